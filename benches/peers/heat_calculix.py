"""A heated section of 4-node elements in CalculiX, which makes solids of them."""

import calculix
from cases import HEAT, HEAT_CELLS
from job import Job

job = Job(__doc__)
along, up = HEAT_CELLS[job.size]


def number(i, j):
    """Number of the node i elements along and j up."""
    return i * (up + 1) + j + 1


deck = ["*NODE, NSET=ALL"]
for i in range(along + 1):
    deck += [f"{number(i, j)},{HEAT.length * i / along:.12g},{HEAT.height * j / up:.12g},0." for j in range(up + 1)]
deck.append("*ELEMENT, TYPE=CPE4, ELSET=ALL")
hot, cooled, element = [], [], 0
for i in range(along):
    for j in range(up):
        element += 1
        deck.append(f"{element},{number(i, j)},{number(i + 1, j)},{number(i + 1, j + 1)},{number(i, j + 1)}")
        if i == 0:
            hot.append(f"{element},S4,{HEAT.flux}")
        for face, is_edge in ((1, j == 0), (2, i == along - 1), (3, j == up - 1)):
            if is_edge:
                cooled.append(f"{element},F{face},{HEAT.ambient},{HEAT.film}")
deck += ["*MATERIAL, NAME=STEEL", "*CONDUCTIVITY", f"{HEAT.conductivity}", "*DENSITY", f"{HEAT.density}"]
deck += ["*SPECIFIC HEAT", f"{HEAT.specific_heat}", "*SOLID SECTION, ELSET=ALL, MATERIAL=STEEL", "0.001"]
deck += ["*INITIAL CONDITIONS, TYPE=TEMPERATURE", f"ALL,{HEAT.ambient}"]
asked = {number(0, up // 2), number(0, (up + 1) // 2)}
deck += ["*NSET, NSET=MIDDLE", *(f"{node}," for node in sorted(asked))]
deck += [f"*STEP, INC={HEAT.steps + 10}", "*HEAT TRANSFER, DIRECT", f"{HEAT.step},{HEAT.step * HEAT.steps}"]
deck += ["*DFLUX", *hot, "*FILM", *cooled]
deck += [f"*NODE PRINT, NSET=MIDDLE, FREQUENCY={HEAT.steps}", "NT", "*END STEP"]
version, lines = calculix.run("\n".join(deck) + "\n")
last = lines[-len(asked) :]
job.done(version, [sum(line[1] for line in last) / len(asked)], unknowns=number(along, up))
