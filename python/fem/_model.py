"""Models: changed, asked, and made by a fit or a diagnosis of others."""

from __future__ import annotations

import html
import json
import os
import tempfile
from collections.abc import Iterator, Mapping, MutableMapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional, Union

from fem import _fem
from fem._data import Columns, Data, asked
from fem._results import Comparison, Compensation, Correction, Listing, Plan, Report, Run, estimated, tables_of
from fem._study import Study, Watch, of_model
from fem._table import Table

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.axes import Axes

    from fem._answer import Answer

_Path = Union[str, "os.PathLike[str]"]


@dataclass(frozen=True)
class Parameter:
    """A quantity that a model does not know exactly."""

    path: str
    """Where it stands: `effects.tool-wear.rate`."""
    unit: str
    value: Optional[float]
    """None where it is unknown (`?`)."""
    std: Optional[float]
    """Its standard uncertainty (`+-`); None where it is unknown."""


class Keys(MutableMapping[str, Any]):
    """A table of a model: reading gives values as they are written, writing changes the model."""

    def __init__(self, model: Model, path: tuple[str, ...]) -> None:
        self._model = model
        self._path = path

    def _plain(self) -> Mapping[str, Any]:
        found: Any = json.loads(_fem.keys(self._model.text))
        for key in self._path:
            found = found[int(key)] if isinstance(found, list) else found[key]
        return dict(enumerate_keys(found)) if isinstance(found, list) else found

    def __getitem__(self, key: Union[str, int]) -> Any:
        found = self._plain()
        if str(key) not in found:
            raise KeyError(f"no {'.'.join((*self._path, str(key)))} in the model; there is {', '.join(found)}")
        value = found[str(key)]
        is_table = isinstance(value, dict) or isinstance(value, list) and any(isinstance(v, dict) for v in value)
        return Keys(self._model, (*self._path, str(key))) if is_table else value

    def __setitem__(self, key: Union[str, int], value: Any) -> None:
        self._model._set((*self._path, str(key)), value)

    def __delitem__(self, key: Union[str, int]) -> None:
        self._model._change(_fem.without(self._model.text, [*self._path, str(key)]))

    def __iter__(self) -> Iterator[str]:
        return iter(self._plain())

    def __len__(self) -> int:
        return len(self._plain())

    def __repr__(self) -> str:
        return repr(self._plain())


def enumerate_keys(values: Sequence[Any]) -> Iterator[tuple[str, Any]]:
    """The places of a list as keys."""
    return ((str(i), value) for i, value in enumerate(values))


