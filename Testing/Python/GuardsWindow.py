"""Faults of ParaView's own window from which the plugin keeps it (Plugin/WindowGuards.h), in the real ParaView by mouse and
keys. Escape after the view in which a selection was begun was deleted: S over the view, Edit > Reset Session, Escape. And
the view of a table that is drawn after the layout has dropped it. ParaView alone ends with both.

Pictures of the window are kept beside the test's other output.
"""

import os
import subprocess
import time
from pathlib import Path

from shared_data import shared_data
from window_play import STATUS_BAR, click, complaints, place_of, play

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "GuardsWindow"
QUESTION = "Delete All"  # of ParaView, before it resets the session
VIEW = (800, 600)
PATIENCE = 60  # seconds, on a machine with other things to do


def key(name):
    subprocess.run(["xdotool", "key", name], check=True)
    time.sleep(2)


def until(reached):
    began = time.monotonic()
    while not reached() and time.monotonic() - began < PATIENCE:
        time.sleep(1)
    assert reached()


def act():
    click(*VIEW)
    key("s")
    click(*STATUS_BAR)
    key("ctrl+r")
    until(lambda: place_of(QUESTION))
    key("Return")
    until(lambda: not place_of(QUESTION))
    time.sleep(3)
    click(*STATUS_BAR)
    key("Escape")


SESSIONS = {"escape": {"act": act}, "table": {"script": Path(__file__).parent / "guards_session.py"}}
for name, given in SESSIONS.items():
    log, picture = play(name, shared_data("surfaces/torus.obj"), [], (), FOLDER / name, **given)
    assert not complaints(log), f"{name}: {complaints(log)}"
    print(f"{name}: {picture}", flush=True)
