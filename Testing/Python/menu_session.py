"""Opens the map of MenuWindow.py, and writes down the views and titles of legends after each change."""

import os
from pathlib import Path

from paraview import simple

from isthmus_plugin import look, pipelines  # there once paraview.simple has loaded the plugin

path = Path(os.environ["ISTHMUS_SESSION_DIR"]) / "views.txt"
reported = []


def titles(view):
    return [bar.Title for bar in view.Representations if bar.SMProxy.GetXMLName() == "ScalarBarWidgetRepresentation"]


def report(*more):
    views = sorted(view.SMProxy.GetXMLName() for view in simple.GetViews())
    words = [title for view in simple.GetViews() if hasattr(view, "HiddenLineRemoval") for title in titles(view)]
    with path.open("a", encoding="utf-8") as file:
        print(" ".join(views), "|", ", ".join(words), *more, file=file)


def second_view():
    """The curvature once more, in a view of its own, which is closed again. Returns the title of its legend."""
    curvature, first = simple.GetActiveSource(), simple.GetActiveView()
    view = simple.CreateView("RenderView")
    display = simple.Show(curvature, view, "GeometryRepresentation")
    simple.ColorBy(display, ("POINTS", "MeanCurvature"))
    display.SetScalarBarVisibility(view, True)
    look.first_look(display.GetGlobalID())
    found = titles(view)
    simple.Delete(view)
    simple.SetActiveView(first)
    return found


def watched(function):
    def called(*arguments):
        result = function(*arguments)
        source = simple.GetActiveSource()
        if not reported and source is not None and source.SMProxy.GetXMLName() == "CurvatureOnSurface":
            reported.append(source)
            report("second view:", *second_view())
        else:
            report()
        return result
    return called


for name in ("first_look", "forget"):
    setattr(pipelines, name, watched(getattr(pipelines, name)))

density = simple.OpenDataFile(os.environ["ISTHMUS_SESSION_DATA"])
simple.Show(density, simple.GetActiveViewOrCreate("RenderView"))
simple.SetActiveSource(density)
