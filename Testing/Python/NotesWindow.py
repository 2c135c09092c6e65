"""Notes in the real ParaView: a protein without pockets. That the sites are patches of its surface is said in the status bar,
and the window Output Messages stays closed.
"""

import os
from pathlib import Path

from shared_data import shared_data
from window_play import button, complaints, play

from isthmus_plugin import steps

NOTE = "pqClientMainWindow/statusbar/IsthmusNote"
MESSAGES = "pqClientMainWindow/outputWidgetDock"
FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "NotesWindow"

log, picture = play(
    "NotesWindow", shared_data("molecules/1AJJ_pH7_PARSE.pqr"),
    [button(4), ("pqClientMainWindow", "pause", "3000"), (NOTE, "check text", steps.NO_POCKETS),
     (MESSAGES, "check visible", "false")], (), FOLDER)
print(picture)
assert "Success =  true" in log, f"the session could not be played: {log[-2000:]}"
assert not complaints(log), complaints(log)
