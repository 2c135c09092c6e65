"""Opens the map of LiveWindow.py, and writes down when a threshold is changed, and when the view is drawn with how many loops."""

import os
import time
from pathlib import Path

from paraview import simple, servermanager

from isthmus_plugin import loop_views  # there once paraview.simple has loaded the plugin

path = Path(os.environ["ISTHMUS_SESSION_DIR"]) / "lively.txt"
count = loop_views.count
THRESHOLDS = ("MaximumNumberOfLoops", "MinimumPersistence", "TrustedOnly")
watched = []


def write(*words):
    with path.open("a") as file:
        print(f"{time.monotonic():.3f}", *words, file=file)


def count_and_watch(loops, view):
    count(loops, view)
    loops = servermanager._getPyProxy(loops.SMProxy)
    said = loop_views.words(loops).replace("\n", "; ")
    texts = [source.Text for (name, _), source in simple.GetSources().items() if name.endswith(loop_views.COUNT)]
    write("count", said, "|", *[text.replace("\n", "; ") for text in texts])
    if watched:
        return
    watched.append(loops)
    for name in THRESHOLDS:
        loops.SMProxy.GetProperty(name).AddObserver(
            "UncheckedPropertyModifiedEvent", lambda *_, name=name: write("change", name))
    view.GetRenderWindow().AddObserver("StartEvent", lambda *_: write("drawing", "begins"))
    view.GetRenderWindow().AddObserver("EndEvent", lambda *_: write("drawn", loops.FieldData[
        "NumberOfShownFeatures"].GetRange(0)[0]))


loop_views.count = count_and_watch

source = simple.OpenDataFile(os.environ["ISTHMUS_SESSION_DATA"])
simple.Show(source, simple.GetActiveViewOrCreate("RenderView"))
simple.SetActiveSource(source)
