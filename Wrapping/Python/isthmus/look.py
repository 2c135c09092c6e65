"""The first display of results of Isthmus' filters: meaningful colours, ranges without outliers,
words for categories, tubes for loops. pipelines.py builds the pipelines; the window calls first_look() for each result that is new or changed.
"""

try:
    from paraview import servermanager, simple
except ImportError:
    servermanager = simple = None  # with pip's vtk alone, isthmus.pipelines can still be imported

from . import cameras, colours, diagram_views, figures, loop_views, messages, steps, track_views
from . import molecule_views as molecules
from . import pocket_views as pockets_and_pores

# Colours. A signed quantity spans a range symmetric about 0, so that its neutral colour means 0.
DIVERGING = "Cool to Warm"
SEQUENTIAL = colours.sequential()
CURVATURES = ("MeanCurvature", "GaussianCurvature", "MaximumCurvature", "MinimumCurvature")
SIGNED = CURVATURES + (
    "Potential", "PolarizedCurvature", "PositivePotentialKappa1", "PositivePotentialKappa2",
    "NegativePotentialKappa1", "NegativePotentialKappa2", "SignedDistance")
SITES = ("BindingSites", "BindingSitesInPockets")
IONS = ("IonTransport", "IonTransportOnSurface", "IonTransportMovingSurface")
MESHES = ("TetrahedralMesher", "IsosurfaceStuffing")
MOLECULES = ("MacromoleculeReader", "TrajectoryReader")
MAPS = ("DensityMapReader",)
DENOISERS = ("DenoiseMap", "DenoiseFromHalfMaps", "HighOrderDiffusion")  # their output is a map, displayed as a surface
LEVELS = ("ScalarPersistence", "MapHandles")  # have Betti numbers over levels
# Surfaces that are shown in the place of a molecule.
ENVELOPES = ("MolecularFlowSurface", "SolvationSurface", "PoissonBoltzmann", "PoissonBoltzmannOnSurface")
UNSIGNED = ("Curvedness",)
FIXED = {"ShapeIndex": (-1.0, 1.0), "Potential": (-5.0, 5.0)}  # as all programs draw potentials
TITLES = {
    "MeanCurvature": "Mean curvature (1/Å)", "GaussianCurvature": "Gaussian curvature (1/Å²)",
    "MaximumCurvature": "Maximum curvature (1/Å)", "MinimumCurvature": "Minimum curvature (1/Å)",
    "Curvedness": "Curvedness (1/Å)", "ShapeIndex": "Shape index", "Potential": "Potential (kT/e)",
    "PolarizedCurvature": "Polarized curvature (kT/(e Å))", "Kind": "Choking loops",
    "BindingSite": "Binding sites", "SiteClass": "Kind of site",
    "Exposed": "Faces", "WidthClass": "Room in the pore"}
# The colours of Okabe and Ito, suitable for colour-blind readers.
VERMILION, ORANGE, SKY, GREEN, YELLOW, BLUE, PURPLE, GREY = (
    (0.835, 0.369, 0.0), (0.902, 0.624, 0.0), (0.337, 0.706, 0.914), (0.0, 0.620, 0.451),
    (0.941, 0.894, 0.259), (0.0, 0.447, 0.698), (0.800, 0.475, 0.655), (0.80, 0.80, 0.80))
FURTHER, BLACK = (0.70, 0.64, 0.74), (0.0, 0.0, 0.0)
UNDEFINED = (0.40, 0.40, 0.40)  # of values that are not numbers, as at the border of a map; unlike the colour of 0
BETTI = (("Beta0", "components", VERMILION), ("Beta1", "tunnels", BLUE), ("Beta2", "cavities", GREEN))
CATEGORIES = {
    "Kind": (("0", "handle", VERMILION), ("1", "tunnel", BLUE), ("2", "bottleneck", ORANGE)),
    "SiteClass": (
        ("0", "none", GREY), ("1", "for - proteins", SKY), ("2", "for - ligands", BLUE),
        ("3", "for + proteins", ORANGE), ("4", "for + ligands", VERMILION)),
    "Exposed": (("0", "boundary of the mesh", GREY), ("1", "exposed by the cut", ORANGE)),
    "BindingSite": (
        ("0", "no site", GREY), ("1", "best site", VERMILION), ("2", "second", BLUE),
        ("3", "third", GREEN), ("4", "fourth", ORANGE), ("5", "fifth", PURPLE)),
    "WidthClass": (
        ("0", "too narrow for water", VERMILION), ("1", "one water", GREEN), ("2", "wider", BLUE)),
}


