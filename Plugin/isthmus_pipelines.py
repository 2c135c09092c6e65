"""Whole pipelines with good defaults, and the first look at what Isthmus' filters make.

    from isthmus import pipelines                 # or: import isthmus_pipelines, with the plugin loaded
    surface, loops = pipelines.map_to_loops(OpenDataFile("emd_5043.map"))
    pipelines.show(surface, loops)

Each of the eight functions takes a source and returns a tuple of the last proxies, the main one last;
all are ordinary filters, to be changed as one likes. They use proxies only, so that the data stays
on the server, wherever that is. What can't be done is told in one sentence, as ValueError.

The buttons of the toolbar are run(); first_look() is what the window calls for each result.
"""

import os
import shutil
import subprocess
import tempfile

from paraview import print_error, servermanager, simple

try:
    import isthmus_pockets as pockets_and_pores  # with the plugin loaded
except ImportError:
    from isthmus import pockets as pockets_and_pores

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
SITES = ("BindingSites", "BindingSitesInPockets")
UNSIGNED = ("Curvedness",)
FIXED = {"ShapeIndex": (-1.0, 1.0)}
TITLES = {
    "MeanCurvature": "Mean curvature (1/Å)", "GaussianCurvature": "Gaussian curvature (1/Å²)",
    "MaximumCurvature": "Maximum curvature (1/Å)", "MinimumCurvature": "Minimum curvature (1/Å)",
    "Curvedness": "Curvedness (1/Å)", "ShapeIndex": "Shape index", "Potential": "Potential (kT/e)",
    "PolarizedCurvature": "Polarized curvature (kT/(e Å))", "Kind": "Choking loops",
    "BindingSite": "Binding sites", "SiteClass": "Kind of site",
    "WidthClass": "Room in the pore"}
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
    "WidthClass": (
        ("0", "too narrow for water", VERMILION), ("1", "one water", GREEN), ("2", "wider", BLUE)),
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


# ---------------------------------------------------------------------------- the pipelines

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
    """(potential, sites): the surface with potential, polarized curvature and likely binding sites: pockets,
    ranked with it.

    potential: a source of it (kT/e) on a grid. Without one it is computed from the charges of the
    atoms (a PQR file has them) by APBS, into a .dx file that stays beside the molecule's or, where
    that folder can't be written, in the current one.
    """
    _require_atoms(source)
    if potential is None:
        potential = _potential(source)
    density, surface = _molecule(source)
    curvature = simple.CurvatureOnSurface(
        registrationName="Curvature", Input=surface, Volume=density,
        Scalars=["POINTS", "Density"])
    polarized = simple.PolarizedCurvature(
        registrationName="Polarized curvature", Input=curvature, PotentialImage=potential)
    sites = simple.BindingSitesInPockets(
        registrationName="Binding sites", Input=polarized, Atoms=source,
        RankedArray=["POINTS", "PolarizedCurvature"])
    sites.UpdatePipeline()
    return potential, sites


def protein_to_pockets(source):
    """(residues, pockets): the pockets of a molecule, ranked, and the residues of the best one."""
    _require_atoms(source)
    return pockets_and_pores.protein_to_pockets(source)


def protein_to_pores(source):
    """(chart, residues, pores): the channels that run through a molecule, the radius along the longest
    one, and the residues that line it."""
    _require_atoms(source)
    return pockets_and_pores.protein_to_pores(source)


def _molecule(source):
    """Density and surface of the atoms."""
    _require_atoms(source)
    density = simple.MolecularDensity(
        registrationName="Molecular density", Input=source, Decay=DECAY, Spacing=SPACING)
    surface = simple.MapSurface(
        registrationName="Molecular surface", Input=density,
        Scalars=["POINTS", "Density"], AutomaticLevel=0, Level=1.0,
        MinimumComponentShare=0.05)
    surface.UpdatePipeline()
    _require_triangles(surface)
    return density, surface


# ---------------------------------------------------------------------------- the potential

APBS_INPUT = """read
  mol pqr molecule.pqr
end
elec
  mg-manual
  dime {n[0]} {n[1]} {n[2]}
  grid {h} {h} {h}
  gcent {c[0]} {c[1]} {c[2]}
  mol 1
  lpbe
  bcfl sdh
  pdie 2.0
  sdie 78.54
  ion charge 1 conc 0.150 radius 2.0
  ion charge -1 conc 0.150 radius 2.0
  srfm smol
  chgm spl2
  sdens 10.0
  srad 1.4
  swin 0.3
  temp 298.15
  calcenergy no
  calcforce no
  write pot dx potential
end
quit
"""


