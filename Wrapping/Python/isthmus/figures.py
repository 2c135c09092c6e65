"""Figures of a view for print: sized in millimetres, light, with legends that can be read, a scale bar, soft shadows and
silhouettes.

    from isthmus import pipelines                 # or: from isthmus_plugin, with the plugin loaded
    pipelines.figure(view, width_mm=85, dpi=300, path="loops.png")

A PNG file and, beside it, an SVG file: text and lines of legends are vectors over the same picture; charts consist
of vectors only. background(), scale_bar() and soft_shadows() change the view itself, as the menu Isthmus > Look of the
view does.
"""

import base64
import math
import os
import re
import struct
import tempfile
import time
import zlib

from vtkmodules.vtkCommonCore import vtkLookupTable, vtkVersion
from vtkmodules.vtkImagingCore import vtkExtractVOI
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

try:
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
except ImportError:
    numpy = None  # figures without silhouettes

try:
    from paraview import servermanager, simple
except ImportError:
    servermanager = simple = None  # with pip's vtk alone, isthmus.pipelines can still be imported

from . import cameras, colours, loop_views, messages

MM_PER_INCH, POINTS_PER_INCH = 25.4, 72.0
WHITE = [1.0, 1.0, 1.0]
BAR_SHARE = 0.25  # largest length of the scale bar, as a fraction of the width
NANOMETRES = 100.0  # angstrom, the shortest bar that is given in nanometres
# Ambient occlusion: the distance at which surfaces shade each other, in diagonals of what is shown, and how much farther
# (in that distance) a surface must be to be shaded at all, so that it does not shade itself.
REACH, BIAS, SAMPLES = 0.12, 0.08, 32
# Silhouettes: where the depth changes by more than this (in diagonals of what is shown) from one pixel to the next; their
# width in print, in points.
JUMP, LINE_POINTS = 0.02, 0.4
LETTER = 11.0  # pixels, the width of one in the text of the scale bar of a view
SCALE_BAR = "scale bar"  # begins its name in the pipeline browser
PALETTES = {"white": "WhiteBackground", "light": "WhiteBackground", "dark": "BlackBackground"}  # ParaView's
LIGHT = [0.93, 0.93, 0.93]
FAST = 0.04  # seconds to draw a view with soft shadows, so that it still turns smoothly


def figure(view=None, width_mm=85, dpi=300, path=None, font_points=7, background=WHITE, scale_bar=True, shadows=True,
           silhouettes=True):
    """Writes the view as a PNG file of that width (mm) and resolution, and as an SVG file of the same name; returns
    their paths.

    path: of the PNG file; None: a new one in the folder for temporary files.
    font_points: size of all text in print.
    background: red, green, blue from 0 to 1; None: as in the view. Text is black on a light one, white on a dark one.
    scale_bar: of a round length, in angstrom below 100 angstrom, else in nanometres. With parallel projection it holds
    everywhere; with perspective only in the plane of the focal point, as its text then states. Charts have none. shadows:
     ambient occlusion by the renderer (SSAO), which darkens crevices. Opaque surfaces only.
    silhouettes: black lines where the depth jumps. Opaque surfaces only; none where a server renders.
    The view itself is not changed."""
    def can_be_drawn(one):
        return one is not None and hasattr(one, "ViewSize") and one.SMProxy.GetXMLName() != "SpreadSheetView"

    if view is None:  # beside an active table, the view that it belongs to
        view = next(filter(can_be_drawn, [simple.GetActiveView(), *simple.GetViews()]), None)
    if not can_be_drawn(view):
        raise ValueError("A figure is made of a render view or a chart: give one.")
    if not (width_mm > 0 and dpi > 0 and font_points > 0):
        raise ValueError("The width (mm), the resolution (dpi) and the size of text (points) must be above 0.")
    width = max(1, round(width_mm / MM_PER_INCH * dpi))
    across, up = view.ViewSize
    size = [width, max(1, round(width * up / across))]
    is_render_view = view.SMProxy.GetXMLName() == "RenderView"
    path = path or os.path.join(tempfile.mkdtemp(prefix="isthmus-figure-"), "figure.png")
    vector = os.path.splitext(path)[0] + ".svg"
    pixels = max(1, round(font_points * dpi / POINTS_PER_INCH))  # height of text in the picture
    scale = across / width  # transferred to the view, from which the vectors are exported
    change = _Changes()
    try:
        if is_render_view:
            for _, display in _bars(view):
                change.set(display, Visibility=0)  # the figure has its own one
            lines = _Silhouettes(view, size, LINE_POINTS * dpi / POINTS_PER_INCH) if silhouettes else None
            _prepare(view, change, background, scale_bar)
            if shadows:
                _occlude(view, change)
            _set_fonts(view, change, pixels, 2.5 / MM_PER_INCH * dpi)
            _save(path, view, size, lines)
            _set_fonts(view, change, max(1, round(pixels * scale)), 2.5 / MM_PER_INCH * dpi * scale)
            _vectors(vector, view, change, size, lines)
        else:
            _set_chart_fonts(view, change, pixels)
            _save(path, view, size)
            _set_chart_fonts(view, change, max(1, round(pixels * scale)))
            _colour_points(view)
            simple.ExportView(vector, view=view)
            _remove_images(vector)  # ParaView 6.1 adds an empty one
        _set_size(vector, width_mm, size)
        _set_resolution(path, dpi)
    finally:
        change.undo()
        _draw(view)
    return path, vector