def data_of(source):
    """The information of a source's output, which is updated if necessary."""
    source.UpdatePipeline()
    return source.GetDataInformation().DataInformation


def range_by_area(port, association, array):
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
    """Range for a colour bar; None if no range is defined for the array."""
    if array in FIXED:
        return FIXED[array]
    if array not in SIGNED and array not in UNSIGNED:
        return None
    found = range_by_area(port, association, array)
    if not found:
        return None
    top = max(abs(found[0]), abs(found[1]))
    if not top > 0.0:
        return None
    return (-top if array in SIGNED else 0.0), top


def _set_categories(table, array):
    colours.set_categories(table, CATEGORIES[array])
    table.NanColor = FURTHER  # values without a name of their own


def number_format(bar, form):
    """A format of numbers for a legend: `form` of printf (".2g"), or from ParaView 6.1 on the same of std::format."""
    return "{:" + form.replace("-", "<") + "}" if "{" in bar.LabelFormat else "%" + form


def _bar(table, view, array):
    bar = colours.legend(table, view, TITLES.get(array, array))
    bar.RangeLabelFormat = number_format(bar, "-#.2g")  # 0.17, not 1.7e-01


_ranges = set()  # global ids of colour maps whose range or categories are set: once, by first_look()
_named = set()  # colour maps whose categories first_look() has named
_titled = set()  # (colour map, view) whose legend has its title


def _title(table, view, array):
    """Gives a legend its title, once in each view: a colour map that several views use has a legend in each."""
    pair = table.GetGlobalID(), view.SMProxy.GetGlobalID()
    if pair not in _titled and hasattr(view, "HiddenLineRemoval"):  # a render view
        _titled.add(pair)
        _bar(table, view, array)


_plain = {}  # displays in a solid colour because their array has no values, by global id: (association, array)


def _follow_values(display, view):
    """Uses a solid colour for a display while its array has no values, and colours by the array again once it has some."""
    if not hasattr(display, "UseSeparateColorMap"):  # a vtkMolecule representation, which has its own colours
        return
    key = display.GetGlobalID()
    association, array = _plain.get(key) or display.ColorArrayName[:2]
    if not array or display.Input is None or (key in _plain and display.ColorArrayName[1]):
        _plain.pop(key, None)  # the user has chosen another array meanwhile
    elif not colours.has_values(display.Input, association, array):
        if key not in _plain:
            _plain[key] = association, array
            colours.plain(display)
            simple.HideUnusedScalarBars(view)
    elif key in _plain:
        del _plain[key]
        colours.colour_by(display, association, array)
        display.SetScalarBarVisibility(view, True)


def _categories_of(display):
    """The categories in the data of a display."""
    association, array = display.ColorArrayName[:2]
    if array == "Kind":
        data = servermanager.Fetch(display.Input)
        kinds = data.GetCellData().GetArray("Kind") if data.IsA("vtkDataSet") else None
        return {int(kinds.GetTuple1(i)) for i in range(kinds.GetNumberOfTuples())} if kinds else set()
    values = (display.Input.PointData if association == "POINTS" else display.Input.CellData)[array]
    low, high = values.GetRange(0) if values else (0.0, -1.0)
    return set(range(int(low), int(high) + 1))


def _name_categories(table, array):
    """A legend of the categories of all displays that use the colour map, also of those hidden at present: all loops while
    only the selected ones are shown."""
    there = set()
    for view in simple.GetViews():
        for display in view.Representations:
            if hasattr(display, "ColorArrayName") and display.ColorArrayName[1] == array and display.LookupTable == table:
                there |= _categories_of(display)
    rows = [row for row in CATEGORIES[array] if int(row[0]) in there]
    if rows and list(table.Annotations)[::2] != [value for value, *_ in rows]:
        colours.set_categories(table, rows)


def _is_used(table, display):
    """Whether another visible display uses a colour map."""
    return any(getattr(other, "LookupTable", None) == table and other.Visibility and other != display and other.ColorArrayName[1]
               for view in simple.GetViews() for other in view.Representations if hasattr(other, "ColorArrayName"))


