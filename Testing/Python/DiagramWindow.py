"""The persistence diagram in the real ParaView, by mouse: a torus, its choking loops, their diagram as a chart. The
point of the tunnel is selected in the chart, and its loop and ball light up in the view; the loop of the handle is
selected in the view, and its point lights up in the chart.

Pictures of the window are kept beside the test's other output.
"""

import os
import subprocess
import time
from pathlib import Path

import numpy
from paraview import simple
from shared_data import shared_data
from window_play import button, click, complaints, drag, pixels_of_window, play

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "DiagramWindow"
PAUSE = ("pqClientMainWindow", "pause", "2000")
# Places in a window of 1600 x 1000: the button of the chart that selects a rectangle (ParaView 6 has one button more before
# it), rectangles around the point of the tunnel and around a piece of the loop of the handle, the render view and the chart.
RECTANGLE = (1253 if simple.GetParaViewVersion().major >= 6 else 1236, 183)
TUNNEL, HANDLE, EMPTY = ((1130, 230), (1190, 300)), ((565, 605), (620, 655)), (450, 900)
VIEW, CHART = (slice(210, 950), slice(310, 1060)), (slice(205, 940), slice(1100, 1590))
POINT = (slice(640, 710), slice(1130, 1190))  # of the handle
VERMILION, BLUE = (213, 94, 0), (0, 114, 178)


def window(name):
    return pixels_of_window(FOLDER / f"{name}.png")


def count(pixels, part, colour, slack=40):
    return int((abs(pixels[part] - numpy.array(colour)) < slack).all(axis=-1).sum())


def lit(pixels, part):
    """In the colour of the selection, shaded or not, also seen through the ball."""
    red, green, blue = numpy.moveaxis(pixels[part], 2, 0)
    return int(((red > 110) & (red > green + 25) & (blue > green - 20)).sum())


def yellow(pixels):
    red, green, blue = numpy.moveaxis(pixels[VIEW], 2, 0)
    return int(((red > blue + 25) & (abs(red - green) < 30)).sum())


def selected():
    path = FOLDER / "selected.txt"
    return [line.split("|") for line in path.read_text().splitlines()] if path.exists() else []


def select(what, act, where, other=()):
    """Acts, again where a busy window did not heed it, until something is selected there, other than the features
    `other`: a slow window reports the previous selection once more."""
    for _ in range(4):
        before = len(selected())
        act()
        for _ in range(20):
            time.sleep(0.5)
            found = [line for line in selected()[before:] if line[0] == where and line[1] not in ("[]", *other)]
            if found:
                return found[-1]
    window("failed")
    raise AssertionError(f"{what} was not selected: {selected()}")


def drawn(name, part, least):
    """The window as soon as the selection is seen in that part of it, at the latest after 20 s."""
    for _ in range(10):
        time.sleep(2)
        pixels = window(name)
        if lit(pixels, part) > least:
            break
    return pixels


def in_chart():
    click(*RECTANGLE)
    time.sleep(1)
    drag(*TUNNEL)


def in_view():
    click(*EMPTY)
    subprocess.run(["xdotool", "key", "s"], check=True)
    time.sleep(1.5)
    drag(*HANDLE)


found = {}


def act():
    pixels = window("first")
    for colour in (VERMILION, BLUE):
        assert count(pixels, CHART, colour, 60) > 20, "a kind has no point in its colour"
    found["lit before"], found["yellow before"] = lit(pixels, VIEW), yellow(pixels)
    found["tunnel"] = select("the tunnel", in_chart, "chart")
    pixels = drawn("tunnel", VIEW, found["lit before"] + 100)
    found["loop"], found["ball"] = lit(pixels, VIEW), yellow(pixels)
    found["handle"] = select("the handle", in_view, "view", other=[found["tunnel"][1]])
    found["point"] = lit(drawn("handle", POINT, 20), POINT)


log, _ = play("DiagramWindow", shared_data("surfaces/torus.obj"), [button(5), PAUSE, button(6), PAUSE], (), FOLDER,
              script=Path(__file__).parent / "diagram_session.py", act=act)
assert "Success =  true" in log, f"the session could not be played: {log[-2000:]}"
assert not complaints(log), complaints(log)
print(found)
assert found["tunnel"][1] == found["tunnel"][2] and found["tunnel"][3] == "1", found
assert found["handle"][1] == found["handle"][2] and found["handle"][3] == "1", found
assert found["tunnel"][1] != found["handle"][1], found
assert found["loop"] > found["lit before"] + 100 and found["ball"] > found["yellow before"] + 5000 and found["point"] > 20, found
