"""What the study compares: times, necks and rearrangement of runs at equal density."""
import dataclasses
import json
import math

import numpy as np

TIME, DENSITY, NECK = "time [s]", "relative_density", "neck_ratio_mean"
PAIR_RATIO, DEVIATION = "rearrangement_pair_ratio", "rearrangement_deviation_mean"
KEPT = (TIME, DENSITY, NECK, PAIR_RATIO, DEVIATION, "rearrangement_d2min_mean", "non_affine_share", "coordination")


@dataclasses.dataclass
class Run:
    columns: dict  # name: array, one value per output
    steps: int
    cpu: float  # [s], of the steps
    wall: float  # [s]

    def at_density(self, name, density):
        """Linear between outputs, the time in its logarithm; NaN outside."""
        reached, values = self.columns[DENSITY], self.columns[name]
        if name == TIME:
            values = np.log(np.maximum(values, 1e-30))
        found = np.interp(density, reached[1:], values[1:], left=math.nan, right=math.nan)
        return float(np.exp(found)) if name == TIME else float(found)


def read(result):
    rows, summary = result.rows(), result.summary()
    columns = {name: np.array([row[name] for row in rows]) for name in KEPT}
    return Run(columns, summary["steps"], summary["cpu_s"]["step"], summary["wall_s"]["step"])


def extrapolated(ratios, values):
    """The value at x_c = 0 and the exponent p of value = limit + a x_c^p, through the three lowest ratios; no value
    where they do not approach a limit."""
    (r0, r1, r2), (y0, y1, y2) = ratios[:3], values[:3]
    first, second = y1 - y0, y2 - y1
    if first == 0.0 or second / first <= 1.0:
        return math.nan, math.nan
    low, high = 1e-3, 60.0
    for _ in range(200):
        p = 0.5 * (low + high)
        share = (r2**p - r1**p) / (r1**p - r0**p)
        low, high = (p, high) if share < second / first else (low, p)
    return y0 - first * r0**p / (r1**p - r0**p), p


def spoiled_below(verlet, reference, youngest):
    """Neck ratio of the reference's mean neck when Verlet's has caught up with 95 % of its growth."""
    times = reference.columns[TIME][1:]
    own = np.interp(times, verlet.columns[TIME], verlet.columns[NECK], right=math.nan)
    start = reference.columns[NECK][0]
    share = (own - start) / np.maximum(reference.columns[NECK][1:] - start, 1e-12)
    behind = np.nonzero(share < 0.95)[0]
    if behind.size == 0:
        return youngest
    last = behind[-1] + 1
    return float(reference.columns[NECK][1:][last]) if last < len(times) and np.isfinite(own[last]) else math.nan


class Study:
    """Runs by (name, eta), and the plan they were made by: a dictionary of what study.py decides."""

    def __init__(self, plan, runs):
        self.plan, self.runs = plan, runs
        self.ratios, self.etas = sorted(plan["ratios"]), sorted(plan["etas"])
        self.youngest, self.particles = plan["youngest"], plan["count"]
        self.factors = dict(zip(plan["ratios"], plan["factors"]))
        start = self.runs[("contact-dynamics", self.etas[0])].columns[DENSITY][0]
        self.end = plan["density"] - 1e-6
        self.middle = round(start + 0.5 * (self.end - start), 3)
        self.start = float(start)

    def run(self, name, eta):
        """The run of a method, None where the study has none."""
        return self.runs.get((name, max(self.etas) if name == "mean-field" else eta))

    def verlet(self, ratio, eta):
        return self.runs[(f"verlet {ratio:g}", eta)]


def save(study, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    runs = [{"name": name, "eta": eta, "steps": run.steps, "cpu": run.cpu, "wall": run.wall,
             "columns": {key: [None if math.isnan(v) else float(f"{v:.9g}") for v in values] for key, values in run.columns.items()}}
            for (name, eta), run in study.runs.items()]
    path.write_text(json.dumps({"plan": study.plan, "runs": runs}, indent=None) + "\n", encoding="utf-8")


def load(path):
    stored = json.loads(path.read_text(encoding="utf-8"))
    runs = {}
    for run in stored["runs"]:
        columns = {key: np.array([math.nan if v is None else v for v in values]) for key, values in run["columns"].items()}
        runs[(run["name"], run["eta"])] = Run(columns, run["steps"], run["cpu"], run["wall"])
    return Study(stored["plan"], runs)
