"""Surface Measures in ParaView: field data and table of a surface, and of a level of a volume."""

import math

from paraview import servermanager
from paraview.simple import Sphere, SurfaceMeasures, SurfaceToGrid, Wavelet

sphere = Sphere(Radius=2.0, ThetaResolution=128, PhiResolution=128)
measures = SurfaceMeasures(Input=sphere)
measures.UpdatePipeline()

field = measures.FieldData
assert abs(field["Area"].GetRange()[0] / (16 * math.pi) - 1) < 1e-3
assert abs(field["Volume"].GetRange()[0] / (32 / 3 * math.pi) - 1) < 2e-3
assert field["Genus"].GetRange()[0] == 0
assert field["Components"].GetRange()[0] == 1

table = servermanager.Fetch(measures, idx=1)
assert table.IsA("vtkTable") and table.GetNumberOfRows() == 2
assert table.GetValueByName(0, "Component").ToInt() == -1
assert table.GetValueByName(0, "Genus").ToInt() == 0

wave = Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
level = SurfaceMeasures(Input=wave, Scalars=["POINTS", "RTData"], Level=160.0)
level.UpdatePipeline()
assert level.FieldData["Area"].GetRange()[0] > 0
inside = level.FieldData["Volume"].GetRange()[0]
values = servermanager.Fetch(wave).GetPointData().GetArray("RTData")
count = sum(values.GetValue(i) > 160.0 for i in range(values.GetNumberOfTuples()))
assert inside == count, (inside, count)

# A volume straight from a reader: its active scalars are taken unless told otherwise.
wavelet = Wavelet()
for create in (SurfaceMeasures, SurfaceToGrid):
    volume = create(Input=wavelet)
    assert servermanager.Fetch(volume).GetNumberOfPoints() > 0
