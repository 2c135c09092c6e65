"""Persistence diagrams as charts, with linked selections in chart and view.

    from isthmus import diagram_views             # or: from isthmus_plugin, with the plugin loaded
    chart = diagram_views.show(loops)             # a chart view beside the active view

Births are across, deaths upwards; features far above the diagonal are persistent. Colours are kinds, symbols are sides
of the surface (discs inside, diamonds outside), the line is the persistence threshold. A loop that is selected in the
chart, in the view or in the table of loops is selected in all of them, and the ball of its choke point and its radius are
shown.
"""

import importlib
import sys
from importlib.machinery import ModuleSpec

try:
    from paraview import servermanager, simple
except ImportError:
    servermanager = simple = None  # with pip's vtk alone, isthmus.pipelines can still be imported

from . import entries, loop_views, messages, selections
from . import pocket_views as pockets_and_pores

DIAGRAMS = {"ChokingLoops": 3, "ScalarPersistence": 1}  # filter and port of its diagram
CELL, ROW = 1, 6  # of vtkDataObject's attribute types
# Pixels: width of a chart's legend, height of each of its rows, and space that the axes and the title of a chart need.
LEGEND_WIDTH, ROW_HEIGHT, LEFT_SPACE, BELOW_SPACE = 145, 18, 75, 90
DISC, DIAMOND = "4", "5"  # marker styles of a chart
# Pixels. ParaView 5.13 draws the loop itself, 5 pixels wide, over its selection.
SELECTED_WIDTH = 15.0 if servermanager and servermanager.vtkSMProxyManager.GetVersionMinor() == 13 else 9.0
VERMILION, ORANGE, GREEN, BLUE, GREY = (
    (0.835, 0.369, 0.0), (0.902, 0.624, 0.0), (0.0, 0.620, 0.451), (0.0, 0.447, 0.698), (0.72, 0.72, 0.72))
# Series of the chart: label, the values of these columns, symbol, colour, size.
LOOPS = (
    ("no loop, inside", {"Kind": 3, "Side": 0}, DISC, GREY, 4),
    ("no loop, outside", {"Kind": 3, "Side": 1}, DIAMOND, GREY, 5),
    ("handle (inside)", {"Kind": 0}, DISC, VERMILION, 9),
    ("tunnel (outside)", {"Kind": 1}, DIAMOND, BLUE, 10),
    ("bottleneck inside", {"Kind": 2, "Side": 0}, DISC, ORANGE, 8),
    ("bottleneck outside", {"Kind": 2, "Side": 1}, DIAMOND, ORANGE, 9))
CLASSES = (
    ("component", {"Dimension": 0}, DISC, VERMILION, 7),
    ("tunnel", {"Dimension": 1}, DIAMOND, BLUE, 8),
    ("cavity", {"Dimension": 2}, "3", GREEN, 7))
DIAGONAL = "birth = death"
# Executed where the data is: the diagram with a column of deaths for each series and each line, which a chart takes
# for a series.
SCRIPT = """import numpy
from vtkmodules.numpy_interface import dataset_adapter

table = dataset_adapter.WrapDataObject(self.GetInputDataObject(0, 0))
result = dataset_adapter.WrapDataObject(self.GetOutputDataObject(0))
result.VTKObject.ShallowCopy(table.VTKObject)
rows = table.RowData
birth, death = numpy.array(rows["Birth"], dtype=float), numpy.array(rows[DEATH], dtype=float)
for label, values in SERIES:
    chosen = numpy.ones(len(birth), dtype=bool)
    for column, value in values.items():
        chosen &= numpy.asarray(rows[column]) == value
    result.RowData.append(numpy.where(chosen, death, numpy.nan), label)
for label, threshold in LINES:
    if threshold is None:  # the least persistent of those that are listed
        threshold = (death - birth)[numpy.argmin(abs(death - birth))] if len(birth) else 0.0
    result.RowData.append(birth + threshold, label)
""" + entries.TIDY


