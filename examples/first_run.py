"""A first run: copper powder at 1050 degC, its density against time, its necks at the end.

PYTHONPATH=build/release/python python3 examples/first_run.py [FOLDER]     a few seconds; writes FOLDER/density.png
"""

import pathlib
import sys

import frit

CASE = """
title = "Copper, 10 um, 1050 degC"
[packing]
generate = "random-dense"
count = 1000
radius = "5 um"
[cell]
kind = "periodic"
[material]
use = "copper"
[stop]
relative_density = 0.85
"""


def tell(run):
    row = run.row
    print(f"{row['time']:8.1f} s   density {row['relative_density']:.3f}   coordination {row['coordination']:.2f}")


def main(folder):
    run = frit.run(frit.parse_case(CASE), folder, replace=True, on_row=tell)
    print(f"{run.ending.reason}: {run.counts['steps']} steps")

    state = run.state  # arrays in SI units, a row a particle or a contact
    pulled = state.normal_forces < 0.0
    print(f"{len(state.radii)} particles, {len(state.neck_radii)} necks, {pulled.mean():.0%} of them pulled apart")
    print(f"mean neck radius {1e6 * state.neck_radii.mean():.2f} um, mean r/R {state.neck_ratios.mean():.3f}")

    frit.plot(run).figure.savefig(folder / "density.png")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "results/first_run"))
