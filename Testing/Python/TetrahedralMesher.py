"""Tetrahedral Mesher in ParaView: both libraries on a sphere, a broken surface ends in an error."""

import math

from paraview import servermanager, simple

sphere = simple.Sphere(ThetaResolution=24, PhiResolution=24, Radius=2.0)
mesher = simple.TetrahedralMesher(Input=sphere)
for library, tolerance in (("TetGen", 0.03), ("CGAL", 0.06)):
    mesher.Library = library
    grid = servermanager.Fetch(mesher)
    assert grid.GetNumberOfCells() > 500, f"{library}: {grid.GetNumberOfCells()} tetrahedra"
    assert grid.GetCellData().GetArray("RegionId").GetRange() == (1.0, 1.0)
    assert grid.GetPointData().GetArray("OriginalPointId") is not None
    volume = servermanager.Fetch(simple.IntegrateVariables(Input=mesher))
    measured = volume.GetCellData().GetArray("Volume").GetTuple1(0)
    expected = 4.0 / 3.0 * math.pi * 8.0
    assert abs(measured / expected - 1.0) < tolerance, f"{library}: volume {measured}"

mesher.Library = "TetGen"
mesher.Side = "Both"
regions = servermanager.Fetch(mesher).GetCellData().GetArray("RegionId").GetRange()
assert regions == (0.0, 1.0), regions

# An open surface gives an error and nothing else.
half = simple.Clip(Input=sphere, ClipType="Plane")
surface = simple.ExtractSurface(Input=half)
refused = servermanager.Fetch(simple.TetrahedralMesher(Input=surface))
assert refused is None or refused.GetNumberOfCells() == 0
