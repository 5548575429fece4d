"""The wheel brings the command `fem`, with its exit statuses."""

from __future__ import annotations

import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import fem


def test_it_is_the_command(command: Any) -> None:
    assert command("--version").stdout == f"fem {fem.__version__}\n"
    assert command("effects", "tool-wear").stdout == fem.effects("tool-wear").text
    module = subprocess.run([sys.executable, "-m", "fem", "--version"], capture_output=True, text=True, check=True)
    assert module.stdout == command("--version").stdout


def test_its_status_says_what_went_wrong(command: Any, root: Path) -> None:
    lathe = str(root / "models/lathe.toml")
    assert command("run", lathe).returncode == 0
    wrong = command("run", "nowhere.toml")
    assert (wrong.returncode, wrong.stdout) == (2, "") and "nowhere.toml" in wrong.stderr
    assert command("run").returncode == 2
    assert command("run", lathe, "-o", "/dev/null/there").returncode == 1


def test_a_reader_that_goes_away_is_no_error(command: Any) -> None:
    with subprocess.Popen([command.program, "effects"], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout and process.stderr
        process.stdout.close()
        assert process.stderr.read() == b""
    assert process.returncode == 0


def test_ctrl_c_ends_it(command: Any, root: Path) -> None:
    arguments = ["report", str(root / "models/lathe.toml"), "--serve"]
    with subprocess.Popen(
        [command.program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=command.folder
    ) as process:
        assert process.stdout
        # It serves until it is stopped, once it has said where.
        assert "http://127.0.0.1" in process.stdout.readline()
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=60) == 130
