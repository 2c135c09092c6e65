"""Opens the data of ProgressWindow.py, and writes down the steps that buttons report and the names of the sources."""

import os
import subprocess
import time
from pathlib import Path

from paraview import simple
from vtkmodules.vtkCommonCore import VTK_STRING, vtkOutputWindow

from isthmus_plugin import messages, pipelines  # there once paraview.simple has loaded the plugin

folder = Path(os.environ["ISTHMUS_SESSION_DIR"])
run = pipelines.run


def write(*words):
    with (folder / "steps.txt").open("a", encoding="utf-8") as file:
        print(f"{time.monotonic():.3f}", *words, file=file)


def names():
    return "|".join(sorted(name for name, _ in simple.GetSources()))


def observe(event, what):
    def keep(_window, _event, text):
        write(what, text)

    keep.CallDataType = VTK_STRING
    return vtkOutputWindow.GetInstance().AddObserver(event, keep)


def watched_run(function):
    observers = [observe(messages.STEP, "step"), observe("UserEvent", "note")]
    write("begins", names())
    run(function)
    write("ends", names())
    for observer in observers:
        vtkOutputWindow.GetInstance().RemoveObserver(observer)


def show_after_escape(*proxies, **given):
    """Escape is pressed when the result is about to be shown."""
    subprocess.run(["xdotool", "key", "Escape"], check=True)
    time.sleep(1)
    return show(*proxies, **given)


pipelines.run = watched_run
if os.environ.get("ISTHMUS_SESSION_ESCAPE"):
    show, pipelines.show = pipelines.show, show_after_escape

source = simple.OpenDataFile(os.environ["ISTHMUS_SESSION_DATA"])
simple.Show(source, simple.GetActiveViewOrCreate("RenderView"))
simple.SetActiveSource(source)
simple.ResetCamera()
simple.Render()
write("opened", names())
