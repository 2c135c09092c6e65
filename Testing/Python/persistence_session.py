"""What PersistenceWindow.py has a user do: a map, its Betti curves, its diagram, and a bar picked."""

import os
import traceback
from pathlib import Path

from paraview import simple

folder = Path(os.environ["ISTHMUS_SESSION_DIR"])
try:
    density = simple.OpenDataFile(os.environ["ISTHMUS_SESSION_MAP"])
    persistence = simple.ScalarPersistence(
        Input=density, Superlevel=1, MinimumPersistence=0.5, Range=[0.2, 10.0])
    view = simple.GetActiveViewOrCreate("RenderView")
    layout = simple.GetLayout(view)
    surface = simple.Show(
        simple.Contour(Input=density, ContourBy=["POINTS", "Density"], Isosurfaces=[1.5]), view)
    surface.Opacity = 0.3
    # ParaView 5.11 shows selections of first outputs only, so the saddles go through one.
    points = simple.PassArrays(
        Input=simple.OutputPort(persistence, 2),
        PointDataArrays=["FeatureId", "Dimension", "Birth", "DeathShown", "CriticalIndex"])
    saddles = simple.Show(points, view)
    saddles.PointSize = 6
    saddles.SelectionPointSize = 16
    saddles.RenderPointsAsSpheres = 1
    simple.ResetCamera(view)
    view.GetActiveCamera().Elevation(80)

    # The diagram: the same points by birth and death, so that a selection is one and the same.
    layout.SplitHorizontal(0, 0.5)
    diagram = simple.CreateView("XYChartView")
    simple.AssignViewToLayout(view=diagram, layout=layout, hint=2)
    bars = simple.Show(points, diagram, "XYChartRepresentation")
    bars.AttributeType = "Point Data"
    bars.UseIndexForXAxis = 0
    bars.XArrayName = "Birth"
    bars.SeriesVisibility = ["DeathShown"]
    bars.SeriesLineStyle = ["DeathShown", "0"]
    bars.SeriesMarkerStyle = ["DeathShown", "4"]
    bars.SeriesMarkerSize = ["DeathShown", "8"]
    diagram.BottomAxisTitle = "Birth"
    diagram.LeftAxisTitle = "Death"

    layout.SplitVertical(2, 0.5)
    curves = simple.CreateView("XYChartView")
    simple.AssignViewToLayout(view=curves, layout=layout, hint=6)
    lines = simple.Show(simple.OutputPort(persistence, 0), curves)
    lines.UseIndexForXAxis = 0
    lines.XArrayName = "Level"
    lines.SeriesVisibility = ["FilteredBeta0", "FilteredBeta1", "FilteredBeta2"]
    simple.SetActiveView(view)
    simple.SetActiveSource(persistence)
    if not os.environ.get("ISTHMUS_SESSION_BY_HAND"):
        simple.QuerySelect(QueryString="FeatureId == 40", FieldType="POINT", Source=points)
    simple.RenderAllViews()
    said = f"done {persistence.GetXMLName()}"
except Exception:
    said = traceback.format_exc()
(folder / "done.tmp").write_text(said)
(folder / "done.tmp").rename(folder / "done.txt")
