"""The pipeline browser in the real ParaView after a button: at most five entries for the button, none twice, helpers only if
the menu asks for them; a click in the table neither shows the panel of a helper nor asks for Apply.

Pictures of the window are kept beside the test's other output.
"""

import os
import sys
import time
from pathlib import Path

import numpy
from shared_data import shared_data
from window_play import APPLY, VERSION, asks_for_apply, button, click, complaints, pixels_of_window, play

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "BrowserWindow"
SCRIPT = Path(__file__).parent / "browser_session.py"
BAR = "pqClientMainWindow/menubar"
PAUSE = ("pqClientMainWindow", "pause", "3000")
HELPERS = [(BAR, "activate", "menuIsthmus"), (BAR + "/menuIsthmus", "activate", "Show_helpers"), PAUSE]
# Of the pipeline browser, in a window of 1600 x 1000: the first of its lines, and the height of each.
TOP, LINE, LINES = 154 if VERSION > (5, 12) else 163, 22, 12
NAMES = (slice(TOP, TOP + LINES * LINE), slice(24, 280))
ROW_BESIDE, ROW_BELOW = (1200, 288), (400, 823)  # rows of the table to the right of a view, and of the table below it


def window(name):
    return pixels_of_window(FOLDER / f"{name}.png")


def entries(pixels):
    """The number of lines with text, which is dark, or white on the blue of the selection."""
    names = pixels[NAMES]
    dark = (names.max(axis=2) < 90).sum(axis=1) > 3
    blue = ((names[..., 2] > 180) & (names[..., 0] < 90)).sum(axis=1) > 60
    white = blue & ((names.min(axis=2) > 200).sum(axis=1) > 3)
    # Without what reaches over from the line above or below.
    return int((dark | white).reshape(LINES, LINE)[:, 5:-5].any(axis=1).sum())


def session(name, data, events, row):
    found = {}

    def act():
        pixels = window(f"{name}_built")
        found["entries"], found["apply"] = entries(pixels), asks_for_apply(pixels)
        click(*row)
        for _ in range(20):
            time.sleep(1)
            lines = (FOLDER / name / "active.txt").read_text().splitlines()
            if any(line.startswith("selected") for line in lines):
                break
        time.sleep(4)
        pixels = window(f"{name}_clicked")
        found["apply after a click"] = asks_for_apply(pixels)
        found["active"] = (FOLDER / name / "active.txt").read_text().splitlines()[-1]

    log, _ = play(name, shared_data(data), [*events, PAUSE], (), FOLDER / name, script=SCRIPT, act=act)
    print(f"{name}: {found}", flush=True)
    assert "Success =  true" in log, f"{name}: the session could not be played: {log[-2000:]}"
    assert not complaints(log), f"{name}: {complaints(log)}"
    return found


def check(name, data, events, row, most, active):
    found = session(name, data, events, row)
    assert 2 < found["entries"] <= most, found
    assert not found["apply"] and not found["apply after a click"], found
    assert found["active"].endswith(active), found
    return found["entries"]


# Lines of the server, the file and its outputs (of a molecule also the cartoon), and at most five of the button.
SESSIONS = {
    "pockets": ("molecules/1hew.pdb", [APPLY, button(7)], ROW_BESIDE, 5 + 5, "MolecularPockets"),
    "loops": ("surfaces/torus.obj", [button(5)], ROW_BELOW, 2 + 5, "ChokingLoops"),
    "sites": ("molecules/1hew/1hew.pqr", [button(4)], ROW_BELOW, 4 + 5, "BindingSitesInPockets"),
    "curvature": ("maps/emd_5043.map", [button(1)], (400, 600), 2 + 5, "CurvatureOnSurface"),
}
FOLDER.mkdir(parents=True, exist_ok=True)
counts = {}
for session_name, arguments in SESSIONS.items():
    if len(sys.argv) < 2 or session_name in sys.argv[1:]:
        counts[session_name] = check(session_name, *arguments)
if "loops" in counts:
    source, events, row, *_ = SESSIONS["loops"]
    shown = session("helpers", source, [*events, *HELPERS], row)
    assert shown["entries"] > counts["loops"], "the menu does not show the helpers"
