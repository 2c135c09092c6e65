"""Lysozyme (PDB 1HEW) as a cartoon, with the inhibitor as balls and sticks in the best pocket.

Usage: pvpython cartoon_with_pocket.py [FOLDER]. FOLDER: for the figure (PNG and SVG); default: a temporary one.
"""

from common import data, look_from, new_view, write
from paraview import simple

from isthmus_plugin import molecule_views as molecules
from isthmus_plugin import pocket_views as pockets

atoms, view = data("molecules/1hew.pdb"), new_view()
cartoon = simple.MoleculeCartoon(atoms)
molecules.show(cartoon, view)
found = simple.MolecularPockets(atoms, FindSites=0)
pocket = simple.Show(pockets.surface_of(found, "best pocket", 1), view)
pocket.ColorArrayName = ["POINTS", ""]
pocket.DiffuseColor, pocket.Opacity = [0.95, 0.80, 0.20], 0.5
look_from(view, (-0.75, 0.15, 0.65), 1.4)
write(view, "cartoon_with_pocket")
