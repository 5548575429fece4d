"""What the tests share: the story of a lathe that is believed to be rigid."""

from __future__ import annotations

import os
import subprocess
import sysconfig
import tempfile
from pathlib import Path
from typing import Any

import matplotlib
import pytest

import fem

matplotlib.use("agg")

# What the program keeps of what it wrote is of the tests alone.
os.environ["XDG_STATE_HOME"] = tempfile.mkdtemp(prefix="fem-state-")

ROOT = Path(__file__).parents[2]


@pytest.fixture
def root() -> Path:
    """The repository."""
    return ROOT


@pytest.fixture
def rigid() -> fem.Model:
    """The model of the story."""
    return fem.demo().model


@pytest.fixture
def measured() -> dict[str, Any]:
    """The measurements of the story."""
    return fem.demo().measured


@pytest.fixture(scope="session")
def found() -> fem.Diagnosis:
    """What is missing in the story."""
    model, measured = fem.demo()
    return model.diagnose(measured)


class Command:
    """The command `fem` that came with the package."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    @property
    def program(self) -> str:
        """Its path."""
        return str(Path(sysconfig.get_path("scripts")) / "fem")

    def __call__(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [self.program, *arguments], cwd=self.folder, capture_output=True, text=True, timeout=300, check=False
        )


@pytest.fixture
def command(tmp_path: Path) -> Command:
    """Runs the command in a folder of its own."""
    return Command(tmp_path)
