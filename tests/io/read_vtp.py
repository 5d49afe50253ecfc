"""Reads what io_vtp_sample writes with VTK itself. Exit code 77 (skipped) without python3-vtk9."""
import subprocess
import sys
import tempfile

try:
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError:
    print("skipped: python3-vtk9 is not installed")
    sys.exit(77)

COUNT = 20000


def read(path):
    reader = vtkXMLPolyDataReader()
    faults = []
    reader.AddObserver("ErrorEvent", lambda *_: faults.append(path))
    reader.SetFileName(path)
    reader.Update()
    assert not faults, faults
    return reader.GetOutput()


def check_particles(data):
    assert data.GetNumberOfPoints() == COUNT
    assert data.GetNumberOfVerts() == COUNT
    assert data.GetNumberOfLines() == 0
    arrays = data.GetPointData()
    names = [arrays.GetArrayName(k) for k in range(arrays.GetNumberOfArrays())]
    assert names == ["id", "radius", "velocity", "coordination"], names
    for row in range(COUNT):
        assert data.GetPoint(row) == (row / 7.0, -row, 1e-6 * row), row
        assert arrays.GetArray("id").GetValue(row) == 10 * row
        assert arrays.GetArray("radius").GetValue(row) == 1.0 / (row + 3.0)
        assert arrays.GetArray("velocity").GetTuple(row) == (row / 3.0, 0.0, -1.0 * row)
        assert arrays.GetArray("coordination").GetValue(row) == row % 13
    assert data.GetFieldData().GetArray("TimeValue").GetValue(0) == 1.0 / 3.0
    assert data.GetFieldData().GetArray("CellSize").GetTuple(0) == (1.0, 2.0, 3.0)


def check_contacts(data):
    assert data.GetNumberOfLines() == 2
    assert data.GetNumberOfVerts() == 0
    second = data.GetCell(1)
    ends = [second.GetPoints().GetPoint(k) for k in range(second.GetNumberOfPoints())]
    assert ends == [(1.0, 0.0, 0.0), (2.0, 5.0, -1.0)], ends
    necks = data.GetCellData().GetArray("neck_radius")
    assert [necks.GetValue(k) for k in range(2)] == [0.1, 0.7]
    assert data.GetFieldData().GetArray("TimeValue").GetValue(0) == 1.0 / 3.0


with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.argv[1], folder], check=True)
    check_particles(read(folder + "/particles.vtp"))
    check_contacts(read(folder + "/contacts.vtp"))
    assert read(folder + "/none.vtp").GetNumberOfPoints() == 0
