"""A ring of 100/84 mm, 60 mm wide, in three jaws that press over 20 deg and 15 mm at one end, by CalculiX: 20-node bricks of a sixth.

Shares nothing with fem. `apt install calculix-ccx` (2.20), then `python wide_ring.py` prints how far the bore moves outwards, um, at
angles from a jaw and places from the face at the chuck. `python wide_ring.py 2` has cells half as large.
"""

import math
import subprocess
import sys
import tempfile
from pathlib import Path

OUTER, INNER, WIDTH = 50.0, 42.0, 60.0  # mm
YOUNG, POISSON = 210e3, 0.30  # N/mm2
FORCE, ARC, REACH = 3000.0, 20.0, 15.0  # N, deg, mm
ANGLES, PLACES = (0.0, 15.0, 30.0, 45.0, 60.0), (0.0, 15.0, 30.0, 45.0, 60.0)


def solve(fine=1):
    around, across, along = 24 * fine, 4 * fine, 20 * fine
    numbers = {}

    def node(i, j, k):
        """Half steps around, across and along."""
        return numbers.setdefault((i, j, k), len(numbers) + 1)

    corners = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)]
    middles = [(1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2), (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)]
    elements, pressed = [], []
    for i in range(around):
        for j in range(across):
            for k in range(along):
                # Across first, then around, so that bricks are right-handed.
                own = [node(2 * i + b, 2 * j + a, 2 * k + c) for a, b, c in corners + middles]
                elements.append(own)
                outside, under = j == across - 1, (i + 1) * 60 / around <= ARC / 2 + 1e-9
                if outside and under and (k + 1) * WIDTH / along <= REACH + 1e-9:
                    pressed.append(len(elements))
    places = {}
    for (i, j, k), number in numbers.items():
        angle, radius = math.radians(60 * i / (2 * around)), INNER + (OUTER - INNER) * j / (2 * across)
        places[number] = (radius * math.cos(angle), radius * math.sin(angle), WIDTH * k / (2 * along))
    pressure = FORCE / (OUTER * math.radians(ARC) * REACH)
    lines = ["*NODE"]
    lines += [f"{n},{x:.12g},{y:.12g},{z:.12g}" for n, (x, y, z) in sorted(places.items())]
    lines.append("*ELEMENT, TYPE=C3D20, ELSET=ALL")
    for number, own in enumerate(elements, 1):
        lines += [",".join(map(str, [number, *own[:10]])) + ",", ",".join(map(str, own[10:]))]
    lines.append("*NSET, NSET=STILL")
    lines += [f"{n}" for (i, j, k), n in numbers.items() if i == 0]
    lines.append("*NSET, NSET=TURNED")
    lines += [f"{n}" for (i, j, k), n in numbers.items() if i == 2 * around]
    c, s = math.cos(math.radians(60)), math.sin(math.radians(60))
    lines += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{YOUNG},{POISSON}", "*SOLID SECTION, ELSET=ALL, MATERIAL=STEEL"]
    lines += ["*TRANSFORM, NSET=TURNED", f"{c},{s},0,{-s},{c},0"]
    lines += ["*BOUNDARY", "STILL,2,2", "TURNED,2,2", f"{node(0, 0, 2 * along)},3,3"]
    lines += ["*STEP", "*STATIC", "*DLOAD"]
    # The face of a brick across its second direction: nodes 2, 3, 7 and 6 stand outside.
    lines += [f"{number},P4,{pressure:.12g}" for number in pressed]
    lines += ["*NODE PRINT, NSET=BORE, GLOBAL=YES", "U", "*END STEP"]
    bore = {numbers[i, 0, k]: (60 * i / (2 * around), WIDTH * k / (2 * along)) for i in range(2 * around + 1) for k in range(2 * along + 1) if (i, 0, k) in numbers}
    at = lines.index("*MATERIAL, NAME=STEEL")
    lines[at:at] = ["*NSET, NSET=BORE", *(str(n) for n in sorted(bore))]
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "ring.inp").write_text("\n".join(lines) + "\n")
        subprocess.run(["ccx", "ring"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        moved = {}
        for line in Path(folder, "ring.dat").read_text().splitlines():
            cells = line.split()
            if len(cells) == 4 and cells[0].isdigit():
                moved[int(cells[0])] = [float(cell) for cell in cells[1:]]
    table = {}
    for number, (angle, place) in bore.items():
        a = math.radians(angle)
        table[round(angle, 6), round(place, 6)] = 1e3 * (moved[number][0] * math.cos(a) + moved[number][1] * math.sin(a))
    return table


if __name__ == "__main__":
    table = solve(int(sys.argv[1]) if len(sys.argv) > 1 else 1)
    print("angle, z:", ", ".join(f"{place:.0f} mm" for place in PLACES))
    for angle in ANGLES:
        print(f"{angle:.0f} deg:", ", ".join(f"{table[angle, place]:.6f}" for place in PLACES))
