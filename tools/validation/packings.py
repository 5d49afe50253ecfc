"""Random packings: two solvers, symmetries of space, thread counts, order of convergence."""
import itertools
import math
import random
import statistics

from . import law
from .claims import Claim, is_above, is_below, is_reported
from .program import base_case, fixed_steps, random_dense, with_keys

RELATIVE_DIFFERENCE = "rms difference of positions / rms motion"


def time_to(x, x0=0.0):
    """Time [s] in which two free spheres grow their neck from x0 to x."""
    return law.tau_of_neck(x, x0) * law.time_scale()


def positions(result, number=-1):
    """Centres [m] in the order of the stable ids."""
    arrays = result.snapshot("particles", number)
    return [point for _, point in sorted(zip(arrays["id"], arrays["Points"]))]


def rms_difference(first, second):
    return math.sqrt(sum(math.dist(a, b)**2 for a, b in zip(first, second)) / len(first))


def without_drift(points):
    """The same points about their mean."""
    mean = [sum(point[axis] for point in points) / len(points) for axis in range(3)]
    return [tuple(point[axis] - mean[axis] for axis in range(3)) for point in points]


def grown_necks(result):
    """Neck radius of every contact by its particles, for contacts there from the start."""
    contacts = result.snapshot("contacts")
    return {(i, j): r for i, j, r, age in zip(contacts["i"], contacts["j"], contacts["neck_radius [m]"], contacts["age [s]"])
            if age >= 0.999 * result.final()["time [s]"]}


def two_solvers(workshop):
    """Newton with conjugate gradients and Gauss-Seidel grow the same necks in 500 spheres.

    Necks and not positions: where a rattler stops between closing gaps takes no force that a tolerance could see, and
    the angular momentum of a free body turns with it; without bending, grains on two or three necks also move along
    mechanisms that hardly anything resists. So the figures of free bodies are told and not judged.
    """
    claims = []
    for kind, steps, bending in (("periodic", 1, False), ("periodic", 1, True), ("free", 1, True), ("free", 1, False)):
        # The accuracy makes the first solve of a step, whose geometry the second one uses, as exact as that.
        contact = {"initial_neck_ratio": 0.3, "neck_bending": bending}
        case = with_keys(random_dense(500), cell={"kind": kind}, contact=contact)
        timing = dict(total=time_to(0.4, 0.3), steps=steps, tolerance=1e-10, accuracy=1e-8)
        first, second = (grown_necks(workshop.run(with_keys(case, **fixed_steps(**timing, solver=solver))))
                         for solver in ("conjugate-gradients", "gauss-seidel"))
        difference = math.sqrt(statistics.fmean((second[pair] / first[pair] - 1) ** 2 for pair in first))
        name = f"two solvers, 500 spheres, {kind}, neck bending {'on' if bending else 'off'}"
        what = "rms relative difference of the necks"
        if kind == "free":
            claims.append(is_reported(name, what, f"{difference:.1e}"))
        else:
            claims.append(is_below(name, what, difference, 1e-6))
    return claims


def rotation():
    """A rotation matrix without special directions, from the unit quaternion (1, 2, 3, 4)/sqrt(30)."""
    a, b, c, d = (n / math.sqrt(30) for n in (1, 2, 3, 4))
    return [[a*a + b*b - c*c - d*d, 2 * (b*c - a*d), 2 * (b*d + a*c)],
            [2 * (b*c + a*d), a*a - b*b + c*c - d*d, 2 * (c*d - a*b)],
            [2 * (b*d - a*c), 2 * (c*d + a*b), a*a - b*b - c*c + d*d]]


def turned(point):
    return tuple(sum(row[axis] * point[axis] for axis in range(3)) for row in rotation())


def shifted(point):
    return (point[0] + 2e-4, point[1] - 1e-4, point[2] + 3e-4)


SYMMETRY_SEEDS = (1, 2, 3)


def neck_difference(necks, wanted):
    return math.sqrt(statistics.fmean((necks[pair] / wanted[pair] - 1) ** 2 for pair in wanted))


