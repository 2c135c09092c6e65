"""Whole pipelines with good defaults, and the first look at what Isthmus' filters make.

    from isthmus import pipelines                 # or: import isthmus_pipelines, with the plugin loaded
    surface, loops = pipelines.map_to_loops(OpenDataFile("emd_5043.map"))
    pipelines.show(surface, loops)

Each of the six functions takes a source and returns a tuple of the last proxies, the main one last;
all are ordinary filters, to be changed as one likes. They use proxies only, so that the data stays
on the server, wherever that is. What can't be done is told in one sentence, as ValueError.

The buttons of the toolbar are run(); first_look() is what the window calls for each result.
"""

import os
import shutil
import subprocess

from paraview import print_error, print_warning, servermanager, simple

DUST = 0.01  # components below that share of the largest one's area are hidden
DECAY = 1.2  # of the Gaussians of a molecular surface: BindingSites.md tells what it was tuned on
SPACING = 0.6  # angstrom, of a molecular surface's grid

# Colours. A signed quantity spans a range symmetric about 0, so that what is neutral is flat.
DIVERGING = "Cool to Warm"
SEQUENTIAL = "Viridis (matplotlib)"
CURVATURES = ("MeanCurvature", "GaussianCurvature", "MaximumCurvature", "MinimumCurvature")
SIGNED = CURVATURES + (
    "Potential", "PolarizedCurvature", "PositivePotentialKappa1", "PositivePotentialKappa2",
    "NegativePotentialKappa1", "NegativePotentialKappa2", "SignedDistance")
UNSIGNED = ("Curvedness",)
FIXED = {"ShapeIndex": (-1.0, 1.0), "Potential": (-5.0, 5.0)}  # as all programs draw potentials
TITLES = {
    "MeanCurvature": "Mean curvature (1/Å)", "GaussianCurvature": "Gaussian curvature (1/Å²)",
    "MaximumCurvature": "Maximum curvature (1/Å)", "MinimumCurvature": "Minimum curvature (1/Å)",
    "Curvedness": "Curvedness (1/Å)", "ShapeIndex": "Shape index", "Potential": "Potential (kT/e)",
    "PolarizedCurvature": "Polarized curvature (kT/(e Å))", "Kind": "Choking loops",
    "BindingSite": "Binding sites", "SiteClass": "Kind of site"}
# Okabe and Ito's colours, which all eyes tell apart.
VERMILION, ORANGE, SKY, GREEN, YELLOW, BLUE, PURPLE, GREY = (
    (0.835, 0.369, 0.0), (0.902, 0.624, 0.0), (0.337, 0.706, 0.914), (0.0, 0.620, 0.451),
    (0.941, 0.894, 0.259), (0.0, 0.447, 0.698), (0.800, 0.475, 0.655), (0.80, 0.80, 0.80))
FURTHER = (0.70, 0.64, 0.74)
CATEGORIES = {
    "Kind": (("0", "handle", VERMILION), ("1", "tunnel", BLUE), ("2", "bottleneck", ORANGE)),
    "SiteClass": (
        ("0", "none", GREY), ("1", "for - proteins", SKY), ("2", "for - ligands", BLUE),
        ("3", "for + proteins", ORANGE), ("4", "for + ligands", VERMILION)),
    "BindingSite": (
        ("0", "no site", GREY), ("1", "best site", VERMILION), ("2", "second", BLUE),
        ("3", "third", GREEN), ("4", "fourth", ORANGE), ("5", "fifth", PURPLE)),
}


# ---------------------------------------------------------------------------- what a source is

def _data_of(source):
    source.UpdatePipeline()
    return source.GetDataInformation().DataInformation


def _is_volume(source):
    return _data_of(source).GetDataSetType() in (6, 10) or (
        _data_of(source).GetDataSetTypeAsString() == "vtkImageData")


def _require_volume(source):
    if not _is_volume(source):
        raise ValueError("This needs a density map (a volume): select one in the pipeline browser, "
                         "or open one by File > Open.")
    if not _point_array(source):
        raise ValueError("The volume has no point array with one number at each node.")


def _require_surface(source):
    if _data_of(source).GetDataSetTypeAsString() != "vtkPolyData" or (
            not _data_of(source).GetNumberOfCells()):
        raise ValueError("This needs a closed surface of triangles: select one in the pipeline "
                         "browser; Map to surface makes one of a density map.")


def _require_atoms(source):
    _data_of(source)
    if source.PointData["Radius"] is None:
        raise ValueError("This needs a molecule with radii: open a PDB, mmCIF or PQR file and select "
                         "it in the pipeline browser.")


