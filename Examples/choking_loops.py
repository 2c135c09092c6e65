"""The picture of Fig. 6.1 of the thesis for any closed surface: translucent surface, handles and
tunnels in red, additional loops in yellow, choke points as spheres, persistence diagram beside it.

Usage: pvpython choking_loops.py SURFACE [PICTURE] [DISTANCE_PERCENT PERSISTENCE_PERCENT [SIDE]]
SURFACE: .obj, .stl, .ply, .vtp or .off. PICTURE: choking_loops.png by default.
SIDE: Inside, Outside or Both (default).
"""

import sys
from pathlib import Path

from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

RED, YELLOW, GREY = (0.80, 0.08, 0.10), (0.98, 0.78, 0.05), (0.62, 0.70, 0.80)


def read_off(path):
    """An OFF file as vtkPolyData: ParaView has no reader for it."""
    lines = [line for line in open(path) if line.strip() and not line.startswith("#")]
    if not lines[0].strip().endswith("OFF"):
        sys.exit(f"{path} is no OFF file: it does not begin with OFF.")
    count, faces = (int(word) for word in lines[1].split()[:2])
    points, cells = vtkPoints(), vtkCellArray()
    for line in lines[2:2 + count]:
        points.InsertNextPoint([float(word) for word in line.split()[:3]])
    for line in lines[2 + count:2 + count + faces]:
        words = [int(float(word)) for word in line.split()]
        cells.InsertNextCell(words[0], words[1:1 + words[0]])
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(cells)
    return surface


def open_surface(path):
    if Path(path).suffix.lower() == ".off":
        source = TrivialProducer()
        source.GetClientSideObject().SetOutput(read_off(path))
        return source
    return OpenDataFile(str(path))


def diameter(source):
    box = source.GetDataInformation().GetBounds()
    return sum((box[2 * i + 1] - box[2 * i]) ** 2 for i in range(3)) ** 0.5


def show_tubes(loops, kinds, colour, radius, view):
    chosen = Threshold(Input=OutputPort(loops, 0), Scalars=["CELLS", "Kind"],
                       LowerThreshold=kinds[0], UpperThreshold=kinds[1])
    tubes = Tube(Input=ExtractSurface(Input=chosen), Radius=radius, NumberofSides=12)
    display = Show(tubes, view)
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = colour
    display.AmbientColor = colour
    display.Specular = 0.4


def show_choke_points(loops, view):
    """Spheres of the radius that gets stuck, so small that they touch the surface all round."""
    balls = Glyph(Input=OutputPort(loops, 2), GlyphType="Sphere", GlyphMode="All Points",
                  ScaleArray=["POINTS", "Radius"], ScaleFactor=1.0,
                  OrientationArray=["POINTS", "No orientation array"])
    balls.GlyphType.Radius = 0.5
    display = Show(balls, view)
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = display.AmbientColor = (0.20, 0.35, 0.65)
    display.Opacity = 0.9


def show_diagram(loops, view):
    """Birth against death of everything found, and the diagonal it would vanish on."""
    table = OutputPort(loops, 3)
    display = Show(table, view, "XYChartRepresentation")
    display.UseIndexForXAxis = 0
    display.XArrayName = "Birth"
    display.SeriesVisibility = ["Death"]
    display.SeriesLineStyle = ["Death", "0"]
    display.SeriesMarkerStyle = ["Death", "4"]
    display.SeriesMarkerSize = ["Death", "6"]
    display.SeriesColor = ["Death", "0.80", "0.08", "0.10"]
    display.SeriesLabel = ["Death", "death"]
    view.ChartTitle = "Persistence diagram"
    view.BottomAxisTitle = "birth"
    view.LeftAxisTitle = "death"


def numbers(loops):
    lines = loops.GetClientSideObject().GetOutputDataObject(0)
    facts = lines.GetFieldData()
    value = lambda name, i=0: facts.GetArray(name).GetValue(i)
    print("handles %d, tunnels %d, additional loops %d inside and %d outside" % (
        value("NumberOfHandles"), value("NumberOfTunnels"), value("NumberOfAdditionalLoops"),
        value("NumberOfAdditionalLoops", 1)))
    print("samples %d, largest sampling error %.4g, reference lengths %.5g inside, %.5g outside" % (
        value("NumberOfSamples"), value("LargestSamplingError"), value("ReferenceLength"),
        value("ReferenceLength", 1)))
    print("seconds: " + ", ".join("%s %.2f" % (name, value("StageTimes", i)) for i, name in
                                  enumerate(("check", "sampling", "filtration", "pairing",
                                             "features"))))


def main(surface, picture="choking_loops.png", distance="100", persistence="5", side="Both"):
    shape = Triangulate(Input=Clean(Input=open_surface(surface), Tolerance=0.0))
    loops = ChokingLoops(Input=shape, MaximumDistance=float(distance),
                         MinimumPersistence=float(persistence), Side=side, Shortening="Geodesic")
    UpdatePipeline(proxy=loops)
    numbers(loops)
    size = diameter(shape)

    view = CreateView("RenderView")
    view.ViewSize = [900, 800]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    surface_display = Show(shape, view)
    surface_display.ColorArrayName = ["POINTS", ""]
    surface_display.DiffuseColor = surface_display.AmbientColor = GREY
    surface_display.Opacity = 0.35
    show_tubes(loops, (0, 1), RED, 0.004 * size, view)
    show_tubes(loops, (2, 2), YELLOW, 0.004 * size, view)
    if side != "Both":  # balls outside would hide what they touch
        show_choke_points(loops, view)
    view.ResetCamera()
    view.CameraViewAngle = 22

    chart = CreateView("XYChartView")
    chart.ViewSize = [600, 800]
    show_diagram(loops, chart)
    layout = CreateLayout("choking loops")
    layout.SplitHorizontal(0, 0.6)
    layout.AssignView(1, view)
    layout.AssignView(2, chart)
    SaveScreenshot(str(picture), layout, ImageResolution=[1500, 800])
    print("picture:", picture)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
