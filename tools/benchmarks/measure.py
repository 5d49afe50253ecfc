"""Runs a benchmark case and takes its figures; optionally its distance from a more accurate run."""
import dataclasses
import os
import statistics
import time

from validation.program import RunFailed, with_keys

from .curves import DENSITIES, MEASURES, differences, figures_at

LONGEST_RUN = 7 * 24 * 3600.0  # [s]
REFERENCE_ACCURACY = 0.001
PATIENCE = 30.0  # times the run as it is, for one with something changed
COPPER_DENSITY = 8960.0  # [kg/m^3], of all cases
TIGHT_TOLERANCE = 5e-5  # of the accuracy: a hundredth of what "auto" takes (docs/config.md, method.tolerance)


@dataclasses.dataclass(frozen=True)
class Effort:
    """How a case is measured."""
    threads: int
    runs: int = 0  # 0: as many as the case wants
    reference: bool = False  # also one run at REFERENCE_ACCURACY
    independence: bool = False  # also runs with other masses and a tighter tolerance


def figures_of(summary, rows, wall, cpu):
    """Figures of one run; wall and cpu [s] are of the whole process, reading and writing included."""
    particles, steps, memory = summary["particles"], summary["steps"], summary["peak_memory_bytes"]
    return {
        "wall [s]": wall, "cpu [s]": cpu,
        "setup wall [s]": summary["wall_s"]["setup"], "step wall [s]": summary["wall_s"]["step"],
        "steps": steps, "rejected": summary["rejected_steps"], "Newton": summary["newton_iterations"],
        "linear": summary["solver_iterations"], "memory [MB]": memory / 1e6, "bytes per particle": memory / particles,
        "wall per step [s]": summary["wall_s"]["step"] / steps,
        "cpu per particle-step [us]": 1e6 * summary["cpu_s"]["step"] / (particles * steps),
        "contacts": statistics.fmean(row["contacts"] for row in rows),
    }


def run_once(workshop, case, threads, longest=LONGEST_RUN):
    """(figures, rows of the series, summary) of one run. Throws RunFailed."""
    before, begin = os.times(), time.perf_counter()
    result = workshop.run(case, threads=threads, longest=longest)
    wall, after = time.perf_counter() - begin, os.times()
    cpu = after.children_user - before.children_user + after.children_system - before.children_system
    rows, summary = result.rows(), result.summary()
    return figures_of(summary, rows, wall, cpu), rows, summary


def variations(keys):
    """Name -> the case with something changed that the answer must not depend on."""
    return {
        "mass x 10": with_keys(keys, material={"density": 10 * COPPER_DENSITY}),
        "mass / 10": with_keys(keys, material={"density": 0.1 * COPPER_DENSITY}),
        "tolerance / 100": with_keys(keys, method={"tolerance": TIGHT_TOLERANCE * keys["method"]["accuracy"]}),
    }


def independence(workshop, keys, rows, wall, threads):
    """Name of the variation -> density -> differences [%] of time and rearrangement from the run as it is, which took
    `wall` [s]; empty for a variation that has no end in sight."""
    found = {}
    for name, changed in variations(keys).items():
        try:
            _, changed_rows, _ = run_once(workshop, changed, threads, max(60.0, PATIENCE * wall))
            found[name] = differences(changed_rows, rows, MEASURES)
        except RunFailed:
            found[name] = {}
    return found


def measure(workshop, starts, case, effort):
    """The entry of a case for results/bench.json. Throws RunFailed."""
    keys = starts.of(case).keys(case.case_keys())
    runs = []
    for _ in range(effort.runs or case.runs()):
        figures, rows, summary = run_once(workshop, keys, effort.threads)
        runs.append(figures)
    entry = {
        "what": case.told(), "particles": summary["particles"], "accuracy": case.accuracy,
        "accuracy estimated": summary["accuracy_estimated"], "threads": summary["threads"], "machine": summary["machine"],
        "start density": rows[0]["relative_density"], "start coordination": rows[0]["coordination"],
        "median": {name: statistics.median(run[name] for run in runs) for name in runs[0]}, "runs": runs,
        "at density": {f"{density:.2f}": figures_at(rows, density) for density in DENSITIES},
    }
    if effort.independence:
        entry["independence [%]"] = independence(workshop, keys, rows, figures["wall [s]"], effort.threads)
    if effort.reference:
        keys["method"]["accuracy"] = REFERENCE_ACCURACY
        figures, accurate_rows, _ = run_once(workshop, keys, effort.threads)
        entry["reference"] = {"accuracy": REFERENCE_ACCURACY, "figures": figures,
                              "difference [%]": differences(rows, accurate_rows)}
    return entry
