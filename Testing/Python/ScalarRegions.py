"""Scalar Regions in ParaView: two scalars, joint areas, sweep and histogram as tables."""

from paraview import servermanager
from paraview.simple import Calculator, ScalarRegions, Sphere, SurfaceCurvature, SurfaceMeasures

sphere = Sphere(Radius=1.0, ThetaResolution=48, PhiResolution=48)
height = Calculator(Input=sphere, Function="coordsZ", ResultArrayName="Height")
curved = SurfaceCurvature(Input=height, PointAreaRule="Mixed")
regions = ScalarRegions(
    Input=curved,
    Scalars=["POINTS", "Height"],
    Thresholds=[-0.5, 0.0, 0.5],
    UseSecondScalar=1,
    SecondScalars=["POINTS", "MeanCurvature"],
    SecondThresholds=[1.0],
    SweepSteps=2,
    SweepTarget=0.1,
    HistogramBins=10,
)
regions.UpdatePipeline()

surface = servermanager.Fetch(regions, idx=0)
for name in ("Region", "SecondRegion", "JointRegion", "ToonColor"):
    assert surface.GetPointData().HasArray(name), name
assert surface.GetCellData().HasArray("Region")
assert surface.GetPointData().GetArray("Region").GetRange() == (0.0, 3.0)

table = servermanager.Fetch(regions, idx=1)
areas = [table.GetValueByName(row, "Area").ToDouble() for row in range(4)]
assert table.GetNumberOfRows() == 4
assert all(abs(area / sum(areas) - 0.25) < 0.01 for area in areas), areas
joint = [
    table.GetValueByName(row, name).ToDouble()
    for row in range(4)
    for name in ("MeanCurvature below 1", "MeanCurvature from 1")
]
assert abs(sum(joint) / sum(areas) - 1) < 1e-12

whole = SurfaceMeasures(Input=sphere)
whole.UpdatePipeline()
assert abs(sum(areas) / whole.FieldData["Area"].GetRange()[0] - 1) < 1e-12

sweep = servermanager.Fetch(regions, idx=2)
assert sweep.GetNumberOfRows() == 5
assert sweep.GetValueByName(4, "Between").ToDouble() == 0.0
assert servermanager.Fetch(regions, idx=3).GetNumberOfRows() == 10
