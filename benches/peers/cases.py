"""The cases that every program is asked, in SI units, and their exact answers.

`turning`: a stepped shaft between two springs under a force that visits N nodes in turn. `ring`: a ring pressed by
three jaws, in plane stress. `heat`: a section heated on one edge and cooled on the others for 200 steps.
"""

import math
import types

import numpy as np

TURNING = types.SimpleNamespace(
    length=0.6,
    steps=[(0.0, 0.18, 0.040), (0.18, 0.42, 0.050), (0.42, 0.60, 0.040)],  # from, to, diameter
    youngs=210e9,
    poisson=0.3,
    density=7850.0,
    springs=(6e7, 4e7),  # at x = 0 and x = length, N/m
    joint=(2e-7, 0.5),  # c and n of y = c Q^n, m and N, instead of the springs
    force=500.0,
)
TURNING.shear = TURNING.youngs / (2 * (1 + TURNING.poisson))
TURNING.kappa = 6 * (1 + TURNING.poisson) / (7 + 6 * TURNING.poisson)  # Cowper, of a full circle

RING = types.SimpleNamespace(
    outer=0.05, inner=0.04, width=0.02, youngs=210e9, poisson=0.3, jaws=3, force=2000.0, half_arc=math.radians(5)
)
RING.pressure = RING.force / (RING.outer * 2 * RING.half_arc * RING.width)

HEAT = types.SimpleNamespace(
    length=0.10,
    height=0.05,
    conductivity=45.0,
    density=7850.0,
    specific_heat=470.0,
    flux=5e4,  # into x = 0
    film=100.0,  # on the other three edges
    ambient=20.0,  # also at the start
    expansion=12e-6,
    step=1.0,
    steps=200,
)

# Elements around and across of 8-node rings, and along and up of 4-node sections, by unknowns.
RING_CELLS = {"20k": (288, 11), "100k": (648, 25), "500k": (1440, 57)}
HEAT_CELLS = {"20k": (200, 100), "100k": (450, 225), "500k": (1000, 500)}
# Angles at which the bore is compared.
BORE_DEGREES = (0, 30, 60)


def diameter(x):
    """Diameter at x, m."""
    return next(d for _, to, d in TURNING.steps if x <= to)


def area(d):
    """Area of a full circle, m2."""
    return math.pi * d**2 / 4


def inertia(d):
    """Second moment of a full circle, m4."""
    return math.pi * d**4 / 64


def nodes(count):
    """Places of the tool, m: every node of `count` elements but the first."""
    return TURNING.length * np.arange(1, count + 1) / count


def turning(x, theory="euler-bernoulli", joints=False):
    """Deflection under the force at each x, m, by the unit-load method: the integrand is a polynomial between steps."""
    t, points = TURNING, (-math.sqrt(0.6), 0.0, math.sqrt(0.6))
    result = []
    for place in x:
        right = place / t.length
        loads = t.force * (1 - right), t.force * right
        ends = [t.joint[0] * q ** t.joint[1] if joints else q / k for q, k in zip(loads, t.springs)]
        y = (1 - right) * ends[0] + right * ends[1]
        cuts = sorted({0.0, place, *(to for _, to, _ in t.steps)})
        for a, b in zip(cuts, cuts[1:]):
            d = diameter((a + b) / 2)
            for point, weight in zip(points, (5 / 9, 8 / 9, 5 / 9)):
                s = (a + b) / 2 + point * (b - a) / 2
                moment = s * (1 - right) if s < place else place * (1 - s / t.length)
                flexibility = moment**2 / (t.youngs * inertia(d))
                if theory == "timoshenko":
                    cross = 1 - right if s < place else -right
                    flexibility += cross**2 / (t.kappa * t.shear * area(d))
                y += t.force * weight * (b - a) / 2 * flexibility
        result.append(y)
    return np.array(result)


def ring():
    """Outward displacement of the bore at BORE_DEGREES, m: Lame's solution and Michell's for every third harmonic."""
    r, ratio = RING, RING.inner / RING.outer
    mean = r.pressure * r.jaws * r.half_arc / math.pi
    b = -mean / (1 / r.outer**2 - 1 / r.inner**2)
    a = -b / r.inner**2
    u = np.full(len(BORE_DEGREES), ((1 - r.poisson) * a * r.inner - (1 + r.poisson) * b / r.inner) / r.youngs)
    for n in range(r.jaws, 600, r.jaws):
        amplitude = 2 * r.jaws * r.pressure * math.sin(n * r.half_arc) / (n * math.pi)
        # Stress function r^e cos(n theta) of each e, r in outer radii; columns scaled, for r^n is tiny at the bore.
        exponents = np.array([n, n + 2, -n, 2 - n])
        scale = np.maximum(ratio ** (exponents - 2.0), 1.0)

        def stresses(radius):
            power = radius ** (exponents - 2.0) / scale
            return (exponents - n**2) * power, n * (exponents - 1) * power

        bore, rim = stresses(ratio), stresses(1.0)
        c = np.linalg.solve(np.array([bore[0], rim[0], bore[1], rim[1]]), [0.0, -amplitude, 0.0, 0.0])
        strain = ((exponents - n**2) - r.poisson * exponents * (exponents - 1)) * ratio ** (exponents - 2.0) / scale
        u = u + np.cos(n * np.radians(BORE_DEGREES)) * float(c @ (strain / (exponents - 1))) * r.inner / r.youngs
    return u


def heat():
    """Temperature in the middle of the hot edge and mean temperature, degC, after all backward Euler steps.

    Exact in space: cosines in y; in x the steady state in closed form, and what is left of the cosines in x after
    `steps` divisions by 1 + step * rate, which vanishes fast.
    """
    h = HEAT
    biot, half = h.film / h.conductivity, h.height / 2
    capacity = h.density * h.specific_heat

    def roots(length, count):
        """The first roots a of a tan(a length) = biot, one in each half period in which the tangent is positive."""
        low = np.arange(count) * math.pi / length
        high = low + math.pi / 2 / length
        for _ in range(60):
            middle = (low + high) / 2
            below = middle * np.tan(middle * length) < biot
            low, high = np.where(below, middle, low), np.where(below, high, middle)
        return low

    def squared(a, length):
        """Integral of cos^2(a s) over 0 to length."""
        return length / 2 + np.sin(2 * a * length) / (4 * a)

    a, b = roots(h.length, 60), roots(half, 4000)
    share = np.sin(b * half) / (b * half)  # mean of cos(b y), y from the middle
    part = np.sin(b * half) / b / squared(b, half)  # of an even flux in cos(b y)

    # exp(-b x) + back exp(-b (2 length - x)) meets the cooled end.
    stiffness, fade = h.conductivity * b, np.exp(-b * h.length)
    back = (stiffness - h.film) / (stiffness + h.film)
    steady = h.flux / stiffness / (1 - back * fade**2)
    hot = steady * (1 + back * fade**2)
    total = steady * (1 - fade) * (1 + back * fade) / b

    rate = h.conductivity * (a**2 + b[:, None] ** 2) / capacity
    missing = h.flux / capacity / squared(a, h.length) / rate * (1 + h.step * rate) ** -float(h.steps)
    hot -= missing.sum(axis=1)
    total -= (missing * np.sin(a * h.length) / a).sum(axis=1)
    return h.ambient + np.array([part @ hot, (part * share) @ total / h.length])
