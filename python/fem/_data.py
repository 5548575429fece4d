"""Measurements from files, data frames and Arrow tables, on their way to the one reader of measurement files."""

from __future__ import annotations

import csv
import dataclasses
import datetime
import io
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Optional, Union

from fem._table import heading

if TYPE_CHECKING:
    from fem._answer import Asked

Data = Any
"""A path or a `File`; a data frame of pandas or polars; a table of Arrow, or whatever hands one over (`__arrow_c_stream__`,
`__dataframe__`); an xarray dataset; a structured array; a mapping of columns; or several of these in a list. Columns are
headed as in a measurement file, `x [mm]`."""

Columns = Union[Mapping[str, Optional[str]], Sequence[str]]
"""Which columns are meant: `{"X-Pos": "x [mm]", "T1": "temperature@x=12 mm", "comment": None}`."""


@dataclasses.dataclass(frozen=True)
class File:
    """A file of measurements, and how it is to be read: what its columns mean, its decimal mark, the line of its headings
    (from 1; 0 where there are none), the sheet of a workbook, and whether readings that look mistyped are taken as they are.

    What is not said the model's ``[data]`` says, or the file itself.
    """

    path: Union[str, os.PathLike[str]]
    columns: Columns = ()
    decimal: Optional[str] = None
    header: Optional[int] = None
    sheet: Optional[str] = None
    as_typed: bool = False

    def _said(self) -> tuple[Any, ...]:
        return self.columns, self.decimal, self.header, self.sheet, self.as_typed


def asked(data: Data, columns: Columns = (), decimal: Optional[str] = None) -> Asked:
    """The measurements as the extension reads them."""
    header: Optional[int] = None
    sheet: Optional[str] = None
    as_typed = False
    files = [one for one in (data if isinstance(data, (list, tuple)) else [data]) if isinstance(one, File)]
    if files:
        if any(one._said() != files[0]._said() for one in files):
            raise ValueError("several files are read in one way; say the same of all of them")
        header, sheet, as_typed = files[0].header, files[0].sheet, files[0].as_typed
        columns, decimal = columns or files[0].columns, decimal or files[0].decimal
    if header is not None and header < 0:
        raise ValueError(f"header is {header}; expected a line from 1, or 0 where there is none")
    if decimal not in (None, ",", "."):
        raise ValueError(f"decimal is {decimal!r}; expected ',' or '.'")
    if isinstance(columns, Mapping):
        columns = [f"{name}={meant or '-'}" for name, meant in columns.items()]
    several = isinstance(data, (list, tuple)) and not isinstance(data, str)
    parts = [_part(one) for one in data] if several else [_part(data)]
    if not parts:
        raise ValueError("there are no measurements; name a file or give a data frame")
    known: dict[str, int] = {}
    for i, (name, text) in enumerate(parts):
        known[name] = known.get(name, 0) + 1
        if text is not None and known[name] > 1:
            parts[i] = (f"{name} {known[name]}", text)
    return {
        "parts": parts,
        "columns": [columns] if isinstance(columns, str) else list(columns),
        "decimal": decimal,
        "header": header,
        "sheet": sheet,
        "as_typed": as_typed,
    }


def _part(data: Data) -> tuple[str, Optional[str]]:
    if isinstance(data, File):
        data = data.path
    if isinstance(data, (str, os.PathLike)):
        return os.fspath(data), None
    return type(data).__name__, csv_of(columns_of(data))


def columns_of(data: Data) -> dict[str, list[Any]]:
    """The columns of whatever holds some."""
    if hasattr(data, "to_dataframe"):  # xarray, whose units are attributes
        units = {name: values.attrs.get("units") for name, values in data.variables.items()}
        frame = data.to_dataframe().reset_index()
        return {heading(str(name), units.get(name)): list(frame[name]) for name in frame.columns if name in units}
    if getattr(getattr(data, "dtype", None), "names", None):  # a structured array of NumPy
        data = {name: data[name] for name in data.dtype.names}
    if hasattr(data, "headings"):  # a table of a result
        data = dict(zip(data.headings, data.values()))
    if hasattr(data, "reset_index"):  # pandas: an index that has names is columns
        data = data.reset_index() if any(name is not None for name in data.index.names) else data
        return {str(name): list(data[name]) for name in data.columns}
    if hasattr(data, "collect") and hasattr(data, "lazy"):  # a lazy frame of polars
        data = data.collect()
    if not isinstance(data, Mapping):
        data = _mapping(data)
    return {str(name): list(values) for name, values in data.items()}


def _mapping(data: Data) -> Mapping[Any, Iterable[Any]]:
    if hasattr(data, "to_pydict"):  # a table of pyarrow
        return dict(data.to_pydict())
    if hasattr(data, "__arrow_c_stream__"):
        try:
            import pyarrow  # type: ignore[import-untyped,unused-ignore]
        except ImportError:
            pass
        else:
            return dict(pyarrow.table(data).to_pydict())
    if hasattr(data, "to_dict"):  # polars, and whatever else can say it
        return dict(data.to_dict())
    if hasattr(data, "__arrow_c_stream__"):
        raise ImportError("a table of Arrow is read by pyarrow: pip install pyarrow")
    if hasattr(data, "__dataframe__"):
        try:
            from pyarrow.interchange import from_dataframe  # type: ignore[import-untyped,unused-ignore]
        except ImportError as error:
            raise ImportError("such a data frame is read by pyarrow: pip install pyarrow") from error
        return dict(from_dataframe(data).to_pydict())
    raise TypeError(
        f"measurements are a {type(data).__name__}; expected a path, a data frame, an Arrow table or a mapping of columns"
    )


def csv_of(columns: Mapping[str, Sequence[Any]]) -> str:
    """The columns as a measurement file, every number with all of its digits."""
    lengths = {name: len(values) for name, values in columns.items()}
    if len(set(lengths.values())) > 1:
        told = ", ".join(f"{name} has {length}" for name, length in lengths.items())
        raise ValueError(f"columns are of different lengths: {told}")
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(zip(*([_cell(value) for value in values] for values in columns.values())))
    return text.getvalue()


def _cell(value: Any) -> str:
    if type(value).__name__ == "datetime64":
        return str(value).replace("T", " ").replace("NaT", "")
    if hasattr(value, "item"):  # a number of NumPy
        value = value.item()
    if hasattr(value, "as_py"):  # one of pyarrow
        value = value.as_py()
    # pandas.NA is not even equal or unequal to itself.
    if value is None or str(value) in ("<NA>", "NaT", "nan"):
        return ""
    if isinstance(value, (datetime.datetime, datetime.date)):
        return value.isoformat(sep=" ") if isinstance(value, datetime.datetime) else value.isoformat()
    return repr(value) if isinstance(value, float) else str(value)
