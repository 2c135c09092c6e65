"""Choking loops in the window: a text that says how many of them are shown, a table of them, and the effect of clicking a row.

    from isthmus import loop_views                # or: from isthmus_plugin, with the plugin loaded
    loop_views.words(loops)                       # "20 of 557 loops shown"
    loop_views.show_table(loops)                  # beside the active view

Selecting a loop in the table selects it in the view, points the camera at it and shows its radius; selections in the
view are shown in the table (diagram_views). Buttons and menus of the window set the properties in steps.SIGNIFICANT,
so that only significant loops are shown; functions in scripts report all loops. look.py calls count()
for each result that is new or has changed.
"""

import math

try:
    from paraview import servermanager, simple
except ImportError:
    servermanager = simple = None  # with pip's vtk alone, isthmus.pipelines can still be imported

from . import pocket_views as pockets_and_pores
from . import colours, entries, messages, selections, steps

LOOPS = ("ChokingLoops",)
STALE = "the loops follow when the slider is released"
COUNT = " shown"  # ends the names of the texts in the pipeline browser
CHOKE_POINTS = 2  # port of Choking Loops
ADVANCED = ("sides", "Minimum Persistence", "Maximum Length", "Maximum Reach")  # properties that the gear shows, in _advice()
CONTEXT = 3.0  # size of the region shown around a clicked loop, relative to the size of the loop
# Executed where the data is. Inputs: the loops, and the atoms of which the surface was made, if any. The residues of a loop
# are those of the atoms nearest to its points; its position is the mean of them.
SCRIPT = """# The table of choking loops, the narrowest one first.
import numpy
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkStaticPointLocator

inputs = [self.GetInputDataObject(0, i) for i in range(self.GetNumberOfInputConnections(0))]
loops = inputs[0]
cells = dataset_adapter.WrapDataObject(loops).CellData
result = self.GetOutputDataObject(0)
rows = dataset_adapter.WrapDataObject(result).RowData
ids = numpy.array(cells["FeatureId"]) if loops.GetNumberOfCells() else numpy.zeros(0, dtype=int)
if len(ids):
    features, first = numpy.unique(ids, return_index=True)
    column = lambda name: numpy.array(cells[name], dtype=float)
    order = numpy.lexsort((features, column("Radius")[first]))
    features, first = features[order], first[order]

    def texts(name, values):
        array = vtkStringArray()
        array.SetName(name)
        for value in values:
            array.InsertNextValue(value)
        result.GetRowData().AddArray(array)

    names = {(0, 0): "handle", (1, 1): "tunnel", (2, 0): "bottleneck inside", (2, 1): "bottleneck outside"}
    kind, side, trusted = (column(name)[first].astype(int) for name in ("Kind", "Side", "Trusted"))
    texts("Kind", [names.get(each, "loop") for each in zip(kind, side)])
    length = column("Length")
    rows.append(numpy.array([length[ids == feature].max() for feature in features]), "Length (\\u00c5)")
    rows.append(column("Radius")[first], "Radius (\\u00c5)")
    rows.append(column("Uncertainty")[first], "Radius error (\\u00c5)")
    points = {feature: [] for feature in features}
    for cell, feature in enumerate(ids):
        line = loops.GetCell(cell).GetPoints()
        points[feature] += [line.GetPoint(i) for i in range(1, line.GetNumberOfPoints())]  # the last one is the first
    if len(inputs) > 1 and inputs[1].GetNumberOfPoints():
        atoms = inputs[1]
        locator = vtkStaticPointLocator()
        locator.SetDataSet(atoms)
        locator.BuildLocator()
        data = atoms.GetPointData()
        name, chain, code = (data.GetAbstractArray(each) for each in ("ResidueName", "Chain", "InsertionCode"))
        number = data.GetArray("ResidueId")
        found = {feature: set() for feature in features}
        for feature, places in points.items():
            for place in places:
                atom = locator.FindClosestPoint(place)
                found[feature].add((chain.GetValue(atom), int(number.GetTuple1(atom)), code.GetValue(atom) if code else "",
                                    name.GetValue(atom)))
        texts("Residues", ["; ".join(f"{word} {n}{c} {letter}".strip() for letter, n, c, word in sorted(found[feature]))
                           for feature in features])
    resolved = column("Uncertainty")[first] < 0.5 * column("Radius")[first]
    texts("Trusted", ["no" if not exists else "yes" if known else "yes, radius unresolved"
                      for exists, known in zip(trusted, resolved)])
    middle = numpy.round([numpy.mean(points[feature], axis=0) for feature in features], 3) + 0.0
    for axis in range(3):
        rows.append(middle[:, axis].copy(), "XYZ"[axis] + " (\\u00c5)")
    rows.append(features, "FeatureId")
""" + entries.TIDY
HIDDEN_COLUMNS = ["FeatureId", "Row ID"]


def _number(source, name):
    field = source.FieldData[name]
    return int(field.GetRange(0)[0]) if field else None


