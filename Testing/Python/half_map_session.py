"""Opens the half maps of HalfMapWindow.py, and writes down what each result of Map Handles has."""

import os
from pathlib import Path

from paraview import servermanager, simple

from isthmus_plugin import pipelines  # there once paraview.simple has loaded the plugin

folder = Path(os.environ["ISTHMUS_SESSION_DIR"])
first_values = pipelines.first_values


def watch(number):
    first_values(number)
    handles = servermanager._getPyProxy(servermanager.ActiveConnection.Session.GetRemoteObject(number))
    handles.NumberOfResamples = 5  # as if it were typed

    def write_down(*_):
        found = handles.FieldData["HalfMapCorrelation"]
        with (folder / "results.txt").open("a") as file:
            print(handles.PointData["PValue"] is not None, found.GetRange()[0] if found else None, file=file)

    handles.SMProxy.AddObserver("UpdateDataEvent", write_down)


pipelines.first_values = watch
for half in (2, 1):
    opened = simple.OpenDataFile(str(folder.parent / f"half_{half}.map"), registrationName=f"half_{half}.map")
    simple.Show(opened, simple.GetActiveViewOrCreate("RenderView"))
simple.SetActiveSource(opened)