class _ScriptColours:
    """Provides a substitute for the module below if it is not installed. ParaView 5.11 to 6.0 import it for the panel of every filter
    with a script, such as the chart's, and do not clear the error if that fails. With Python 3.12 or later the next
    import then fails, too, and ParaView crashes (Debian 13, with or without Isthmus)."""

    MODULE = "pygments.formatters.redtabhtml"

    @classmethod
    def find_spec(cls, name, path=None, target=None):
        return ModuleSpec(name, cls) if name == cls.MODULE else None

    @staticmethod
    def create_module(spec):
        return None

    @staticmethod
    def exec_module(module):
        module.RedTabHtmlFormatter = importlib.import_module("pygments.formatters").HtmlFormatter


if simple and not any(getattr(finder, "MODULE", None) == _ScriptColours.MODULE for finder in sys.meta_path):
    sys.meta_path.append(_ScriptColours)  # the last one


def show(source):
    """The persistence diagram of Choking Loops or Scalar Persistence in a chart view beside the
    active view, which is returned."""
    name = source.SMProxy.GetXMLName()
    if name not in DIAGRAMS:
        raise ValueError("Choking Loops and Scalar Persistence have a persistence diagram: select one in "
                         "the pipeline browser.")
    table = simple.OutputPort(source, DIAGRAMS[name])
    table.UpdatePipeline()
    rows = table.GetDataInformation().GetAttributeInformation(ROW)
    if not rows.GetArrayInformation("Birth"):
        raise ValueError("The persistence diagram is empty: the filter's messages say why.")
    if not table.GetDataInformation().DataInformation.GetNumberOfRows():
        raise ValueError("There is no persistence diagram: nothing becomes narrower or connects here, as on a sphere.")
    selected = simple.GetActiveSource()
    plot = _plot_of(source, table)
    simple.SetActiveSource(selected)
    view = simple.GetActiveView()
    layout = simple.GetLayout(view) if view else None
    chart = simple.CreateView("XYChartView")
    pockets_and_pores.own_views.add(chart.SMProxy.GetGlobalID())
    if layout:
        layout.SplitViewHorizontal(view, 0.6)
        simple.AssignViewToLayout(view=chart, layout=layout)
    _draw(source, plot, chart)
    simple.Render(chart)
    if view:
        simple.SetActiveView(view)
    return chart


def _series_of(source):
    """The series that the diagram has rows for."""
    name = source.SMProxy.GetXMLName()
    rows = servermanager.Fetch(source, idx=DIAGRAMS[name]).GetRowData()
    listed = CLASSES if name == "ScalarPersistence" else LOOPS
    columns = {column: rows.GetArray(column) for _, values, *_ in listed for column in values}
    there = {tuple(int(array.GetTuple1(i)) for array in columns.values()) for i in range(rows.GetNumberOfTuples())}

    def has_rows(values):
        return any(all(row[place] == values.get(column, row[place]) for place, column in enumerate(columns))
                   for row in there)
    return [each for each in listed if has_rows(each[1])]


def thresholds(source):
    """The lines of persistence above which features are reported: (label, death - birth). None instead of a number: that
    of the least persistent feature in the diagram."""
    if source.SMProxy.GetXMLName() == "ScalarPersistence":
        if source.PersistenceUnit == "Values":
            least = float(source.MinimumPersistence)
            return [("threshold", -least if source.Superlevel else least)] if least > 0.0 else []
        return [("weakest feature listed", None)]
    found = []
    fields = servermanager.Fetch(simple.OutputPort(source, 0), 0, 0).GetFieldData()
    proposed, reference = fields.GetArray("ProposedThreshold"), fields.GetArray("ReferenceLength")
    for side, words in enumerate(("inside", "outside")):
        if source.Side not in (words.capitalize(), "Both"):
            continue
        if source.ThresholdMode == "Largest gap":
            value = proposed.GetTuple(side)[0] if proposed else 0.0
        elif source.PersistenceUnit == "Percent":
            value = 0.01 * source.MinimumPersistence * reference.GetValue(side) if reference else 0.0
        else:
            value = float(source.MinimumPersistence)
        if value > 0.0:
            found.append((f"threshold {words}", value))
    if len(found) == 2 and found[0][1] == found[1][1]:
        found = [("threshold", found[0][1])]
    return found