def words(loops):
    """A text that says how many of the loops are shown; "" without a result, or if it has several blocks."""
    proxy = servermanager._getPyProxy(loops.SMProxy)
    if proxy.GetDataInformation().DataInformation.GetCompositeDataSetType() != -1:
        return ""
    shown, found, untrusted = (_number(proxy, name) for name in (
        "NumberOfShownFeatures", "NumberOfFeatures", "NumberOfUntrustedFeatures"))
    if shown is None or found is None:
        return ""
    if not found:
        lines = ["No choking loops", f"Try {_advice(proxy)}"]
    else:
        lines = [f"{shown} of {found} loops shown" if only_of(proxy) is None else f"the selected ones of {found} loops shown"]
        if untrusted and proxy.TrustedOnly:
            lines[0] += f", {untrusted} not trusted"
        if not shown:
            lines.append(f"Try {'Trusted Only off' if untrusted and proxy.TrustedOnly else _advice(proxy)}")
    gain = _gain_of_denoising(proxy)
    if gain is not None:
        lines.append(f"map denoised first, estimated gain {gain:.1f} dB")
    return "\n".join(lines)


def _advice(loops):
    """What the user can change to get loops if there are none."""
    found = [words for words, helps in (
        ("both sides", loops.Side != "Both"),
        ("all kinds", not (loops.IncludeHandles and loops.IncludeTunnels and loops.IncludeBottlenecks)),
        ("a lower Minimum Persistence", loops.ThresholdMode == "Given" and loops.MinimumPersistence > 0.0),
        ("a larger Maximum Radius", loops.SMProxy.GetGlobalID() not in _largest and (
            loops.RadiusUnit != "Percent" or loops.MaximumRadius < 100.0)),
        ("a larger Maximum Length", loops.MaximumLength > 0.0),
        ("a larger Maximum Reach", loops.MaximumReach > 0.0),
        ("another level of the map", loops.Input.SMProxy.GetXMLName() in steps.LEVELLED)) if helps]
    words = " or ".join(filter(None, [", ".join(found[:-1]), *found[-1:]])) or "a surface with narrow places"
    return words + " (the gear above the panel shows it)" * any(name in words for name in ADVANCED)


def _gain_of_denoising(loops):
    """The estimated gain of the Denoise Map upstream; None if there is none."""
    proxy = loops.SMProxy
    while proxy is not None and proxy.GetNumberOfProducers():
        proxy = proxy.GetProducerProxy(0)
        if proxy.GetXMLName() == "DenoiseMap":
            gain = servermanager._getPyProxy(proxy).FieldData["EstimatedGain"]
            return gain.GetRange(0)[0] if gain else None
    return None


def registered_name(proxy):
    """The name in the pipeline browser; "" for a source that is not registered."""
    names = [name for (name, _), known in simple.GetSources().items() if known.SMProxy == proxy.SMProxy]
    return names[0] if names else ""


_largest = {}  # MaximumRadius of loops as set here, by their global id


def show_radius(loops):
    """Sets the maximum radius in angstrom to the largest that any loop can have, unless the user has set another one: the
    slider then starts at its maximum."""
    number, limit = loops.SMProxy.GetGlobalID(), loops.FieldData["ReferenceLength"]
    if limit is None or (number in _largest and loops.MaximumRadius != _largest[number]):
        return
    largest = math.ceil(10.0 * limit.GetRange(0)[1]) / 10.0
    if number not in _largest or largest != _largest[number]:
        _largest[number] = loops.MaximumRadius = largest
        loops.RadiusUnit = "Angstrom"
        loops.UpdatePipeline()


def count(loops, view):
    """Creates or updates the text in the view that says how many loops are shown, and hides it together with the
    loops. Returns whether anything has changed."""
    loops = servermanager._getPyProxy(loops.SMProxy)
    if loops.SMProxy.GetGlobalID() in _largest:
        show_radius(loops)
    name = registered_name(loops)
    if not name or not hasattr(view, "HiddenLineRemoval"):  # no render view
        return False
    text = simple.FindSource(name + COUNT)
    said = words(loops)
    if text is None:
        if not said:
            return False
        text = entries.make("Text", None, name + COUNT, Text=said)
        _place(simple.Show(text, view))
        return True
    has_changed = text.Text != said
    if has_changed:
        text.Text = said
    visible = view in views_of(loops)
    shown = simple.GetRepresentation(text, view)
    if bool(shown.Visibility) != (visible and bool(said)):
        shown.Visibility = int(visible and bool(said))
        return True
    return has_changed


def _place(display):
    """Places the text in the upper left corner, so that it is complete in flat views and with large letters."""
    display.WindowLocation = "Upper Left Corner" if "Upper Left Corner" in display.GetProperty(
        "WindowLocation").Available else "UpperLeftCorner"
    display.FontSize, display.Justification = 14, "Left"


def mark_stale(depends):
    """Replaces the texts of those loops for which `depends` is true by a note that they wait for a new level."""
    for (name, _), text in list(simple.GetSources().items()):
        loops = simple.FindSource(name[:-len(COUNT)]) if name.endswith(COUNT) else None
        if loops is not None and text.SMProxy.GetXMLName() == "TextSource" and depends(loops.SMProxy):
            text.Text = STALE


