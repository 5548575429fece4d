"""A shaft by hand: Hermite beam elements in a band, one Cholesky factor, as many right sides as positions."""

import numpy as np
import scipy
from scipy.linalg import cho_solve_banded, cholesky_banded

from cases import TURNING, diameter, inertia
from job import Job

job = Job(__doc__)
count = int(job.size)
length = TURNING.length / count
band = np.zeros((4, 2 * count + 2))
for e in range(count):
    rigidity = TURNING.youngs * inertia(diameter((e + 0.5) * length)) / length**3
    own = [
        [12, 6 * length, -12, 6 * length],
        [6 * length, 4 * length**2, -6 * length, 2 * length**2],
        [-12, -6 * length, 12, -6 * length],
        [6 * length, 2 * length**2, -6 * length, 4 * length**2],
    ]
    for i in range(4):
        for j in range(i + 1):
            band[i - j, 2 * e + j] += rigidity * own[i][j]
band[0, 0] += TURNING.springs[0]
band[0, 2 * count] += TURNING.springs[1]

loaded = 2 * np.arange(1, count + 1)
forces = np.zeros((2 * count + 2, count))
forces[loaded, np.arange(count)] = TURNING.force
moved = cho_solve_banded((cholesky_banded(band, lower=True), True), forces)
job.done(scipy.__version__, moved[loaded, np.arange(count)])
