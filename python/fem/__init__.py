"""Predicts what a machine, a fixture and a workpiece do to a machined part, compares the prediction with measurements,
and names the physical effect that is missing."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Optional, Union

from fem import _fem
from fem._answer import Planned
from fem._data import Columns, Data, File, asked
from fem._errors import ComputationError, DataError, Error, Fault, ModelError, Problem
from fem._model import Diagnosis, Fit, Laws, Model, Parameter, Remedies, compare, report
from fem._record import Record
from fem._results import (
    Budget,
    Catalogue,
    Comparison,
    Compensation,
    Correction,
    NextPart,
    Plan,
    Report,
    Result,
    Run,
)
from fem._start import Demo, demo, load, model, new
from fem._study import Study, study
from fem._table import Table

__version__: str = _fem.__version__

__all__ = [
    "Budget",
    "Catalogue",
    "Comparison",
    "Compensation",
    "ComputationError",
    "Correction",
    "DataError",
    "Demo",
    "Diagnosis",
    "Error",
    "Fault",
    "File",
    "Fit",
    "Laws",
    "Model",
    "ModelError",
    "NextPart",
    "Parameter",
    "Plan",
    "Problem",
    "Record",
    "Remedies",
    "Report",
    "Result",
    "Run",
    "Study",
    "Table",
    "budget",
    "compare",
    "demo",
    "effects",
    "load",
    "model",
    "new",
    "next_part",
    "report",
    "study",
]


def effects(name: Optional[str] = None) -> Catalogue:
    """The catalogue of effects, whole or of a process or an effect: law, parameters, units, source, look-alikes."""
    return Catalogue(*_fem.catalogue(name))


def budget(path: Union[str, "os.PathLike[str]"]) -> Budget:
    """The errors of a budget file added up."""
    return Budget(*_fem.budget(os.fspath(path)))


def next_part(
    log: Union[str, "os.PathLike[str]"],
    data: Optional[Data] = None,
    *,
    job: Optional[str] = None,
    applied: Optional[float] = None,
    new_insert: bool = False,
    new_set_up: bool = False,
    pause: float = 0.0,
    next_job: Optional[str] = None,
    dry_run: bool = False,
    columns: Columns = (),
    decimal: Optional[str] = None,
) -> NextPart:
    """The offset of the next part, from the machine's own history in a log to which what was measured is added.

    ``applied`` is the offset (um) with which the measured parts were made, where it is not the advised one; ``pause`` is in
    minutes. A ``dry_run`` adds nothing to the log.
    """
    measured = None if data is None else asked(data, columns, decimal)
    planned: Planned = {
        "new_insert": new_insert,
        "new_set_up": new_set_up,
        "pause": pause,
        "next_job": next_job,
        "applied": applied,
        "dry_run": dry_run,
    }
    return NextPart(*_fem.next_part(Path(log), measured, job, planned))
