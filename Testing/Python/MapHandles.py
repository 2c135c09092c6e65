"""Map Handles in ParaView: bridges and windows of GroEL, a stable level, its contour; a picture."""

import os
from pathlib import Path

from paraview.simple import (ColorBy, CreateView, MapHandles, OpenDataFile, OutputPort, ResetCamera,
                             SaveScreenshot, Show)
from vtkmodules.util.numpy_support import vtk_to_numpy

from outputs import output_of
from shared_data import shared_data

OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "MapHandles"
OUTPUT.mkdir(parents=True, exist_ok=True)

density = OpenDataFile(str(shared_data("maps/emd_5043.map")))
handles = MapHandles(Input=density, MinimumPersistence=0.45, Range=[0.2, 5.0])
handles.UpdatePipeline()
intervals = output_of(handles, 3)
first = {intervals.GetColumnName(i): intervals.GetColumn(i).GetValue(0)
         for i in range(intervals.GetNumberOfColumns())}
stable = intervals.GetFieldData().GetArray("StableLevel").GetValue(0)
print("stable level", stable, first)
# Below the level at which the subunits part, the widest run of levels holds the authors' 1.5.
assert abs(stable - first["Middle"]) < 1e-12
assert first["From"] < 1.5 < first["To"] and first["Beta1"] == 36, first
bridges = output_of(handles, 0)
level = vtk_to_numpy(bridges.GetPointData().GetArray("Level"))
for low, high, count in ((3.42, 3.57, 14), (2.96, 3.13, 7), (2.22, 2.31, 14), (0.78, 0.965, 7)):
    assert ((level >= low) & (level <= high)).sum() == count, (low, high)

view = CreateView("RenderView")
view.ViewSize = [800, 700]
surface = Show(OutputPort(handles, 4), view)
surface.Opacity = 0.3
points = Show(OutputPort(handles, 0), view)
points.PointSize = 10
points.RenderPointsAsSpheres = 1
ColorBy(points, ("POINTS", "Level"))
points.SetScalarBarVisibility(view, True)
ResetCamera(view)
view.GetActiveCamera().Elevation(80)
SaveScreenshot(str(OUTPUT / "groel.png"), view)
