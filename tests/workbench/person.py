"""What a person has at hand: a folder of files, the program, a browser; and eyes that read the page.

    from person import ROOT, Folder, Person, browser, finish, must

Scripts of this folder are run as `SCRIPT FEM [WHAT]`, with the path of the program. It tells what happened as JSON on
its output; what must hold and does not ends it with a sentence on its errors.
"""

import base64
import contextlib
import http.client
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import traceback
from pathlib import Path

from playwright.sync_api import Error, expect, sync_playwright

ROOT = Path(__file__).resolve().parents[2]
PATIENCE = 20.0  # s, for whatever has to show; nothing waits longer than it must
CAUSES = ["tool-wear", "headstock-compliance", "guideway-wear"]
WIDE = {"viewport": {"width": 1400, "height": 900}}
# What the program keeps for its user stays with the test.
KEPT = tempfile.TemporaryDirectory(prefix="fem-kept-")
SURROUNDINGS = os.environ | {"XDG_STATE_HOME": KEPT.name, "XDG_DATA_HOME": KEPT.name}
expect.set_options(timeout=PATIENCE * 1000)


class Wrong(AssertionError):
    """What must hold and does not."""


def must(holds, sentence):
    if not holds:
        raise Wrong(sentence)


def until(holds, sentence, patience=PATIENCE):
    """The first answer of `holds` that counts as true; what it reads is outside of the page, so it is asked again."""
    end = time.monotonic() + patience
    while time.monotonic() < end:
        found = holds()
        if found:
            return found
        time.sleep(0.02)
    raise Wrong(f"{sentence}: not within {patience:g} s")


class Folder:
    """A folder of a shop with copies of files of the repository; it goes with the test."""

    def __init__(self, *copies, **named):
        self.made = tempfile.TemporaryDirectory(prefix="fem-shop-")
        self.path = Path(self.made.name)
        for file in copies:
            shutil.copy(ROOT / "models" / file, self.path / Path(file).name)
        for name, file in named.items():
            shutil.copy(ROOT / "models" / file, self.path / name)

    def __truediv__(self, name):
        return self.path / name

    def names(self):
        """All files of the folder, hidden ones too."""
        return sorted(str(file.relative_to(self.path)) for file in self.path.rglob("*"))

    def texts(self):
        return {file.name: file.read_bytes() for file in self.path.iterdir() if file.is_file()}


class Fem:
    """The program, serving a folder or a model."""

    def __init__(self, program, what, port=0):
        words = [program, "open", str(what), "--port", str(port)]
        self.process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=SURROUNDINGS)
        told = self.process.stderr.readline()
        found = re.match(r"http://([^:]+):(\d+)/(\S*)", told)
        must(found, f"{' '.join(words)} told no address but: {told}{self.process.stderr.read() if not found else ''}")
        self.url, self.port, self.token = found.group(0), int(found.group(2)), found.group(3)

    def ask(self, method, what, said=None):
        """Status and JSON of an answer, asked beside the page."""
        wire = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        body = None if said is None else json.dumps(said)
        wire.request(method, f"/{self.token}{what}", body)
        answer = wire.getresponse()
        text = answer.read()
        wire.close()
        return answer.status, json.loads(text) if text[:1] in (b"{", b"[") else text.decode()

    def state(self):
        status, state = self.ask("GET", "state")
        must(status == 200, f"the state is answered by {status}: {state}")
        return state

    def resident(self):
        """Memory of the program, bytes."""
        status = Path(f"/proc/{self.process.pid}/status").read_text()
        return 1024 * int(re.search(r"VmRSS:\s+(\d+)", status).group(1))

    def end(self, how=signal.SIGINT):
        if self.process.poll() is None:
            self.process.send_signal(how)
        self.process.wait(PATIENCE)
        self.process.stderr.close()

    def kill(self):
        self.end(signal.SIGKILL)


@contextlib.contextmanager
def opened(program, what, port=0):
    fem = Fem(program, what, port)
    try:
        yield fem
    finally:
        fem.kill()


@contextlib.contextmanager
def browser():
    with sync_playwright() as playwright:
        own = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
        yield own
        own.close()


# How what has the focus is called and what it is, as a screen reader tells it.
FOCUSED = """() => {
  const e = document.activeElement;
  if (!e || e === document.body) return null;
  const label = e.getAttribute('aria-label') || (e.labels && [...e.labels].map(l => l.textContent).join(' '))
    || (e.getAttribute('aria-labelledby') || '').split(' ').map(i => document.getElementById(i)?.textContent || '').join(' ').trim()
    || (e.tagName === 'SELECT' ? '' : e.textContent);
  const role = e.getAttribute('role') || {A: 'link', BUTTON: 'button', SUMMARY: 'summary', SELECT: 'select', TEXTAREA: 'text'}[e.tagName]
    || (e.tagName === 'INPUT' ? {range: 'slider', checkbox: 'checkbox', file: 'file'}[e.type] || 'text' : e.tagName.toLowerCase());
  return {name: label.replace(/\\s+/g, ' ').trim(), role, id: e.id};
}"""


