"""Pockets and pores in the window: the pipelines of the buttons, and the display of a selected pocket or pore.

    from isthmus import pocket_views              # or: from isthmus_plugin, with the plugin loaded
    residues, found = pocket_views.protein_to_pockets(OpenDataFile("1hew.pdb"))
    pocket_views.show(found)

The best pockets are shown as translucent surfaces. Selecting a pocket or pore in a table or in the view shows its
residues as sticks with their names, the surface of a pocket, and the chart of a pore. The buttons in
pipelines.py call this module.
"""

try:
    from paraview import servermanager, simple
except ImportError:
    servermanager = simple = None  # with pip's vtk alone, isthmus.pipelines can still be imported

from . import cameras, colours, entries, messages, selections, steps
from . import molecule_views as molecules

POINT, CELL, ROW = 0, 1, 6  # of vtkDataObject's attribute types
# The arrays that number the features, and the output ports of the parts shown.
FEATURES = {
    "MolecularPockets": {"id": "PocketId", "row": "Rank", "shapes": 3, "table": 1, "atoms": 5,
                         "residues": 4},
    "PoreProfile": {"id": "PoreId", "row": "PoreId", "shapes": 5, "table": 2, "atoms": 6, "chart": 1},
}
# The colours of Okabe and Ito for the best pockets, then three more. All further pockets have the colour FURTHER.
COLOURS = ((0.835, 0.369, 0.0), (0.0, 0.447, 0.698), (0.0, 0.620, 0.451), (0.902, 0.624, 0.0),
           (0.800, 0.475, 0.655), (0.337, 0.706, 0.914), (0.941, 0.894, 0.259), (0.45, 0.30, 0.15),
           (0.40, 0.80, 0.75), (0.95, 0.70, 0.75))
FURTHER = (0.70, 0.64, 0.74)
BEST = 3  # number of pockets whose surfaces are shown at first
FAINT, STRONG = 0.3, 0.7  # opacities of the best pockets' surfaces, and of the chosen one's
BEST_SURFACES, CHOSEN_SURFACE = "best pockets", "chosen pocket"
HIDDEN_COLUMNS = {
    "MolecularPockets": [
        "ApolarShare", "CenterX", "CenterY", "CenterZ", "Cells", "CopyOf", "LiningAtoms", "MeanPolarized",
        "MeanPotential", "MouthArea", "MouthRadius", "Parent", "PolarShare", "Radius", "Row ID"],
    "PoreProfile": ["BottleneckX", "BottleneckY", "BottleneckZ", "Row ID"]}
# Units of columns of tables, which their headers show.
UNITS = {"Area": "Å²", "MouthArea": "Å²", "Volume": "Å³", "Radius": "Å", "RadiusError": "Å", "MouthRadius": "Å", "Length": "Å",
         "Span": "Å",
         "CenterX": "Å", "CenterY": "Å", "CenterZ": "Å", "BottleneckX": "Å", "BottleneckY": "Å", "BottleneckZ": "Å",
         "MeanDepth": "Å", "MeanPotential": "kT/e", "MeanPolarized": "kT/(e Å)"}
