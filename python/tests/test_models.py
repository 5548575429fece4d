"""Models are read, made, changed and kept without a file."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path

import numpy as np
import pytest

import fem

CIRCLE = {
    "process": "contour",
    "path": {"shape": "circle", "radius": "150 mm", "feed": "1000 mm/min"},
    "drives": {"gain": "50 /s"},
}


def test_a_file_is_read_as_it_is(root: Path) -> None:
    path = root / "models/lathe.toml"
    model = fem.load(path)
    assert model.text == path.read_text()
    assert model.name == str(path)
    assert model.process == "turning"
    assert "tailstock-compliance" in model.effects
    headstock = model.parameters[0]
    assert headstock == fem.Parameter("effects.headstock-compliance.stiffness", "N/um", 60.0, 10.0)


@pytest.mark.parametrize(
    "process", ["turning", "ring", "thermal", "fixture", "stiffness", "axis", "rotary", "contour", "cam"]
)
def test_every_process_has_a_model_to_start_from(process: str) -> None:
    model = fem.new(process)
    assert model.process == process
    assert model.run().profile.rows > 1


def test_a_mapping_makes_a_model() -> None:
    model = fem.model(CIRCLE).add("backlash-x", gap="6 um")
    assert model.effects == ["backlash-x"]
    # Half of the play stands on either side of the circle.
    change = model.run().changes["backlash-x"]
    assert np.max(change) == pytest.approx(3.0, abs=0.01)
    assert np.min(change) == pytest.approx(-3.0, abs=0.01)
    assert fem.model(model.to_dict()).run().profile["deviation"] == pytest.approx(model.run().profile["deviation"])


def test_keys_change_a_model_and_keep_its_comments() -> None:
    model = fem.new("turning")
    before = model.text
    model["cut"]["depth"] = "0.7 mm"
    assert model["cut"]["depth"] == "0.7 mm"
    changed = [(a, b) for a, b in zip(before.splitlines(), model.text.splitlines()) if a != b]
    assert len(changed) == 1 and changed[0][1].startswith('depth = "0.7 mm"')
    assert changed[0][0].partition("#")[2] == changed[0][1].partition("#")[2]
    model["workpiece"]["segments"][0]["length"] = "300 mm"
    model["batch"]["parts"] = np.int64(3)
    assert max(model.run().profile["x"]) == 300.0
    assert sorted(set(model.run().profile["part"])) == [1, 2, 3]
    del model["effects"]["headstock-compliance"]
    assert model.effects == ["tailstock-compliance"]
    with pytest.raises(KeyError, match="there is depth"):
        model["cut"]["depht"]


def test_a_changed_copy_leaves_its_model_alone() -> None:
    model = fem.model(CIRCLE)
    faster = model.with_({"path.feed": "2000 mm/min", "effects.backlash-x.gap": "6 um"})
    assert model["path"]["feed"] == "1000 mm/min" and model.effects == []
    # The servos shrink a circle with the square of the feed.
    shrunk = [np.mean(m.run().changes["ideal"]) for m in (model, faster)]
    assert shrunk[1] / shrunk[0] == pytest.approx(4.0, rel=1e-3)
    with pytest.raises(fem.ModelError):
        model.with_({"path.feed": "2000 mm"})
    assert model == fem.model(CIRCLE) and model != faster


def test_what_no_model_holds_is_refused() -> None:
    model = fem.model(CIRCLE)
    for wrong in (None, float("nan"), object()):
        with pytest.raises((TypeError, ValueError)):
            model["path"]["radius"] = wrong
    assert model["path"]["radius"] == "150 mm"


def test_a_model_is_saved_and_never_written_over(tmp_path: Path, rigid: fem.Model) -> None:
    place = rigid.save(tmp_path / "own.toml")
    assert fem.load(place).text == rigid.text
    with pytest.raises(FileExistsError, match="overwrite=True"):
        rigid.add("tool-wear", rate="8 um/km").save(place)
    assert fem.load(place).effects == []
    rigid.add("tool-wear", rate="8 um/km").save(place, overwrite=True)
    assert fem.load(place).effects == ["tool-wear"]
    assert [file.name for file in tmp_path.iterdir()] == ["own.toml"]


def test_models_pickle_by_their_text(root: Path, rigid: fem.Model) -> None:
    for model in (rigid, fem.load(root / "models/lathe.toml")):
        again = pickle.loads(pickle.dumps(model))
        assert again == model and again.run().text == model.run().text
        assert copy.deepcopy(model) == model
    assert len(pickle.dumps(rigid)) < len(rigid.text) + 200


def test_a_mistake_is_told_with_place_and_remedy(rigid: fem.Model) -> None:
    rigid["cut"]["depht"] = "0.6 mm"
    rigid["workholding"]["type"] = "center"
    with pytest.raises(fem.ModelError) as caught:
        rigid.run()
    error = caught.value
    lines = rigid.text.splitlines()
    assert [problem.file for problem in error.problems] == ["rigid", "rigid"]
    assert [lines[(p.line or 0) - 1].split(" ")[0] for p in error.problems] == ["type", "depht"]
    assert "depht" in error.problems[1].message and "depth" in (error.problems[1].remedy or "")
    assert "\x1b" not in str(error) and f"rigid:{error.problems[1].line}:1" in str(error)
    assert isinstance(error, (fem.Error, ValueError))
    again = pickle.loads(pickle.dumps(error))
    assert str(again) == str(error) and again.problems == error.problems


def test_what_is_unknown_or_cannot_be_computed_is_told_apart(rigid: fem.Model) -> None:
    with pytest.raises(fem.ModelError, match="unknown"):
        rigid.add("tool-wear").run()
    with pytest.raises(fem.ModelError, match="no process"):
        fem.new("turnng")
    with pytest.raises(fem.ModelError, match="no effect"):
        rigid.add("tool-waer")
    with pytest.raises(fem.ComputationError) as caught:
        rigid.with_({"effects.headstock-compliance.stiffness": "1e-9 N/um"}).run()
    assert caught.value.problems[0].remedy


def test_the_catalogue_is_at_hand() -> None:
    turning = fem.effects("turning")
    assert "tool-wear" in turning.names
    wear = turning["tool-wear"]
    assert [p.unit for p in wear.parameters if p.name == "rate"] == ["um/km"]
    assert "rate*l" in wear.law and "rate*l" in repr(fem.effects("tool-wear"))
    assert len(fem.effects()) > len(turning)
    assert {"effect", "name", "unit"} <= set(turning.to_pandas().columns)
    with pytest.raises(KeyError, match="tool-wear"):
        turning["tool-waer"]
    with pytest.raises(fem.ModelError, match="tool-wear"):
        fem.effects("tool-waer")
