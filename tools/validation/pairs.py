"""Two spheres, and a chain of them: every answer is a closed form."""
import math

from . import law
from .claims import Claim, has_failed, is_below, is_equal
from .program import RunFailed, base_case, fixed_steps, with_keys

STEPS = (1, 2, 10, 1000)


def touching(*radii):
    """Spheres in a row along x that just touch."""
    spheres, x = [], 0.0
    for n, radius in enumerate(radii):
        x += (radii[n - 1] if n else 0.0) + radius
        spheres.append((x, 0.0, 0.0, radius))
    return spheres


def necked(x0, **contact):
    return with_keys(base_case(), contact={"initial_neck_ratio": x0, **contact})


def distance(arrays):
    return math.dist(*arrays["Points"][:2])


def growth_of_a_pair(workshop, radii):
    """x^6 = x0^6 + 54 tau and approach (r^2 - r0^2)/(2R), for any number of steps."""
    name = "two equal spheres" if radii[0] == radii[1] else "two unequal spheres"
    R, spheres, x0, x1 = law.equivalent(*radii), touching(*radii), 0.03, 0.5
    total = law.tau_of_neck(x1, x0) * law.time_scale(R)
    neck_error = approach_error = 0.0
    for steps in STEPS:
        result = workshop.run(with_keys(necked(x0), **fixed_steps(total, steps)), spheres)
        neck_error = max(neck_error, abs(result.final()["neck_ratio_mean"] / x1 - 1))
        moved = distance(result.snapshot("particles", 0)) - distance(result.snapshot("particles"))
        approach_error = max(approach_error, abs(moved / (R / 2 * (x1**2 - x0**2)) - 1))
    told = f"x 0.03 to 0.5 in {', '.join(map(str, STEPS))} steps, largest error"
    return [is_below(f"{name}: neck follows x^6 = x0^6 + 54 tau", told, neck_error, 1e-6),
            is_below(f"{name}: approach is (r^2 - r0^2)/(2R)", told, approach_error, 1e-6)]


def growth_equal(workshop):
    return growth_of_a_pair(workshop, (law.RADIUS, law.RADIUS))


def growth_unequal(workshop):
    return growth_of_a_pair(workshop, (law.RADIUS, 2 * law.RADIUS))


def times_of_paper(workshop):
    """The listed dimensionless times at which x is 0.3, 0.5, 0.7, from a neck of almost nothing."""
    claims = []
    for x, tau in ((0.3, 1.350e-5), (0.5, 2.894e-4), (0.7, 2.179e-3)):
        case = with_keys(necked(1e-3), stop={"time": tau * law.time_scale()})
        result = workshop.run(case, touching(law.RADIUS, law.RADIUS))
        claims.append(is_equal(f"two spheres, tau = {tau:.3e}, automatic steps: x", x, result.final()["neck_ratio_mean"], 2e-4))
    return claims


def load_on(force):
    """Particle 0 is pushed towards +x by `force` [N], particle 1 the other way."""
    return [{"ids": [0], "force": [force, 0.0, 0.0]}, {"ids": [1], "force": [-force, 0.0, 0.0]}]


def loaded(workshop):
    """Under a load P the neck follows f_a + P; pulled beyond f_a it thins."""
    claims, x0 = [], 0.3
    for ratio, total in ((2.0, 100.0), (-0.5, 100.0), (-1.5, 10.0)):
        load = ratio * law.attraction()
        case = with_keys(necked(x0), particles=load_on(load), **fixed_steps(total, 3))
        obtained = workshop.run(case, touching(law.RADIUS, law.RADIUS)).final()["neck_ratio_mean"]
        claims.append(is_equal(f"two spheres under P = {ratio:g} f_a: x", law.neck_under_load(load, total, x0), obtained, 1e-6))
    return claims


