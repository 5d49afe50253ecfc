"""Figures of a run at given densities, and how far they are from those of a more accurate run."""
import bisect
import math

DENSITIES = (0.70, 0.80, 0.87)
PAIR_RATIO = "rearrangement_pair_ratio"
MEASURES = (PAIR_RATIO, "rearrangement_deviation_mean", "rearrangement_d2min_q50")


def cubic(points, x):
    """Value at x of the polynomial through the points (x, y), by Lagrange."""
    total = 0.0
    for place, (x_here, y_here) in enumerate(points):
        others = [x_other for number, (x_other, _) in enumerate(points) if number != place]
        total += y_here * math.prod((x - other) / (x_here - other) for other in others)
    return total


def at_density(rows, density, value):
    """value(row) at a density, by a cubic through the four nearest rows; None outside the run.

    A straight line would miss by up to a per cent in the logarithm of time at the usual steps.
    """
    points, densest = [], 0.0
    for row in rows:
        if row["relative_density"] > densest and row["time [s]"] > 0.0:
            densest = row["relative_density"]
            points.append((densest, value(row)))
    if not points or not points[0][0] <= density <= points[-1][0] * (1 + 1e-6):
        return None
    at = bisect.bisect_left([point[0] for point in points], density)
    first = max(0, min(at - 2, len(points) - 4))
    return cubic(points[first:first + 4], density)


def figures_at(rows, density, measures=(PAIR_RATIO,)):
    """Time [s], interpolated in its logarithm, and measures of rearrangement; None outside the run."""
    log_time = at_density(rows, density, lambda row: math.log(row["time [s]"]))
    if log_time is None:
        return None
    return {"time [s]": math.exp(log_time)} | {name: at_density(rows, density, lambda row: row[name]) for name in measures}


def differences(rows, accurate_rows, measures=(PAIR_RATIO,)):
    """Density -> relative differences [%] of a run from the accurate one, where both reach the density."""
    compared = {}
    for density in DENSITIES:
        here, there = (figures_at(of, density, measures) for of in (rows, accurate_rows))
        if here and there:
            compared[f"{density:.2f}"] = {name: 100 * (here[name] / there[name] - 1) for name in here}
    return compared