def _script(source):
    series = [(label, values) for label, values, *_ in _series_of(source)]
    death = "DeathShown" if source.SMProxy.GetXMLName() == "ScalarPersistence" else "Death"
    return (f"DEATH = {death!r}\nSERIES = {series!r}\n"
            f"LINES = {thresholds(source)!r}\n{SCRIPT}")


def _plots():
    """The filters that make charts of diagrams, each with the proxy of its input, or None."""
    for proxy in list(simple.GetSources().values()):
        if proxy.SMProxy.GetXMLName() == "ProgrammableFilter" and str(proxy.Script).startswith("DEATH = "):
            yield proxy, proxy.SMProxy.GetProducerProxy(0) if proxy.SMProxy.GetNumberOfProducers() else None


def plots_of(source):
    """The filters that make charts of the diagrams of `source`."""
    return [plot for plot, shown in _plots() if shown == source.SMProxy]


def forget():
    """Deletes the plots whose filter was deleted: ParaView gives them the input of that filter instead."""
    for plot, shown in _plots():
        if shown is None or shown.GetXMLName() not in DIAGRAMS:
            simple.Delete(plot)


def _plot_of(source, table):
    known = plots_of(source)
    plot = known[0] if known else simple.ProgrammableFilter(
        table, registrationName=pockets_and_pores.name_of(source, "persistence diagram"), OutputDataSetType="vtkTable")
    plot.Script = _script(source)
    plot.UpdatePipeline()
    return plot


def _draw(source, plot, chart):
    rows = plot.GetDataInformation().DataInformation.GetAttributeInformation(ROW)
    names = [rows.GetArrayInformation(i).GetName() for i in range(rows.GetNumberOfArrays())]
    series = [each for each in _series_of(source) if each[0] in names]
    lines = [label for label, _ in thresholds(source) if label in names]
    points = simple.Show(plot, chart, "XYChartRepresentation")
    points.AttributeType = "Row Data"
    points.UseIndexForXAxis, points.XArrayName = 0, "Birth"
    has_lines = plot.GetDataInformation().DataInformation.GetNumberOfRows() > 1  # a chart draws none through one point
    drawn = [*(("Birth", *lines) if has_lines else ()), *(label for label, *_ in series)]
    points.SeriesVisibility = drawn
    styles = {"Birth": ("1", "0", "4", GREY, "1"), **{
                  label: ("1", "0", "4", (0.45, 0.45, 0.45) if "outside" in label else (0.0, 0.0, 0.0), "2") for label in lines},
              **{label: ("0", symbol, str(size), colour, "1") for label, _, symbol, colour, size in series}}
    for place, name in enumerate(("SeriesLineStyle", "SeriesMarkerStyle", "SeriesMarkerSize")):
        setattr(points, name, [word for label in drawn for word in (label, styles[label][place])])
    points.SeriesLineThickness = [word for label in drawn for word in (label, styles[label][4])]
    points.SeriesColor = [word for label in drawn for word in (label, *map(str, styles[label][3]))]
    points.SeriesLabel = [word for label in drawn for word in (label, DIAGONAL if label == "Birth" else label)]
    of_map = source.SMProxy.GetXMLName() == "ScalarPersistence"
    unit = "level, unit of the map" if of_map else "radius, Å"
    chart.ChartTitle, chart.BottomAxisTitle, chart.LeftAxisTitle = (
        "Persistence diagram", f"Birth ({unit})", f"Death ({unit})")
    for axis, columns in (("Bottom", ("Birth",)), ("Left", ("Birth", "DeathShown" if of_map else "Death"))):
        _set_range(chart, axis, [rows.GetArrayInformation(column).GetComponentFiniteRange(0) for column in columns])
    superlevel = of_map and int(source.Superlevel)
    chart.LegendLocation = "TopLeft" if superlevel else "BottomRight"  # the empty half
    _make_room(chart, len(drawn), superlevel)


