"""Periodic lattices and the affine motion of equal necks: density by a closed form."""
import math

from . import law
from .claims import is_below, is_equal
from .program import base_case, with_keys

LATTICES = (("simple-cubic", 27, math.pi / 6), ("body-centred-cubic", 54, math.pi * math.sqrt(3) / 8),
            ("face-centred-cubic", 108, math.pi * math.sqrt(2) / 6))
X0 = 0.03


def density_claim(workshop, name, case, start_density, spheres=None):
    """The density at three times of a case whose spheres just touch, against the closed form."""
    errors = []
    for x in (0.3, 0.5, 0.6):  # all below a density of 1
        timed = with_keys(case, stop={"time": law.tau_of_neck(x, X0) * law.time_scale()})
        density = workshop.run(timed, spheres).final()["relative_density"]
        errors.append(abs(density / law.lattice_density(start_density, x, X0) - 1))
    return is_below(f"{name}: density", "largest error at x = 0.3, 0.5, 0.6", max(errors), 1e-4)


def lattices(workshop):
    claims = []
    for kind, count, density in LATTICES:
        case = with_keys(base_case(), packing={"generate": kind, "count": count, "radius": law.RADIUS},
                         cell={"kind": "periodic"}, contact={"initial_neck_ratio": X0, "sliding_resistance": 0.01})
        claims.append(density_claim(workshop, f"{kind}, periodic, no stress", case, density))
        if kind == "simple-cubic":
            claims += listed_times(workshop, case)
    return claims


def listed_times(workshop, case):
    claims = []
    for tau, density in ((9.304e-4, 0.7), (2.711e-3, 0.8), (5.343e-3, 0.9)):
        timed = with_keys(case, contact={"initial_neck_ratio": 1e-3}, stop={"time": tau * law.time_scale()})
        obtained = workshop.run(timed).final()["relative_density"]
        claims.append(is_equal(f"simple cubic, tau = {tau:.3e}: density", density, obtained, 1e-4))
    return claims


def hexagonal_layers(edge):
    """Spheres that touch 6 others in their layer and 2 in the layers above and below; the cell's edges."""
    R, spheres = law.RADIUS, []
    height = math.sqrt(3) * R
    for layer in range(edge):
        for row in range(2 * edge):
            for place in range(edge):
                spheres.append((2 * R * place + R * (row % 2), height * row, 2 * R * layer, R))
    return spheres, [2 * R * edge, 2 * edge * height, 2 * R * edge]


def mean_field(workshop):
    """The affine method on equal necks (D0 = 0.6046, nearest simple packing to the listed 0.60)."""
    spheres, edges = hexagonal_layers(3)
    density = math.pi / (3 * math.sqrt(3))
    case = with_keys(base_case(), cell={"kind": "periodic", "size": edges}, contact={"initial_neck_ratio": X0},
                     method={"name": "mean-field"})
    return [density_claim(workshop, "mean field of equal necks (hexagonal layers)", case, density, spheres)]