def _colour(display, view, first=False):
    _follow_values(display, view)
    association, array = display.ColorArrayName[0], display.ColorArrayName[1]
    if not array or (array not in CATEGORIES and array not in SIGNED and
                     array not in UNSIGNED and array not in FIXED):
        return
    table = display.LookupTable
    key = table.GetGlobalID()
    if array in CATEGORIES:
        if key not in _ranges:
            _ranges.add(key)
            _named.add(key)
            _set_categories(table, array)
        if key in _named:
            _name_categories(table, array)
        _title(table, view, array)
        return
    if key in _ranges and (not first or _is_used(table, display)):  # see colour_by()
        _title(table, view, array)
        return
    limits = colour_range(display.Input, association, array)
    if not limits:
        return
    table.ApplyPreset(SEQUENTIAL if array in UNSIGNED else DIVERGING, True)
    if array == "Potential":
        table.InvertTransferFunction()  # red is negative, as everywhere in structural biology
    table.AutomaticRescaleRangeMode = "Never"
    table.NanColor = UNDEFINED
    _title(table, view, array)
    table.RescaleTransferFunction(*limits)
    opacity = display.OpacityTransferFunction
    if opacity:
        opacity.RescaleTransferFunction(*limits)
    _ranges.add(key)


def _look_at_loops(display, view, port):
    """Loops as tubes coloured by kind, on a translucent surface; nothing else."""
    if port == 0:
        if display.Input.SMProxy.GetGlobalID() in _by_hand:
            loop_views.show_radius(servermanager._getPyProxy(display.Input.SMProxy))
        loop_views.look(display, view)
        # For a map, the contour is an output; for a surface, it is the input.
        loops = servermanager._getPyProxy(display.Input.SMProxy)
        own = loops.SMProxy.GetNumberOfOutputPorts() > 4
        surface = simple.OutputPort(loops, 4) if own else loops.Input
        envelope = simple.Show(surface, view)
        envelope.Opacity, envelope.Pickable = 0.35, 0  # must not catch clicks on loops
    elif port < 4:
        display.Visibility = 0


def _look_at_ions(display, view):
    """A channel's volume cut along the channel, not its outline, and seen upright from the side."""
    normal = list(servermanager._getPyProxy(display.Input.SMProxy).MembraneNormal)
    upright = abs(normal[2]) == max(abs(x) for x in normal)
    across = 1 if upright else 2
    data = data_of(display.Input)
    extent, bounds = data.GetExtent(), data.GetBounds()
    display.SetRepresentationType("Slice")
    display.SliceMode = "XZ Plane" if upright else "XY Plane"
    display.Slice = (extent[2 * across + 1] - extent[2 * across]) // 2
    if colours.colour_by(display, "POINTS", "Potential"):
        display.SetScalarBarVisibility(view, True)
    middle = [0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]) for axis in range(3)]
    simple.ResetCameraToDirection(middle, [0, 1, 0] if upright else [0, 0, -1], normal, view)


def _look_at_mesh(display, view):
    """Shows the edges of cells, and colours regions if there is more than one."""
    display.SetRepresentationType("Surface With Edges")
    _colour_if_it_differs(display, view, "RegionId")


def _show_surface(display, view, name):
    """The surface of a map, by a separate Map Surface with its own level, and the box of the map as an outline."""
    if display.Representation != "Outline" or not _is_map(display.Input):
        return None
    selected = simple.GetActiveSource()
    surface = simple.MapSurface(
        display.Input, registrationName=pockets_and_pores.name_of(display.Input, name), **steps.FIRST["MapSurface"])
    surface.UpdatePipeline()
    if surface.FieldData["InvertedContrast"]:
        surface.InsideIsHigher = 0
        surface.UpdatePipeline()
    level = surface.FieldData["Level"]
    if level is not None:
        surface.AutomaticLevel, surface.Level = 0, level.GetRange()[0]
        surface.UpdatePipeline()
    simple.SetActiveSource(selected)
    if not data_of(surface).GetNumberOfCells():
        simple.Delete(surface)
        return None
    simple.Show(surface, view)
    return surface


