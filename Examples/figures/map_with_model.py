"""A map with its model: the density of GroEL and GroES (PDB 1AON, computed from the atoms), coloured by the nearest chain,
and the chains as a cartoon.

Usage: pvpython map_with_model.py [FOLDER]. FOLDER: for the figure (PNG and SVG); default: a temporary one.
"""

from common import data, look_from, new_view, write
from paraview import simple

from isthmus_plugin import pipelines
from isthmus_plugin import molecule_views as molecules

model, view = data("molecules/1aon.pdb.gz"), new_view()
density = simple.MolecularDensity(simple.AtomSelection(model), Spacing=2.0, Decay=0.3)
cartoon, coloured = pipelines.map_with_model(density, model, level=1.0)
molecules.show_with_map(cartoon, coloured, view)
print(pipelines.overlap(density, model, pipelines.map_to_surface(density, 1.0)[0])[1])
look_from(view, (1.0, 0.0, 0.0), 1.3)
write(view, "map_with_model", silhouettes=False)
