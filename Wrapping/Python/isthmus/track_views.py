"""Choking loops along a trajectory: the radius of each one over time as a chart, and where it moves.

    from isthmus import pipelines, track_views    # or: from isthmus_plugin, with the plugin loaded
    loops, tracks = pipelines.trajectory_to_loops(OpenDataFile("moving.xtc"))
    chart = track_views.show_chart(tracks)
    for name, times, radii in track_views.series_of(tracks):
        print(name, min(radii))

A loop keeps its track from frame to frame (Feature Tracks). The chart has a line for each track that lasts longest; the
view has the path of its choke point in the same colour.
"""

import importlib

try:
    from paraview import servermanager, simple
except ImportError:
    servermanager = simple = None  # with pip's vtk alone, isthmus.pipelines can still be imported

from . import colours, messages
from . import pocket_views as pockets_and_pores

CHARTED = 8  # tracks at most in the chart
CHART, PATHS = 1, 2  # ports of Feature Tracks
# The colours of Okabe and Ito, suitable for colour-blind readers, and one for all further tracks.
COLOURS = ((0.0, 0.447, 0.698), (0.835, 0.369, 0.0), (0.0, 0.620, 0.451), (0.902, 0.624, 0.0), (0.800, 0.475, 0.655),
           (0.337, 0.706, 0.914), (0.0, 0.0, 0.0), (0.55, 0.45, 0.10))
FURTHER = (0.70, 0.70, 0.70)
KINDS = {(0, 0): "handle", (1, 1): "tunnel", (2, 0): "bottleneck inside", (2, 1): "bottleneck outside"}
AXES = {"TrajectoryReader": "Time (ps)", "MacromoleculeReader": "Model (the first is 0)"}


def times_of(source):
    """The time steps of a source; empty if it has none."""
    values = source.SMProxy.GetProperty("TimestepValues")
    if values is None:
        reader = _root(source)
        reader.UpdatePipelineInformation()
        values = reader.SMProxy.GetProperty("TimestepValues")
    else:
        source.UpdatePipelineInformation()
    if values is None:
        return []
    return [values.GetElement(i) for i in range(values.GetNumberOfElements())]


def _root(source):
    """The reader, or else the first source, from which the data come."""
    proxy = source.SMProxy
    while proxy.GetNumberOfProducers():
        proxy = proxy.GetProducerProxy(0)
    return servermanager._getPyProxy(proxy)


def report_frames(tracks, count):
    """Reports each frame to the window while `tracks` processes them."""
    try:
        # Python cannot instantiate a class that it has first seen as an object of C++.
        importlib.import_module("isthmus.vtkIsthmusFiltersPockets")
    except ImportError:
        pass  # ParaView without the package
    algorithm = tracks.GetClientSideObject()  # None with a server elsewhere
    if algorithm is None:
        return

    def frame(*_):
        done = min(count, round(algorithm.GetProgress() / 0.9 * count))
        if done < count:
            messages.is_cancelled(f"frame {done + 1} of {count}")

    messages.is_cancelled(f"frame 1 of {count}")
    algorithm.AddObserver("ProgressEvent", frame)


def series_of(tracks):
    """[(name, times, radii)] of the tracks that last longest, those with most frames first. Names are a kind and the
    number of the track, such as "tunnel 3"; radii are in angstrom, NaN in frames without the loop."""
    chart = servermanager.Fetch(tracks, idx=CHART)
    names = _names(tracks)
    columns = [chart.GetColumn(i) for i in range(chart.GetNumberOfColumns())]
    times = [columns[0].GetTuple1(row) for row in range(chart.GetNumberOfRows())] if columns else []
    return [(names.get(column.GetName(), column.GetName()), times, [column.GetTuple1(row) for row in range(len(times))])
            for column in columns[1:1 + CHARTED]]


