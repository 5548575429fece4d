"""A rotor in ROSS: its stiffness at rest, and a dense solve, for a static force at a point is no case of its own."""

import warnings

warnings.filterwarnings("ignore")

import numpy as np
import ross

from cases import TURNING, diameter
from job import Job

job = Job(__doc__)
count = int(job.size)
length = TURNING.length / count
steel = ross.Material(name="steel", rho=TURNING.density, E=TURNING.youngs, G_s=TURNING.shear)
shaft = [
    ross.ShaftElement(length, 0.0, diameter((e + 0.5) * length), material=steel, n=e, shear_effects=False)
    for e in range(count)
]
bearings = [ross.BearingElement(n, kxx=k, cxx=0, kyy=k, cyy=0) for n, k in zip((0, count), TURNING.springs)]
rotor = ross.Rotor(shaft, [], bearings)
stiffness, freedoms = rotor.K(0), rotor.number_dof
lateral = [freedoms * i + j for i in range(count + 1) for j in (0, 1, 3, 4)]
positions = np.arange(count)
forces = np.zeros((len(lateral), count))
forces[4 * (positions + 1), positions] = TURNING.force
moved = np.linalg.solve(stiffness[np.ix_(lateral, lateral)], forces)
job.done(ross.__version__, moved[4 * (positions + 1), positions])
