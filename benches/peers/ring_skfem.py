"""A ring of 8-node quadrilaterals in scikit-fem, factored by CHOLMOD or PARDISO, as the variant says."""

import math

import numpy as np
import scipy.sparse
import skfem
from skfem.helpers import dot, sym_grad

from cases import BORE_DEGREES, RING, RING_CELLS
from factor import choose
from job import Job

job = Job(__doc__)
library, factor = choose(job.variant)
job.begin()
around, across = RING_CELLS[job.size]
step = 2 * math.pi / around
angles, radii = step * np.arange(around), np.linspace(RING.inner, RING.outer, across + 1)
points = np.array([np.outer(np.cos(angles), radii).ravel(), np.outer(np.sin(angles), radii).ravel()])
index = np.arange(around * (across + 1)).reshape(around, across + 1)
here, there = index, np.roll(index, -1, axis=0)
cells = [here[:, :-1].ravel(), here[:, 1:].ravel(), there[:, 1:].ravel(), there[:, :-1].ravel()]
straight = skfem.MeshQuad(points, np.array(cells))
mesh = skfem.MeshQuad2.from_mesh(straight)
# Nodes in the middle of an edge along the circumference lie on its chord: out to the circle.
curved = mesh.doflocs.copy()
part = np.arctan2(curved[1], curved[0]) / step
curved[:, np.abs(part - np.round(part)) > 0.25] /= math.cos(step / 2)
mesh = skfem.MeshQuad2(curved, mesh.t)

element = skfem.ElementVector(skfem.ElementQuadS2())
basis = skfem.Basis(mesh, element, intorder=4)
stiffness = RING.youngs * RING.width / (1 - RING.poisson**2)


@skfem.BilinearForm
def elastic(u, v, _):
    a, b, nu = sym_grad(u), sym_grad(v), RING.poisson
    normal = (a[0, 0] + nu * a[1, 1]) * b[0, 0] + (a[1, 1] + nu * a[0, 0]) * b[1, 1]
    return stiffness * (normal + 2 * (1 - nu) * a[0, 1] * b[0, 1])


@skfem.LinearForm
def pressure(v, w):
    return -RING.pressure * RING.width * dot(w.n, v)


matrix = elastic.assemble(basis)
middle = straight.p[:, straight.facets].mean(axis=1)
between = np.mod(np.arctan2(middle[1], middle[0]) + math.pi / 3, 2 * math.pi / 3) - math.pi / 3
rim = np.hypot(*middle) > RING.outer * math.cos(step / 2) - 1e-9
jaws = np.nonzero(rim & (np.abs(between) < RING.half_arc))[0]
load = pressure.assemble(skfem.FacetBasis(mesh, element, facets=jaws, intorder=4))

# Stiff tangential springs under the jaws hold the ring; by symmetry they carry nothing.
ties = np.zeros((matrix.shape[0], 3))
for k in range(3):
    angle = k * 2 * math.pi / 3
    ties[basis.nodal_dofs[:, index[k * around // 3, -1]], k] = -math.sin(angle), math.cos(angle)
ties = scipy.sparse.csr_array(ties)
matrix = scipy.sparse.csc_matrix(matrix + RING.youngs * RING.width * (ties @ ties.T))

solve = factor(matrix)
moved = solve(load)
values = []
for degrees in BORE_DEGREES:
    x, y = basis.nodal_dofs[:, index[degrees * around // 360, 0]]
    angle = math.radians(degrees)
    values.append(moved[x] * math.cos(angle) + moved[y] * math.sin(angle))
job.done(f"{skfem.__version__}, {library}", values, unknowns=matrix.shape[0])
