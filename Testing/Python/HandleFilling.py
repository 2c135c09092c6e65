"""Handle Filling as a user has it: two rings side by side in one plate, the narrow hole filled, the wide
one left; the surface measured by other filters, and Choking Loops of what is left.
"""

import math

from paraview.simple import (ChokingLoops, Contour, HandleFilling, ProgrammableSource, SurfaceMeasures,
                             UpdatePipeline)

from outputs import output_of

PLATE = """
import numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.util.numpy_support import numpy_to_vtk
n, h = (121, 75, 25), 0.05
x, y, z = numpy.meshgrid(*[h * (numpy.arange(k) - (k - 1) / 2.0) for k in n], indexing="ij")
value = numpy.max([abs(x) - 2.6, abs(y) - 1.6, abs(z) - 0.4], axis=0)
for center, radius in ((-1.213, 0.3), (1.207, 0.6)):
    value = numpy.maximum(value, radius - numpy.hypot(x - center, y - 0.013))
output.SetDimensions(n)
output.SetSpacing(h, h, h)
array = numpy_to_vtk(value.ravel(order="F"), deep=True)
array.SetName("Value")
output.GetPointData().SetScalars(array)
"""


def measured(surface):
    measures = SurfaceMeasures(Input=surface)
    UpdatePipeline(proxy=measures)
    table = output_of(measures, 0).GetFieldData()
    return table.GetArray("Genus").GetTuple1(0), table.GetArray("Volume").GetTuple1(0)


def tunnels(surface):
    loops = ChokingLoops(Input=surface)
    UpdatePipeline(proxy=loops)
    points = output_of(loops, 2).GetPointData()
    return [points.GetArray("Radius").GetValue(i) for i in range(points.GetArray("Kind").GetNumberOfValues())
            if points.GetArray("Kind").GetValue(i) == 1]


source = ProgrammableSource(OutputDataSetType="vtkImageData", Script=PLATE,
                            ScriptRequestInformation="from paraview.util import SetOutputWholeExtent\n"
                                                     "SetOutputWholeExtent(self, [0, 120, 0, 74, 0, 24])")
plate = Contour(Input=source, ContourBy=["POINTS", "Value"], Isosurfaces=[0.0])
filled = HandleFilling(Input=plate, FillHandlesBelow=0.35)
UpdatePipeline(proxy=filled)
surface, table = output_of(filled), output_of(filled, 1)
assert table.GetNumberOfRows() == 1, table.GetNumberOfRows()
row = {table.GetColumnName(i): table.GetValue(0, i) for i in range(table.GetNumberOfColumns())}
assert row["KindName"].ToString() == "tunnel"
assert abs(row["Radius"].ToDouble() - 0.3) < 0.01, row["Radius"].ToDouble()
assert abs(row["Area"].ToDouble() - math.pi * 0.09) < 0.02
genus = surface.GetFieldData().GetArray("Genus")
assert (genus.GetValue(0), genus.GetValue(1)) == (2, 1)
assert surface.GetCellData().GetArray("Filling").GetRange() == (0.0, 1.0)
before, after = measured(plate), measured(filled)
assert (before[0], after[0]) == (2, 1), (before, after)
predicted = row["Volume"].ToDouble()
assert abs(after[1] - abs(before[1]) - predicted) < 0.05 * predicted, (before, after, predicted)
was, now = tunnels(plate), tunnels(filled)
assert len(was) == 2 and len(now) == 1 and abs(max(was) - now[0]) < 1e-3, (was, now)
print("the narrow hole is filled, the wide one as it was")

# The next size takes what is left, and the first filling with it.
filled.FillHandlesBelow = 0.7
UpdatePipeline(proxy=filled)
assert output_of(filled).GetFieldData().GetArray("Genus").GetValue(1) == 0
print("and none is left below 0.7")
