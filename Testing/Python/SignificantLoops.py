"""Of the loops of a map the button shows the significant ones first, with the number of all, from a map that was
denoised where its noise asks for it; functions give all loops, and the data functions the same ones.

A ring in white noise of 0.6 of its standard deviation has one handle and one tunnel; undenoised it has many.
"""

import isthmus
import numpy
from paraview import simple
from shared_data import shared_data
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow

from isthmus_plugin import loop_views, pipelines  # there once paraview.simple has loaded the plugin

NOISE = 0.6


def ring(noise):
    """A ring as a smooth map of 48 x 48 x 24 nodes."""
    x, y, z = numpy.meshgrid(*(numpy.arange(n) - 0.5 * (n - 1) for n in (48, 48, 24)), indexing="ij")
    distance = numpy.hypot(numpy.hypot(x, y) - 13.0, z)
    values = 1.0 / (1.0 + numpy.exp(distance - 5.0))
    return values + noise * values.std() * numpy.random.default_rng(41).standard_normal(values.shape)


def opened(values):
    source = simple.PVTrivialProducer(registrationName="ring.map")
    source.GetClientSideObject().SetOutput(isthmus.functions.take_input(
        values, isthmus.functions.table()["functions"]["map_surface"]["inputs"][0], "opened"))
    return source


def kinds(loops):
    """How many features there are of each kind: handles, tunnels, bottlenecks."""
    cells = loops.GetCellData()
    ids, first = numpy.unique(vtk_to_numpy(cells.GetArray("FeatureId")), return_index=True)
    return numpy.bincount(vtk_to_numpy(cells.GetArray("Kind"))[first], minlength=3)


def text():
    found = [source.Text for (name, _), source in simple.GetSources().items() if name.endswith(loop_views.COUNT)]
    assert len(found) == 1, found
    return found[0]


def run(source, function="map_to_loops"):
    """What the button has made, and what the window was told."""
    window, said = vtkOutputWindow.GetInstance(), []
    watched = [window.AddObserver(event, lambda *_: said.append(1)) for event in ("WarningEvent", "ErrorEvent")]
    simple.SetActiveSource(source)
    pipelines.run(function)
    for each in watched:
        window.RemoveObserver(each)
    return simple.GetActiveSource(), said


def clear():
    for proxy in list(simple.GetSources().values()):
        simple.Delete(proxy)


# By data: the ring's two loops come out of the noise, and not without denoising.
denoised = isthmus.map_to_loops(ring(NOISE), level=0.5)
raw = isthmus.map_to_loops(ring(NOISE), level=0.5, denoise=False)
calm = isthmus.map_to_loops(ring(0.0), level=0.5)
print("handles, tunnels, bottlenecks: raw", kinds(raw.loops), "denoised", kinds(denoised.loops), "no noise",
      kinds(calm.loops), flush=True)
assert list(kinds(denoised.loops)[:2]) == list(kinds(calm.loops)[:2]) == [1, 1]
assert kinds(raw.loops)[:2].sum() > 4
assert denoised.surface.GetFieldData().HasArray("EstimatedGain")
assert not calm.surface.GetFieldData().HasArray("EstimatedGain")

# By the button: the same, and it is said. A second press, with the loops selected, begins at the map again.
noisy = opened(ring(NOISE))  # the script of a table puts numpy's source() in the place of a variable of that name
for selected in (noisy, None):
    loops, said = run(selected or loops)
    assert "denoised first, estimated gain" in text() and not said, (text(), said)
    names = [loop_views.registered_name(proxy) for proxy in (loops, loops.Input, loops.Input.Input)]
    number = "" if selected else " 2"
    assert names == [f"ring {what}{number}" for what in ("loops", "largest parts", "denoised")], names
    assert loops.Input.Input.Input.SMProxy == noisy.SMProxy
    simple.Delete(simple.FindSource(names[0] + loop_views.COUNT))
clear()

# Many loops: the 20 most persistent of them, all of them trusted; the text follows the properties.
source = simple.OpenDataFile(str(shared_data("maps/emd_5043.map")))
loops, said = run(source)
assert text() == "20 of 77 loops shown" and not said, (text(), said)
# In a corner: at a fraction of the height, a view that is low, or larger letters, would cut it off.
(shown,) = [display for display in simple.GetActiveView().Representations
            if display.SMProxy.GetXMLName() == "TextSourceRepresentation" and display.Visibility]
place = str(shown.WindowLocation).strip("'").replace(" ", "")
assert place == "UpperLeftCorner", place
assert loops.MaximumNumberOfLoops == 20 and loops.TrustedOnly == 1
surface = loops.Input
loops.MaximumNumberOfLoops = 0
loops.UpdatePipeline()
pipelines.live_change(loops.GetGlobalID())
assert text() == "77 of 77 loops shown", text()
simple.Delete(loops)
loop_views.forget()
assert not [name for name, _ in simple.GetSources() if name.endswith(loop_views.COUNT)]

# What a script asks for it gets, all of it; a filter of the menu starts as the button's.
(everything,) = pipelines.surface_to_loops(surface)
assert everything.MaximumNumberOfLoops == 0 and everything.TrustedOnly == 0
waiting = simple.ChokingLoops(Input=surface)
pipelines.first_values(waiting.GetGlobalID())
assert waiting.MaximumNumberOfLoops == 20 and waiting.TrustedOnly == 1
given = simple.ChokingLoops(Input=surface, MaximumNumberOfLoops=3)
pipelines.first_values(given.GetGlobalID())
assert given.MaximumNumberOfLoops == 3
print("the significant loops first")
