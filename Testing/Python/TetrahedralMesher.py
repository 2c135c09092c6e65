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

# An open surface gives an error and nothing else, unless Automatic may close it.
half = simple.Clip(Input=sphere, ClipType="Plane", Crinkleclip=1)
surface = simple.ExtractSurface(Input=half)
refused = servermanager.Fetch(simple.TetrahedralMesher(Input=surface, Library="TetGen"))
assert refused is None or refused.GetNumberOfCells() == 0


def engine(grid):
    return grid.GetFieldData().GetAbstractArray("Engine").GetValue(0)


def number(grid, name):
    return grid.GetFieldData().GetArray(name).GetValue(0)


automatic = simple.TetrahedralMesher(Input=sphere)
assert automatic.Library == "Automatic"
assert engine(servermanager.Fetch(automatic)) == "TetGen"
assert number(servermanager.Fetch(automatic), "HausdorffDistance") == 0.0
closed = servermanager.Fetch(simple.TetrahedralMesher(Input=surface))
assert engine(closed) == "TetGen after repair", engine(closed)
assert closed.GetNumberOfCells() > 100 and number(closed, "HausdorffDistance") > 0.0

# Two spheres that cross: nothing but stuffing fills them, and their union has a known volume.
other = simple.Sphere(ThetaResolution=24, PhiResolution=24, Radius=2.0, Center=[2.0, 0.1, 0.2])
crossing = simple.MergeBlocks(Input=simple.GroupDatasets(Input=[sphere, other]),
                              OutputDataSetType="Polygonal Mesh")
filled = servermanager.Fetch(simple.TetrahedralMesher(Input=crossing))
distance = math.sqrt(4.0 + 0.01 + 0.04)
lens = math.pi * (8.0 + distance) * (4.0 - distance) ** 2 / 12.0
union = 2.0 * expected - lens
assert abs(number(filled, "VolumeAfter") / union - 1.0) < 0.03, (engine(filled), union)
print(filled.GetFieldData().GetAbstractArray("EngineReport").GetValue(0))
