"""A stepped spindle heated over a strip, in CalculiX: 8-node axisymmetric elements of 2.5 mm, uncoupled displacement.

Lengths of 40, 60 and 30 mm, 100, 70 and 60 mm in diameter, the first two with a bore of 40 mm, of k 50, rho 7850, c 470,
E 210 GPa, nu 0.3, alpha 11.5e-6; 120 W on the outside from x = 50 to 80 mm; 30 W/(m2 K) everywhere to the 20 degC at which
it starts. Prints temperatures, changes of diameters and the elongation after 20 min, extrapolated from steps of 12 and 6 s,
which are of first order.
"""

import math
import pathlib
import subprocess
import tempfile

SIZE, END, POWER, FILM, AMBIENT = 2.5, 1200.0, 120.0, 30.0, 20.0
# Length, inner and outer radius, mm.
WALLS = [(40.0, 20.0, 50.0), (60.0, 20.0, 35.0), (30.0, 0.0, 30.0)]
# The surface of its elements is too large: insulated, 144 kJ warm the body by 77.4971 K on average, not by the 77.4052 K of
# its capacity.
SURFACE = 77.4971164 / 77.4051877
# x and radius, mm.
WARM = [(65, 35), (0, 50), (130, 0)]
CIRCLES = [(65, 35), (65, 20), (20, 20), (10, 50), (120, 30)]


def lines(borders):
    """Borders of elements between places."""
    found = [borders[0]]
    for low, high in zip(borders, borders[1:]):
        count = math.ceil((high - low) / SIZE - 1e-9)
        found += [low + (high - low) * i / count for i in range(1, count + 1)]
    return found


X, R = lines([0, 40, 50, 80, 100, 130]), lines([0, 20, 30, 35, 50])


def is_filled(i, j):
    """Whether an element is there."""
    if not (0 <= i < len(X) - 1 and 0 <= j < len(R) - 1):
        return False
    x, r, end = 0.5 * (X[i] + X[i + 1]), 0.5 * (R[j] + R[j + 1]), 0.0
    for length, inner, outer in WALLS:
        end += length
        if x < end:
            return inner < r < outer
    return False


def mesh():
    """Nodes (x and radius, mm), elements, their free faces, and those under the strip."""
    number, nodes, elements, free, heated = {}, [], [], [], []
    for i, j in ((i, j) for i in range(len(X) - 1) for j in range(len(R) - 1) if is_filled(i, j)):
        own = []
        for a, b in ((0, 0), (0, 2), (2, 2), (2, 0), (0, 1), (1, 2), (2, 1), (1, 0)):
            a, b = 2 * i + a, 2 * j + b
            if (a, b) not in number:
                number[a, b] = len(nodes) + 1
                nodes.append((0.5 * (X[a // 2] + X[(a + 1) // 2]), 0.5 * (R[b // 2] + R[(b + 1) // 2])))
            own.append(number[a, b])
        elements.append(own)
        for face, (a, b) in enumerate(((-1, 0), (0, 1), (1, 0), (0, -1)), 1):
            if is_filled(i + a, j + b) or (face == 4 and R[j] == 0):
                continue
            free.append((len(elements), face))
            if face == 2 and R[j + 1] == 35 and 50 <= X[i] < 80:
                heated.append((len(elements), face))
    return nodes, elements, free, heated


def deck(step):
    """The input file for steps of one length (s)."""
    nodes, elements, free, heated = mesh()
    flux = POWER / (2 * math.pi * 0.035 * 0.030) / SURFACE
    text = ["*NODE, NSET=ALL"]
    text += [f"{k}, {1e-3 * r:.12g}, {1e-3 * x:.12g}, 0" for k, (x, r) in enumerate(nodes, 1)]
    text += ["*ELEMENT, TYPE=CAX8, ELSET=ALL"]
    text += [f"{k}, {', '.join(map(str, own))}" for k, own in enumerate(elements, 1)]
    text += ["*MATERIAL, NAME=STEEL", "*ELASTIC", "210e9, 0.3", "*EXPANSION, ZERO=20", "11.5e-6", "*DENSITY", "7850"]
    text += ["*CONDUCTIVITY", "50", "*SPECIFIC HEAT", "470", "*SOLID SECTION, ELSET=ALL, MATERIAL=STEEL"]
    text += ["*INITIAL CONDITIONS, TYPE=TEMPERATURE", f"ALL, {AMBIENT}", "*BOUNDARY", f"{nodes.index((0, 20)) + 1}, 2, 2"]
    text += [f"{k}, 1, 1" for k, (_, r) in enumerate(nodes, 1) if r == 0]
    text += ["*STEP, INC=100000", "*UNCOUPLED TEMPERATURE-DISPLACEMENT, DIRECT", f"{step}, {END}", "*DFLUX"]
    text += [f"{element}, S{face}, {flux:.12g}" for element, face in heated] + ["*FILM"]
    text += [f"{element}, F{face}, {AMBIENT}, {FILM / SURFACE:.12g}" for element, face in free]
    text += [f"*NODE FILE, OUTPUT=2D, FREQUENCY={round(END / step)}", "NT, U", "*END STEP"]
    return nodes, "\n".join(text) + "\n"


def block(text, start):
    """Numbers of the last block of nodes that begins so, by node."""
    own = text[text.rindex(start) :]
    rows = [line for line in own[: own.index("\n -3")].splitlines() if line.startswith(" -1")]
    return {int(row[3:13]): [float(row[i : i + 12]) for i in range(13, len(row) - 11, 12)] for row in rows}


def solved(step):
    """Temperatures (degC), changes of diameters and the elongation (um)."""
    nodes, text = deck(step)
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "job.inp").write_text(text)
        subprocess.run(["ccx", "-i", "job"], cwd=folder, capture_output=True, check=True)
        found = pathlib.Path(folder, "job.frd").read_text()
    places, warm, moved = block(found, "    2C"), block(found, " -4  NDTEMP"), block(found, " -4  DISP")

    def at(x, r):
        return min(places, key=lambda k: math.hypot(places[k][0] - 1e-3 * r, places[k][1] - 1e-3 * x) + abs(places[k][2]))

    def face(x):
        """Mean displacement of an end along the axis: Simpson's rule on every side, weighted by the radius."""
        radii = sorted(r for own, r in nodes if own == x)
        terms = []
        for low, middle, high in zip(radii[0::2], radii[1::2], radii[2::2]):
            terms += [(share * (high - low) * r, moved[at(x, r)][1]) for r, share in ((low, 1), (middle, 4), (high, 1))]
        return sum(w * u for w, u in terms) / sum(w for w, _ in terms)

    grown = [2e6 * moved[at(*circle)][0] for circle in CIRCLES]
    return [warm[at(*place)][0] for place in WARM] + grown + [1e6 * (face(130) - face(0))]


coarse, fine = solved(12), solved(6)
extrapolated = [2 * b - a for a, b in zip(coarse, fine)]
for (x, r), value in zip(WARM, extrapolated):
    print(f"temperature at x = {x} mm, r = {r} mm: {value:.4f} degC")
for (x, r), value in zip(CIRCLES, extrapolated[len(WARM) :]):
    print(f"change of the diameter of {2 * r} mm at x = {x} mm: {value:.4f} um")
print(f"elongation: {extrapolated[-1]:.4f} um")