def _look_at_opened(display, view, name):
    """The initial view of a file opened by the user: the surface of a map, or the cartoon of a molecule with ligands as balls
    and sticks. Both are ordinary filters; the setting Isthmus > Surface And Cartoon Of Files turns them off."""
    if display.Input.SMProxy.GetGlobalID() not in _by_hand or not _shows_files() or _has_filters(display.Input):
        return
    before, shown = set(simple.GetSources().values()), None
    if name in MAPS and data_of(display.Input).GetNumberOfPoints() <= steps.MOST_NODES:
        shown = _show_surface(display, view, "surface")
    elif name in MOLECULES and getattr(display.Input, "Port", 0) == 0 and display.Input.PointData["ResidueId"] is not None:
        selected = simple.GetActiveSource()
        shown = simple.MoleculeCartoon(
            display.Input, registrationName=pockets_and_pores.name_of(display.Input, "cartoon"))
        shown.UpdatePipeline()
        simple.SetActiveSource(selected)
        if data_of(shown).GetNumberOfCells():
            molecules.show(shown, view)
            _hide_molecule(display.Input, view)
            display.Visibility = 0
        else:
            simple.Delete(shown)
            shown = None
    if shown is not None and not any(each.Visibility for each in view.Representations if getattr(
            each, "Input", None) is not None and not comes_from(each.Input.SMProxy, display.Input.SMProxy)):
        # Not to the box of the map, or the water of the molecule, which may be much larger.
        view.SMProxy.ResetCamera(*shown.GetDataInformation().GetBounds())
    _first_sights.update(source.SMProxy.GetGlobalID() for source in set(simple.GetSources().values()) - before)


_first_sights = set()  # global ids of the filters that _look_at_opened() has made


def _hide_first_sight(source, view):
    """Hides the surface or cartoon of an opened file, which a filter that the user has applied to it would be drawn over."""
    given = getattr(getattr(source, "Input", None), "SMProxy", None)
    if given is None or source.SMProxy.GetGlobalID() in _first_sights:
        return
    for display in view.Representations:
        shown = getattr(display, "Input", None)
        if shown is None or shown.SMProxy.GetGlobalID() not in _first_sights or not display.Visibility:
            continue
        if shown.SMProxy.GetProducerProxy(0) == given:
            display.Visibility = 0
    simple.HideUnusedScalarBars(view)


def _hide_made_from(origin, part, view):
    """Hides the surfaces made from a map, except those made from a part of its pipeline, which lie in the same place."""
    for display in view.Representations:
        shown = getattr(display, "Input", None)
        if shown is not None and hasattr(display, "ColorArrayName") and shown.SMProxy != origin and comes_from(
                shown.SMProxy, origin) and not comes_from(shown.SMProxy, part):
            display.Visibility = 0
    simple.HideUnusedScalarBars(view)


def _has_filters(source):
    """True if the user has already applied a filter or pressed a button."""
    return any(getattr(getattr(other, "Input", None), "SMProxy", None) == source.SMProxy
               for other in simple.GetSources().values())


def _shows_files():
    settings = servermanager.ProxyManager().GetProxy("settings", "IsthmusSettings")
    return settings is None or bool(settings.SurfaceAndCartoonOfFiles)


def _count_atoms(port):
    data = data_of(port)
    return max(data.GetNumberOfPoints(), data.GetNumberOfVertices())  # the latter of a vtkMolecule


def _colour_if_it_differs(display, view, array):
    """A plain colour if a cell array has a single value: a colour bar would be empty."""
    cells = _range_of_cells(display.Input, array)
    if cells is None or cells[0] == cells[1]:
        colours.plain(display)
        simple.HideUnusedScalarBars(view)


def _range_of_cells(source, array):
    """(lowest, highest) value of a cell array, or None."""
    found = source.CellData[array]
    return found.GetRange(0) if found else None


def _draw_curves(display, view, x, curves, titles):
    """`curves` (column, words, colour) over column `x`, instead of all columns over the row."""
    display.AttributeType = "Row Data"
    display.UseIndexForXAxis, display.XArrayName = 0, x
    # One by one: the panel that shows the series puts back what a shorter list leaves out.
    series = servermanager.vtkSMPropertyHelper(display.SMProxy, "SeriesVisibility")
    for name in list(display.SeriesVisibility):
        series.SetStatus(name, 0)
    for name, label, colour in curves:
        series.SetStatus(name, 1)
        servermanager.vtkSMPropertyHelper(display.SMProxy, "SeriesLabel").SetStatus(name, label)
        servermanager.vtkSMPropertyHelper(display.SMProxy, "SeriesColor").SetStatus(name, colour, 3)
    display.SMProxy.UpdateVTKObjects()
    view.ChartTitle, view.BottomAxisTitle, view.LeftAxisTitle = titles


def _columns(table):
    """Names of the columns of a table."""
    rows = data_of(table).GetAttributeInformation(6)  # vtkDataObject.ROW
    return [rows.GetArrayInformation(i).GetName() for i in range(rows.GetNumberOfArrays())]


