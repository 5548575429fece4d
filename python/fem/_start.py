"""Models to begin with: read from a file, made of keys, written for a process, and a story to try everything on."""

from __future__ import annotations

import csv
import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple, Union

from fem import _fem
from fem._model import Model, in_json

if TYPE_CHECKING:
    from fem._table import Array


def load(path: Union[str, "os.PathLike[str]"]) -> Model:
    """Reads a model file."""
    return Model._of(_fem.Model.load(os.fspath(path)))


def new(process: str) -> Model:
    """A model of a process to start from."""
    return Model(_fem.starting_model(process), process)


class Demo(NamedTuple):
    """Something to try everything on."""

    model: Model
    """A lathe that is believed to be rigid."""
    measured: dict[str, Array]
    """Columns of measurements of twelve shafts that it turned."""


def demo() -> Demo:
    """A model of a lathe, and measurements that it does not explain: `pandas.DataFrame(measured)` makes a frame of them."""
    import numpy as np

    text, measured = _fem.demo()
    header, *rows = csv.reader(line for line in measured.splitlines() if not line.startswith("#"))
    columns = np.array(rows, dtype=np.float64).T
    return Demo(Model(text, "rigid"), dict(zip(header, columns)))


def model(keys: Union[str, Mapping[str, Any]], name: str = "model") -> Model:
    """A model of nested mappings, or of the text of a model file."""
    text = keys if isinstance(keys, str) else _fem.written(in_json(keys))
    return Model(text, name).check()
