"""A button of the toolbar in the real ParaView, then Ctrl+Z as often as one likes: what a pipeline has
built is not taken apart piece by piece, which left charts of the wrong columns and ended ParaView 5.11
as soon as a table's view was taken back.

The pictures of the window before and after are kept beside the test's other output.
"""

import os
from pathlib import Path

import numpy
from shared_data import shared_data
from window_play import button, complaints, pixels_of_view, play

output = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "UndoWindow"
views = {}
for name, keys in (("built", ("Escape",)), ("undone", ("ctrl+z",) * 8)):
    log, picture = play(name, shared_data("molecules/1hew/1hew.pqr"), [button(7)], (), output / name, keys)
    assert "Success =  true" in log, f"{name}: the session could not be played: {log[-2000:]}"
    assert not complaints(log), f"{name}: {complaints(log)}"
    views[name] = pixels_of_view(picture)
    print(f"{name}: {picture}", flush=True)
differ = float(numpy.mean(numpy.abs(views["built"] - views["undone"]).max(axis=2) > 24))
print(f"{100 * differ:.2f} % of the view differ")
assert differ < 0.01, "Ctrl+Z has taken something out of the view"
