"""The button beside Minimum Persistence in the real ParaView: a map, its choking loops by the toolbar, the
button. The panel then has the threshold that the same loops propose in a script, and fewer loops show.

The pictures of the window are kept beside the test's other output; the log must have no warning.
"""

import os
from pathlib import Path

from paraview import servermanager, simple
from shared_data import shared_data
from window_play import PANEL, button, coloured_fraction, complaints, play

from isthmus_plugin import pipelines

MAP = shared_data("maps/emd_1832.map")
THRESHOLD = PANEL + "MinimumPersistence/"
PAUSE = ("pqClientMainWindow", "pause", "2000")

_, loops = pipelines.map_to_loops(simple.OpenDataFile(str(MAP)))
lines = servermanager.Fetch(simple.OutputPort(loops, 0), 0, 0)
told = lines.GetFieldData().GetArray("ProposedThreshold")
inside, outside = told.GetTuple(0), told.GetTuple(1)
assert inside[1] > 0.0 and outside[1] > 0.0, "each side of this map has a gap"
expected = repr(min(inside[0], outside[0]))  # the field holds all digits, and shows some

SESSIONS = {
    "given": [button(2), PAUSE],
    "proposed": [button(2), PAUSE, (THRESHOLD + "UseProposedThreshold", "activate", ""), PAUSE,
                 (THRESHOLD + "DoubleRangeWidget/DoubleLineEdit", "check text", expected)]}
output = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "ThresholdWindow"
coloured = {}
for name, events in SESSIONS.items():
    log, picture = play(name, MAP, events, (), output / name)
    assert "Success =  true" in log, f"{name}: the session could not be played: {log[-2000:]}"
    assert not complaints(log), f"{name}: {complaints(log)}"
    coloured[name] = coloured_fraction(picture)
    print(f"{name}: {100 * coloured[name]:.2f} % of the view are loops, {picture}", flush=True)
assert 0.001 < coloured["proposed"] < 0.8 * coloured["given"]
