"""The lathe of models/lathe-on-bed.toml, pushed-lathe.toml and slant-bed in OpenSees: machine, shaft and carriage as one frame.

Shares nothing with fem. `pip install openseespy` (3.7.1), then `python lathe_on_bed.py` prints the diameter errors and
readings of dials in um that `fem validate` holds its own against, and `python lathe_on_bed.py tailstock-tilt 0.4` a
measurement of the pushed lathe whose joint of that name has that part of its stiffness, with noise of 0.3 um; with a third
word `again` another one (models/slant-bed/pushed.csv), and with `shaft` one of the shaft that it turns, with noise of 1.5 um. With the
word `compliances` it prints the file of models/measured-lathe.toml.
"""

import math
import random
import sys

import openseespy.opensees as ops

IRON, STEEL = (110e9, 0.26), (210e9, 0.30)


class Frame:
    """Nodes in mm, beams that shear, springs of no length; numbers are handed out in order."""

    def __init__(self):
        ops.wipe()
        ops.model("basic", "-ndm", 2, "-ndf", 3)
        self.nodes = self.elements = self.materials = 0

    def node(self, x, y):
        self.nodes += 1
        ops.node(self.nodes, x / 1e3, y / 1e3)
        return self.nodes

    def member(self, a, b, section, material):
        self.elements += 1
        ops.geomTransf("Linear", self.elements)
        (area, inertia, kappa), (young, nu) = section, material
        shear = young / 2 / (1 + nu)
        number = self.elements
        ops.element("ElasticTimoshenkoBeam", number, a, b, young, shear, area, inertia, kappa(nu) * area, number)

    def joint(self, a, b, **stiffness):
        ways = {"x": 1, "y": 2, "turning": 6}
        materials = []
        for value in stiffness.values():
            self.materials += 1
            ops.uniaxialMaterial("Elastic", self.materials, value)
            materials.append(self.materials)
        self.elements += 1
        directions = [ways[way] for way in stiffness]
        ops.element("zeroLength", self.elements, a, b, "-mat", *materials, "-dir", *directions)

    def ground(self, node, **stiffness):
        x, y = (1e3 * c for c in ops.nodeCoord(node))
        ground = self.node(x, y)
        ops.fix(ground, 1, 1, 1)
        self.joint(ground, node, **stiffness)


def tube(width, height, wall):
    """A rectangular tube; the shear coefficient of a thin-walled box by Cowper (1966)."""
    hollow_width, hollow_height = width - 2 * wall, height - 2 * wall
    m = (width - wall) / (height - wall)

    def kappa(nu):
        own = 12 + 72 * m + 150 * m**2 + 90 * m**3 + nu * (11 + 66 * m + 135 * m**2 + 90 * m**3)
        return 10 * (1 + nu) * (1 + 3 * m) ** 2 / (own + 10 * m**2 * ((3 + nu) * m + 3 * m**2))

    area = width * height - hollow_width * hollow_height
    return area, (width * height**3 - hollow_width * hollow_height**3) / 12, kappa


def round_bar(diameter, bore=0.0):
    ratio = (bore / diameter) ** 2

    def kappa(nu):
        return 6 * (1 + nu) * (1 + ratio) ** 2 / ((7 + 6 * nu) * (1 + ratio) ** 2 + (20 + 12 * nu) * ratio)

    return math.pi / 4 * (diameter**2 - bore**2), math.pi / 64 * (diameter**4 - bore**4), kappa


JOINTS = {
    "foot-left": 250e6,
    "foot-right": 250e6,
    "foot-along": 200e6,
    "headstock-seat": 800e6,
    "headstock-seat-along": 600e6,
    "headstock-tilt": 9000e3,
    "tailstock-seat": 400e6,
    "tailstock-seat-along": 300e6,
    "tailstock-tilt": 1500e3,
}


def machine(joints, places=()):
    """The bed with nodes at further places (mm), headstock and tailstock: the frame, the bed's nodes, the others."""
    f = Frame()
    places = sorted({-500.0, -200.0, 720.0, 1000.0, *places})
    bed = {x: f.node(x, -350) for x in places}
    for a, b in zip(places, places[1:]):
        f.member(bed[a], bed[b], tube(0.35, 0.22, 0.018), IRON)
    headstock_foot, spindle, nose = f.node(-200, -350), f.node(-200, 0), f.node(0, 0)
    tailstock_foot, quill, centre = f.node(720, -350), f.node(720, 0), f.node(600, 0)
    f.member(headstock_foot, spindle, tube(0.3, 0.32, 0.025), IRON)
    f.member(spindle, nose, round_bar(0.09, 0.04), STEEL)
    f.member(tailstock_foot, quill, tube(0.2, 0.18, 0.02), IRON)
    f.member(quill, centre, round_bar(0.06), STEEL)
    f.ground(bed[-500.0], x=joints["foot-along"], y=joints["foot-left"])
    f.ground(bed[1000.0], y=joints["foot-right"])
    for unit, foot, x in (("headstock", headstock_foot, -200.0), ("tailstock", tailstock_foot, 720.0)):
        along, across, tilt = (joints[f"{unit}-{way}"] for way in ("seat-along", "seat", "tilt"))
        f.joint(bed[x], foot, x=along, y=across, turning=tilt)
    others = {"nose": nose, "centre": centre, "headstock-foot": headstock_foot, "tailstock-foot": tailstock_foot}
    return f, bed, others