FIRST_COLUMNS = {"Rank": "# Rank", "PoreId": "# Pore"}  # names that ParaView, which sorts columns by name, places first
RADII = {"Of the atoms": "radii of the atoms", "HOLE": "radii of HOLE"}
BOTTLENECKS = 3  # port of Pore Profile
BALL = (0.941, 0.894, 0.259)
WATERS = ("1.15", "2.30")  # smallest radii that let one and two water molecules pass (as in HOLE)
# Executed where the data is. The faces between two pockets belong to both, and each pocket has points of its own.
SURFACES = """# The outer faces of each pocket's tetrahedra, smoothed.
import numpy
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkWindowedSincPolyDataFilter

pockets = self.GetInputDataObject(0, 0)
if pockets.GetNumberOfCells():
    corners = vtk_to_numpy(pockets.GetCells().GetConnectivityArray()).reshape(-1, 4)
    number = vtk_to_numpy(pockets.GetCellData().GetArray("PocketId")).astype(numpy.int64)
    place = vtk_to_numpy(pockets.GetPoints().GetData()).astype(float)
    faces = numpy.concatenate([corners[:, others] for others in ((1, 2, 3), (0, 2, 3), (0, 1, 3), (0, 1, 2))])
    inner, pocket = numpy.concatenate(list(corners.T)), numpy.tile(number, 4)
    a, b, c, d = (place[ends] for ends in (*faces.T, inner))
    inward = numpy.einsum("ij,ij->i", numpy.cross(b - a, c - a), d - a) > 0.0
    faces[inward] = faces[inward][:, [0, 2, 1]]
    keys = numpy.column_stack([pocket, numpy.sort(faces, axis=1)])
    _, back, count = numpy.unique(keys, axis=0, return_inverse=True, return_counts=True)
    outer = count[back.ravel()] == 1
    faces, pocket = faces[outer], pocket[outer]
    owned, ends = numpy.unique(pocket[:, None] * len(place) + faces, return_inverse=True)
    place, ends = place[owned % len(place)], ends.reshape(-1, 3)
    for _ in range(2):  # each triangle becomes four
        edges = numpy.sort(ends[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        edges, middle = numpy.unique(edges, axis=0, return_inverse=True)
        middle = len(place) + middle.reshape(-1, 3)
        place = numpy.concatenate([place, place[edges].mean(axis=1)])
        (a, b, c), (ab, bc, ca) = ends.T, middle.T
        ends = numpy.concatenate([numpy.column_stack(three) for three in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))])
        pocket = numpy.tile(pocket, 4)
    surface, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(place, deep=True))
    cells.SetData(3, numpy_to_vtk(ends.astype(numpy.int64).ravel(), deep=True))
    surface.SetPoints(points)
    surface.SetPolys(cells)
    ids = numpy_to_vtk(pocket.astype(numpy.int32), deep=True)
    ids.SetName("PocketId")
    surface.GetCellData().AddArray(ids)
    smooth, normals = vtkWindowedSincPolyDataFilter(), vtkPolyDataNormals()
    smooth.SetInputData(surface)
    smooth.SetNumberOfIterations(60)
    smooth.SetPassBand(0.03)
    smooth.NonManifoldSmoothingOn()
    normals.SetInputConnection(smooth.GetOutputPort())
    normals.SplittingOff()
    normals.ConsistencyOff()
    normals.Update()
    self.GetOutputDataObject(0).ShallowCopy(normals.GetOutput())
""" + entries.TIDY
ELEMENTS = (("6", "C", (0.72, 0.72, 0.66)), ("7", "N", (0.0, 0.447, 0.698)),
            ("8", "O", (0.835, 0.2, 0.1)), ("16", "S", (0.902, 0.75, 0.1)),
            ("1", "H", (0.9, 0.9, 0.9)), ("15", "P", (0.902, 0.5, 0.0)))


def protein_to_pockets(source):
    """(residues, pockets): the pockets of a molecule, and the residues of the best one."""
    return _with_residues(_make("protein_to_pockets", "pockets", source), steps.NOTHING["pockets"])


def protein_to_pores(source):
    """(chart, residues, pores): the channels through a molecule, the profile of the longest one, and the residues
    that line it."""
    residues, pores = _with_residues(_make("protein_to_pores", "pores", source), steps.NOTHING["pores"])
    return chart_of(pores), residues, pores


def _make(pipeline, name, source):
    step = steps.PIPELINES[pipeline][name]
    label = name_of(source, step.label)
    messages.step(label)
    return getattr(simple, step.proxy)(source, registrationName=label, **step.properties)


def name_of(source, what):
    """A new name for a source made from `source`: "1hew pockets" if its data come from the file 1hew.pdb, then
    "1hew pockets 2", and so on."""
    name = f"{_root_of(source.SMProxy)} {what}".strip()
    known, number = {name for name, _ in simple.GetSources()}, 2
    while f"{name} {number}" in known:
        number += 1
    return f"{name} {number}" if name in known else name


def _root_of(proxy):
    """The name of the file from which the data come, or else of the first source upstream."""
    while proxy.GetNumberOfProducers():
        proxy = proxy.GetProducerProxy(0)
    for name in ("FileName", "FileNames"):
        if proxy.GetProperty(name) and servermanager.vtkSMPropertyHelper(proxy, name).GetNumberOfElements():
            return steps.stem_of(servermanager.vtkSMPropertyHelper(proxy, name).GetAsString(0))
    names = [name for (name, _), known in simple.GetSources().items() if known.SMProxy == proxy]
    return steps.stem_of(names[0]) if names else ""


