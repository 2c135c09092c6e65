"""Whole pipelines with good defaults, and the default display of results of Isthmus' filters.

    from isthmus import pipelines                 # or: from isthmus_plugin, with the plugin loaded
    surface, loops = pipelines.map_to_loops(OpenDataFile("emd_5043.map"))
    pipelines.show(surface, loops)

Each of the functions takes a source and returns a tuple of the last proxies, the main one last;
all are ordinary filters whose properties can be changed. They use proxies only, so that the data stays
on the server, wherever that is. A pipeline that is impossible raises a ValueError with one sentence.

The buttons of the toolbar are run(); the window calls first_look() for each result
(look.py).
"""

import importlib
import json
import os

from vtkmodules.vtkCommonCore import vtkOutputWindow

try:
    from paraview import servermanager, simple
except ImportError:
    # With the vtk package alone, the module can be imported; its functions report what they need (end of this file).
    servermanager = simple = None

from . import cameras, comparisons, diagram_views, entries, figures, levels, look, loop_views, messages, steps, track_views
from . import molecule_views as molecules

from . import pocket_views as pockets_and_pores

DUST, DECAY, SPACING = steps.DUST, steps.DECAY, steps.SPACING
# Filters that pass on the atoms of a molecule, as the buttons put them in.
PARTS = ("AtomSelection", "ForceFieldCharges")
DENOISERS = ("DenoiseMap", "DenoiseFromHalfMaps", "HighOrderDiffusion", "PDETransform")
# Options that buttons pass to the functions: of many loops only the significant ones.
BY_BUTTON = {"map_to_loops": {"significant": True}, "surface_to_loops": {"significant": True}}

CURVATURES, FIXED = look.CURVATURES, look.FIXED
colour_range, first_look, first_values, show = look.colour_range, look.first_look, look.first_values, look.show
figure, save_figure, change_look = figures.figure, figures.save_figure, figures.change_look
background, soft_shadows, scale_bar = figures.background, figures.soft_shadows, figures.scale_bar
keep_looks, show_loops = look.keep_looks, diagram_views.show_loops
live_change, preview_level, end_preview = look.live_change, look.preview_level, look.end_preview


# ---------------------------------------------------------------------------- what a source is

def _is_volume(source):
    return look.data_of(source).GetDataSetType() in (6, 10) or (
        look.data_of(source).GetDataSetTypeAsString() == "vtkImageData")


def _require_volume(source):
    if look.data_of(source).GetDataSetTypeAsString() == "vtkImageData" and not look.data_of(source).GetNumberOfPoints():
        raise ValueError("There is no map: the file could not be read. The window Output Messages says why.")
    if not _is_volume(source):
        raise ValueError("This needs a density map (a volume): select one in the pipeline browser, "
                         "or open one by File > Open.")
    if not _point_array(source):
        raise ValueError(steps.NOTHING["volume"])


def _require_surface(source):
    if look.data_of(source).GetDataSetTypeAsString() != "vtkPolyData" or (
            not look.data_of(source).GetNumberOfCells()):
        raise ValueError("This needs a closed surface of triangles: select one in the pipeline "
                         "browser; Map to surface makes one of a density map.")


def _require_one(source, what):
    """Most filters process groups block by block, but not on the second input of a filter."""
    if look.data_of(source).GetCompositeDataSetType() != -1:
        raise ValueError(f"This works on one {what}, and a group is selected: extract it by Extract Block.")


def _has_atoms(source):
    look.data_of(source)
    return source.PointData["Radius"] is not None


def _require_atoms(source):
    if not _has_atoms(source):
        raise ValueError("This needs a molecule with radii: open a PDB, mmCIF or PQR file and select "
                         "it in the pipeline browser.")


def _point_array(source):
    """Name of the scalars of a volume: the active ones, otherwise the first with one component."""
    data = source.PointData
    active = look.data_of(source).GetPointDataInformation().GetAttributeInformation(0)
    if active and active.GetNumberOfComponents() == 1:
        return active.GetName()
    names = [data.GetArray(i).Name for i in range(data.GetNumberOfArrays())
             if data.GetArray(i).GetNumberOfComponents() == 1]
    return names[0] if names else None


def _field_number(source, name):
    """A number of the field data, without fetching the data; None where there is none."""
    field = source.FieldData[name]
    return field.GetRange(0)[0] if field else None