def _colour_points(view):
    """Gives each point of a chart the colour of its series: VTK 9.6 crashes where points without colours of their own
    are exported as vectors."""
    if vtkVersion().GetVTKMajorVersion() * 100 + vtkVersion().GetVTKMinorVersion() < 906:
        return
    chart = view.GetClientSideObject().GetChart()
    for number in range(chart.GetNumberOfPlots()):
        plot = chart.GetPlot(number)
        table = plot.GetInput()
        if not plot.IsA("vtkPlotPoints") or table is None or plot.GetScalarVisibility():
            continue
        colour = plot.GetPen().GetColorObject()
        look = vtkLookupTable()
        look.SetNumberOfTableValues(1)
        look.SetTableValue(0, colour.GetRed() / 255.0, colour.GetGreen() / 255.0, colour.GetBlue() / 255.0,
                           plot.GetPen().GetOpacity() / 255.0)
        plot.SetLookupTable(look)
        plot.SelectColorArray(0)
        plot.ScalarVisibilityOn()


@messages.reports_faults("Saving the figure")
def save_figure(path, width_mm, dpi, background, scale_bar, outlines):
    """Isthmus > Save figure: the active view as shown, without status texts such as the number of loops."""
    try:
        path = path if path.lower().endswith(".png") else path + ".png"
        written = figure(None, width_mm, dpi, path, background=background, scale_bar=scale_bar, shadows=outlines,
                         silhouettes=outlines)
    except (ValueError, OSError) as error:
        messages.show_error(str(error))
        return
    messages.show_note(f"Saved {written[0]} and, with text as vectors, {os.path.basename(written[1])}.")


class _Changes:
    """Properties that are restored at the end, and representations that are removed again."""

    def __init__(self):
        self.before, self.added = [], []

    def set(self, proxy, **values):
        for name, value in values.items():
            if proxy.GetProperty(name) is None:
                continue  # of another version of ParaView
            was = getattr(proxy, name)
            self.before.append((proxy, name, was[:] if hasattr(was, "__len__") and not isinstance(was, str) else was))
            setattr(proxy, name, value)

    def add(self, view, kind, source, **values):
        """Draws a source that is not part of a pipeline."""
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


# ---------------------------------------------------------------------------- the look of a view

def background(name):
    """The background of all views without one of their own: "white", "light", "dark", or "standard" as ParaView starts.
    Texts, legends and axes have a colour to be read on it: these are ParaView's palettes of colours."""
    if name not in (*PALETTES, "standard"):
        raise ValueError(f"There is no background {name}: choose {', '.join(PALETTES)} or standard.")
    is_new = servermanager.vtkSMProxyManager.GetVersionMajor() > 5
    standard = "WarmGrayBackground" if is_new else "BlueGrayBackground"
    simple.LoadPalette(PALETTES.get(name, standard))
    if name == "light":
        palette = servermanager.ProxyManager().GetProxy("settings", "ColorPalette")
        servermanager.vtkSMPropertyHelper(getattr(palette, "SMProxy", palette), "BackgroundColor").Set(LIGHT, 3)
        palette.UpdateVTKObjects()
    for view in _render_views():
        for ruler, display in _bars(view):
            _place_bar(view, ruler, display)
        for names in _names(view):
            names.PointLabelColor = view.OrientationAxesLabelColor
        _draw(view)