def _with_residues(features, nothing):
    features.UpdatePipeline()
    kind = FEATURES[features.SMProxy.GetXMLName()]
    rows = features.SMProxy.GetDataInformation(kind["table"]).GetNumberOfRows()
    if rows < 1:
        raise ValueError(nothing)
    return residues_of(features), features


# ---------------------------------------------------------------------------- what follows a click

def _fed_by(features, port, name):
    """The filter of that name behind a port of `features`, if there is one."""
    for proxy in simple.GetSources().values():
        given = proxy.SMProxy.GetProperty("Input") if proxy.SMProxy.GetXMLName() == name else None
        if given is not None and given.GetNumberOfProxies() and given.GetProxy(0) == features.SMProxy and (
                given.GetOutputPortForConnection(0) == port):
            return proxy
    return None


def residues_of(features):
    """The filter that passes the residues of one pocket or pore."""
    kind = FEATURES[features.SMProxy.GetXMLName()]
    found = _fed_by(features, kind["atoms"], "Threshold")
    if found is None:
        found = entries.make(
            "Threshold", simple.OutputPort(features, kind["atoms"]), name_of(features, "residues"), hidden=False,
            Scalars=["POINTS", kind["id"]], ThresholdMethod="Between", LowerThreshold=1, UpperThreshold=1)
        found.UpdatePipeline()
    return found


def _rows_of_one(features, part, column, words):
    """The filter that passes those rows of a table that belong to one pocket or pore."""
    port = FEATURES[features.SMProxy.GetXMLName()][part]
    found = _fed_by(features, port, "ThresholdTable")
    if found is None:
        found = entries.make(
            "ThresholdTable", simple.OutputPort(features, port), name_of(features, words), hidden=False,
            Column=["ROWS", column], MinValue=1, MaxValue=1, Mode="Between")
        found.UpdatePipeline()
    return found


def chart_of(pores):
    """The filter that passes the profile of one pore."""
    return _rows_of_one(pores, "chart", "PoreId", "profile")


def lining_of(pockets):
    """The filter that passes the table of residues that line one pocket."""
    return _rows_of_one(pockets, "residues", "PocketId", "lining residues")


def names_of(residues, make=True):
    """The filter that extracts the atoms labelled with residue names, so that the names can be hidden; make=False:
    None if there is none yet."""
    found = _fed_by(residues, 0, "ExtractSelection")
    if found is None and make:
        found = entries.make("ExtractSelection", residues, name_of(residues, "residue names"),
                             Selection=selections.of_ids("POINT", [0]))
    return found


def surface_of(pockets, name, last):
    """The filter with this name that passes the surfaces of pockets (the smoothed outer faces of their tetrahedra),
    initially of the pockets 1 to `last`."""
    smooth = _fed_by(pockets, 0, "ProgrammableFilter") or entries.make(
        "ProgrammableFilter", pockets, name_of(pockets, "pocket surfaces"), OutputDataSetType="vtkPolyData", Script=SURFACES)
    for (known, _), proxy in simple.GetSources().items():
        given = getattr(proxy, "Input", None) if name in known else None
        if given is not None and given.SMProxy == smooth.SMProxy:
            return proxy
    return entries.make("Threshold", smooth, name_of(pockets, name), hidden=False, Scalars=["CELLS", "PocketId"],
                        ThresholdMethod="Between", LowerThreshold=1, UpperThreshold=last)


