#!/usr/bin/env python3
"""Times `fem` beside its peers, each in a fresh process, and prints the tables of benches/README.md.

    python run.py --check                     the small cases with NumPy, SciPy and, where it is built, `fem`
    python run.py [CASE ...] [--threads N]    all of it, or `turning`, `joints`, `ring`, `heat`

Programs of one case and size take turns. What is not installed is told and left out.
"""

import argparse
import csv
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import numpy as np

import cases

HERE = pathlib.Path(__file__).parent
# Seconds after which a program is ended, and after which it is not asked again.
LONGEST, ENOUGH = 180.0, 40.0
# Cores in use by others from which wall times mean little.
MOST_BESIDE = 0.5

# Sizes, scripts (with variants) and what `fem` is asked beside them, by case.
SCRIPTS = {
    ("turning", "200"): ["scipy", "opensees", "ross", "pynite", "calculix"],
    ("turning", "1000"): ["scipy", "opensees", "ross"],
    ("joints", "200"): ["opensees joints"],
    ("joints", "1000"): ["opensees joints"],
    ("ring", "100k"): ["skfem cholmod", "skfem pardiso", "ngsolve", "calculix"],
    ("ring", "500k"): ["skfem cholmod", "skfem pardiso", "ngsolve"],
    ("heat", "100k"): ["skfem cholmod", "skfem pardiso", "ngsolve", "calculix"],
    ("heat", "500k"): ["skfem cholmod", "skfem pardiso", "ngsolve"],
}
NAMES = {
    "scipy": "band solver (SciPy)",
    "opensees": "OpenSeesPy, factored once",
    "opensees joints": "OpenSeesPy, Newton",
    "ross": "ROSS",
    "pynite": "PyNite",
    "calculix": "CalculiX",
    "skfem cholmod": "scikit-fem, CHOLMOD",
    "skfem pardiso": "scikit-fem, PARDISO",
    "ngsolve": "NGSolve",
}
# `fem` writes shapes for ParaView unless it is asked for figures alone.
FEM = {"fem run": ["-o"], "fem run --plot": ["--plot"]}
# Models, and what is written otherwise in them at each size.
MODELS = {"turning": "turning.toml", "joints": "turning-joints.toml", "ring": "ring.toml", "heat": "heat.toml"}
TURNING_1000 = {
    "positions = 200": "positions = 1000",
    'element_size = "3 mm"': 'element_size = "0.6 mm"',
    'from = "3 mm"': 'from = "0.6 mm"',
}
CHANGES = {
    ("turning", "1000"): TURNING_1000,
    ("joints", "1000"): TURNING_1000,
    ("ring", "100k"): {"circumferential = 288": "circumferential = 648", "radial = 11": "radial = 25"},
    # Of 8 nodes: 3 unknowns an element.
    ("heat", "100k"): {'"0.87 mm"': '"0.3876 mm"'},
}
# What the bench says: the bore at three angles, um; the time, s, a temperature, and the peak of memory.
RING_LINE = re.compile(r"u_r (\S+) (\S+) (\S+) um")
HEAT_LINE = re.compile(r"total ([\d.]+) s, BackwardEuler: hot ([\d.]+), imbalance \S+, peak (\d+) MB")


class Left(Exception):
    """Why a program has no figures."""


def environment(threads):
    """The same number of threads for every library; tuning that was meant for others is not handed on."""
    names = ("OMP", "MKL", "OPENBLAS", "RAYON")
    own = {k: v for k, v in os.environ.items() if not k.startswith("OPENBLAS_")}
    return own | {f"{name}_NUM_THREADS": str(threads) for name in names}


def timed(command, threads, folder):
    """Runs a command. What it printed; its wall time, CPU time with that of its children, s, and peak memory, MB."""
    start = time.perf_counter()
    with open(pathlib.Path(folder, "stdout"), "w+") as out, open(pathlib.Path(folder, "stderr"), "w+") as err:
        # GNU time starts it: the peak of a child of ours would begin with the memory of this interpreter.
        peak = pathlib.Path(folder, "peak")
        process = subprocess.Popen(
            ["/usr/bin/time", "-q", "-f", "%M", "-o", str(peak), *command],
            stdout=out,
            stderr=err,
            stdin=subprocess.DEVNULL,
            cwd=folder,
            env=environment(threads),
            start_new_session=True,
        )
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            wall = time.perf_counter() - start
            if pid:
                break
            if wall > LONGEST:
                os.killpg(process.pid, 9)
                os.wait4(process.pid, 0)
                process.returncode = -9
                raise Left(f"> {LONGEST:.0f} s")
            time.sleep(0.0005)
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0), err.seek(0)
        printed, said = out.read(), err.read()
    if process.returncode != 0:
        lines = (said or printed).strip().splitlines() or ["no word"]
        raise Left(f"exit status {process.returncode}: {lines[-1]}")
    figures = {"wall": wall, "cpu": usage.ru_utime + usage.ru_stime, "memory": int(peak.read_text()) / 1024}
    return printed, figures