def forget():
    """Deletes the texts of loops that have been deleted."""
    names = {name for name, _ in simple.GetSources()}
    for (name, _), text in list(simple.GetSources().items()):
        if name.endswith(COUNT) and text.SMProxy.GetXMLName() == "TextSource" and (
                name[:-len(COUNT)] not in names):
            simple.Delete(text)


# ---------------------------------------------------------------------------- the table

def tables_of(loops):
    """The filters that make tables of these loops."""
    return [proxy for proxy in list(simple.GetSources().values()) if proxy.SMProxy.GetXMLName() == "ProgrammableFilter" and
            proxy.Script == SCRIPT and proxy.SMProxy.GetNumberOfProducers() and
            proxy.SMProxy.GetProducerProxy(0) == loops.SMProxy]


def table_of(loops):
    """The filter that makes the table of these loops: kind, length, radius and its error (angstrom), trusted, position, and
    the residues around each where the surface was made of atoms."""
    known = tables_of(loops)
    if known:
        return known[0]
    atoms = _atoms_of(loops)
    table = entries.make(
        "ProgrammableFilter", [simple.OutputPort(loops, 0), *([atoms] if atoms is not None else [])],
        pockets_and_pores.name_of(loops, "table of loops"), OutputDataSetType="vtkTable", Script=SCRIPT)
    table.UpdatePipeline()
    return table


def _atoms_of(loops):
    """The atoms, with residues, of which the surface was made; None if it was not made of atoms."""
    proxy = loops.SMProxy
    while proxy.GetNumberOfProducers():
        proxy = proxy.GetProducerProxy(0)
        source = servermanager._getPyProxy(proxy)
        if proxy.IsA("vtkSMSourceProxy") and source.PointData["ResidueId"] is not None:
            return source
    return None


def show_table(loops, beside=None):
    """Opens the table of the loops below a view; does nothing if there are no loops."""
    table = table_of(loops)
    if not table.GetDataInformation().DataInformation.GetNumberOfRows():
        simple.Delete(table)
        return None
    sheet = pockets_and_pores.new_view("SpreadSheetView", beside or simple.GetActiveView(), "below", 0.7)
    sheet.HiddenColumnLabels = HIDDEN_COLUMNS
    simple.Show(table, sheet, "SpreadSheetRepresentation")
    return sheet


def zoom(loops, cells):
    """Points the camera at some of the loops, in each view that shows them."""
    if not cells:
        return
    lines = servermanager.Fetch(simple.OutputPort(loops, 0), 0, 0)
    boxes = [lines.GetCell(cell).GetBounds() for cell in cells]
    bounds = []
    for axis in range(3):
        low, high = min(box[2 * axis] for box in boxes), max(box[2 * axis + 1] for box in boxes)
        reach = 0.5 * CONTEXT * (high - low)
        bounds += [0.5 * (low + high) - reach, 0.5 * (low + high) + reach]
    whole = loops.Input.GetDataInformation().GetBounds()
    if math.dist(bounds[::2], bounds[1::2]) > math.dist(whole[::2], whole[1::2]):
        bounds = whole
    for view in views_of(loops):
        view.SMProxy.ResetCamera(*bounds)


def views_of(loops):
    """The render views that show the loops, or only the selected ones."""
    only = only_of(loops)
    shown = [loops.SMProxy] if only is None else [loops.SMProxy, only.SMProxy]
    return [view for view in simple.GetViews() if hasattr(view, "HiddenLineRemoval") and any(
        display.Visibility and getattr(getattr(display, "Input", None), "SMProxy", None) in shown and
        getattr(display.Input, "Port", 0) == 0 for display in view.Representations if hasattr(display, "Visibility"))]


# ---------------------------------------------------------------------------- only the selected loops

def only_of(loops):
    """The filter that extracts the selected loops; None while all are shown."""
    for proxy in simple.GetSources().values():
        given = getattr(proxy, "Input", None) if proxy.SMProxy.GetXMLName() == "ExtractSelection" else None
        if given is not None and given.SMProxy == loops.SMProxy and given.Port == 0:
            return proxy
    return None


def look(display, view):
    """Loops as tubes, coloured by kind."""
    display.RenderLinesAsTubes, display.LineWidth = 1, 5.0
    if colours.colour_by(display, "CELLS", "Kind"):
        display.SetScalarBarVisibility(view, True)


def show_only(loops, cells):
    """Shows only these loops; the surface stays visible. cells: ids of their cells (lines)."""
    only = only_of(loops)
    if only is not None:
        only.Selection = selections.of_ids("CELL", cells)
        only.UpdatePipeline()
        return
    views = views_of(loops)
    only = entries.make("ExtractSelection", simple.OutputPort(loops, 0), pockets_and_pores.name_of(loops, "selected loops"),
                        hidden=False, Selection=selections.of_ids("CELL", cells))
    for view in views:
        simple.Hide(loops, view)
        look(simple.Show(only, view), view)


def show_all(loops):
    """Shows all loops again."""
    only = only_of(loops)
    for view in views_of(loops) if only is not None else ():
        simple.Show(loops, view)
    if only is not None:
        simple.Delete(only)
