"""Opens the molecule of PoreRadiusWindow.py, and writes down the title and axis of the chart, and the radius at the ball."""

import os
from pathlib import Path

from paraview import servermanager, simple

from isthmus_plugin import pipelines, pocket_views  # there once paraview.simple has loaded the plugin

path = Path(os.environ["ISTHMUS_SESSION_DIR"]) / "chart.txt"
first_look = pipelines.first_look


def write():
    for view in simple.GetViews():
        if view.SMProxy.GetXMLName() == "XYChartView":
            pores = next(source for source in simple.GetSources().values() if source.SMProxy.GetXMLName() == "PoreProfile")
            place = pocket_views._fed_by(pores, pocket_views.BOTTLENECKS, "ExtractSelection")
            balls = servermanager.Fetch(place).GetPointData().GetArray("Radius")
            with path.open("a", encoding="utf-8") as file:
                print(view.ChartTitle, "|", view.LeftAxisTitle, "| label", f"{balls.GetValue(0):.2f}", file=file)


def look_and_write(*ids):
    first_look(*ids)
    write()


pipelines.first_look = look_and_write
source = simple.OpenDataFile(os.environ["ISTHMUS_SESSION_DATA"])
simple.Show(source, simple.GetActiveViewOrCreate("RenderView"))
simple.SetActiveSource(source)
