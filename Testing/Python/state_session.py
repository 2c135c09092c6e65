"""Loads the state of StateWindow.py, and writes down what each selection shows."""

import os
from pathlib import Path

from paraview import servermanager, simple

from isthmus_plugin import diagram_views, loop_views, pipelines, pocket_views  # there once paraview.simple has loaded the plugin

path = Path(os.environ["ISTHMUS_SESSION_DIR"]) / "shown.txt"
changed = pipelines.selection_changed


def words():
    for source in simple.GetSources().values():
        name = source.SMProxy.GetXMLName()
        if name in pocket_views.FEATURES:
            return f"residues of {int(pocket_views.residues_of(source).LowerThreshold)}"
        if name in loop_views.LOOPS and diagram_views.balls_of(source) is not None:
            balls = servermanager.Fetch(diagram_views.balls_of(source))
            radii = balls.GetPointData().GetArray("Radius")
            return f"{balls.GetNumberOfPoints()} ball, radius {radii.GetValue(0):.3f}" if radii else "no balls"
    return "nothing"


def change_and_write(number):
    changed(number)
    with path.open("a", encoding="utf-8") as file:
        print(words(), file=file)


pipelines.selection_changed = change_and_write
simple.LoadState(os.environ["ISTHMUS_SESSION_DATA"])