def _look_at_currents(display, view):
    """A channel's currents over the position of the cross-section, or over the updates of the surface."""
    x, words = (("Update", "Update") if "Update" in _columns(display.Input)
                else ("Along", "Position along the axis (Å)"))
    ions = sorted(name for name in _columns(display.Input) if name.startswith("Current_"))
    curves = [(name, name[len("Current_"):], colour)
              for name, colour in zip(ions, (VERMILION, BLUE, GREEN, ORANGE, PURPLE))]
    _draw_curves(display, view, x, [("Current", "all ions", BLACK), *curves], ("Currents", words, "Current (pA)"))


def _look_at_handles(display, port):
    """Bridges and windows as balls that can be seen on a translucent contour."""
    if port < 2:
        display.RenderPointsAsSpheres, display.PointSize = 1, 10.0
    elif port == 4:
        display.Opacity = 0.35


def _hide_molecule(atoms, view):
    """The balls and sticks of atoms that a surface has replaced in the view."""
    reader = servermanager._getPyProxy(atoms.SMProxy)
    if reader.SMProxy.GetXMLName() in MOLECULES:
        simple.Hide(simple.OutputPort(reader, 1), view)
        simple.HideUnusedScalarBars(view)


# Columns that a spreadsheet of residues hides initially, so that name, number and structure are visible.
HIDDEN_OF_RESIDUES = ("ChainIndex", "InsertionCode", "Point ID", "Points")
# Columns that a spreadsheet of sites hides initially: ParaView sorts columns by name, and these would come
# before rank, class, residues, score and volume.
HIDDEN = ("Area", "CenterX", "CenterY", "CenterZ", "MeanDepth", "MeanPotential", "Points", "Row ID", "SiteClass")


def _view_of(display):
    """The view that shows it; the active one may be a table or chart beside that."""
    views = [view for view in simple.GetViews() if display in list(view.Representations)]
    return views[0] if views else simple.GetActiveView()


def _menu_of(source):
    """The category of a filter in the menu Filters; "" without one."""
    hints = source.SMProxy.GetHints()
    entry = hints.FindNestedElementByName("ShowInMenu") if hints else None
    return (entry.GetAttribute("category") or "") if entry else ""


_seen = set()


def _look_at_table(display, view, name):
    if hasattr(display, "XArrayName") and "Isthmus" in _menu_of(display.Input):
        pockets_and_pores.own_views.add(view.SMProxy.GetGlobalID())  # a chart is closed with its source
    if name in SITES:
        view.HiddenColumnLabels = HIDDEN
    elif name == "MoleculeCartoon" and hasattr(view, "HiddenColumnLabels"):
        view.HiddenColumnLabels = HIDDEN_OF_RESIDUES
    elif name in pockets_and_pores.FEATURES:
        view.HiddenColumnLabels = pockets_and_pores.HIDDEN_COLUMNS[name]
    elif name in LEVELS and hasattr(display, "XArrayName") and _columns(display.Input).count("Level"):
        _draw_curves(display, view, "Level", BETTI, ("Betti curves", "Level", "Number"))
    elif name in IONS and hasattr(display, "XArrayName"):
        _look_at_currents(display, view)


def _look_at_shape(display, view, source, name):
    port = getattr(source, "Port", 0)
    if source.SMProxy.GetGlobalID() in _by_hand and hasattr(view, "HiddenLineRemoval"):
        _hide_first_sight(source, view)
    if name in loop_views.LOOPS:
        _look_at_loops(display, view, port)
    elif name in SITES and port == 0:
        if colours.colour_by(display, "POINTS", "BindingSite"):
            display.SetScalarBarVisibility(view, True)
    elif name in IONS and port == 0:
        _look_at_ions(display, view)
    elif name == "MapHandles":
        _look_at_handles(display, port)
    elif name in MESHES:
        _look_at_mesh(display, view)
    elif name == "HandleFilling" and port == 0:
        _colour_if_it_differs(display, view, "Filling")
    elif name in ENVELOPES:
        _hide_molecule(source.Input, view)
    elif name in DENOISERS and port == 0 and source.SMProxy.GetGlobalID() in _by_hand:
        if _show_surface(display, view, "denoised surface"):
            display.Visibility = 0
            _hide_made_from(source.Input.SMProxy, source.SMProxy, view)
    elif name in MOLECULES and not _count_atoms(display.Input):
        display.Visibility = 0  # of a file without atoms: ParaView shows a legend of nothing
        simple.HideUnusedScalarBars(view)
    elif name in MAPS + MOLECULES:
        _look_at_opened(display, view, name)
    elif name == "AtomSelection":
        pockets_and_pores.sticks(display, view)
    elif name == "MoleculeCartoon":
        molecules.look(display, view, port)
        _hide_molecule(source.Input, view)
    elif name in pockets_and_pores.FEATURES:
        pockets_and_pores.look(display, view, port)