def symmetries(workshop):
    """Shift, rotation and relabelling of 500 spheres change nothing but what they must.

    Necks are judged, as between the two solvers: where a loosely held grain stops takes no force that a tolerance could see, so
    positions follow round-off, by 1e-7 to 4e-5 of the motion from one packing to another; they are told.
    """
    necks, places = {}, {}
    for seed in SYMMETRY_SEEDS:
        spheres = workshop.pack(with_keys(random_dense(500), packing={"seed": seed}))
        case = with_keys(base_case(), contact={"sliding_resistance": 0.01}, **fixed_steps(time_to(0.25), 4, tolerance=1e-9))
        plain = workshop.run(case, spheres)
        expected, moved = positions(plain), rms_difference(positions(plain), positions(plain, 0))
        order = random.Random(1).sample(range(len(spheres)), len(spheres))
        same = range(len(spheres))
        variants = {
            "shift": ([(*shifted(s[:3]), s[3]) for s in spheres], [shifted(p) for p in expected], same),
            "rotation": ([(*turned(s[:3]), s[3]) for s in spheres], [turned(p) for p in expected], same),
            "relabelling": ([spheres[n] for n in order], [expected[n] for n in order], order),
        }
        wanted = {frozenset(pair): neck for pair, neck in grown_necks(plain).items()}
        for name, (changed, there, was) in variants.items():
            result = workshop.run(case, changed)
            found = {frozenset((was[int(i)], was[int(j)])): neck for (i, j), neck in grown_necks(result).items()}
            necks[name] = max(necks.get(name, 0.0), neck_difference(found, wanted))
            places[name] = max(places.get(name, 0.0), rms_difference(positions(result), there) / moved)
    claims = []
    for name in necks:
        told = f"{name} of 500 spheres, 4 steps, the worst of {len(SYMMETRY_SEEDS)} packings"
        claims.append(is_below(told, "rms relative difference of the necks", necks[name], 1e-6))
        claims.append(is_reported(told, RELATIVE_DIFFERENCE, f"{places[name]:.1e}"))
    return claims


def thread_counts(workshop):
    """series.csv is byte-equal for 1 and 2 threads (3,000 spheres: three blocks of work)."""
    case = with_keys(random_dense(3000), stop={"time": time_to(0.2)}, output={"every_steps": 1})
    one, two = (workshop.run(case, threads=threads).folder / "series.csv" for threads in (1, 2))
    equal = one.read_bytes() == two.read_bytes()
    name, obtained = "1 and 2 threads, 3,000 spheres: series.csv", "the same" if equal else "differ"
    return [Claim(name, "the same bytes", obtained, "exact", equal)]


def diluted_lattice(edge, seed):
    """A free face-centred cubic block, a tenth of its places empty, radii up to 2 % larger than touching: no other
    pair comes near."""
    source, spheres = random.Random(seed), []
    half = math.sqrt(2) * law.RADIUS
    for x, y, z in itertools.product(range(edge), repeat=3):
        if (x + y + z) % 2 == 0 and source.random() > 0.1:
            spheres.append((half * x, half * y, half * z, law.RADIUS * source.uniform(1.0, 1.02)))
    return spheres


def position_errors(results):
    """rms and median over particles of the difference from the last result, relative to the rms motion."""
    finest = without_drift(positions(results[-1]))
    moved = rms_difference(finest, without_drift(positions(results[-1], 0)))
    rms, median = [], []
    for result in results[:-1]:
        points = without_drift(positions(result))
        rms.append(rms_difference(points, finest) / moved)
        median.append(statistics.median(map(math.dist, points, finest)) / moved)
    return rms, median


def density_errors(results):
    """Differences from the last result's density, relative to its densification."""
    finest = results[-1].rows()
    gained = finest[-1]["relative_density"] - finest[0]["relative_density"]
    return [abs(result.final()["relative_density"] - finest[-1]["relative_density"]) / gained for result in results[:-1]]


def order_claims(workshop, name, spheres, counts, least_order):
    """Order of convergence of density and positions for fixed steps; the last of the counts is the reference. Without a
    least order the orders are told and not judged."""
    case = with_keys(base_case(), contact={"sliding_resistance": 0.01, "initial_neck_ratio": 0.3})
    results = [workshop.run(with_keys(case, **fixed_steps(time_to(0.4, 0.3), steps, tolerance=1e-10, accuracy=1e-7)), spheres)
               for steps in counts]
    rows = results[-1].rows()
    claims = [is_reported(f"{name}: necks born", "contacts at the end minus at the start",
                          f"{rows[-1]['contacts'] - rows[0]['contacts']:g}")]
    rms, median = position_errors(results)
    for what, errors in (("density", density_errors(results)), ("positions (rms)", rms), ("positions (median)", median)):
        order = math.log(errors[0] / errors[-1]) / math.log(counts[-2] / counts[0])
        told = f"{', '.join(map(str, counts[:-1]))} steps against {counts[-1]}: errors "
        told += ", ".join(f"{error:.1e}" for error in errors)
        if least_order is None:
            claims.append(is_reported(f"{name}: order of {what}", told, f"{order:.2f}"))
        else:
            claims.append(is_above(f"{name}: order of {what}", told, order, least_order))
    return claims


def order_without_births(workshop):
    name = "order, births impossible, diluted lattice of about 800"
    return order_claims(workshop, name, diluted_lattice(12, 1), (4, 8, 16, 128), 1.8)


def order_with_births(workshop):
    name = "order, births on, random packing of 1,000"
    return order_claims(workshop, name, workshop.pack(random_dense(1000)), (8, 16, 32, 64, 512), None)