def choose(features, number):
    """Shows the residues of one pocket or pore, the surface of a pocket, and the chart of a pore."""
    kind = FEATURES[features.SMProxy.GetXMLName()]
    residues = residues_of(features)
    residues.LowerThreshold = residues.UpperThreshold = number
    residues.UpdatePipeline()
    changed = [residues]
    if _fed_by(features, 0, "ProgrammableFilter"):
        chosen = surface_of(features, CHOSEN_SURFACE, 1)
        chosen.LowerThreshold = chosen.UpperThreshold = number
        chosen.UpdatePipeline()
        changed.append(chosen)
        lining = lining_of(features)
        lining.MinValue = lining.MaxValue = number
        lining.UpdatePipeline()
    if "chart" in kind:
        chart = chart_of(features)
        chart.MinValue = chart.MaxValue = number
        chart.UpdatePipeline()
        changed.append(chart)
        _narrowest_of(features, number)
        for view in simple.GetViews():
            if _is_shown(chart, view):
                _title_chart(chart, view)
    for view in simple.GetViews():
        for display in view.Representations if "chart" not in kind else ():
            if getattr(display, "Input", None) in changed[1:]:
                _name_ranks(display.LookupTable, features, sorted({*range(1, 1 + BEST), number}))
        for proxy in changed:
            shown = simple.GetRepresentation(proxy, view) if _is_shown(proxy, view) else None
            if shown is None and view.SMProxy.GetXMLName() == "RenderView" and proxy is residues and (
                    _shows(features, view)):
                shown = _show_residues(residues, view)
            if shown is not None:
                if proxy is residues:
                    place_names(residues, view)
                view.SMProxy.StillRender()


def show_only(pockets, number):
    """Shows the surface and the residues of one pocket and hides the others; 0 shows the best pockets, with the
    residues of the first."""
    choose(pockets, number or 1)
    if not _fed_by(pockets, 0, "ProgrammableFilter"):
        return
    best = surface_of(pockets, BEST_SURFACES, BEST)
    for view in simple.GetViews():
        for display in view.Representations:
            if getattr(display, "Input", None) == best:
                display.Visibility = int(number == 0)


def _is_shown(proxy, view, kind=""):
    """Whether a view has a display of a source; kind: only displays of this kind."""
    return proxy is not None and any(
        getattr(display, "Input", None) == proxy and display.SMProxy.GetXMLName().startswith(kind)
        for display in view.Representations)


def _shows(features, view):
    return any(getattr(getattr(display, "Input", None), "SMProxy", None) == features.SMProxy and
               display.Visibility for display in view.Representations)


def are_shown(molecule, view):
    """Whether a view shows pockets or pores of a molecule."""
    for display in view.Representations:
        source = getattr(display, "Input", None)
        features = _features_of(source) if source is not None and display.Visibility else None
        if features is not None and features.Input.SMProxy == molecule.SMProxy:
            return True
    return False


def _selected(features, source):
    """The number of the feature that is selected in `source`, determined on the server; None if nothing is
    selected."""
    kind = FEATURES[features.SMProxy.GetXMLName()]
    for port in range(source.SMProxy.GetNumberOfOutputPorts()):
        if source.SMProxy.GetSelectionInput(port) is None:
            continue
        part = source.SMProxy.GetSelectionOutput(port)
        part.UpdatePipeline()
        data = part.GetDataInformation(0)
        for attribute, name in ((ROW, FIRST_COLUMNS[kind["row"]]), (ROW, kind["row"]), (ROW, kind["id"]), (CELL, kind["id"]),
                                (POINT, kind["id"])):
            arrays = data.GetAttributeInformation(attribute)
            array = arrays.GetArrayInformation(name) if arrays else None
            if array and array.GetNumberOfTuples() > 0:
                low, high = array.GetComponentRange(0)
                if low <= high:
                    return int(low)
    return None


def _features_of(source):
    """The source itself if it is pockets or pores, or those it was made from; None otherwise."""
    proxy = source.SMProxy
    while proxy.GetXMLName() not in FEATURES:
        if not proxy.GetNumberOfProducers():
            return None
        proxy = proxy.GetProducerProxy(0)
    return servermanager._getPyProxy(proxy)


@messages.reports_faults("Showing the residues of what was selected")
def selection_changed(source):
    """Shows the residues of the pocket or pore that was selected in a table or in a view."""
    features = _features_of(source)
    chosen = _selected(features, source) if features is not None else None
    if chosen is not None:
        choose(features, chosen)


# ---------------------------------------------------------------------------- what is shown

def look(display, view, port):
    """The display that an output gets when the window first shows it: only coloured shapes."""
    kind = FEATURES[display.Input.SMProxy.GetXMLName()]
    if port == kind["shapes"]:
        colour_shapes(display, view)
    elif port != 0 or "chart" in kind:
        display.Visibility = 0
    else:
        _colour_by_rank(display, "CELLS", view)


