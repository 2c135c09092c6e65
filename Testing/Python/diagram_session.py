"""Opens the surface of DiagramWindow.py, and writes down which features are selected, in chart and view."""

import os
from pathlib import Path

from paraview import simple

from isthmus_plugin import loop_views, pipelines  # there once paraview.simple has loaded the plugin
from isthmus_plugin import diagram_views as diagrams

path = Path(os.environ["ISTHMUS_SESSION_DIR"]) / "selected.txt"
changed = pipelines.selection_changed


def change_and_tell(number):
    changed(number)
    loops = [source for source in simple.GetSources().values() if source.SMProxy.GetXMLName() == "ChokingLoops"]
    for source, plot in ((source, plot) for source in loops for plot in diagrams.plots_of(source)):
        where = "chart" if number == plot.SMProxy.GetGlobalID() else "view" if number else "nothing"
        balls = diagrams.balls_of(source)
        count = balls.GetDataInformation().DataInformation.GetNumberOfPoints() if balls else 0
        with path.open("a") as file:
            print(where, diagrams._selected_ids(source), diagrams._selected_ids(plot), count, sep="|", file=file)


pipelines.selection_changed = change_and_tell
loop_views.show_table = lambda *_: None  # the places of DiagramWindow.py are those without it

surface = simple.OpenDataFile(os.environ["ISTHMUS_SESSION_DATA"])
simple.Show(surface, simple.GetActiveViewOrCreate("RenderView"))
simple.SetActiveSource(surface)
