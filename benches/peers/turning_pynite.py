"""A frame in PyNite: a member for each element, a load combination for each position, its linear analysis."""

import importlib.metadata

from Pynite import FEModel3D

from cases import TURNING, area, diameter, inertia
from job import Job

job = Job(__doc__)
count = int(job.size)
frame = FEModel3D()
frame.add_material("steel", TURNING.youngs, TURNING.shear, TURNING.poisson, TURNING.density * 9.81)
for d in sorted({d for *_, d in TURNING.steps}):
    frame.add_section(str(d), area(d), inertia(d), inertia(d), 2 * inertia(d))
for i in range(count + 1):
    frame.add_node(f"N{i}", TURNING.length * i / count, 0, 0)
for e in range(count):
    d = diameter((e + 0.5) * TURNING.length / count)
    frame.add_member(f"M{e}", f"N{e}", f"N{e + 1}", "steel", str(d))
frame.def_support("N0", True, False, True, True, False, False)
frame.def_support(f"N{count}", False, False, True, False, False, False)
for node, spring in zip((0, count), TURNING.springs):
    frame.def_support_spring(f"N{node}", "DY", spring)
for i in range(1, count + 1):
    frame.add_node_load(f"N{i}", "FY", TURNING.force, case=f"C{i}")
    frame.add_load_combo(f"L{i}", {f"C{i}": 1.0})
frame.analyze_linear(sparse=True)
moved = [frame.nodes[f"N{i}"].DY[f"L{i}"] for i in range(1, count + 1)]
job.done(importlib.metadata.version("PyNiteFEA"), moved)