def is_displayed(display):
    """Remembers that a display has its look."""
    _seen.add(display.GetGlobalID())


def _look(display):
    """Returns the view if this was the first display of a representation, or if one of its texts has changed."""
    source = getattr(display, "Input", None)
    if source is None:
        return None
    view = _view_of(display)
    name = source.SMProxy.GetXMLName()
    key = display.GetGlobalID()
    first = key not in _seen
    _seen.add(key)
    if not hasattr(display, "ColorArrayName"):
        if first:
            _look_at_table(display, view, name)
        elif name == "ThresholdTable":
            pockets_and_pores.follow_profile(source, view)
    else:
        if first:
            _look_at_shape(display, view, source, name)
        _colour(display, view, first)
        if name in loop_views.LOOPS and getattr(source, "Port", 0) == 0 and loop_views.count(source, view):
            return view
        if name == "Threshold" and pockets_and_pores.replace_names(source, view):
            return view
    return view if first else None


def first_look(*ids):
    """Called by the window with the global ids of representations that are new or changed."""
    session = servermanager.ActiveConnection.Session
    views, lit = {}, []
    for number in ids:
        proxy = session.GetRemoteObject(number)
        if proxy is None:
            continue
        try:
            display = servermanager._getPyProxy(proxy)
            view = _look(display)
            if view is not None:
                views[view.GetGlobalID()] = view
                if display.Input.SMProxy.GetXMLName() in MAPS + MOLECULES or _is_ours(display.Input.SMProxy):
                    lit.append(view)
        except Exception:  # a failed display must not cause an error
            messages.fault("The initial display of a result")
    for view in views.values():  # ParaView has drawn them before
        if hasattr(view, "HiddenLineRemoval"):  # a render view
            simple.HideUnusedScalarBars(view)
            if view in lit:
                figures.first_sight(view)
        view.SMProxy.StillRender()


_previews = {}  # by the global id of a filter whose slider is held: the contour, what draws it, and what it hides


@messages.reports_faults("The preview of a level")
def preview_level(number, level):
    """Called by the window while the slider of the level of that filter is held: shows the contour of the level in
    each view that shows the filter or something derived from it, and hides these."""
    source = servermanager._getPyProxy(servermanager.ActiveConnection.Session.GetRemoteObject(number))
    if number not in _previews:
        _previews[number] = _begin_preview(source)
    surface, drawn, _ = _previews[number]
    surface.Level = level
    surface.UpdatePipeline()
    for view, _ in drawn:
        view.SMProxy.StillRender()


def _begin_preview(source):
    manager = servermanager.ProxyManager()
    surface = servermanager.filters.MapSurface(Input=source.Input, AutomaticLevel=0)
    for name in ("SelectInputScalars", "InsideIsHigher", "LargestComponents", "MinimumComponentArea",
                 "MinimumComponentShare"):
        if source.SMProxy.GetProperty(name):
            surface.SMProxy.GetProperty(name).Copy(source.SMProxy.GetProperty(name))
    surface.SMProxy.UpdateVTKObjects()
    hidden, drawn = [], []
    for view in simple.GetViews():
        if not hasattr(view, "HiddenLineRemoval"):  # no render view
            continue
        shown = [display for display in view.Representations if getattr(display, "Input", None) is not None and
                 display.Visibility and hasattr(display, "Opacity") and comes_from(display.Input.SMProxy, source.SMProxy)]
        if not shown:
            continue
        hidden += shown
        contour = servermanager._getPyProxy(manager.SMProxyManager.NewProxy("representations", "GeometryRepresentation"))
        contour.Input = surface
        contour.Representation = "Surface"
        contour.Opacity = min(display.Opacity for display in shown)
        view.Representations.append(contour)
        drawn.append((view, contour))
    for display in hidden:
        display.Visibility = 0
    loop_views.mark_stale(lambda proxy: comes_from(proxy, source.SMProxy))
    return surface, drawn, hidden


def comes_from(proxy, origin):
    """Whether a source is `origin` or made from it."""
    return proxy == origin or any(comes_from(proxy.GetProducerProxy(i), origin)
                                  for i in range(proxy.GetNumberOfProducers()))


