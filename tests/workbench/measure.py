"""How quick the page is, and what it takes: a table in Markdown. No test: nothing is asserted of a time.

    measure.py FEM [CLICKS [PROCESS ...]]

Each process has 2000 rows, predicted by its model with a little noise. Moves are 60 of one slider; clicks (2000 if not said
otherwise) stand for an hour of work.
"""

import csv
import http.client
import io
import json
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from monkey import Monkey
from person import SURROUNDINGS, Folder, Person, arguments, browser, must, opened

ROWS, MOVES = 2000, 60
MODELS = {"turning": "lathe", "stiffness": "stiffness", "fixture": "fixture", "ring": "ring",
          "thermal": "thermal", "axis": "axis", "contour": "contour", "cam": "cam"}
# What is observed; all else that stands in a profile says where.
OBSERVED = ("error", "deviation", "displacement", "temperature", "elongation")
DERIVED = ("finished_diameter",)

# Notes every drawing of the plot, and every answer to a trial.
WATCH = """() => {
  window.__drawn = []; window.__answered = [];
  const clear = CanvasRenderingContext2D.prototype.clearRect;
  CanvasRenderingContext2D.prototype.clearRect = function (...all) {
    window.__drawn.push(performance.now());
    return clear.apply(this, all);
  };
  const ask = window.fetch;
  window.fetch = async (what, how) => {
    const answer = await ask(what, how), text = answer.text.bind(answer);
    if (String(what) === 'try') answer.text = async () => { const t = await text(); window.__answered.push(performance.now()); return t; };
    return answer;
  };
}"""

# From the moment a slider moves to the frame after the one in which its trial is drawn; whether the plot is another one.
MOVE = """async ([id, step]) => {
  const canvas = document.querySelector('#plot canvas'), slider = document.getElementById(id);
  const frame = () => new Promise(done => requestAnimationFrame(() => {
    const after = new MessageChannel();
    after.port1.onmessage = () => done(performance.now());
    after.port2.postMessage(0);
  }));
  const before = canvas.toDataURL();
  await frame(); await frame();
  window.__drawn.length = window.__answered.length = 0;
  slider.value = step;
  const began = performance.now();
  slider.dispatchEvent(new Event('input', {bubbles: true}));
  let now = began;
  while (now - began < 5000) {
    now = await frame();
    const answered = window.__answered[0];
    if (answered !== undefined && window.__drawn.some(t => t > answered)) break;
  }
  return [now - began, document.querySelector('#plot canvas').toDataURL() !== before];
}"""

PAINTED = """() => Object.fromEntries(performance.getEntriesByType('paint').map(e => [e.name, e.startTime]))"""
FETCHED = """() => [...performance.getEntriesByType('navigation'), ...performance.getEntriesByType('resource')]
  .map(e => [e.name.replace(/^.*\\//, '').replace(/\\?.*/, ''), e.transferSize || e.encodedBodySize])"""
COMPARED = """() => { const first = () => { const c = document.querySelector('#plot canvas');
    if (!c || !window.__drawn.length) { requestAnimationFrame(first); return; }
    const after = new MessageChannel(); after.port1.onmessage = () => { window.__compared = performance.now(); }; after.port2.postMessage(0); };
  requestAnimationFrame(first); }"""


def noisy(cell, noise):
    return cell and f"{float(cell) + noise:.6g}"


def measured(program, process):
    """A folder with the model and as many rows as wanted: the model's own profile, repeated, with noise of a seed."""
    folder = Folder(f"{MODELS[process]}.toml")
    with tempfile.TemporaryDirectory() as out:
        words = [program, "run", folder / f"{MODELS[process]}.toml", "-o", out]
        subprocess.run(words, check=True, capture_output=True, env=SURROUNDINGS)
        rows = list(csv.DictReader((Path(out) / "profile.csv").open()))
    names = [name for name in rows[0] if not name.startswith(DERIVED)]
    seen = [name for name in names if name.split(" ")[0].endswith(OBSERVED)]
    chance = random.Random(process)
    spread = {name: 0.02 * max(abs(float(row[name])) for row in rows if row[name]) for name in seen}
    text = io.StringIO()
    table = csv.writer(text)
    table.writerow(names)
    # Evenly out of the profile where it is longer, and again from its beginning where it is shorter.
    step = max(1.0, len(rows) / ROWS)
    for number in range(ROWS):
        row = rows[int(number * step) % len(rows)]
        table.writerow([noisy(row[name], chance.gauss(0, spread[name])) if name in seen else row[name] for name in names])
    (folder / "measured.csv").write_text(text.getvalue())
    return folder


def moving(fem):
    """The value whose trials move the rows most, among those that may be a tenth more and less."""
    values = [v for v in fem.state()["model"]["values"] if v.get("value") and v.get("kind", "quantity") == "quantity"]
    base = fem.ask("POST", "try", {"values": {}})[1]["predicted"]
    best = (0.0, None)
    for v in values:
        tried = [fem.ask("POST", "try", {"values": {v["path"]: v["value"] * by}}) for by in (0.9, 1.06, 1.1)]
        if all(status == 200 for status, _ in tried):
            moved = sum(abs(a - b) for a, b in zip(tried[2][1]["predicted"], base) if a is not None and b is not None)
            best = max(best, (moved, v), key=lambda own: own[0])
    must(best[1], "no value moves anything")
    return best[1]