def solve(loads):
    """Displacements under loads: (node, along y in N, counter-clockwise in N m)."""
    ops.timeSeries("Linear", 1)
    ops.pattern("Plain", 1, 1)
    for node, force, moment in loads:
        ops.load(node, 0, force, moment)
    for call, arguments in [
        (ops.system, ("FullGeneral",)),
        (ops.numberer, ("Plain",)),
        (ops.constraints, ("Transformation",)),
        (ops.integrator, ("LoadControl", 1.0)),
        (ops.algorithm, ("Linear",)),
        (ops.analysis, ("Static",)),
    ]:
        call(*arguments)
    if ops.analyze(1) != 0:
        raise RuntimeError("OpenSees found no solution")


def diameter_error(tool, chuck=False, rest=None, offset=0.0, force=450.0, carriage=80e6, joints=JOINTS):
    """Diameter error in um with the tool at x in mm; a rest of 30 N/um at x; the carriage so far beside the tool."""
    stand = tool + offset
    f, bed, others = machine(joints, [stand, *([rest] if rest else [])])
    places = sorted({0.0, 150.0, 450.0, 600.0, tool, *([rest] if rest else [])})
    shaft = {x: f.node(x, 0) for x in places}
    for a, b in zip(places, places[1:]):
        f.member(shaft[a], shaft[b], round_bar(0.05 if 150 <= a < 450 else 0.04), STEEL)
    ops.equalDOF(others["nose"], shaft[0.0], *((1, 2, 3) if chuck else (1, 2)))
    ops.equalDOF(others["centre"], shaft[600.0], 2)
    if rest:
        f.joint(bed[rest], shaft[rest], y=30e6)
    # Beside its stand the force turns the carriage with the bed.
    solve([(shaft[tool], force, 0), (bed[stand], -force, force * offset / 1e3)])
    back = ops.nodeDisp(bed[stand], 2) - offset / 1e3 * ops.nodeDisp(bed[stand], 3)
    return 2e6 * (ops.nodeDisp(shaft[tool], 2) - back + force / carriage)


def pushed(load, joints, force=1000.0):
    """Readings of the dials in um, in the order of the model, where it is pushed along y."""
    _, bed, others = machine(joints)
    solve([(others[load], force, 0)])
    watched = [*(others[name] for name in ("nose", "centre", "headstock-foot", "tailstock-foot")), bed[-500.0], bed[1000.0]]
    return [1e6 * ops.nodeDisp(node, 2) for node in watched]


def compliances(tools=(0.0, 102.0, 306.0, 450.0, 600.0)):
    """Compliance between headstock, tailstock and the tool at places of the bed (mm), as a file."""
    yield "push,push_x [mm],read,read_x [mm],compliance [um/kN]"
    places = [("headstock", None), ("tailstock", None), *(("tool", x) for x in tools)]
    for pushed_at, (push, push_x) in enumerate(places):
        _, bed, others = machine(JOINTS, tools)
        at = {"headstock": others["nose"], "tailstock": others["centre"]}
        node = lambda place: at[place[0]] if place[1] is None else bed[place[1]]
        solve([(node((push, push_x)), 1.0, 0)])
        for read, read_x in places[: pushed_at + 1]:
            x = ["" if x is None else f"{x:.0f}" for x in (push_x, read_x)]
            yield f"{push},{x[0]},{read},{x[1]},{1e9 * ops.nodeDisp(node((read, read_x)), 2):.9f}"


def measured(joints, noise=0.3, seed=3):
    """A measurement of the pushed lathe, as a file."""
    scatter = random.Random(seed)
    yield "load,dial,force [N],displacement [um]"
    for number, load in enumerate(("nose", "centre"), 1):
        for dial, per_newton in enumerate(pushed(load, joints, 1.0), 1):
            for force in (250, 500, 750, 1000):
                yield f"{number},{dial},{force},{per_newton * force + scatter.gauss(0, noise):.2f}"


def turned(joints, noise=1.5, seed=5):
    """Diameter errors of the shaft between centres, as a file."""
    scatter = random.Random(seed)
    yield "x [mm],diameter_error [um]"
    for x in range(10, 600, 20):
        yield f"{x},{diameter_error(float(x), joints=joints) + scatter.gauss(0, noise):.1f}"


def table():
    held = {
        "between centres": {},
        "in chuck and centre": {"chuck": True},
        "in chuck and centre, on a rest": {"chuck": True, "rest": 300.0},
        "between centres, carriage 120 mm beside": {"offset": -120.0},
    }
    for name, how in held.items():
        for tool in (0.0, 102.0, 306.0, 450.0, 600.0):
            yield f"{name}, x = {tool:.0f} mm: {diameter_error(tool, **how):.9f}"
    for load in ("nose", "centre"):
        yield f"pushed at {load}: " + ", ".join(f"{reading:.9f}" for reading in pushed(load, JOINTS))


if __name__ == "__main__":
    if sys.argv[1:] == ["compliances"]:
        print("\n".join(compliances()))
    elif len(sys.argv) in (3, 4):
        joint, part = sys.argv[1], float(sys.argv[2])
        softened = {**JOINTS, joint: part * JOINTS[joint]}
        tests = {(): measured(softened), ("again",): measured(softened, seed=6), ("shaft",): turned(softened)}
        print("\n".join(tests[tuple(sys.argv[3:])]))
    else:
        print("\n".join(table()))
