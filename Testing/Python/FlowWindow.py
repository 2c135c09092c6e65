"""Molecular Flow Surface in the real ParaView: a PDB file opened, the entry of the menu, Apply; then with
time steps, at their first, and played to their last, which is the surface without time steps.

The pictures of the window are kept beside the test's other output; the log must have no warning.
"""

import os
from pathlib import Path

import numpy
from shared_data import shared_data
from window_play import APPLY, PANEL, complaints, entry, pixels_of_view, play

PAUSE = ("pqClientMainWindow", "pause", "5000")
STEPS = (PANEL + "TimeSteps/IntRangeWidget/LineEdit", "set_string", "5")
PLAY = ("pqClientMainWindow/VCRToolbar/1QToolButton3", "activate", "")
MENU = entry("MolecularFlowSurface")

SESSIONS = {"surface": [MENU, APPLY, PAUSE], "first": [MENU, STEPS, APPLY, PAUSE],
            "played": [MENU, STEPS, APPLY, PAUSE, PLAY, PAUSE]}

output = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "FlowWindow"
views = {}
for name, events in SESSIONS.items():
    log, picture = play(name, shared_data("molecules/1hew.pdb"), events, (), output / name)
    assert "Success =  true" in log, f"{name}: the session could not be played: {log[-2000:]}"
    assert not complaints(log), f"{name}: {complaints(log)}"
    views[name] = pixels_of_view(picture)
    bright = float(numpy.mean(views[name].min(axis=2) > 120))
    print(f"{name}: {100 * bright:.1f} % of the view is the surface, {picture}", flush=True)
    assert bright > 0.05, f"{name}: there is no surface in {picture}"


def difference(a, b):
    """Share of the pixels that differ."""
    return float(numpy.mean(numpy.abs(views[a] - views[b]).max(axis=2) > 24))


print(f"differ: last from surface {difference('played', 'surface'):.4f}, "
      f"last from first {difference('played', 'first'):.4f}")
assert difference("played", "surface") < 0.01 < 0.03 < difference("played", "first")
