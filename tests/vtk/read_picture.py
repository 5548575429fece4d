#!/usr/bin/env python3
"""Read the script that opens a picture in ParaView, and every frame of the series it names, with VTK.

    python read_picture.py VIEW.py

Needs only VTK's reader and filter modules: `pip install --no-deps vtk`. No display, OpenGL or numpy.

The JSON object has `constants` (what the script says), `frames` (their number), `field_data` of the first
frame, `captions`, `ranges` (name: [min, max], the same in every frame), `open_edges` (edges of faces that no
other face shares, in all frames), and `volumes` of the bodies of the first frame by name, m^3.

Exit code 1, with the reasons on stderr, on any VTK error or warning, on NaN, infinity or minus zero, and where a
scalar has not the same range in every frame.
"""

import ast
import math
import sys
from pathlib import Path

from vtkmodules.vtkCommonCore import VTK_STRING
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkMassProperties, vtkThreshold, vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from read_pvd import Problems, listed, watch_the_rest


def constants(script):
    """What stands in capitals at the head of the script."""
    found = {}
    for node in ast.parse(script.read_text()).body:
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            try:
                found[node.targets[0].id] = ast.literal_eval(node.value)
            except ValueError:
                pass
    return found


def numbers(array):
    values = memoryview(array)
    return values.cast("B").cast(values.format)


def ranges(poly, where, problems):
    """[min, max] of every scalar on the points."""
    found = {}
    data = poly.GetPointData()
    for i in range(data.GetNumberOfArrays()):
        array = data.GetArray(i)
        values = numbers(array)
        if not all(map(math.isfinite, values)):
            problems.list.append(f"{where}: {array.GetName()} holds NaN or infinity")
        elif any(v == 0.0 and math.copysign(1.0, v) < 0.0 for v in values):
            problems.list.append(f"{where}: {array.GetName()} holds minus zero")
        elif array.GetNumberOfComponents() == 1:
            found[array.GetName()] = [min(values), max(values)]
    return found


def open_edges(poly):
    edges = vtkFeatureEdges()
    edges.SetInputData(poly)
    edges.BoundaryEdgesOn()
    edges.FeatureEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()


def field_data(poly):
    data = poly.GetFieldData()
    found = {}
    for i in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(i)
        found[array.GetName()] = array.GetValue(0) if array.GetDataType() == VTK_STRING else array.GetTuple1(0)
    return found


def volumes(poly, names):
    found = {}
    for number, name in names:
        one = vtkThreshold()
        one.SetInputData(poly)
        one.SetInputArrayToProcess(0, 0, 0, 1, "body")
        one.SetLowerThreshold(number)
        one.SetUpperThreshold(number)
        surface, triangles, mass = vtkGeometryFilter(), vtkTriangleFilter(), vtkMassProperties()
        surface.SetInputConnection(one.GetOutputPort())
        triangles.SetInputConnection(surface.GetOutputPort())
        mass.SetInputConnection(triangles.GetOutputPort())
        mass.Update()
        found[name] = mass.GetVolume()
    return found


def main(script):
    problems = Problems()
    watch_the_rest(problems)
    said = constants(script)
    pvd = script.parent / said["SERIES"]
    result = {"constants": said, "captions": [], "open_edges": 0}
    for frame, (_, path) in enumerate(listed(pvd)):
        reader = vtkXMLPolyDataReader()
        problems.watch(reader, path.name)
        reader.SetFileName(str(path))
        reader.Update()
        poly = reader.GetOutput()
        own, told = ranges(poly, path.name, problems), field_data(poly)
        result["captions"].append(told["caption"])
        result["open_edges"] += open_edges(poly)
        if frame == 0:
            result |= {"ranges": own, "field_data": told}
            bodies = (entry.split(" ", 1) for entry in told["bodies"].split("; "))
            result["volumes"] = volumes(poly, [(int(number), name) for number, name in bodies])
        elif own != result["ranges"]:
            problems.list.append(f"{path.name}: ranges {own} and not {result['ranges']}")
    return problems.told_beside(result | {"frames": len(result["captions"])})


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(Path(sys.argv[1])))
