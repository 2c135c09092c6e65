"""Dual Contouring in ParaView: a volume and a box, triangles and quadrilaterals."""

from paraview import servermanager, simple

wavelet = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
contour = simple.DualContouring(Input=wavelet, Scalars=["POINTS", "RTData"], Level=200.0)
triangles = servermanager.Fetch(contour)
assert triangles.GetNumberOfCells() > 100, triangles.GetNumberOfCells()
contour.Quadrilaterals = 1
assert servermanager.Fetch(contour).GetNumberOfCells() * 2 == triangles.GetNumberOfCells()

# A box keeps its corners: its bounds and its volume come out as they went in.
box = simple.Box(XLength=1.0, YLength=2.0, ZLength=3.0)
merged = simple.CleantoGrid(Input=box)
surface = simple.ExtractSurface(Input=merged)
sharp = simple.DualContouring(Input=surface, Spacing=0.17)
bounds = servermanager.Fetch(sharp).GetBounds()
for found, expected in zip(bounds, (-0.5, 0.5, -1.0, 1.0, -1.5, 1.5)):
    assert abs(found - expected) < 1e-6, bounds
grid = simple.TetrahedralMesher(Input=sharp)
volume = servermanager.Fetch(simple.IntegrateVariables(Input=grid))
assert abs(volume.GetCellData().GetArray("Volume").GetTuple1(0) - 6.0) < 0.01

sharp.FeatureThreshold = 3.0
refused = servermanager.Fetch(sharp)
assert refused is None or refused.GetNumberOfCells() == 0
