"""A heated section of 4-node quadrilaterals in NGSolve, factored once by its own sparse Cholesky."""

import ngsolve as ng
from ngsolve.meshes import MakeStructured2DMesh

from cases import HEAT, HEAT_CELLS
from job import Job

job = Job(__doc__)
ng.ngsglobals.msg_level = 0
ng.SetNumThreads(job.threads)
along, up = HEAT_CELLS[job.size]
mesh = MakeStructured2DMesh(quads=True, nx=along, ny=up, mapping=lambda x, y: (HEAT.length * x, HEAT.height * y))
space = ng.H1(mesh, order=1)
u, v = space.TnT()
cooled, heated = ng.ds("right|top|bottom"), ng.ds("left")
conduct = ng.BilinearForm(space, symmetric=True)
conduct += HEAT.conductivity * ng.grad(u) * ng.grad(v) * ng.dx + HEAT.film * u * v * cooled
store = ng.BilinearForm(space, symmetric=True)
store += HEAT.density * HEAT.specific_heat * u * v * ng.dx
power = ng.LinearForm(space)
power += HEAT.flux * v * heated + HEAT.film * HEAT.ambient * v * cooled
with ng.TaskManager():
    for form in (conduct, store, power):
        form.Assemble()
    matrix = store.mat.CreateMatrix()
    matrix.AsVector().data = 1 / HEAT.step * store.mat.AsVector() + conduct.mat.AsVector()
    inverse = matrix.Inverse(space.FreeDofs(), inverse="sparsecholesky")
    temperature = ng.GridFunction(space)
    temperature.Set(HEAT.ambient)
    missing, change = power.vec.CreateVector(), power.vec.CreateVector()
    for _ in range(HEAT.steps):
        missing.data = power.vec - conduct.mat * temperature.vec
        change.data = inverse * missing
        temperature.vec.data += change
    mean = ng.Integrate(temperature, mesh) / (HEAT.length * HEAT.height)
middle = temperature(mesh(0, HEAT.height / 2))
job.done(ng.__version__, [middle, mean], unknowns=space.ndof)
