"""pipelines.figure: pictures for print of a render view and of a chart, each as PNG and as SVG of the width, resolution,
size of text, scale bar, shadows and silhouettes asked for; the view is afterwards what it was.
"""

import base64
import os
import re
import struct
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy
from paraview import simple
from shared_data import shared_data
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from isthmus_plugin import figures, pipelines  # there once paraview.simple has loaded the plugin

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "Figures"
FOLDER.mkdir(parents=True, exist_ok=True)
DPI, WIDTH_MM = 200, 85
WIDTH = round(WIDTH_MM / 25.4 * DPI)


def pixels_of(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].reshape(height, width, 3).astype(int)


def per_metre(path):
    """The resolution that the PNG file states."""
    data = path.read_bytes()
    start = data.index(b"pHYs")
    return struct.unpack(">II", data[start + 4:start + 12])


def texts_of(path):
    root = ElementTree.parse(path).getroot()
    return root, [" ".join("".join(text.itertext()).split()) for text in root.iter() if text.tag.endswith("text")]


def settings_of(view):
    values = [view.UseColorPaletteForBackground, list(view.Background), view.OrientationAxesVisibility,
              list(view.ViewSize), len(view.Representations)]
    for shown in view.Representations:
        for name in ("TitleColor", "TitleFontSize", "Visibility", "ScalarBarThickness", "FontSize"):
            if shown.SMProxy.GetProperty(name):
                value = getattr(shown, name)
                values.append(list(value) if hasattr(value, "__len__") and not isinstance(value, str) else value)
    return values


def check_sizes(png, svg, view):
    across, up = view.ViewSize
    pixels = pixels_of(png)
    assert pixels.shape[:2] == (round(WIDTH * up / across), WIDTH), pixels.shape
    assert per_metre(png) == (round(DPI / 0.0254),) * 2, per_metre(png)
    root, texts = texts_of(svg)
    assert root.get("width") == f"{WIDTH_MM}mm", root.attrib
    assert abs(float(root.get("height")[:-2]) - WIDTH_MM * up / across) < 0.2, root.attrib
    return pixels, texts


def check_view():
    """A surface with its curvature: white, its legend in black, a bar of a known length."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [700, 560]
    source = simple.OpenDataFile(str(shared_data("maps/emd_1832.map")))
    pipelines.show(*pipelines.map_to_curvature(source), view=view)
    camera = view.GetActiveCamera()
    camera.SetParallelProjection(True)
    camera.SetParallelScale(140.0)  # so that a pixel of the view is half an angstrom
    before = settings_of(view)
    png, svg = map(Path, pipelines.figure(view, WIDTH_MM, DPI, str(FOLDER / "view.png"), shadows=False, silhouettes=False))
    assert settings_of(view) == before, (before, settings_of(view))
    pixels, texts = check_sizes(png, svg, view)
    assert (pixels[-20:, :200] == 255).all(), "the background is not white"
    assert any("curvature" in text.lower() for text in texts), texts
    assert "50 \u00c5" in texts, texts  # at most a quarter of 350 angstrom
    # The bar is the longest dark run of the lowest rows at the left: 50 angstrom of 350.
    dark = (pixels.max(axis=2) < 80)[:pixels.shape[0] // 8, :pixels.shape[1] // 2]
    runs = [max((len(run) for run in "".join("x" if on else " " for on in row).split()), default=0) for row in dark]
    assert abs(max(runs) - WIDTH * 50.0 / 350.0) < 4, (max(runs), WIDTH * 50.0 / 350.0)
    # Vectors: the text is text, and what lies below it is the picture without its text.
    embedded = re.search(r"base64,([A-Za-z0-9+/=]+)", svg.read_text())
    (FOLDER / "embedded.png").write_bytes(base64.b64decode(embedded[1]))
    inner = pixels_of(FOLDER / "embedded.png")
    center = slice(inner.shape[0] // 3, 2 * inner.shape[0] // 3), slice(inner.shape[1] // 3, 2 * inner.shape[1] // 3)
    assert inner.shape == pixels.shape and numpy.abs(inner - pixels)[center].max() < 24
    dark_png, _ = pipelines.figure(view, WIDTH_MM, DPI, str(FOLDER / "dark.png"), background=[0.0, 0.0, 0.0],
                                   scale_bar=False)
    dark_pixels = pixels_of(dark_png)
    assert (dark_pixels[-20:, :200] == 0).all() and (dark_pixels.min(axis=2) > 200).any(), "no white text on black"


def two_plates():
    """A square plate of 60 x 60, and one of 20 x 20 that is 5 nearer to the viewer, in a view of 1 angstrom a pixel."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [200, 160]
    for half, depth in ((30.0, 0.0), (10.0, 5.0)):
        plate = simple.Plane(Origin=[-half, -half, depth], Point1=[half, -half, depth], Point2=[-half, half, depth])
        shown = simple.Show(plate, view)
        shown.DiffuseColor = shown.AmbientColor = [0.9, 0.9, 0.9]
    simple.Render(view)  # the first one sets the camera
    camera = view.GetActiveCamera()
    camera.SetParallelProjection(True)
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetPosition(0.0, 0.0, 300.0)
    camera.SetParallelScale(80.0)
    return view


