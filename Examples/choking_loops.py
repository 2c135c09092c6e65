"""The picture of Fig. 6.1 of the thesis for any closed surface: translucent surface, handles and
tunnels in red, additional loops in yellow, choke points as spheres, persistence diagram beside it.

Usage: pvpython choking_loops.py SURFACE [PICTURE] [RADIUS_PERCENT PERSISTENCE_PERCENT [SIDE]]
SURFACE: .obj, .stl, .ply, .vtp or .off. PICTURE: a path; default: choking_loops.png in a temporary
folder. The loops (.vtp) and their numbers (.txt) are written beside it. The numbers and paths are
printed to standard output, the steps to standard error.
SIDE: Inside, Outside or Both (default).

Other scripts call choking_picture() with any source of a closed surface.
"""

import sys
from pathlib import Path

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkTable

from output_folder import output_folder
from step_lines import step

INK, GREY = (0.10, 0.10, 0.12), (0.66, 0.74, 0.86)
RED, YELLOW, BLUE, PALE = (0.83, 0.09, 0.10), (0.98, 0.74, 0.02), (0.13, 0.38, 0.70), (0.72, 0.72, 0.74)
HANDLE, TUNNEL, ADDITIONAL, NOISE = range(4)
NO_LOOPS = "The surface has no choking loops that could be drawn; see the messages."


def output(proxy, port=0):
    """Fetch() of ParaView 5.11 always returns port 0."""
    return proxy.GetClientSideObject().GetOutputDataObject(port)


def column(attributes, name):
    array = attributes.GetArray(name)
    return vtk_to_numpy(array) if array else numpy.zeros(0)


def numbers_of(loops):
    """The results: counts, facts about the analysis, and one row per loop."""
    data = output(loops)
    loops.UpdatePropertyInformation()
    times = servermanager.vtkSMPropertyHelper(loops.SMProxy, "StageTimes")
    facts = {name: column(data.GetFieldData(), name).tolist() for name in (
        "NumberOfHandles", "NumberOfTunnels", "NumberOfAdditionalLoops", "NumberOfSamples",
        "LargestSamplingError", "ReferenceLength")}
    stages = ("check", "sampling", "filtration", "pairing", "features")
    rows = [column(data.GetCellData(), name).tolist() for name in
            ("FeatureId", "Kind", "Side", "Radius", "Persistence", "Length", "Trusted")]
    return {
        "handles": facts["NumberOfHandles"][0],
        "tunnels": facts["NumberOfTunnels"][0],
        "additional inside": facts["NumberOfAdditionalLoops"][0],
        "additional outside": facts["NumberOfAdditionalLoops"][1],
        "samples": facts["NumberOfSamples"][0],
        "largest sampling error": facts["LargestSamplingError"][0],
        "reference length": dict(zip(("inside", "outside"), facts["ReferenceLength"])),
        "seconds": {name: times.GetAsDouble(stage) for stage, name in enumerate(stages)},
        "loops": [dict(zip(("feature", "kind", "side", "radius", "persistence", "length",
                            "trusted"), row)) for row in zip(*rows)],
    }


def paint(display, colour, opacity=1.0, specular=0.0):
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = display.AmbientColor = colour
    display.Opacity, display.Specular, display.SpecularPower = opacity, specular, 40


def between(port, array, low, high):
    """The part of an output where the array lies in [low, high]. The bounds are set after the array,
    whose range would replace them."""
    part = simple.Threshold(Input=port, Scalars=array)
    part.LowerThreshold, part.UpperThreshold = low, high
    return part


def show_tubes(loops, kinds, colour, radius, view):
    data = output(loops)
    if not numpy.isin(column(data.GetCellData(), "Kind"), kinds).any():
        return
    chosen = between(simple.OutputPort(loops, 0), ["CELLS", "Kind"], min(kinds), max(kinds))
    lines = simple.ExtractSurface(Input=chosen)
    tubes = simple.Tube(Input=lines, Radius=radius, NumberofSides=16, Scalars=["POINTS", ""])
    paint(simple.Show(tubes, view), colour, specular=0.5)


def show_choke_points(loops, view):
    """Spheres of the radius at which they get stuck; they touch the surface on all sides. Spheres outside are
    almost transparent, since they would hide the objects behind them."""
    points = simple.OutputPort(loops, 2)
    for side, opacity in ((0, 1.0), (1, 0.16)):
        data = output(loops, 2)
        if not (column(data.GetPointData(), "Side") == side).any():
            continue
        chosen = between(points, ["POINTS", "Side"], side, side)
        balls = simple.Glyph(Input=chosen, GlyphType="Sphere", GlyphMode="All Points",
                             OrientationArray=["POINTS", "No orientation array"])
        balls.ScaleArray = ["POINTS", "Radius"]
        balls.ScaleFactor = 1.0  # after the array, whose range would set it
        balls.GlyphType.Radius = 1.0
        balls.GlyphType.ThetaResolution = balls.GlyphType.PhiResolution = 32
        paint(simple.Show(balls, view), BLUE, opacity, 0.3)


