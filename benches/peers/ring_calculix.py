"""A ring of 8-node plane-stress elements in CalculiX, which makes solids of them."""

import math

import calculix
from cases import BORE_DEGREES, RING, RING_CELLS
from job import Job

job = Job(__doc__)
around, across = RING_CELLS[job.size]
rows = 2 * across + 1


def number(i, j):
    """Number of the node i half elements around and j across."""
    return i % (2 * around) * rows + j + 1


deck, unknowns = ["*NODE, NSET=ALL"], 0
for i in range(2 * around):
    for j in range(rows):
        if i % 2 == 0 or j % 2 == 0:
            angle, radius = math.pi * i / around, RING.inner + (RING.outer - RING.inner) * j / (rows - 1)
            deck.append(f"{number(i, j)},{radius * math.cos(angle):.12g},{radius * math.sin(angle):.12g},0.")
            unknowns += 2
deck.append("*ELEMENT, TYPE=CPS8, ELSET=ALL")
pressed, element = [], 0
for i in range(0, 2 * around, 2):
    between = (math.pi * (i + 1) / around + math.pi / 3) % (2 * math.pi / 3) - math.pi / 3
    for j in range(0, 2 * across, 2):
        element += 1
        corners = number(i, j), number(i, j + 2), number(i + 2, j + 2), number(i + 2, j)
        middles = number(i, j + 1), number(i + 1, j + 2), number(i + 2, j + 1), number(i + 1, j)
        deck.append(",".join(map(str, (element, *corners, *middles))))
    if abs(between) < RING.half_arc:
        pressed.append(element)
deck += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{RING.youngs},{RING.poisson}"]
deck += ["*SOLID SECTION, ELSET=ALL, MATERIAL=STEEL", f"{RING.width}", "*NSET, NSET=JAWS"]
deck += [f"{number(k * 2 * around // 3, rows - 1)}," for k in range(3)]
deck += ["*TRANSFORM, NSET=JAWS, TYPE=C", "0.,0.,0.,0.,0.,1.", "*BOUNDARY", "JAWS,2,2", "*NSET, NSET=BORE"]
asked = [number(degrees * around // 180, 0) for degrees in BORE_DEGREES]
deck += [f"{node}," for node in asked]
deck += ["*STEP", "*STATIC", "*DLOAD", *(f"{e},P2,{RING.pressure:.10g}" for e in pressed)]
deck += ["*NODE PRINT, NSET=BORE", "U", "*END STEP"]
version, lines = calculix.run("\n".join(deck) + "\n")
moved = {int(line[0]): line[1:3] for line in lines}
values = []
for degrees, node in zip(BORE_DEGREES, asked):
    angle = math.radians(degrees)
    values.append(moved[node][0] * math.cos(angle) + moved[node][1] * math.sin(angle))
job.done(version, values, unknowns=unknowns)