@messages.reports_faults("The preview of a level")
def end_preview(number):
    """Called by the window when the slider is released: removes the preview and shows the filters again, without drawing."""
    _, drawn, hidden = _previews.pop(number, (None, (), ()))
    for view, contour in drawn:
        view.Representations.remove(contour)
    for display in hidden:
        display.Visibility = 1


@messages.reports_faults("The change of a property")
def live_change(number):
    """Called by the window with the global id of a filter that has a new result, before that is drawn."""
    proxy = servermanager._getPyProxy(servermanager.ActiveConnection.Session.GetRemoteObject(number))
    if proxy is not None and proxy.SMProxy.GetXMLName() == "MolecularPockets":
        pockets_and_pores.show_only(proxy, int(proxy.ShownPocket))
    if proxy is not None and proxy.SMProxy.GetXMLName() in loop_views.LOOPS:
        for view in simple.GetViews():
            if any(getattr(getattr(display, "Input", None), "SMProxy", None) == proxy.SMProxy
                   for display in view.Representations):
                loop_views.count(proxy, view)
    if proxy is not None and proxy.SMProxy.GetXMLName() in diagram_views.DIAGRAMS:
        diagram_views.follow_threshold(proxy)


@messages.reports_faults("Keeping the look of what was loaded")
def keep_looks():
    """Called by the window after a state was loaded, or a step was undone or redone: existing displays keep their look,
    and labels still follow the camera and views still close with their source."""
    for view in simple.GetViews():
        is_render_view = hasattr(view, "HiddenLineRemoval")
        if is_render_view:
            cameras.follow(view)
        for display in view.Representations:
            source = getattr(display, "Input", None)
            if source is None:
                continue
            _seen.add(display.GetGlobalID())
            if not is_render_view and _is_ours(source.SMProxy):
                pockets_and_pores.own_views.add(view.SMProxy.GetGlobalID())
            table = getattr(display, "LookupTable", None)
            if table is not None:
                _ranges.add(table.GetGlobalID())
                _titled.add((table.GetGlobalID(), view.SMProxy.GetGlobalID()))


def _is_ours(proxy):
    """Whether the data comes from a filter of Isthmus, or from one that a button has added downstream of it."""
    return "Isthmus" in _menu_of(servermanager._getPyProxy(proxy)) or any(
        _is_ours(proxy.GetProducerProxy(i)) for i in range(proxy.GetNumberOfProducers()))


_by_hand = set()  # global ids of filters that a menu has created


@messages.reports_faults("Proposing values")
def first_values(number):
    """Called by the window with the global id of a filter that a menu has created and that waits for its first Apply:
    sets steps.FIRST, as the buttons do, and values proposed from the data."""
    proxy = servermanager._getPyProxy(servermanager.ActiveConnection.Session.GetRemoteObject(number))
    if proxy is None:
        return
    _by_hand.add(number)
    name = proxy.SMProxy.GetXMLName()
    for key, value in steps.FIRST.get(name, {}).items():
        if proxy.SMProxy.GetProperty(key).IsValueDefault():
            setattr(proxy, key, value)
    if getattr(proxy, "Input", None) is None or not _is_map(proxy.Input):
        return
    if name == "ScalarPersistence":
        proxy.Superlevel = 1  # the dense region is the object
    elif name in steps.LEVELLED and proxy.AutomaticLevel:
        level = _proposed_level(proxy.Input)
        if level is not None:
            proxy.AutomaticLevel, proxy.Level = 0, level


def _is_map(port):
    return port.PointData["Density"] is not None and (
        port.GetDataInformation().GetDataSetTypeAsString() == "vtkImageData")


def _proposed_level(port):
    """The level that Map Surface proposes; None where it proposes none, or suspects that the contrast is inverted."""
    surface = servermanager.filters.MapSurface(Input=port)
    algorithm = surface.GetClientSideObject()  # of the built-in server
    if algorithm is not None:
        algorithm.AddObserver("WarningEvent", lambda *_: None)  # the filter itself will report it
    surface.UpdatePipeline()
    found = surface.FieldData["Level"]
    return found.GetRange()[0] if found and not surface.FieldData["InvertedContrast"] else None