def error(case, values, where=None, theory="euler-bernoulli"):
    """Largest difference from the exact answer, as a part of the largest value; of temperatures, of the rise."""
    values = np.asarray(values, dtype=float)
    if case in ("turning", "joints"):
        exact = cases.turning(cases.nodes(len(values)) if where is None else where, theory, case == "joints")
    elif case == "ring":
        exact = cases.ring()
        exact = exact if where is None else exact[where]
    else:
        exact = cases.heat()
        exact, values = exact - cases.HEAT.ambient, values - cases.HEAT.ambient
        exact = exact if len(values) == len(exact) else exact[: len(values)]
    return float(np.abs(values - exact).max() / np.abs(exact).max())


def script(case, size, name):
    """A function that runs a peer's script once."""
    stem, *variant = name.split()
    path = HERE / f"{'turning' if case == 'joints' else case}_{stem}.py"

    def once(threads, folder):
        printed, figures = timed([sys.executable, str(path), size, *variant], threads, folder)
        line = json.loads(next(line for line in printed.splitlines() if line.startswith("{")))
        return figures | {
            "version": line["version"],
            "own": line["cpu"],
            "error": error(case, line["values"], theory=line.get("theory", "euler-bernoulli")),
        }

    return once


def fem(binary, case, size, options):
    """A function that runs `fem run` once, and reads what it wrote."""
    text = (HERE / "models" / MODELS[case]).read_text()
    for old, new in CHANGES.get((case, size), {}).items():
        if text.count(old) != 1:
            raise SystemExit(f"models/{MODELS[case]}: expected {old!r} once, found it {text.count(old)} times")
        text = text.replace(old, new)

    def once(threads, folder):
        pathlib.Path(folder, "model.toml").write_text(text)
        printed, figures = timed([binary, "run", "model.toml", *options, "results", "--json"], threads, folder)
        found, where = json.loads(printed)["findings"], None
        profile = pathlib.Path(folder, "results", "profile.csv")
        tool = cases.TURNING.force / 5e7
        if case in ("turning", "joints") and profile.exists():
            with open(profile) as file:
                values = [float(row["diameter_error [um]"]) / 2e6 - tool for row in csv.DictReader(file)]
        elif case in ("turning", "joints"):
            values, where = [found["largest"]["value"] / 2e6 - tool], [found["largest"]["x"] / 1e3]
        elif case == "ring":  # The bore that is left is what it was squeezed by, the other way round.
            values, where = [-found["largest"]["value"] / 1e6, -found["smallest"]["value"] / 1e6], [0, 2]
        else:
            strain = found["largest"]["end"] / 1e6 / cases.HEAT.length
            values = [found["hottest"]["value"], cases.HEAT.ambient + strain / cases.HEAT.expansion]
        version = subprocess.run([binary, "--version"], capture_output=True, text=True).stdout.split()[-1]
        return figures | {"version": version, "own": figures["cpu"], "error": error(case, values, where)}

    return once


def benches():
    """The built bench of plane bodies, which has the solvers of `fem` without a command around them."""
    command = ["cargo", "bench", "--manifest-path", str(HERE / "../../Cargo.toml"), "--bench", "plane", "--no-run"]
    done = subprocess.run([*command, "--message-format", "json"], stdout=subprocess.PIPE, text=True, check=True)
    built = (json.loads(line) for line in done.stdout.splitlines())
    return next(b["executable"] for b in built if b.get("executable") and b["target"]["name"] == "plane")


def bench(path, case, size):
    """A function that asks the bench, which tells its own time: of heat it runs two schemes more."""
    cells = (cases.RING_CELLS if case == "ring" else cases.HEAT_CELLS)[size]

    def once(threads, folder):
        printed, figures = timed([path, case, *map(str, cells)], threads, folder)
        if case == "ring":
            values = [float(v) / 1e6 for v in RING_LINE.search(printed).groups()]
            version, memory = "whole mesh", figures["memory"]
        else:
            wall, hot, memory = (float(v) for v in HEAT_LINE.search(printed).groups())
            values, version = [hot], "temperatures alone"
            figures = {"wall": wall, "cpu": float("nan")}
        more = {"version": version, "own": figures["cpu"], "memory": memory}
        return figures | more | {"error": error(case, values)}

    return once


def others():
    """Cores that other programs keep busy, looked at for a moment: the load average would hold our own last run too."""

    def busy():
        with open("/proc/stat") as file:
            times = [int(v) for v in file.readline().split()[1:9]]
        return sum(times) - times[3] - times[4]

    before, start = busy(), time.perf_counter()
    time.sleep(0.5)
    return (busy() - before) / os.sysconf("SC_CLK_TCK") / (time.perf_counter() - start)


