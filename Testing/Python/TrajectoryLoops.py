"""pipelines.trajectory_to_loops: the tunnel of a ring of atoms that widens and narrows is one track of known radii."""

import math
import os
from pathlib import Path

import numpy
import ring_models
from paraview import simple

from isthmus_plugin import pipelines, track_views  # there once paraview.simple has loaded the plugin

FRAMES = 5


def refused(call, words):
    try:
        call()
    except ValueError as error:
        assert words in str(error), error
    else:
        raise AssertionError(f"not refused: {words}")


def tunnel_of(tracks, expected):
    """The radii of the tunnel, which is narrower than the ring by the half thickness of its surface."""
    series = {name: radii for name, _, radii in track_views.series_of(tracks)}
    tunnels = [name for name in series if name.startswith("tunnel ")]
    assert len(tunnels) == 1 and any(name.startswith("handle ") for name in series), series
    inset = expected - numpy.array(series[tunnels[0]])
    print(tunnels[0], series[tunnels[0]], "narrower than the ring by", inset)
    assert numpy.ptp(inset) < 0.35 and 1.7 < inset.mean() < 2.7, inset


folder = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "TrajectoryLoops"
folder.mkdir(parents=True, exist_ok=True)
ring_models.write(folder / "ring.pdb", FRAMES)
source = simple.OpenDataFile(str(folder / "ring.pdb"))
assert track_views.times_of(source) == list(range(FRAMES))
loops, tracks = pipelines.trajectory_to_loops(source)
tunnel_of(tracks, ring_models.radii(FRAMES))
names = {name for name, _ in simple.GetSources()}
assert {"ring surface", "ring loops", "ring loops over time"} <= names, names

# The display: the paths in the view and the lines of the chart have one colour for each track.
view = simple.CreateView("RenderView")
simple.AssignViewToLayout(view=view)
paths = pipelines.show(loops, tracks, view=view, tables=True)
chart = next(each for each in simple.GetViews() if each.SMProxy.GetXMLName() == "XYChartView")
lines = chart.Representations[0]
assert (chart.LeftAxisTitle, chart.BottomAxisTitle) == ("Radius (Å)", "Model (the first is 0)"), chart.BottomAxisTitle
shown = [name for name, _, _ in track_views.series_of(tracks)]
labels = dict(zip(lines.SeriesLabel[::2], lines.SeriesLabel[1::2]))
assert [labels[column] for column in lines.SeriesVisibility] == shown, labels
colours = {row[0]: [float(x) for x in row[1:]] for row in zip(*(lines.SeriesColor[i::4] for i in range(4)))}
legend = dict(zip(paths.LookupTable.Annotations[1::2], zip(*(paths.LookupTable.IndexedColors[i::3] for i in range(3)))))
for column in lines.SeriesVisibility:
    assert math.dist(colours[column], legend[labels[column]]) < 1e-6, column
# The legend of the chart is above the lines.
highest = max(radius for _, _, radii in track_views.series_of(tracks) for radius in radii if radius == radius)
assert chart.LeftAxisRangeMaximum > highest * (1.0 + 0.05 * len(shown)), chart.LeftAxisRangeMaximum

# Of too many frames, some; of a map made from the frames, the molecule's.
_, fewer = pipelines.trajectory_to_loops(source, frames=3)
tunnel_of(fewer, ring_models.radii(FRAMES)[::2])
density = next(each for (name, _), each in simple.GetSources().items() if name == "ring density")
fits = pipelines._fits("trajectory_to_loops")
assert fits(source) and not fits(density) and not fits(tracks)

still = simple.Sphere()
refused(lambda: pipelines.trajectory_to_loops(still), "several time steps")
