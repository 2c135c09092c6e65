"""Background, scale bar and soft shadows of a view: pipelines.background, scale_bar, soft_shadows, change_look."""

import math

from paraview import servermanager, simple

from isthmus_plugin import figures, pipelines  # there once paraview.simple has loaded the plugin
from isthmus_plugin import pocket_views as pockets
from shared_data import shared_data

view = simple.GetActiveViewOrCreate("RenderView")
view.ViewSize = [600, 450]
figures._has_begun = True  # what depends on the speed of this machine is tested with given times, below
molecule = simple.OpenDataFile(str(shared_data("molecules/1ubq.pdb")))
pipelines.show(*pipelines.protein_to_surface(molecule), view=view)


def check_bar():
    """The bar of the view is horizontal at its lower left, and its length that of its text, at the focal point."""
    (ruler, display), = figures._bars(view)
    length = math.dist(ruler.Point1, ruler.Point2)
    (x1, y1), (x2, y2) = (pockets._on_screen(view, point) for point in (ruler.Point1, ruler.Point2))
    assert float(display.LabelFormat.split()[0]) * (10.0 if " nm" in display.LabelFormat else 1.0) == round(length, 6)
    assert abs(y1 - y2) < 0.5 and 0.03 < y1 / 450 < 0.12 and 0 <= x1 < 0.25 * 600 and 40 < x2 - x1 <= 0.26 * 600, (x1, x2, y1)
    camera = view.GetActiveCamera()
    height = (2.0 * camera.GetParallelScale() if camera.GetParallelProjection() else
              2.0 * camera.GetDistance() * math.tan(math.radians(0.5 * camera.GetViewAngle())))
    assert abs((x2 - x1) - length * 450 / height) < 0.5
    return display.LabelFormat


assert pipelines.scale_bar(view) is True
far = check_bar()
assert far.endswith("Å at the focal plane"), far
near_before = view.GetActiveCamera().GetDistance()
view.GetActiveCamera().Zoom(3.0)
view.SMProxy.GetInteractor().InvokeEvent("EndInteractionEvent")
near = check_bar()
assert near != far, "the bar does not follow the camera"
view.CameraParallelProjection = 1
simple.ResetCamera(view)
assert check_bar().endswith("Å"), "with parallel projection it holds everywhere"
assert pipelines.scale_bar(view) is False and not figures._bars(view)[0][1].Visibility
assert pipelines.scale_bar(view) is True and len(figures._bars(view)) == 1

# A button hides all else, but not the bar.
pipelines.run("protein_to_surface")
assert figures._bars(view)[0][1].Visibility
check_bar()

# What follows the camera updates no pipeline, which may just be running; the next rendering draws what it has set.
*_, found = pipelines.protein_to_pockets(molecule)
pockets.show(found, view, tables=False)
residues = pockets.residues_of(found)
names = pockets.names_of(residues)
count = names.GetDataInformation().GetNumberOfPoints()
assert count > 1, count
ran = []
for (name, _), source in simple.GetSources().items():
    source.GetClientSideObject().AddObserver("StartEvent", lambda *_, name=name: ran.append(name))
residues.UpperThreshold = 2  # waits for an update
view.GetActiveCamera().Zoom(0.1)  # all names overlap
view.SMProxy.InvokeEvent("ResetCameraEvent")
view.SMProxy.GetInteractor().InvokeEvent("InteractionEvent")
assert not ran, f"moving the camera updates {sorted(set(ran))}"
residues.UpperThreshold = 1
simple.Render(view)
assert 0 < names.GetDataInformation().GetNumberOfPoints() < count, "the names do not follow the camera"
simple.ResetCamera(view)

# Backgrounds, and texts that can be read on them.
for name, light in (("white", True), ("light", True), ("dark", False), ("standard", False)):
    pipelines.change_look(name)
    (_, display), = figures._bars(view)
    back, ink = sum(view.SMProxy.GetRenderer().GetBackground()) / 3.0, sum(display.AxisColor) / 3.0
    assert (ink < 0.2 < 0.5 < back) if light else (back < 0.5 < ink), (name, back, ink)

assert pipelines.soft_shadows(view) is True and view.UseAmbientOcclusion and view.Radius > 1.0
assert pipelines.soft_shadows(view) is False and not view.UseAmbientOcclusion
pipelines.figure(view, width_mm=40, dpi=100)
assert figures._bars(view)[0][1].Visibility, "a figure has its own bar, and leaves that of the view"

chart = simple.CreateView("XYChartView")
for call in (pipelines.scale_bar, pipelines.soft_shadows):
    try:
        call(chart)
    except ValueError as error:
        assert "Render View" in str(error)
    else:
        raise AssertionError("a chart has none")
try:
    pipelines.background("pink")
except ValueError as error:
    assert "white, light, dark or standard" in str(error), error
else:
    raise AssertionError("there is no such background")

# The first result of a session: light where the background is ParaView's own, soft shadows where they are drawn fast.
settings = servermanager.ProxyManager().GetProxy("settings", "IsthmusSettings")
assert not settings.LightBackgroundAndSoftShadows, "after Standard background it stays"
pipelines.change_look("light")
assert servermanager.vtkSMSettings.GetInstance().HasSetting(".settings.ColorPalette.BackgroundColor"), "ParaView saves a choice"


def first_sight(before, after, setting=1, background="standard"):
    """Whether there is a light background, and soft shadows; before, after: seconds to draw the view without and with these."""
    pipelines.change_look(background)
    settings.LightBackgroundAndSoftShadows = setting
    figures._has_begun, view.UseAmbientOcclusion = False, 0
    times = [before, after]
    figures._time_to_draw = lambda _: times.pop(0)
    figures.first_sight(view)
    return sum(view.SMProxy.GetRenderer().GetBackground()) > 1.5, bool(int(view.UseAmbientOcclusion))


fast, slow = 0.5 * figures.FAST, 2.0 * figures.FAST
assert first_sight(fast, fast) == (True, True)
saved = servermanager.vtkSMSettings.GetInstance()
assert not saved.HasSetting(".settings.ColorPalette.BackgroundColor"), "later sessions begin as ParaView does"
view.UseAmbientOcclusion = 0
figures.first_sight(view)
assert not int(view.UseAmbientOcclusion), "only the first result"
assert first_sight(fast, slow) == (True, False)
assert first_sight(slow, fast) == (True, False)
assert first_sight(fast, fast, background="dark") == (False, True)
assert first_sight(fast, fast, setting=0) == (False, False)
