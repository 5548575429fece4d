"""The story, as a person takes it: with a mouse, by keys alone, and with a diagnosis that is stopped or overtaken.

    loop.py FEM [mouse | keys | stop | overtaken]
"""

import re

from person import CAUSES, ROOT, Folder, Person, browser, finish, must, opened, until

MEASURED = ROOT / "models/story/measured.csv"


def mouse(program):
    folder = Folder("story/rigid.toml")
    with browser() as own:
        with opened(program, folder / "rigid.toml") as fem:
            person = Person(own, fem.url)
            person.drop(MEASURED)
            person.reads("#head .verdict", re.compile(r"43\.2 µm"))
            person.click("button", "Find what is missing")
            person.diagnosed()
            for cause in CAUSES:
                person.click("button", f"Add {cause}", "#causes")
                person.bars_are(2 + CAUSES.index(cause))
            fallen = person.bars()
            person.click("button", "Undo")
            undone = person.bars_are(3)
            person.click("button", "Redo")
            again = person.bars_are(4)
            person.click("button", "Compute the correction")
            person.corrected()
            corrected = person.text("#correct .served")
            person.click("summary", "Save as")
            person.write("File name", "better.toml")
            person.click("button", "Save under this name")
            person.reads("#head", "better.toml")
            person.page.reload()
            reloaded = person.bars_are(4)
            person.corrected()
            person.is_calm()
            clicks = person.clicks
            person.close()
            fem.end()
        with opened(program, folder.path) as fem:
            person = Person(own, fem.url)
            person.choose("Model file", "better.toml")
            person.reads("#head", "better.toml")
            person.click("checkbox", "measured.csv")
            reopened = person.bars_are(1)
            verdict = person.text("#head .verdict")
            person.is_calm()
    rigid = (folder / "rigid.toml").read_bytes() == (ROOT / "models/story/rigid.toml").read_bytes()
    return {"fallen": fallen, "undone": undone, "again": again, "reloaded": reloaded, "reopened": reopened,
            "corrected": corrected, "verdict": verdict, "is_own_file_untouched": rigid, "clicks": clicks, "names": folder.names()}


def keys(program):
    folder = Folder("story/rigid.toml", "story/measured.csv")
    with browser() as own:
        with opened(program, folder / "rigid.toml") as fem:
            person = Person(own, fem.url)
            person.jump("Data")
            person.reach("checkbox", "measured.csv")
            person.press("Space")
            person.reads("#head .verdict", re.compile(r"43\.2 µm"))
            # Straight on with the keys: what has the focus is not lost by what was drawn anew.
            person.reach("button", "Find what is missing")
            person.press("Enter")
            person.diagnosed()
            for cause in CAUSES:
                person.reach("button", f"Add {cause}")
                person.press("Space")
                person.bars_are(2 + CAUSES.index(cause))
            fallen = person.bars()
            person.reach("button", re.compile("Undo$"), "Shift+Tab")
            person.press("Enter")
            undone = person.bars_are(3)
            person.reach("button", re.compile("Redo$"), most=3)
            person.press("Enter")
            again = person.bars_are(4)
            # Along the points by arrows.
            person.reach("group", re.compile(r"residual .* over"))
            person.press("ArrowRight", "ArrowRight", "ArrowLeft")
            person.reads("#residuals .picked", "Line")
            picked = person.text("#residuals .picked")
            # A slider, and back.
            person.reach("slider", re.compile("cut radial force"), "Shift+Tab")
            person.press("ArrowRight", "ArrowRight")
            person.reads("#trial", re.compile("Trial of 1 value|Nothing moves"))
            person.reach("button", "Reset all")
            person.press("Enter")
            person.page.locator("#trial").wait_for(state="hidden")
            person.reach("button", "Compute the correction", "Shift+Tab")
            person.press("Enter")
            person.corrected()
            person.reach("summary", re.compile("Save as"), "Shift+Tab")
            person.press("Enter")
            person.reach("text", "File name", most=2)
            person.page.keyboard.type("better.toml")
            person.press("Enter")
            person.reads("#head", "better.toml")
            person.page.reload()
            reloaded = person.bars_are(4)
            person.is_calm()
            pressed = person.keys
            person.close()
            fem.end()
        with opened(program, folder.path) as fem:
            person = Person(own, fem.url)
            person.jump("Model")
            person.reach("select", "Model file")
            # The list is walked by its letters.
            person.press("b")
            person.reads("#head", "better.toml")
            person.reach("checkbox", "measured.csv", "Shift+Tab")
            person.press("Space")
            reopened = person.bars_are(1)
            person.is_calm()
    return {"fallen": fallen, "undone": undone, "again": again, "reloaded": reloaded, "reopened": reopened, "picked": picked,
            "keys": pressed, "clicks": person.clicks}


def stop(program):
    folder = Folder("story/rigid.toml")
    lines = MEASURED.read_text().splitlines()
    (folder / "long.csv").write_text("\n".join(lines[:2] + 20 * lines[2:]) + "\n")
    with browser() as own, opened(program, folder / "rigid.toml") as fem:
        person = Person(own, fem.url)
        person.click("checkbox", "long.csv")
        person.reads("#head .verdict", re.compile(r"43\.2 µm"))
        before = fem.state()
        person.click("button", "Find what is missing")
        person.reads(".job", re.compile(r"[1-9]\d* s"))
        others = person.at("button", "Find what is missing").is_disabled()
        person.click("button", "Stop")
        began = person.page.evaluate("performance.now()")
        person.is_idle()
        stopping = person.page.evaluate("performance.now()") - began
        after = fem.state()
        changed = [key for key in before if before[key] != after[key] and key != "version"]
        must(not person.page.locator("#causes article").count(), "a diagnosis that was stopped shows causes")
        # Another one can be started, and is stopped by the keys of a page that was loaded anew.
        person.click("button", "Find what is missing")
        person.is_busy()
        person.page.reload()
        person.is_busy()
        person.click("button", "Stop")
        person.is_idle()
        # A shorter one ends by itself.
        person.click("button", "Compute the correction")
        person.corrected()
        person.is_calm()
    return {"changed": changed, "is_off_meanwhile": others, "stopping_ms": round(stopping)}


def overtaken(program):
    """The data are others when the diagnosis of those before comes: it is not told as if it were of these."""
    folder = Folder("story/rigid.toml", "story/measured.csv")
    lines = MEASURED.read_text().splitlines()
    (folder / "half.csv").write_text("\n".join(lines[:56]) + "\n")
    with browser() as own, opened(program, folder / "rigid.toml") as fem:
        person = Person(own, fem.url)
        person.click("checkbox", "measured.csv")
        person.reads("#head .verdict", re.compile(r"43\.2 µm"))
        fem.ask("POST", "data", {"files": ["half.csv"]})
        person.reads("#data", "54 rows")
        person.click("button", "Find what is missing")
        person.click("button", "Undo")
        person.reads("#data", "108 rows")
        person.is_idle()
        until(lambda: fem.state()["job"] is None, "the diagnosis does not end")
        diagnosis, redo = fem.state()["diagnosis"], fem.state()["redo"]
        if diagnosis:
            person.reads("#causes", re.compile("issing|xplain"))
        person.is_calm()
    return {"is_told_as_current": bool(diagnosis and diagnosis["is_current"]), "redo": redo}


finish({"mouse": mouse, "keys": keys, "stop": stop, "overtaken": overtaken})
