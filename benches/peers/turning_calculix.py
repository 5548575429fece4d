"""A shaft of 3-node beams in CalculiX, which makes solids of them; a step for each position."""

import calculix
from cases import TURNING, diameter
from job import Job

job = Job(__doc__)
count = int(job.size)
last = 2 * count + 1
deck = ["*NODE, NSET=ALL"]
deck += [f"{i + 1},{TURNING.length * i / (2 * count):.12g},0.,0." for i in range(last)]
deck += ["*ELEMENT, TYPE=B32"]
deck += [f"{e + 1},{2 * e + 1},{2 * e + 2},{2 * e + 3}" for e in range(count)]
deck += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{TURNING.youngs},{TURNING.poisson}"]
for d in sorted({d for *_, d in TURNING.steps}):
    name = f"D{1000 * d:.0f}"
    deck += [f"*ELSET, ELSET={name}"]
    deck += [f"{e + 1}," for e in range(count) if diameter((e + 0.5) * TURNING.length / count) == d]
    deck += [f"*BEAM SECTION, ELSET={name}, MATERIAL=STEEL, SECTION=CIRC", f"{d},{d}", "0.,1.,0."]
for k, (node, spring) in enumerate(zip((1, last), TURNING.springs), 1):
    deck += [f"*ELEMENT, TYPE=SPRING1, ELSET=S{k}", f"{count + k},{node}", f"*SPRING, ELSET=S{k}", "2", f"{spring}"]
deck += ["*BOUNDARY", "1,1,1", "1,3,3", f"{last},3,3"]
nodes = [2 * i + 1 for i in range(1, count + 1)]
for node in nodes:
    deck += [f"*NSET, NSET=N{node}", f"{node}"]
for node in nodes:
    deck += ["*STEP", "*STATIC", "*CLOAD, OP=NEW", f"{node},2,{TURNING.force}", f"*NODE PRINT, NSET=N{node}", "U"]
    deck += ["*END STEP"]
version, lines = calculix.run("\n".join(deck) + "\n")
job.done(version, [line[2] for line in lines], theory="timoshenko")
