"""Isthmus > Save figure in the real ParaView, by mouse and keys: a torus with its loops, saved with a given width on white.
The picture has that size and background and the loops, but not the text with their number.

Pictures of the window are kept beside the test's other output.
"""

import os
import subprocess
import time
from pathlib import Path

import numpy
from shared_data import shared_data
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from window_play import button, complaints, place_of, play

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "FigureWindow"
FIGURE = FOLDER / "loops.png"
PAUSE = ("pqClientMainWindow", "pause", "3000")


def xdotool(*arguments):
    subprocess.run(["xdotool", *map(str, arguments)], check=True)


def until(what, reached, act=None):
    """Acts, again where a busy window did not heed it, until that is reached."""
    for _ in range(5):
        act() if act else None
        for _ in range(20):
            time.sleep(0.5)
            if reached():
                return
    subprocess.run(["import", "-window", "root", str(FOLDER / "failed.png")], check=True, timeout=60)
    raise AssertionError(f"{what} was not reached")


def menu():
    """Isthmus > Save figure, by its letters."""
    xdotool("mousemove", 300, 987, "click", 1, "key", "Escape", "sleep", 1, "key", "alt+i", "sleep", 1, "key", "Up", "sleep", 1)
    for _ in range(len(BELOW)):
        xdotool("key", "Up", "sleep", 0.5)
    xdotool("key", "Return")


BELOW = ("Show helpers in the pipeline browser",)  # entries of the menu below Save figure


def save():
    until("the dialog", lambda: place_of("Save Figure"), menu)
    # Width and resolution are the first fields, the background is the third.
    xdotool("sleep", 1, "key", "ctrl+a", "type", "40")
    xdotool("key", "Tab", "sleep", 0.5, "key", "ctrl+a", "type", "254")
    xdotool("key", "Tab", "sleep", 0.5, "key", "Down", "sleep", 0.5)
    subprocess.run(["import", "-window", "root", str(FOLDER / "dialog.png")], check=True, timeout=60)
    xdotool("key", "Return", "sleep", 3, "key", "ctrl+a", "type", "--delay", 20, str(FIGURE))
    xdotool("sleep", 1, "key", "Return")
    until("the figure", lambda: FIGURE.exists() and FIGURE.with_suffix(".svg").exists())
    time.sleep(3)


def pixels(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int).reshape(height, width, 3)


FOLDER.mkdir(parents=True, exist_ok=True)
for old in FOLDER.glob("loops.*"):
    old.unlink()
log, picture = play("FigureWindow", shared_data("surfaces/torus.obj"), [button(5), PAUSE], (), FOLDER, act=save)
assert "Success =  true" in log, f"the session could not be played: {log[-2000:]}"
assert not complaints(log), complaints(log)
saved, vectors = pixels(FIGURE), FIGURE.with_suffix(".svg").read_text()
coloured = float((saved.max(axis=2) - saved.min(axis=2) > 90).mean())
print(f"{saved.shape}, {100 * coloured:.2f} % coloured, {FIGURE}, {picture}")
assert saved.shape[1] == 400, f"40 mm at 254 dots per inch are 400 pixels, not {saved.shape[1]}"
assert (saved[[0, 0, -1, -1], [0, -1, 0, -1]] > 250).all(), "the background is not white"
assert coloured > 0.002, "the loops are missing"
assert 'width="40mm"' in vectors and "loops shown" not in vectors