def check_silhouettes_and_shadows():
    """Lines where the depth jumps and nowhere else; shadows beside the nearer plate only."""
    view = two_plates()
    dpi = 254  # of 85 mm 850 pixels: 4.25 for an angstrom
    made = {}
    for name, more in (("plain", {}), ("lines", {"silhouettes": True}), ("shadows", {"shadows": True})):
        options = {"shadows": False, "silhouettes": False, "scale_bar": False, **more}
        before = settings_of(view)
        png, _ = pipelines.figure(view, WIDTH_MM, dpi, str(FOLDER / f"{name}.png"), **options)
        assert settings_of(view) == before
        made[name] = pixels_of(png).min(axis=2)
        assert made[name].shape == (680, 850)
    row = made["lines"][340]
    dark = numpy.flatnonzero(row < 60)
    edges = [425 + 4.25 * x for x in (-30, -10, 10, 30)]
    assert max(min(abs(x - edge) for edge in edges) for x in dark) < 6, dark
    assert all(min(abs(dark - edge)) < 3 for edge in edges), (dark, edges)
    away = numpy.ones(850, bool)
    away[[x for edge in edges for x in range(round(edge) - 6, round(edge) + 7)]] = False
    assert (abs(row - made["plain"][340])[away] < 3).all(), "lines elsewhere, too"
    darker = made["plain"].astype(int) - made["shadows"]
    beside = darker[340, round(425 + 4.25 * 11):round(425 + 4.25 * 16)].mean()  # on the farther plate, near the edge
    middle, outside = darker[340, 415:435].mean(), darker[340, 30:200].mean()
    assert beside > middle + 5 and abs(outside) < 1, (beside, middle, outside)


def check_corner_of_axes():
    """No lines around the corner where the window shows its axes, which is another renderer's."""
    view = two_plates()
    view.OrientationAxesVisibility = 1
    view.GetActiveCamera().SetParallelScale(25.0)  # the larger plate fills the picture
    png, _ = pipelines.figure(view, WIDTH_MM, DPI, str(FOLDER / "corner.png"), shadows=False, scale_bar=False)
    pixels = pixels_of(png).min(axis=2)
    # From the left edge of the larger plate, and below the smaller one.
    corner = pixels[:27 * pixels.shape[0] // 100, pixels.shape[1] // 20:2 * pixels.shape[1] // 5]
    assert corner.min() > 100, f"{(corner < 100).sum()} dark pixels in the lower left corner"


def check_scale_bar():
    """A bar of perspective has its length at the focal plane, says so, and is in front of all; long ones are in nm."""
    view = two_plates()
    camera = view.GetActiveCamera()
    start, end, words = figures.scale_bar_of(view)
    assert words == "50 \u00c5" and abs(end[0] - start[0] - 50.0) < 1e-9 and start[2] > 5.0, (start, end, words)
    camera.SetParallelScale(800.0)
    assert figures.scale_bar_of(view)[2] == "50 nm"
    camera.SetParallelProjection(False)
    camera.SetViewAngle(30.0)
    start, end, words = figures.scale_bar_of(view)
    assert words == "50 \u00c5 at the focal plane" and start[2] > 5.0, (start, words)
    # At the focal plane, the eye sees it as 50 angstrom.
    assert abs((end[0] - start[0]) * 300.0 / (300.0 - start[2]) - 50.0) < 1e-6, (start, end)


def check_chart():
    source = simple.OpenDataFile(str(shared_data("surfaces/torus.obj")))
    loops = pipelines.surface_to_loops(source)[-1]
    (chart,) = pipelines.persistence_diagram(loops)
    chart.ViewSize = [600, 500]
    size = chart.LeftAxisTitleFontSize
    png, svg = map(Path, pipelines.figure(chart, WIDTH_MM, DPI, str(FOLDER / "chart.png")))
    assert chart.LeftAxisTitleFontSize == size
    _, texts = check_sizes(png, svg, chart)
    assert {"Birth", "Death"} <= {word for text in texts for word in text.split()}, texts
    assert "<image" not in svg.read_text(), "a chart is all vectors"


def check_refusals():
    for bad in (dict(width_mm=0), dict(dpi=-1), dict(font_points=0)):
        try:
            pipelines.figure(simple.GetActiveView(), path=str(FOLDER / "bad.png"), **bad)
        except ValueError as error:
            assert "above 0" in str(error), error
        else:
            raise AssertionError(f"{bad} was not refused")
    assert not (FOLDER / "bad.png").exists()


for most, expected in ((9.99, 5.0), (10.0, 10.0), (49.0, 20.0), (87.5, 50.0), (0.021, 0.02)):
    assert abs(figures.round_length(most) - expected) < 1e-12 * expected, (most, figures.round_length(most))
check_view()
check_silhouettes_and_shadows()
check_corner_of_axes()
check_scale_bar()
check_chart()
check_refusals()
print("figures of a view and of a chart")
