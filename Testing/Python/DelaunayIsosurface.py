"""Delaunay Isosurface, Surface Remesh and their angles, as a user chains them in ParaView."""

from paraview import servermanager, simple


def smallest_angle(source):
    report = simple.MeshQualityReport(Input=source)
    return servermanager.Fetch(report).GetCellData().GetArray("SmallestAngle").GetRange()[0]


wavelet = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
surface = simple.DelaunayIsosurface(Input=wavelet)
surface.Level = 157.0
triangles = servermanager.Fetch(surface)
assert triangles.GetNumberOfCells() > 500, triangles.GetNumberOfCells()
assert smallest_angle(surface) >= 30.0, smallest_angle(surface)
contour = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[157.0])
assert smallest_angle(contour) < 15.0
assert triangles.GetNumberOfCells() < servermanager.Fetch(contour).GetNumberOfCells()

remeshed = simple.SurfaceRemesh(Input=surface, RelativeEdgeLength=1.5)
coarser = servermanager.Fetch(remeshed).GetNumberOfCells()
assert 0.25 < coarser / triangles.GetNumberOfCells() < 0.75, coarser
remeshed.Target = "Number of triangles"
remeshed.NumberOfTriangles = 400
assert abs(servermanager.Fetch(remeshed).GetNumberOfCells() - 400) <= 4

# What comes out is fit for tetrahedra; the histogram is the second output.
report = simple.MeshQualityReport(Input=simple.TetrahedralMesher(Input=surface))
report.UpdatePipeline()
histogram = servermanager.Fetch(report, idx=1)
assert histogram.GetNumberOfRows() == 36
fractions = histogram.GetColumnByName("Fraction")
assert abs(sum(fractions.GetValue(i) for i in range(36)) - 1.0) < 1e-12
