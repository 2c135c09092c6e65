"""Each button of the Isthmus toolbar and README's first recipe in the real ParaView's window.

ParaView opens shared data by its command line and plays what a user does with its own recorder
(--test-script): Apply, a button of the toolbar (once without Apply before), an entry of the menu.
The dialog that asks for a second input is answered by the mouse (xdotool). The log must have no
warning, and the result must be in the picture of the window, which is kept beside the test's other
output.
"""

import shutil

from window_play import APPLY, NOTHING_TO_APPLY, PANEL, button, entry, play_all

# In the dialog that asks for the second input: Volume, the first source of its list, OK. Then Apply.
ANSWERS = ((17, 74), (231, 48), (362, 376))
PROTEIN = "molecules/1AJJ_pH7_PARSE.pqr"
BARE_PROTEIN = "molecules/1ubq.pdb" if shutil.which("pdb2pqr") else PROTEIN  # that finds its charges
NO_LEVEL = (PANEL + "Level", "check visible", "false")  # where no volume is the surface
PROTEIN_WITH_POCKETS = "molecules/1hew/1hew.pqr"  # the other has none, of which the window warns

# Name, data, what the user does, least share of strongly coloured pixels, clicks in a dialog.
SESSIONS = (
    ("curvature_on_surface", "maps/emd_1832.map", [button(0), entry("CurvatureOnSurface")], 0.02, ANSWERS),
    ("map_to_surface", "maps/emd_1832.map", [button(0), NOTHING_TO_APPLY], 0.0, ()),
    ("map_to_curvature", "maps/emd_5043.map", [button(1)], 0.02, ()),
    ("map_to_loops", "maps/emd_1832.map", [button(2)], 0.003, ()),
    ("protein_to_surface", PROTEIN, [button(3)], 0.0, ()),
    ("potential", BARE_PROTEIN, [entry("PoissonBoltzmann"), NO_LEVEL, APPLY], 0.005, ()),
    ("protein_to_sites", PROTEIN_WITH_POCKETS, [button(4)], 0.001, ()),
    ("surface_to_loops", "surfaces/torus.obj", [button(5)], 0.0005, ()),
    ("persistence_diagram", "surfaces/torus.obj", [button(5), button(6)], 0.0005, ()),
)

play_all("Toolbar", SESSIONS)
