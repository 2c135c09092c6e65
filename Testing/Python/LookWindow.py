"""The look of the view in the real ParaView, by the menu Isthmus: a map's surface on white, with scale bar and soft
shadows; the bar stays in its place when the mouse turns and zooms the view.

The picture of the window is kept beside the test's other output, for people to look at.
"""

import os
import subprocess
import time
from pathlib import Path

from shared_data import shared_data
from window_play import button, complaints, drag, pixels_of_view, play

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "LookWindow"
BAR = "pqClientMainWindow/menubar"
PAUSE = ("pqClientMainWindow", "pause", "2000")


def look(name):
    return [(BAR, "activate", "menuIsthmus"), (BAR + "/menuIsthmus", "activate", "Look_of_the_view"),
            (BAR + "/menuIsthmus/Look_of_the_view", "activate", f"Look_{name}"), PAUSE]


def picture_of(name):
    path = FOLDER / f"{name}.png"
    subprocess.run(["import", "-window", "root", str(path)], check=True, timeout=60)
    return path


def bar_of(path):
    """(row, first, last) of the scale bar: the longest dark run of pixels in the lowest part of the view, whose rows go
    upwards."""
    view = pixels_of_view(path)[:, :600].max(axis=2)
    best = (0, 0, 0)
    for row in range(60):
        begin = None
        for column, dark in enumerate([*(view[row] < 90), False]):
            if dark and begin is None:
                begin = column
            elif not dark and begin is not None:
                best = max(best, (column - begin, row, begin))
                begin = None
    return best[1], best[2], best[2] + best[0]


places = []


def settled(name):
    """The bar as soon as a busy machine has drawn it again in its row, at the latest after 20 s."""
    for _ in range(10):
        place = bar_of(picture_of(name))
        if abs(place[0] - places[0][0]) < 4:
            break
        time.sleep(2)
    return place


def turn_and_zoom():
    places.append(bar_of(picture_of("before")))
    drag((700, 500), (900, 560))
    time.sleep(3)
    places.append(settled("turned"))
    subprocess.run(["xdotool", "mousemove", "800", "500", "click", "4", "sleep", "1", "click", "4"], check=True)
    time.sleep(3)


log, picture = play("LookWindow", shared_data("maps/emd_5043.map"),
                    [button(0), PAUSE, *look("white"), *look("scale_bar"), *look("soft_shadows")], (), FOLDER,
                    act=turn_and_zoom)
assert "Success =  true" in log, f"the session could not be played: {log[-2000:]}"
assert not complaints(log), complaints(log)
places.append(bar_of(picture))
white = float((pixels_of_view(picture).min(axis=2) > 250).mean())
print(f"{100 * white:.0f} % of the view are white; scale bar (row, first and last pixel) {places}; {picture}")
assert white > 0.2
for row, first, last in places:
    assert 60 < last - first < 330 and abs(row - places[0][0]) < 4, places
