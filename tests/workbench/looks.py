"""What a check of accessibility and the width of a phone say of the page, in each of its states and looks.

    looks.py FEM [looks]

Three browsers follow the same session: light, dark, and a phone. With FEM_PAGE_SHOTS set to a folder, pictures stay there.
"""

import os
import re
from importlib.resources import files
from pathlib import Path

from person import Folder, Person, browser, finish, opened

LOOKS = {
    "light": {"viewport": {"width": 1280, "height": 900}, "color_scheme": "light"},
    "dark": {"viewport": {"width": 1280, "height": 900}, "color_scheme": "dark"},
    "phone": {"viewport": {"width": 390, "height": 844}, "color_scheme": "light", "is_mobile": True, "has_touch": True},
}
RULES = "axe.run({runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'best-practice']})"
AXE = (files("axe_playwright_python") / "axe.min.js").read_text()


def refuse(person):
    person.write("cut radial force", "450 mm")
    person.press("Enter")
    person.reads("#model .problem", "length")


def looks(program):
    folder = Folder("story/rigid.toml", "story/measured.csv")
    shots = os.environ.get("FEM_PAGE_SHOTS")
    found = {"states": [], "violations": [], "wider": []}
    with browser() as own, opened(program, folder.path) as fem:
        people = {name: Person(own, fem.url, **options) for name, options in LOOKS.items()}
        first = people["light"]
        for person in people.values():
            # The script of the check is run by the debugger, which a page's policy does not bind.
            person.page.evaluate(AXE)

        def look(state, shows):
            found["states"].append(state)
            for name, person in people.items():
                shows(person)
                wider = person.is_within()
                if wider > 0:
                    found["wider"].append(f"{name}, {state}: {wider} px")
                for v in person.page.evaluate(RULES)["violations"]:
                    found["violations"] += [f"{name}, {state}: {v['id']}: {node['html'][:160]}" for node in v["nodes"][:2]]
                if shots:
                    person.page.screenshot(path=Path(shots) / f"workbench-{state}-{name}.png", full_page=True)

        look("nothing", lambda person: person.reads("#head .verdict", "Open a model"))
        first.choose("Model file", "rigid.toml")
        look("model", lambda person: person.reads("#head h1", "Shafts"))
        first.click("checkbox", "measured.csv")
        look("data", lambda person: person.reads("#head .verdict", re.compile(r"43\.2 µm")))
        first.click("button", "Find what is missing")
        look("diagnosed", Person.diagnosed)
        first.click("button", "Compute the correction")
        look("corrected", Person.corrected)
        look("refused", refuse)
        for person in people.values():
            person.is_calm()
    return found


finish({"looks": looks})