def first_sight(view):
    """Called before the window shows its first result of Isthmus, which it lights for a figure: a light background, where the
    user has ParaView's own, and soft shadows, where the view is drawn fast enough with them. The setting Isthmus > Light
    Background And Soft Shadows turns this off."""
    global _has_begun
    settings = servermanager.ProxyManager().GetProxy("settings", "IsthmusSettings")
    if _has_begun or settings is None or not settings.LightBackgroundAndSoftShadows:
        return
    _has_begun = True
    manager = servermanager.ProxyManager()
    if manager.GetProxy("settings", "ColorPalette").GetProperty("BackgroundColor").IsValueDefault():
        background("light")
        # ParaView has saved it for later sessions, which may be without Isthmus: the default values take it out again.
        servermanager.vtkSMSettings.GetInstance().SetProxySettings(manager.GetPrototypeProxy("settings", "ColorPalette"), None)
    # A view that is slow without shadows is not made to wait for the measurement.
    if _time_to_draw(view) < FAST and soft_shadows(view, True) and _time_to_draw(view) > FAST:
        soft_shadows(view, False)


_has_begun = False


def _draw(view):
    """Not simple.Render(), which resets the camera when it draws for the first time."""
    view.SMProxy.StillRender()


def _time_to_draw(view):
    began = time.monotonic()
    _draw(view)
    return time.monotonic() - began


def soft_shadows(view=None, on=None):
    """Ambient occlusion, which darkens crevices of opaque surfaces, in a render view; on=None: toggle.
    Returns whether it is on."""
    view = _render_view(view)
    on = not int(view.UseAmbientOcclusion) if on is None else bool(on)
    if on:
        _occlude(view, _Changes())
    else:
        view.UseAmbientOcclusion = 0
    _draw(view)
    return on


def scale_bar(view=None, on=None):
    """A scale bar of a round length at the lower left of a render view, which follows the camera; on=None: toggle. Its length holds at the focal point; with perspective, its text says so. Returns whether it is shown."""
    view = _render_view(view)
    known = _bars(view)
    on = not any(display.Visibility for _, display in known) if on is None else bool(on)
    if on and not known:
        known = [_make_bar(view)]
    for ruler, display in known:
        display.Visibility = int(on)
        _place_bar(view, ruler, display)
        cameras.follow(view)
    _draw(view)
    return on


@messages.reports_faults("The look of the view")
def change_look(what):
    """An entry of the menu Isthmus > Look of the view."""
    try:
        if what not in (*PALETTES, "standard"):
            globals()[what]()
            return
        background(what)
        if what == "standard":
            settings = servermanager.ProxyManager().GetProxy("settings", "IsthmusSettings")
            settings.LightBackgroundAndSoftShadows = 0
            servermanager.vtkSMSettings.GetInstance().SetProxySettings(settings.SMProxy, None)  # for later sessions
        messages.show_note("ParaView keeps the background for later sessions; Standard background returns to its own.")
    except ValueError as error:
        messages.show_error(str(error))


def refresh(view):
    """Adapts scale bar and soft shadows to the current contents of a view."""
    if int(view.UseAmbientOcclusion):
        _occlude(view, _Changes())
    for ruler, display in _bars(view):
        _place_bar(view, ruler, display)


def _render_views():
    return [view for view in simple.GetViews() if view.SMProxy.GetXMLName() == "RenderView"]


def _render_view(view):
    view = view or simple.GetActiveView()
    if view is None or view.SMProxy.GetXMLName() != "RenderView":
        raise ValueError("Only a view of shapes (Render View) has this: click into one first.")
    return view


def _bars(view):
    """[(ruler, display)] of the scale bars in a view."""
    found = []
    for (name, _), ruler in simple.GetSources().items() if hasattr(view, "HiddenLineRemoval") else ():
        if name.startswith(SCALE_BAR) and ruler.SMProxy.GetXMLName() == "Ruler":
            found += [(ruler, display) for display in view.Representations if getattr(display, "Input", None) == ruler]
    return found