def _require_triangles(surface):
    if not look.data_of(surface).GetNumberOfCells():
        raise ValueError(steps.NOTHING["surface"])


# ---------------------------------------------------------------------------- the pipelines

def _make(pipeline, name, source, hidden=False, **more):
    """The filter of a step of steps.PIPELINES, with a descriptive name. hidden: a part of a result, which the pipeline
    browser leaves out."""
    step = steps.PIPELINES[pipeline][name]
    label = pockets_and_pores.name_of(source, step.label)
    messages.step(label)
    return entries.make(step.proxy, source, label, hidden, follows=False, **{**step.properties, **more})


def map_to_surface(source, level=None):
    """(surface,): the map's closed surface; at the recommended or an automatic level where none is
    given, which is then shown in the panel."""
    return (_surface_of_map("map_to_surface", source, level),)


def _surface_of_map(pipeline, source, level=None):
    """The surface of a map as in that pipeline."""
    _require_volume(source)
    surface = _make(pipeline, "surface", source, Scalars=["POINTS", _point_array(source)])
    if level is not None:
        surface.AutomaticLevel, surface.Level = 0, level
    surface.UpdatePipeline()
    if surface.FieldData["InvertedContrast"]:
        # The filter has issued a warning. The user can change the property back in the panel.
        surface.InsideIsHigher = 0
        surface.UpdatePipeline()
        vtkOutputWindow.GetInstance().DisplayWarningText(f"Isthmus: {steps.INVERTED}\n")
    _require_triangles(surface)
    surface.Level = _field_number(surface, "Level")
    surface.AutomaticLevel = 0
    surface.UpdatePipeline()
    return surface


def map_to_curvature(source, level=None):
    """(surface, curvature): the map's surface coloured by the curvature of the map there, at the scale
    that Curvature On Surface chooses by default."""
    _require_volume(source)
    _require_one(source, "map")
    (surface,) = map_to_surface(source, level)
    return _with_curvature(surface, source)


def _with_curvature(surface, source):
    """(surface, curvature) of a surface of that map."""
    curvature = _make("map_to_curvature", "curvature", surface, Volume=source,
                      Scalars=["POINTS", _point_array(source)])
    curvature.UpdatePipeline()
    if look.range_by_area(curvature, "POINTS", "MeanCurvature") is None:
        raise ValueError(steps.NOTHING["curvature"])
    return surface, curvature


def map_to_loops(source, level=None, denoise=None, significant=False):
    """(surface, loops): the map's surface, of no more than its ten largest components, and its
    choking loops.

    denoise: whether the map is denoised first (Denoise Map); None: if its noise requires it, i.e. if the noise
    is at least half a percent of the map's range, and the estimated gain at least 3 dB.
    significant: the 20 most persistent loops that are trusted, as the button shows; else all of them."""
    _require_volume(source)
    source = _denoised(source, denoise)
    surface = _surface_of_map("map_to_loops", source, level)
    return surface, surface_to_loops(surface, significant)[-1]


def _denoised(source, denoise):
    """The map, denoised if requested, or, with None, if its noise requires it."""
    information = look.data_of(source)
    if denoise is False or information.GetCompositeDataSetType() != -1 or denoise is None and (
            information.GetNumberOfPoints() > steps.MOST_NODES or _is_denoised(source)):
        return source
    array = _point_array(source)
    made = _make("map_to_loops", "denoised", source, Scalars=["POINTS", array])
    if not denoise:
        _hide_warnings(made)
    made.UpdatePipeline()
    if denoise or steps.asks_for_denoising(_field_number(made, "EstimatedGain"), _field_number(made, "NoiseLevel"),
                                           *source.PointData[array].GetRange(0)):
        return made
    simple.Delete(made)
    return source


def _hide_warnings(source):
    """Hides a filter's warning about a map without noise, which does not concern the loops."""
    try:
        # Python cannot instantiate a class that it has first seen as an object of C++.
        importlib.import_module("isthmus.vtkIsthmusFiltersImaging")
    except ImportError:
        pass  # ParaView without the package
    algorithm = source.GetClientSideObject()  # None where a server has it, whose warnings stay there
    if algorithm is not None:
        algorithm.AddObserver("WarningEvent", lambda *_: None)


