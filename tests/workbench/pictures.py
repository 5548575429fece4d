"""Pictures of the story for a book, as PNG of 1400 by 900 points and few colours.

    pictures.py FEM OUT

workbench-fails, workbench-causes, workbench-explained, workbench-corrected
"""

import re
import struct
import zlib
from collections import Counter
from pathlib import Path

from person import CAUSES, Folder, Person, arguments, browser, opened

MOST = 150_000  # bytes of a picture


def palette(png):
    """The same picture with at most 256 colours, which is a third of the bytes: text and lines have few."""
    at, parts = 8, {}
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        parts[kind] = parts.get(kind, b"") + png[at + 8:at + 8 + length]
        at += 12 + length
    width, height, depth, colour = struct.unpack(">IIBB", parts[b"IHDR"][:10])
    size = {2: 3, 6: 4}[colour]
    raw, row, rows = zlib.decompress(parts[b"IDAT"]), bytearray(width * size), []
    for y in range(height):
        begin = y * (width * size + 1)
        above, row = row, bytearray(raw[begin + 1:begin + 1 + width * size])
        unfilter(raw[begin], row, above, size)
        rows.append([bytes(row[i:i + 3]) for i in range(0, len(row), size)])
    counts = Counter(pixel for line in rows for pixel in line)
    kept = [pixel for pixel, _ in counts.most_common(256)]
    number = {pixel: i for i, pixel in enumerate(kept)}
    for pixel in counts:
        if pixel not in number:
            number[pixel] = min(range(len(kept)), key=lambda i: sum((a - b) ** 2 for a, b in zip(kept[i], pixel)))
    lines = b"".join(b"\0" + bytes(number[pixel] for pixel in line) for line in rows)
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)
    return png[:8] + chunk(b"IHDR", head) + chunk(b"PLTE", b"".join(kept)) + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b"")


def unfilter(kind, row, above, size):
    """Takes back what a PNG does to a row before it is packed."""
    for i in range(len(row)):
        left = row[i - size] if i >= size else 0
        if kind == 1:
            row[i] = (row[i] + left) & 255
        elif kind == 2:
            row[i] = (row[i] + above[i]) & 255
        elif kind == 3:
            row[i] = (row[i] + (left + above[i] >> 1)) & 255
        elif kind == 4:
            corner = above[i - size] if i >= size else 0
            far = left + above[i] - corner
            a, b, c = abs(far - left), abs(far - above[i]), abs(far - corner)
            row[i] = (row[i] + (left if a <= b and a <= c else above[i] if b <= c else corner)) & 255


def shoot(person, out, name, pane=None):
    """What can be seen, from the pane downwards if one is named: without what is said for a moment."""
    page = person.page
    page.evaluate("""pane => {
      document.getElementById('said').textContent = '';
      document.activeElement?.blur();
      if (pane) document.getElementById(pane).scrollIntoView({block: 'start', behavior: 'instant'}); else scrollTo(0, 0);
    }""", pane)
    page.mouse.move(0, 0)
    file = out / f"workbench-{name}.png"
    file.write_bytes(palette(page.screenshot(animations="disabled", caret="hide")))
    size = file.stat().st_size
    print(f"{file.name} {size} bytes{' (too large)' * (size > MOST)}")


def main():
    program, out = arguments(2)[:2]
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    folder = Folder("story/rigid.toml", "story/measured.csv")
    # A name that a reader knows.
    shop = folder.path / "shop"
    shop.mkdir()
    for name in folder.names():
        if "." in name:
            (folder / name).rename(shop / name)
    with browser() as own, opened(program, shop / "rigid.toml") as fem:
        person = Person(own, fem.url, device_scale_factor=1, color_scheme="light", reduced_motion="reduce")
        person.click("checkbox", "measured.csv")
        person.reads("#head .verdict", re.compile(r"43\.2 µm"))
        shoot(person, out, "fails")
        person.click("button", "Find what is missing")
        person.diagnosed()
        shoot(person, out, "causes")
        for cause in CAUSES:
            person.click("button", f"Add {cause}", "#causes")
            person.bars_are(2 + CAUSES.index(cause))
        shoot(person, out, "explained")
        person.click("button", "Compute the correction")
        person.corrected()
        shoot(person, out, "corrected", "correct")
        person.is_calm()


if __name__ == "__main__":
    main()
