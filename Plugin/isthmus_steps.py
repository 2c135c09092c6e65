"""The steps of the pipelines: the one table of their filters and of what differs from the filters' defaults.

The buttons and isthmus_pipelines.py make proxies of it, isthmus.map_to_loops() and the like run it on data.
Imports neither ParaView nor VTK.
"""
import collections

# label: registration name in the pipeline browser; properties: by their names in the panel.
Step = collections.namedtuple("Step", "label proxy properties")

DUST = 0.01  # components below that share of the largest one's area are hidden
DECAY = 1.2  # of the Gaussians of a molecular surface: BindingSites.md tells what it was tuned on
SPACING = 0.6  # angstrom, of a molecular surface's grid

_SURFACE_OF_A_MAP = Step("Surface", "MapSurface", {"MinimumComponentShare": DUST})
_CHAINS = Step("Chains", "AtomSelection", {})
_LIGANDS = Step("Ligands", "AtomSelection", {"KeepChains": 0, "KeepLigands": 1, "KeepIons": 1})
_DENSITY = Step("Molecular density", "MolecularDensity", {"Decay": DECAY, "Spacing": SPACING})
_SURFACE_OF_ATOMS = Step("Molecular surface", "MapSurface",
                         {"AutomaticLevel": 0, "Level": 1.0, "MinimumComponentShare": 0.05})

PIPELINES = {
    "map_to_surface": {"surface": _SURFACE_OF_A_MAP},
    "map_to_curvature": {"surface": _SURFACE_OF_A_MAP,
                         "curvature": Step("Curvature", "CurvatureOnSurface", {})},
    "map_to_loops": {
        "surface": _SURFACE_OF_A_MAP._replace(properties={"MinimumComponentShare": DUST, "LargestComponents": 10}),
        "loops": Step("Choking loops", "ChokingLoops", {})},
    "surface_to_loops": {"loops": Step("Choking loops", "ChokingLoops", {})},
    "protein_to_surface": {"chains": _CHAINS, "ligands": _LIGANDS, "density": _DENSITY,
                           "surface": _SURFACE_OF_ATOMS},
    "protein_to_potential": {
        "chains": _CHAINS, "ligands": _LIGANDS,
        "charges": Step("Charges", "ForceFieldCharges", {}),
        "density": _DENSITY, "surface": _SURFACE_OF_ATOMS,
        "potential": Step("Potential", "PoissonBoltzmannOnSurface",
                          {"IsoValue": 1.0, "SolventDielectric": 78.54, "IonicStrength": 0.15}),
        "curvature": Step("Curvature", "CurvatureOnSurface", {}),
        "polarized": Step("Polarized curvature", "PolarizedCurvature", {}),
        "sites": Step("Binding sites", "BindingSitesInPockets", {})},
    "protein_to_pockets": {"pockets": Step("Pockets", "MolecularPockets", {})},
    "protein_to_pores": {"pores": Step("Pores", "PoreProfile", {})},
}

NOTHING = {
    "volume": "The volume has no point array with one number at each node.",
    "surface": "No surface came out: all values of the map are alike, or all components were hidden as dust. "
               "Look at its values in the Information panel.",
    "loops": "The surface has no choking loops that could be found: the messages say why. Map Surface makes "
             "surfaces that are closed.",
    "chains": "The molecule has no atoms but water: open a file with a protein or nucleic acid.",
    "curvature": "The map is too small, or its surface too near its border: curvature needs three nodes inside of "
                 "the map on every side. Pad the map, or raise the level.",
    "pockets": "The molecule has no pockets of this size: lower Inner Radius, or raise Outer Radius, of Molecular "
               "Pockets.",
    "pores": "No channel runs through the molecule. Pore Profile follows the way between two points, or along a "
             "direction: choose its Mode.",
    "charges": "The atoms have no charges, from which the potential comes, and a force field gave them none; the "
               "message before this one says why. Or open a PQR file, or a potential's .dx file for Polarized "
               "Curvature.",
}
NO_POCKETS = ("The molecule has no pockets: the sites shown are patches of its surface (Use Pockets of Binding sites "
              "is off).")
INVERTED = ("The contrast of the map seems to be inverted, so Inside Is Higher was switched off. Switch it on, with an "
            "automatic level, if the density is brighter than the background.")
