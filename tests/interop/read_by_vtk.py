"""VTK reads the collection, particles and contacts of every time; they fit series.csv."""

import math
import xml.etree.ElementTree

from sample import COUNT, run_case, series, skip

try:
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError:
    skip("python3-vtk9 is not installed")


def read(path):
    reader = vtkXMLPolyDataReader()
    faults = []
    reader.AddObserver("ErrorEvent", lambda *_: faults.append(path))
    reader.SetFileName(str(path))
    reader.Update()
    assert not faults, faults
    return reader.GetOutput()


with run_case() as folder:
    rows = series(folder)
    sets = xml.etree.ElementTree.parse(folder / "snapshots.pvd").findall(".//DataSet")
    assert len(sets) == 2 * len(rows["time [s]"]), sets
    for n, time in enumerate(rows["time [s]"]):
        particles, contacts = (next(s for s in sets[2 * n:2 * n + 2] if s.get("part") == part) for part in "01")
        assert float(particles.get("timestep")) == float(contacts.get("timestep")) == float(time)
        points, lines = read(folder / particles.get("file")), read(folder / contacts.get("file"))
        assert points.GetNumberOfPoints() == COUNT
        assert lines.GetNumberOfLines() == int(float(rows["contacts"][n]))
        radii = points.GetPointData().GetArray("radius")
        size = points.GetFieldData().GetArray("CellSize").GetTuple(0)
        solid = sum(4 / 3 * math.pi * radii.GetValue(k)**3 for k in range(COUNT))
        assert math.isclose(solid / math.prod(size), float(rows["relative_density"][n]), rel_tol=1e-12)
    print(f"{len(rows['time [s]'])} snapshots read by VTK")
