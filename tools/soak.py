#!/usr/bin/env python3
"""Many small runs in one process: the memory that stays in use must not grow.

PYTHONPATH=build/release/python /usr/bin/python3 tools/soak.py [--runs N]     one run in 50 writes a folder, one in 10 is refused

Resident memory is read after each run; its mean over the last tenth is compared with that over the second tenth (the first fills caches
and pools of threads), and a line is laid through all but the first tenth. Exits with 1 when it has grown by more than --most percent, or
when a run ends otherwise than it should. `--curve FILE` keeps the memory after each run.
"""
import argparse
import array
import gc
import os
import pathlib
import sys
import tempfile
import time

import frit

BASE = {"material.use": "copper", "temperature.start": "1050 degC", "output.report": False}
LATTICE = {"packing.generate": "simple-cubic", "packing.count": 27, "packing.radius": "5 um", "cell.kind": "periodic"}
DENSE = {"packing.generate": "random-dense", "packing.count": 60, "packing.radius": "5 um", "cell.kind": "periodic"}
KINDS = [  # what a run is asked for
    {**LATTICE, "stop.time": "10 s"},
    {**DENSE, "stop.relative_density": 0.7},
    {**DENSE, "stop.relative_density": 0.7, "contact.sliding_resistance": 0.0},
    {**LATTICE, "stop.time": "1 s", "method.name": "quasi-static"},
    {**DENSE, "stop.relative_density": 0.68, "method.name": "mean-field"},
    {**LATTICE, "stop.time": "0.01 s", "method.name": "verlet", "method.density_factor": 1e12},
    {**LATTICE, "stop.time": "5 s", "cell.stress": "-1 MPa"},
]
REFUSED = {**LATTICE, "packing.radius": "5 s", "stop.time": "a while", "output.colour": "red"}


def text_of(keys):
    """A case file with these keys."""
    return "\n".join(f"{key} = {value}" if not isinstance(value, (str, bool)) else
                     f'{key} = "{value}"' if isinstance(value, str) else f"{key} = {str(value).lower()}" for key, value in keys.items())


def resident():
    """Resident memory [bytes]."""
    return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def run_once(number, folder):
    """One small run; its number chooses the kind."""
    if number % 10 == 9:
        try:
            frit.parse_case(text_of({**BASE, **REFUSED}))
        except frit.InputError:
            return
        sys.exit("a wrong case was taken")
    keys = {**BASE, **KINDS[number % len(KINDS)], "packing.seed": 1 + number // len(KINDS)}
    if keys["packing.generate"] != "random-dense":
        del keys["packing.seed"]
    run = frit.run(frit.parse_case(text_of(keys)), folder if number % 50 == 0 else None, replace=True)
    if run.ending.code != 0:
        sys.exit(f"run {number} ended with {run.ending}")


def slope(memory, first):
    """Growth from run to run by least squares, from run `first` on [bytes]."""
    middle = (first + len(memory) - 1) / 2.0
    mean = sum(memory[first:]) / (len(memory) - first)
    away = [(number - middle, memory[number] - mean) for number in range(first, len(memory))]
    return sum(x * y for x, y in away) / sum(x * x for x, _ in away)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=2500, help="(default: %(default)s)")
    parser.add_argument("--most", type=float, default=1.0, help="growth that is allowed, in percent (default: %(default)s)")
    parser.add_argument("--curve", type=pathlib.Path, help="write the resident memory [bytes] after each run, a line each")
    arguments = parser.parse_args()
    memory = array.array("q", [0]) * arguments.runs  # of one size from the start: a growing list would be measured too
    with tempfile.TemporaryDirectory() as folder:
        for number in range(arguments.runs):
            run_once(number, folder)
            if number % 10 == 0:
                gc.collect()
            memory[number] = resident()
    if arguments.curve:
        arguments.curve.write_text("".join(f"{size}\n" for size in memory))
    tenth = arguments.runs // 10
    early, late = (sum(part) / len(part) for part in (memory[tenth:2 * tenth], memory[-tenth:]))
    growth = 100.0 * (late / early - 1.0)
    print(f"{arguments.runs} runs: {early / 1e6:.2f} MB after {tenth}, {late / 1e6:.2f} MB at the end: {growth:+.2f} %; "
          f"{slope(memory, tenth):+.1f} bytes a run; {time.process_time() / arguments.runs:.3f} s of processor time each")
    return 0 if growth <= arguments.most else 1


if __name__ == "__main__":
    sys.exit(main())
