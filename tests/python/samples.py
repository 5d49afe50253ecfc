"""What the tests of the module share: cases, folders, arrays that must be the same bits."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import frit

PROGRAM = os.environ["FRIT"]
SOURCE = pathlib.Path(os.environ["FRIT_SOURCE"])

CASE = """
[packing]
generate = "random-dense"
count = 300
radius_spread = 0.2
[cell]
kind = "periodic"
[material]
use = "copper"
[stop]
relative_density = 0.70
"""
PAIR = """
[material]
use = "copper"
[contact]
initial_neck_ratio = 0.05
[stop]
time = "60 s"
"""
TOUCHING = frit.Packing([[0, 0, 0], [1e-5, 0, 0]], 5e-6)


class FolderTest(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory(prefix="frit-python-")
        self.folder = pathlib.Path(self._folder.name)

    def tearDown(self):
        self._folder.cleanup()

    def run_program(self, *arguments):
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done
