"""Studies from Python: the rows of the command, on threads and on Dask, whatever becomes of a worker."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import fem

INPUTS = {"cut.depth": {"distribution": "uniform", "half_field": "0.1 mm"}}
RESULTS = [{"figure": "largest.value", "tolerance": {"lower": "0 um", "upper": "60 um"}}, "smallest.value"]


def test_rows_are_those_of_the_command(root: Path, tmp_path: Path) -> None:
    plan, own, told = root / "models" / "study-lathe.toml", tmp_path / "own", tmp_path / "told"
    seen: list[tuple[int, int]] = []
    found = fem.study(plan, output=own, progress=lambda done, of: seen.append((done, of)))
    subprocess.run([sys.executable, "-m", "fem", "study", str(plan), "-o", str(told)], check=True, capture_output=True)
    assert (own / "rows.csv").read_bytes() == (told / "rows.csv").read_bytes()
    assert (own / "study.json").read_bytes() == (told / "study.json").read_bytes()
    assert sorted(path.name for path in own.iterdir()) == sorted(path.name for path in told.iterdir())
    assert found.path == own / "rows.csv" and found.table.rows == found.jobs
    assert all(done <= of == found.jobs for done, of in seen)
    first = found.summary[0]
    low, high = first["yield"]["interval95"]
    assert low <= first["yield"]["share"] <= high
    assert {one["input"] for one in first["indices"]} == {one["name"] for one in found.document.to_dict()["inputs"]}


def test_a_model_is_studied_without_a_file(rigid: fem.Model, tmp_path: Path) -> None:
    def asked(**more: Any) -> fem.Study:
        return rigid.study(INPUTS, RESULTS, design="random", samples=40, seed=3, **more)

    free, kept = asked(), asked(output=tmp_path / "rows")
    frame = kept.to_pandas()
    assert list(frame["job"]) == list(range(1, 41)) and free.path is None
    assert frame.equals(free.to_pandas())
    # A job is a run of the model at its point.
    one = rigid.with_({"cut.depth": f"{float(frame['cut.depth [mm]'][0])!r} mm"}).run()
    assert frame["largest.value [um]"][0] == one.findings.largest.value
    # What is done is not done again.
    before = os.stat(tmp_path / "rows" / "rows.csv").st_mtime_ns
    asked(output=tmp_path / "rows")
    assert os.stat(tmp_path / "rows" / "rows.csv").st_mtime_ns == before
    assert "yield" in kept._repr_html_()
    import pyarrow.parquet as pq

    table = pq.read_table(kept.to_parquet(tmp_path / "rows.parquet"))
    assert table.column("largest.value [um]").to_pylist() == list(kept.table["largest.value"])
    assert str(table.schema.field("error").type) == "string"
    assert kept.to_polars()["cut.depth [mm]"].to_list() == list(kept.table["cut.depth"])


def test_what_is_wrong_is_told_with_place_and_remedy(rigid: fem.Model, tmp_path: Path) -> None:
    with pytest.raises(fem.ModelError) as told:
        rigid.study({"cut.depht": {"half_field": "0.1 mm"}}, design="random", samples=2)
    assert told.value.problems[0].line and told.value.problems[0].remedy
    rigid.study(INPUTS, RESULTS, design="random", samples=2, output=tmp_path / "rows")
    with pytest.raises(fem.ModelError, match="another plan"):
        rigid.study(INPUTS, RESULTS, design="random", samples=3, output=tmp_path / "rows")


def test_what_a_watcher_raises_stops_a_study_that_can_go_on(rigid: fem.Model, tmp_path: Path) -> None:
    def enough(done: int, of: int) -> None:
        raise TimeoutError

    asked: Any = {"design": "random", "samples": 100_000, "output": tmp_path / "rows"}
    with pytest.raises(TimeoutError):
        rigid.study(INPUTS, RESULTS, progress=enough, **asked)
    # What was being computed is done, and its rows are there.
    for _ in range(100):
        try:
            rest = rigid.study(INPUTS, RESULTS, time_limit=0.0, **asked)
            break
        except fem.ModelError:
            time.sleep(0.1)
    assert 0 < rest.rows < 100_000 and rest.notes
    assert np.array_equal(rest.table["job"], np.arange(1, rest.rows + 1))


def test_nothing_is_lost_or_done_twice_when_a_worker_of_dask_is_killed(rigid: fem.Model, tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed", reason="dask is not installed")
    asked: Any = {"design": "random", "samples": 6000, "seed": 5}
    alone = rigid.study(INPUTS, RESULTS, output=tmp_path / "alone", **asked)
    with (
        distributed.LocalCluster(
            n_workers=3, threads_per_worker=1, processes=True, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        workers = client.run(os.getpid)
        killed: list[int] = []

        def kill(done: int, of: int) -> None:
            if not killed and done < of:
                killed.append(next(iter(workers.values())))
                os.kill(killed[0], 9)

        shared = rigid.study(
            INPUTS, RESULTS, output=tmp_path / "shared", client=client, chunk=200, progress=kill, **asked
        )
        assert killed
    assert (tmp_path / "shared" / "rows.csv").read_bytes() == (tmp_path / "alone" / "rows.csv").read_bytes()
    assert shared.document.to_dict()["rows"] == alone.document.to_dict()["rows"] == 6000
