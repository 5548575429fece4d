"""Predicts what a machine, a fixture and a workpiece do to a machined part, compares the prediction with measurements,
and names the physical effect that is missing."""

from __future__ import annotations

from typing import Optional

from fem import _fem
from fem._errors import ComputationError, DataError, Error, Fault, ModelError, Problem
from fem._model import Demo, Model, Parameter, compare, demo, load, model, new, report
from fem._record import Record
from fem._results import (
    Catalogue,
    Comparison,
    Compensation,
    Diagnosis,
    Fit,
    Plan,
    Report,
    Result,
    Run,
)
from fem._study import Study, study
from fem._table import Table

__version__: str = _fem.__version__

__all__ = [
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
