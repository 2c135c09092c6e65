"""A first Apply of the panels that no recipe of the README opens, in the real ParaView's window: the entry
of the menu on shared data, Apply, and the picture. The log must have no warning.

The pictures are kept beside the test's other output; what they show was looked at.
"""

from window_play import APPLY, entry, play_all

PROTEIN = "molecules/1AJJ_pH7_PARSE.pqr"
LYSOZYME = "molecules/1hew/1hew.pqr"
MAP = "maps/emd_1832.map"


def first_apply(name):
    return [entry(name), APPLY]


# Name, data, what the user does, least share of strongly coloured pixels, clicks in a dialog.
SESSIONS = (
    ("molecular_pockets", LYSOZYME, first_apply("MolecularPockets"), 0.001, ()),
    ("pore_profile", "molecules/channels/1grm_hole_example.pdb", first_apply("PoreProfile"), 0.001, ()),
    ("molecular_flow_surface", PROTEIN, first_apply("MolecularFlowSurface"), 0.0, ()),
    ("nonpolar_solvation", PROTEIN, first_apply("NonpolarSolvation"), 0.001, ()),
    ("poisson_boltzmann", PROTEIN, first_apply("PoissonBoltzmann"), 0.001, ()),
    ("feature_tracks", "molecules/2kix.pdb",
     first_apply("MolecularPockets") + first_apply("FeatureTracks"), 0.0, ()),
    ("isosurface_stuffing", MAP, first_apply("IsosurfaceStuffing"), 0.0, ()),
    ("dual_contouring", MAP, first_apply("DualContouring"), 0.0, ()),
    ("map_handles", MAP, first_apply("MapHandles"), 0.001, ()),
    ("fullerene_stability", "fullerenes/c60.xyz", first_apply("FullereneStability"), 0.0, ()),
    ("offset_surface", "surfaces/torus.obj", first_apply("OffsetSurface"), 0.0, ()),
    ("tet_cutaway", "volumes/tetraMesh.vtk", first_apply("TetCutaway"), 0.0, ()),
)

play_all("PanelsByMouse", SESSIONS)