def _make_room(chart, rows, superlevel):
    """Extends the axis of deaths until a legend with that many rows, in the corner beyond the diagonal, does not reach
    the diagonal."""
    low, high, left, right = (getattr(chart, f"{axis}AxisRange{end}") for axis in ("Left", "Bottom")
                              for end in ("Minimum", "Maximum"))
    across, up = chart.ViewSize
    width = min(LEGEND_WIDTH / max(1, across - LEFT_SPACE), 0.6)
    share = min((ROW_HEIGHT * rows + 8) / max(1, up - BELOW_SPACE), 0.5)
    if superlevel:
        corner = left + width * (right - left)
        chart.LeftAxisRangeMaximum = max(high, low + (corner - low) / (1.0 - share))
    else:
        corner = right - width * (right - left)
        chart.LeftAxisRangeMinimum = min(low, (corner - share * high) / (1.0 - share))


def _set_range(chart, axis, ranges):
    """Slightly larger than the ranges, so that no symbol at the border is cut."""
    low, high = min(low for low, _ in ranges), max(high for _, high in ranges)
    if high > low:
        margin = 0.04 * (high - low)
        setattr(chart, f"{axis}AxisUseCustomRange", 1)
        setattr(chart, f"{axis}AxisRangeMinimum", low - margin)
        setattr(chart, f"{axis}AxisRangeMaximum", high + margin)


@messages.reports_faults("The threshold in the persistence diagram")
def follow_threshold(source):
    """Moves the lines of the charts of `source`, whose result has changed, and selects its loops again."""
    for plot in plots_of(source):
        script = _script(source)
        if script != plot.Script:
            plot.Script = script
            plot.UpdatePipeline()
            for view in simple.GetViews():
                if any(getattr(display, "Input", None) == plot for display in view.Representations):
                    _draw(source, plot, view)
                    view.SMProxy.StillRender()
    tables = loop_views.tables_of(source)
    if source.SMProxy.GetXMLName() in loop_views.LOOPS and (tables or plots_of(source)):
        # The chart has all features, so that its rows stay the same.
        ids = [number for plot in plots_of(source) for number in _selected_ids(plot)]
        _select_loops(source, ids)
        for table in tables:
            _select(table, "ROW", _places(servermanager.Fetch(table), ROW, ids))
        loop_views.show_all(source)
        _show_balls(source, _selected_ids(source))


# ---------------------------------------------------------------------------- one selection in chart, table and view

@messages.reports_faults("The selection of a loop")
def selection_changed(number):
    """Called by the window with the global id of the source whose selection was changed by the user or by this module;
    0: nothing is selected. The loops of Choking Loops, the charts of their diagram and their table share one selection."""
    for source in list(simple.GetSources().values()):
        if source.SMProxy.GetXMLName() in loop_views.LOOPS:
            _share_selection(source, number)


def _share_selection(source, number):
    tables = loop_views.tables_of(source)
    members = [source, *plots_of(source), *tables]
    selected = [_selected_ids(member) for member in members]
    changed = [i for i, member in enumerate(members) if member.SMProxy.GetGlobalID() == number]
    if len(members) == 1 or not changed and not any(selected):
        return
    wanted = selected[changed[0]] if changed else []
    for i, member in enumerate(members):
        if i not in changed and _with_rows(member, wanted) != selected[i]:
            _select_loops(source, wanted) if member is source else _select(
                member, "ROW", _places(servermanager.Fetch(member), ROW, wanted))
    shown = _selected_ids(source)
    if shown and changed:
        cells = cells_of(source, shown)
        if loop_views.only_of(source) is not None:
            loop_views.show_only(source, cells)
        if members[changed[0]] in tables:
            loop_views.zoom(source, cells)
    _show_balls(source, shown)
    simple.RenderAllViews()


def _with_rows(member, ids):
    """The features for which a member has a row or a loop."""
    if not ids:
        return []
    data = servermanager.Fetch(simple.OutputPort(member, 0), 0, 0)
    arrays = [data.GetAttributes(kind).GetArray("FeatureId") for kind in (CELL, ROW) if data.GetAttributes(kind)]
    there = {int(array.GetTuple1(i)) for array in arrays if array for i in range(array.GetNumberOfTuples())}
    return [number for number in ids if number in there]


