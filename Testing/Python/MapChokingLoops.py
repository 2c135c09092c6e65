"""From a map to its choking loops in one step: GroEL's 36 handles and 36 tunnels at 1.5, with the radii
of Map Surface and Choking Loops one after the other; the automatic level; one that nothing is inside of.
"""

import sys

import numpy
from paraview.simple import (ChokingLoops, MapChokingLoops, MapSurface, OpenDataFile, UpdatePipeline,
                             Wavelet)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject

from outputs import output_of, stage_times
from shared_data import shared_data


def column(data, name):
    return vtk_to_numpy(data.GetArray(name))


def radii(proxy):
    points = output_of(proxy, 2).GetPointData()
    return column(points, "Kind"), column(points, "Radius")


density = OpenDataFile(str(shared_data("maps/emd_5043.map")))
loops = MapChokingLoops(Input=density, Level=1.5)
UpdatePipeline(proxy=loops)
facts = output_of(loops).GetFieldData()
assert facts.GetArray("NumberOfHandles").GetValue(0) == 36
assert facts.GetArray("NumberOfTunnels").GetValue(0) == 36
assert facts.GetArray("Level").GetValue(0) == 1.5
for port in range(3):
    assert output_of(loops, port).GetNumberOfCells() >= 72, port
assert output_of(loops, 3).GetNumberOfRows() >= 72
surface = MapSurface(Input=density, AutomaticLevel=0, Level=1.5)
steps = ChokingLoops(Input=surface)
UpdatePipeline(proxy=steps)
assert output_of(loops, 4).GetNumberOfPoints() == output_of(surface).GetNumberOfPoints()
for one, two in zip(radii(loops), radii(steps)):
    assert numpy.array_equal(one, two)
print("handles and tunnels as in two steps")

# Another threshold leaves contour and analysis alone.


before = stage_times(loops)
assert sum(before) > 0
loops.MinimumPersistence = 20
UpdatePipeline(proxy=loops)
assert stage_times(loops) == before

# Without a level, that of Map Surface; a level given by a script or an old state file counts (above).
automatic, proposed = MapChokingLoops(Input=density), MapSurface(Input=density)
UpdatePipeline(proxy=automatic)
UpdatePipeline(proxy=proposed)
levels = [output_of(proxy).GetFieldData().GetArray("Level").GetValue(0) for proxy in (automatic, proposed)]
assert levels[0] == levels[1], levels
assert output_of(automatic, 4).GetNumberOfPoints() == output_of(proposed).GetNumberOfPoints()

# The proposed level stays one while the map's range changes; a state file of before 1.0 takes it as it is.
assert automatic.AutomaticLevel == "Unless a level is given", automatic.AutomaticLevel
middle = MapChokingLoops(Input=density)
middle.SMProxy.GetProperty("AutomaticLevel").SetElement(0, 0)
middle.SMProxy.UpdateVTKObjects()
UpdatePipeline(proxy=middle)
low, high = density.PointData["Density"].GetRange()
used = output_of(middle).GetFieldData().GetArray("Level").GetValue(0)
assert abs(used - 0.5 * (low + high)) < 1e-5 * (high - low), (used, low, high)

# The map's own field data are on the loops.
assert output_of(automatic).GetFieldData().GetNumberOfArrays() > output_of(density).GetFieldData().GetNumberOfArrays()
for i in range(output_of(density).GetFieldData().GetNumberOfArrays()):
    name = output_of(density).GetFieldData().GetArrayName(i)
    assert output_of(automatic).GetFieldData().GetAbstractArray(name), name

vtkObject.GlobalWarningDisplayOff()
# An analysis that fails leaves all outputs empty, the surface too.
short = MapChokingLoops(Input=density, Level=1.5, MemoryLimit=1)
UpdatePipeline(proxy=short)
for port in (0, 1, 2, 4):
    assert output_of(short, port).GetNumberOfPoints() == 0, port
empty = MapChokingLoops(Input=Wavelet(), Level=1e6)
UpdatePipeline(proxy=empty)
for port in (0, 1, 2, 4):
    assert output_of(empty, port).GetNumberOfPoints() == 0
assert output_of(empty, 3).GetNumberOfRows() == 0
print("passed")
sys.exit(0)
