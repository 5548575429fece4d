"""Studies: many jobs with one model, and what their rows say."""

from __future__ import annotations

import csv
import json
import os
import tempfile
from collections import deque
from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Optional, Union

from fem import _fem
from fem._answer import bare
from fem._results import Result
from fem._table import Table

if TYPE_CHECKING:
    import pandas as pd
    import polars as pl
    import pyarrow as pa  # type: ignore[import-untyped,unused-ignore]
    import xarray as xr

_Path = Union[str, "os.PathLike[str]"]
Watch = Callable[[int, int], object]

# Chunks that wait on a scheduler for each thread of its workers: enough that none is idle.
_AHEAD = 4


class Study(Result):
    """The rows of a study, and what they say: yield, worst case, Sobol' indices."""

    def __init__(self, document: str, text: str, rows: Path, left: int, is_kept: bool) -> None:
        notes = [f"the time was over; {left} jobs are left. The same call goes on with them"] if left else []
        super().__init__(bare(document, text, notes))
        self.table: Table = _table(rows, self.document.to_dict())
        """All rows: `job`, the inputs, `data`, the results, `error`."""
        self.path: Optional[Path] = rows if is_kept else None
        """The file of the rows, if a folder was named."""

    @property
    def summary(self) -> list[dict[str, Any]]:
        """What is said of each result: `yield` with its interval, `worst`, `indices`."""
        return list(self.document.to_dict()["results"])

    def to_pandas(self) -> pd.DataFrame:
        """The rows."""
        return self.table.to_pandas()

    def to_polars(self) -> pl.DataFrame:
        """The rows."""
        import polars as pl

        return pl.DataFrame(dict(zip(self.table.headings, self.table.values())))

    def to_arrow(self) -> pa.Table:
        """The rows; a result that a job does not have is null."""
        import numpy as np
        import pyarrow as pa  # type: ignore[import-untyped,unused-ignore]

        def column(values: Any) -> Any:
            return pa.array(values, mask=np.isnan(values)) if values.dtype.kind == "f" else pa.array(values)

        return pa.table({name: column(self.table[own]) for name, own in zip(self.table.headings, self.table)})

    def to_parquet(self, path: _Path) -> Path:
        """Writes the rows as Parquet; the file appears whole."""
        import pyarrow.parquet as pq  # type: ignore[import-untyped,unused-ignore]

        place = Path(path)
        handle, beside = tempfile.mkstemp(dir=place.parent, prefix=".fem-")
        os.close(handle)
        try:
            pq.write_table(self.to_arrow(), beside)
            os.replace(beside, place)
        except BaseException:
            os.unlink(beside)
            raise
        return place

    def to_xarray(self) -> xr.Dataset:
        """The rows."""
        return self.table.to_xarray()


def study(
    plan: _Path,
    *,
    output: Optional[_Path] = None,
    restart: bool = False,
    time_limit: Optional[float] = None,
    progress: Optional[Watch] = None,
    client: Any = None,
    chunk: int = 256,
) -> Study:
    """Does the jobs of a plan, or those that are left of it in the folder `output`.

    `progress` is told how many jobs are done, and of how many. With a client of Dask its workers do the jobs, so many a
    task (`chunk`); they must see the same files.
    """
    return _done(os.fspath(plan), None, output, restart, time_limit, progress, client, chunk)


def of_model(
    save: Callable[[Path], object],
    keys: Mapping[str, Any],
    output: Optional[_Path],
    restart: bool,
    time_limit: Optional[float],
    progress: Optional[Watch],
    client: Any,
    chunk: int,
) -> Study:
    """A plan of these keys, with a model that `save` writes."""
    # Beside the rows, where workers on other machines see it as well.
    beside = None if output is None else Path(output).absolute().parent
    if beside is not None:
        beside.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=beside, prefix=".fem-") as folder:
        save(Path(folder, "model.toml"))
        text = _fem.written(json.dumps({"model": "model.toml", **keys}, default=_plain, allow_nan=False))
        return _done(os.path.join(folder, "study.toml"), text, output, restart, time_limit, progress, client, chunk)


def _done(
    name: str,
    text: Optional[str],
    output: Optional[_Path],
    restart: bool,
    time_limit: Optional[float],
    progress: Optional[Watch],
    client: Any,
    chunk: int,
) -> Study:
    if chunk < 1:
        raise ValueError(f"chunk is {chunk}; expected at least 1")
    if client is not None and time_limit is not None:
        raise ValueError("time_limit is not for a client; leave it out, interrupt, and call again with the same output")
    with ExitStack() as stack:
        folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="fem-")) if output is None else output
        core = _fem.Study.open(name, text, os.fspath(folder), restart)
        if client is None:
            core.compute(time_limit, progress)
        else:
            _shared(core, os.path.abspath(name), text, client, chunk, progress)
        done, jobs = core.done()
        document, page, rows = core.finish(None if output is None else os.fspath(output))
        return Study(document, page, Path(rows), jobs - done, output is not None)


def _shared(core: _fem.Study, name: str, text: Optional[str], client: Any, chunk: int, progress: Optional[Watch]) -> None:
    """Lets workers do the jobs that are left. Rows are appended in order, each once, whatever becomes of a worker."""
    facts = core.facts()
    next_, jobs = core.done()
    waiting: deque[Any] = deque()
    try:
        while waiting or next_ < jobs:
            most = _AHEAD * max(sum(client.nthreads().values()), 1)
            while next_ < jobs and len(waiting) < most:
                last = min(next_ + chunk, jobs)
                waiting.append(client.submit(_fem.study_jobs, name, text, facts, next_, last, pure=False))
                next_ = last
            core.append(waiting[0].result())
            waiting.popleft()
            if progress is not None:
                progress(*core.done())
    finally:
        if waiting:
            client.cancel(list(waiting))


def _table(path: Path, document: Mapping[str, Any]) -> Table:
    import numpy as np

    with open(path, encoding="utf-8", newline="") as file:
        header, *rows = csv.reader(file)
    cells = list(zip(*rows)) if rows else [()] * len(header)
    given: Sequence[Mapping[str, Any]] = [*document["inputs"], *document["results"]]
    units = {f"{one['name']} [{one['unit']}]": one["unit"] for one in given if one.get("unit")}
    words = {"data", "error", *(one["name"] for one in document["results"] if "words" in one)}
    columns = []
    for heading, own in zip(header, cells):
        unit = units.get(heading)
        name = heading[: -len(unit) - 3] if unit else heading
        if name in words:
            known = sorted(set(own))
            place = {word: i for i, word in enumerate(known)}
            columns.append((name, unit, np.array([place[word] for word in own], dtype=np.float64), known))
        else:
            columns.append((name, unit, np.array([float(cell or "nan") for cell in own], dtype=np.float64), []))
    return Table(columns, ["job"])


def _plain(value: Any) -> Any:
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"{value!r} is no value of a plan; expected a text with a unit, a number, a list or a mapping")
