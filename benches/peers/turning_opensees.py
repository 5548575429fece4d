"""A shaft in OpenSees, factored once; with the variant `joints`, on power-law joints, by Newton's method."""

import importlib.metadata

import openseespy.opensees as ops

from cases import TURNING, area, diameter, inertia
from job import Job

# Points of a joint's curve, spaced evenly by logarithm over this range of forces, N.
POINTS, RANGE = 200, (0.5, 1000.0)

job = Job(__doc__)
joints = job.variant == "joints"
count = int(job.size)
length = TURNING.length / count
ops.wipe()
ops.model("basic", "-ndm", 2, "-ndf", 3)
for i in range(count + 1):
    ops.node(i + 1, i * length, 0.0)
ops.geomTransf("Linear", 1)
for e in range(count):
    d = diameter((e + 0.5) * length)
    ops.element("elasticBeamColumn", e + 1, e + 1, e + 2, area(d), TURNING.youngs, inertia(d), 1)
ops.fix(1, 1, 0, 0)
c, n = TURNING.joint
forces = [RANGE[0] * (RANGE[1] / RANGE[0]) ** (i / (POINTS - 1)) for i in range(POINTS)]
for tag, (place, spring) in enumerate(zip((1, count + 1), TURNING.springs), 1):
    ground = count + 1 + tag
    ops.node(ground, *ops.nodeCoord(place))
    ops.fix(ground, 1, 1, 1)
    if joints:
        force = [*(-f for f in reversed(forces)), 0.0, *forces]
        strain = [*(-c * f**n for f in reversed(forces)), 0.0, *(c * f**n for f in forces)]
        ops.uniaxialMaterial("ElasticMultiLinear", tag, 0.0, "-strain", *strain, "-stress", *force)
    else:
        ops.uniaxialMaterial("Elastic", tag, spring)
    ops.element("zeroLength", count + tag, ground, place, "-mat", tag, "-dir", 2)

ops.constraints("Plain")
ops.numberer("RCM")
ops.integrator("LoadControl", 1.0)
if joints:
    ops.system("BandGeneral")
    # By displacement: round-off of 1000 stiff elements alone leaves more than 1e-4 N.
    ops.test("NormDispIncr", 1e-12, 100)
    ops.algorithm("Newton")
else:
    ops.system("BandSPD")
    ops.algorithm("Linear", "-factorOnce")
ops.analysis("Static")
ops.timeSeries("Constant", 1)
moved = []
for node in range(2, count + 2):
    ops.pattern("Plain", 1, 1)
    ops.load(node, 0.0, TURNING.force, 0.0)
    if ops.analyze(1) != 0:
        raise SystemExit(f"no equilibrium at node {node}")
    moved.append(ops.nodeDisp(node, 2))
    ops.remove("loadPattern", 1)
job.done(importlib.metadata.version("openseespy"), moved, case="joints" if joints else "springs")