def quantiles(times):
    times = sorted(times)
    return f"{times[len(times) // 2]:.1f}", f"{times[int(0.95 * (len(times) - 1))]:.1f}"


def answers(fem, value):
    """Times of answers to trials, ms, on one connection as a browser keeps it."""
    wire = http.client.HTTPConnection("127.0.0.1", fem.port)
    times = []
    for number in range(MOVES):
        body = json.dumps({"values": {value["path"]: value["value"] * (1 + 0.001 * (number + 1))}})
        began = time.perf_counter()
        wire.request("POST", f"/{fem.token}try", body)
        answer = wire.getresponse()
        answer.read()
        times.append(1000 * (time.perf_counter() - began))
        must(answer.status == 200, f"{value['path']} is not tried: {answer.status}")
    wire.close()
    return times


def moves(person, value):
    """Times from the slider to the plot, ms; how many moves left the plot as it was."""
    id = "v-" + "".join(c if c.isalnum() or c in "_-" else "_" for c in value["path"]) + "-try"
    place = person.page.locator(f"[id='{id}']")
    if not place.count():
        person.page.locator(f"[data-click=more][data-path='{value['path']}']").first.click()
        place.wait_for()
    middle = last = int(place.input_value())
    chance = random.Random(1)
    times, still = [], 0
    for _ in range(MOVES):
        step = chance.choice([step for step in range(max(0, middle - 50), min(1000, middle + 50) + 1) if step != last])
        took, is_other = person.page.evaluate(MOVE, [id, step])
        last = step
        times.append(took)
        still += not is_other
    return times, still


def heap(page):
    session = page.context.new_cdp_session(page)
    session.send("HeapProfiler.collectGarbage")
    session.send("Performance.enable")
    found = {entry["name"]: entry["value"] for entry in session.send("Performance.getMetrics")["metrics"]}
    session.detach()
    return found["JSHeapUsedSize"]


def look(own, program, process, clicks):
    folder = measured(program, process)
    with opened(program, folder / f"{MODELS[process]}.toml") as fem:
        status, answer = fem.ask("POST", "data", {"files": ["measured.csv"]})
        must(status == 200, f"{process}: {answer}")
        must(fem.state()["data"]["rows"] >= ROWS, f"{process}: {fem.state()['data']['rows']} rows")
        value = moving(fem)
        page = own.new_context(viewport={"width": 1400, "height": 900}).new_page()
        page.add_init_script(f"({WATCH})(); ({COMPARED})();")
        page.goto(fem.url)
        page.locator("#plot canvas").wait_for()
        while not page.evaluate("window.__compared || 0"):
            pass
        paint = page.evaluate(PAINTED)
        painted = paint.get("first-contentful-paint", paint.get("first-paint", 0))
        # What is drawn shows no sooner than the page itself.
        shown = max(painted, page.evaluate("window.__compared"))
        fetched = page.evaluate(FETCHED)
        page.context.close()
        served = answers(fem, value)
        person = Person(own, fem.url)
        person.page.evaluate(WATCH)
        drawn, still = moves(person, value)
        person.go(fem.url)
        person.page.locator("#plot canvas").wait_for()
        before = (heap(person.page), fem.resident())
        monkey = Monkey(person, 1)
        began = time.monotonic()
        for _ in range(clicks):
            monkey.click()
        took = time.monotonic() - began
        fem.ask("POST", "stop", {})
        after = (heap(person.page), fem.resident())
        person.close()
    mb = lambda size: f"{size / 2**20:.1f}"
    return [process, value["path"], *quantiles(served), *quantiles(drawn), str(still),
            f"{painted:.0f}", f"{shown:.0f}",
            str(len(fetched)), f"{sum(size for _, size in fetched) / 1024:.0f}",
            f"{mb(before[0])} → {mb(after[0])}", f"{mb(before[1])} → {mb(after[1])}", f"{took:.0f}", str(len(set(person.trouble)))], sorted(set(person.trouble))


HEAD = ["process", "slider", "try, median [ms]", "p95", "input to plot, median [ms]", "p95", "moves without change",
        "first paint [ms]", "first comparison [ms]", "fetched", "kB", "JS heap [MB]", "resident [MB]", "clicking [s]", "errors"]


def main():
    program, *words = arguments(1)
    clicks = int(words[0]) if words else 2000
    print(f"{ROWS} rows, {MOVES} moves; heap and memory before and after {clicks} clicks\n")
    print("| " + " | ".join(HEAD) + " |\n|" + "---|" * len(HEAD))
    with browser() as own:
        for process in words[1:] or MODELS:
            cells, trouble = look(own, program, process, clicks)
            print("| " + " | ".join(cells) + " |", flush=True)
            print("\n".join(f"{process}: {text}" for text in trouble), end="\n" * bool(trouble), file=sys.stderr)


if __name__ == "__main__":
    main()
