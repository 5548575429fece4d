"""Measurements come from wherever they are, and lose nothing on the way."""

from __future__ import annotations

import csv
import io
import math
import struct
import sys
from pathlib import Path
from typing import Any, Callable

import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
import xarray as xr

import fem
from fem import _data


class OnlyArrow:
    """Hands over a stream of Arrow, and knows nothing else."""

    def __init__(self, table: pa.Table) -> None:
        self._table = table

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        return self._table.__arrow_c_stream__(requested_schema)


class OnlyInterchange:
    """Speaks the data frame interchange protocol, and nothing else."""

    def __init__(self, table: pa.Table) -> None:
        self._table = table

    def __dataframe__(self, nan_as_null: bool = False, allow_copy: bool = True) -> object:
        return self._table.__dataframe__(nan_as_null, allow_copy)


KINDS: dict[str, Callable[[pd.DataFrame], Any]] = {
    "pandas": lambda frame: frame,
    "pandas with an index": lambda frame: frame.set_index(["part", "x [mm]"]),
    "pandas of Arrow": lambda frame: frame.convert_dtypes(dtype_backend="pyarrow"),
    "polars": pl.from_pandas,
    "polars, lazy": lambda frame: pl.from_pandas(frame).lazy(),
    "Arrow": pa.Table.from_pandas,
    "a stream of Arrow": lambda frame: OnlyArrow(pa.Table.from_pandas(frame)),
    "an interchanged frame": lambda frame: OnlyInterchange(pa.Table.from_pandas(frame)),
    "NumPy": lambda frame: frame.to_records(index=False),
    "a mapping of arrays": lambda frame: {name: frame[name].to_numpy() for name in frame},
    "a mapping of lists": lambda frame: frame.to_dict("list"),
    "two frames": lambda frame: [frame[:50], frame[50:]],
}


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_says_the_same(kind: str, rigid: fem.Model, measured: dict[str, Any], root: Path) -> None:
    of_file = rigid.compare(root / "models/story/measured.csv")
    compared = rigid.compare(KINDS[kind](pd.DataFrame(measured)))
    assert np.array_equal(compared.rows["residual"], of_file.rows["residual"])
    assert compared.rms == of_file.rms


def test_results_are_measurements_again(rigid: fem.Model, measured: dict[str, Any]) -> None:
    compared = rigid.compare(measured)
    for again in (compared.rows, compared.to_xarray(), compared.to_pandas()):
        assert rigid.compare(again).rms == pytest.approx(compared.rms, rel=1e-12)
    # A prediction agrees with its own model.
    run = rigid.run()
    for profile in (run.profile, run.to_pandas()):
        assert rigid.compare(profile).rms == pytest.approx(0.0, abs=1e-9)


def test_no_digit_is_lost() -> None:
    bits = np.random.default_rng(1).integers(0, 2**64, 5000, dtype=np.uint64)
    numbers = [x for x in bits.view(np.float64).tolist() if math.isfinite(x)]
    numbers += [0.1, -0.0, 5e-324, sys.float_info.max]
    assert len(numbers) > 4000
    text = _data.csv_of({"x [mm]": np.array(numbers), "n": [1] * len(numbers)})
    read = [float(row["x [mm]"]) for row in csv.DictReader(io.StringIO(text))]
    assert [struct.pack("d", x) for x in read] == [struct.pack("d", x) for x in numbers]


def test_cells_are_written_as_a_file_has_them() -> None:
    moment = pd.Timestamp("2024-05-06 07:08:09")
    cells = [1, np.float32(0.5), True, None, float("nan"), pd.NA, pd.NaT, "a,b", moment, np.datetime64("2024-05-06")]
    rows = list(csv.reader(io.StringIO(_data.csv_of({"c": cells, "d": ["-"] * len(cells)}))))
    told = ["1", "0.5", "True", "", "", "", "", "a,b", "2024-05-06 07:08:09", "2024-05-06"]
    assert [row[0] for row in rows[1:]] == told


def test_other_headings_are_said(rigid: fem.Model, measured: dict[str, Any]) -> None:
    frame = pd.DataFrame(measured)
    other = frame.rename(columns={"x [mm]": "Pos", "diameter_error [um]": "dD"}).assign(remark="none")
    with pytest.raises(fem.DataError):
        rigid.compare(other)
    compared = rigid.compare(other, columns={"Pos": "x [mm]", "dD": "diameter_error [um]", "remark": None})
    assert compared.rms == rigid.compare(frame).rms
    with pytest.raises(ValueError, match="expected ','"):
        rigid.compare(frame, decimal=";")


def test_a_file_says_how_it_is_to_be_read(rigid: fem.Model, measured: dict[str, Any], tmp_path: Path) -> None:
    frame = pd.DataFrame(measured)
    rows = frame.to_csv(index=False)
    path = tmp_path / "printed.csv"
    # A number stands above the table, and headings that nobody knows.
    head, table = rows.split("\n", 1)
    path.write_text(f"Report;17\n\n{head.replace('x [mm]', 'Pos')}\n{table}")
    said = fem.File(path, header=3, columns={"Pos": "x [mm]"}, as_typed=True)
    assert rigid.compare(said).rms == pytest.approx(rigid.compare(frame).rms, rel=1e-12)
    assert rigid.compare([said]).rms == rigid.compare(said).rms
    with pytest.raises(ValueError, match="say the same of all"):
        rigid.compare([said, fem.File(path)])
    with pytest.raises(ValueError, match="header is -1"):
        rigid.compare(fem.File(path, header=-1))
    with pytest.raises(fem.DataError):
        rigid.compare(fem.File(path, header=2))


def test_a_wrong_row_is_told_with_its_line(rigid: fem.Model) -> None:
    frame = pd.DataFrame({"x [mm]": ["1", "two", "3"], "diameter_error [um]": [1.0, 2.0, 3.0]})
    with pytest.raises(fem.DataError) as caught:
        rigid.compare(frame)
    # The head of the table is line 1.
    assert [(p.file, p.line) for p in caught.value.problems] == [("DataFrame", 3)]
    assert "two" in str(caught.value) and caught.value.problems[0].remedy
    frame["x [mm]"] = [1.0, 2.0, 700.0]
    with pytest.raises(fem.DataError, match="line 4: x = 700 mm is not on the shaft"):
        rigid.compare(frame)
    with pytest.raises(fem.DataError, match="cannot be read"):
        rigid.compare("nowhere.csv")


def test_what_is_no_table_is_refused(rigid: fem.Model) -> None:
    with pytest.raises(TypeError, match="expected a path"):
        rigid.compare(17)
    with pytest.raises(ValueError, match="different lengths: x has 1, y has 2"):
        rigid.compare({"x": [1], "y": [1, 2]})
    with pytest.raises(ValueError, match="no measurements"):
        rigid.compare([])


def test_datasets_say_their_units(rigid: fem.Model, measured: dict[str, Any]) -> None:
    dataset = rigid.compare(measured).to_xarray()
    assert isinstance(dataset, xr.Dataset)
    assert dataset["residual"].dims == ("part", "x") and dataset["x"].attrs["units"] == "mm"
    row = dataset.sel(part=3, x=250.0)
    of_row = (measured["part"] == 3) & (measured["x [mm]"] == 250.0)
    assert float(row["diameter_error"]) == measured["diameter_error [um]"][of_row][0]
    assert float(row["radial_force"]) == measured["radial_force [N]"][of_row][0]
