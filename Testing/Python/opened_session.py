"""Writes down what the view of OpenedWindow.py shows after each first look."""

import os
from pathlib import Path

from paraview import servermanager, simple

from isthmus_plugin import pipelines  # there once paraview.simple has loaded the plugin

path = Path(os.environ["ISTHMUS_SESSION_DIR"]) / "shown.txt"
first_look = pipelines.first_look


def look_and_write(*ids):
    first_look(*ids)
    view = simple.GetActiveView()
    found = [f"{display.Input.SMProxy.GetXMLName()} {str(display.Representation).strip(chr(39))}" for display in view.Representations
             if getattr(display, "Input", None) and getattr(display, "Representation", None) and display.Visibility]
    with path.open("a") as file:
        print(", ".join(sorted(found)), file=file)


pipelines.first_look = look_and_write
settings = servermanager.ProxyManager().GetProxy("settings", "IsthmusSettings")
settings.SurfaceAndCartoonOfFiles = settings.LightBackgroundAndSoftShadows = int(os.environ["ISTHMUS_SESSION_SETTING"])
