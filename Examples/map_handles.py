"""Bridges of a density map, coloured by the level at which they appear, on the contour at a level, next to a
chart of the components and tunnels that persist, over all levels.

Usage: pvpython map_handles.py MAP [PICTURE [LEVEL [LOWEST HIGHEST]]]

PICTURE: a path; default: map_handles.png in a temporary folder. It is printed. LEVEL: a
number; default, or "-": the recommended level, or else an estimated one. LOWEST, HIGHEST: range of levels (default: from the
mean to the maximum).
"""

import sys

from paraview import simple

from isthmus_plugin import look  # there once paraview.simple has loaded the plugin
from output_folder import output_folder


def show_map(handles, view):
    contour = simple.Show(simple.OutputPort(handles, 4), view)
    contour.DiffuseColor = [0.66, 0.74, 0.86]
    contour.Opacity = 0.35
    bridges = simple.Show(simple.OutputPort(handles, 0), view)
    bridges.PointSize = 12
    bridges.RenderPointsAsSpheres = 1
    simple.ColorBy(bridges, ("POINTS", "Level"))
    simple.GetColorTransferFunction("Level").ApplyPreset(look.SEQUENTIAL, True)
    bridges.SetScalarBarVisibility(view, True)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    bar = simple.GetScalarBar(simple.GetColorTransferFunction("Level"), view)
    bar.TitleColor = bar.LabelColor = [0.1, 0.1, 0.12]
    simple.ResetCamera(view)
    view.GetActiveCamera().Elevation(80)
    view.GetActiveCamera().Dolly(1.25)


def show_levels(handles, view):
    curves = simple.Show(simple.OutputPort(handles, 2), view)
    curves.UseIndexForXAxis = 0
    curves.XArrayName = "Level"
    marks = ["StableLevel"] + ["RecommendedLevel"] * (handles.FieldData["RecommendedLevel"] is not None)
    names = ["Beta0", "Beta1", "Beta2", *marks]
    curves.SeriesVisibility = names
    curves.SeriesLabel = ["Beta0", "components", "Beta1", "tunnels", "Beta2", "cavities", "StableLevel",
                          "stable level", "RecommendedLevel", "recommended level"]
    curves.SeriesMarkerStyle = ["StableLevel", "4", "RecommendedLevel", "5"]
    curves.SeriesMarkerSize = ["StableLevel", "12", "RecommendedLevel", "12"]
    view.BottomAxisTitle = "level"
    view.LeftAxisTitle = "number"


def main(arguments):
    if {"-h", "--help"} & set(arguments):
        print(__doc__)
        return
    if not arguments:
        sys.exit(__doc__)
    picture = arguments[1] if len(arguments) > 1 else str(output_folder() / "map_handles.png")
    density = simple.OpenDataFile(arguments[0])
    handles = simple.MapHandles(Input=density)
    if len(arguments) > 2 and arguments[2] != "-":
        handles.Level = float(arguments[2])
    if len(arguments) > 4:
        handles.Range = [float(arguments[3]), float(arguments[4])]
    handles.UpdatePipeline()
    intervals = handles.GetClientSideObject().GetOutputDataObject(3)
    print("Levels at which nothing appears or goes, the longest first:")
    for row in range(min(5, intervals.GetNumberOfRows())):
        low, high, middle = (intervals.GetColumnByName(name).GetValue(row)
                             for name in ("From", "To", "Middle"))
        betti = [intervals.GetColumnByName(f"Beta{d}").GetValue(row) for d in range(3)]
        print(f"  {low:.4g} to {high:.4g}, middle {middle:.4g}: {betti[0]} components, {betti[1]} "
              f"tunnels, {betti[2]} cavities")
    layout = simple.CreateLayout("Map Handles")
    rendered = simple.CreateView("RenderView")
    simple.AssignViewToLayout(view=rendered, layout=layout, hint=0)
    chart = simple.CreateView("XYChartView")
    simple.AssignViewToLayout(view=chart, layout=layout, hint=0)
    layout.SetSize(1100, 500)
    show_map(handles, rendered)
    show_levels(handles, chart)
    simple.Render(rendered)
    simple.SaveScreenshot(picture, layout)
    print(picture)


if __name__ == "__main__":
    main(sys.argv[1:])
