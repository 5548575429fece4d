"""Times `fem diagnose` of a heated rod with ten sensors, 500 rows: effects hidden, or one that the program does not know.

    cargo build --release && python3 benches/sensors.py target/release/fem

The rod is that of models/thermal.toml, heated for 90 min of 200 min; the model knows of its convection alone, roughly.
The program itself predicts what the sensors show with the effects of each case, and noise of 0.1 K is added. With --keep
DIR the files are left there. Nothing else should run beside it.
"""

import argparse
import csv
import pathlib
import random
import re
import resource
import subprocess
import tempfile
import time

MODEL = """process = "thermal"

[body]
material = "steel"
segments = [{ length = "200 mm", diameter = "20 mm" }]

[[source]]
at = "200 mm"
power = "15 W"
on = [["0 min", "90 min"]]

[environment]
temperature = "20 degC"

[time]
end = "200 min"
step = "30 s"

[measurement]
places = [PLACES]
interval = "4 min"

[effects.convection]
coefficient = "CONVECTION"
"""
EFFECTS = {
    "ambient-drift": 'amplitude = "1.5 K"\nperiod = "1.7 h"\nphase = "40 deg"',
    "base-conductance": 'conductance = "0.3 W/K"',
    "sensor-lag": 'time_constant = "90 s"',
    "heater-capacity": 'heat_capacity = "60 J/K"\ncontact = "0.5 W/K"',
}
CASES = {
    "one effect": ["base-conductance"],
    "two effects": ["base-conductance", "sensor-lag"],
    "four effects": list(EFFECTS),
    "four effects, noise unknown": list(EFFECTS),
    "one that no effect makes": [],
}
SENSORS, TIMES, NOISE = 10, 50, 0.1


def model(convection, effects=()):
    places = ", ".join(f'"{(i + 0.5) * 200 / SENSORS:g} mm"' for i in range(SENSORS))
    text = MODEL.replace("PLACES", places).replace("CONVECTION", convection)
    return text + "".join(f"\n[effects.{name}]\n{EFFECTS[name]}\n" for name in effects)


def predicted(fem, folder, effects):
    """Rows of time (min), place (mm) and temperature (degC) of the rod with these effects."""
    (folder / "truth.toml").write_text(model("13 W/m^2/K", effects))
    subprocess.run([fem, "run", "truth.toml", "-o", "truth", "--force"], cwd=folder, check=True, capture_output=True)
    with open(folder / "truth/profile.csv", newline="") as file:
        rows = [(float(r["time [min]"]), r["x [mm]"], r["temperature [degC]"]) for r in csv.DictReader(file)]
    rows = [(time, float(x), float(value)) for time, x, value in rows if value and time > 0.0]
    return rows[: SENSORS * TIMES]


def cpu():
    """CPU time of all programs that have been run (s)."""
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("fem", type=pathlib.Path)
    arguments.add_argument("--keep", type=pathlib.Path)
    given = arguments.parse_args()
    fem = given.fem.resolve()
    with tempfile.TemporaryDirectory() as place:
        for case, effects in CASES.items():
            folder = (given.keep or pathlib.Path(place)) / re.sub(r"\W+", "-", case)
            folder.mkdir(parents=True, exist_ok=True)
            draw = random.Random(7)
            rows = predicted(fem, folder, effects)
            known = "unknown" not in case
            with open(folder / "measured.csv", "w") as file:
                file.write("time [min],x [mm],temperature [degC]" + (",u [K]\n" if known else "\n"))
                for at, x, value in rows:
                    # Heat that comes and goes where no law of the program has it.
                    value += 0.8 * (at / 200) ** 2 * (x / 200) ** 3 * (1 if at < 110 else -1) * (not effects)
                    file.write(f"{at:g},{x:g},{value + draw.gauss(0.0, NOISE):.4f}" + (f",{NOISE}\n" if known else "\n"))
            (folder / "model.toml").write_text(model("15 +- 3 W/m^2/K"))
            start, before = time.time(), cpu()
            told = subprocess.run([fem, "diagnose", "model.toml", "--with", "measured.csv", "--profile"],
                                  cwd=folder, check=True, capture_output=True, text=True)
            seconds, busy = time.time() - start, cpu() - before
            evaluations = re.search(r"in all +\d+ +(\d+)", told.stderr)
            verdict = next(line for line in told.stdout.splitlines()[1:] if line)
            print(f"{case}, {len(rows)} rows: {seconds:.1f} s ({busy:.1f} s of CPU), {evaluations and evaluations[1]} evaluations; {verdict}")


if __name__ == "__main__":
    main()
