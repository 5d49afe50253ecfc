"""Run by pvpython: the spheres of each time must fill the box that places and radii of the particles span."""

import os
import pathlib
import sys

from paraview import servermanager, simple

sys.path.insert(0, str(pathlib.Path(os.environ["FRIT_SOURCE"], "share/paraview")))
import frit_packing  # noqa: E402

def first_leaf(data):
    while data is not None and data.IsA("vtkMultiBlockDataSet"):
        data = next(filter(None, map(data.GetBlock, range(data.GetNumberOfBlocks()))), None)
    return data


collection = simple.PVDReader(FileName=sys.argv[1])
times = list(collection.TimestepValues)
assert len(times) > 2, times
spheres, contacts, view = frit_packing.show(collection)
for time in times:
    view.ViewTime = time
    simple.UpdatePipeline(time=time, proxy=spheres)
    simple.UpdatePipeline(time=time, proxy=contacts)
    points = first_leaf(servermanager.Fetch(simple.FindSource("particles")))
    radii = points.GetPointData().GetArray("radius")
    low = min(points.GetPoint(k)[2] - radii.GetValue(k) for k in range(points.GetNumberOfPoints()))
    high = max(points.GetPoint(k)[2] + radii.GetValue(k) for k in range(points.GetNumberOfPoints()))
    bounds = spheres.GetDataInformation().GetBounds()
    assert abs(bounds[4] - low) < 1e-3 * (high - low) and abs(bounds[5] - high) < 1e-3 * (high - low), (bounds, low, high)
    assert contacts.GetDataInformation().GetNumberOfCells() > 100
print(f"{len(times)} times shown to scale")