def visible_bars(view):
    """The displays of the scale bars that a view shows."""
    return [display for _, display in _bars(view) if display.Visibility]


def _make_bar(view):
    selected = simple.GetActiveSource()
    names = {name for name, _ in simple.GetSources()}
    number = next(i for i in range(1, len(names) + 2) if _bar_name(i) not in names)
    ruler = simple.Ruler(registrationName=_bar_name(number))
    display = simple.Show(ruler, view)
    display.NumberOfTicks, display.AxisLineWidth = 2, 3.0
    simple.SetActiveSource(selected)
    return ruler, display


def _bar_name(number):
    return SCALE_BAR if number == 1 else f"{SCALE_BAR} {number}"


def _place_bar(view, ruler, display):
    start, end, words = scale_bar_of(view, in_front=False)
    ruler.Point1, ruler.Point2, display.LabelFormat = start, end, words
    display.AxisColor = list(display.Color)  # of texts, which follows the palette


@cameras.when_moved
def _place_bars(view, _):
    """Places the bars again whenever the camera has moved."""
    bars = [(ruler, display) for ruler, display in _bars(view) if display.Visibility]
    for ruler, display in bars:
        _place_bar(view, ruler, display)
    return bool(bars)


# ---------------------------------------------------------------------------- figures

def _legends(view):
    return [display for display in view.Representations
            if display.SMProxy.GetXMLName() == "ScalarBarWidgetRepresentation" and display.Visibility]


def _texts(view):
    return [display for display in view.Representations
            if display.SMProxy.GetXMLName() == "TextSourceRepresentation" and display.Visibility]


def _names(view):
    return [display for display in view.Representations
            if display.SMProxy.GetXMLName() == "DataLabelRepresentation" and display.Visibility]


def _prepare(view, change, background, scale_bar):
    change.set(view, OrientationAxesVisibility=0, CenterAxesVisibility=0)
    if background is None:
        ink = list(view.OrientationAxesLabelColor)  # of texts, which follows the palette
    else:
        ink = colours.ink(background)
        change.set(view, UseColorPaletteForBackground=0, BackgroundColorMode="Single Color", Background=background)
    for text in _texts(view):
        if loop_views.registered_name(text.Input).endswith(loop_views.COUNT):
            change.set(text, Visibility=0)
    if scale_bar:
        _add_scale_bar(view, change, ink)
    for bar in _legends(view):
        change.set(bar, TitleColor=ink, LabelColor=ink)
    for text in _texts(view):
        change.set(text, Color=ink)
    for names in _names(view):
        change.set(names, PointLabelColor=ink)


def _set_fonts(view, change, size, thickness):
    for bar in _legends(view):
        change.set(bar, TitleFontSize=size, LabelFontSize=size, ScalarBarThickness=max(1, round(thickness)))
    for text in _texts(view):
        change.set(text, FontSize=size)
    _draw(view)


def _add_scale_bar(view, change, ink):
    """A line at the lower left, of a round length in the plane of the focal point, and its length."""
    start, end, words = scale_bar_of(view)
    line = _source("LineSource", Point1=start, Point2=end)
    change.add(view, "GeometryRepresentation", line, AmbientColor=ink, DiffuseColor=ink, LineWidth=4.0,
               Ambient=1.0, Diffuse=0.0)
    place_label(change.add(view, "TextSourceRepresentation", _source("TextSource", Text=words)))


def place_label(display):
    """The text of a scale bar, above its line."""
    names = display.GetProperty("WindowLocation").Available
    display.WindowLocation = "Any Location" if "Any Location" in names else "AnyLocation"
    display.Justification, display.Position = "Left", [0.04, 0.07]


