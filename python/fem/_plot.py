"""Figures by matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from fem._record import Record
from fem._table import Table, heading

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from fem._table import Array

# Most lines that a legend names.
_NAMED = 12


def _axes(ax: Optional[Axes]) -> Axes:
    if ax is not None:
        return ax
    try:
        import matplotlib.pyplot as plt
    except ImportError as error:
        raise ImportError("plot() draws with matplotlib: pip install matplotlib; .figures has drawings without it") from error
    return plt.subplots(layout="constrained")[1]


def _groups(table: Table) -> tuple[Optional[str], list[tuple[str, Array]]]:
    """The coordinate to draw along, and the rows of each line with its label."""
    numbers = [name for name in table.varying() if table[name].dtype.kind in "if"]
    # Numbers of parts tell lines apart where there is a place to draw along.
    along = next((name for name in numbers if table.units[name]), numbers[0] if numbers else None)
    others = [name for name in table.varying() if name != along and len(np.unique(table[name])) <= _NAMED]
    kinds = [_labels(table, others[: i + 1]) for i in range(len(others))] or [_labels(table, [])]
    # As few coordinates as tell apart what all of them do: a part that was turned with a force of its own is that part.
    labels = min(kinds, key=lambda kind: -len(np.unique(kind)))
    seen = list(dict.fromkeys(labels.tolist()))
    return along, [(label, np.flatnonzero(labels == label)) for label in seen]


def _labels(table: Table, names: list[str]) -> Array:
    def told(name: str, row: int) -> str:
        value = table[name][row]
        number = f"{value:g}" if isinstance(value, float) else str(value)
        return " ".join(word for word in (name, number, table.units[name]) if word)

    return np.array([", ".join(told(name, row) for name in names) for row in range(table.rows)])


def _draw(table: Table, name: str, ax: Optional[Axes], style: dict[str, Any]) -> Axes:
    axes = _axes(ax)
    along, groups = _groups(table)
    colours = _colours(len(groups))
    for (label, rows), colour in zip(groups, colours):
        x = table[along][rows] if along else rows
        order = np.argsort(x, kind="stable") if table.units.get(along or "") else np.arange(len(rows))
        axes.plot(x[order], table[name][rows][order], label=label, color=colour, **style)
    axes.set_xlabel(heading(along, table.units[along]) if along else "row")
    axes.set_ylabel(heading(name, table.units[name]))
    if 1 < len(groups) <= _NAMED:
        axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize="small")
    return axes


def _colours(count: int) -> list[Any]:
    """Colours of lines in an order, or the usual one."""
    import matplotlib

    if count == 1:
        return [None]
    return [matplotlib.colormaps["viridis"](0.9 * i / (count - 1)) for i in range(count)]


def lines(table: Table, name: str, ax: Optional[Axes]) -> Axes:
    """A column along the longest coordinate."""
    return _draw(table, name, ax, {})


def points(table: Table, name: str, ax: Optional[Axes]) -> Axes:
    """The same as points about zero."""
    axes = _draw(table, name, ax, {"linestyle": "none", "marker": "."})
    axes.axhline(0.0, color="grey", linewidth=0.8)
    return axes


def falling(diagnosis: Record, ax: Optional[Axes]) -> Axes:
    """The error as effects are added."""
    axes = _axes(ax)
    # Everything is fitted anew with each effect.
    steps = [("as it is", diagnosis["before"]["rms"])]
    steps += [(f"+ {one['effect']}", one["rms_after"]) for one in diagnosis["missing"]]
    names, errors = [name for name, _ in steps], [error for _, error in steps]
    bars = axes.bar(names, errors)
    axes.bar_label(bars, fmt="%.3g")
    noise = diagnosis["noise"]
    axes.axhline(noise["sigma"], color="grey", linestyle="--", label="noise")
    axes.set_ylabel(f"rms error, {noise['unit']}")
    axes.tick_params(axis="x", rotation=20)
    axes.legend()
    return axes


def shares(plan: Record, ax: Optional[Axes]) -> Axes:
    """The part of each effect's signature that nothing else can imitate."""
    axes = _axes(ax)
    effects = [one for one in plan["effects"] if one["own_share"] is not None]
    axes.barh([one["effect"] for one in effects], [one["own_share"] for one in effects])
    axes.invert_yaxis()
    axes.set_xlabel("own share of the signature")
    return axes


def columns(records: list[dict[str, Any]], x: str, y: str, labels: tuple[str, str], ax: Optional[Axes]) -> Axes:
    """A key of records over another."""
    axes = _axes(ax)
    axes.plot([one[x] for one in records], [one[y] for one in records], marker=".")
    axes.set_xlabel(labels[0])
    axes.set_ylabel(labels[1])
    return axes
