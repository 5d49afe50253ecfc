"""ParaView shows a result with the script that is shipped.

Skipped without pvpython, whose Debian package excludes python3-vtk9.
"""

import os
import pathlib
import subprocess

from sample import run_case, skip

PVPYTHON = os.environ["FRIT_PVPYTHON"]
if not pathlib.Path(PVPYTHON).is_file():
    skip("pvpython (paraview, python3-paraview) is not installed")
if "DISPLAY" not in os.environ:
    skip("there is no display; run it under xvfb-run")

HERE = pathlib.Path(__file__).parent
with run_case() as folder:
    script = HERE / "inside_paraview.py"
    done = subprocess.run([PVPYTHON, script, folder / "snapshots.pvd"], capture_output=True, text=True, timeout=300)
    print(done.stdout, done.stderr)
    assert done.returncode == 0 and "to scale" in done.stdout, "the script of ParaView failed"
    picture = folder / "packing.png"
    shipped = pathlib.Path(os.environ["FRIT_SOURCE"], "share/paraview/frit_packing.py")
    subprocess.run([PVPYTHON, shipped, folder / "snapshots.pvd", picture], check=True, timeout=300)
    assert picture.read_bytes().startswith(b"\x89PNG")
