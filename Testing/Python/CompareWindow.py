"""Isthmus > Compare in the real ParaView: a map's surface and the same coloured by curvature beside each other. Turning one
by the mouse turns the other.

Pictures of the window are kept beside the test's other output.
"""

import os
import time
from pathlib import Path

import numpy
from shared_data import shared_data
from window_play import button, complaints, drag, pixels_of_window, play

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "CompareWindow"
BAR = "pqClientMainWindow/menubar"
PAUSE = ("pqClientMainWindow", "pause", "3000")
COMPARE = [(BAR, "activate", "menuIsthmus"), (BAR + "/menuIsthmus", "activate", "Compare"), PAUSE]
LEFT, RIGHT = (slice(260, 900), slice(400, 900)), (slice(260, 900), slice(1000, 1500))
pictures = {}


def window(name):
    pictures[name] = pixels_of_window(FOLDER / f"{name}.png")


def turn():
    window("before")
    drag((650, 500), (760, 560))
    time.sleep(3)
    window("turned")


def coloured(part):
    pixels = pictures["before"][part]
    return float((pixels.max(axis=2) - pixels.min(axis=2) > 90).mean())


def moved(part):
    return float((numpy.abs(pictures["before"][part] - pictures["turned"][part]).max(axis=2) > 24).mean())


log, _ = play("CompareWindow", shared_data("maps/emd_1832.map"), [button(1), PAUSE, *COMPARE], (), FOLDER, act=turn)
assert "Success =  true" in log, f"the session could not be played: {log[-2000:]}"
assert not complaints(log), complaints(log)
found = {"coloured": (coloured(LEFT), coloured(RIGHT)), "moved": (moved(LEFT), moved(RIGHT))}
print(found)
assert found["coloured"][0] < 0.002 < found["coloured"][1], f"the curvature is not in the right view alone: {found}"
assert min(found["moved"]) > 0.03, f"the cameras are not linked: {found}"