def table_source(columns):
    table = vtkTable()
    for name, values in columns.items():
        array = vtkDoubleArray()
        array.SetName(name)
        for value in values:
            array.InsertNextValue(float(value))
        table.AddColumn(array)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(table)
    return source


def show_series(view, births, deaths, label, colour, marker=0, size=1, line=0):
    """One series of the diagram. Markers: 4 circle, 5 diamond; lines: 1 solid, 2 dashed."""
    births, deaths = list(births), list(deaths)
    if len(births) == 1:  # VTK complains of lines with one point
        births, deaths = 2 * births, 2 * deaths
    display = simple.Show(table_source({"birth": births, label: deaths}), view,
                          "XYChartRepresentation")
    display.UseIndexForXAxis = 0
    display.XArrayName = "birth"
    display.SeriesVisibility = [label]
    display.SeriesLabel = [label, label]
    display.SeriesColor = [label] + [str(c) for c in colour]
    display.SeriesMarkerStyle = [label, str(marker)]
    display.SeriesMarkerSize = [label, str(size)]
    display.SeriesLineStyle = [label, str(line)]
    display.SeriesLineThickness = [label, "2"]


def show_diagram(loops, view, radius, persistence):
    """Plots birth against death of the features, in percent of the reference length of their side, and the line
    above which additional loops are reported."""
    rows = output(loops, 3).GetRowData()
    kind, side = column(rows, "Kind"), column(rows, "Side")
    reference = numpy.array(column(output(loops).GetFieldData(), "ReferenceLength"))
    unit = 0.01 * numpy.where(reference > 0, reference, numpy.inf)[side]
    birth, death = column(rows, "Birth") / unit, column(rows, "Death") / unit
    shown = column(output(loops).GetCellData(), "FeatureId")
    reported = numpy.isin(numpy.arange(len(kind)), shown)
    voids = (column(rows, "Dimension") == 2) & ~reported & (death <= 100)
    show_series(view, [0, 104], [0, 104], "filled as soon as closed", PALE, line=1)
    show_series(view, [0, min(radius, 104 - persistence)],
                [persistence, min(radius, 104 - persistence) + persistence],
                "threshold: %g %%" % persistence, INK, line=2)
    for chosen, label, colour, marker in (
            (voids, "not reported", PALE, 4),
            (reported & (kind == HANDLE), "handles", RED, 4),
            (reported & (kind == TUNNEL), "tunnels", RED, 5),
            (reported & (kind == ADDITIONAL) & (side == 0), "additional, inside", YELLOW, 4),
            (reported & (kind == ADDITIONAL) & (side == 1), "additional, outside", YELLOW, 5)):
        if chosen.any():
            label = "%s (%d)" % (label, chosen.sum()) if label != "not reported" else label
            show_series(view, birth[chosen], death[chosen], label, colour, marker,
                        6 if colour == PALE else 13)
    for axis in ("Left", "Bottom"):
        setattr(view, f"{axis}AxisUseCustomRange", 1)
        setattr(view, f"{axis}AxisRangeMinimum", -3.0)
        setattr(view, f"{axis}AxisRangeMaximum", 104.0)
        setattr(view, f"{axis}AxisTitleFontSize", 20)
        setattr(view, f"{axis}AxisTitleBold", 0)
        setattr(view, f"{axis}AxisLabelFontSize", 18)
        setattr(view, f"{axis}AxisGridColor", (0.90, 0.90, 0.92))
    view.ChartTitle = "Persistence diagram (% of the largest radius on its side)"
    view.ChartTitleFontSize = 21
    view.BottomAxisTitle = "radius at which the space behind is closed off"
    view.LeftAxisTitle = "radius at which it is filled"
    view.LegendFontSize = 18
    view.LegendLocation = "BottomRight"


def look_along(view, points, direction):
    """Points the camera at the points from direction; None: from the direction in which they look broadest."""
    if direction is None:
        variances, axes = numpy.linalg.eigh(numpy.cov((points - points.mean(axis=0)).T))
        even = variances[2] - variances[0] < 0.05 * variances[2]
        direction = (0.30, -0.22, 0.93) if even else axes[:, 0] + 0.12 * axes[:, 1]
    direction = numpy.asarray(direction, float) / numpy.linalg.norm(direction)
    up = numpy.eye(3)[numpy.argmin(numpy.abs(direction))]
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    up = up - up.dot(direction) * direction
    across = numpy.cross(up, direction)
    half = max(numpy.abs((points - middle) @ up).max() / numpy.linalg.norm(up),
               numpy.abs((points - middle) @ across).max() / numpy.linalg.norm(across))
    view.CameraViewAngle = 20
    view.CameraFocalPoint = middle.tolist()
    view.CameraPosition = (middle + 1.3 * half / numpy.tan(numpy.radians(10)) * direction).tolist()
    view.CameraViewUp = up.tolist()