class Model:
    """A machine, fixture, tool and workpiece, and what is asked of them.

    `model["cut"]["depth"] = "0.5 mm"` changes it; `with_`, `add` and results give new ones. It is checked when it is
    asked something, or by `check`.
    """

    def __init__(self, text: str, name: str = "model") -> None:
        self._text = text
        self._name = name
        self._read: Optional[_fem.Model] = None

    @classmethod
    def _of(cls, core: _fem.Model) -> Model:
        # It was read already.
        model = cls(core.text, core.name)
        model._read = core
        return model

    def _core(self) -> _fem.Model:
        if self._read is None:
            self._read = _fem.Model.parse(self._name, self._text)
        return self._read

    def _change(self, text: str) -> None:
        self._text, self._read = text, None

    def _set(self, path: Sequence[str], value: Any) -> None:
        self._change(_fem.with_value(self._text, list(path), in_json(value)))

    @property
    def text(self) -> str:
        """The model file."""
        return self._text

    @property
    def name(self) -> str:
        """The name of its file; the paths that it names are relative to its folder."""
        return self._name

    @property
    def title(self) -> Optional[str]:
        """Its title, if it has one."""
        return self._core().title

    @property
    def process(self) -> str:
        """The process that it models."""
        return self._core().process

    @property
    def effects(self) -> list[str]:
        """Names of its effects, in their order."""
        return self._core().effects

    @property
    def parameters(self) -> list[Parameter]:
        """What it does not know exactly."""
        return [Parameter(*one) for one in self._core().parameters]

    def check(self) -> Model:
        """Raises what is wrong with it, and returns it."""
        self._core()
        return self

    def copy(self) -> Model:
        """The same again, to be changed by itself."""
        return Model(self._text, self._name)

    def __getitem__(self, key: str) -> Any:
        return Keys(self, ())[key]

    def __setitem__(self, key: str, value: Any) -> None:
        Keys(self, ())[key] = value

    def __delitem__(self, key: str) -> None:
        del Keys(self, ())[key]

    def __contains__(self, key: object) -> bool:
        return key in json.loads(_fem.keys(self._text))

    def __iter__(self) -> Iterator[str]:
        return iter(Keys(self, ()))

    def to_dict(self) -> dict[str, Any]:
        """All of its keys."""
        return dict(json.loads(_fem.keys(self._text)))

    def with_(self, values: Optional[Mapping[str, Any]] = None, **more: Any) -> Model:
        """The model with other values, by their paths: `with_({"cut.depth": "0.6 mm"})`."""
        model = self.copy()
        for path, value in {**(values or {}), **more}.items():
            model._set(path.split("."), value)
        return model.check()

    def add(self, effect: str, **parameters: Any) -> Model:
        """The model with one more effect; what is left out of its parameters is unknown (`?`), to be fitted."""
        settings = [(key, value if isinstance(value, str) else in_json(value)) for key, value in parameters.items()]
        return Model._of(self._core().add(effect, settings))

    def save(self, path: _Path, overwrite: bool = False) -> Path:
        """Writes the model file; the paths that it names lead to the same files from there."""
        place = Path(path)
        if place.exists() and not overwrite:
            raise FileExistsError(f"{place} is there already; name another file, or say overwrite=True")
        handle, beside = tempfile.mkstemp(dir=place.parent, prefix=".fem-")
        try:
            with os.fdopen(handle, "w", encoding="utf-8", newline="") as file:
                file.write(self._core().text_at(os.fspath(place)))
            os.replace(beside, place)
        except BaseException:
            os.unlink(beside)
            raise
        return place

    def run(self) -> Run:
        """Predicts."""
        return Run(self._core().run())

    def predict(
        self,
        design: Optional[Data] = None,
        *,
        bands: bool = False,
        columns: Columns = (),
        decimal: Optional[str] = None,
    ) -> Table:
        """The prediction of rows: of a design, which is measurements without what is observed, or of its own programme.

        With ``bands``, ``from`` and ``to`` hold the truth with 95 %: values known roughly are drawn together.
        """
        return self.predictions(design, bands=bands, columns=columns, decimal=decimal)[0]

    def predictions(
        self,
        design: Optional[Data] = None,
        *,
        bands: bool = False,
        columns: Columns = (),
        decimal: Optional[str] = None,
    ) -> list[Table]:
        """The same of each observable, where rows have several."""
        rows = None if design is None else asked(design, columns, decimal)
        answer = self._core().predict(rows)
        (tables,) = answer["tables"]
        left_out = () if bands else ("from", "to")
        return [
            Table([column for column in table if column[0] not in left_out], answer["coordinates"])
            for table in tables.values()
        ]

    def correct(
        self,
        program: Optional[_Path] = None,
        *,
        add_blocks: bool = False,
        despite_failure: bool = False,
        output: Optional[_Path] = None,
        overwrite: bool = False,
    ) -> Correction:
        """What to command so that the part comes out as the drawing asks, and what will be left.

        A model that failed against its measurements is refused, unless ``despite_failure``. A ``program`` is written with other X words into the folder ``output``, with all that the command writes.
        """
        own = None if program is None else Path(program)
        folder = None if output is None else Path(output)
        return Correction(self._core().correct(own, add_blocks, despite_failure, folder, overwrite))

    def remedies(
        self,
        minutes: Optional[float] = None,
        *,
        despite_failure: bool = False,
        output: Optional[_Path] = None,
        overwrite: bool = False,
    ) -> Remedies:
        """Which of its ``[[setting]]``s to change: what each gains, what it costs, and which few do best together."""
        folder = None if output is None else Path(output)
        answer = self._core().remedies(minutes, despite_failure, folder, overwrite)
        return Remedies(answer, Model._of(answer["model"]) if answer["model"] else None)

    def compare(self, data: Data, *, columns: Columns = (), decimal: Optional[str] = None) -> Comparison:
        """How well it agrees with measurements, and where it fails."""
        return Comparison(_fem.compare([self._core()], asked(data, columns, decimal)))

    def fit(
        self,
        data: Data,
        *,
        columns: Columns = (),
        decimal: Optional[str] = None,
        time_limit: Optional[float] = None,
    ) -> Fit:
        """Estimates what is marked `+-` or `?`, within so many seconds if a limit is given."""
        return Fit(self._core().fit(asked(data, columns, decimal), time_limit))

    def diagnose(
        self,
        data: Data,
        *,
        max_effects: int = 6,
        columns: Columns = (),
        decimal: Optional[str] = None,
        time_limit: Optional[float] = None,
    ) -> Diagnosis:
        """Names the effects that are missing, at most so many together."""
        _positive(max_effects)
        return Diagnosis(self._core().diagnose(asked(data, columns, decimal), max_effects, time_limit))

    def discover(
        self,
        data: Data,
        *,
        columns: Columns = (),
        decimal: Optional[str] = None,
        candidates: Sequence[_Path] = (),
        time_limit: Optional[float] = None,
    ) -> Laws:
        """Seeks a law that is in no catalogue in what the model leaves, over every column of the data.

        Files of ``candidates``, or folders of them, hold laws of your own, which are tried among the others.
        """
        own = [Path(path) for path in candidates]
        return Laws(self._core().discover(asked(data, columns, decimal), own, time_limit))

    def plan(
        self,
        design: Optional[Data] = None,
        *,
        noise: Union[str, Sequence[str]] = (),
        columns: Columns = (),
        decimal: Optional[str] = None,
        time_limit: Optional[float] = None,
    ) -> Plan:
        """Before measuring: what could be seen at a noise such as `"1.5 um"`, and what would look alike.

        A design is measurements without what is observed; left out, it is the model's own programme.
        """
        rows = None if design is None else asked(design, columns, decimal)
        return Plan(self._core().plan(rows, [noise] if isinstance(noise, str) else list(noise), time_limit))

    def compensate(self, data: Data, *, columns: Columns = (), decimal: Optional[str] = None) -> Compensation:
        """Evaluates the test of a feed axis by ISO 230-2, and what tables for its controller would leave."""
        return Compensation(self._core().compensate(asked(data, columns, decimal)))

    def report(
        self,
        data: Optional[Data] = None,
        path: Optional[_Path] = None,
        *,
        max_effects: int = 6,
        columns: Columns = (),
        decimal: Optional[str] = None,
        time_limit: Optional[float] = None,
    ) -> Report:
        """Prediction, residuals, causes and what to do next as one page, written to a path if one is given."""
        return report(
            [self], data, path, max_effects=max_effects, columns=columns, decimal=decimal, time_limit=time_limit
        )

    def study(
        self,
        inputs: Optional[Mapping[str, Mapping[str, Any]]] = None,
        results: Sequence[Union[str, Mapping[str, Any]]] = (),
        *,
        design: Union[str, Mapping[str, Any], None] = None,
        samples: Optional[int] = None,
        seed: Optional[int] = None,
        indices: Optional[bool] = None,
        data: Optional[_Path] = None,
        task: Optional[str] = None,
        title: Optional[str] = None,
        output: Optional[_Path] = None,
        restart: bool = False,
        time_limit: Optional[float] = None,
        progress: Optional[Watch] = None,
        client: Any = None,
        chunk: int = 256,
    ) -> Study:
        """Many jobs with it: `model.study({"cut.depth": {"half_field": "0.1 mm"}}, ["largest.value"])`.

        The names are those of a plan: keys of an input by its quantity, a figure or all keys of a result, the type of
        the design or all of its keys. Files are relative to the folder of the model. The rest is as in `fem.study`.
        """
        chosen: dict[str, Any] = {"type": design} if isinstance(design, str) else dict(design or {})
        given = {"samples": samples, "seed": seed, "indices": indices}
        chosen.update({key: value for key, value in given.items() if value is not None})
        folder = Path(self._name).absolute().parent
        if "file" in chosen:
            chosen["file"] = os.fspath(folder / chosen["file"])
        keys: dict[str, Any] = {"title": title, "task": task, "design": chosen or None}
        if data is not None:
            keys["data"] = os.fspath(folder / data)
        keys = {key: value for key, value in keys.items() if value is not None}
        keys["input"] = [{"quantity": quantity, **one} for quantity, one in (inputs or {}).items()]
        keys["result"] = [{"figure": one} if isinstance(one, str) else dict(one) for one in results]
        keys = {key: value for key, value in keys.items() if value != []}
        return of_model(self.save, keys, output, restart, time_limit, progress, client, chunk)

    def __reduce__(self) -> tuple[Any, ...]:
        return Model, (self._text, self._name)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Model) and (self._text, self._name) == (other._text, other._name)

    # It changes.
    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        keys = self.to_dict()
        title = f" {keys['title']!r}" if "title" in keys else ""
        effects = f" with {', '.join(keys['effects'])}" if keys.get("effects") else ""
        return f"<fem.Model {self._name}: {keys.get('process', 'no process')}{title}{effects}>"

    def _repr_html_(self) -> str:
        text = html.escape(self._text)
        return f"<details><summary>{html.escape(repr(self))}</summary><pre>{text}</pre></details>"


