"""Figures of a view for print: sized in millimetres, light, with legends that can be read and a scale bar.

    from isthmus import pipelines                 # or: import isthmus_pipelines, with the plugin loaded
    pipelines.figure(view, width_mm=85, dpi=300, path="loops.png")

A PNG file and, beside it, an SVG file: text and lines of legends are vectors over the same picture; charts consist
of vectors only.
"""

import base64
import math
import os
import re
import struct
import tempfile
import zlib

from vtkmodules.vtkImagingCore import vtkExtractVOI
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

try:
    from paraview import servermanager, simple
except ImportError:
    servermanager = simple = None  # pip's vtk alone: isthmus.pipelines can be imported all the same

MM_PER_INCH, POINTS_PER_INCH = 25.4, 72.0
WHITE, BLACK = [1.0, 1.0, 1.0], [0.0, 0.0, 0.0]
BAR_SHARE = 0.25  # of the width, at most, is the scale bar


def figure(view=None, width_mm=85, dpi=300, path=None, font_points=7, background=WHITE, scale_bar=True):
    """Writes the view as a PNG file of that width (mm) and resolution, and as an SVG file of the same name; returns
    their paths.

    path: of the PNG file; None: a new one in the folder for temporary files.
    font_points: size of all text in print.
    background: red, green, blue from 0 to 1. Text is black on a light one, white on a dark one.
    scale_bar: of a round length in angstrom, as it is in the plane of the focal point; no chart has one.
    The view itself is not changed."""
    view = view or simple.GetActiveView()
    if view is None or not hasattr(view, "ViewSize") or view.SMProxy.GetXMLName() == "SpreadSheetView":
        raise ValueError("A figure is made of a render view or a chart: give one.")
    if not (width_mm > 0 and dpi > 0 and font_points > 0):
        raise ValueError("The width (mm), the resolution (dpi) and the size of text (points) must be above 0.")
    width = max(1, round(width_mm / MM_PER_INCH * dpi))
    across, up = view.ViewSize
    size = [width, max(1, round(width * up / across))]
    path = path or os.path.join(tempfile.mkdtemp(prefix="isthmus-figure-"), "figure.png")
    vector = os.path.splitext(path)[0] + ".svg"
    pixels = max(1, round(font_points * dpi / POINTS_PER_INCH))  # height of text in the picture
    scale = across / width  # from there to the view, which is what the vectors are made of
    change = _Changes()
    try:
        if view.SMProxy.GetXMLName() == "RenderView":
            _prepare(view, change, background, scale_bar)
            _set_fonts(view, change, pixels, 2.5 / MM_PER_INCH * dpi)
            _save(path, view, size)
            _set_fonts(view, change, max(1, round(pixels * scale)), 2.5 / MM_PER_INCH * dpi * scale)
            _vectors(vector, view, change, size)
        else:
            _set_chart_fonts(view, change, pixels)
            _save(path, view, size)
            _set_chart_fonts(view, change, max(1, round(pixels * scale)))
            simple.ExportView(vector, view=view)
        _set_size(vector, width_mm, size)
        _set_resolution(path, dpi)
    finally:
        change.undo()
        simple.Render(view)
    return path, vector


class _Changes:
    """Properties that are put back in the end, and representations that are taken out."""

    def __init__(self):
        self.before, self.added = [], []

    def set(self, proxy, **values):
        for name, value in values.items():
            if proxy.SMProxy.GetProperty(name) is None:
                continue  # of another version of ParaView
            was = getattr(proxy, name)
            self.before.append((proxy, name, was[:] if hasattr(was, "__len__") and not isinstance(was, str) else was))
            setattr(proxy, name, value)

    def add(self, view, kind, source, **values):
        """Draws a source that is in no pipeline."""
        proxy = servermanager.ProxyManager().SMProxyManager.NewProxy("representations", kind)
        display = servermanager._getPyProxy(proxy)
        display.Input = source
        for name, value in values.items():
            setattr(display, name, value)
        view.Representations.append(display)
        self.added.append((view, display, source))
        return display

    def undo(self):
        for view, display, _ in self.added:
            view.Representations.remove(display)
        for proxy, name, was in reversed(self.before):
            setattr(proxy, name, was)
        self.before, self.added = [], []


def _ink(background):
    return BLACK if sum(background) > 1.5 else WHITE


def _legends(view):
    return [display for display in view.Representations
            if display.SMProxy.GetXMLName() == "ScalarBarWidgetRepresentation" and display.Visibility]


def _texts(view):
    return [display for display in view.Representations
            if display.SMProxy.GetXMLName() == "TextSourceRepresentation" and display.Visibility]


def _prepare(view, change, background, scale_bar):
    ink = _ink(background)
    change.set(view, UseColorPaletteForBackground=0, BackgroundColorMode="Single Color", Background=background,
               OrientationAxesVisibility=0, CenterAxesVisibility=0)
    if scale_bar:
        _add_scale_bar(view, change, ink)
    for bar in _legends(view):
        change.set(bar, TitleColor=ink, LabelColor=ink)
    for text in _texts(view):
        change.set(text, Color=ink)


def _set_fonts(view, change, size, thickness):
    for bar in _legends(view):
        change.set(bar, TitleFontSize=size, LabelFontSize=size, ScalarBarThickness=max(1, round(thickness)))
    for text in _texts(view):
        change.set(text, FontSize=size)
    simple.Render(view)


