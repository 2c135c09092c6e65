"""Opens the map of LevelWindow.py with Map Surface and its loops, and records when a preview of a level is asked for, how long it took until it was drawn, and the loops that are shown."""

import json
import os
import time
from pathlib import Path

from paraview import simple

from isthmus_plugin import loop_views, pipelines  # there once paraview.simple has loaded the plugin

path = Path(os.environ["ISTHMUS_SESSION_DIR"]) / "level.txt"
begun = []


def write(*words):
    with path.open("a") as file:
        print(*words, file=file)


def preview(number, level, call=pipelines.preview_level):
    begun.append(time.monotonic())
    call(number, level)
    visible = [display.Input.SMProxy.GetXMLName() for display in view.Representations
               if getattr(display, "Input", None) and display.Visibility]
    write("preview", f"{level:.4f}", *sorted(visible), f"{drawing[-1] - begun[-1]:.3f}")


def count(loops, view, call=loop_views.count):
    changed = call(loops, view)
    texts = [text.Text for (name, _), text in simple.GetSources().items() if name.endswith(loop_views.COUNT)]
    write("loops", *texts)
    return changed


def change(number, call=pipelines.live_change):
    call(number)
    write("level", surface.Level)


def values(number, call=pipelines.level_values):
    text = call(number)
    found = json.loads(text)
    write("range", found["low"], found["high"], *source.PointData["Density"].GetRange(0))
    return text


drawing = []
source = simple.OpenDataFile(os.environ["ISTHMUS_SESSION_DATA"])
view = simple.GetActiveViewOrCreate("RenderView")
surface, loops = pipelines.map_to_loops(source, significant=True)
pipelines.show(surface, loops)
simple.SetActiveSource(surface)
view.GetRenderWindow().AddObserver("StartEvent", lambda *_: drawing.append(time.monotonic()))
pipelines.preview_level, loop_views.count = preview, count
pipelines.live_change, pipelines.level_values = change, values
write("level", surface.Level)