def _point_array(source):
    """Name of the scalars of a volume: the active ones, else the first of one component."""
    data = source.PointData
    active = _data_of(source).GetPointDataInformation().GetAttributeInformation(0)
    if active and active.GetNumberOfComponents() == 1:
        return active.GetName()
    names = [data.GetArray(i).Name for i in range(data.GetNumberOfArrays())
             if data.GetArray(i).GetNumberOfComponents() == 1]
    return names[0] if names else None


def _field_number(source, name):
    """A number of the field data, without fetching the data; None where there is none."""
    field = source.FieldData[name]
    return field.GetRange(0)[0] if field else None


def _spacing(volume):
    bounds = _data_of(volume).GetBounds()
    extent = _data_of(volume).GetExtent()
    steps = [(bounds[2 * a + 1] - bounds[2 * a]) / (extent[2 * a + 1] - extent[2 * a])
             for a in range(3) if extent[2 * a + 1] > extent[2 * a]]
    return min((step for step in steps if step > 0.0), default=1.0)


def _require_triangles(surface):
    if not _data_of(surface).GetNumberOfCells():
        raise ValueError("No surface came out: all values of the map are alike, or all components "
                         "were hidden as dust. Look at its values in the Information panel.")


# ---------------------------------------------------------------------------- the six pipelines

def map_to_surface(source, level=None):
    """(surface,): the map's closed surface; at the recommended or a sensible level where none is
    given, which then stands in the panel, ready to be moved."""
    _require_volume(source)
    surface = simple.MapSurface(
        registrationName="Surface", Input=source,
        Scalars=["POINTS", _point_array(source)], MinimumComponentShare=DUST)
    if level is not None:
        surface.AutomaticLevel, surface.Level = 0, level
    surface.UpdatePipeline()
    _require_triangles(surface)
    surface.Level = _field_number(surface, "Level")
    surface.AutomaticLevel = 0
    surface.UpdatePipeline()
    return (surface,)


def map_to_curvature(source, level=None):
    """(surface, curvature): the map's surface coloured by the curvature of the map there, smoothed
    over one and a half nodes."""
    (surface,) = map_to_surface(source, level)
    curvature = simple.CurvatureOnSurface(
        registrationName="Curvature", Input=surface, Volume=source,
        Scalars=["POINTS", _point_array(source)], Scale=1.5 * _spacing(source))
    curvature.UpdatePipeline()
    if _range_by_area(curvature, "POINTS", "MeanCurvature") is None:
        raise ValueError("The map is too small, or its surface too near its border: curvature needs "
                         "three nodes inside of the map on every side. Pad the map, or raise the level.")
    return surface, curvature


def map_to_loops(source, level=None):
    """(surface, loops): the map's surface, of no more than its ten largest components, and its
    choking loops."""
    (surface,) = map_to_surface(source, level)
    surface.LargestComponents = 10
    return surface, surface_to_loops(surface)[-1]


def surface_to_loops(source):
    """(loops,): the choking loops of a closed surface."""
    _require_surface(source)
    loops = simple.ChokingLoops(registrationName="Choking loops", Input=source)
    loops.UpdatePipeline()
    if loops.FieldData["NumberOfSamples"] is None:
        raise ValueError("The surface has no choking loops that could be found: the messages say why. "
                         "Map Surface makes surfaces that are closed.")
    return (loops,)


def protein_to_surface(source):
    """(surface,): the smooth molecular surface of the atoms, without cavities smaller than a
    twentieth of it."""
    return (_molecule(source)[1],)


def protein_to_sites(source, potential=None):
    """(potential, sites): the surface with potential, polarized curvature and likely binding sites.

    potential: a source of it (kT/e) on a grid. Without one it is computed from the charges of the
    atoms. A PQR file has them; of a PDB file pdb2pqr, where it is installed, makes one, which stays
    beside it or, where that folder can't be written, in the current one.
    """
    _require_atoms(source)
    if potential is None:
        source = _charged(source)
        potential = _potential(source)
    density, surface = _molecule(source)
    curvature = simple.CurvatureOnSurface(
        registrationName="Curvature", Input=surface, Volume=density,
        Scalars=["POINTS", "Density"])
    polarized = simple.PolarizedCurvature(
        registrationName="Polarized curvature", Input=curvature, PotentialImage=potential)
    sites = simple.BindingSites(
        registrationName="Binding sites", Input=polarized,
        RankedArray=["POINTS", "PolarizedCurvature"])
    sites.UpdatePipeline()
    return potential, sites


def _molecule(source):
    """Density and surface of the atoms."""
    _require_atoms(source)
    # Named, since its default is the array that other filters made the active one.
    radii = {"Radii": ["POINTS", "Radius"]} if source.PointData["Radius"] else {}
    density = simple.MolecularDensity(
        registrationName="Molecular density", Input=source, Decay=DECAY, Spacing=SPACING, **radii)
    surface = simple.MapSurface(
        registrationName="Molecular surface", Input=density,
        Scalars=["POINTS", "Density"], AutomaticLevel=0, Level=1.0,
        MinimumComponentShare=0.05)
    surface.UpdatePipeline()
    _require_triangles(surface)
    return density, surface


