"""What models answer."""

from __future__ import annotations

import base64
import html
import json
import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional, Union, overload

from fem._answer import bare
from fem._record import Record, read
from fem._table import Table

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr
    from matplotlib.axes import Axes

    from fem._answer import Answer


class Result:
    """An answer: reads as the command would print it, and has the keys of its JSON document as attributes."""

    def __init__(self, answer: Answer) -> None:
        self.document: Record = read(answer["json"])
        """The JSON document of the command."""
        self.text: str = answer["text"]
        """What the command prints."""
        self.figures: dict[str, str] = dict(answer["figures"])
        """Figures as SVG, by their names."""
        self.notes: list[str] = answer["notes"]
        """Notes and warnings for people."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name == "document":
            raise AttributeError(name)
        try:
            return self.document[name]
        except KeyError:
            raise AttributeError(f"{type(self).__name__} has no {name!r}; there is {', '.join(self.document)}") from None

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.document]

    def __repr__(self) -> str:
        return "\n".join([self.text.rstrip(), *(f"note: {note}" for note in self.notes)])

    def _repr_html_(self) -> str:
        pictures = "".join(_picture(svg) for svg in list(self.figures.values())[:1])
        notes = "".join(f"<p><em>{html.escape(note)}</em></p>" for note in self.notes)
        return f"{pictures}<pre>{html.escape(self.text.rstrip())}</pre>{notes}"

    def to_dict(self) -> dict[str, Any]:
        """The JSON document as plain dictionaries and lists."""
        return self.document.to_dict()

    def to_pandas(self) -> pd.DataFrame:
        """The main table as a data frame."""
        raise NotImplementedError

    def to_xarray(self) -> xr.Dataset:
        """The main table as a dataset."""
        raise NotImplementedError

    def plot(self, ax: Optional[Axes] = None) -> Axes:
        """Draws it with matplotlib."""
        raise NotImplementedError


class Run(Result):
    """A prediction."""

    def __init__(self, answer: Answer) -> None:
        super().__init__(answer)
        (tables,) = answer["tables"]
        self.tables: dict[str, Table] = tables_of(tables, answer["coordinates"])
        """All tables: `profile`, those of the process, and `changes of …` for each observable."""

    @property
    def profile(self) -> Table:
        """The prediction at every point of the model's own programme."""
        return self.tables["profile"]

    @property
    def changes(self) -> Table:
        """What each effect changes at every point, and `ideal`, the system without any."""
        return next(table for name, table in self.tables.items() if name.startswith("changes of "))

    def to_pandas(self) -> pd.DataFrame:
        """The profile, which is a measurement file in itself."""
        return self.profile.to_pandas()

    def to_xarray(self) -> xr.Dataset:
        """The profile."""
        return self.profile.to_xarray()

    def plot(self, ax: Optional[Axes] = None) -> Axes:
        """Draws the profile along its longest coordinate, a line for each part, run or direction."""
        from fem import _plot

        return _plot.lines(self.profile, self.profile.values_of[0], ax)


class Correction(Result):
    """What to command, and what will be left."""

    def __init__(self, answer: Answer) -> None:
        super().__init__(answer)
        (tables,) = answer["tables"]
        self.rows: Table = tables_of(tables, answer["coordinates"])["correction"]
        """The change at every place of every part, what is left there, and the interval that holds it with 95 %."""

    def to_pandas(self) -> pd.DataFrame:
        """The rows."""
        return self.rows.to_pandas()

    def to_xarray(self) -> xr.Dataset:
        """The rows."""
        return self.rows.to_xarray()

    def plot(self, ax: Optional[Axes] = None) -> Axes:
        """Draws what is left along its longest coordinate, a line for each part, run or direction."""
        from fem import _plot

        return _plot.lines(self.rows, "left", ax)


class NextPart(Result):
    """The offset of the next part, and what to expect of it."""

    def __init__(self, document: str, text: str, page: str, notes: list[str]) -> None:
        super().__init__(bare(document, text, notes))
        self.page: Report = Report(page, notes)
        """The same as a page for a browser."""


class Comparison(Result):
    """Models against measurements."""

    def __init__(self, answer: Answer) -> None:
        super().__init__(answer)
        self.tables: list[dict[str, Table]] = [tables_of(tables, answer["coordinates"]) for tables in answer["tables"]]
        """For each model the table of each observable: coordinates, what was measured, `u`, `predicted`, `residual`."""

    def __getattr__(self, name: str) -> Any:
        models = self.__dict__["document"]["models"] if "document" in self.__dict__ else []
        if len(models) == 1 and not name.startswith("_") and name in models[0]:
            return models[0][name]
        return super().__getattr__(name)

    @property
    def rows(self) -> Table:
        """The rows of the first observable with the predictions of the last model."""
        return next(iter(self.tables[-1].values()))

    def to_pandas(self) -> pd.DataFrame:
        """The rows with predictions and residuals, of several models one below the other."""
        import pandas as pd

        frames = []
        for model, tables in zip(self.document["models"], self.tables):
            for table in tables.values():
                frame = table.to_pandas()
                if len(self.tables) > 1:
                    frame.insert(0, "model", model["model"])
                frames.append(frame)
        return pd.concat(frames, ignore_index=True)

    def to_xarray(self) -> xr.Dataset:
        """The rows of the last model."""
        return self.rows.to_xarray()

    def plot(self, ax: Optional[Axes] = None) -> Axes:
        """Draws the residuals of the last model along their longest coordinate."""
        from fem import _plot

        return _plot.points(self.rows, "residual", ax)


