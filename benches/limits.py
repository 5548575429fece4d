"""Measures what docs/limits.md promises, at its largest sizes: time, the peak of memory, and what is written.

    cargo build --release && python3 benches/limits.py target/release/fem

Each line is a fresh process. Names, or parts of them, may follow: `python3 benches/limits.py target/release/fem ring page`.
"""

import argparse
import math
import os
import pathlib
import subprocess
import tempfile
import time

import rows

MODELS = pathlib.Path(__file__).parent.parent / "models"


def model(name, *changes):
    """The text of a model with parts of it replaced."""
    text = (MODELS / name).read_text()
    for before, after in changes:
        assert before in text, before
        text = text.replace(before, after)
    return text


def heated(body, size):
    return f"""process = "thermal"
[body]
material = "steel"
{body}
[[boundary]]
edge = "left"
flux = "20 kW/m^2"
[environment]
temperature = "20 degC"
[time]
end = "1 min"
step = "1 s"
[mesh]
element_size = "{size} mm"
[effects.convection]
coefficient = "20 W/m^2/K"
"""


def drawn_ring(around, across):
    """A ring of 100 and 84 mm in 8-node quadrilaterals, with three jaws over 24 deg, as Gmsh writes it (MSH 4.1)."""
    nodes, numbers = [], {}

    def node(i, j):
        key = (i % (2 * around), j)
        if key not in numbers:
            angle, radius = math.pi * key[0] / around, 42.0 + 8.0 * j / (2 * across)
            nodes.append((radius * math.cos(angle), radius * math.sin(angle)))
            numbers[key] = len(nodes)
        return numbers[key]

    quads = []
    for i in range(0, 2 * around, 2):
        for j in range(0, 2 * across, 2):
            corners = [(i, j), (i, j + 2), (i + 2, j + 2), (i + 2, j)]
            middles = [(i, j + 1), (i + 1, j + 2), (i + 2, j + 1), (i + 1, j)]
            quads.append([node(*at) for at in corners + middles])
    half = around // 30
    curves = {}
    for jaw in range(3):
        middle = jaw * around // 3
        curves[jaw + 1] = [(2 * cell, 2 * across) for cell in range(middle - half, middle + half)]
    curves[4] = [(2 * cell, 0) for cell in range(around)]
    sides = {tag: [[node(i, j), node(i + 2, j), node(i + 1, j)] for i, j in of] for tag, of in curves.items()}
    lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$PhysicalNames", "5"]
    lines += [f'1 {tag} "{name}"' for tag, name in enumerate(["jaw-1", "jaw-2", "jaw-3", "bore"], 1)]
    lines += ['2 5 "ring"', "$EndPhysicalNames", "$Entities", "0 4 1 0"]
    lines += [f"{tag} -50 -50 0 50 50 0 1 {tag} 0" for tag in range(1, 5)]
    lines += ["1 -50 -50 0 50 50 0 1 5 0", "$EndEntities", "$Nodes", f"1 {len(nodes)} 1 {len(nodes)}"]
    lines += [f"2 1 0 {len(nodes)}", *map(str, range(1, len(nodes) + 1)), *(f"{x!r} {y!r} 0" for x, y in nodes)]
    count = len(quads) + sum(map(len, sides.values()))
    lines += ["$EndNodes", "$Elements", f"{1 + len(sides)} {count} 1 {count}"]
    number = 0
    for dimension, tag, kind, of in [*((1, tag, 8, own) for tag, own in sides.items()), (2, 1, 16, quads)]:
        lines.append(f"{dimension} {tag} {kind} {len(of)}")
        for own in of:
            number += 1
            lines.append(" ".join(map(str, [number, *own])))
    return "\n".join([*lines, "$EndElements", ""])


def divided_bed(members):
    """The lathe on its bed, the middle of the bed in so many members."""
    before, bed = model("lathe-on-bed.toml").split("[structure.bed-b]", 1)
    after = bed[bed.index("[structure.bed-c]") :]
    ends = ["under-headstock", *(f"bed{i}" for i in range(1, members)), "under-tailstock"]
    places = (f'{end} = ["{-200 + 920 * i / members} mm", "-350 mm"]\n' for i, end in enumerate(ends[1:-1], 1))
    section = 'width = "350 mm"\nheight = "220 mm"\nwall = "18 mm"\n'
    pieces = (f'[structure.bed-b{i}]\nbetween = ["{ends[i]}", "{ends[i + 1]}"]\n{section}\n' for i in range(members))
    names = "".join(f'"bed-b{i}", ' for i in range(members))
    before = before.replace("[structure.nodes]\n", "[structure.nodes]\n" + "".join(places)).replace('"bed-b", ', names)
    return before + "".join(pieces) + after


