"""A table of the data of GuardsWindow.py, drawn once more after the layout has dropped its view."""

import os

from paraview import simple

source = simple.OpenDataFile(os.environ["ISTHMUS_SESSION_DATA"])
view = simple.GetActiveViewOrCreate("RenderView")
sheet = simple.CreateView("SpreadSheetView")
layout = simple.GetLayout(view)
layout.SplitViewVertical(view, 0.5)
simple.AssignViewToLayout(view=sheet, layout=layout, hint=2)
simple.Show(source, sheet, "SpreadSheetRepresentation")
simple.Render(sheet)
layout.SMProxy.RemoveView(sheet.SMProxy)
simple.Render(sheet)
