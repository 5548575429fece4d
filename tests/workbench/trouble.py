"""What goes wrong around the page: the program is killed, what is given to it is bad, the file is edited elsewhere.

    trouble.py FEM [killed | cut | refused | edited | unsaved | gone]
"""

import contextlib
import re
import time

from person import ROOT, Folder, Person, Wrong, browser, expect, finish, must, opened, until
from relay import Relay

LARGE = 100 << 20
FORCE = "cut radial force"


def started(own, fem, *names):
    """Somebody before an open model, with measurements."""
    person = Person(own, fem.url)
    for name in names:
        person.click("checkbox", name)
        person.reads("#head .verdict", re.compile(r"43\.2 µm"))
    return person


def field(person):
    return person.at("textbox", FORCE).input_value()


def killed(program):
    folder = Folder("story/rigid.toml", "story/measured.csv")
    with browser() as own:
        with opened(program, folder / "rigid.toml") as fem:
            person = started(own, fem, "measured.csv")
            person.write(FORCE, "460 N")
            person.press("Enter")
            person.click("button", re.compile("^Save( •)?$"))
            person.reads("#bar", "Saved")
            saved = folder.texts()
            for text in ("470 N", "480 N"):
                person.write(FORCE, text)
                person.press("Enter")
                until(lambda: f'"{text}"' in fem.state()["model"]["text"], f"{text} is not set")
            # While something is computed, too.
            person.click("button", "Find what is missing")
            person.is_busy()
            port, before = fem.port, folder.texts()
            fem.kill()
            person.reads("#trouble", "connection")
            lost = person.text("#trouble")
            after = folder.texts()
        with opened(program, folder / "rigid.toml", port) as again:
            # The old page knows the old token alone: it cannot come back, and has to say so.
            told = lost
            if again.token != fem.token:
                with contextlib.suppress(Wrong):
                    until(lambda: person.text("#trouble") != lost, "the page says nothing else", patience=8)
                told = person.text("#trouble")
            person.close()
            person = Person(own, again.url)
            person.reads("#head h1", "Shafts")
            reopened, resumed = field(person), None
            # What was not saved is offered where the program has kept it.
            session = again.state().get("session")
            if session:
                person.click("button", re.compile("Take up the last session"))
                expect(person.at("textbox", FORCE)).to_have_value("480 N")
                resumed = field(person)
            person.is_calm()
            last = folder.texts()
    must(saved["rigid.toml"] == after["rigid.toml"] == last["rigid.toml"], "the saved file is not what it was")
    must(b'"460 N"' in saved["rigid.toml"], "what was saved is not in the file")
    return {"lost": lost, "told": told, "reopened": reopened, "session": session, "resumed": resumed,
            "names": {"before": sorted(before), "after": sorted(after), "last": folder.names()}}


def cut(program):
    """The wire is cut and joined again; the program stays, and the model is changed meanwhile."""
    folder = Folder("story/rigid.toml", "story/measured.csv")
    with browser() as own, opened(program, folder / "rigid.toml") as fem, Relay(fem) as wire:
        person = Person(own, wire.url)
        wire.cut()
        person.reads("#trouble", "connection")
        fem.ask("POST", "set", {"path": "cut.radial_force", "text": "470 N"})
        wire.join()
        expect(person.page.locator("#trouble")).not_to_contain_text("connection")
        expect(person.at("textbox", FORCE)).to_have_value("470 N")
        person.write(FORCE, "480 N")
        person.press("Enter")
        until(lambda: '"480 N"' in fem.state()["model"]["text"], "480 N is not set")
    return {}


# What is open; what lies in the folder may be more.
OPEN = ["model", "data", "comparison", "steps", "undo", "redo"]


def kept(fem):
    state = fem.state()
    return {key: state[key] for key in OPEN}


def alarmed(person, names):
    """The sentence that tells what was refused; it goes by the key that puts things away."""
    expect(person.page.locator("#alarm, #data [role=alert], #data .problem").filter(has_text=names).first).to_be_visible()
    places = person.page.locator("#alarm, #data [role=alert], #data .problem").all_inner_texts()
    leave = person.at("button", "Do not use it")
    leave.click() if leave.is_visible() else person.press("Escape")
    return " ".join(" ".join(places).split())


