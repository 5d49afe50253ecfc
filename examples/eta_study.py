"""A parameter study: how the sliding resistance eta changes densification and rearrangement.

PYTHONPATH=build/release/python python3 examples/eta_study.py [FOLDER]     a few seconds; writes FOLDER/eta.png
"""

import pathlib
import sys

import matplotlib
import numpy

import frit

CASE = """
[packing]
generate = "random-dense"
count = 800
radius = "5 um"
[cell]
kind = "periodic"
[material]
use = "copper"
[stop]
relative_density = 0.80
"""
ETAS = [0.001, 0.01, 0.1]


def at_density(series, column, density):
    return numpy.interp(density, series["relative_density"], series[column])


def main(folder):
    matplotlib.use("Agg")  # no display is needed
    folder.mkdir(parents=True, exist_ok=True)
    case = frit.parse_case(CASE)
    runs = [frit.run(case.with_overrides({"contact.sliding_resistance": eta})) for eta in ETAS]

    print("eta      time to 0.70   pair ratio at 0.70")
    for eta, run in zip(ETAS, runs):
        time = at_density(run.series, "time", 0.70)
        ratio = at_density(run.series, "rearrangement_pair_ratio", 0.70)
        print(f"{eta:<8} {time:8.1f} s     {ratio:.3f}")

    from matplotlib import pyplot
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4), layout="constrained")
    labels = [f"eta {eta}" for eta in ETAS]
    frit.plot(runs, labels=labels, ax=left)
    frit.plot(runs, y="rearrangement_pair_ratio", x="relative_density", labels=labels, ax=right)
    figure.savefig(folder / "eta.png")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "results/eta_study"))