class Person:
    """Somebody before the page: does by name what is to be seen, and counts clicks and keys."""

    def __init__(self, browser, url, **options):
        self.clicks = self.keys = 0
        self.trouble = []
        self.page = browser.new_context(**(WIDE | options)).new_page()
        self.page.set_default_timeout(PATIENCE * 1000)
        self.page.on("console", self.heard)
        self.page.on("pageerror", lambda error: self.note(f"error of the page: {error.stack or error}"))
        self.go(url)

    def heard(self, message):
        # A refusal is an answer with a status of its own, which the browser notes by itself.
        if message.type in ("error", "warning") and "status of 422" not in message.text:
            self.note(f"{message.type}: {message.text}")

    def note(self, text):
        # The same trouble reads the same whatever port and token.
        self.trouble.append(re.sub(r"http://127\.0\.0\.1:\d+/\w+/", "", text))

    def go(self, url):
        self.page.goto(url)
        self.page.locator("h1").wait_for()

    def is_calm(self):
        must(not self.trouble, f"the browser complains: {self.trouble}")

    def close(self):
        self.page.context.close()

    # What there is to be done.

    def at(self, role, name, within="body"):
        """What can be seen and has this name: all of it if a text, a part of it if an expression."""
        place = self.page.locator(within)
        if role == "summary":
            return place.locator("summary").filter(has_text=name).locator("visible=true").first
        return place.get_by_role(role, name=name, exact=isinstance(name, str)).locator("visible=true").first

    def click(self, role, name, within="body"):
        self.clicks += 1
        self.at(role, name, within).click()

    def choose(self, label, option, within="body"):
        """One click opens the list, one takes from it."""
        self.clicks += 2
        self.at("combobox", label, within).select_option(option)

    def write(self, label, text, within="body"):
        """A click into the field, then the text in place of what stood there."""
        self.clicks += 1
        field = self.at("textbox", label, within)
        field.click()
        field.fill(text)
        self.keys += len(text)

    def press(self, *keys):
        for key in keys:
            self.keys += 1
            self.page.keyboard.press(key)

    def drop(self, *files):
        """Lets files fall on the page as from a window beside it; that is one move of the mouse."""
        self.clicks += 1
        held = [[Path(file).name, base64.b64encode(Path(file).read_bytes()).decode()] for file in files]
        self.page.evaluate("""async held => {
          const all = new DataTransfer();
          for (const [name, text] of held) {
            const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
            all.items.add(new File([bytes], name));
          }
          const place = document.getElementById('drop') || document.body;
          for (const kind of ['dragenter', 'dragover', 'drop'])
            place.dispatchEvent(new DragEvent(kind, {dataTransfer: all, bubbles: true, cancelable: true}));
        }""", held)

    def pick(self, file):
        """Chooses a file of the computer in the browser's own window."""
        self.clicks += 2
        self.page.locator("#pick").set_input_files(file)

    # By keys alone.

    def focused(self):
        return self.page.evaluate(FOCUSED)

    def reach(self, role, name, key="Tab", most=400):
        """Tabs until something of this name has the focus."""
        for _ in range(most):
            self.press(key)
            now = self.focused()
            if now and now["role"] == role and (name == now["name"] if isinstance(name, str) else name.search(now["name"])):
                return now
        raise Wrong(f"{most} times {key} never reach the {role} {name}")

    def jump(self, pane):
        """Goes to a pane by its link."""
        self.reach("link", pane)
        self.press("Enter")

    # What there is to be seen.

    def reads(self, within, text, patience=PATIENCE):
        """Waits until a text (or an expression) stands at a place."""
        expect(self.page.locator(within).first).to_contain_text(text, timeout=patience * 1000)

    def text(self, within):
        return " ".join(self.page.locator(within).first.inner_text().split())

    def bars(self):
        """What was left with each model, µm, as the header shows it."""
        shown = self.page.get_by_role("list", name="The error falling").get_by_role("listitem").all_inner_texts()
        return [float(re.findall(r"([\d.]+)\s*\u00b5m", text)[-1]) for text in shown]

    def bars_are(self, count):
        expect(self.page.get_by_role("list", name="The error falling").get_by_role("listitem")).to_have_count(count)
        return self.bars()

    def is_idle(self):
        """Waits until nothing runs beside the page."""
        self.page.locator(".job").first.wait_for(state="detached", timeout=60_000)

    def is_busy(self):
        """Waits until something runs beside the page."""
        self.page.locator(".job").first.wait_for()

    def diagnosed(self):
        self.page.locator("#causes article").first.wait_for(timeout=60_000)

    def corrected(self):
        self.page.locator("#correct .served").first.wait_for(timeout=60_000)

    def is_within(self):
        """Nothing is wider than the window: how much it sticks out, px."""
        return self.page.evaluate("document.documentElement.scrollWidth - innerWidth")


def arguments(least):
    """What stands behind the script's name: at least so many words, or it says how it is used."""
    words = sys.argv[1:]
    if {"-h", "--help"} & set(words):
        print(sys.modules["__main__"].__doc__)
        sys.exit()
    if len(words) < least:
        sys.exit(sys.modules["__main__"].__doc__)
    return words


def finish(parts):
    """Runs the part that is named, with what more is said to it, or all of them, and tells what was found."""
    program, *words = arguments(1)
    what, more = words[:1], words[1:]
    found = {}
    for name in what or parts:
        try:
            found[name] = parts[name](program, *more)
        except (AssertionError, Error) as error:
            # Where it happened in the script, and what was said; not all that the page shows.
            here = [frame for frame in traceback.extract_tb(error.__traceback__) if Path(frame.filename).parent == Path(__file__).parent]
            line = next((frame for frame in reversed(here) if not frame.filename.endswith("person.py")), here[-1])
            said = "\n".join(str(error).split("Aria snapshot")[0].strip().splitlines()[:12])
            sys.exit(f"{name}, line {line.lineno}: {line.line}\n{said}")
    print(json.dumps(found[what[0]] if what else found))