def colour_shapes(display, view):
    kind = FEATURES[display.Input.SMProxy.GetXMLName()]
    if "chart" in kind:
        if colours.colour_by(display, "POINTS", "WidthClass"):
            display.SetScalarBarVisibility(view, True)
    else:
        # Balls of their true size; ParaView multiplies the radius set here by the array.
        display.SetRepresentationType("Point Gaussian")
        display.ShaderPreset = "Sphere"
        display.GaussianRadius = 1.0
        display.ScaleByArray = 1
        display.SetScaleArray = ["POINTS", "Radius"]
        display.UseScaleFunction = 0
        _colour_by_rank(display, "POINTS", view)


def _colour_by_rank(display, association, view, pockets=None):
    """Gives each of the best pockets a colour, labelled by its rank. pockets: of which the display shows the best ones or the
    chosen one only."""
    if not colours.colour_by(display, association, "PocketId"):
        return
    names = _name_ranks(display.LookupTable, pockets or display.Input, range(1, 1 + (BEST if pockets else len(COLOURS))))
    colours.legend(display.LookupTable, view, "Sites by rank (probability)" if any(" " in name for name in names) else "Pockets by rank")
    display.SetScalarBarVisibility(view, True)


def _name_ranks(table, pockets, ranks):
    """Gives the colour map an entry for each of these ranks: the rank, with its probability if there are sites."""
    found = servermanager.Fetch(pockets, idx=FEATURES["MolecularPockets"]["table"])
    ranks = [rank for rank in ranks if rank <= found.GetNumberOfRows()]
    values = [found.GetValueByName(rank - 1, "Probability").ToDouble() for rank in ranks]
    names = [str(rank) if value != value else f"{rank} ({value:.2f})" for rank, value in zip(ranks, values)]
    colours.set_categories(table, [(str(rank), name, COLOURS[rank - 1] if rank <= len(COLOURS) else FURTHER)
                                   for rank, name in zip(ranks, names)])
    table.NanColor = FURTHER
    return names


def sticks(display, view):
    """Bonds as sticks, coloured by element."""
    display.SetRepresentationType("Surface")
    display.RenderLinesAsTubes, display.LineWidth = 1, 5.0
    if colours.colour_by(display, "POINTS", "Element"):
        colours.set_categories(display.LookupTable, ELEMENTS)
        display.SetScalarBarVisibility(view, False)


def _show_residues(residues, view):
    display = simple.Show(residues, view)
    sticks(display, view)
    display.Pickable = 0
    place_names(residues, view)
    show_labels(names_of(residues), view, "ResidueLabel")
    cameras.follow(view)
    return display


_named = {}  # atoms that have a residue's name, those of the largest area first: (name, point, number), by id of the residues


def place_names(residues, view):
    """Chooses the residue names that are shown: residues with the largest share of the pocket's surface come first,
    and names that would overlap in this view are left out."""
    data = servermanager.Fetch(residues)
    labels = data.GetPointData().GetAbstractArray("ResidueLabel") if data.GetNumberOfPoints() else None
    if labels is None:
        _named.pop(residues.SMProxy.GetGlobalID(), None)
        return
    areas = _areas_of(residues)
    named = [(labels.GetValue(i), data.GetPoint(i), i) for i in range(data.GetNumberOfPoints()) if labels.GetValue(i)]
    named.sort(key=lambda one: (-areas.get(one[0], 0.0), one[2]))
    _named[residues.SMProxy.GetGlobalID()] = named
    _choose_names(residues, view)
    names_of(residues).UpdatePipeline()


def _choose_names(residues, view):
    """Of the names that place_names() has found. The next rendering updates the pipeline."""
    named = _named.get(residues.SMProxy.GetGlobalID(), ())
    shown = without_overlap([(name, _on_screen(view, place), i) for name, place, i in named])
    if named:
        names_of(residues).Selection = selections.of_ids("POINT", shown)


def replace_names(residues, view):
    """Called for new data of a source that a view shows: places its residue names, if it has any there. Returns whether."""
    if not _is_shown(names_of(residues, False), view):
        return False
    place_names(residues, view)
    return True


def without_overlap(named, letter=8.5, height=17.0):
    """From items (name, (x, y) in pixels, number), the numbers of those whose names do not overlap a previous one.
    `letter` is the width of a letter."""
    boxes, fitting = [], []
    for name, (x, y), number in named:
        right, top = x + letter * len(name), y + height
        if all(right < left or x > end or top < low or y > high for left, low, end, high in boxes):
            boxes.append((x, y, right, top))
            fitting.append(number)
    return fitting