def scene(surface, loops, direction):
    view = simple.CreateView("RenderView")
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    points = vtk_to_numpy(output(surface).GetPoints().GetData()).astype(float)
    size = numpy.linalg.norm(points.max(axis=0) - points.min(axis=0))
    # Its name up to ParaView 5.12, and from 5.13 on.
    normals = getattr(simple, "SurfaceNormals", None) or simple.GenerateSurfaceNormals
    smooth = normals(Input=surface, Splitting=0)
    paint(simple.Show(smooth, view), GREY, 0.30, 0.2)
    show_tubes(loops, (HANDLE, TUNNEL), RED, 0.0042 * size, view)
    show_tubes(loops, (ADDITIONAL,), YELLOW, 0.0038 * size, view)  # red has precedence where both are
    show_choke_points(loops, view)
    look_along(view, points, direction)
    return view


def choking_picture(surface, picture, radius=100.0, persistence=5.0, side="Both",
                    direction=None, size=(1600, 900)):
    """Draws the choking loops of `surface`, any ParaView source of a closed surface, to `picture`.

    radius, persistence: MaximumRadius and MinimumPersistence of the filter ChokingLoops, in
    percent. direction: from where to look; None: from where the surface looks broadest.
    Returns the counts, facts and rows that numbers_of() names, and the filter's proxy as "proxy".
    """
    loops = loops_of(surface, radius, persistence, side)
    simple.UpdatePipeline(proxy=loops)
    if output(loops, 3).GetNumberOfRows() == 0:
        raise RuntimeError(NO_LOOPS)
    draw(surface, loops, picture, radius, persistence, direction, size)
    return dict(numbers_of(loops), proxy=loops)


def loops_of(surface, radius, persistence, side):
    """The filter, not yet executed."""
    return simple.ChokingLoops(
        registrationName="ChokingLoops", Input=surface, MaximumRadius=float(radius),
        MinimumPersistence=float(persistence), Side=side, Shortening="Geodesic")


def draw(surface, loops, picture, radius, persistence, direction=None, size=(1600, 900)):
    """The picture of the loops that were found."""
    chart = simple.CreateView("XYChartView")
    show_diagram(loops, chart, float(radius), float(persistence))
    layout = simple.CreateLayout("Choking loops")
    layout.SplitHorizontal(0, 0.60)
    view = scene(surface, loops, direction)
    layout.AssignView(1, view)
    layout.AssignView(2, chart)
    layout.SetSize(*size)
    simple.SaveScreenshot(str(picture), layout, ImageResolution=list(size))


def report(found):
    """The numbers as lines of text; the first has the counts."""
    reference = found["reference length"]
    return [
        "handles {handles}, tunnels {tunnels}, additional loops {additional inside} inside and "
        "{additional outside} outside".format(**found),
        "samples %d, largest sampling error %.4g, reference lengths %.5g inside, %.5g outside" % (
            found["samples"], found["largest sampling error"], reference["inside"], reference["outside"]),
        "seconds: " + ", ".join("%s %.2f" % item for item in found["seconds"].items())]


def main(surface, picture=None, radius=100.0, persistence=5.0, side="Both"):
    if not Path(surface).is_file():
        sys.exit(f"There is no file {surface}.")
    source = simple.OpenDataFile(str(surface))
    simple.UpdatePipeline(proxy=source)
    if source.GetDataInformation().GetDataSetTypeAsString() != "vtkPolyData":
        sys.exit(f"{surface} is not a surface: create one first, e.g. from a map with map_to_mesh.py.")
    picture = picture or output_folder() / "choking_loops.png"
    loops = loops_of(source, radius, persistence, side)
    with step("Choking loops", loops) as this:
        simple.UpdatePipeline(proxy=loops)
        if output(loops, 3).GetNumberOfRows() == 0:
            sys.exit(NO_LOOPS)
        found = numbers_of(loops)
        this.facts.append(f"{found['samples']} samples")
    with step("Picture") as this:
        draw(source, loops, picture, radius, persistence)
        this.facts.append(Path(picture).name)
    lines = report(found)
    file, numbers = Path(picture).with_suffix(".vtp"), Path(picture).with_suffix(".txt")
    simple.SaveData(str(file), simple.OutputPort(loops, 0), DataMode="Binary")
    numbers.write_text("\n".join(lines) + "\n")
    print(*lines[:2], f"Picture, loops, numbers: {picture} {file} {numbers}", sep="\n")


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        sys.exit(len(sys.argv) < 2)
    main(*sys.argv[1:])