def _add_scale_bar(view, change, ink):
    """A line at the lower left, in the plane of the focal point, and its length."""
    camera = view.GetActiveCamera()
    across, up = view.ViewSize
    height = (2.0 * camera.GetParallelScale() if camera.GetParallelProjection() else
              2.0 * camera.GetDistance() * math.tan(math.radians(0.5 * camera.GetViewAngle())))
    unit = height / up  # of the data, for a pixel
    length = round_length(BAR_SHARE * across * unit)
    ahead, above = camera.GetDirectionOfProjection(), camera.GetViewUp()
    right = _unit(_cross(ahead, above))
    above = _cross(right, ahead)
    focus = camera.GetFocalPoint()
    x, y = (-0.46 * across) * unit, (-0.44 * up) * unit
    start = [focus[i] + x * right[i] + y * above[i] for i in range(3)]
    end = [start[i] + length * right[i] for i in range(3)]
    line = _source("LineSource", Point1=start, Point2=end)
    change.add(view, "GeometryRepresentation", line, AmbientColor=ink, DiffuseColor=ink, LineWidth=4.0,
               Ambient=1.0, Diffuse=0.0)
    label = _source("TextSource", Text=f"{length:g} \u00c5")
    place = change.add(view, "TextSourceRepresentation", label, Justification="Left")
    names = place.GetProperty("WindowLocation").Available
    place.WindowLocation = "Any Location" if "Any Location" in names else "AnyLocation"
    place.Position = [0.04, 0.07]


def _source(name, **values):
    source = servermanager._getPyProxy(servermanager.ProxyManager().SMProxyManager.NewProxy("sources", name))
    for key, value in values.items():
        setattr(source, key, value)
    source.UpdatePipeline()
    return source


def round_length(most):
    """The largest of 1, 2 or 5 times a power of ten that is no more than `most`."""
    power = 10.0 ** math.floor(math.log10(most))
    return max(factor for factor in (1.0, 2.0, 5.0) if factor * power <= most * (1.0 + 1e-9)) * power


def _cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return [x / length for x in a]


def _set_chart_fonts(view, change, size):
    change.set(view, ChartTitleFontSize=size, LegendFontSize=size, **{
        f"{axis}Axis{part}FontSize": size for axis in ("Left", "Bottom", "Right", "Top") for part in ("Title", "Label")})
    simple.Render(view)


def _save(path, view, size):
    """A picture of exactly that size: ParaView makes one of a multiple of a smaller one, which is then cut."""
    times = max(1, *(-(-size[axis] // max(1, view.ViewSize[axis])) for axis in range(2)))
    made = [-(-size[axis] // times) * times for axis in range(2)]
    simple.SaveScreenshot(path, view, ImageResolution=made, FontScaling="Do not scale fonts", TransparentBackground=0)
    if made != size:
        reader, cut, writer = vtkPNGReader(), vtkExtractVOI(), vtkPNGWriter()
        reader.SetFileName(path)
        cut.SetInputConnection(reader.GetOutputPort())
        cut.SetVOI(0, size[0] - 1, 0, size[1] - 1, 0, 0)
        cut.Update()
        writer.SetInputConnection(cut.GetOutputPort())
        writer.SetFileName(path)
        writer.Write()


def _vectors(path, view, change, size):
    """Text, legends and lines as ParaView exports them, over a picture without."""
    simple.ExportView(path, view=view)
    for each in (*_legends(view), *_texts(view)):
        change.set(each, Visibility=0)
    with tempfile.TemporaryDirectory() as folder:
        picture = os.path.join(folder, "picture.png")
        _save(picture, view, size)
        with open(picture, "rb") as file:
            data = base64.b64encode(file.read()).decode()
    across, up = view.ViewSize
    with open(path, encoding="utf-8") as file:
        text = file.read()
    text = re.sub(r"<image\b[^>]*/>|<image\b.*?</image>", "", text, flags=re.S)
    image = f'<image x="0" y="0" width="{across}" height="{up}" xlink:href="data:image/png;base64,{data}"/>\n'
    with open(path, "w", encoding="utf-8") as file:
        file.write(text.replace("<g>", "<g>\n" + image, 1))


def _set_size(path, width_mm, size):
    """The width and height of an SVG file, in millimetres."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    height_mm = width_mm * size[1] / size[0]
    text = re.sub(r'width="[^"]*" height="[^"]*" viewBox', f'width="{width_mm:g}mm" height="{height_mm:g}mm" viewBox',
                  text, count=1)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def _set_resolution(path, dpi):
    """Writes the resolution into a PNG file (the chunk pHYs), so that programs place it at its width."""
    with open(path, "rb") as file:
        data = file.read()
    per_metre = round(dpi / MM_PER_INCH * 1000)
    body = b"pHYs" + struct.pack(">IIB", per_metre, per_metre, 1)
    chunk = struct.pack(">I", 9) + body + struct.pack(">I", zlib.crc32(body))
    start = data.find(b"pHYs")
    if start > 0:
        data = data[:start - 4] + data[start + 17:]
    with open(path, "wb") as file:
        file.write(data[:33] + chunk + data[33:])  # after the signature and the chunk IHDR
