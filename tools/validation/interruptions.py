"""Runs killed at random moments, and with every call of the system failing once: tests/app/test_resume.py at length."""
import os
import pathlib
import re
import subprocess
import sys

from . import program
from .claims import Claim

ROOT = pathlib.Path(__file__).resolve().parents[2]
KILLS = 200


def at_length(name, test, pattern, **environment):
    """The claim that a test holds at length; `pattern` finds in its output what it did."""
    environment = {"FRIT": str(program.PROGRAM), "FRIT_CASES": str(ROOT / "cases"), "FRIT_KILLS": str(KILLS), **environment}
    done = subprocess.run([sys.executable, ROOT / "tests" / "app" / "test_resume.py", test], capture_output=True, text=True,
                          check=False, env={**os.environ, **environment}, timeout=600)
    did = re.search(pattern, done.stdout)
    said = did.group(0) if did else (done.stderr.strip().splitlines() or ["nothing said"])[-1]
    return Claim(name, "the bits of an uninterrupted run", said, "0", done.returncode == 0 and did is not None)


def kills(_workshop):
    return [at_length("SIGKILL at random moments, resumed", "Kills", r"[0-9]+ kills in [0-9]+ runs")]


def failing_calls(_workshop):
    shim = program.PROGRAM.parents[2] / "tests" / "app" / "libfailing_calls.so"
    test = "Machine.test_every_call_that_fails_is_told_and_costs_nothing"
    return [at_length("every write, flush, rename, opening fails once, resumed", test, r"[0-9]+ of [0-9]+ calls failed",
                      FRIT_SHIM=str(shim))]
