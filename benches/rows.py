"""Times `fem compare` and `fem diagnose` on as many rows as instruments write, and `fem fit` of six parameters.

    cargo build --release && python3 benches/rows.py target/release/fem 1000000

The rows are shafts of models/lathe.toml at places of their own, with the tailstock set over and a noise of 0.3 um;
with --unknown in a wave as well that no effect makes. Nothing else should run beside it.
"""

import argparse
import bisect
import csv
import math
import pathlib
import random
import resource
import subprocess
import tempfile
import time

MODELS = pathlib.Path(__file__).parent.parent / "models"
PARTS, NOISE = 12, 0.3
SIX = {
    'stiffness = "60 +- 10 N/um"': 'stiffness = "? N/um"',
    'stiffness = "40 +- 8 N/um"': 'stiffness = "? N/um"',
    'rate = "8 um/km"': 'rate = "? um/km"',
    'elongation = "12 um"': 'elongation = "? um"',
    'time_constant = "6 min"': 'time_constant = "? min"',
}


def profiles(fem, folder):
    """Diameter error (um) over x (mm) of every part, as the program predicts it with the tailstock set over."""
    model = (MODELS / "lathe.toml").read_text().replace("positions = 101", "positions = 2001")
    (folder / "truth.toml").write_text(model + '\n[effects.tailstock-offset]\noffset = "12 um"\n')
    subprocess.run([fem, "run", "truth.toml", "-o", "truth"], cwd=folder, check=True, capture_output=True)
    of_parts = {part: ([], []) for part in range(1, PARTS + 1)}
    with open(folder / "truth/profile.csv", newline="") as file:
        for row in csv.DictReader(file):
            x, y = of_parts[int(row["part"])]
            x.append(float(row["x [mm]"]))
            y.append(float(row["diameter_error [um]"]))
    return of_parts


def write(path, of_parts, rows, unknown):
    draw = random.Random(5)
    with open(path, "w") as file:
        file.write("part,x [mm],diameter_error [um],u [um]\n")
        for _ in range(rows):
            part, at = draw.randint(1, PARTS), draw.uniform(0.0, 600.0)
            x, y = of_parts[part]
            i = min(max(bisect.bisect(x, at), 1), len(x) - 1)
            value = y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1])
            value += 12.0 * math.sin(2.0 * math.pi * at / 170.0) if unknown else 0.0
            file.write(f"{part},{at:.5f},{value + draw.gauss(0.0, NOISE):.3f},{NOISE}\n")


def timed(command, folder):
    start = time.time()
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    return time.time() - start


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("fem", type=pathlib.Path)
    arguments.add_argument("rows", type=int, nargs="?", default=1_000_000)
    arguments.add_argument("--unknown", action="store_true")
    given = arguments.parse_args()
    fem = given.fem.resolve()
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        of_parts = profiles(fem, folder)
        model = (MODELS / "lathe.toml").read_text()
        (folder / "model.toml").write_text(model)
        for known, free in SIX.items():
            assert known in model, known
            model = model.replace(known, free)
        (folder / "six.toml").write_text(model)
        write(folder / "rows.csv", of_parts, given.rows, given.unknown)
        write(folder / "few.csv", of_parts, 600, given.unknown)
        megabytes = (folder / "rows.csv").stat().st_size / 1e6
        print(f"{given.rows} rows, {megabytes:.0f} MB")
        for command, model, rows in [("fit", "six", "few"), ("compare", "model", "rows"), ("diagnose", "model", "rows")]:
            seconds = timed([fem, command, f"{model}.toml", "--with", f"{rows}.csv"], folder)
            peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1e3
            print(f"fem {command} {model}.toml --with {rows}.csv: {seconds:.2f} s, most memory so far {peak:.0f} MB")


if __name__ == "__main__":
    main()
