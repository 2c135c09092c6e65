"""The steps of the pipelines: a table of their filters, with the properties that differ from the filters' defaults.

The buttons and pipelines.py create proxies from it; functions such as isthmus.map_to_loops() run it on data.
Imports neither ParaView nor VTK.
"""
import collections

# label: added to the name of the file in the pipeline browser; properties: by their names in the panel.
Step = collections.namedtuple("Step", "label proxy properties")

DUST = 0.01  # components smaller than this fraction of the largest one's area are hidden
DECAY = 1.2  # of the Gaussians of a molecular surface: BindingSites.md describes the data used for tuning
SPACING = 0.6  # angstrom, of a molecular surface's grid

# A map is denoised before its loops are searched if denoising removes at least half of its noise (EstimatedGain,
# dB) and the noise is at least this fraction of the range of the values. With white noise of 0.1 standard
# deviations or more, surfaces have handles caused by the noise; below 0.02 they have none.
LEAST_GAIN, LEAST_NOISE = 3.0, 0.005
MOST_FRAMES = 100  # of a trajectory whose loops are followed, which takes some seconds each
MOST_NODES = 30000000  # of a map whose noise is estimated, which takes about 30 s

# Properties that menus and buttons of the window set on a new filter, for a first look; scripts get all results.
# Testing/check_defaults.py compares the pipelines with it and with the panels.
# Contour a map: filters added from a menu copy the automatic level to the Level slider.
LEVELLED = ("MapSurface", "MapHandles", "DualContouring", "DelaunayIsosurface", "IsosurfaceStuffing")
WATER = {"SolventDielectric": 78.54, "IonicStrength": 0.15}  # at 25 degrees Celsius, with a cell's salt (mol/l)
SIGNIFICANT = {"MaximumNumberOfLoops": 20, "TrustedOnly": 1}  # few enough to look at, and not caused by the sampling
FIRST = {
    "ChokingLoops": SIGNIFICANT,
    "MapSurface": {"MinimumComponentShare": DUST},
    "MolecularDensity": {"Decay": DECAY, "Spacing": SPACING},
    "PoissonBoltzmann": WATER, "PoissonBoltzmannOnSurface": WATER,
}


def _step(label, proxy, **properties):
    """A step with the initial values of its filter and the additional properties of its place in the pipeline."""
    # Functions report all loops; buttons show the significant ones.
    first = FIRST.get(proxy, {}) if proxy != "ChokingLoops" else {}
    return Step(label, proxy, {**first, **properties})


_CHAINS = _step("chains", "AtomSelection")
_LIGANDS = _step("ligands", "AtomSelection", IncludeChains=0, IncludeLigands=1, IncludeIons=1)
_DENSITY = _step("density", "MolecularDensity")
_SURFACE_OF_ATOMS = _step("surface", "MapSurface", AutomaticLevel=0, Level=1.0, MinimumComponentShare=0.05)

PIPELINES = {
    "map_to_surface": {"surface": _step("surface", "MapSurface")},
    "map_to_curvature": {"surface": _step("surface", "MapSurface"),
                         "curvature": _step("curvature", "CurvatureOnSurface")},
    "map_to_loops": {
        "denoised": _step("denoised", "DenoiseMap"),
        "surface": _step("largest parts", "MapSurface", LargestComponents=10),
        "loops": _step("loops", "ChokingLoops")},
    "surface_to_loops": {"loops": _step("loops", "ChokingLoops")},
    "protein_to_surface": {"chains": _CHAINS, "ligands": _LIGANDS, "density": _DENSITY,
                           "surface": _SURFACE_OF_ATOMS},
    "protein_to_potential": {
        "chains": _CHAINS, "ligands": _LIGANDS,
        "charges": _step("charges", "ForceFieldCharges"),
        "density": _DENSITY, "surface": _SURFACE_OF_ATOMS,
        "potential": _step("potential", "PoissonBoltzmannOnSurface", Level=1.0),
        "curvature": _step("curvature", "CurvatureOnSurface"),
        "polarized": _step("polarized curvature", "PolarizedCurvature"),
        "sites": _step("sites", "BindingSitesInPockets")},
    "protein_to_pockets": {"pockets": _step("pockets", "MolecularPockets")},
    "protein_to_pores": {"pores": _step("pores", "PoreProfile")},
}



def stem_of(name):
    """The name of a file or source, without its endings: "GroEL" of "GroEL.map.gz"."""
    name = name.replace("\\", "/").rsplit("/", 1)[-1]
    while True:
        stem, dot, ending = name.rpartition(".")
        if not dot or not stem or not (ending.isalnum() and ending[0].isalpha() and len(ending) < 6):
            return name
        name = stem


def asks_for_denoising(gain, noise, low, high):
    """Whether a map should be denoised before its loops are searched, from the estimated gain (dB) and noise level
    of Denoise Map (None if unknown) and the range of the map's values."""
    return gain is not None and noise is not None and gain >= LEAST_GAIN and noise >= LEAST_NOISE * (high - low)


NOTHING = {
    "volume": "The volume has no point array with one number at each node.",
    "surface": "The surface is empty: all values of the map are equal, or all components were hidden as dust. "
               "Look at the values in the Information panel.",
    "loops": "No choking loops of the surface were found; the messages say why. Map Surface makes closed surfaces.",
    "chains": "The molecule has no atoms but water: open a file with a protein or nucleic acid.",
    "curvature": "The map is too small, or its surface too near its border: curvature needs three nodes inside of "
                 "the map on every side. Pad the map, or raise the level.",
    "pockets": "The molecule has no pockets of this size: lower Inner Radius, or raise Outer Radius, of Molecular "
               "Pockets.",
    "pores": "No channel runs through the molecule. Pore Profile can follow a path between two points or along a "
             "direction: choose its Mode.",
    "frames": "This needs a trajectory, that is a molecule, map or closed surface with several time steps: open a DCD, "
              "XTC or TRR file, a PDB file with several models, or a series of files.",
    "tracks": "No choking loop of this surface is found in two frames.",
    "charges": "The atoms have no charges, which the potential needs, and the force field could not assign any; the "
               "previous message says why. Alternatives: open a PQR file, or a potential (.dx) for Polarized Curvature.",
}
NO_POCKETS = ("The molecule has no pockets: the sites shown are patches of its surface (Use Pockets of Binding sites "
              "is off).")
INVERTED = ("The contrast of the map seems to be inverted, so Inside Is Higher was switched off. Switch it on, with an "
            "automatic level, if the density is brighter than the background.")
