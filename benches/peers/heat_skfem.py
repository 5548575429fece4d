"""A heated section of 4-node quadrilaterals in scikit-fem, factored once by CHOLMOD or PARDISO, as the variant says."""

import numpy as np
import skfem
from skfem.helpers import dot, grad

from cases import HEAT, HEAT_CELLS
from factor import choose
from job import Job

job = Job(__doc__)
library, factor = choose(job.variant)
job.begin()
along, up = HEAT_CELLS[job.size]
mesh = skfem.MeshQuad.init_tensor(np.linspace(0, HEAT.length, along + 1), np.linspace(0, HEAT.height, up + 1))
basis = skfem.Basis(mesh, skfem.ElementQuad1(), intorder=2)
hot = mesh.facets_satisfying(lambda x: x[0] < 1e-12)
cooled = skfem.FacetBasis(mesh, basis.elem, facets=np.setdiff1d(mesh.boundary_facets(), hot), intorder=4)
heated = skfem.FacetBasis(mesh, basis.elem, facets=hot, intorder=4)
conduct = skfem.BilinearForm(lambda u, v, _: HEAT.conductivity * dot(grad(u), grad(v))).assemble(basis)
conduct = conduct + skfem.BilinearForm(lambda u, v, _: HEAT.film * u * v).assemble(cooled)
store = skfem.BilinearForm(lambda u, v, _: HEAT.density * HEAT.specific_heat * u * v).assemble(basis) / HEAT.step
power = skfem.LinearForm(lambda v, _: HEAT.flux * v).assemble(heated)
power = power + skfem.LinearForm(lambda v, _: HEAT.film * HEAT.ambient * v).assemble(cooled)
weight = skfem.LinearForm(lambda v, _: 1.0 * v).assemble(basis)

matrix, store = (store + conduct).tocsc(), store.tocsr()
solve = factor(matrix)
temperature = np.full(matrix.shape[0], HEAT.ambient)
for _ in range(HEAT.steps):
    temperature = solve(store @ temperature + power)
# The middle of the hot edge is a node, or halfway between two.
edge = np.abs(basis.doflocs[0]) < 1e-12
order = np.argsort(basis.doflocs[1, edge])
middle = np.interp(HEAT.height / 2, basis.doflocs[1, edge][order], temperature[edge][order])
mean = weight @ temperature / (HEAT.length * HEAT.height)
job.done(f"{skfem.__version__}, {library}", [middle, mean], unknowns=matrix.shape[0])
