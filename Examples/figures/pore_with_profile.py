"""The pore of gramicidin A (PDB 1GRM): its surface, coloured by the room for water, and the radius along it.

Usage: pvpython pore_with_profile.py [FOLDER]. FOLDER: for the figures (PNG and SVG); default: a temporary one.
"""

from common import data, look_from, new_view, write
from paraview import simple

from isthmus_plugin import pipelines

view = new_view()
pores = pipelines.protein_to_pores(data("molecules/channels/1grm_hole_example.pdb"))[-1]
pipelines.show(pores, view=view, tables=True)
(chart,) = [other for other in simple.GetViews() if other.SMProxy.GetXMLName() == "XYChartView"]
simple.SetActiveView(view)
for display in view.Representations:
    if display.SMProxy.GetXMLName() == "DataLabelRepresentation":
        display.Visibility = 0  # names of residues, too small for print
look_from(view, (1.0, 0.0, 0.0), 1.0)
write(view, "pore")
chart.ViewSize = [1000, 760]
write(chart, "pore_profile")
