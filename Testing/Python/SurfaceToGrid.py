"""Surface To Grid in ParaView: a surface on its own grid and on an image's, and a level of a volume."""

import math

from paraview import servermanager
from paraview.simple import Contour, Sphere, SurfaceToGrid, Wavelet

sphere = Sphere(Radius=2.0, ThetaResolution=64, PhiResolution=64)
grid = SurfaceToGrid(Input=sphere, Spacing=0.2)
grid.UpdatePipeline()
image = servermanager.Fetch(grid, idx=0)
distance = image.GetPointData().GetArray("SignedDistance")
inside = image.GetPointData().GetArray("Inside")
for node in range(0, image.GetNumberOfPoints(), 7):
    exact = math.hypot(*image.GetPoint(node)) - 2.0
    assert abs(distance.GetValue(node) - exact) < 0.06, (node, exact)
    assert abs(exact) < 0.02 or inside.GetValue(node) == (exact < 0)
crossings = servermanager.Fetch(grid, idx=1)
assert crossings.GetNumberOfPoints() > 500
assert crossings.GetPointData().GetNormals() is not None

wave = Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
level = SurfaceToGrid(Input=wave, Scalars=["POINTS", "RTData"], Level=200.0)
level.UpdatePipeline()
assert level.PointData["RTData"] is not None
assert level.PointData["SignedDistance"].GetRange()[0] < 0 < level.PointData["SignedDistance"].GetRange()[1]

small = Sphere(Radius=5.0, ThetaResolution=32, PhiResolution=32)
onto = SurfaceToGrid(Input=small, Grid=wave)
onto.UpdatePipeline()
assert servermanager.Fetch(onto, idx=0).GetDimensions() == (21, 21, 21)
assert onto.PointData["Inside"].GetRange() == (0, 1)
# A contour of the distance is the surface again.
again = Contour(Input=onto, ContourBy=["POINTS", "SignedDistance"], Isosurfaces=[0.0])
again.UpdatePipeline()
bounds = again.GetDataInformation().GetBounds()
assert all(abs(abs(value) - 5.0) < 0.1 for value in bounds), bounds
