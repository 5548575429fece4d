"""Answers: the numbers of the commands, as objects."""

from __future__ import annotations

import json
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from matplotlib.axes import Axes

import fem


def test_a_run_is_what_the_command_says(root: Path, command: Any) -> None:
    path = str(root / "models/lathe.toml")
    run = fem.load(path).run()
    assert run.to_dict() == json.loads(command("run", path, "--json", "--plot", "figures").stdout)
    assert command("run", path, "--plot", "more").stdout.startswith(run.text)
    assert {f"{name}.svg" for name in run.figures} == {p.name for p in (command.folder / "figures").glob("*.svg")}


def test_the_profile_is_the_file_of_the_command(root: Path, command: Any) -> None:
    path = str(root / "models/lathe.toml")
    command("run", path, "-o", "out")
    file = pd.read_csv(command.folder / "out/profile.csv", comment="#")
    run = fem.load(path).run()
    pd.testing.assert_frame_equal(run.to_pandas(), file, check_dtype=False, rtol=1e-9)


def test_changes_add_up_where_effects_do(rigid: fem.Model) -> None:
    run = rigid.add("setting-error", offset="5 um").add("guideway-taper", slope="40 um/m").run()
    changes = run.changes
    whole = changes["ideal"] + changes["setting-error"] + changes["guideway-taper"]
    assert whole == pytest.approx(run.profile["diameter_error"], abs=1e-9)
    assert changes.units["setting-error"] == "um"
    by_effect = {share.effect: share.rms for share in run.shares}
    assert by_effect["guideway-taper"] == pytest.approx(np.sqrt(np.mean(changes["guideway-taper"] ** 2)))


def test_columns_are_arrays_of_their_own(rigid: fem.Model) -> None:
    column = rigid.run().profile["x"]
    assert column.dtype == np.float64 and column.flags.c_contiguous
    # The memory of the column itself, not a list that was walked.
    assert not column.flags.owndata and column.base is not None


def test_residuals_are_measured_less_predicted(rigid: fem.Model, measured: dict[str, Any]) -> None:
    compared = rigid.compare(measured)
    rows = compared.rows
    assert rows["diameter_error"] - rows["predicted"] == pytest.approx(rows["residual"], abs=1e-9)
    assert compared.rms == pytest.approx(np.sqrt(np.mean(rows["residual"] ** 2)))
    assert compared.models[0].rms == compared.rms and not compared.adequate
    assert np.array_equal(rows["u"], measured["u [um]"])


def test_the_error_falls_step_by_step(rigid: fem.Model, measured: dict[str, Any], found: fem.Diagnosis) -> None:
    assert found.verdict == "missing-effect"
    names = [missing.effect for missing in found.missing]
    assert names == ["tool-wear", "headstock-compliance", "guideway-wear"]
    assert [step.effects for step in found.steps] == [names[:1], names[:2], names]
    compared = fem.compare([rigid, *found.steps], measured)
    errors = [model.rms for model in compared.models]
    assert errors == sorted(errors, reverse=True) and errors[0] > 40 and errors[-1] < 1
    assert [model.adequate for model in compared.models] == [False, False, False, True]
    assert [model.model for model in compared.models][1] == "rigid-tool-wear"
    frame = compared.to_pandas()
    assert frame.groupby("model")["residual [um]"].apply(lambda r: (r**2).mean() ** 0.5).min() == pytest.approx(min(errors))
    assert found.model is not None and found.model.compare(measured).adequate
    # Commands name files, of which there are none.
    assert "fem diagnose" not in found.text and found.text.rstrip().endswith(".details all of it")
    assert "fem add" not in found.details and found.details.rstrip().endswith("every value re-fitted")
    assert found.text.count("\n") < 30 < found.details.count("\n")


def test_a_diagnosis_is_what_the_command_says(root: Path, command: Any, found: fem.Diagnosis) -> None:
    model, data = (str(root / "models/story" / name) for name in ("rigid.toml", "measured.csv"))
    told = json.loads(command("diagnose", model, "--with", data, "--json").stdout)
    own = found.to_dict()
    for key in ("missing", "candidates", "parameters", "verdict", "after"):
        assert own[key] == told[key], key


def test_a_fit_gives_a_model(rigid: fem.Model, measured: dict[str, Any]) -> None:
    fit = rigid.add("tool-wear").fit(measured)
    (rate,) = fit.parameters
    frame = fit.to_pandas()
    assert frame["parameter"].tolist() == ["effects.tool-wear.rate"] and frame["value"][0] == rate.value
    assert frame["low95"][0] < rate.value < frame["high95"][0]
    (fitted,) = fit.model.parameters
    assert fitted.value == pytest.approx(rate.value, rel=1e-2) and fitted.std is not None
    assert np.sqrt(np.mean(fit.rows["residual"] ** 2)) == pytest.approx(fit.rms)
    assert "value" in fit.to_xarray()
    with pytest.raises(fem.ModelError, match="nothing to fit"):
        rigid.fit(measured)