def cells_of(source, ids):
    """The cells (lines) of features in the first output of Choking Loops."""
    return _places(servermanager.Fetch(simple.OutputPort(source, 0), 0, 0), CELL, ids)


@messages.reports_faults("Showing some of the loops")
def show_loops(selected):
    """Shows only the selected loops, or all of them again, for each Choking Loops filter visible in a view."""
    found = False
    for source in list(simple.GetSources().values()):
        if source.SMProxy.GetXMLName() not in loop_views.LOOPS or not loop_views.views_of(source):
            continue
        ids = _selected_ids(source)
        if selected and ids:
            loop_views.show_only(source, cells_of(source, ids))
        elif not selected:
            loop_views.show_all(source)
        found = found or bool(ids) or not selected
        for view in loop_views.views_of(source):
            loop_views.count(source, view)
    if not found:
        messages.show_note("Select loops first: click rows of their table, or press S over the view and drag a rectangle.")
    simple.RenderAllViews()


def _select_loops(source, ids):
    _select(source, "CELL", cells_of(source, ids))
    for view in simple.GetViews():
        for display in view.Representations:
            if hasattr(display, "SelectionLineWidth") and getattr(
                    getattr(display, "Input", None), "SMProxy", None) == source.SMProxy:
                display.SelectionLineWidth = SELECTED_WIDTH


def _selected_ids(source):
    """The selected FeatureIds in the first output of `source`."""
    if source.SMProxy.GetSelectionInput(0) is None:
        return []
    part = servermanager._getPyProxy(source.SMProxy.GetSelectionOutput(0))
    part.UpdatePipeline()
    data = servermanager.Fetch(part)
    found = set()
    for kind in (CELL, ROW):
        attributes = data.GetAttributes(kind) if data is not None else None
        array = attributes.GetArray("FeatureId") if attributes else None
        found.update(int(array.GetTuple1(i)) for i in range(array.GetNumberOfTuples())) if array else None
    return sorted(found)


def _places(data, kind, ids):
    """The rows, cells or points that have one of the FeatureIds."""
    attributes = data.GetAttributes(kind) if data is not None and ids else None
    array = attributes.GetArray("FeatureId") if attributes else None
    wanted = set(ids)
    return [i for i in range(array.GetNumberOfTuples()) if int(array.GetTuple1(i)) in wanted] if array else []


def _select(source, kind, places):
    """Selects these rows or cells of the first output, as the window would."""
    if not places:
        if source.SMProxy.GetSelectionInput(0) is not None:
            selections.select(source, 0, None)
        return
    selections.select(source, 0, selections.of_ids(kind, places))


def balls_of(source):
    """The filter that passes the choke points of the loops that are selected; None before the first."""
    for proxy in simple.GetSources().values():
        given = getattr(proxy, "Input", None) if proxy.SMProxy.GetXMLName() == "ExtractSelection" else None
        if given is not None and given.SMProxy == source.SMProxy and given.Port == loop_views.CHOKE_POINTS:
            return proxy
    return None


def _show_balls(source, ids):
    """The balls that get stuck in the selected loops, in the views that show the loops."""
    balls = balls_of(source)
    places = _places(servermanager.Fetch(source, idx=loop_views.CHOKE_POINTS), 0, ids)
    if balls is None:
        if not places:
            return
        balls = entries.make(
            "ExtractSelection", simple.OutputPort(source, loop_views.CHOKE_POINTS),
            pockets_and_pores.name_of(source, "selected balls"), Selection=selections.of_ids("POINT", []))
    balls.Selection = selections.of_ids("POINT", places)
    balls.UpdatePipeline()
    for view in loop_views.views_of(source):
        if not [display for display in view.Representations if getattr(display, "Input", None) == balls]:
            _ball_display(balls, view)
            pockets_and_pores.show_labels(balls, view, "Radius", 2)
        for display in view.Representations:
            if getattr(display, "Input", None) == balls:
                display.Visibility = int(bool(places))


def _ball_display(balls, view):
    display = simple.Show(balls, view)
    pockets_and_pores.show_balls(display)
    return display
