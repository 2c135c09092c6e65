"""Opens the data of BrowserWindow.py, and writes down the active source after each selection."""

import os
from pathlib import Path

from paraview import simple

from isthmus_plugin import pipelines  # there once paraview.simple has loaded the plugin

path = Path(os.environ["ISTHMUS_SESSION_DIR"]) / "active.txt"


def write(*words):
    source = simple.GetActiveSource()
    with path.open("a") as file:
        print(*words, source.SMProxy.GetXMLName() if source else "nothing", file=file)


changed = pipelines.selection_changed


def change_and_write(number):
    changed(number)
    write("selected")


def watch(*_):
    write("active")


pipelines.selection_changed = change_and_write
source = simple.OpenDataFile(os.environ["ISTHMUS_SESSION_DATA"])
if not os.environ["ISTHMUS_SESSION_DATA"].endswith((".pdb", ".pqr")):  # outputs of an opened file's cartoon would fill the list
    pipelines.first_values(source.GetGlobalID())  # as if opened by hand
simple.Show(source, simple.GetActiveViewOrCreate("RenderView"))
simple.SetActiveSource(source)
model = source.SMProxy.GetSessionProxyManager().GetSelectionModel("ActiveSources")
model.AddObserver("CurrentChangedEvent", watch)
model.AddObserver("SelectionChangedEvent", watch)
write("active")
