"""Prints what VTK reads of a grid of vertices with the field `quarter`, as JSON."""

import json
import sys

from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

reader = vtkXMLUnstructuredGridReader()
reader.SetFileName(sys.argv[1])
reader.Update()
grid = reader.GetOutput()
quarter = grid.GetPointData().GetArray("quarter")
print(
    json.dumps(
        {
            "quarter": [quarter.GetValue(i) for i in range(quarter.GetNumberOfTuples())],
            "points": [c for i in range(grid.GetNumberOfPoints()) for c in grid.GetPoint(i)],
            "cells": [grid.GetCell(i).GetPointId(0) for i in range(grid.GetNumberOfCells())],
        }
    )
)
