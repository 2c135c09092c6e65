"""Opens the data of LoopTableWindow.py, and writes down what a view shows of the loops after each drawing."""

import os
from pathlib import Path

from paraview import servermanager, simple

from isthmus_plugin import diagram_views, loop_views  # there once paraview.simple has loaded the plugin

path = Path(os.environ["ISTHMUS_SESSION_DIR"]) / "shown.txt"
source = simple.OpenDataFile(os.environ["ISTHMUS_SESSION_DATA"])
simple.Show(source, simple.GetActiveViewOrCreate("RenderView"))
simple.SetActiveSource(source)
view = simple.GetActiveView()
said = []


def drawn(*_):
    """distance of the camera | cells of loops that are drawn | radius written beside a selected loop"""
    loops = [each for each in simple.GetSources().values() if each.SMProxy.GetXMLName() in loop_views.LOOPS]
    if not loops:
        return
    only = loop_views.only_of(loops[0])
    lines = (loops[0] if only is None else only).GetDataInformation().GetNumberOfCells()
    balls = diagram_views.balls_of(loops[0])
    radii = servermanager.Fetch(balls).GetPointData().GetArray("Radius") if balls is not None else None
    line = (f"{view.GetActiveCamera().GetDistance():.2f} | {lines} | "
            f"{' '.join(f'{radii.GetValue(i):.3f}' for i in range(radii.GetNumberOfTuples())) if radii else ''}")
    if said[-1:] != [line]:
        said.append(line)
        with path.open("a", encoding="utf-8") as file:
            print(line, file=file)


view.GetRenderWindow().AddObserver("EndEvent", drawn)
