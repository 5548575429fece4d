"""Questions and answers as they pass between Rust and Python."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional, TypedDict

if TYPE_CHECKING:
    from fem import _fem
    import numpy as np
    import numpy.typing as npt

    Column = tuple[str, Optional[str], npt.NDArray[np.float64], list[str]]
    """Name, unit, values, and the words that the values number where they are words."""


class Answer(TypedDict):
    """What a command would print and draw, and more."""

    json: str
    text: str
    details: str
    figures: list[tuple[str, str]]
    tables: list[dict[str, list[Column]]]
    coordinates: list[str]
    notes: list[str]
    model: Optional[_fem.Model]
    steps: list[_fem.Model]


def bare(json: str, text: str, notes: list[str]) -> Answer:
    """An answer without figures, tables and models."""
    return Answer(
        json=json, text=text, details="", figures=[], tables=[], coordinates=[], notes=notes, model=None, steps=[]
    )


class Planned(TypedDict):
    """What happens before the next part, and how the measured ones were made."""

    new_insert: bool
    new_set_up: bool
    pause: float
    next_job: Optional[str]
    applied: Optional[float]
    dry_run: bool


class Asked(TypedDict):
    """Measurements: files, and tables as CSV, each with its name; how they are to be read."""

    parts: list[tuple[str, Optional[str]]]
    columns: list[str]
    decimal: Optional[str]
    header: Optional[int]
    sheet: Optional[str]
    as_typed: bool
