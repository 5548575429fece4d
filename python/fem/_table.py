"""Columns of equal length with units."""

from __future__ import annotations

import html
import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Optional

if TYPE_CHECKING:
    import numpy as np
    import pandas as pd
    import xarray as xr

    from fem._answer import Column

    Array = np.ndarray[Any, np.dtype[Any]]

# Rows that are shown of a long table, at its beginning and at its end.
_SHOWN = 5


class Table(Mapping[str, "Array"]):
    """Columns by their names, as NumPy arrays."""

    def __init__(self, columns: Sequence[Column], coordinates: Sequence[str] = ()) -> None:
        self._columns: dict[str, Array] = {}
        self.units: dict[str, Optional[str]] = {}
        """Unit of each column; None where it has none."""
        for name, unit, values, words in columns:
            own = name if name not in self._columns else heading(name, unit)
            self._columns[own] = _meant(values, words, unit is None and name in coordinates)
            self.units[own] = unit
        self.coordinates: list[str] = [name for name in self._columns if name in coordinates]
        """Columns that say where, when and under which conditions."""

    def __getitem__(self, name: str) -> Array:
        try:
            return self._columns[name]
        except KeyError:
            raise KeyError(f"no column {name!r}; there is {', '.join(self._columns)}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    @property
    def rows(self) -> int:
        """Number of rows."""
        return max((len(values) for values in self._columns.values()), default=0)

    @property
    def values_of(self) -> list[str]:
        """Columns that are no coordinates."""
        return [name for name in self._columns if name not in self.coordinates]

    @property
    def headings(self) -> list[str]:
        """Names with units, as a measurement file has them: `x [mm]`."""
        return [heading(name, self.units[name]) for name in self._columns]

    def varying(self) -> list[str]:
        """Coordinates that take more than one value."""
        import numpy as np

        return [name for name in self.coordinates if len(np.unique(self._columns[name])) > 1]

    def to_pandas(self) -> pd.DataFrame:
        """A data frame, its columns headed `name [unit]`; it can be compared with a model as it is."""
        import pandas as pd

        return pd.DataFrame(dict(zip(self.headings, self._columns.values())))

    def to_xarray(self) -> xr.Dataset:
        """A dataset with units as attributes. Where coordinates make a whole grid they are its dimensions."""
        import numpy as np
        import xarray as xr

        attributes = {name: {"units": unit} for name, unit in self.units.items() if unit}
        dimensions, order, shape = self._grid()

        def laid(name: str) -> tuple[Any, ...]:
            values = self._columns[name][order].reshape(shape)
            if name in dimensions:
                return name, np.unique(values), attributes.get(name, {})
            if name in self.coordinates and len(np.unique(values)) == 1:
                return (), values.flat[0], attributes.get(name, {})
            return dimensions, values, attributes.get(name, {})

        return xr.Dataset(
            {name: laid(name) for name in self.values_of}, {name: laid(name) for name in self.coordinates}
        )

    def _grid(self) -> tuple[list[str], Array, tuple[int, ...]]:
        """As many coordinates as make a whole grid, the rows in its order, and its shape; else the rows as they are."""
        import numpy as np

        varying = self.varying()
        levels = {name: np.unique(self._columns[name], return_inverse=True) for name in varying}
        for count in range(min(len(varying), 4), 0, -1):
            for names in itertools.combinations(varying, count):
                shape = tuple(len(levels[name][0]) for name in names)
                if math.prod(shape) != self.rows:
                    continue
                places = np.ravel_multi_index(tuple(levels[name][1] for name in names), shape)
                if len(np.unique(places)) == self.rows:
                    return list(names), np.argsort(places), shape
        return ["row"], np.arange(self.rows), (self.rows,)

    def __repr__(self) -> str:
        lines = [self.headings, *self._shown()]
        widths = [max(len(line[i]) for line in lines) for i in range(len(self._columns))]
        text = "\n".join("  ".join(cell.rjust(width) for cell, width in zip(line, widths)) for line in lines)
        return f"{text}\n[{self.rows} rows]"

    def _repr_html_(self) -> str:
        head = "".join(f"<th>{html.escape(name)}</th>" for name in self.headings)
        rows = "".join(
            "<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in line) + "</tr>" for line in self._shown()
        )
        return f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table><p>{self.rows} rows</p>"

    def _shown(self) -> list[list[str]]:
        whole = self.rows <= 2 * _SHOWN
        rows = range(self.rows) if whole else [*range(_SHOWN), -1, *range(self.rows - _SHOWN, self.rows)]
        return [["…" if row < 0 else _cell(values[row]) for values in self._columns.values()] for row in rows]


def heading(name: str, unit: Optional[str]) -> str:
    """A name with its unit, as a measurement file has it."""
    return f"{name} [{unit}]" if unit else name


def _meant(values: Array, words: Sequence[str], is_label: bool) -> Array:
    import numpy as np

    if words:
        return np.asarray(words)[values.astype(np.int64)]
    # Numbers of parts and runs.
    if is_label and np.all(values == np.rint(values)):
        return values.astype(np.int64)
    return values


def _cell(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)
