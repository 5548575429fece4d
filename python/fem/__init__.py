"""Predicts what a machine, a fixture and a workpiece do to a machined part, compares the prediction with measurements,
and names the physical effect that is missing."""

from __future__ import annotations

import os
from typing import Optional, Union

from fem import _fem
from fem._errors import ComputationError, DataError, Error, Fault, ModelError, Problem
from fem._model import Diagnosis, Fit, Laws, Model, Parameter, compare, report
from fem._record import Record
from fem._results import (
    Budget,
    Catalogue,
    Comparison,
    Compensation,
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
    "DataError",
    "Demo",
    "Diagnosis",
    "Error",
    "Fault",
    "Fit",
    "Laws",
    "Model",
    "ModelError",
    "Parameter",
    "Plan",
    "Problem",
    "Record",
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
    "report",
    "study",
]


def effects(name: Optional[str] = None) -> Catalogue:
    """The catalogue of effects, whole or of a process or an effect: law, parameters, units, source, look-alikes."""
    return Catalogue(*_fem.catalogue(name))


def budget(path: Union[str, "os.PathLike[str]"]) -> Budget:
    """The errors of a budget file added up."""
    return Budget(*_fem.budget(os.fspath(path)))
