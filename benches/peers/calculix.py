"""Runs CalculiX on an input file and reads what it printed of nodes."""

import pathlib
import re
import subprocess
import tempfile


def run(deck):
    """Version, and the numbers of every line of nodes that `ccx` printed for the text of an input file."""
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "job.inp").write_text(deck)
        done = subprocess.run(["ccx", "-i", "job"], cwd=folder, capture_output=True, text=True)
        if done.returncode != 0 or "*ERROR" in done.stdout:
            raise SystemExit(done.stdout[-2000:])
        printed = pathlib.Path(folder, "job.dat").read_text()
    version = re.search(r"Version ([0-9.]+)", done.stdout)
    lines = (line.split() for line in printed.splitlines())
    return version[1] if version else "?", [[float(v) for v in line] for line in lines if line and line[0].isdigit()]
