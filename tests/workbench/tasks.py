"""Six tasks of a newcomer who has read nothing, each with the clicks and keys that it takes.

    tasks.py FEM [verdict | causes | headings | sheet | trial | correction]

A task that the page has no means for yet answers null.
"""

import contextlib
import re
import zipfile
from xml.sax.saxutils import escape

from person import ROOT, Error, Folder, Person, browser, expect, finish, must, opened

MEASURED = ROOT / "models/story/measured.csv"
# Headings of another country: what they are, in which unit.
HEADINGS = [("Teil", "part", ""), ("Position", "x", "mm"), ("Kraft", "radial_force", "N"), ("Messwert", "diameter_error", "µm")]


def may_click(person, name, within="#head"):
    """Takes what the page offers as the next step, if it offers that."""
    button = person.at("button", name, within)
    if not button.is_visible():
        return False
    person.clicks += 1
    button.click()
    return True


def counted(person, task, **more):
    person.is_calm()
    return {"task": task, "clicks": person.clicks, "keys": person.keys, **more}


def compared(person):
    """From an empty page to the verdict."""
    person.reads("#head", "Open")
    if not may_click(person, "Open rigid.toml"):
        person.choose("Model file", "rigid.toml")
    person.reads("#head h1", "Shafts")
    offered = person.at("button", "Compare with measured.csv", "#head")
    person.clicks += 1
    offered.or_(person.at("checkbox", "measured.csv")).first.wait_for()
    # The page looks into the files first.
    with contextlib.suppress(Error):
        offered.wait_for(timeout=1000)
    (offered if offered.is_visible() else person.at("checkbox", "measured.csv")).click()
    person.reads("#head .verdict", re.compile(r"43\.2 µm"))


def verdict(program):
    folder = Folder("story/rigid.toml", "story/measured.csv")
    with browser() as own, opened(program, folder.path) as fem:
        person = Person(own, fem.url)
        compared(person)
        return counted(person, "open model and file, read the verdict", told=person.text("#head .verdict"))


def explained(person):
    """From a comparison that fails to one that is left with the noise."""
    if not may_click(person, "Find what is missing"):
        person.click("button", "Find what is missing")
    person.diagnosed()
    bars = person.page.get_by_role("list", name="The error falling").get_by_role("listitem")
    while "does not explain" in person.text("#head .verdict"):
        count = bars.count()
        must(count < 9, "adding what is missing comes to no end")
        together = person.at("button", re.compile(r"^Add the \d+"), "#head")
        more = int(re.search(r"\d+", together.inner_text()).group()) if together.is_visible() else 1
        if not may_click(person, re.compile("^Add ")):
            person.click("button", re.compile("^Add "), "#causes")
        expect(bars).to_have_count(count + more)


def causes(program):
    folder = Folder("story/rigid.toml", "story/measured.csv")
    with browser() as own, opened(program, folder / "rigid.toml") as fem:
        fem.ask("POST", "data", {"files": ["measured.csv"]})
        person = Person(own, fem.url)
        person.reads("#head .verdict", re.compile(r"43\.2 µm"))
        explained(person)
        return counted(person, "find what is missing and add it", left=person.bars()[-1])


def foreign(folder):
    """The story's measurements as a spreadsheet of another country has them."""
    lines = [line for line in MEASURED.read_text().splitlines() if not line.startswith("#")]
    rows = [line.split(",") for line in lines[1:]]
    text = [";".join(cell.replace(".", ",") for cell in row[:4]) for row in rows]
    (folder / "messung.csv").write_text("\n".join([";".join(heading for heading, *_ in HEADINGS), *text]) + "\n")


def headings(program):
    folder, elsewhere = Folder("story/rigid.toml"), Folder()
    foreign(elsewhere)
    with browser() as own, opened(program, folder / "rigid.toml") as fem:
        if "reading" not in str(fem.ask("GET", "columns.js")[1]):
            return None
        person = Person(own, fem.url)
        person.drop(elsewhere / "messung.csv")
        person.reads("#columns", "Messwert")
        for heading, name, unit in HEADINGS:
            # What is read right already needs no word, but for its unit.
            shown = person.at("combobox", re.compile(f"^{heading} is"), "#columns").locator("option").first.inner_text()
            if name not in shown.split():
                person.choose(re.compile(f"^{heading} is"), name, "#columns")
            called = re.compile(f"unit of {heading}")
            field = person.at("textbox", called, "#columns").or_(person.at("combobox", called, "#columns"))
            if unit and not re.fullmatch(f"{unit}|um", field.input_value() or field.get_attribute("placeholder") or ""):
                person.clicks += 1
                person.keys += len(unit)
                field.fill(unit)
        person.click("button", "Read it so")
        person.reads("#head .verdict", "rms")
        return counted(person, "a file with foreign headings made readable", told=person.text("#head .verdict"),
                       columns=[column["name"] for column in fem.state()["data"]["columns"]])


