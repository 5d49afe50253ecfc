"""The methods beside each other: explicit dynamics against closed forms and against contact dynamics."""
from . import law
from .claims import is_below, is_equal, is_reported
from .lattices import LATTICES, X0
from .program import base_case, random_dense, with_keys

METHODS = ("contact-dynamics", "quasi-static", "mean-field", "verlet")


def verlet(factor):
    return {"name": "verlet", "density_factor": factor}


def explicit_pair(workshop):
    """Two free spheres by explicit steps at falling density factors."""
    claims, x0 = [], 0.2
    time = law.tau_of_neck(0.3, x0) * law.time_scale()
    spheres = [(0.0, 0.0, 0.0, law.RADIUS), (2 * law.RADIUS, 0.0, 0.0, law.RADIUS)]
    for factor in (1e14, 1e13, 1e12):
        case = with_keys(base_case(), contact={"initial_neck_ratio": x0}, method=verlet(factor), stop={"time": time})
        obtained = workshop.run(case, spheres).final()["neck_ratio_mean"]
        claims.append(is_equal(f"two spheres, Verlet, density factor {factor:.0e}: x", 0.3, obtained, factor * 2e-17))
    return claims


def lattices_by_all_methods(workshop):
    """Density of three lattices at x = 0.5: largest error over the lattices, a claim for each method."""
    claims = []
    for method in METHODS:
        errors = []
        for kind, count, density in LATTICES:
            keys = verlet(1e14) if method == "verlet" else {"name": method}
            case = with_keys(base_case(), packing={"generate": kind, "count": count, "radius": law.RADIUS},
                             cell={"kind": "periodic"}, method=keys, stop={"time": law.tau_of_neck(0.5, X0) * law.time_scale()},
                             contact={"initial_neck_ratio": X0, "sliding_resistance": 0.01})
            errors.append(abs(workshop.run(case).final()["relative_density"] / law.lattice_density(density, 0.5, X0) - 1))
        claims.append(is_below(f"sc, bcc, fcc by {method}: density at x = 0.5", "largest error", max(errors), 2e-4))
    return claims


def shrinkage(result):
    final = result.final()
    return -100 * sum(final[f"linear_strain_{axis}"] for axis in "xyz") / 3


def alumina_ball(workshop):
    """4,000 spheres of 50 nm at 1473 K for 0.3 s: Verlet meets contact dynamics as the factor falls."""
    claims = []
    for spins in ("free", "blocked"):
        case = with_keys(random_dense(4000), packing={"radius": 50e-9}, temperature={"start": 1473.0},
                         contact={"spins": spins}, stop={"time": 0.3})
        case["material"] = {"use": "alumina"}
        reference = shrinkage(workshop.run(with_keys(case, method={"accuracy": 1e-3})))
        values = {factor: shrinkage(workshop.run(with_keys(case, method=verlet(factor)), longest=600.0))
                  for factor in (1e18, 1e17, 1e16, 1e15)}
        told = ", ".join(f"{value:.3f} at {factor:.0e}" for factor, value in values.items())
        name = f"4,000 alumina spheres, spins {spins}"
        claims.append(is_reported(f"{name}: shrinkage in %", f"contact dynamics {reference:.3f}", told))
        gaps = [reference - value for value in values.values()]
        claims.append(is_below(f"{name}: gap of Verlet to contact dynamics", "largest ratio of a gap to that at ten times the factor",
                               max(abs(b) / abs(a) for a, b in zip(gaps, gaps[1:])), 0.5))
        claims.append(is_equal(f"{name}: shrinkage by Verlet at 1e15", reference, values[1e15], 0.01))
    return claims