class Fit(Listing):
    """What a model leaves open, estimated."""

    def __init__(self, answer: Answer) -> None:
        super().__init__(answer)
        (tables,) = answer["tables"]
        self.tables: dict[str, Table] = tables_of(tables, answer["coordinates"])
        """The table of each observable: coordinates, what was measured, `u`, `predicted`, `residual`."""
        self._model = Model._of(answer["model"]) if answer["model"] else None

    @property
    def model(self) -> Model:
        """The model with the fitted values and their uncertainties."""
        if self._model is None:
            raise ValueError("a fitted value lies outside of what a model may hold: none can be made of this fit")
        return self._model

    @property
    def rows(self) -> Table:
        """The rows of the first observable with the predictions of the fitted model."""
        return next(iter(self.tables.values()))

    def _records(self) -> list[dict[str, Any]]:
        return [estimated(p["parameter"], p) for p in self.document["parameters"]]

    def to_pandas(self) -> pd.DataFrame:
        """The parameters: value, unit, standard uncertainty, 95 % interval."""
        return super().to_pandas()

    def plot(self, ax: Optional[Axes] = None) -> Axes:
        """Draws the residuals of the fitted model along their longest coordinate."""
        from fem import _plot

        return _plot.points(self.rows, "residual", ax)


class Remedies(Listing):
    """Which settings to change."""

    def __init__(self, answer: Answer, model: Optional[Model]) -> None:
        super().__init__(answer)
        self.model: Optional[Model] = model
        """The model with the best settings; None where none makes it better."""

    def _records(self) -> list[dict[str, Any]]:
        keys = ("setting", "from", "to", "gain", "minutes", "rms", "worst", "probability_in")
        return [{key: one.to_dict().get(key) for key in keys} for one in self.document["actions"] if one["setting"]]

    def to_pandas(self) -> pd.DataFrame:
        """A row for each setting alone: what to change, what it gains (m) and costs (minutes)."""
        return super().to_pandas()


