"""Runs the built program in a folder of its own and looks at what comes out."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["FRIT"]
CASES = pathlib.Path(os.environ["FRIT_CASES"])

PAIR = "x [um],y [um],z [um],radius [um]\n0,0,0,5\n10,0,0,5\n"
CASE = """
[packing]
file = "packing.csv"
[material]
use = "copper"
[contact]
initial_neck_ratio = 0.05
[stop]
time = "60 s"
[output]
every_time = "10 s"
"""
LATTICE = """
[packing]
generate = "simple-cubic"
count = 8
[cell]
kind = "periodic"
[material]
use = "copper"
[stop]
relative_density = 0.6
"""


class ProgramTest(unittest.TestCase):
    parent = None  # of the test's folder

    def setUp(self):
        self._folder = tempfile.TemporaryDirectory(prefix="frit-app-", dir=self.parent)
        self.folder = pathlib.Path(self._folder.name)
        self.write("packing.csv", PAIR)
        self.write("pair.toml", CASE)
        self.write("lattice.toml", LATTICE)

    def tearDown(self):
        self._folder.cleanup()

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def frit(self, *arguments, code=0, **options):
        """Runs the program; its exit code must be `code`."""
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, capture_output=True,
                              text=True, timeout=120, **options)
        self.assertEqual(done.returncode, code, f"frit {arguments}: {done.stdout}\n{done.stderr}")
        return done

    def names(self):
        """What is in the folder beside what setUp put there."""
        return sorted({p.name for p in self.folder.iterdir()} - {"packing.csv", "pair.toml", "lattice.toml"})

    def assert_fault(self, done, *words):
        """One line of standard error has all the words; every line has the program's prefix."""
        lines = done.stderr.splitlines()
        for line in lines:
            self.assertTrue(line.startswith("frit: "), line)
        if not any(all(word in line for word in words) for line in lines):
            self.fail(f"no line with {words} in:\n{done.stderr}")

    def summary(self, folder):
        return json.loads((self.folder / folder / "summary.json").read_text())

    def series(self, folder):
        """Columns of series.csv by name, as text."""
        lines = (self.folder / folder / "series.csv").read_text().splitlines()
        names = lines[0].split(",")
        rows = [line.split(",") for line in lines[1:]]
        return {name: [row[n] for row in rows] for n, name in enumerate(names)}
