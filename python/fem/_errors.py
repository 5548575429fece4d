"""What goes wrong, each with its place and its remedy."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Optional


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong."""

    file: Optional[str]
    """Name of the file, or of the table, in which it stands; None where it stands in none."""
    line: Optional[int]
    """Line, from 1."""
    column: Optional[int]
    """Column, from 1, in characters."""
    message: str
    """The finding, in one sentence."""
    remedy: Optional[str]
    """What to write instead."""


class Error(Exception):
    """Whatever `fem` refuses or cannot do; reads as the command would print it."""

    def __init__(self, text: str, problems: Sequence[Problem] = ()) -> None:
        super().__init__(text)
        self.problems: list[Problem] = list(problems)
        """Each thing that is wrong, in the order of its place."""

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (str(self), self.problems)


class ModelError(Error, ValueError):
    """A model, or what is asked of it, is wrong."""


class DataError(Error, ValueError):
    """Measurements are wrong."""


class ComputationError(Error):
    """A model that can be read gives no answer with these values."""


class Fault(Error):
    """The program itself went wrong; the interpreter, and every other model, go on."""

    def __init__(self, message: str, problems: Sequence[Problem] = ()) -> None:
        super().__init__(message, problems)

    def __str__(self) -> str:
        return f"fault in fem: {super().__str__()}\n  help: report it with the model and the data"

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (super().__str__(), self.problems)
