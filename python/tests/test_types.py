"""The types that the package states are those that it has."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import fem

# What a user might write, and one mistake.
USER = """
import fem

model = fem.new("turning")
model["cut"]["depth"] = "0.6 mm"
rows: int = model.run().profile.rows
better: fem.Model | None = model.diagnose("m.csv").model
wrong: str = model.run().profile.rows


def completed(fit: fem.Fit, diagnosis: fem.Diagnosis) -> list[fem.Model]:
    return [fit.model, *diagnosis.steps]
"""


def checked(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-m", *arguments], cwd=folder, capture_output=True, text=True, check=False)


def test_the_package_is_typed(tmp_path: Path) -> None:
    assert (Path(fem.__file__).parent / "py.typed").exists()
    told = checked(tmp_path, "mypy", "--strict", "-p", "fem")
    assert told.returncode == 0, told.stdout


def test_the_stub_is_that_of_the_extension(tmp_path: Path) -> None:
    told = checked(tmp_path, "mypy.stubtest", "fem._fem", "--ignore-disjoint-bases")
    assert told.returncode == 0, told.stdout


def test_users_see_the_types(tmp_path: Path) -> None:
    script = tmp_path / "user.py"
    script.write_text(USER)
    told = checked(tmp_path, "mypy", "--strict", str(script))
    assert told.returncode == 1 and told.stdout.count("error:") == 1 and "user.py:8" in told.stdout, told.stdout
