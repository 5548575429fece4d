"""Opens a page of `fem report` in a headless Chromium as a reader does, and tells as JSON what happened.

    look.py PAGE [SCREENSHOTS]

With a folder for screenshots, the page is also kept there as it looks in light, dark, on a phone and on paper.
"""

import json
import shutil
import sys
from importlib.resources import files
from pathlib import Path

from playwright.sync_api import sync_playwright

page_url = Path(sys.argv[1]).resolve().as_uri()
shots = Path(sys.argv[2]) if len(sys.argv) > 2 else None
axe = (files("axe_playwright_python") / "axe.min.js").read_text()
LOOKS = {
    "light": {"viewport": {"width": 1280, "height": 900}, "color_scheme": "light"},
    "dark": {"viewport": {"width": 1280, "height": 900}, "color_scheme": "dark"},
    "phone": {"viewport": {"width": 390, "height": 844}, "color_scheme": "light", "is_mobile": True, "has_touch": True},
}
found = {"trouble": [], "requests": [], "violations": [], "overflow": {}}


def opened(browser, **options):
    page = browser.new_context(**options).new_page()
    page.on("console", lambda m: found["trouble"].append(m.text) if m.type in ("error", "warning") else None)
    page.on("pageerror", lambda e: found["trouble"].append(str(e)))
    page.on("request", lambda r: found["requests"].append(r.url) if r.url != page_url else None)
    page.goto(page_url)
    return page


def look(page, name):
    found["overflow"][name] = page.evaluate("document.documentElement.scrollWidth - innerWidth")
    # The script of the check is run by the debugger, which a page's policy does not bind.
    page.evaluate(axe)
    result = page.evaluate("axe.run({runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'best-practice']})")
    for v in result["violations"]:
        found["violations"].append(f"{name}: {v['id']}: {v['nodes'][0]['html'][:160]}")
    if shots:
        page.screenshot(path=shots / f"{name}.png", full_page=True)


def use(page):
    """Hovers, walks by keys, zooms, slides, sorts and downloads."""
    figure = page.locator("figure").filter(has_text="measured over predicted").first
    if not figure.count():
        figure = page.locator("figure").first
    figure.scroll_into_view_if_needed()
    at = figure.evaluate("""f => { const s = f.querySelector('svg'), m = JSON.parse(f.querySelector('script').textContent).marks[0];
        const p = new DOMPoint(m[0], m[1]).matrixTransform(s.getScreenCTM()); return [p.x, p.y]; }""")
    page.mouse.move(*at)
    found["hover"] = page.locator("#tip").inner_text()
    page.mouse.move(1, 1)
    found["away"] = page.locator("#tip").is_hidden()
    view = figure.locator(".view")
    view.focus()
    view.press("ArrowRight")
    found["key"] = page.locator("#tip").inner_text()
    box = "f => f.querySelector('svg').getAttribute('viewBox')"
    whole = figure.evaluate(box)
    view.press("+")
    found["zoomed"] = figure.evaluate(box) != whole
    view.press("0")
    found["unzoomed"] = figure.evaluate(box) == whole
    steps = page.locator(".steps")
    if steps.count():
        shown = "() => [...document.querySelectorAll('.step')].map(s => !s.hidden)"
        found["first_step"] = page.evaluate(shown)
        steps.locator("input").focus()
        steps.locator("input").press("End")
        found["last_step"] = page.evaluate(shown)
        found["step_label"] = steps.locator("output").inner_text()
    table = page.locator("table.sortable").first
    column = "t => [...t.tBodies[0].rows].map(r => r.cells[0].textContent)"
    found["unsorted"] = table.evaluate(column)
    table.locator("th button").first.click()
    found["sorted"] = table.evaluate(column)
    for kind in ("CSV", "SVG"):
        with page.expect_download() as download:
            figure.get_by_role("button", name=f"as {kind}").click()
        found[kind] = Path(download.value.path()).read_text()[:4000]


with sync_playwright() as playwright:
    browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
    for name, options in LOOKS.items():
        page = opened(browser, **options)
        look(page, name)
        if name == "light":
            use(page)
            page.emulate_media(media="print")
            found["printed_steps"] = page.evaluate(
                "() => [...document.querySelectorAll('.step')].every(s => getComputedStyle(s).display !== 'none')")
            pdf = page.pdf(format="A4", prefer_css_page_size=True)
            if shots:
                (shots / "print.pdf").write_bytes(pdf)
        page.context.close()
    plain = opened(browser, java_script_enabled=False)
    found["plain_figures"] = plain.locator("figure svg").count()
    found["plain_verdict"] = plain.locator(".verdict").inner_text()
    found["plain_steps"] = all(step.is_visible() for step in plain.locator(".step").all())
    browser.close()
print(json.dumps(found))