class Laws(Listing):
    """Laws that are in no catalogue."""

    def __init__(self, answer: Answer) -> None:
        super().__init__(answer)
        self.model: Optional[Model] = Model._of(answer["model"]) if answer["model"] else None
        """The model with the law, every value re-fitted; None where no law is told."""

    @property
    def formula(self) -> Optional[str]:
        """The law that is told, as a formula."""
        law = self.document["law"]
        return law["formula"] if law else None

    def _records(self) -> list[dict[str, Any]]:
        told = [law for law in (self.document["law"] or self.document["law_held_back"],) if law]
        keys = ("formula", "chi2_per_dof", "price", "criterion")
        return [{key: law[key] for key in keys} for law in told + self.document["rivals"]]

    def to_pandas(self) -> pd.DataFrame:
        """The law and its rivals: what is left of the error, and what each pays for the search."""
        return super().to_pandas()


class Diagnosis(Listing):
    """The effects that are missing."""

    def __init__(self, answer: Answer) -> None:
        super().__init__(answer)
        self.model: Optional[Model] = Model._of(answer["model"]) if answer["model"] else None
        """The model with the missing effects and every fitted value; None where no model may hold these."""
        self.steps: list[Model] = [Model._of(step) for step in answer["steps"]]
        """The model with one missing effect after the other: `fem.compare([model, *diagnosis.steps], data)` shows the
        error falling."""
        self.details: str = self._without_commands(answer["details"])
        """All of it, as `fem diagnose --verbose` prints it: where the model fails, every cause, every effect on trial."""
        self.text = self._without_commands(self.text) + "  .details all of it\n"

    def _without_commands(self, text: str) -> str:
        """The text with attributes in the place of commands, which name files, of which there are none here."""
        told, commands, _ = text.partition("\nto go on\n")
        if not commands:
            return text
        steps = "  .steps   the model with one of them after the other\n" if self.steps else ""
        model = "  .model   the model with all of them, every value re-fitted\n" if self.steps and self.model else ""
        return f"{told}\nto go on\n{steps}{model}"

    def _records(self) -> list[dict[str, Any]]:
        keys = ("effect", "kind", "rms_after", "delta_bic", "p_value", "note")
        return [{key: one[key] for key in keys} for one in self.document["candidates"]]

    def to_pandas(self) -> pd.DataFrame:
        """Every effect on trial: what is left of the error with it, and how much better it is than chance."""
        return super().to_pandas()

    def parameters_to_pandas(self) -> pd.DataFrame:
        """All that was fitted: value, unit, standard uncertainty, 95 % interval."""
        import pandas as pd

        found = self.document["parameters"]
        return pd.DataFrame([estimated(path, estimate) for path, estimate in found.items()])

    def plot(self, ax: Optional[Axes] = None) -> Axes:
        """Draws the error falling from effect to effect."""
        from fem import _plot

        return _plot.falling(self.document, ax)