def _on_screen(view, place):
    width, height = view.ViewSize
    matrix = view.GetActiveCamera().GetCompositeProjectionTransformMatrix(width / max(1, height), -1.0, 1.0)
    x, y, _, w = matrix.MultiplyPoint((*place, 1.0))
    return (x / w + 1.0) / 2.0 * width, (y / w + 1.0) / 2.0 * height


def _areas_of(residues):
    """The area of the chosen pocket's surface that belongs to each residue, by the residue's name."""
    features = residues.Input
    if features.SMProxy.GetXMLName() != "MolecularPockets":
        return {}
    table = servermanager.Fetch(features, idx=FEATURES["MolecularPockets"]["residues"])
    areas = {}
    for row in range(table.GetNumberOfRows()):
        value = lambda name, row=row: table.GetValueByName(row, name)
        if value("PocketId").ToInt() == residues.LowerThreshold:
            name = (f'{value("ResidueName").ToString()} {value("ResidueId").ToInt()}'
                    f'{value("InsertionCode").ToString()} {value("Chain").ToString()}')
            areas[name.strip()] = value("Area").ToDouble()
    return areas


@cameras.when_moved
def _place_names_again(view, ended):
    """Chooses the names again whenever the mouse has rotated or zoomed the view."""
    shown = [display.Input for display in view.Representations if ended and getattr(display, "Input", None) is not None and
             display.Input.SMProxy.GetXMLName() == "Threshold" and _is_shown(names_of(display.Input, False), view)]
    for residues in shown:
        _choose_names(residues, view)
    return bool(shown)


def show_labels(source, view, array, digits=None):
    """Shows a point array of a source as labels beside the points; digits: decimals, for lengths in angstrom."""
    if _is_shown(source, view, "DataLabelRepresentation"):
        return
    manager = servermanager.ProxyManager()
    labels = servermanager._getPyProxy(
        manager.SMProxyManager.NewProxy("representations", "DataLabelRepresentation"))
    labels.Input = source
    labels.PointLabelVisibility, labels.CellLabelVisibility = 1, 0
    labels.PointFieldDataArrayName = array
    labels.PointLabelMode = 6  # of vtkLabeledDataMapper: the array of that name
    labels.PointLabelColor, labels.PointLabelBold = view.OrientationAxesLabelColor, 1
    labels.PointLabelFontSize = 13
    labels.MaximumNumberOfLabels = 1000000  # nearly all atoms of residues have an empty label
    if digits is not None:
        labels.PointLabelFormat = f"  {{:.{digits}f}} Å" if "{" in labels.PointLabelFormat else f"  %.{digits}f Å"
        labels.PointLabelFontSize = 18
    labels.UpdateVTKObjects()
    manager.RegisterProxy("representations", f"Labels{labels.SMProxy.GetGlobalIDAsString()}", labels)
    view.Representations.append(labels)


def _show_surfaces(pockets, view):
    """Shows the best pockets faintly and the chosen one strongly, in the colours of their ranks."""
    display = None
    for name, last, opacity in ((BEST_SURFACES, BEST, FAINT), (CHOSEN_SURFACE, 1, STRONG)):
        surface = surface_of(pockets, name, last)
        surface.UpdatePipeline()
        shown = simple.Show(surface, view)
        shown.SetRepresentationType("Surface")
        shown.Opacity = opacity
        _colour_by_rank(shown, "CELLS", view, pockets)
        display = display or shown
    return display


def _show_molecule(source, view):
    """Shows the molecule pale and not selectable: as a cartoon with its ligands, or thin where it has no residues."""
    cartoon = _cartoon_of(source)
    if cartoon is not None:
        display = simple.Show(simple.OutputPort(cartoon, molecules.CARTOON), view)
        colours.plain(display)
        display.AmbientColor = display.DiffuseColor = [0.72, 0.72, 0.75]
        display.Pickable = 0
        if cartoon.SMProxy.GetDataInformation(molecules.STICKS).GetNumberOfCells():
            ligands = simple.Show(simple.OutputPort(cartoon, molecules.STICKS), view)
            molecules.look(ligands, view, molecules.STICKS)
            ligands.Pickable = 0
        return
    display = simple.Show(source, view)
    display.SetRepresentationType("Surface")
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = [0.55, 0.55, 0.6]
    display.LineWidth, display.PointSize, display.Opacity = 1.0, 1.0, 0.6
    display.Pickable = 0


