"""Two results side by side: linked cameras, one range of colours.

    from isthmus import comparisons               # or: from isthmus_plugin, with the plugin loaded
    comparisons.compare(denoised_surface)         # moves from the active view to a second one
"""

try:
    from paraview import simple
except ImportError:
    simple = None  # with pip's vtk alone, isthmus.pipelines can still be imported

from . import colours, look, messages, pocket_views

COPIED = ("Opacity", "AmbientColor", "DiffuseColor", "LineWidth", "PointSize", "RenderLinesAsTubes", "Pickable")
OF_LEGENDS = ("Title", "ComponentTitle", "HorizontalTitle", "Orientation", "RangeLabelFormat", "LabelFormat")


def compare(source):
    """Opens a second view beside the active one and moves there what the active view shows of `source`, i.e. itself
    and what was made from it. Where nothing else is left, the active view shows the last hidden shape again that was not
    made from `source` (the surface of a map before denoising), or the same as the second view. Returns the new view;
    None, with a note, if there is nothing to compare."""
    view = simple.GetActiveView()
    shapes = _shapes(view) if hasattr(view, "HiddenLineRemoval") else []
    chosen = [display for display in shapes if look.comes_from(display.Input.SMProxy, source.SMProxy)]
    moved = [display for display in chosen if display.Visibility] or chosen[-1:]
    if not moved:
        messages.show_note("Compare: select a source that the active 3D view shows; it moves to a second view.")
        return None
    others = [display for display in shapes if display not in chosen]
    other = pocket_views.new_view("RenderView", view, "right", 0.5)
    _copy_properties(view, other, ("Background", "UseColorPaletteForBackground", "OrientationAxesLabelColor"))
    for display in moved:
        _copy(display, view, other)
    if others:
        for display in moved:
            display.Visibility = 0
        if not any(display.Visibility for display in others):
            others[-1].Visibility = 1
    _share_ranges(view, other)
    simple.ResetCamera(view)
    simple.Render(other)  # ParaView resets the camera of a view when it first draws a shape
    _same_camera(view, other)
    simple.AddCameraLink(view, other, f"Isthmus{other.SMProxy.GetGlobalID()}")
    simple.HideUnusedScalarBars(view)
    simple.SetActiveView(view)
    simple.SetActiveSource(source)
    for each in (view, other):
        simple.Render(each)
    return other


def _shapes(view):
    """Displays of shapes, without texts, labels and outlines of volumes."""
    return [display for display in view.Representations if hasattr(display, "ColorArrayName") and hasattr(display, "Representation") and
            getattr(display, "Input", None) is not None and display.Representation.GetData() != "Outline"]


def _copy(display, view, other):
    copy = simple.Show(display.Input, other)
    look.is_displayed(copy)
    copy.SetRepresentationType(display.Representation.GetData())
    _copy_properties(display, copy, COPIED)
    association, array = display.ColorArrayName[:2]
    if array and colours.colour_by(copy, association, array):
        copy.SetScalarBarVisibility(other, True)
        _copy_properties(simple.GetScalarBar(display.LookupTable, view), simple.GetScalarBar(copy.LookupTable, other), OF_LEGENDS)
    elif not array:
        colours.plain(copy)


def _copy_properties(original, copy, names):
    for name in names:
        if hasattr(original, name) and hasattr(copy, name):
            setattr(copy, name, getattr(original, name))


def _share_ranges(*views):
    """Each colour map of a quantity covers the values of all views."""
    limits, tables = {}, {}
    for view in views:
        for display in _shapes(view):
            association, array = display.ColorArrayName[:2]
            found = look.colour_range(display.Input, association, array) if array and display.Visibility else None
            if found:
                key = display.LookupTable.GetGlobalID()
                low, high = limits.get(key, found)
                limits[key], tables[key] = (min(low, found[0]), max(high, found[1])), display.LookupTable
    for key, (low, high) in limits.items():
        tables[key].AutomaticRescaleRangeMode = "Never"
        tables[key].RescaleTransferFunction(low, high)


def _same_camera(view, other):
    for name in ("CameraPosition", "CameraFocalPoint", "CameraViewUp", "CameraParallelScale", "CenterOfRotation"):
        setattr(other, name, list(getattr(view, name)) if name != "CameraParallelScale" else view.CameraParallelScale)