# ---------------------------------------------------------------------------- the potential

def _charged(source):
    """The molecule with charges: itself, or what pdb2pqr makes of its file."""
    charges = source.PointData["Charge"]
    low, high = charges.GetRange(0) if charges else (0.0, 0.0)
    if low < 0.0 < high:
        return source
    program = shutil.which("pdb2pqr") or shutil.which("pdb2pqr30")
    file = _file_of(source)
    way_out = "or open a PQR file, or a potential's .dx file for Polarized Curvature."
    if not file or not file.lower().endswith((".pdb", ".ent", ".cif")):
        raise ValueError("The molecule has no charges, from which the potential comes: open its PDB file as "
                         "it is, not compressed, " + way_out)
    if servermanager.ActiveConnection.IsRemote():
        raise ValueError("The molecule has no charges; on a remote server run pdb2pqr there, " + way_out)
    if not program:
        raise ValueError("The molecule has no charges. They come from a force field by pdb2pqr, which is "
                         "not installed: install it (Debian: apt install pdb2pqr), " + way_out)
    target = _place_for(file, ".pqr")
    done = subprocess.run(
        [program, "--ff=AMBER", "--keep-chain", "--drop-water", "--nodebump", "--noopt", file, target],
        capture_output=True, text=True)
    if done.returncode != 0 or not os.path.exists(target):
        last = (done.stderr or done.stdout).strip().splitlines()[-1:]
        raise ValueError("pdb2pqr could not give the atoms charges: " + " ".join(last) + " Complete the "
                         "protein, " + way_out)
    left_out = _left_out(target)
    if left_out:
        print_warning("pdb2pqr knows no charges of " + ", ".join(left_out) + ": they were left out.")
    return simple.OpenDataFile(target, registrationName=os.path.basename(target))


def _left_out(pqr):
    """The residues that pdb2pqr's remarks say it left out, by name and number."""
    names = []
    with open(pqr, encoding="ascii", errors="replace") as lines:
        for line in lines:
            words = line.split()
            # REMARK   5    1234 CA in CA 201
            if line.startswith("REMARK") and len(words) == 7 and words[4] == "in":
                names.append(" ".join(words[5:]))
    return sorted(set(names))


def _potential(source):
    bounds = source.GetDataInformation().GetBounds()
    largest = max(bounds[2 * a + 1] - bounds[2 * a] for a in range(3)) + 30.0
    solver = simple.PoissonBoltzmann(
        registrationName="Poisson Boltzmann", Input=source, IonicStrength=0.15, SolventDielectric=78.54,
        Spacing=max(0.5, largest / 256.0))
    if _data_of(solver).GetNumberOfPoints() == 0:
        raise ValueError("The potential could not be computed: the messages say why. A potential's .dx "
                         "file can be given to Polarized Curvature instead.")
    return solver


def _file_of(source):
    name = source.GetProperty("FileName")
    name = name.GetData() if name else None
    return name if name is None or isinstance(name, str) else name[0]


def _place_for(file, ending):
    """Beside the molecule's file, else in the current folder."""
    folder, base = os.path.split(os.path.abspath(file))
    # Root may write everywhere, which is no reason to.
    if not os.access(folder, os.W_OK) or not os.stat(folder).st_mode & 0o222:
        folder = os.getcwd()
    return os.path.join(folder, base.split(".")[0] + ending)


# ---------------------------------------------------------------------------- first look

def _range_by_area(port, association, array):
    """The 2 and 98 % quantiles by area of an array, computed where the data is; None without any."""
    proxy = servermanager.ProxyManager().NewProxy("internal_filters", "AreaQuantiles")
    servermanager.vtkSMPropertyHelper(proxy, "Input").Set(port.SMProxy, getattr(port, "Port", 0))
    fields = {"POINTS": 0, "CELLS": 1}
    servermanager.vtkSMPropertyHelper(proxy, "SelectInputScalars").SetInputArrayToProcess(
        fields[association], array)
    proxy.UpdateVTKObjects()
    proxy.UpdatePipeline()
    rows = proxy.GetDataInformation(0).GetAttributeInformation(6)  # vtkDataObject.ROW
    column = rows.GetArrayInformation("Range") if rows else None
    return tuple(column.GetComponentRange(0)) if column else None


def colour_range(port, association, array):
    """Range for a colour bar; None where the array has none of its own."""
    if array in FIXED:
        return FIXED[array]
    if array not in SIGNED and array not in UNSIGNED:
        return None
    found = _range_by_area(port, association, array)
    if not found:
        return None
    top = max(abs(found[0]), abs(found[1]))
    if not top > 0.0:
        return None
    return (-top if array in SIGNED else 0.0), top


