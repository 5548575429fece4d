#!/usr/bin/env python3
"""Read a .pvd and every frame it lists with VTK's own reader; print what is in them as JSON.

    python read_pvd.py FILE.pvd

Needs only VTK's reader modules: `pip install --no-deps vtk`. No display, OpenGL or numpy.

The JSON object has `frames` (their number), `times`, and `steps`: for each frame `time`, `file`,
`points`, `cells`, `cell_types` (VTK type number: how many), `bounds` [xmin, xmax, ...], and
`point_fields` and `cell_fields` (name: `components`, `range` [min, max] over all components).

Exit code 1, with the reasons on stderr, on any VTK error or warning, on NaN, infinity or minus zero, on a
missing file, on an empty frame, or when the list of frames is not what a .pvd should be.
"""

import json
import math
import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkLogger, vtkObject, vtkOutputWindow
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


class Problems:
    """Everything that went wrong, VTK's own complaints included."""

    def __init__(self):
        self.list = []

    def told_beside(self, result):
        """Print what was read, and the problems beside it; return the exit code."""
        print(json.dumps(result, allow_nan=False))
        for problem in self.list:
            print(problem, file=sys.stderr)
        return 1 if self.list else 0

    def watch(self, algorithm, name):
        """Collect what `algorithm` reports while it works on `name`."""

        def observe(caller, event, text=None):
            self.list.append(f"{name}: {event}: {' '.join((text or '').split())}")

        observe.CallDataType = "string0"
        algorithm.AddObserver("ErrorEvent", observe)
        algorithm.AddObserver("WarningEvent", observe)


def watch_the_rest(problems):
    """Messages of objects nobody observes (parsers, decompressors) go to the output window."""
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # else each is printed twice
    vtkObject.GlobalWarningDisplayOn()
    problems.watch(vtkOutputWindow.GetInstance(), "VTK")


def listed(pvd):
    """(time, path) of every frame of `pvd`, in the order of the file."""
    root = ElementTree.parse(pvd).getroot()
    if root.tag != "VTKFile" or root.get("type") != "Collection":
        raise ValueError(f"{pvd}: not a VTKFile of type Collection")
    sets = root.findall("./Collection/DataSet")
    return [(float(s.attrib["timestep"]), pvd.parent / s.attrib["file"]) for s in sets]


def fields(data, rows, where, problems):
    """Components and range of every array of `data`, which has one tuple per point or cell."""
    found = {}
    for i in range(data.GetNumberOfArrays()):
        array = data.GetArray(i)
        name = array.GetName()
        if array.GetNumberOfTuples() != rows:
            problems.list.append(f"{where}: {name} has {array.GetNumberOfTuples()} rows of {rows}")
        # The array's own memory, flat: no numpy needed.
        values = memoryview(array)
        values = values.cast("B").cast(values.format)
        if not all(map(math.isfinite, values)):
            problems.list.append(f"{where}: {name} holds NaN or infinity")
            continue
        if any(v == 0.0 and math.copysign(1.0, v) < 0.0 for v in values):
            problems.list.append(f"{where}: {name} holds minus zero")
        span = [min(values), max(values)] if len(values) else None
        found[name] = {"components": array.GetNumberOfComponents(), "range": span}
    return found


def read(path, problems):
    """What VTK finds in the .vtu at `path`."""
    reader = vtkXMLUnstructuredGridReader()
    problems.watch(reader, path.name)
    reader.SetFileName(str(path))
    reader.Update()
    if reader.GetErrorCode():
        problems.list.append(f"{path.name}: error code {reader.GetErrorCode()}")
    grid = reader.GetOutput()
    points, cells = grid.GetNumberOfPoints(), grid.GetNumberOfCells()
    if points == 0 or cells == 0:
        problems.list.append(f"{path.name}: {points} points, {cells} cells")
        return {"points": points, "cells": cells}
    bounds = grid.GetBounds()
    if not all(map(math.isfinite, bounds)):
        problems.list.append(f"{path.name}: coordinates hold NaN or infinity")
    nodes = memoryview(grid.GetCells().GetConnectivityArray())
    nodes = nodes.cast("B").cast(nodes.format)
    if min(nodes) < 0 or max(nodes) >= points:
        problems.list.append(f"{path.name}: cells use points {min(nodes)}...{max(nodes)} of {points}")
    types = Counter(grid.GetCellType(i) for i in range(cells))
    return {
        "points": points,
        "cells": cells,
        "cell_types": {str(t): n for t, n in sorted(types.items())},
        "bounds": bounds,
        "point_fields": fields(grid.GetPointData(), points, path.name, problems),
        "cell_fields": fields(grid.GetCellData(), cells, path.name, problems),
    }


def main(pvd):
    problems = Problems()
    watch_the_rest(problems)
    steps = []
    for time, path in listed(pvd):
        if not path.is_file():
            problems.list.append(f"{pvd.name}: {path} does not exist")
            continue
        steps.append({"time": time, "file": path.name} | read(path, problems))
    times = [s["time"] for s in steps]
    if not steps:
        problems.list.append(f"{pvd.name}: no frames")
    if not all(map(math.isfinite, times)) or any(b <= a for a, b in zip(times, times[1:])):
        problems.list.append(f"{pvd.name}: times are not finite and increasing: {times}")
    return problems.told_beside({"frames": len(steps), "times": times, "steps": steps})


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    try:
        sys.exit(main(Path(sys.argv[1])))
    except (OSError, ElementTree.ParseError, KeyError, ValueError) as error:
        sys.exit(f"{sys.argv[1]}: {error!r}")
