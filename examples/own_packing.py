"""A packing of one's own from NumPy arrays: a chain of two sizes of spheres, shrinking step by step.

PYTHONPATH=build/release/python python3 examples/own_packing.py     less than a second
"""

import numpy

import frit

CASE = """
[material]
use = "copper"
[contact]
initial_neck_ratio = 0.1
[temperature]
start = "1050 degC"
[stop]
time = "10 min"
"""


def make_chain(count, large, small):
    """Touching spheres along x, large and small in turn. Radii in m."""
    radii = numpy.where(numpy.arange(count) % 2 == 0, large, small)
    positions = numpy.zeros((count, 3))
    positions[1:, 0] = numpy.cumsum(radii[:-1] + radii[1:])
    return frit.Packing(positions, radii)


def main():
    case = frit.parse_case(CASE, packing=make_chain(count=20, large=5e-6, small=3e-6))
    simulation = frit.Simulation(case)
    start = simulation.state  # stays as it is, whatever the run does
    while simulation.step():
        now = simulation.state
        length = now.positions[-1, 0] - now.positions[0, 0]
        print(f"{now.time:8.2f} s   length {1e6 * length:7.3f} um   mean r/R {now.neck_ratios.mean():.3f}")
    moved = simulation.state.positions - start.positions
    print(f"the ends approached each other by {1e6 * (moved[0, 0] - moved[-1, 0]):.3f} um")


if __name__ == "__main__":
    main()
