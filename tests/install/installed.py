"""What must hold of an installed frit, wherever its files came from."""

import os
import pathlib
import subprocess
import tempfile
import unittest

BUILD = pathlib.Path(os.environ["FRIT_BUILD"])
SOURCE = pathlib.Path(os.environ["FRIT_SOURCE"])
HAS_PYTHON = os.environ["FRIT_HAS_PYTHON"] == "1"

CASE = """
[packing]
generate = "simple-cubic"
count = 27
[cell]
kind = "periodic"
[material]
use = "copper"
[stop]
relative_density = 0.55
"""


def run(*command, **options):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=500, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command} ended with {done.returncode}:\n{done.stdout}\n{done.stderr}")
    return done.stdout


class InstalledTest(unittest.TestCase):
    """Tests of self.prefix, the folder that holds bin and share. A class below sets it in setUpClass."""

    @classmethod
    def setUpClass(cls):
        cls._folder = tempfile.TemporaryDirectory(prefix="frit-install-")
        cls.folder = pathlib.Path(cls._folder.name)

    @classmethod
    def tearDownClass(cls):
        cls._folder.cleanup()

    def check_program(self):
        (self.folder / "case.toml").write_text(CASE)
        run(self.prefix / "bin/frit", "run", self.folder / "case.toml", "-o", self.folder / "out", "--quiet")
        self.assertIn("0.55", (self.folder / "out/series.csv").read_text().splitlines()[-1])

    def check_module(self):
        if not HAS_PYTHON:
            return
        code = "import frit; print(frit.run(frit.parse_case(open('case.toml').read())).row['relative_density'])"
        environment = {"PYTHONPATH": str(self.prefix / "lib/python3/dist-packages"), "PATH": "/usr/bin:/bin"}
        density = run("/usr/bin/python3", "-c", code, cwd=self.folder, env=environment)
        self.assertAlmostEqual(float(density), 0.55, 8)

    def check_pages(self):
        page = (self.prefix / "share/man/man1/frit.1").read_text()
        commands = run(self.prefix / "bin/frit", "--help").split("Subcommands:")[1].splitlines()
        for name in [line.split()[0] for line in commands if line.strip()]:
            self.assertIn(f"\n.SS {name}\n", page)
        keys = (self.prefix / "share/man/man5/frit-case.5").read_text().replace("\\-", "-")
        for line in run(self.prefix / "bin/frit", "describe").splitlines()[2:]:
            self.assertIn(f"\n.B {line.split()[0]}\n", keys)

    def complete(self, *words):
        """What bash offers for the last of the words."""
        script = self.prefix / "share/bash-completion/completions/frit"
        before = words[-2]
        quoted = " ".join(f"'{word}'" for word in words)
        code = (f"source {script}; COMP_WORDS=({quoted}); COMP_CWORD={len(words) - 1}; "
                f"_frit frit '{words[-1]}' '{before}' 2>/dev/null; echo ${{COMPREPLY[*]}}")
        return run("/bin/bash", "-c", code, cwd=self.folder).split()

    def check_completion(self):
        self.assertEqual(self.complete("frit", "re"), ["replay", "report", "resume"])
        self.assertIn("--threads", self.complete("frit", "run", "--"))
        self.assertNotIn("--threads", self.complete("frit", "check", "--"))
        self.assertEqual(self.complete("frit", "run", "case.toml", "--set", "stop."), ["stop.time=", "stop.relative_density="])
        self.assertEqual(self.complete("frit", "describe", "contact.pu"), ["contact.pull"])
