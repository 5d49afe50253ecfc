"""A run whose snapshots others read."""

import contextlib
import os
import pathlib
import subprocess
import sys
import tempfile

COUNT = 64
CASE = f"""
[packing]
generate = "random-dense"
count = {COUNT}
radius_spread = 0.2
[cell]
kind = "periodic"
[material]
use = "copper"
[stop]
relative_density = 0.70
[output]
formats = ["vtp", "xyz", "lammps"]
every_density = 0.02
"""


@contextlib.contextmanager
def run_case():
    """The folder of the results, while it lasts."""
    with tempfile.TemporaryDirectory(prefix="frit-interop-") as name:
        folder = pathlib.Path(name)
        (folder / "case.toml").write_text(CASE)
        subprocess.run([os.environ["FRIT"], "run", "case.toml", "-o", "out", "--quiet"], cwd=folder, check=True)
        yield folder / "out"


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(77)


def series(folder):
    """Columns of series.csv by name."""
    lines = [line.split(",") for line in (folder / "series.csv").read_text().splitlines()]
    return {name: [row[n] for row in lines[1:]] for n, name in enumerate(lines[0])}
