"""A free ball of thousands of spheres from its first density to 0.87: no failed run, and not far from the mean field."""
import math

from .claims import has_failed, is_below, is_reported
from .program import RunFailed, base_case, random_dense, read_packing, with_keys

LATEST = {0.70: 0.10, 0.80: 0.05, 0.87: 0.05}  # how much later than the mean field, at most
LONGEST_BALL = 6 * 3600.0  # [s]
RATIO_DENSITIES = (0.70, 0.80, 0.87)


def at_density(rows, column, density):
    """The column where the density is first reached, linear between outputs; NaN when it is not reached."""
    for before, after in zip(rows, rows[1:]):
        if after["relative_density"] >= density * (1 - 1e-6):
            share = (density - before["relative_density"]) / (after["relative_density"] - before["relative_density"])
            return before[column] + share * (after[column] - before[column])
    return math.nan


def time_to(rows, density):
    """Time [s] to the density. Densification goes with about the cube root of time: linear in that."""
    roots = [{**row, "root": row["time [s]"]**(1 / 3)} for row in rows]
    return at_density(roots, "root", density)**3


def ball_case(sliding_resistance, **method):
    return with_keys(base_case(), contact={"sliding_resistance": sliding_resistance}, method=method,
                     stop={"relative_density": 0.87}, output={"every_density": 0.005})


def run_ball(workshop, spheres, sliding_resistance, **method):
    case = ball_case(sliding_resistance, **method)
    del case["output"]["every_steps"]
    return workshop.run(with_keys(case, output={"snapshots": False}), spheres, threads=2, longest=LONGEST_BALL)


def against_mean_field(name, rows, affine_rows):
    claims = []
    for density, limit in LATEST.items():
        later = time_to(rows, density) / time_to(affine_rows, density) - 1
        claims.append(is_below(f"{name}: later at D = {density:g} than the mean field", "(time - time of it) / time of it",
                               later, limit))
    return claims


def against_accurate(name, rows, accurate_rows):
    """Differences from a run with a tenth of the accuracy's number: reported, not judged."""
    late, ratio = [], []
    for density in RATIO_DENSITIES:
        late.append(time_to(rows, density) / time_to(accurate_rows, density) - 1)
        column = "rearrangement_pair_ratio"
        ratio.append(at_density(rows, column, density) / at_density(accurate_rows, column, density) - 1)
    at = "at D = " + ", ".join(f"{density:g}" for density in RATIO_DENSITIES)
    return [is_reported(f"{name}: time to D, accuracy 0.01 against 0.001", at, ", ".join(f"{value:+.1%}" for value in late)),
            is_reported(f"{name}: rearrangement_pair_ratio, the same", at, ", ".join(f"{value:+.1%}" for value in ratio))]


def free_ball(workshop, packing=None, accurate=True):
    """Claims for eta 0.01 and 0.1 on a generated ball of 10,000, or on the packing given."""
    spheres = read_packing(packing) if packing else workshop.pack(random_dense(10000))
    name = f"free body of {len(spheres):,} spheres"
    affine = run_ball(workshop, spheres, 0.01, name="mean-field", accuracy=0.001).rows()
    claims, ratios = [], {}
    for sliding_resistance in (0.01, 0.1):
        told = f"{name}, eta {sliding_resistance:g}"
        try:
            result = run_ball(workshop, spheres, sliding_resistance)
        except RunFailed as failure:
            claims.append(has_failed(told, str(failure)))
            continue
        rows, summary = result.rows(), result.summary()
        claims.append(is_reported(f"{told}: reached 0.87", "steps, Newton iterations, wall time",
                                  f"{summary['steps']}, {summary['newton_iterations']}, {summary['wall_s']['total']:.0f} s"))
        claims += against_mean_field(told, rows, affine)
        ratios[sliding_resistance] = rows
        if accurate:
            claims += against_accurate(told, rows, run_ball(workshop, spheres, sliding_resistance, accuracy=0.001).rows())
    return claims + ratio_claims(name, ratios)


def ratio_claims(name, rows_of):
    text = []
    for density in RATIO_DENSITIES:
        values = [f"{at_density(rows, 'rearrangement_pair_ratio', density):.3f} (eta {eta:g})" for eta, rows in rows_of.items()]
        text.append(f"D {density:g}: " + ", ".join(values))
    return [is_reported(f"{name}: rearrangement_pair_ratio", "falls as eta grows", "; ".join(text))]
