"""A ring of second-order quadrilaterals (9 nodes) in NGSolve, deformed to the circle, with its own sparse Cholesky."""

import math

import ngsolve as ng
from netgen.meshing import Element1D, Element2D, FaceDescriptor, MeshPoint, Pnt
from netgen.meshing import Mesh as NetgenMesh

from cases import BORE_DEGREES, RING, RING_CELLS
from job import Job

job = Job(__doc__)
ng.ngsglobals.msg_level = 0
ng.SetNumThreads(job.threads)
around, across = RING_CELLS[job.size]
step = 2 * math.pi / around
coarse = NetgenMesh(dim=2)
index = []
for i in range(around):
    c, s = math.cos(i * step), math.sin(i * step)
    radii = [RING.inner + (RING.outer - RING.inner) * j / across for j in range(across + 1)]
    index.append([coarse.Add(MeshPoint(Pnt(r * c, r * s, 0))) for r in radii])
coarse.Add(FaceDescriptor(surfnr=1, domin=1, bc=1))
coarse.SetMaterial(1, "steel")
for i in range(around):
    here, there = index[i], index[(i + 1) % around]
    for j in range(across):
        coarse.Add(Element2D(1, [here[j], here[j + 1], there[j + 1], there[j]]))
    between = ((i + 0.5) * step + math.pi / 3) % (2 * math.pi / 3) - math.pi / 3
    coarse.Add(Element1D([here[-1], there[-1]], index=1 if abs(between) < RING.half_arc else 2))
    coarse.Add(Element1D([there[0], here[0]], index=3))
for number, name in enumerate(("jaw", "rim", "bore")):
    coarse.SetBCName(number, name)
mesh = ng.Mesh(coarse)

# Where a point of the straight quadrilaterals belongs on the ring.
x, y = ng.x, ng.y
angle = ng.atan2(y, x)
turns = ng.IfPos(angle, angle, angle + 2 * math.pi) / step
along = turns - ng.floor(turns + 1e-9) - 0.5
radius = ng.sqrt(x * x + y * y) * ng.cos(along * step) / math.cos(step / 2)
true = (ng.floor(turns + 1e-9) + 0.5 + ng.tan(along * step) / math.tan(step / 2) / 2) * step
shift = ng.GridFunction(ng.VectorH1(mesh, order=2))
shift.Set(ng.CF((radius * ng.cos(true) - x, radius * ng.sin(true) - y)))
mesh.SetDeformation(shift)

space = ng.VectorH1(mesh, order=2)
u, v = space.TnT()
nu = RING.poisson
a, b = ng.Sym(ng.Grad(u)), ng.Sym(ng.Grad(v))
stiffness = RING.youngs * RING.width / (1 - nu**2)
form = ng.BilinearForm(space, symmetric=True)
form += stiffness * ((1 - nu) * ng.InnerProduct(a, b) + nu * ng.Trace(a) * ng.Trace(b)) * ng.dx
load = ng.LinearForm(space)
load += -RING.pressure * RING.width * ng.InnerProduct(ng.specialcf.normal(2), v) * ng.ds("jaw")
with ng.TaskManager():
    form.Assemble()
    load.Assemble()
    # Stiff tangential springs under the jaws hold the ring; by symmetry they carry nothing.
    half = space.ndof // 2
    for k in range(3):
        vertex = index[k * around // 3][-1].nr - 1
        tangent = -math.sin(k * 2 * math.pi / 3), math.cos(k * 2 * math.pi / 3)
        for i, j in ((0, 0), (1, 0), (1, 1)):
            spring = RING.youngs * RING.width * tangent[i] * tangent[j]
            form.mat[i * half + vertex, j * half + vertex] += spring
    moved = ng.GridFunction(space)
    moved.vec.data = form.mat.Inverse(space.FreeDofs(), inverse="sparsecholesky") * load.vec
values = []
for degrees in BORE_DEGREES:
    vertex, angle = index[degrees * around // 360][0].nr - 1, math.radians(degrees)
    x, y = (moved.components[k].vec[vertex] for k in (0, 1))
    values.append(x * math.cos(angle) + y * math.sin(angle))
job.done(ng.__version__, values, unknowns=space.ndof)