def _cartoon_of(source):
    """The cartoon of a molecule; None where it has no residues."""
    if source.PointData["ResidueId"] is None:
        return None
    for proxy in simple.GetSources().values():
        if proxy.SMProxy.GetXMLName() == "MoleculeCartoon" and proxy.Input.SMProxy == source.SMProxy:
            return proxy
    cartoon = entries.make("MoleculeCartoon", source, name_of(source, "cartoon"), hidden=False, follows=False)
    cartoon.UpdatePipeline()
    if cartoon.SMProxy.GetDataInformation(molecules.CARTOON).GetNumberOfCells():
        return cartoon
    simple.Delete(cartoon)
    return None


def _beside(view, kind, share):
    """The layout, and the location of a new cell to the right of `view` or below it."""
    layout = simple.GetLayout(view)
    cell = layout.SMProxy.GetViewLocation(view.SMProxy)
    split = layout.SplitHorizontal if kind == "right" else layout.SplitVertical
    split(cell, share)
    return layout, 2 * cell + 2


def new_view(name, beside, kind, share):
    """A new view to the right of another one or below it, which keeps the given share; the view is closed when its
    sources are deleted."""
    layout, hint = _beside(beside, kind, share)
    view = simple.CreateView(name)
    simple.AssignViewToLayout(view=view, layout=layout, hint=hint)
    own_views.add(view.SMProxy.GetGlobalID())
    return view


own_views = set()  # tables and charts that buttons have opened, by global id


def close_empty_views():
    """Closes the tables and charts opened by buttons that are empty because their sources were deleted."""
    for view in list(simple.GetViews()):
        number = view.SMProxy.GetGlobalID()
        if number not in own_views or any(getattr(display, "Input", None) for display in view.Representations):
            continue
        own_views.discard(number)
        layout = simple.GetLayout(view)
        if layout is not None:
            cell = layout.SMProxy.GetViewLocation(view.SMProxy)
            layout.SMProxy.RemoveView(view.SMProxy)
            layout.SMProxy.Collapse(cell)
        simple.Delete(view)


def show_table(source, port, hidden, beside, kind, share):
    """Opens a table with units in the headers of its columns, the rank first, and without the columns `hidden`; returns its
    view."""
    table = entries.make("RenameArrays", simple.OutputPort(source, port), name_of(source, "table"))
    table.RowArrays = [name for column in _columns(source, port) if _header_of(column) != column
                       for name in (column, _header_of(column))]
    sheet = new_view("SpreadSheetView", beside, kind, share)
    sheet.HiddenColumnLabels = [_header_of(column) for column in hidden]
    simple.Show(table, sheet, "SpreadSheetRepresentation")
    return sheet


def _header_of(column):
    return FIRST_COLUMNS.get(column) or (f"{column} ({UNITS[column]})" if column in UNITS else column)


def _columns(source, port):
    source.UpdatePipeline()
    rows = source.SMProxy.GetDataInformation(port).GetAttributeInformation(ROW)
    return [rows.GetArrayInformation(i).GetName() for i in range(rows.GetNumberOfArrays())]


def _show_table(features, beside, kind, share):
    name = features.SMProxy.GetXMLName()
    return show_table(features, FEATURES[name]["table"], HIDDEN_COLUMNS[name], beside, kind, share)


def _show_chart(pores, view):
    chart = new_view("XYChartView", view, "right", 0.58)
    lines = simple.Show(chart_of(pores), chart, "XYChartRepresentation")
    lines.AttributeType = "Row Data"
    lines.UseIndexForXAxis = 0
    lines.XArrayName = "ArcLength"
    lines.SeriesVisibility = ["Radius"]
    lines.SeriesLineThickness = ["Radius", "3"]
    chart.BottomAxisTitle = f"Along the pore (Å). One water passes from {WATERS[0]} Å, two from {WATERS[1]} Å"
    chart.ChartTitleFontSize = chart.BottomAxisTitleFontSize = 12
    _title_chart(chart_of(pores), chart)
    chart.LeftAxisUseCustomLabels = 1
    chart.LeftAxisLabels = [word for value in ("0", *WATERS, "3", "4", "5") for word in (value, value)]
    chart.LeftAxisUseCustomRange = 1
    chart.LeftAxisRangeMinimum, chart.LeftAxisRangeMaximum = 0.0, 6.0
    return chart