def workbook(path, sheets):
    """A workbook with these sheets, each a list of rows of numbers and texts."""
    def cell(value):
        try:
            return f"<c><v>{float(value)}</v></c>"
        except ValueError:
            return f'<c t="inlineStr"><is><t>{escape(value)}</t></is></c>'
    main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
    of = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
    package = "http://schemas.openxmlformats.org/package/2006"
    numbers = range(1, len(sheets) + 1)
    listed = "".join(f'<sheet name="{name}" sheetId="{i}" r:id="r{i}"/>' for i, name in zip(numbers, sheets))
    related = "".join(f'<Relationship Id="r{i}" Type="{of}/worksheet" Target="worksheets/sheet{i}.xml"/>' for i in numbers)
    with zipfile.ZipFile(path, "w") as file:
        file.writestr("[Content_Types].xml", f'<Types xmlns="{package}/content-types"><Default Extension="xml" ContentType="application/xml"/></Types>')
        file.writestr("_rels/.rels", f'<Relationships xmlns="{package}/relationships"><Relationship Id="w" Type="{of}/officeDocument" Target="xl/workbook.xml"/></Relationships>')
        file.writestr("xl/workbook.xml", f'<workbook xmlns="{main}" xmlns:r="{of}"><sheets>{listed}</sheets></workbook>')
        file.writestr("xl/_rels/workbook.xml.rels", f'<Relationships xmlns="{package}/relationships">{related}</Relationships>')
        for i, rows in zip(numbers, sheets.values()):
            text = "".join(f"<row>{''.join(cell(value) for value in row)}</row>" for row in rows)
            file.writestr(f"xl/worksheets/sheet{i}.xml", f'<worksheet xmlns="{main}"><sheetData>{text}</sheetData></worksheet>')


def sheet(program):
    """A workbook whose first table is another one, and whose headings stand below a row of numbers."""
    folder, elsewhere = Folder("story/rigid.toml"), Folder()
    lines = [line.split(",") for line in MEASURED.read_text().splitlines() if not line.startswith("#")]
    other = [["year", "parts"], *[[str(2000 + i), str(10 * i)] for i in range(8)]]
    workbook(elsewhere / "week.xlsx", {"Count": other, "Shafts": [["14", "2", "3", "4", "5"], *lines]})
    with browser() as own, opened(program, folder / "rigid.toml") as fem:
        person = Person(own, fem.url)
        person.drop(elsewhere / "week.xlsx")
        person.reads("#columns", "week.xlsx cannot be read")
        person.choose("Sheet", "Shafts", "#columns")
        person.reads("#columns", "Headings in line")
        field = person.at("spinbutton", "Headings in line", "#columns")
        field.fill("2")
        field.press("Tab")
        person.reads("#columns", "radial_force")
        person.click("button", "Read it so")
        person.reads("#head .verdict", "rms")
        return counted(person, "a sheet and a line of headings said", told=person.text("#head .verdict"),
                       commands=str(fem.state()["history"]), rows=fem.state()["data"]["rows"])


def trial(program):
    folder = Folder("story/rigid.toml", "story/measured.csv")
    with browser() as own, opened(program, folder / "rigid.toml") as fem:
        fem.ask("POST", "data", {"files": ["measured.csv"]})
        person = Person(own, fem.url)
        slider = person.at("slider", re.compile("workpiece segments.* diameter"))
        if not slider.is_visible():
            # In a table of the model it is one step further away.
            person.clicks += 1
            person.page.locator("#model [aria-label^=\"more of\"][aria-label*=diameter]").first.click()
        slider.scroll_into_view_if_needed()
        box = slider.bounding_box()
        person.clicks += 1
        before = person.text("#head .facts .main")
        slider.click(position={"x": box["width"] * 0.3, "y": box["height"] / 2})
        person.reads("#trial", re.compile(r"\d µm rms"))
        tried = person.text("#trial")
        must(person.text("#head .facts .main") == before, "a trial changes the error of the model")
        person.click("button", re.compile("^Use the trial value"))
        person.page.locator("#trial").wait_for(state="hidden")
        person.reads("#bar", "Save •")
        used = person.text("#head .facts .main")
        person.click("button", "Undo")
        person.reads("#bar", "Saved")
        undone = person.text("#head .facts .main")
        person.click("button", "Redo")
        person.reads("#bar", "Save •")
        person.click("summary", "Save as")
        person.write("File name", "thin.toml")
        person.click("button", "Save under this name")
        person.reads("#head", "thin.toml")
        must((folder / "thin.toml").read_text() != (folder / "rigid.toml").read_text(), "what was saved has not the value used")
        return counted(person, "try a value, use it, undo, redo, save under another name",
                       tried=tried, used=used, undone=undone, before=before)


def correction(program):
    folder = Folder("story/rigid.toml", "story/measured.csv")
    with browser() as own, opened(program, folder / "rigid.toml") as fem:
        if "Write the files" not in str(fem.ask("GET", "texts.js")[1]):
            return None
        fem.ask("POST", "data", {"files": ["measured.csv"]})
        person = Person(own, fem.url)
        explained(person)
        person.clicks = person.keys = 0
        if not may_click(person, "Compute the correction"):
            person.click("button", "Compute the correction")
        person.corrected()
        person.click("button", "Write the files", "#correct")
        person.reads("#correct", "Written")
        names = [name for name in folder.names() if name.startswith("corrected/")]
        return counted(person, "correct the job and write the files", names=names)


finish({"verdict": verdict, "causes": causes, "headings": headings, "sheet": sheet, "trial": trial, "correction": correction})
