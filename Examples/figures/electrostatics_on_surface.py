"""The electrostatic potential of lysozyme (PDB 1HEW) on its surface, by the Poisson-Boltzmann equation.

Usage: pvpython electrostatics_on_surface.py [FOLDER]. FOLDER: for the figure (PNG and SVG); default: a temporary one.
"""

from common import data, look_from, new_view, write
from paraview import simple

from isthmus_plugin import pipelines

view = new_view()
sites = pipelines.protein_to_sites(data("molecules/1hew/1hew.pqr"))[-1]
display = pipelines.show(sites, view=view)
simple.ColorBy(display, ("POINTS", "Potential"))
pipelines.first_look(display.GetGlobalID())
display.SetScalarBarVisibility(view, True)
simple.HideUnusedScalarBars(view)
look_from(view, (0.3, 0.2, -1.0), 1.35)
write(view, "electrostatics_on_surface", silhouettes=False)
