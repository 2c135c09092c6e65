"""The plugin's choking loops: outputs and arrays, thresholds from the cache, errors, shortening."""

import time

import isthmus
import numpy
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkContourFilter

from outputs import output_of, stage_times

isthmus.vtkChokingLoops  # noqa: B018 - its class, before a proxy makes an object that has only that of its base


def torus(ring, cross):
    return Superquadric(Toroidal=1, ThetaRoundness=1, PhiRoundness=1, Thickness=0.3,
                        ThetaResolution=ring, PhiResolution=cross)


def surface(source):
    triangles = Triangulate(Input=Clean(Input=source, Tolerance=1e-6))
    return triangles


def field(data, name):
    return data.GetFieldData().GetArray(name)


shape = surface(torus(64, 48))
loops = ChokingLoops(Input=shape)
UpdatePipeline(proxy=loops)
lines = output_of(loops, 0)
assert lines.GetNumberOfCells() == 2, lines.GetNumberOfCells()
for name in ("Kind", "Side", "KindName", "Radius", "Birth", "Death", "Persistence", "Trusted", "Length", "Reach",
             "FeatureId", "SharedWith", "Component"):
    assert lines.GetCellData().GetAbstractArray(name), name
kinds = {lines.GetCellData().GetAbstractArray("KindName").GetValue(i) for i in range(2)}
assert kinds == {"handle", "tunnel"}, kinds
membranes = output_of(loops, 1)
assert membranes.GetNumberOfCells() > 10 and membranes.GetCellData().GetArray("Area")
points = output_of(loops, 2)
assert points.GetNumberOfPoints() == 2 and points.GetPointData().GetArray("Radius")
table = output_of(loops, 3)
for name in ("FeatureId", "Dimension", "Side", "Birth", "Death", "Persistence", "Kind"):
    assert table.GetColumnByName(name), name
proposed = field(lines, "ProposedThreshold")
assert proposed.GetNumberOfTuples() == 2 and proposed.GetNumberOfComponents() == 2
assert field(lines, "NumberOfHandles").GetValue(0) == 1


# Thresholds, side and shortening leave the analysis alone: its times stay what they were.
before = stage_times(loops)
assert sum(before) > 0
loops.Side = "Inside"
loops.MinimumPersistence = 20
loops.Shortening = "Rounds"
started = time.time()
UpdatePipeline(proxy=loops)
took = time.time() - started
lines = output_of(loops, 0)
assert lines.GetNumberOfCells() == 1
assert stage_times(loops) == before
print("another side, threshold and shortening after %.1f ms" % (1e3 * took))

# The most persistent alone; and the threshold at the largest gap is the one that is proposed.
loops.Side, loops.MinimumPersistence, loops.MaximumNumberOfLoops = "Both", 5, 1
UpdatePipeline(proxy=loops)
assert output_of(loops, 2).GetNumberOfPoints() == 1
loops.MaximumNumberOfLoops = 0
loops.ThresholdMode = "Largest gap"
UpdatePipeline(proxy=loops)
assert output_of(loops, 2).GetNumberOfPoints() == 2

# Loops come as geodesics, and along edges when asked for: these are longer on an uneven mesh.
uneven = Decimate(Input=shape, TargetReduction=0.4, PreserveTopology=1)
lengths = {}
for shortening in ("None", "Geodesic"):
    again = ChokingLoops(Input=uneven, Shortening=shortening)
    UpdatePipeline(proxy=again)
    lengths[shortening] = output_of(again, 0).GetCellData().GetArray("Length")
for i in range(2):
    assert lengths["Geodesic"].GetValue(i) < lengths["None"].GetValue(i)

# The filter on its own shortens what the other leaves.
loops.Shortening = "None"
short = LoopShortening(Input=loops, Surface=shape)
UpdatePipeline(proxy=short)
shorter = servermanager.Fetch(short)
assert shorter.GetCellData().GetArray("Converged").GetRange() == (1.0, 1.0)

print("loop shortening passed", flush=True)
offset = OffsetSurface(Input=shape, Distance=0.05, Resolution=40)
UpdatePipeline(proxy=offset)
assert servermanager.Fetch(offset).GetNumberOfCells() > 300



# The order of points and triangles, and their orientation, change neither the number of loops nor their radii.
def contour_of_blobs(seed):
    """Points and triangles of a surface around fourteen Gaussians."""
    random = numpy.random.default_rng(seed)
    centers, widths = random.uniform(-1.0, 1.0, (14, 3)), random.uniform(0.3, 0.45, 14)
    axis = numpy.linspace(-2.2, 2.2, 26)
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
    values = sum(numpy.exp(-((x - c[0]) ** 2 + (y - c[1]) ** 2 + (z - c[2]) ** 2) / w ** 2 * 1.5)
                 for c, w in zip(centers, widths))
    image = vtkImageData()
    image.SetDimensions(26, 26, 26)
    image.SetOrigin(-2.2, -2.2, -2.2)
    image.SetSpacing(4.4 / 25, 4.4 / 25, 4.4 / 25)
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
    contour = vtkContourFilter()
    contour.SetInputData(image)
    contour.SetValue(0, 0.5)
    contour.Update()
    made = contour.GetOutput()
    return (vtk_to_numpy(made.GetPoints().GetData()).astype(float),
            vtk_to_numpy(made.GetPolys().GetConnectivityArray()).reshape(-1, 3))


def loops_of(places, triangles):
    """Kind, side and radius of each loop, sorted."""
    data, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(places), deep=True))
    data.SetPoints(points)
    ids = numpy.ascontiguousarray(triangles.ravel(), numpy.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(numpy.arange(0, len(ids) + 1, 3), deep=True),
                  numpy_to_vtkIdTypeArray(ids, deep=True))
    data.SetPolys(cells)
    loops_filter = isthmus.vtkChokingLoops()
    loops_filter.SetInputData(data)
    loops_filter.SetSide(loops_filter.Both)
    loops_filter.SetSampleSpacing(0.15)
    loops_filter.Update()
    arrays = loops_filter.GetOutput(0).GetCellData()
    return numpy.array(sorted(zip(*(vtk_to_numpy(arrays.GetArray(name)).astype(float)
                                    for name in ("Kind", "Side", "Radius")))))


for seed in (104, 127, 139, 178):  # small loops around single points were loops of their own in one order
    places, triangles = contour_of_blobs(seed)
    random = numpy.random.default_rng(seed)
    expected = loops_of(places, triangles)
    number = random.permutation(len(places))
    shuffled = numpy.empty_like(places)
    shuffled[number] = places
    for other in (loops_of(places, triangles[:, [0, 2, 1]]),
                  loops_of(shuffled, number[triangles][random.permutation(len(triangles))][:, [1, 0, 2]])):
        assert other.shape == expected.shape, (seed, other, expected)
        assert numpy.allclose(other, expected, rtol=1e-3), (seed, other, expected)
print("order and orientation passed", flush=True)

# An open surface ends in one sentence and empty outputs.
half = Clip(Input=shape, ClipType="Plane")
opened = ExtractSurface(Input=half)
vtkObject.GlobalWarningDisplayOff()
bad = ChokingLoops(Input=Triangulate(Input=opened))
UpdatePipeline(proxy=bad)
assert output_of(bad, 0).GetNumberOfCells() == 0
assert output_of(bad, 3).GetNumberOfRows() == 0
print("passed")
