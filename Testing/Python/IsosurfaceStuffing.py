"""Isosurface Stuffing in ParaView: a level of a volume filled, its angles, both sides, refusals."""

import math

from paraview import servermanager, simple

wavelet = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
stuffing = simple.IsosurfaceStuffing(Input=wavelet, Scalars=["POINTS", "RTData"], Level=157.0)


def angles(source):
    report = servermanager.Fetch(simple.MeshQualityReport(Input=source)).GetCellData()
    return (report.GetArray("SmallestAngle").GetRange()[0],
            report.GetArray("LargestAngle").GetRange()[1])


def volume(source):
    fetched = servermanager.Fetch(simple.IntegrateVariables(Input=source))
    return fetched.GetCellData().GetArray("Volume").GetTuple1(0)


inside = servermanager.Fetch(stuffing)
assert inside.GetNumberOfCells() > 10000, inside.GetNumberOfCells()
assert inside.GetCellData().GetArray("RegionId").GetRange() == (1.0, 1.0)
assert inside.GetPointData().GetArray("OnSurface").GetRange() == (0.0, 1.0)
assert angles(stuffing)[0] >= 10.7 and angles(stuffing)[1] <= 164.8, angles(stuffing)
filled = volume(stuffing)

# Against a surface mesher that knows nothing of it.
surface = simple.DelaunayIsosurface(Input=wavelet, Scalars=["POINTS", "RTData"], Level=157.0)
reference = servermanager.Fetch(simple.IntegrateVariables(
    Input=simple.TetrahedralMesher(Input=surface, Library="TetGen")))
reference = reference.GetCellData().GetArray("Volume").GetTuple1(0)
assert abs(filled / reference - 1.0) < 0.02, (filled, reference)

stuffing.CellSize = 2.0
coarse = servermanager.Fetch(stuffing).GetNumberOfCells()
assert 6 < inside.GetNumberOfCells() / coarse < 10, coarse

stuffing.CellSize = 1.0
stuffing.Side = "Both"
both = servermanager.Fetch(stuffing)
bounds = both.GetBounds()
box = math.prod(bounds[2 * a + 1] - bounds[2 * a] for a in range(3))
assert abs(volume(stuffing) / box - 1.0) < 1e-9
stuffing.GradingLevels = 2
assert servermanager.Fetch(stuffing).GetNumberOfCells() < both.GetNumberOfCells()

for name, value in (("CellSize", -1.0), ("Level", float("nan")), ("GradingLevels", 9)):
    before = stuffing.GetPropertyValue(name)
    stuffing.SetPropertyWithName(name, value)
    refused = servermanager.Fetch(stuffing)
    assert refused is None or refused.GetNumberOfCells() == 0, name
    stuffing.SetPropertyWithName(name, before)
assert servermanager.Fetch(stuffing).GetNumberOfCells() > 0