def _title_chart(profile, chart):
    """The title of a chart: the narrowest place. The axis names the radii of atoms."""
    pores = servermanager._getPyProxy(profile.Input.SMProxy)
    chart.LeftAxisTitle = f"Radius (Å), {RADII[pores.RadiusTable.GetData()]}"
    rows = servermanager.Fetch(profile)
    columns = ("Radius", "ArcLength", "RadiusError")
    places = [[rows.GetValueByName(row, name).ToDouble() for name in columns] for row in range(rows.GetNumberOfRows())]
    chart.ChartTitle = ""
    if places:
        radius, along, _ = min(places)
        error = radius - min(each - below for each, _, below in places)  # of the narrowest place, wherever it is
        digits = 2 if error >= 0.005 else 3
        chart.ChartTitle = (f"Pore {int(profile.MinValue)}. Narrowest: {radius:.{digits}f} ± {error:.{digits}f} Å, at {along:.1f} Å")


def follow_profile(profile, chart):
    """Called for new data of the profile that a chart shows, such as with other radii of the atoms."""
    if getattr(profile.Input, "SMProxy", None) and profile.Input.SMProxy.GetXMLName() in FEATURES:
        pores = servermanager._getPyProxy(profile.Input.SMProxy)
        _title_chart(profile, chart)
        _narrowest_of(pores, int(profile.MinValue))
        simple.RenderAllViews()


def _narrowest_of(pores, number):
    """The filter that extracts the largest ball at the narrowest place of a pore."""
    data = servermanager.Fetch(pores, idx=BOTTLENECKS).GetPointData()
    pore, rank = data.GetArray("PoreId"), data.GetArray("Rank")
    places = [i for i in range(pore.GetNumberOfTuples() if pore else 0) if (pore.GetTuple1(i), rank.GetTuple1(i)) == (number, 1)]
    found = _fed_by(pores, BOTTLENECKS, "ExtractSelection")
    if found is None:
        found = entries.make("ExtractSelection", simple.OutputPort(pores, BOTTLENECKS), name_of(pores, "narrowest place"),
                             hidden=False, Selection=selections.of_ids("POINT", places))
    else:
        found.Selection = selections.of_ids("POINT", places)
    found.UpdatePipeline()
    return found


def show_balls(display):
    """Shows points as translucent yellow balls with their radius."""
    display.SetRepresentationType("Point Gaussian")
    display.ShaderPreset, display.GaussianRadius = "Sphere", 1.0
    display.ScaleByArray, display.UseScaleFunction = 1, 0
    display.SetScaleArray = ["POINTS", "Radius"]
    colours.plain(display)
    display.DiffuseColor = display.AmbientColor = BALL
    display.Opacity, display.Pickable = 0.4, 0


def show(features, view=None, tables=True):
    """Shows shapes, molecule and residues in `view`, and beside it the table and, for a pore, the chart."""
    name = features.SMProxy.GetXMLName()
    kind = FEATURES[name]
    view = view or simple.GetActiveViewOrCreate("RenderView")
    _show_molecule(features.Input, view)
    if "chart" in kind:
        display = simple.Show(simple.OutputPort(features, kind["shapes"]), view)
        colour_shapes(display, view)
    else:
        display = _show_surfaces(features, view)
        lining_of(features)
    _show_residues(residues_of(features), view)
    if "chart" in kind:
        narrowest = _narrowest_of(features, 1)
        show_balls(simple.Show(narrowest, view))
        show_labels(narrowest, view, "Radius", 2)
    simple.ResetCamera(view)
    view.GetActiveCamera().Zoom(1.3)  # the camera has made room for stray water molecules
    place_names(residues_of(features), view)
    if tables:
        chart = _show_chart(features, view) if "chart" in kind else None
        _show_table(features, chart or view, "below" if chart else "right", 0.6)
        simple.SetActiveView(view)
    simple.SetActiveSource(features)  # not a table or surface that was made for the display
    return display