def show(*proxies, view=None, tables=False):
    """Shows the last proxies of a pipeline as the window would, and returns the last display. tables: open
    the tables and charts of pockets and pores beside the view as well."""
    view = view or simple.GetActiveViewOrCreate("RenderView")
    if proxies[-1].SMProxy.GetXMLName() in pockets_and_pores.FEATURES:
        display = pockets_and_pores.show(proxies[-1], view, tables)
        _seen.update(each.GetGlobalID() for each in view.Representations)  # they are already displayed
        _look(display)
        return display
    if proxies[-1].SMProxy.GetXMLName() == "PointDatasetInterpolator":  # pipelines.map_with_model
        display = molecules.show_with_map(proxies[0], proxies[-1], view)
        _seen.update(each.GetGlobalID() for each in view.Representations)  # they are already displayed
        return display
    if proxies[-1].SMProxy.GetXMLName() == "FeatureTracks":  # pipelines.trajectory_to_loops
        _look(simple.Show(proxies[0], view))
        simple.ResetCamera(view)
        display = track_views.show(*proxies, view, tables)
        _seen.add(display.GetGlobalID())
        return display
    display = None
    for proxy in proxies:
        if data_of(proxy).GetDataSetTypeAsString() != "vtkPolyData":
            continue
        display = simple.Show(proxy, view)
        _look(display)
    for proxy in proxies[:-1]:
        if _replaced(proxy, proxies[-1]):
            simple.Hide(proxy, view)
    if proxies[-1].SMProxy.GetXMLName() in SITES:
        return _show_sites(proxies[-1], display, view, tables)
    if display is not None and display.LookupTable is not None and display.ColorArrayName[1]:
        display.SetScalarBarVisibility(view, True)
    simple.ResetCamera(view)
    if tables and proxies[-1].SMProxy.GetXMLName() in loop_views.LOOPS:
        loop_views.show_table(proxies[-1], view)
        simple.SetActiveView(view)
    return display


def _show_sites(sites, display, view, beside):
    """The best site faces the viewer. beside: the potential there in a second view that moves with the first one, and
    the table with the residues."""
    display.SetScalarBarVisibility(view, True)
    found = _name_sites(sites, display, view)
    _face(sites, found, view)
    if not beside:
        return display
    other = pockets_and_pores.new_view("RenderView", view, "right", 0.5)
    potential = simple.Show(sites, other, "GeometryRepresentation")
    _seen.add(potential.GetGlobalID())  # is displayed here
    colours.colour_by(potential, "POINTS", "Potential")
    _colour(potential, other)
    potential.SetScalarBarVisibility(other, True)
    _face(sites, found, other)
    simple.AddCameraLink(view, other, f"Isthmus{other.SMProxy.GetGlobalID()}")
    pockets_and_pores.show_table(sites, 1, HIDDEN, view, "below", 0.7)
    simple.SetActiveView(view)
    simple.SetActiveSource(sites)
    simple.Render(other)
    return display


def _name_sites(sites, display, view):
    """The legend lists the existing sites, and has one entry for those without a colour of their own. Returns the table of sites."""
    found = servermanager.Fetch(sites, idx=1)
    rows = CATEGORIES["BindingSite"]
    table = display.LookupTable
    colours.set_categories(table, rows[:1 + found.GetNumberOfRows()])
    bar = simple.GetScalarBar(table, view)
    bar.DrawNanAnnotation, bar.NanAnnotation = int(found.GetNumberOfRows() >= len(rows)), "further sites"
    return found


def _face(sites, found, view):
    """Points the camera at the best site from outside of the molecule; at the whole molecule if there is no site."""
    simple.ResetCamera(view)
    low_high = sites.GetDataInformation().GetBounds()
    middle = [0.5 * (low_high[2 * axis] + low_high[2 * axis + 1]) for axis in range(3)]
    if not found.GetNumberOfRows():
        return
    outward = [found.GetValueByName(0, f"Center{axis}").ToDouble() - middle[i] for i, axis in enumerate("XYZ")]
    length = sum(x * x for x in outward) ** 0.5
    if not length > 1e-3:
        return
    camera = view.GetActiveCamera()
    distance = camera.GetDistance()
    up = (0.0, 0.0, 1.0) if abs(outward[1]) > 0.9 * length else (0.0, 1.0, 0.0)
    view.CameraFocalPoint = middle
    view.CameraPosition = [middle[axis] + distance * outward[axis] / length for axis in range(3)]
    view.CameraViewUp = up
    view.GetActiveCamera().Zoom(1.3)


def _replaced(proxy, last):
    """Whether `last` shows the same as `proxy`, with additions."""
    return last.SMProxy.GetXMLName() in ("CurvatureOnSurface",) + SITES
