"""Clicks at random on whatever can be clicked, but for what leaves the page or downloads.

    monkey.py FEM [clicks [COUNT [SEED]]]

What is on the disk is looked at after each click: it changes by Save alone, and is always a model.
"""

import random
import subprocess
import tempfile

from person import SURROUNDINGS, Folder, Person, browser, finish, must, opened, until

# Everything that can be clicked now, each with a number; where it is, is seen when its turn has come.
CLICKABLE = """() => {
  const all = [...document.querySelectorAll('button, summary, select, input[type=checkbox], input[type=range], input[type=text],'
    + 'a[href^="#"], #plot canvas, label.pick')];
  const leaves = e => /^download/.test(e.getAttribute('aria-label') || '');
  const shown = all.filter(e => !e.disabled && !leaves(e) && e.checkVisibility({visibilityProperty: true}) && e.getBoundingClientRect().width > 0);
  window.__clickable = shown;
  const nameOf = e => (e.getAttribute('aria-label') || e.labels?.[0]?.textContent || e.textContent || '').trim().slice(0, 60);
  return shown.map(e => [e.tagName + (e.type ? ':' + e.type : ''), nameOf(e),
    e.dataset.click || e.closest('form')?.dataset.submit || e.id, e.closest('section, nav, header, #trial')?.id || '']);
}"""

# Brings one of them into view: the middle of it if it is what a click there would hit, else null.
WHERE = """i => {
  const e = window.__clickable[i];
  if (!e || !e.isConnected) return null;
  e.scrollIntoView({block: 'center', inline: 'center', behavior: 'instant'});
  const r = e.getBoundingClientRect();
  const x = r.left + r.width / 2, y = r.top + r.height / 2, hit = document.elementFromPoint(x, y);
  return hit && (e === hit || e.contains(hit) || hit.contains(e)) ? {x: r.left, y: r.top, width: r.width, height: r.height,
    options: e.tagName === 'SELECT' ? [...e.options].map(o => o.value) : null} : null;
}"""

# What of a state is what is open.
OPEN = ["data", "comparison", "steps", "diagnosis", "correction"]


def text_of(state):
    return state["model"] and state["model"]["text"]


class Monkey:
    """Clicks where it likes, by a seed, and notes what it did."""

    def __init__(self, person, seed):
        self.person, self.chance = person, random.Random(seed)
        self.done = []
        self.saves = 0
        self.steps = 0
        person.page.on("filechooser", lambda _: None)
        person.page.on("dialog", lambda dialog: dialog.accept())
        person.page.on("response", self.answered)

    def answered(self, response):
        what = response.url.rsplit("/", 1)[-1].split("?")[0]
        if response.request.method == "POST" and response.ok:
            self.saves += what == "save"

    def click(self):
        """One click; False where what was chosen is gone or covered."""
        page = self.person.page
        there = page.evaluate(CLICKABLE)
        # Panes with many values are not all that is clicked.
        places = sorted({place for *_, place in there})
        place = self.chance.choice(places)
        number, (kind, name, what, _) = self.chance.choice([(i, e) for i, e in enumerate(there) if e[3] == place])
        where = page.evaluate(WHERE, number)
        if where is None:
            return False
        self.done.append(f"{kind} {name} ({what})")
        x, y = where["x"] + where["width"] / 2, where["y"] + where["height"] / 2
        if where["options"]:
            page.evaluate("""([i, value]) => { const e = window.__clickable[i]; e.focus(); e.value = value;
              e.dispatchEvent(new Event('input', {bubbles: true})); e.dispatchEvent(new Event('change', {bubbles: true})); }""",
              [number, self.chance.choice(where["options"])])
            return True
        if kind == "INPUT:range" or kind == "CANVAS":
            x = where["x"] + where["width"] * self.chance.uniform(0.05, 0.95)
        page.mouse.click(x, y)
        if what == "saveAs" and kind == "INPUT:text":
            page.keyboard.type(self.chance.choice(["other.toml", "third.toml", "../out.toml", "measured.csv"]))
            page.keyboard.press("Enter")
        return True


def is_model(program, file):
    """Whether a file is a model: it runs, or all that keeps it from that are unknown values."""
    with tempfile.TemporaryDirectory() as out:
        ran = subprocess.run([program, "run", file, "-o", out], capture_output=True, text=True, env=SURROUNDINGS)
    return ran.returncode == 0 or "is unknown (`?`)" in ran.stderr


def clicks(program, count=500, seed=1):
    count, seed = int(count), int(seed)
    folder = Folder("story/rigid.toml", "story/measured.csv", "lathe.toml", "stiffness.toml")
    with browser() as own, opened(program, folder.path) as fem:
        person = Person(own, fem.url)
        first = fem.state()
        person.choose("Model file", "rigid.toml")
        person.reads("#head h1", "Shafts")
        second = fem.state()
        person.click("checkbox", "measured.csv")
        person.reads("#head .verdict", "43.2")
        monkey = Monkey(person, seed)
        models = {name: text for name, text in folder.texts().items() if name.endswith(".toml")}
        missed = written = heard = 0
        trouble = {}
        while len(monkey.done) < count:
            missed += not monkey.click()
            must(missed < 2 * count, "hardly anything can be clicked")
            for told in person.trouble[heard:]:
                trouble.setdefault(told, monkey.done[-5:])
            heard = len(person.trouble)
            now = {name: text for name, text in folder.texts().items() if name.endswith(".toml")}
            if now == models:
                continue
            # The click that saves is noted before its answer, which may come some clicks later on a busy computer.
            must(any("save" in what for what in monkey.done[-8:]), f"a file has changed by {monkey.done[-8:]}")
            for name in now:
                if now[name] != models.get(name):
                    written += 1
                    must(is_model(program, folder / name), f"{name} is no model after {monkey.done[-5:]}: {now[name].decode()}")
            models = now
        fem.ask("POST", "stop", {})
        until(lambda: fem.state()["job"] is None, "what runs does not stop")
        states = [fem.state()]
        while states[-1]["undo"] is not None:
            status, answer = fem.ask("POST", "undo", {})
            must(status == 200, f"undo is refused: {answer}")
            states.append(fem.state())
    differs = [f"{key}, {count} steps back" for count, then in ((len(states) - 1, first), (len(states) - 2, second))
               for key in OPEN if states[count][key] != then[key]]
    differs += [f"model, {count} steps back" for count, then in ((len(states) - 1, first), (len(states) - 2, second))
                if text_of(states[count]) != text_of(then)]
    return {"clicks": len(monkey.done), "kinds": len(set(monkey.done)), "missed": missed, "saves": monkey.saves, "written": written,
            "undone": len(states) - 1, "differs": differs, "trouble": trouble, "names": folder.names()}


if __name__ == "__main__":
    finish({"clicks": clicks})
