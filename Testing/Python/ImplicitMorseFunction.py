"""Choking loops by an implicit function on a volume instead of the distance (thesis, 6.3.2): a contour,
tetrahedra of it, the volume's own values at their points, and the filtration of these.

A ring with one thin place: as a signed distance the function gives the radius of the handle, times 5 it
gives 5 times that, squared the square, at the same choke triangle: the order of the values is what counts.
"""

from paraview.simple import (Calculator, ChokingLoops, Contour, ProgrammableSource, ResampleWithDataset,
                             TetrahedralMesher, UpdatePipeline)

from outputs import output_of

RING = """
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
n, h = (69, 69, 25), 0.05
x, y, z = numpy.meshgrid(*[h * (numpy.arange(k) - (k - 1) / 2.0) for k in n], indexing="ij")
thick = 0.35 - 0.15 * numpy.exp(-((x - 1.0) ** 2 + y ** 2) / 0.1)
value = numpy.hypot(numpy.hypot(x, y) - 1.013, z - 0.004) - thick
output.SetDimensions(n)
output.SetOrigin(*[-h * (k - 1) / 2.0 for k in n])
output.SetSpacing(h, h, h)
array = numpy_to_vtk(value.ravel(order="F"), deep=True)
array.SetName("Value")
output.GetPointData().SetScalars(array)
"""


def handle(points):
    """Radius and place of the only handle."""
    kinds = points.GetPointData().GetArray("Kind")
    handles = [i for i in range(points.GetNumberOfPoints()) if kinds.GetValue(i) == 0]
    assert len(handles) == 1, len(handles)
    return points.GetPointData().GetArray("Radius").GetValue(handles[0]), points.GetPoint(handles[0])


volume = ProgrammableSource(OutputDataSetType="vtkImageData", Script=RING,
                            ScriptRequestInformation="from paraview.util import SetOutputWholeExtent\n"
                                                     "SetOutputWholeExtent(self, [0, 68, 0, 68, 0, 24])")
surface = Contour(Input=volume, ContourBy=["POINTS", "Value"], Isosurfaces=[0.0])
tetrahedra = TetrahedralMesher(Input=surface, Side="Inside", MaximumVolume=1e-4)
probed = ResampleWithDataset(SourceDataArrays=volume, DestinationMesh=tetrahedra)
found = {}
for name, formula in (("once", "abs(Value)"), ("fivefold", "5*abs(Value)"), ("square", "Value^2")):
    depth = Calculator(Input=probed, ResultArrayName="Depth", Function=formula)
    loops = ChokingLoops(Input=surface, Mesh=depth, Filtration="Tetrahedral mesh",
                         MorseFunction="Point array", MorseArray="Depth", Side="Inside")
    UpdatePipeline(proxy=loops)
    found[name] = handle(output_of(loops, 2))
radius, place = found["once"]
# The thin place has radius 0.2, and between points half an edge off its axis the function stays below.
assert abs(radius - 0.2) < 0.05, radius
assert place[0] > 0.8 and abs(place[1]) < 0.3, place
assert abs(found["fivefold"][0] - 5.0 * radius) < 1e-9 and found["fivefold"][1] == place, found
assert abs(found["square"][0] - radius ** 2) < 1e-9 and found["square"][1] == place, found
print("radius", radius, "at", place)
exact = ChokingLoops(Input=surface, Mesh=tetrahedra, Filtration="Tetrahedral mesh",
                     MorseFunction="Fast marching on a grid", Side="Inside")
UpdatePipeline(proxy=exact)
marched = handle(output_of(exact, 2))
assert abs(marched[0] - radius) < 0.05, marched
print("by fast marching", *marched)