def scale_bar_of(view, in_front=True):
    """(start, end, words) of a scale bar at the lower left of a view: at the depth of the focal point it has a round
    length. in_front: it is drawn in front of what is shown, shortened by perspective; else at the focal point."""
    camera = view.GetActiveCamera()
    across, up = view.ViewSize
    distance, is_parallel = camera.GetDistance(), camera.GetParallelProjection()
    height = (2.0 * camera.GetParallelScale() if is_parallel else
              2.0 * distance * math.tan(math.radians(0.5 * camera.GetViewAngle())))
    unit = height / up  # of the data, for a pixel
    length = round_length(BAR_SHARE * across * unit)
    eye, focus, ahead = camera.GetPosition(), camera.GetFocalPoint(), camera.GetDirectionOfProjection()
    right = _unit(_cross(ahead, camera.GetViewUp()))
    above = _cross(right, ahead)
    depth = _depth_in_front(view, eye, ahead, distance) if in_front else distance
    factor = 1.0 if is_parallel else depth / distance
    words = f"{length / 10.0:g} nm" if length >= NANOMETRES else f"{length:g} \u00c5"
    words = words if is_parallel else words + " at the focal plane"
    x, y = -0.46 * across, -0.44 * up  # pixels
    if not in_front:  # room for the text, whose middle is that of the line
        x = max(x, -0.5 * across + 0.5 * LETTER * len(words) - 0.5 * length / unit)
    x, y = x * unit * factor, y * unit * factor
    start = [eye[i] + depth * ahead[i] + x * right[i] + y * above[i] for i in range(3)]
    end = [start[i] + length * factor * right[i] for i in range(3)]
    return start, end, words


def _depth_in_front(view, eye, ahead, distance):
    """A depth in front of all that is shown; at least a tenth of the way to the focal point."""
    bounds = _bounds_of(view)
    if bounds is None:
        return distance
    corners = [[bounds[2 * i + (n >> i & 1)] for i in range(3)] for n in range(8)]
    nearest = min(sum((corner[i] - eye[i]) * ahead[i] for i in range(3)) for corner in corners)
    return max(min(distance, nearest - 0.01 * _diagonal(bounds)), 0.1 * distance)


def _bounds_of(view):
    """The bounds of all visible shapes; None without any."""
    found = None
    for display in view.Representations:
        source = getattr(display, "Input", None)
        if source is None or not display.Visibility or not hasattr(display, "Opacity"):
            continue
        low_high = source.GetDataInformation().GetBounds()
        if low_high[0] > low_high[1]:
            continue
        found = list(low_high) if found is None else [
            (min, max)[i % 2](found[i], low_high[i]) for i in range(6)]
    return found


def _diagonal(bounds):
    return sum((bounds[2 * i + 1] - bounds[2 * i]) ** 2 for i in range(3)) ** 0.5


def _occlude(view, change):
    """Ambient occlusion at the size of what is shown."""
    bounds = _bounds_of(view)
    if bounds is None:
        return
    reach = REACH * _diagonal(bounds)
    change.set(view, UseAmbientOcclusion=1, UseSSAODefaultPresets=0, Radius=reach, Bias=BIAS * reach,
               KernelSize=SAMPLES, Blur=1)


class _Silhouettes:
    """The pixels of a picture at which the depth jumps, as shares of black."""

    def __init__(self, view, size, width):
        self.mask = None
        bounds = _bounds_of(view)
        if numpy is None or bounds is None or not hasattr(view.SMProxy, "CaptureDepthBuffer"):
            return
        change = _Changes()
        corners = _corners(view)
        try:
            for corner in corners:
                corner.DrawOff()
            for each in (*_legends(view), *_texts(view), *_names(view)):
                change.set(each, Visibility=0)
            for each in view.Representations:
                change.set(each, SelectionPointLabelVisibility=0)
            change.set(view, OrientationAxesVisibility=0, CenterAxesVisibility=0)
            change.set(view, ViewSize=size)  # ignored if the window determines it
            _draw(view)
            depths = view.SMProxy.CaptureDepthBuffer()
            across, up = view.SMProxy.GetRenderWindow().GetSize()
            low, high = view.GetActiveCamera().GetClippingRange()
        finally:
            for corner in corners:
                corner.DrawOn()
            change.undo()
        if depths is None or depths.GetNumberOfTuples() != across * up:
            return
        depth = vtk_to_numpy(depths).reshape(up, across).astype(float)
        if view.GetActiveCamera().GetParallelProjection():
            depth = low + depth * (high - low)
        else:
            depth = low * high / (high - depth * (high - low))
        # A depth far behind counts as slightly behind: a line belongs to the surface in front.
        mask = numpy.zeros(depth.shape, dtype=bool)
        jump = JUMP * _diagonal(bounds)
        mask[:, 1:] |= depth[:, 1:] - depth[:, :-1] > jump
        mask[:, :-1] |= depth[:, :-1] - depth[:, 1:] > jump
        mask[1:] |= depth[1:] - depth[:-1] > jump
        mask[:-1] |= depth[:-1] - depth[1:] > jump
        rows = numpy.minimum((numpy.arange(size[1]) + 0.5) * up / size[1], up - 1).astype(int)
        columns = numpy.minimum((numpy.arange(size[0]) + 0.5) * across / size[0], across - 1).astype(int)
        self.mask = _blurred(mask[rows][:, columns].astype(float), max(1.0, width))

    def draw(self, pixels):
        """The picture (rows from below, columns, channels) with the lines."""
        if self.mask is None or not self.mask.any():
            return pixels
        return numpy.rint(pixels * (1.0 - self.mask[..., None])).astype(numpy.uint8)