def wide(path, columns):
    with open(path, "w") as file:
        file.write(",".join(["part", "x [mm]", "diameter_error [um]", *(f"c{i}" for i in range(columns - 3))]) + "\n")
        for i in range(1000):
            file.write(",".join([str(1 + i % 12), f"{0.6 * i:.1f}", "100", *("1" for _ in range(columns - 3))]) + "\n")


def header(path, size):
    with open(path, "w") as file:
        file.write("part,x [mm],diameter_error [um]")
        for _ in range(size // 1_000_000):
            file.write(",column" * 142_857)
        file.write("\n1,2,3\n")


def cases(of_parts):
    """(name, files by their names, what writes those that are large, arguments)"""
    lathe = model("lathe.toml")
    ring = model("ring.toml")
    mesh = "circumferential = 360\nradial = 6\norder = 2"
    before, arc = ring.split("[effects.jaw-contact-arc]")
    drawn = before.replace(mesh, 'file = "ring.msh"') + "[effects" + arc.split("[effects", 1)[1]
    run = ["run", "model.toml", "-o", "out"]
    with_rows = ["--with", "rows.csv"]
    sheet = 'rectangle = { length = "400 mm", height = "40 mm", width = "100 mm" }'
    sleeve = 'revolved = [{ length = "400 mm", diameter = "120 mm", bore = "40 mm" }]'
    return [
        ("500 000 predicted points", {"model.toml": model("lathe.toml", ("positions = 101", "positions = 10000"), ("parts = 12", "parts = 50"))}, run),
        ("rod of 20 000 elements", {"model.toml": model("thermal.toml") + '\n[mesh]\nelement_size = "0.01 mm"\n'}, run),
        ("rod, 200 000 steps", {"model.toml": model("thermal.toml", ('step = "30 s"', 'step = "54 ms"'))}, run),
        ("structure of 9900 members", {"model.toml": divided_bed(9880)}, run),
        ("plate of 50 000 elements", {"model.toml": heated(sheet, 0.57)}, run),
        ("sleeve of 50 000 elements", {"model.toml": heated(sleeve, 0.57)}, run),
        ("ring of 40 000 equal cells", {"model.toml": ring.replace(mesh, "circumferential = 5000\nradial = 8")}, run),
        ("ring of 40 000 drawn elements", {"model.toml": drawn, "ring.msh": lambda path: path.write_text(drawn_ring(4000, 10))}, run),
        ("cam of 20 000 blocks", {"model.toml": model("cam.toml", ('step = "0.5 mm"', "blocks = 20000"), (", blocks = 1 ", " "), (", blocks = 4 ", " "))}, run),
        ("1000 columns", {"model.toml": lathe, "rows.csv": lambda path: wide(path, 1000)}, ["compare", "model.toml", *with_rows]),
        ("6 000 000 rows", {"model.toml": lathe, "rows.csv": lambda path: rows.write(path, of_parts, 6_000_000, False)}, ["compare", "model.toml", *with_rows]),
        ("page of 10^6 rows", {"model.toml": lathe, "rows.csv": lambda path: rows.write(path, of_parts, 1_000_000, False)}, ["report", "model.toml", *with_rows, "-o", "page.html"]),
        ("header of 300 MB", {"model.toml": lathe, "rows.csv": lambda path: header(path, 300_000_000)}, ["compare", "model.toml", *with_rows]),
    ]


def write_apart(write, path):
    """Writes in a process of its own: a child begins with the peak of memory of its parent."""
    child = os.fork()
    if child == 0:
        write(path)
        os._exit(0)
    os.waitpid(child, 0)


def measure(fem, files, arguments):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for name, text in files.items():
            if isinstance(text, str):
                (folder / name).write_text(text)
            else:
                write_apart(text, folder / name)
        before = {path for path in folder.rglob("*")}
        start = time.time()
        with open(folder / "told", "w") as told:
            child = subprocess.Popen([fem, *arguments], cwd=folder, stdout=told, stderr=subprocess.STDOUT)
            _, status, usage = os.wait4(child.pid, 0)
        took = time.time() - start
        written = sum(path.stat().st_size for path in folder.rglob("*") if path.is_file() and path not in before)
        last = [line for line in (folder / "told").read_text().splitlines() if "error" in line or "×" in line]
        return took, usage.ru_maxrss / 1024, written / 1e6, os.waitstatus_to_exitcode(status), last[:1]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fem")
    parser.add_argument("names", nargs="*")
    given = parser.parse_args()
    fem = str(pathlib.Path(given.fem).resolve())
    print("| what | time | memory | written | status |\n|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        of_parts = rows.profiles(fem, pathlib.Path(folder))
    for name, files, arguments in cases(of_parts):
        if given.names and not any(own in name for own in given.names):
            continue
        took, memory, written, status, said = measure(fem, files, arguments)
        told = f", {said[0].strip()}" if status else ""
        print(f"| {name} | {took:.1f} s | {memory:.0f} MB | {written:.1f} MB | {status}{told} |", flush=True)


main()