# Three parts, to be turned with one force.
DESIGN = {"part": [1, 1, 1, 6, 6, 6, 12, 12, 12], "x [mm]": [50.0, 250.0, 450.0] * 3}


def test_a_plan_needs_no_measurements(rigid: fem.Model) -> None:
    plan = rigid.plan(DESIGN, noise="1 um")
    assert plan.observations == 9 and not plan.notes
    visible = plan.to_pandas().set_index("effect")["visible"]
    assert visible["tool-wear"] and set(plan.to_xarray()["effect"].values) == set(visible.index)
    assert "assumed" in repr(rigid.plan(DESIGN)).splitlines()[-1]
    with pytest.raises(fem.ModelError, match="no positive"):
        rigid.plan(DESIGN, noise="0 um")


def test_an_axis_is_compensated(root: Path) -> None:
    model = fem.load(root / "models/axis.toml")
    answer = model.compensate(model.run().to_pandas())
    assert answer.schema == "fem-compensation/1" and len(answer.to_pandas()) == len(answer.iso230.targets)
    with pytest.raises(fem.ModelError, match="compensation is for axes"):
        fem.demo().model.compensate(fem.demo().measured)


def test_a_report_is_a_page(tmp_path: Path, rigid: fem.Model, measured: dict[str, Any]) -> None:
    page = rigid.report(measured, tmp_path / "report.html")
    assert (tmp_path / "report.html").read_text() == page.html
    assert "guideway-wear" in page.html and "<script src" not in page.html
    assert page._repr_html_().startswith("<iframe srcdoc=")
    assert "guideway-wear" not in rigid.report().html


def test_answers_show_themselves(rigid: fem.Model, measured: dict[str, Any], found: fem.Diagnosis) -> None:
    for answer in (rigid.run(), rigid.compare(measured), found):
        assert repr(answer) == answer.text.rstrip()
        page = answer._repr_html_()
        assert "data:image/svg+xml;base64," in page and "<pre>" in page
    assert rigid.compare(measured).rows._repr_html_().count("<tr>") == 12
    assert "[108 rows]" in repr(rigid.compare(measured).rows)
    assert "depth" in rigid._repr_html_()


def test_answers_draw_themselves(root: Path, rigid: fem.Model, measured: dict[str, Any], found: fem.Diagnosis) -> None:
    axes = rigid.run().plot()
    assert axes.get_xlabel() == "x [mm]" and len(axes.lines) == 12
    assert axes.lines[0].get_ydata() == pytest.approx(rigid.run().to_xarray()["diameter_error"].values[0])
    points = rigid.compare(measured).plot()
    assert points.get_ylabel() == "residual [um]"
    assert sum(len(line.get_xdata()) for line in points.lines[:-1]) == 108
    fit = rigid.add("tool-wear").fit(measured)
    assert fit.plot(points) is points
    assert [bar.get_height() for bar in found.plot().patches] == [found.before.rms] + [m.rms_after for m in found.missing]
    axis = fem.load(root / "models/axis.toml")
    assert isinstance(axis.compensate(axis.run().profile).plot(), Axes)
    assert len(rigid.plan(DESIGN, noise="1 um").plot().patches) > 10


def test_answers_pickle(rigid: fem.Model, measured: dict[str, Any], found: fem.Diagnosis) -> None:
    for answer in (rigid.run(), rigid.compare(measured), found):
        again = pickle.loads(pickle.dumps(answer))
        assert again.text == answer.text and again.to_dict() == answer.to_dict()
    assert pickle.loads(pickle.dumps(found)).steps == found.steps


def test_a_missing_key_is_told(rigid: fem.Model) -> None:
    run = rigid.run()
    with pytest.raises(AttributeError, match="there is schema"):
        run.finding
    with pytest.raises(KeyError, match="there is part"):
        run.profile["diameter"]
    assert "findings" in dir(run) and not hasattr(run.findings, "biggest")


def test_a_time_limit_is_told(rigid: fem.Model, measured: dict[str, Any]) -> None:
    assert rigid.diagnose(measured, time_limit=0.0).left_undone
    with pytest.raises(ValueError, match="1 to 8"):
        rigid.diagnose(measured, max_effects=0)


def test_a_budget_is_that_of_the_command(root: Path, command: Any) -> None:
    path = root / "models" / "budget-lathe.toml"
    found = fem.budget(path)
    assert found.to_dict() == json.loads(command("budget", str(path), "--json").stdout)
    assert found.monte_carlo.samples == 20000
    assert "total by the handbook" in str(found)
    with pytest.raises(fem.ModelError):
        fem.budget(root / "models" / "lathe.toml")
