"""The plugin's choking loops: outputs and arrays, thresholds from the cache, errors, shortening."""

import time

from paraview import servermanager
from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkObject

from outputs import output_of, stage_times


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
             "FeatureId", "SharedWith", "Component",
             "Distance", "Fill", "Widening"):  # the last three are deprecated
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
offset = OffsetSurface(Input=shape, Distance=0.05, Resolution=24)
UpdatePipeline(proxy=offset)
assert servermanager.Fetch(offset).GetNumberOfCells() > 300

# An open surface ends in one sentence and empty outputs.
half = Clip(Input=shape, ClipType="Plane")
opened = ExtractSurface(Input=half)
vtkObject.GlobalWarningDisplayOff()
bad = ChokingLoops(Input=Triangulate(Input=opened))
UpdatePipeline(proxy=bad)
assert output_of(bad, 0).GetNumberOfCells() == 0
assert output_of(bad, 3).GetNumberOfRows() == 0
print("passed")