def _set_categories(table, array):
    rows = CATEGORIES[array]
    table.InterpretValuesAsCategories = 1
    table.Annotations = [word for value, name, _ in rows for word in (value, name)]
    table.IndexedColors = [part for _, _, colour in rows for part in colour]
    table.NanColor = FURTHER  # values without a name of their own


def _bar(table, view, array):
    bar = simple.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = TITLES.get(array, array), ""


# Colour maps that first_look() has set, by global id: the range it gave them. A map whose range is
# another now was changed by the user.
_ranges = {}


def _colour(display, view):
    association, array = display.ColorArrayName[0], display.ColorArrayName[1]
    if not array or (array not in CATEGORIES and array not in SIGNED and
                     array not in UNSIGNED and array not in FIXED):
        return
    table = display.LookupTable
    key = table.GetGlobalID()
    if array in CATEGORIES:
        if key not in _ranges:
            _ranges[key] = None
            _set_categories(table, array)
            _bar(table, view, array)
        return
    now = (table.RGBPoints[0], table.RGBPoints[-4])
    if key in _ranges and _ranges[key] != now:
        return
    limits = colour_range(display.Input, association, array)
    if not limits:
        return
    if key not in _ranges:
        table.ApplyPreset(SEQUENTIAL if array in UNSIGNED else DIVERGING, True)
        if array == "Potential":
            table.InvertTransferFunction()  # red is negative, as everywhere in structural biology
        table.AutomaticRescaleRangeMode = "Never"
        table.NanColor = GREY
        _bar(table, view, array)
    table.RescaleTransferFunction(*limits)
    opacity = display.OpacityTransferFunction
    if opacity:
        opacity.RescaleTransferFunction(*limits)
    _ranges[key] = (table.RGBPoints[0], table.RGBPoints[-4])


def _look_at_loops(display, view, port):
    """Loops as tubes coloured by kind, on a translucent surface; nothing else."""
    if port == 0:
        display.RenderLinesAsTubes, display.LineWidth = 1, 5.0
        simple.ColorBy(display, ("CELLS", "Kind"))
        display.SetScalarBarVisibility(view, True)
        surface = display.Input.Input
        simple.Show(surface, view).Opacity = 0.35
    else:
        display.Visibility = 0


_seen = set()


def _look(display):
    source = getattr(display, "Input", None)
    view = simple.GetActiveView()
    if source is None or not hasattr(display, "ColorArrayName"):
        return
    name = source.SMProxy.GetXMLName()
    key = display.GetGlobalID()
    if key not in _seen:
        _seen.add(key)
        if name == "ChokingLoops":
            _look_at_loops(display, view, source.Port if hasattr(source, "Port") else 0)
        elif name == "BindingSites" and getattr(source, "Port", 0) == 0:
            simple.ColorBy(display, ("POINTS", "BindingSite"))
            display.SetScalarBarVisibility(view, True)
    _colour(display, view)


def first_look(*ids):
    """Called by the window with the global ids of representations that are new or changed."""
    session = servermanager.ActiveConnection.Session
    for number in ids:
        proxy = session.GetRemoteObject(number)
        if proxy is None:
            continue
        try:
            _look(servermanager._getPyProxy(proxy))
        except Exception as error:  # a look is never worth a failure
            print_error(f"The first look at a result failed: {error}")


def show(*proxies, view=None):
    """Shows the last proxies of a pipeline as the window would, and returns the last display."""
    view = view or simple.GetActiveViewOrCreate("RenderView")
    display = None
    for proxy in proxies:
        if _data_of(proxy).GetDataSetTypeAsString() != "vtkPolyData":
            continue
        display = simple.Show(proxy, view)
        _look(display)
    for proxy in proxies[:-1]:
        if _replaced(proxy, proxies[-1]):
            simple.Hide(proxy, view)
    if display is not None and display.LookupTable is not None and display.ColorArrayName[1]:
        display.SetScalarBarVisibility(view, True)
    simple.ResetCamera(view)
    return display


def _replaced(proxy, last):
    """Whether `last` shows what `proxy` does, with more to it."""
    return last.SMProxy.GetXMLName() in ("CurvatureOnSurface", "BindingSites")


def run(function):
    """A button of the toolbar: the pipeline on the active source, shown in the active view."""
    source = simple.GetActiveSource()
    if source is None:
        print_error("Select a source in the pipeline browser first: open a map, a molecule or a surface.")
        return
    before = set(simple.GetSources().values())
    try:
        proxies = globals()[function](source)
    except ValueError as error:
        for proxy in set(simple.GetSources().values()) - before:
            simple.Delete(proxy)
        print_error(str(error))
        return
    view = simple.GetActiveViewOrCreate("RenderView")
    simple.Hide(source, view)
    show(*proxies, view=view)
    simple.SetActiveSource(proxies[-1])
    simple.Render(view)