def _corners(view):
    """Renderers of a part of the view, such as that of the orientation axes, which clears the depth there even if they
    are hidden."""
    renderers = view.SMProxy.GetRenderWindow().GetRenderers()
    each = [renderers.GetItemAsObject(i) for i in range(renderers.GetNumberOfItems())]
    return [renderer for renderer in each if renderer.GetDraw() and renderer.GetViewport() != (0.0, 0.0, 1.0, 1.0)]


def _blurred(mask, width):
    """Lines of one pixel as soft lines of that width."""
    reach = int(math.ceil(0.5 * width))
    padded = numpy.pad(mask, reach)
    found = numpy.zeros_like(mask)
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            share = min(1.0, max(0.0, 0.5 * width + 0.5 - math.hypot(dx, dy)))
            if share:
                part = padded[reach + dy:reach + dy + mask.shape[0], reach + dx:reach + dx + mask.shape[1]]
                numpy.maximum(found, share * part, out=found)
    return found


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
    _draw(view)


def _save(path, view, size, lines=None):
    """A picture of exactly that size. If the view cannot have that size, ParaView renders a multiple of a smaller size, which
    is then cropped."""
    change = _Changes()
    change.set(view, ViewSize=size)
    times = max(1, *(-(-size[axis] // max(1, view.ViewSize[axis])) for axis in range(2)))
    made = [-(-size[axis] // times) * times for axis in range(2)]
    try:
        simple.SaveScreenshot(path, view, ImageResolution=made, FontScaling="Do not scale fonts", TransparentBackground=0)
    finally:
        change.undo()
    if made != size or lines is not None and lines.mask is not None:
        reader, cut = vtkPNGReader(), vtkExtractVOI()
        reader.SetFileName(path)
        cut.SetInputConnection(reader.GetOutputPort())
        cut.SetVOI(0, size[0] - 1, 0, size[1] - 1, 0, 0)
        cut.Update()
        picture = cut.GetOutput()
        if lines is not None and lines.mask is not None:
            pixels = vtk_to_numpy(picture.GetPointData().GetScalars())
            drawn = lines.draw(pixels.reshape(size[1], size[0], -1)[..., :3])
            picture.GetPointData().SetScalars(numpy_to_vtk(drawn.reshape(-1, 3), deep=1))
        writer = vtkPNGWriter()
        writer.SetInputData(picture)
        writer.SetFileName(path)
        writer.Write()


def _vectors(path, view, change, size, lines=None):
    """Text, legends and lines as exported by ParaView, over a picture without them."""
    simple.ExportView(path, view=view)
    for each in (*_legends(view), *_texts(view)):
        change.set(each, Visibility=0)
    with tempfile.TemporaryDirectory() as folder:
        picture = os.path.join(folder, "picture.png")
        _save(picture, view, size, lines)
        with open(picture, "rb") as file:
            data = base64.b64encode(file.read()).decode()
    across, up = view.ViewSize
    text = _remove_images(path)
    image = f'<image x="0" y="0" width="{across}" height="{up}" xlink:href="data:image/png;base64,{data}"/>\n'
    with open(path, "w", encoding="utf-8") as file:
        file.write(text.replace("<g>", "<g>\n" + image, 1))


def _remove_images(path):
    """The text of an SVG file, from which pictures are removed."""
    with open(path, encoding="utf-8") as file:
        text = re.sub(r"<image\b[^>]*/>|<image\b.*?</image>", "", file.read(), flags=re.S)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return text


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