def _names(tracks):
    """{column of the chart: name of the track}"""
    table = servermanager.Fetch(tracks, idx=0)
    number, kind, side = (table.GetColumnByName(name) for name in ("Track", "Kind", "Side"))
    if kind is None:
        return {}
    return {f"Track {int(number.GetTuple1(row))}":
            f"{KINDS.get((int(kind.GetTuple1(row)), int(side.GetTuple1(row))), 'loop')} {int(number.GetTuple1(row))}"
            for row in range(table.GetNumberOfRows())}


def _charted(tracks):
    """[(column, name, colour)] of the tracks in the chart."""
    chart = tracks.SMProxy.GetDataInformation(CHART).GetAttributeInformation(6)  # vtkDataObject.ROW
    found = {chart.GetArrayInformation(i).GetName() for i in range(chart.GetNumberOfArrays())}
    names = _names(tracks)
    fetched = servermanager.Fetch(tracks, idx=CHART)
    ordered = [fetched.GetColumnName(i) for i in range(1, fetched.GetNumberOfColumns())]
    return [(column, names.get(column, column), colour)
            for column, colour in zip([each for each in ordered if each in found], COLOURS)]


def show_chart(tracks, beside=None):
    """Opens the chart of the radius of each loop over time; `beside`: to the right of that view. Returns the chart."""
    rows = _charted(tracks)
    if beside is not None:
        chart = pockets_and_pores.new_view("XYChartView", beside, "right", 0.55)
    else:
        chart = simple.CreateView("XYChartView")
    lines = simple.Show(simple.OutputPort(tracks, CHART), chart, "XYChartRepresentation")
    lines.AttributeType = "Row Data"
    lines.UseIndexForXAxis, lines.XArrayName = 0, "Time"
    lines.SeriesVisibility = [column for column, *_ in rows]
    lines.SeriesLabel = [word for column, name, _ in rows for word in (column, name)]
    lines.SeriesColor = [word for column, _, colour in rows for word in (column, *map(str, colour))]
    for name, value in (("SeriesLineThickness", "2"), ("SeriesMarkerStyle", "4"), ("SeriesMarkerSize", "6")):
        setattr(lines, name, [word for column, *_ in rows for word in (column, value)])
    axis = AXES.get(_root(tracks).SMProxy.GetXMLName(), "Time")
    chart.ChartTitle, chart.BottomAxisTitle, chart.LeftAxisTitle = "Radius of choking loops", axis, "Radius (Å)"
    _make_room(tracks, chart)
    simple.Render(chart)
    return chart


def _make_room(tracks, chart):
    """Axes with a margin, and with room for the legend above the lines."""
    series = series_of(tracks)
    times = series[0][1] if series else []
    radii = [radius for _, _, values in series for radius in values if radius == radius]
    if not radii:
        return
    # The legend's rows are about 4 % of the height of a chart each.
    top = max(radii) * (1.05 + 0.06 * len(series))
    span = (times[-1] - times[0]) or 1.0
    for axis, low, high in (("Bottom", times[0] - 0.03 * span, times[-1] + 0.03 * span), ("Left", 0.0, top)):
        setattr(chart, f"{axis}AxisUseCustomRange", 1)
        setattr(chart, f"{axis}AxisRangeMinimum", low)
        setattr(chart, f"{axis}AxisRangeMaximum", high)
    chart.LegendLocation = "TopRight"


def show(loops, tracks, view, beside=False):
    """Shows the paths of the choke points beside the loops, in the colours of the chart, which beside=True opens."""
    display = simple.Show(simple.OutputPort(tracks, PATHS), view)
    display.SetRepresentationType("Surface")
    display.RenderLinesAsTubes, display.LineWidth = 1, 4.0
    if colours.colour_by(display, "POINTS", "Track"):
        table = display.LookupTable
        colours.set_categories(table, [(column.split()[-1], name, colour) for column, name, colour in _charted(tracks)])
        table.NanColor = FURTHER
        colours.legend(table, view, "Paths of loops")
        display.SetScalarBarVisibility(view, True)
    if beside:
        show_chart(tracks, view)
        simple.SetActiveView(view)
    return display