def pulled_open(workshop):
    """A unilateral contact opens when pulled beyond f_a."""
    case = with_keys(necked(0.3, pull="unilateral"), particles=load_on(-1.5 * law.attraction()), **fixed_steps(1e-7, 1))
    left = workshop.run(case, touching(law.RADIUS, law.RADIUS)).final()["contacts"]
    return [Claim("two spheres pulled by 1.5 f_a, unilateral: necks left", "0", f"{left:g}", "exact", left == 0)]


def equilibrium(workshop):
    """Growth ends at sin(psi/2) and stays there for ten decades of time, without chatter."""
    total = 1e10 * law.tau_of_neck(law.EQUILIBRIUM) * law.time_scale()
    case = with_keys(necked(0.03), stop={"time": total}, output={"every_steps": 1})
    result = workshop.run(case, touching(law.RADIUS, law.RADIUS))
    necks = [row["neck_ratio_mean"] for row in result.rows()]
    back = max(before - after for before, after in zip(necks, necks[1:]))
    force = abs(result.snapshot("contacts")["normal_force [N]"][0]) / law.attraction()
    reached = [number for number, x in enumerate(necks) if abs(x / law.EQUILIBRIUM - 1) < 1e-9]
    left = max((abs(x / law.EQUILIBRIUM - 1) for x in necks[reached[0]:]), default=0.0) if reached else math.inf
    return [is_equal("equilibrium: x after ten decades", law.EQUILIBRIUM, necks[-1], 1e-9),
            is_below("equilibrium: neck never leaves it once reached", "largest deviation", left, 1e-9),
            is_below("equilibrium: neck never shrinks", "largest decrease of x in a step", back, 1e-9),
            is_below("equilibrium: force at rest", "|f_n| / f_a at the end", force, 1e-6)]


def parhami_mcmeeking(workshop):
    """The times of the other attraction, under refinement: second order in the step."""
    x0, x1, errors = 0.1, 0.7, []
    total = law.tau_parhami_mcmeeking(x1, x0) * law.time_scale()
    spheres = touching(law.RADIUS, law.RADIUS)
    for steps in (10, 100, 1000):
        case = with_keys(necked(x0, attraction="parhami-mcmeeking"), **fixed_steps(total, steps))
        errors.append(abs(workshop.run(case, spheres).final()["neck_ratio_mean"] / x1 - 1))
    claims = [is_below("Parhami-McMeeking: x = 0.7 by 10, 100, 1000 equal steps",
                       f"error {errors[0]:.1e}, {errors[1]:.1e} and", errors[2], 1e-4)]
    for x, tau in ((0.3, 4.937e-6), (0.5, 1.005e-4), (0.7, 7.204e-4)):
        case = with_keys(necked(1e-3, attraction="parhami-mcmeeking"), method={"time_step": tau * law.time_scale() / 400},
                         stop={"time": tau * law.time_scale()})
        claims.append(is_equal(f"Parhami-McMeeking, tau = {tau:.3e}: x", x,
                               workshop.run(case, spheres).final()["neck_ratio_mean"], 2e-4))
    return claims


def chain(workshop):
    """Eight spheres with their real mass: each neck as two free spheres, for any fixed step."""
    x0, claims = 0.3, []
    for step, steps in ((1e-8, 50), (1e-6, 50), (1e-3, 50), (1.0, 50), (100.0, 5)):
        case = with_keys(necked(x0), **fixed_steps(steps * step, steps))
        name = f"chain of 8, real mass, steps of {step:g} s: neck growth"
        try:
            result = workshop.run(case, touching(*[law.RADIUS] * 8))
        except RunFailed as failure:
            claims.append(has_failed(name, str(failure)))
            continue
        growth = 54 * steps * step / law.time_scale()
        necks = [r / law.RADIUS for r in result.snapshot("contacts")["neck_radius [m]"]]
        neck_error = max(abs(x / law.neck_of_tau(growth / 54, x0) - 1) for x in necks)
        growth_error = max(abs((x**6 - x0**6) / growth - 1) for x in necks)
        claims.append(is_below(name, f"largest error of x; of x^6 - x0^6: {growth_error:.1e}", neck_error, 1e-4))
    return claims
