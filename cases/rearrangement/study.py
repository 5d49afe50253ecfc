#!/usr/bin/env python3
"""The same powder by four methods: what multiplied masses do to density and to rearrangement.

Runs contact dynamics, quasi-static, mean field and Verlet at several density factors on one packing with loose
regions, for several sliding resistances, and writes a page with plots. `--quick` takes about a minute.

The packing: a random dense packing of density 0.64 in a periodic cell; in spherical zones about particles drawn at
random a third of the particles is taken out. All necks, first ones and new ones, have a neck ratio of at least
YOUNGEST, so that the lowest factors can be chosen such that inertia matters for none of them (x_c below 0.8 of it).
"""
import argparse
import concurrent.futures
import dataclasses
import math
import pathlib
import random
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import measures  # noqa: E402
import pages  # noqa: E402
from validation import law, program  # noqa: E402

PACKED_DENSITY = 0.64
YOUNGEST = 0.15  # neck ratio of the youngest necks
ZONE_RADIUS, TAKEN_OUT = 4.0, 1 / 3  # of loose zones, in particle radii; share of their particles
ACCURACY = 1e-4  # of the implicit methods: rearrangement asks for more than density does
ACCURACY_AT_ZERO = 0.01  # with eta = 0, where a finer step takes minutes
LONGEST = 7200.0  # [s] of one run


@dataclasses.dataclass(frozen=True)
class Plan:
    """Sizes of a study."""
    particles: int
    zones: int
    density: float  # where runs stop
    ratios: tuple  # x_c over YOUNGEST, one Verlet run each
    etas: tuple = (0.0, 0.001, 0.01, 0.1)


FULL = Plan(particles=2500, zones=8, density=0.65, ratios=(0.79, 1.0, 1.25, 1.6, 2.0))
QUICK = Plan(particles=500, zones=3, density=0.64, ratios=(1.0, 1.25, 1.6), etas=(0.01, 0.1))
# The run repeated with other inertias of the cell: x_c over YOUNGEST, eta, and the inertias.
CELL_RATIO, CELL_ETA, CELL_INERTIAS = 1.25, 0.01, (0.1, 10.0)


def factor_of(x_c):
    """Density factor for which inertia governs necks below the neck ratio x_c (docs/theory.md, eq. 18)."""
    mass = 8960 * 4 / 3 * math.pi * law.RADIUS**3
    return x_c**10 * math.pi * law.RADIUS**8 / (432 * law.DELTA_B**2 * law.SURFACE_ENERGY * mass)


def edge_of(spheres):
    """Edge [m] of the generated cubic cell."""
    solid = sum(4 / 3 * math.pi * sphere[3]**3 for sphere in spheres)
    return (solid / PACKED_DENSITY)**(1 / 3)


def loosen(spheres, edge, zones, seed=1):
    """The spheres of a periodic cell without some of those in zones about random ones."""
    dice = random.Random(seed)
    reach = ZONE_RADIUS * spheres[0][3]
    centres = dice.sample(spheres, zones)

    def is_near(sphere, centre):
        apart = [sphere[k] - centre[k] - edge * round((sphere[k] - centre[k]) / edge) for k in range(3)]
        return sum(part * part for part in apart) < reach * reach

    def stays(sphere):
        return not any(is_near(sphere, centre) for centre in centres) or dice.random() >= TAKEN_OUT
    return [sphere for sphere in spheres if stays(sphere)]


def runs_of(plan):
    """(name, eta, keys of [method]) of every run, the longest first."""
    methods = [(f"verlet {ratio:g}", {"name": "verlet", "density_factor": factor_of(ratio * YOUNGEST)})
               for ratio in sorted(plan.ratios)]
    runs = [(name, eta, keys) for name, keys in methods for eta in sorted(plan.etas, reverse=True)]
    for eta in plan.etas:
        finest = ACCURACY if eta > 0 else ACCURACY_AT_ZERO
        runs += [(name, eta, {"name": name, "accuracy": finest}) for name in ("contact-dynamics", "quasi-static")]
        runs += [(f"contact-dynamics {accuracy:g}", eta, {"name": "contact-dynamics", "accuracy": accuracy})
                 for accuracy in (0.001, 0.01) if accuracy > finest]
    runs.append(("mean-field", max(plan.etas), {"name": "mean-field", "accuracy": ACCURACY}))
    factor = factor_of(CELL_RATIO * YOUNGEST)
    return runs + [(f"cell {inertia:g}", CELL_ETA, {"name": "verlet", "density_factor": factor, "cell_inertia": inertia})
                   for inertia in CELL_INERTIAS]


def make_runs(plan, workshop, jobs):
    """Results by (name, eta). Mean field, which no sliding resistance slows, has one run."""
    whole = workshop.pack(program.random_dense(plan.particles, cell={"kind": "periodic"}))
    edge = edge_of(whole)
    spheres = loosen(whole, edge, plan.zones)

    def run(name, eta, keys):
        case = program.with_keys(
            program.base_case(), cell={"kind": "periodic", "size": [edge] * 3}, method=keys, stop={"relative_density": plan.density},
            contact={"sliding_resistance": eta, "initial_neck_ratio": YOUNGEST, "birth_neck_ratio": YOUNGEST})
        case["output"] = {"every_density": 0.0025, "snapshots": False}
        result = measures.read(workshop.run(case, spheres, longest=LONGEST))
        print(f"{name}, eta {eta:g}: {result.steps} steps, {result.cpu:.1f} s", flush=True)
        return (name, eta), result
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        done = list(pool.map(lambda args: run(*args), runs_of(plan)))
    return dict(done), len(spheres)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="a small packing, a minute")
    parser.add_argument("--jobs", type=int, default=1, help="runs at the same time")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("rearrangement"),
                        help="folder of the page (default: ./rearrangement)")
    parser.add_argument("--page", action="store_true", help="only write the page again, from data.json of the folder")
    parser.add_argument("--program", type=pathlib.Path, help="the program (default: the release build)")
    arguments = parser.parse_args()
    if arguments.page:
        pages.write(measures.load(arguments.output / "data.json"), arguments.output)
        return 0
    if arguments.program:
        program.PROGRAM = arguments.program.resolve()
    if not program.PROGRAM.is_file():
        print(f"study: {program.PROGRAM} is not there; run ./dev build first", file=sys.stderr)
        return 2
    plan = QUICK if arguments.quick else FULL
    with tempfile.TemporaryDirectory(prefix="frit-study-") as folder:
        results, particles = make_runs(plan, program.Workshop(folder), arguments.jobs)
    study = measures.Study(dataclasses.asdict(plan) | {
        "youngest": YOUNGEST, "count": particles, "factors": [factor_of(ratio * YOUNGEST) for ratio in plan.ratios],
        "cell_ratio": CELL_RATIO, "cell_eta": CELL_ETA, "cell_inertias": CELL_INERTIAS}, results)
    measures.save(study, arguments.output / "data.json")
    pages.write(study, arguments.output)
    print(f"study: {arguments.output / 'results.md'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
