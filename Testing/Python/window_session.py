"""What ParaViewWindow.py has a user do in the window. Writes done.txt when it has been done."""

import os
import traceback
from pathlib import Path

from paraview import simple

folder = Path(os.environ["ISTHMUS_SESSION_DIR"])
try:
    density = simple.OpenDataFile(str(folder / "phantom.map"))
    surface = simple.Contour(Input=density, ContourBy=["POINTS", "Density"], Isosurfaces=[0.5])
    curvature = simple.HessianCurvature(Input=density, Surface=surface)
    view = simple.GetActiveViewOrCreate("RenderView")
    display = simple.Show(curvature, view)
    simple.ColorBy(display, ("POINTS", "MeanCurvature"))
    display.RescaleTransferFunctionToDataRange(False)
    display.SetScalarBarVisibility(view, True)
    simple.SetActiveSource(curvature)
    simple.ResetCamera(view)
    simple.Render(view)
    said = f"{density.GetXMLName()} {curvature.GetXMLName()}"
except Exception:
    said = traceback.format_exc()
(folder / "done.tmp").write_text(said)
(folder / "done.tmp").rename(folder / "done.txt")
