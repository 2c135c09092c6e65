"""The table of choking loops and the panel in the real ParaView, by mouse and keys: a click on the narrowest loop, also after
undo and redo; only that loop, all loops; the box of a kind, and which properties the panel shows.

Pictures of the window are kept beside the test's other output.
"""

import os
import subprocess
import time
from pathlib import Path

from shared_data import shared_data
from window_play import APPLY, PANEL, button, click, complaints, pixels_of_window, place_of_button, play

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "LoopTableWindow"
SCRIPT = Path(__file__).parent / "loop_table_session.py"
FIRST_ROW, SECOND_ROW = (400, 823), (400, 847)  # of the table below the view, in a window of 1600 x 1000
ONLY, ALL = 11, 12  # buttons
SHOWN = ("MaximumRadius", "IncludeHandles", "IncludeTunnels", "IncludeBottlenecks", "MaximumNumberOfLoops")
ADVANCED = ("MaximumRadiusUnit", "AlwaysIncludeHandles", "SampleSpacing", "Side")
TUNNELS = PANEL + "IncludeTunnels/CheckBox"
PAUSE = ("pqClientMainWindow", "pause", "2000")


def drawn():
    """[(distance of the camera, number of lines, radii)] of the drawings that differ."""
    path = FOLDER / "shown.txt"
    lines = [line.split(" | ") for line in path.read_text(encoding="utf-8").splitlines()] if path.exists() else []
    return [(float(distance), int(count), [float(each) for each in radii.split()]) for distance, count, radii in lines]


def last():
    return drawn()[-1] if drawn() else (0.0, 0, [])


def until(what, act, reached):
    """Acts, again where a busy window did not heed it, until that is drawn."""
    for _ in range(4):
        act()
        for _ in range(20):
            time.sleep(0.5)
            if reached(*last()):
                pixels_of_window(FOLDER / f"{what.replace(' ', '_')}.png")
                return last()
    pixels_of_window(FOLDER / "failed.png")
    raise AssertionError(f"{what}: {last()}")


def key(name):
    click(*FIRST_ROW)
    subprocess.run(["xdotool", "key", name], check=True)
    time.sleep(2)


def act():
    assert [count for _, count, _ in drawn()] == [2, 1, 2], f"a handle and a tunnel, the handle, both; not {drawn()}"
    far = last()[0]
    near, _, narrow = until("narrowest", lambda: click(*FIRST_ROW), lambda distance, count, radii: len(radii) == 1)
    _, _, wide = until("second", lambda: click(*SECOND_ROW), lambda distance, count, radii: radii not in ([], narrow))
    assert narrow < wide, f"the narrowest comes first: {narrow}, {wide}"
    assert near < far, f"the camera stays at {far}"
    until("only selected", lambda: click(*place_of_button(ONLY)), lambda distance, count, radii: count == 1)
    until("all", lambda: click(*place_of_button(ALL)), lambda distance, count, radii: count == 2)
    for name in ("ctrl+z", "ctrl+shift+z"):
        key(name)
    until("after undo", lambda: click(*SECOND_ROW), lambda distance, count, radii: radii == wide)
    until("after undo narrowest", lambda: click(*FIRST_ROW), lambda distance, count, radii: radii == narrow)


events = [APPLY, button(5), PAUSE,
          *((PANEL + name, "check visible", "true") for name in SHOWN),
          *((PANEL + name, "check visible", "false") for name in ADVANCED),
          (TUNNELS, "set_boolean", "false"), PAUSE, (TUNNELS, "set_boolean", "true"), PAUSE]
log, _ = play("LoopTableWindow", shared_data("surfaces/torus.obj"), events, (), FOLDER, script=SCRIPT, act=act)
assert "Success =  true" in log, f"the session could not be played: {log[-3000:]}"
assert not complaints(log), complaints(log)
