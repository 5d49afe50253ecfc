"""ASE reads extended XYZ and LAMMPS dumps of every time; both have the numbers that `frit convert` takes from the VTP."""

import csv
import os
import subprocess

from sample import COUNT, run_case, series, skip

try:
    import ase.io
    import numpy
except ImportError:
    skip("python3-ase is not installed")


def particles_of(folder, number):
    """id to x, y, z, radius [m], by way of CSV."""
    vtp, table = folder / f"snapshots/particles_{number:06}.vtp", folder / "snapshot.csv"
    subprocess.run([os.environ["FRIT"], "convert", vtp, table], check=True, capture_output=True)
    with open(table, newline="") as file:
        rows = [[float(cell) for cell in row] for row in list(csv.reader(file))[1:]]
    return numpy.array(sorted(rows))


with run_case() as folder:
    rows = series(folder)
    strain = [float(value) for value in rows["linear_strain_x"]]
    first_edge = None
    for n, time in enumerate(rows["time [s]"]):
        ours = particles_of(folder, n)
        xyz = ase.io.read(folder / f"snapshots/particles_{n:06}.xyz", format="extxyz")
        dump = ase.io.read(folder / f"snapshots/particles_{n:06}.dump", format="lammps-dump-text", units="si")
        assert len(xyz) == len(dump) == COUNT
        assert numpy.array_equal(xyz.positions, ours[:, 1:4])  # the same bits
        assert numpy.array_equal(xyz.arrays["radius"], ours[:, 4])
        assert numpy.array_equal(xyz.arrays["id"], ours[:, 0])
        assert xyz.info["Time"] == float(time)
        assert xyz.pbc.all() and dump.pbc.all()
        metre = 1e10  # ASE turns SI units into angstrom
        assert numpy.allclose(dump.positions, ours[:, 1:4] * metre, rtol=1e-14)
        assert numpy.allclose(dump.cell.array, xyz.cell.array * metre, rtol=1e-14)
        first_edge = first_edge or xyz.cell.array[0, 0]
        assert abs(numpy.log(xyz.cell.array[0, 0] / first_edge) - strain[n]) < 1e-12
    print(f"{len(strain)} snapshots read by ASE {ase.__version__}")