class Listing(Result):
    """An answer whose main table lists parameters or effects."""

    def _records(self) -> list[dict[str, Any]]:
        raise NotImplementedError

    def to_pandas(self) -> pd.DataFrame:
        import pandas as pd

        return pd.DataFrame(self._records())

    def to_xarray(self) -> xr.Dataset:
        frame = self.to_pandas()
        return frame.set_index(frame.columns[0]).to_xarray()


class Plan(Listing):
    """What could be seen by measuring."""

    def _records(self) -> list[dict[str, Any]]:
        return [one.to_dict() for one in self.document["effects"]]

    def to_pandas(self) -> pd.DataFrame:
        """Every effect: whether it would be seen, and the smallest that would."""
        return super().to_pandas()

    def plot(self, ax: Optional[Axes] = None) -> Axes:
        """Draws how much of each effect's signature nothing else could imitate."""
        from fem import _plot

        return _plot.shares(self.document, ax)


class Compensation(Listing):
    """The test of an axis by ISO 230-2, and what tables for its controller would leave."""

    def _records(self) -> list[dict[str, Any]]:
        return [one.to_dict() for one in self.document["iso230"]["targets"]]

    def to_pandas(self) -> pd.DataFrame:
        """The targets: means, scatter and reversal."""
        return super().to_pandas()

    def plot(self, ax: Optional[Axes] = None) -> Axes:
        """Draws the reversal value of each target."""
        from fem import _plot

        return _plot.columns(self._records(), "position", "B", ("position, mm", "reversal value B, um"), ax)


class Budget(Result):
    """Errors of a part added up: by the rules of the handbook and by Monte Carlo, each with its share."""

    def __init__(self, document: str, text: str, notes: list[str]) -> None:
        super().__init__(bare(document, text, notes))


class Report:
    """A self-contained page for a browser."""

    def __init__(self, html: str, notes: list[str]) -> None:
        self.html: str = html
        """The page."""
        self.notes: list[str] = notes
        """Notes for people."""

    def save(self, path: Union[str, os.PathLike[str]]) -> Path:
        """Writes the page."""
        place = Path(path)
        place.write_text(self.html, encoding="utf-8")
        return place

    def __repr__(self) -> str:
        return f"<fem.Report of {len(self.html)} characters; save('report.html') writes it>"

    def _repr_html_(self) -> str:
        page = html.escape(self.html, quote=True)
        return f'<iframe srcdoc="{page}" style="width: 100%; height: 40em; border: 1px solid #ccc"></iframe>'


class Catalogue(Sequence[Record]):
    """Effects: law, parameters with units, source, look-alikes."""

    def __init__(self, document: str, text: str) -> None:
        self._effects: list[Record] = [Record(one) for one in json.loads(document)]
        self.text: str = text
        """What the command prints."""

    @overload
    def __getitem__(self, key: Union[int, str]) -> Record: ...
    @overload
    def __getitem__(self, key: slice) -> list[Record]: ...
    def __getitem__(self, key: Union[int, str, slice]) -> Union[Record, list[Record]]:
        """An effect by its place or its name."""
        if not isinstance(key, str):
            return self._effects[key]
        found = [effect for effect in self._effects if effect["effect"] == key]
        if not found:
            raise KeyError(f"no effect {key!r} here; there is {', '.join(self.names)}")
        return found[0]

    def __len__(self) -> int:
        return len(self._effects)

    def __iter__(self) -> Iterator[Record]:
        return iter(self._effects)

    @property
    def names(self) -> list[str]:
        """Names of the effects."""
        return [effect["effect"] for effect in self._effects]

    def __repr__(self) -> str:
        return self.text.rstrip()

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(self.text.rstrip())}</pre>"

    def to_pandas(self) -> pd.DataFrame:
        """A row for each parameter of each effect."""
        import pandas as pd

        return pd.DataFrame(
            [
                {"process": one["process"], "effect": one["effect"], "law": one["law"], "source": one["source"]}
                | {f"parameter {key}" if key == "about" else key: value for key, value in parameter.to_dict().items()}
                for one in self._effects
                for parameter in one["parameters"]
            ]
        )


def tables_of(tables: dict[str, Any], coordinates: Sequence[str]) -> dict[str, Table]:
    return {name: Table(columns, coordinates) for name, columns in tables.items()}


def estimated(path: str, estimate: Any) -> dict[str, Any]:
    low, high = estimate["interval95"]
    return {
        "parameter": path,
        "value": estimate["value"],
        "unit": estimate["unit"],
        "std": estimate["std"],
        "low95": low,
        "high95": high,
    }


def _picture(svg: str) -> str:
    # As an image, so that its styles stay its own.
    data = base64.b64encode(svg.encode()).decode()
    return f'<img alt="" style="max-width: 100%" src="data:image/svg+xml;base64,{data}">'
