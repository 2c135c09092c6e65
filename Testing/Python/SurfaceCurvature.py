"""Surface Curvature in ParaView: arrays and signs on a sphere and on a surface with a border."""

import tempfile
from pathlib import Path

from paraview import servermanager
from paraview.simple import FindSource, LoadState, Plane, ResetSession, SaveState, Sphere, SurfaceCurvature

sphere = Sphere(Radius=2.0, ThetaResolution=64, PhiResolution=64)
curvature = SurfaceCurvature(Input=sphere, PointAreaRule="Mixed")
curvature.UpdatePipeline()
points = curvature.PointData
low, high = points["MeanCurvature"].GetRange()
assert 0.4 < low and high < 0.6, (low, high)
assert points["CurvatureValid"].GetRange() == (1, 1)
for name in ("GaussianCurvature", "MaximumCurvature", "MinimumCurvature", "ShapeIndex", "Curvedness"):
    assert points[name] is not None, name

tensor = SurfaceCurvature(
    Input=sphere, Method="Edge tensor", Neighbourhood="Ball", Radius=0.6,
    OutputArrays=["MeanCurvature", "PrincipalDirection1"])
tensor.UpdatePipeline()
low, high = tensor.PointData["MeanCurvature"].GetRange()
assert 0.45 < low and high < 0.54, (low, high)
assert tensor.PointData["PrincipalDirection1"].GetNumberOfComponents() == 3

# The arrays of the output are chosen in one list, which state files keep.
chosen = SurfaceCurvature(registrationName="chosen", Input=sphere)
assert sorted(chosen.OutputArrays) == sorted(
    ["GaussianCurvature", "MeanCurvature", "MaximumCurvature", "MinimumCurvature", "ShapeIndex", "Curvedness", "PointArea"])
chosen.OutputArrays = ["GaussianCurvature", "SurfaceType"]
with tempfile.TemporaryDirectory() as folder:
    path = str(Path(folder) / "chosen.pvsm")
    SaveState(path)
    ResetSession()
    LoadState(path)
loaded = FindSource("chosen")
loaded.UpdatePipeline()
names = set(loaded.PointData.keys())
assert names >= {"GaussianCurvature", "SurfaceType", "CurvatureValid"}, names
assert not names & {"MeanCurvature", "PointArea", "GaussMap"}, names
assert sorted(loaded.OutputArrays) == ["GaussianCurvature", "SurfaceType"]
assert len(loaded.OutputArrays.Available) == 17

plane = SurfaceCurvature(Input=Plane(XResolution=10, YResolution=10))
data = servermanager.Fetch(plane).GetPointData()
valid = data.GetArray("CurvatureValid")
assert sum(valid.GetValue(i) for i in range(valid.GetNumberOfTuples())) == 81
assert data.GetArray("GaussianCurvature").GetRange() == (0.0, 0.0)
