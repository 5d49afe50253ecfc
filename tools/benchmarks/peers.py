"""The same packing in a code of smooth dynamics: time per particle and step, and the steps that sintering would need.

The peer (LIGGGHTS) runs its own contact law on spheres at rest; only its time per step is taken. The number of steps
follows from the stability limit of explicit sintering along the run that frit has made.
"""
import math
import re
import shutil
import subprocess

from validation import law

from .starts import read_spheres

PACKAGE, PROGRAM = "liggghts", "liggghts"
WARM_UP, TIMED_STEPS = 200, 5_000
PEER_STEP = 1e-9  # [s]; short, so that the contacts stay those of the packing

COPPER_DENSITY = 8960.0  # [kg/m^3]
# Stability limit in units of m/c_n: measured on packings with eta 0.01; below SLOW_NECK the rotations of young necks
# limit it, about with the square of the neck ratio.
SLOW_LIMIT, SLOW_NECK = 0.28, 0.2
YOUNG_LIMIT, YOUNG_NECK = 0.017, 0.05
YOUNG_POWER = math.log(SLOW_LIMIT / YOUNG_LIMIT) / math.log(SLOW_NECK / YOUNG_NECK)
BIRTH_NECK = 0.03  # default of contact.birth_neck_ratio: the youngest necks of a run
SPARED_SHARE = 0.8  # of the youngest neck: inertia below this leaves the answer as it is
FACTOR_IN_USE = 1e12  # density factor of published studies

SCRIPT = """units si
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
read_data packing.data
neighbor {skin!r} bin
neigh_modify delay 0
fix young all property/global youngsModulus peratomtype 1e7
fix poisson all property/global poissonsRatio peratomtype 0.3
fix rebound all property/global coefficientRestitution peratomtypepair 1 0.3
fix rub all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
timestep {step!r}
fix motion all nve/sphere
thermo 1000
run {warm_up}
run {timed}
"""


def is_installed():
    return shutil.which(PROGRAM) is not None


def stability_limit(x):
    """Limit of the explicit step in units of m/c_n at the neck ratio x."""
    return SLOW_LIMIT if x >= SLOW_NECK else SLOW_LIMIT * (x / SLOW_NECK) ** YOUNG_POWER


def longest_explicit_step(x, radius, density_factor):
    """[s] at the neck ratio x: the limit times m/c_n, with c_n = pi (x R)^4/(8 Delta_b)."""
    mass = density_factor * COPPER_DENSITY * 4 / 3 * math.pi * radius**3
    return stability_limit(x) * mass * 8 * law.DELTA_B / (math.pi * (x * radius) ** 4)


def explicit_steps(rows, radius, density_factor):
    """Steps of the explicit method along a run: integral of dt/limit(x(t)) with the mean neck ratio, by trapezoids.

    The mean, though the oldest necks limit the step: that is in favour of the peer.
    """
    rates = [1 / longest_explicit_step(row["neck_ratio_mean"], radius, density_factor) for row in rows]
    times = [row["time [s]"] for row in rows]
    return sum((t1 - t0) * (r0 + r1) / 2 for t0, t1, r0, r1 in zip(times, times[1:], rates, rates[1:]))


def sparing_factor(x_youngest, radius):
    """Largest density factor at which inertia leaves necks from x_youngest on alone.

    Inertia matters below x_c = (432 Delta_b^2 gamma factor m/(pi R^8))^(1/10); asked is x_c = 0.8 x_youngest.
    """
    mass = COPPER_DENSITY * 4 / 3 * math.pi * radius**3
    at_factor_1 = 432 * law.DELTA_B**2 * law.SURFACE_ENERGY * mass / (math.pi * radius**8)
    return max(1.0, (SPARED_SHARE * x_youngest) ** 10 / at_factor_1)


def write_data(path, spheres):
    """The packing as the peer reads it: id, type, diameter, density, centre."""
    edge = 1.1 * max(abs(number) + sphere[3] for sphere in spheres for number in sphere[:3])
    bounds = "".join(f"{-edge!r} {edge!r} {axis}lo {axis}hi\n" for axis in "xyz")
    lines = [f"{n} 1 {2 * radius!r} {COPPER_DENSITY} {x!r} {y!r} {z!r}" for n, (x, y, z, radius) in enumerate(spheres, 1)]
    path.write_text(f"packing\n\n{len(spheres)} atoms\n1 atom types\n{bounds}\nAtoms\n\n" + "\n".join(lines) + "\n", encoding="utf-8")


def time_peer(folder, spheres):
    """(version, seconds per particle and step on one core). Throws CalledProcessError."""
    write_data(folder / "packing.data", spheres)
    script = SCRIPT.format(skin=0.2 * law.RADIUS, step=PEER_STEP, warm_up=WARM_UP, timed=TIMED_STEPS)
    said = subprocess.run([PROGRAM], input=script, cwd=folder, capture_output=True, text=True, check=True).stdout
    loops = re.findall(r"Loop time of (\S+) on 1 procs for (\d+) steps with (\d+) atoms", said)
    seconds, steps, atoms = loops[-1]
    if (int(steps), int(atoms)) != (TIMED_STEPS, len(spheres)):
        raise ValueError(f"the peer ran {steps} steps of {atoms} spheres, not {TIMED_STEPS} of {len(spheres)}")
    version = re.search(r"Version ([^,)]+)", said).group(1)
    return version, float(seconds) / (TIMED_STEPS * len(spheres))


def compare(workshop, start, figures, rows):
    """The entry of the comparison; figures and rows are of frit's run on one thread from that start."""
    spheres = read_spheres(start.packing)
    version, per_particle_step = time_peer(workshop.new_folder(), spheres)
    factors = {"true density": 1.0, "factor that keeps the answer": sparing_factor(BIRTH_NECK, law.RADIUS),
               "factor in use": FACTOR_IN_USE}
    entry = {
        "peer": version, "particles": len(spheres), "peer cpu per particle-step [us]": 1e6 * per_particle_step,
        "peer steps timed": TIMED_STEPS, "frit cpu [s]": figures["cpu [s]"], "frit steps": figures["steps"],
        "frit cpu per particle-step [us]": figures["cpu per particle-step [us]"], "sintering time [s]": rows[-1]["time [s]"],
        "arithmetic": "steps = integral of dt/limit(x(t)); limit = (m/c_n) min(0.28, 0.28 (x/0.2)^2.02), c_n = pi (x R)^4/(8 Delta_b), "
                      "m = factor * mass, x = mean neck ratio of frit's run; peer time = steps * particles * time per particle-step; "
                      "ratio = peer time/frit cpu; factor that keeps the answer: x_c = 0.8 * 0.03 (birth neck ratio), "
                      "x_c = (432 Delta_b^2 gamma factor m/(pi R^8))^0.1",
        "factors": {},
    }
    for name, factor in factors.items():
        steps = explicit_steps(rows, law.RADIUS, factor)
        seconds = steps * len(spheres) * per_particle_step
        entry["factors"][name] = {"density factor": factor, "peer steps": steps, "peer time [s]": seconds,
                                  "ratio": seconds / figures["cpu [s]"]}
    return entry