def compare(
    models: Sequence[Model], data: Data, *, columns: Columns = (), decimal: Optional[str] = None
) -> Comparison:
    """Several models against the same measurements: the error falling, side by side."""
    if not models:
        raise ValueError("there is no model to compare")
    return Comparison(_fem.compare([model._core() for model in models], asked(data, columns, decimal)))


def report(
    models: Sequence[Model],
    data: Optional[Data] = None,
    path: Optional[_Path] = None,
    *,
    max_effects: int = 6,
    columns: Columns = (),
    decimal: Optional[str] = None,
    time_limit: Optional[float] = None,
) -> Report:
    """One page of several models, of which the last is diagnosed."""
    if not models:
        raise ValueError("there is no model to report on")
    _positive(max_effects)
    rows = None if data is None else asked(data, columns, decimal)
    page = Report(*_fem.report([model._core() for model in models], rows, max_effects, time_limit))
    if path is not None:
        page.save(path)
    return page


def _positive(max_effects: int) -> None:
    if not 1 <= max_effects <= 8:
        raise ValueError(f"max_effects is {max_effects}; expected 1 to 8")


def in_json(value: Any) -> str:
    """A value of a model; NumPy's numbers are numbers."""
    return json.dumps(value, default=_number, allow_nan=False)


def _number(value: Any) -> Any:
    if isinstance(value, Keys):
        return value._plain()
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"{value!r} is no value of a model; expected a text with a unit, a number, a list or a mapping")