def _potential(source):
    low, high = source.PointData["Charge"].GetRange(0) if source.PointData["Charge"] else (0.0, 0.0)
    if not low < 0.0 < high:
        raise ValueError("The molecule has no charges, from which the potential comes: open a PQR file "
                         "(pdb2pqr makes one of a PDB file), or give a potential: open its .dx file, and "
                         "use Polarized Curvature.")
    if not shutil.which("apbs"):
        raise ValueError("The potential is computed by APBS, which is not installed (Debian: apt install "
                         "apbs); or open a .dx file of it, and use Polarized Curvature.")
    if servermanager.ActiveConnection.IsRemote():
        raise ValueError("On a remote server, compute the potential there, open its .dx file, and use "
                         "Polarized Curvature.")
    path = _run_apbs(servermanager.Fetch(source), _place_for(source))
    return simple.OpenDXGridReader(registrationName=os.path.basename(path), FileName=path)


def _place_for(source):
    """File of the potential: beside the molecule's, else in the current folder."""
    name = source.GetProperty("FileName")
    name = name.GetData() if name else "molecule"
    name = name if isinstance(name, str) else name[0]
    folder, base = os.path.split(os.path.abspath(name))
    # Root may write everywhere, which is no reason to.
    if not os.access(folder, os.W_OK) or not os.stat(folder).st_mode & 0o222:
        folder = os.getcwd()
    return os.path.join(folder, base.split(".")[0] + "_potential.dx")


def _run_apbs(molecule, target):
    points = [molecule.GetPoint(i) for i in range(molecule.GetNumberOfPoints())]
    radius = molecule.GetPointData().GetArray("Radius")
    charge = molecule.GetPointData().GetArray("Charge")
    centre, sides = [], []
    for axis in range(3):
        values = [point[axis] for point in points]
        centre.append((min(values) + max(values)) / 2.0)
        sides.append(max(values) - min(values) + 30.0)
    h = max(0.6, max(sides) / 256.0)
    counts = [32 * max(1, -int(-side / h // 32)) + 1 for side in sides]
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "molecule.pqr"), "w") as file:
            for i, point in enumerate(points):
                if radius.GetValue(i) == radius.GetValue(i):  # not NaN
                    file.write("ATOM %d X MOL 1 %.4f %.4f %.4f %.4f %.4f\n" % (
                        i + 1, *point, charge.GetValue(i), radius.GetValue(i)))
        with open(os.path.join(folder, "apbs.in"), "w") as file:
            file.write(APBS_INPUT.format(n=counts, h=h, c=centre))
        done = subprocess.run(["apbs", "apbs.in"], cwd=folder, capture_output=True, text=True)
        found = [name for name in os.listdir(folder) if name.endswith(".dx")]
        if done.returncode != 0 or not found:
            last = (done.stderr or done.stdout).strip().splitlines()[-1:]
            raise ValueError("APBS could not compute the potential: " + " ".join(last))
        shutil.move(os.path.join(folder, found[0]), target)
    return target


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
        elif name in SITES and getattr(source, "Port", 0) == 0:
            simple.ColorBy(display, ("POINTS", "BindingSite"))
            display.SetScalarBarVisibility(view, True)
        elif name in pockets_and_pores.FEATURES:
            pockets_and_pores.look(display, view, getattr(source, "Port", 0))
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


def show(*proxies, view=None, tables=False):
    """Shows the last proxies of a pipeline as the window would, and returns the last display. tables: open
    the tables and charts of pockets and pores beside the view, too."""
    view = view or simple.GetActiveViewOrCreate("RenderView")
    if proxies[-1].SMProxy.GetXMLName() in pockets_and_pores.FEATURES:
        display = pockets_and_pores.show(proxies[-1], view, tables)
        _look(display)
        return display
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
    return last.SMProxy.GetXMLName() in ("CurvatureOnSurface",) + SITES


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
    show(*proxies, view=view, tables=True)
    simple.SetActiveSource(proxies[-1])
    simple.Render(view)