def refused(program):
    folder = Folder("story/rigid.toml", "story/measured.csv", "stiffness.toml")
    elsewhere = Folder()
    (elsewhere / "prose.txt").write_text("this is no table\nat all\n")
    (elsewhere / "empty.csv").touch()
    for large in (elsewhere / "large.csv", folder / "huge.csv"):
        with large.open("wb") as file:
            file.truncate(LARGE)
    told, seconds = {}, {}
    with browser() as own, opened(program, folder / "rigid.toml") as fem:
        person = started(own, fem, "measured.csv")
        person.write(FORCE, "460 N")
        person.press("Enter")
        until(lambda: '"460 N"' in fem.state()["model"]["text"], "460 N is not set")
        before = kept(fem)

        def tries(what, act, names=None):
            began = time.monotonic()
            act()
            told[what] = alarmed(person, names or what)
            seconds[what] = round(time.monotonic() - began, 2)
            must(kept(fem) == before, f"{what}: what was open is not what it was")

        tries("prose.txt", lambda: person.drop(elsewhere / "prose.txt"))
        tries("empty.csv", lambda: person.drop(elsewhere / "empty.csv"))
        tries("large.csv", lambda: person.pick(elsewhere / "large.csv"), re.compile("large"))
        tries("huge.csv", lambda: person.click("checkbox", "huge.csv"))
        must(person.at("checkbox", "measured.csv").is_checked(), "the file that is open is not ticked")
        must(not person.at("checkbox", "huge.csv").is_checked(), "a file that was refused stays ticked")
        # At the field: the text stays to be mended, and the value is what it was.
        person.write(FORCE, "450 mm")
        person.press("Enter")
        place = person.at("textbox", FORCE).locator("xpath=ancestor::*[contains(concat(' ', @class, ' '), ' value ')][1]")
        expect(place.locator(".problem")).to_be_visible()
        told["450 mm"] = " ".join(place.locator(".problem").inner_text().split())
        must(field(person) == "450 mm", "the text that was refused is gone")
        must(person.at("textbox", FORCE).get_attribute("aria-invalid") == "true", "the field does not say that it is wrong")
        must(kept(fem) == before, "450 mm: what was open is not what it was")
        person.press("Escape")
        expect(place.locator(".problem")).to_have_count(0)
        must(field(person) == "460 N", "Escape does not bring back the value")
        # Measurements are of a process: another model leaves them, and says so; a step back brings all of it again.
        person.choose("Model file", "stiffness.toml")
        person.reads("#head", "stiffness.toml")
        person.reads("#said", "stiffness.toml")
        told["stiffness.toml"] = " ".join([person.text("#head .verdict"), person.text("#said"), person.text("#alarm")])
        person.click("button", "Undo")
        person.reads("#head .verdict", "rms")
        back = kept(fem)
        person.is_calm()
    lost = [key for key in ("data", "comparison", "steps") if back[key] != before[key]]
    lost += ["model"] * (back["model"]["text"] != before["model"]["text"])
    return {"told": told, "seconds": seconds, "lost": lost, "names": folder.names()}


def edited(program):
    folder = Folder("story/rigid.toml", "story/measured.csv")
    file, text = folder / "rigid.toml", (ROOT / "models/story/rigid.toml").read_text()
    with browser() as own, opened(program, file) as fem:
        person = started(own, fem, "measured.csv")
        expected = person.at("textbox", FORCE)
        file.write_text(text.replace('"450 N"', '"500 N"'))
        expect(expected).to_have_value("500 N")
        followed = person.text("#head .verdict")
        file.write_text(text.replace('"450 N"', '"450 m"'))
        person.reads("#trouble", "rigid.toml")
        told = person.text("#trouble")
        must(field(person) == "500 N" and person.text("#head .verdict") == followed, "the last good state is not kept")
        file.write_text("process = ")
        until(lambda: person.text("#trouble") != told, "another fault is not told")
        file.write_text(text)
        expect(person.page.locator("#trouble [role=alert]")).to_have_count(0)
        expect(expected).to_have_value("450 N")
        person.reads("#head .verdict", re.compile(r"43\.2 µm"))
        # What is half written does not take away what is being typed.
        expected.click()
        person.page.keyboard.type("1")
        half = field(person)
        file.write_text(text.replace('"0.5 mm"', '"0.6 mm"'))
        expect(person.at("textbox", "cut depth")).to_have_value("0.6 mm")
        must(field(person) == half, "what was being typed is gone")
        person.is_calm()
    return {"followed": followed, "told": told}


def unsaved(program):
    """Edited elsewhere while something is not saved here: neither of the two is lost without a word."""
    folder = Folder("story/rigid.toml", "story/measured.csv")
    file, text = folder / "rigid.toml", (ROOT / "models/story/rigid.toml").read_text()
    with browser() as own, opened(program, file) as fem:
        person = started(own, fem, "measured.csv")
        person.write(FORCE, "460 N")
        person.press("Enter")
        until(lambda: '"460 N"' in fem.state()["model"]["text"], "460 N is not set")
        elsewhere = text.replace('"0.5 mm"', '"0.6 mm"')
        file.write_text(elsewhere)
        told = ""
        with contextlib.suppress(Wrong):
            told = until(lambda: person.text("#trouble"), "nothing is said", patience=2)
        person.click("button", re.compile("^Save"))
        said = lambda: person.text("#alarm") or person.text("#trouble")
        until(lambda: file.read_text() != elsewhere or said(), "Save does nothing")
        told = told or said()
        after = file.read_text()
    return {"told": told, "is_overwritten": after != elsewhere}


def gone(program):
    """The file is emptied, or goes: the page does not say that it is saved, and can write it again."""
    seen = {}
    for what in ("emptied", "removed"):
        folder = Folder("story/rigid.toml", "story/measured.csv")
        with browser() as own, opened(program, folder / "rigid.toml") as fem:
            person = started(own, fem, "measured.csv")
            (folder / "rigid.toml").write_text("") if what == "emptied" else (folder / "rigid.toml").unlink()
            save = person.at("button", re.compile("^Save( •)?$"))
            with contextlib.suppress(Wrong):
                until(lambda: save.is_visible() and save.is_enabled() or person.text("#trouble"), "nothing is said", patience=2)
            can_save = save.is_visible() and save.is_enabled()
            seen[what] = {"says": person.text("#trouble"), "can_save": can_save, "rows": fem.state()["data"]["rows"]}
            person.is_calm()
    return seen


finish({"killed": killed, "cut": cut, "refused": refused, "edited": edited, "unsaved": unsaved, "gone": gone})
