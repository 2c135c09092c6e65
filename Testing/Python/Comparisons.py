"""Compare: the same surface at two sizes beside each other, with linked cameras and one range of colours."""

from paraview import simple

from isthmus_plugin import comparisons, pipelines  # there once paraview.simple has loaded the plugin
from vtkmodules.vtkCommonCore import vtkOutputWindow

view = simple.GetActiveViewOrCreate("RenderView")
view.Background, view.UseColorPaletteForBackground = [1.0, 1.0, 1.0], 0


def coloured(source, name):
    """Spheres coloured by mean curvature, of which the filter finds 1/radius."""
    curvature = simple.SurfaceCurvature(source, registrationName=name)
    return curvature, pipelines.show(curvature, view=view)


def shown(in_view):
    return [display.Input for display in in_view.Representations if getattr(display, "Input", None) is not None and display.Visibility]


def range_of(display):
    points = display.LookupTable.RGBPoints
    return min(points[::4]), max(points[::4])


def same(first, second):
    return all(abs(a - b) < 1e-9 * max(1.0, abs(a)) for a, b in zip(first, second))


def camera_of(in_view):
    camera = in_view.GetActiveCamera()
    return [*camera.GetPosition(), *camera.GetFocalPoint(), *camera.GetViewUp(), camera.GetParallelScale()]


sphere = simple.Sphere(Radius=10.0, ThetaResolution=40, PhiResolution=40)
large, large_display = coloured(sphere, "large")
small, small_display = coloured(simple.Transform(sphere, Transform="Transform"), "small")
small.Input.Transform.Scale = [0.25, 0.25, 0.25]
small_display.Opacity = 0.5
simple.Hide(large, view)
simple.Render(view)

# The shape moves to a second view; the first one shows what it does not come from.
other = comparisons.compare(small)
assert shown(view) == [large] and shown(other) == [small], (shown(view), shown(other))
(copy,) = [display for display in other.Representations if getattr(display, "Input", None) == small]
assert copy.Opacity == 0.5 and list(other.Background) == [1.0, 1.0, 1.0]
legends = [simple.GetScalarBar(copy.LookupTable, each) for each in (view, other)]
assert all(legend.Visibility for legend in legends) and legends[0].Title == legends[1].Title == "Mean curvature (1/Å)", legends[1].Title

# One colour map covers the curvatures of both spheres, 0.1 and 0.4, and keeps its range.
assert copy.LookupTable == large_display.LookupTable and copy.ColorArrayName[1] == "MeanCurvature"
low, high = range_of(copy)
assert low <= -0.38 and 0.38 <= high < 0.6, f"colours from {low} to {high}"
small.Input.Transform.Scale = [2.0, 2.0, 2.0]
for each in (view, other):
    simple.Render(each)
pipelines.first_look(copy.GetGlobalID())
assert range_of(copy) == (low, high), "the range follows one of the views"

# Both cameras are one, whichever of them moves.
assert same(camera_of(view), camera_of(other)), (camera_of(view), camera_of(other))
for moved, follows in ((view, other), (other, view)):
    before = camera_of(follows)
    moved.CameraPosition = [x + 7.0 for x in moved.CameraPosition]
    moved.CameraParallelScale *= 2.0
    simple.Render(moved)
    assert camera_of(follows) != before and same(camera_of(moved), camera_of(follows)), "the cameras are not linked"

# A source that the view does not show gives a note, and no view.
said = []
tag = vtkOutputWindow.GetInstance().AddObserver("UserEvent", lambda *_: said.append(1))
assert comparisons.compare(simple.Cone()) is None and said and len(simple.GetViews()) == 2
vtkOutputWindow.GetInstance().RemoveObserver(tag)

# Both shapes come from the sphere, so that none is left for the first view: it keeps what moves.
simple.SetActiveView(view)
alone = comparisons.compare(sphere)
assert shown(view) == [large] and shown(alone) == [large], (shown(view), shown(alone))