def measure(programs, repeats, threads):
    """Runs programs in turns. Figures of each run, or why there are none, by name."""
    taken = {name: [] for name in programs}
    left = {}
    for _ in range(repeats):
        for name, once in programs.items():
            if name in left or sum(run["wall"] for run in taken[name]) > ENOUGH:
                continue
            load, beside = os.getloadavg()[0], others()
            print(f"{name}: load average {load:.2f}, others use {beside:.1f} cores", file=sys.stderr, end="")
            if beside > MOST_BESIDE:
                print(" (WARNING: compare CPU times alone)", file=sys.stderr, end="")
            sys.stderr.flush()
            with tempfile.TemporaryDirectory() as folder:
                try:
                    taken[name].append(once(threads, folder) | {"load": load, "beside": beside})
                    print(": {wall:.3f} s, CPU {cpu:.3f} s".format(**taken[name][-1]), file=sys.stderr)
                except Left as reason:
                    left[name] = str(reason)
                    print(f": {reason}", file=sys.stderr)
    return taken, left


def table(case, size, taken, left, threads):
    """Lines of Markdown."""
    plural = "one thread" if threads == 1 else f"{threads} threads"
    yield f"**{case}, {size}, {plural}**"
    yield ""
    yield "| program | version | wall, s | CPU, s | CPU without imports, s | memory, MB | error |"
    yield "|---|---|---|---|---|---|---|"
    for name, runs in taken.items():
        if not runs:
            yield f"| {name} | | {left.get(name, '')} | | | | |"
            continue
        best = {key: min(run[key] for run in runs) for key in ("wall", "cpu", "own")}
        most = {key: max(run[key] for run in runs) for key in ("wall", "cpu", "own", "memory", "error")}
        spans = [span(best[key], most[key]) for key in ("wall", "cpu", "own")]
        yield f"| {name} | {runs[0]['version']} | {' | '.join(spans)} | {most['memory']:.0f} | {most['error']:.0e} |"
    beside = max((run["beside"] for runs in taken.values() for run in runs), default=0.0)
    yield ""
    yield f"Other programs used at most {beside:.1f} cores just before a run."
    yield ""


def span(least, most):
    """The least of some times, and the most where it is told apart."""
    if least != least:
        return "–"
    digits = 3 if least < 1 else 2 if least < 10 else 1
    texts = f"{least:.{digits}f}", f"{most:.{digits}f}"
    return texts[0] if texts[0] == texts[1] else " to ".join(texts)


def check(binary):
    """The small cases against the exact answers; how many are wrong. Tolerances are round-off or the mesh's error."""
    band = script("turning", "200", "scipy")
    # The condition of a plain stiffness grows with the fourth power of the elements: 200^4 times 1e-16.
    expected = [("turning", band, 2e-7)]
    if binary.exists():
        small = [("turning", "200", 1e-10), ("joints", "200", 1e-9), ("ring", "20k", 1e-4), ("heat", "20k", 1e-6)]
        expected += [(f"fem {c} {size}", fem(str(binary), c, size, FEM["fem run"]), most) for c, size, most in small]
    else:
        print(f"{binary} is not built: fem is left out")
    wrong = 0
    for name, once, most in expected:
        with tempfile.TemporaryDirectory() as folder:
            off = once(1, folder)["error"]
        wrong += not off <= most
        print(f"{name}: error {off:.1e}, at most {most:.0e}{'' if off <= most else ' WRONG'}")
    # Another theory of beams must be told apart.
    other = error("turning", cases.turning(cases.nodes(200), "timoshenko"))
    wrong += not 1e-3 < other < 1e-1
    print(f"shear that is left out: {other:.1e}")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", nargs="*", metavar="CASE", help="turning, joints, ring or heat")
    parser.add_argument("--check", action="store_true", help="only check the small cases")
    parser.add_argument("--fem", type=pathlib.Path, default=HERE / "../../target/release/fem", help="the program")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--size", help="this size alone")
    parser.add_argument("--bench", action="store_true", help="also the solvers for ring and heat alone, by cargo bench")
    arguments = parser.parse_args()
    binary = arguments.fem.resolve()
    if not pathlib.Path("/usr/bin/time").exists():
        parser.error("GNU time is not there, which tells the peak of memory: apt-get install time")
    if arguments.check:
        raise SystemExit(1 if check(binary) else 0)
    if not binary.exists():
        parser.error(f"{binary} is not there: build it by cargo build --release, or say --fem PATH")
    built = benches() if arguments.bench else None
    for (case, size), names in SCRIPTS.items():
        if arguments.cases and case not in arguments.cases or arguments.size not in (None, size):
            continue
        programs = {}
        # A command refuses so many elements.
        if size != "500k":
            programs |= {label: fem(str(binary), case, size, options) for label, options in FEM.items()}
        if built and case in ("ring", "heat"):
            programs["fem, bench"] = bench(built, case, size)
        programs |= {NAMES[name]: script(case, size, name) for name in names}
        taken, left = measure(programs, arguments.repeats, arguments.threads)
        print("\n".join(table(case, size, taken, left, arguments.threads)), flush=True)


if __name__ == "__main__":
    main()