def _is_denoised(source):
    """Whether the map comes from a filter that denoises it."""
    proxy = source.SMProxy
    while proxy.GetXMLName() not in DENOISERS:
        if not proxy.GetNumberOfProducers():
            return False
        proxy = proxy.GetProducerProxy(0)
    return True


def surface_to_loops(source, significant=False):
    """(loops,): the choking loops of a closed surface; significant: the 20 most persistent loops that are
    trusted, as the button shows; else all of them."""
    _require_surface(source)
    loops = _make("surface_to_loops", "loops", source, **(steps.SIGNIFICANT if significant else {}))
    loops.UpdatePipeline()
    if loops.FieldData["NumberOfSamples"] is None:
        # Closes holes and orients all triangles consistently; the warning reports the changes.
        loops.CapHoles = 1
        loops.UpdatePipeline()
    if loops.FieldData["NumberOfSamples"] is None:
        raise ValueError(steps.NOTHING["loops"])
    if significant:
        loop_views.show_radius(loops)
    return (loops,)


def trajectory_to_loops(source, frames=steps.MOST_FRAMES):
    """(loops, tracks): the significant choking loops in each frame of a molecule, map or closed surface with time
    steps, and their tracks from frame to frame, with the radius of each over time (track_views).

    A molecule's loops are those of the surface of its chains, a map's those at the level of its first frame. frames: the
    maximum number of analysed frames; of more frames, every second, third, ... is used."""
    times = track_views.times_of(source)
    if len(times) < 2:
        raise ValueError(steps.NOTHING["frames"])
    moving = source
    if len(times) > frames:
        moving = entries.make(
            "ExtractTimeSteps", source, pockets_and_pores.name_of(source, "frames"), follows=False,
            SelectionMode="Select Time Range", TimeStepRange=[0, len(times) - 1], TimeStepInterval=-(-len(times) // frames))
        times = times[::-(-len(times) // frames)]
    moving.UpdatePipeline(times[0])
    if _has_atoms(moving):
        surface = _molecule(_chains(moving, hidden=True), hidden=("density",))[1]
    elif _is_volume(moving):
        surface = _surface_of_map("map_to_loops", moving)
    else:
        surface = moving
    (loops,) = surface_to_loops(surface, significant=True)
    tracks = simple.FeatureTracks(
        simple.OutputPort(loops, loop_views.CHOKE_POINTS), MinimumLength=2,
        registrationName=pockets_and_pores.name_of(source, "loops over time"))
    track_views.report_frames(tracks, len(times))
    tracks.UpdatePipeline()
    messages.step()
    if not track_views.series_of(tracks):
        raise ValueError(steps.NOTHING["tracks"])
    return loops, tracks


def protein_to_surface(source):
    """(surface,) or (ligands, surface): the smooth molecular surface of the chains, without cavities
    smaller than a twentieth of it; the ligands and ions, if there are any. Water is left out; the
    switches of Atom Selection add it, or ligands, to the surface."""
    chains, ligands = _parts(source)
    surface = _molecule(chains)[1]
    return (ligands, surface) if ligands else (surface,)


def protein_to_sites(source, potential=None):
    """(potential, sites) or (potential, ligands, sites): the surface with potential, polarized curvature
    and likely binding sites, which are the pockets; or patches of the surface, where the molecule has no
    pocket. Ligands and ions, if there are any, are not included.

    potential: a source of it (kT/e) on a grid, for instance an opened .dx file. Without one it is computed
    from the charges of the chains in 0.15 mol/l of salt; File > Save Data keeps it as a .dx file. A PQR
    file has charges; those of a PDB or mmCIF file are a force field's (Force Field Charges, by the
    program pdb2pqr).
    """
    _require_atoms(source)
    _require_one(source, "molecule")
    chains, ligands = _parts(source, hidden=True)
    if potential is None:
        chains = _charged(chains)
    density, surface = _molecule(chains, hidden=("density", "surface"))
    if potential is None:
        potential = _make("protein_to_potential", "potential", chains, Surface=density)
        potential.UpdatePipeline()
    curvature = _make("protein_to_potential", "curvature", surface, hidden=True, Volume=density,
                      Scalars=["POINTS", "Density"])
    curvature.UpdatePipeline()
    polarized = _make("protein_to_potential", "polarized", curvature, hidden=True, PotentialImage=potential)
    polarized.UpdatePipeline()
    sites = _make("protein_to_potential", "sites", polarized, Atoms=chains,
                  RankedArray=["POINTS", "PolarizedCurvature"])
    sites.UsePockets = int(_has_pockets(chains))  # checked first, since the filter would warn as well
    sites.UpdatePipeline()
    if not sites.UsePockets:
        messages.show_note(steps.NO_POCKETS)
    return (potential, ligands, sites) if ligands else (potential, sites)


def _has_pockets(atoms):
    pockets = simple.MolecularPockets(atoms)
    pockets.FindSites = 0  # Binding Sites looks in whole pockets
    pockets.UpdatePipeline()
    count = simple.OutputPort(pockets, 1).GetDataInformation().GetNumberOfRows()
    simple.Delete(pockets)
    return count > 0


def protein_to_pockets(source):
    """(residues, pockets): the pockets of a molecule, ranked, and the residues of the best one."""
    _require_atoms(source)
    return pockets_and_pores.protein_to_pockets(source)


def protein_to_pores(source):
    """(chart, residues, pores): the channels that run through a molecule, the radius along the longest
    one, and the residues that line it."""
    _require_atoms(source)
    return pockets_and_pores.protein_to_pores(source)


FITTED, PARTLY = 0.6, 0.3  # shares of atoms inside the contour from which a model is fitted, or partly


def map_with_model(source, model=None, level=None):
    """(cartoon, coloured): a model, and the surface of its map coloured by the nearest chain (array ChainIndex, of the
    nearest residue). overlap() says whether the model is fitted to the map.

    model: None: the only molecule that is open."""
    _require_volume(source)
    if model is None:
        known = [each for each in simple.GetSources().values() if each.SMProxy.GetXMLName() in look.MOLECULES]
        if len(known) != 1:
            raise ValueError(f"The map needs one model beside it, and {len(known) or 'no'} molecules are open: open the "
                             "PDB or mmCIF file of the model, and close others.")
        model = known[0]
    surface, _, cartoon = _map_and_model(source, model, level)
    coloured = _nearest(simple.OutputPort(cartoon, molecules.RESIDUES), surface, "chains")
    messages.show_note(overlap(source, model, surface)[1])
    return cartoon, coloured


def density_around(source, model, residues=None, reach=4.0, level=None):
    """(atoms, part): those atoms of a model, and the surface of its map up to `reach` angstrom from them.

    residues: names (NAG), numbers (57) or numbers with a chain (A:57), separated by blanks; None: the ligands."""
    surface, ligands, _ = _map_and_model(source, model, level, cartoon=False)
    if residues is None and ligands is None:
        raise ValueError("The model has no ligand: name residues to see the density around.")
    atoms = ligands if residues is None else molecules.atoms_of(model, residues)
    placed = simple.Calculator(atoms, ResultArrayName="Place", Function="coords",
                               registrationName=pockets_and_pores.name_of(model, "places"))
    nearest = _nearest(placed, surface, "nearest atoms")
    distances = simple.Calculator(nearest, ResultArrayName="Distance", Function="mag(coords-Place)",
                                  registrationName=pockets_and_pores.name_of(source, "distances"))
    part = simple.Clip(distances, registrationName=pockets_and_pores.name_of(source, "around residues"),
                       ClipType="Scalar", Scalars=["POINTS", "Distance"], Value=reach, Invert=1)
    part.UpdatePipeline()
    if not look.data_of(part).GetNumberOfCells():
        raise ValueError(f"The surface of the map has no point within {reach:g} angstrom of these residues: lower the "
                         "level, or check whether the model is fitted to the map.")
    return atoms, part


def overlap(source, model, surface=None):
    """(share, words): the share of the atoms of a model, without ligands, ions and water, that are inside the contour of
    its map, and whether the model is fitted, partly fitted or not fitted.

    surface: a Map Surface of the map, whose level is the contour's; None: the level of Map Surface."""
    if surface is None:
        (surface,) = map_to_surface(source)
    chains = _chains(model)
    name = _point_array(source)
    level, above = _field_number(surface, "Level"), surface.InsideIsHigher
    sampled = simple.ResampleWithDataset(SourceDataArrays=source, DestinationMesh=chains)
    messages.step("atoms inside the contour")
    on_map = simple.Threshold(sampled, Scalars=["POINTS", "vtkValidPointMask"], ThresholdMethod="Above Upper Threshold",
                              UpperThreshold=0.5)
    inside = simple.Threshold(on_map, Scalars=["POINTS", name], LowerThreshold=level, UpperThreshold=level,
                              ThresholdMethod=f"{'Above Upper' if above else 'Below Lower'} Threshold")
    inside.UpdatePipeline()
    count, total = (look.data_of(each).GetNumberOfPoints() for each in (inside, chains))
    for made in (inside, on_map, sampled, chains):
        simple.Delete(made)
    share = count / total
    verdict = ("fitted" if share >= FITTED else "partly fitted" if share >= PARTLY else
               "not fitted: most of it is outside the density")
    return share, f"{100.0 * share:.0f} % of {total} atoms are inside the contour: the model is {verdict}."


def _map_and_model(source, model, level, cartoon=True):
    """(surface, ligands, cartoon)"""
    _require_volume(source)
    _require_one(source, "map")
    _require_atoms(model)
    _require_one(model, "molecule")
    (surface,) = map_to_surface(source, level)
    if cartoon:
        name = pockets_and_pores.name_of(model, "cartoon")
        messages.step(name)
        made = simple.MoleculeCartoon(model, registrationName=name)
        made.UpdatePipeline()
        return surface, None, made
    chains, ligands = _parts(model)
    simple.Delete(chains)
    return surface, ligands, None


def _nearest(points, surface, what):
    """The surface with the arrays of the nearest of the points."""
    messages.step(what)
    return entries.make(
        "PointDatasetInterpolator", points, pockets_and_pores.name_of(surface, what), hidden=False, follows=False,
        Source=surface, Kernel="VoronoiKernel", PassPointArrays=1)


def _chains(source, hidden=False):
    """The atoms without ligands, ions and water."""
    _require_atoms(source)
    chains = _make("protein_to_surface", "chains", source, hidden)
    chains.UpdatePipeline()
    if not look.data_of(chains).GetNumberOfPoints():
        raise ValueError(steps.NOTHING["chains"])
    return chains


def _parts(source, hidden=False):
    """(chains, ligands), the latter with ions; None without any. hidden: the chains."""
    chains = _chains(source, hidden)
    ligands = _make("protein_to_surface", "ligands", source)
    ligands.UpdatePipeline()
    if not look.data_of(ligands).GetNumberOfPoints():
        simple.Delete(ligands)
        ligands = None
    return chains, ligands


def _charged(atoms):
    """The atoms with charges: those of their file, or a force field's."""
    charged = _make("protein_to_potential", "charges", atoms, hidden=True)
    charged.UpdatePipeline()
    if not look.data_of(charged).GetNumberOfPoints():
        raise ValueError(steps.NOTHING["charges"])
    return charged


def _molecule(source, hidden=()):
    """Density and surface of the atoms. hidden: those that the pipeline browser leaves out."""
    density = _make("protein_to_surface", "density", source, "density" in hidden)
    surface = _make("protein_to_surface", "surface", density, "surface" in hidden, Scalars=["POINTS", "Density"])
    surface.UpdatePipeline()
    _require_triangles(surface)
    return density, surface


# ---------------------------------------------------------------------------- charts, buttons, states

def state(function, example):
    """Does what the state files of Examples/states do: shows the pipeline on the file $ISTHMUS_FILE, or else on
    `example` in the folder $ISTHMUS_DATA_DIR. Returns the last proxies."""
    path = os.environ.get("ISTHMUS_FILE")
    if not path and os.environ.get("ISTHMUS_DATA_DIR"):
        path = os.path.join(os.environ["ISTHMUS_DATA_DIR"], example)
    if not path or not os.path.exists(path):
        raise ValueError(f"There is no file {path or ''} to open: set ISTHMUS_FILE to one, or "
                         f"ISTHMUS_DATA_DIR to the folder that has {example}.")
    source = simple.OpenDataFile(path)
    proxies = globals()[function](source, **BY_BUTTON.get(function, {}))
    show(*proxies)
    simple.SetActiveSource(proxies[-1])
    return proxies


def persistence_diagram(source):
    """(chart,): the persistence diagram of Choking Loops or Scalar Persistence in a chart view beside the active view:
    births across, deaths upwards, a colour for each kind, a symbol for each side, and the threshold as a line. A loop
    that is selected in the chart is selected in the view, too, and the other way round."""
    return (diagram_views.show(source),)


def _upstream(source, fits):
    """The nearest suitable source upstream of source (or source itself); source if none is suitable."""
    waiting, met, selected = [source.SMProxy], set(), source.SMProxy
    while waiting:
        proxy = waiting.pop(0)
        if proxy.GetGlobalID() in met:
            continue
        met.add(proxy.GetGlobalID())
        candidate = servermanager._getPyProxy(proxy)
        if fits(candidate) and (proxy == selected or not _is_part(candidate)):
            return candidate
        waiting += [proxy.GetProducerProxy(i) for i in range(proxy.GetNumberOfProducers())
                    if proxy.GetProducerProxy(i).IsA("vtkSMSourceProxy")]
    return source


def _is_part(source):
    """Whether a button has inserted the filter: a result does not depend on which source was selected."""
    name = source.SMProxy.GetXMLName()
    return name in PARTS or name == "DenoiseMap" and " denoised" in loop_views.registered_name(source)


def _fits(function):
    """The input of a button: with a map's surface selected, Map to curvature goes back to the map."""
    if function.startswith("map_"):
        return _is_volume
    if function.startswith("protein_"):
        return lambda source: _has_atoms(source) and source.PointData["Element"] is not None
    if function == "trajectory_to_loops":
        return _moves
    if function == "persistence_diagram":
        return lambda source: source.SMProxy.GetXMLName() in diagram_views.DIAGRAMS
    return lambda source: True


def _moves(source):
    """Whether a source is a molecule or map with time steps, and no map made from atoms."""
    if _is_volume(source):
        made = source.SMProxy
        while made.GetNumberOfProducers():
            made = made.GetProducerProxy(0)
        return not _has_atoms(servermanager._getPyProxy(made)) and len(track_views.times_of(source)) > 1
    return _has_atoms(source) and source.PointData["Element"] is not None and len(track_views.times_of(source)) > 1


@messages.reports_faults("The proposed threshold")
def use_proposed_threshold(number):
    """The button beside Minimum Persistence of the proxy with that global id: the threshold that its last
    result proposes, of both sides the lower one that separates anything. The loops change immediately."""
    loops = servermanager._getPyProxy(servermanager.ActiveConnection.Session.GetRemoteObject(number))
    proposed = loops.FieldData["ProposedThreshold"]
    if proposed is None:
        messages.show_error("There is no threshold to propose before the first result: press Apply first.")
        return
    lines = servermanager.Fetch(simple.OutputPort(loops, 0), 0, 0)
    told = lines.GetFieldData().GetArray("ProposedThreshold")
    sides = [side for side, other in ((0, "Outside"), (1, "Inside")) if loops.Side != other]
    rows = [told.GetTuple(side) for side in sides]
    gaps = [threshold for threshold, width in rows if width > 0.0]
    loops.PersistenceUnit = "Angstrom"
    loops.MinimumPersistence = min(gaps or [threshold for threshold, _ in rows])
    loops.UpdatePipeline()
    simple.RenderAllViews()


@messages.reports_faults("The inverted contrast")
def use_inverted_contrast(number):
    """The button beside Inside Is Higher of the Map Surface with that global id, whose last result suspects an
    inverted contrast: the surface of the dark density."""
    surface = servermanager._getPyProxy(servermanager.ActiveConnection.Session.GetRemoteObject(number))
    surface.InsideIsHigher = 0
    surface.UpdatePipeline()
    simple.RenderAllViews()


@messages.reports_faults("Compare")
def compare():
    """The entry Compare of the menu, for the selected source."""
    source = simple.GetActiveSource()
    if source is None:
        messages.show_note("Compare: select a source that the active 3D view shows; it moves to a second view.")
        return
    comparisons.compare(source)


def level_values(number):
    """Called by the panel with the global id of a filter with a level: levels.describe() as JSON, "" if it has nothing."""
    try:
        surface = servermanager._getPyProxy(servermanager.ActiveConnection.Session.GetRemoteObject(number))
        found = levels.describe(surface, surface.Scalars[1] or _point_array(surface.Input))
    except Exception:
        messages.fault("The histogram of the level")
        return ""
    return json.dumps(found) if found else ""


def selection_changed(number):
    """Called by the window with the global id of the source whose selection has changed; 0: nothing is selected. What to
    show is derived from the pipeline, so that it also works after a state was loaded and for results of scripts."""
    diagram_views.selection_changed(number)
    proxy = servermanager.ActiveConnection.Session.GetRemoteObject(number) if number else None
    if proxy is not None:
        source = servermanager._getPyProxy(proxy)
        pockets_and_pores.selection_changed(source)
        molecules.selection_changed(source)


@messages.reports_faults("Closing what belongs to a deleted source")
def forget():
    """Called by the window when sources were deleted: deletes their texts, tables and charts."""
    loop_views.forget()
    diagram_views.forget()
    entries.forget()
    pockets_and_pores.close_empty_views()


def _surface_on_screen(source):
    """The Map Surface of a map that the active view shows at a given level, as it is or coloured by its curvature, which
    buttons keep; None if there is none."""
    view = simple.GetActiveView()
    for display in view.Representations if view is not None else ():
        port = getattr(display, "Input", None)
        if port is None or not display.Visibility:
            continue
        surface = servermanager._getPyProxy(port.SMProxy)
        if surface.SMProxy.GetXMLName() == "CurvatureOnSurface":
            surface = servermanager._getPyProxy(surface.Input.SMProxy)
        if surface.SMProxy.GetXMLName() != "MapSurface":
            continue
        if surface.Input.SMProxy == source.SMProxy and surface.InsideIsHigher and not surface.AutomaticLevel:
            return surface
    return None


@messages.reports_faults("The button")
def run(function):
    """A button of the toolbar: the pipeline on the active source, or on the source from which it was made; shown
    in the active view, with everything else hidden; but the surface of a molecule does not hide its pockets and pores."""
    selected = simple.GetActiveSource()
    if selected is None or not loop_views.registered_name(selected):  # after Reset Session, it is still that of before
        messages.show_error("Select a source in the pipeline browser first: open a map, a molecule or a surface.")
        return
    source = _upstream(selected, _fits(function))
    before = set(simple.GetSources().values())
    shown = _surface_on_screen(source) if function.startswith("map_") else None
    given = {**BY_BUTTON.get(function, {}), **({"level": shown.Level} if shown is not None else {})}
    try:
        is_whole = shown is not None and not shown.LargestComponents
        if function == "map_to_surface" and is_whole:
            proxies = (shown,)
        elif function == "map_to_curvature" and is_whole:
            proxies = _with_curvature(shown, source)
        else:
            proxies = globals()[function](source, **given)
        if function == "persistence_diagram":
            return
        messages.step()
    except Exception as error:
        for proxy in set(simple.GetSources().values()) - before:
            simple.Delete(proxy)
        simple.SetActiveSource(selected)  # it may have been deleted itself
        if messages.is_cancelled():  # in a filter, whose empty result is then not an error
            messages.show_note("Cancelled: the objects that the button had created were removed.")
            return
        if not isinstance(error, ValueError):
            raise
        messages.show_error(str(error))
        return
    messages.begin_showing()
    view = simple.GetActiveViewOrCreate("RenderView")
    if function == "protein_to_surface" and pockets_and_pores.are_shown(source, view):
        camera = cameras.position_of(view)
        display = show(*proxies, view=view)
        display.Opacity, display.Pickable = 0.3, 0
        cameras.set_position(view, camera)
    else:
        bars = figures.visible_bars(view)
        simple.HideAll(view)
        for bar in bars:
            bar.Visibility = 1
        simple.HideUnusedScalarBars(view)
        show(*proxies, view=view, tables=True)
    figures.first_sight(view)
    figures.refresh(view)
    simple.SetActiveSource(proxies[-1])
    view.SMProxy.StillRender()


# ---------------------------------------------------------------------------- without ParaView

def _needs_paraview(name):
    def refuse(*_, **__):
        raise ImportError(f"isthmus.pipelines.{name}() makes sources of ParaView, which this Python does not have. "
                          "Without it, use functions of data such as isthmus.map_to_loops().")
    refuse.__name__, refuse.__doc__ = name, globals()[name].__doc__
    return refuse


if simple is None:
    for _name, _value in list(globals().items()):
        if _name[0] != "_" and callable(_value) and getattr(_value, "__module__", None) in (
                __name__, look.__name__, figures.__name__, molecules.__name__):
            globals()[_name] = _needs_paraview(_name)
