"""From cause to action: bands, corrections, remedies, the next part."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

import fem


@pytest.fixture
def shaft(root: Path) -> fem.Model:
    """A shaft with a drawing, on a lathe that is known roughly."""
    return fem.load(str(root / "models/correction/shaft.toml"))


def test_a_correction_is_what_the_command_says(shaft: fem.Model, command: Any, tmp_path: Path) -> None:
    found = shaft.correct(output=tmp_path / "here")
    told = command("correct", shaft.name, "--json", "-o", "there")
    assert found.to_dict() == json.loads(told.stdout)
    files = [sorted(p.name for p in (tmp_path / folder).iterdir()) for folder in ("here", "there")]
    assert files[0] == files[1] and "correction.html" in files[0] and "contour.ngc" in files[0]
    frame = pd.read_csv(tmp_path / "there/correction.csv")
    pd.testing.assert_frame_equal(found.to_pandas(), frame, check_dtype=False, rtol=1e-9)
    rows = found.rows
    assert np.all(rows["left_from"] <= rows["left"]) and np.all(rows["left"] <= rows["left_to"])
    assert found.rms.left < 0.2 * found.rms.before


def test_a_program_goes_into_the_folder(shaft: fem.Model, tmp_path: Path) -> None:
    program = tmp_path / "part.ngc"
    program.write_text("G18 G21\nG0 X42. Z2.\nG1 X40. F0.15\nZ-120.\nX50.\nZ-380.\nX40.\nZ-500.\nG0 X60.\nM30\n")
    found = shaft.correct(program, add_blocks=True, output=tmp_path / "out")
    assert found.document["program"]["words_changed"] > 0
    assert (tmp_path / "out/part.ngc").read_text() != program.read_text()
    with pytest.raises(fem.Error):
        shaft.correct(program, output=tmp_path)


def test_a_process_without_a_command_is_advised(root: Path) -> None:
    found = fem.load(str(root / "models/cam.toml")).correct()
    assert found.rows.rows == 0 and found.document["correction"] == []


def test_a_prediction_has_its_band(shaft: fem.Model, rigid: fem.Model) -> None:
    design = {"part": [1, 8], "x [mm]": [250, 250]}
    plain = shaft.predict(design)
    assert "from" not in plain
    banded = shaft.predict(design, bands=True)
    assert np.array_equal(plain["predicted"], banded["predicted"])
    assert np.all(banded["from"] < banded["predicted"]) and np.all(banded["predicted"] < banded["to"])
    assert np.allclose(banded["upper_limit"], 40)
    # The last part is known less well than the first: wear.
    assert np.diff(banded["to"] - banded["from"])[0] > 0
    # What is known exactly has no width.
    exact = rigid.predict(bands=True)
    assert np.array_equal(exact["from"], exact["to"]) and exact.rows > 0


def test_remedies_give_a_model(root: Path) -> None:
    model = fem.load(str(root / "models/correction/remedies.toml"))
    found = model.remedies()
    frame = found.to_pandas()
    assert list(frame.columns[:3]) == ["setting", "from", "to"] and len(frame) > 0
    assert found.model is not None and found.model.name != model.name
    assert found.model.correct().rms.left <= model.correct().rms.left * 1.5


def test_the_next_part_is_what_the_command_says(root: Path, command: Any, tmp_path: Path) -> None:
    for name in ("lathe.toml", "log.toml", "today.csv"):
        shutil.copy(root / "models/next" / name, tmp_path / name)
    log, today = tmp_path / "log.toml", tmp_path / "today.csv"
    before = log.read_text()
    found = fem.next_part(log, today, dry_run=True)
    assert log.read_text() == before and "<html" in found.page.html
    told = command("next", "log.toml", "--with", "today.csv", "--json")
    told = json.loads(told.stdout)
    assert found.to_dict() | {"log": None} == told | {"log": None}
    # The command has added to the log; to say it again adds nothing.
    after = log.read_text()
    assert after.startswith(before) and len(after) > len(before)
    fem.next_part(log, today)
    assert log.read_text() == after
    frame = pd.read_csv(today)
    with pytest.raises(fem.Error):
        fem.next_part(log, frame, job="nobody")
