"""The slider of a level in the real ParaView, held and moved: Map Surface with choking loops of its surface. While it is held, the contour of each level is drawn soon, and the loops are hidden; when it is released,
they are found at the new level. How long a contour takes is printed: no more than PATIENCE seconds until it is drawn.
"""

import os
import re
from pathlib import Path

from shared_data import shared_data
from window_play import NOTHING_TO_APPLY, PANEL, coloured_fraction, complaints, play

PATIENCE = 2.0  # on a machine with other things to do
MAP = shared_data("maps/emd_5043.map")
SLIDER = PANEL + "Level/DoubleRangeWidget/Slider"
PAUSE = ("pqClientMainWindow", "pause", "3000")
MIDDLE = 31  # of the slider in pixels, where its handle then is


def held():
    """Presses the handle and moves it twice: button, buttons, modifiers, and the place."""
    return [(SLIDER, "set_int", "50"), PAUSE, PAUSE, (SLIDER, "mousePress", f"1,1,0,{MIDDLE},12"), PAUSE,
            *[step for x in (1, 2) for step in ((SLIDER, "mouseMove", f"1,1,0,{MIDDLE + x},12"), PAUSE)]]


def released():
    return [*held(), (SLIDER, "mouseRelease", f"1,0,0,{MIDDLE + 2},12"), PAUSE, PAUSE, PAUSE, NOTHING_TO_APPLY]


def session(name, events):
    folder = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "LevelWindow" / name
    log, picture = play(name, MAP, events, (), folder, script=Path(__file__).parent / "level_session.py")
    assert "Success =  true" in log, f"{name}: the session could not be played: {log[-2000:]}"
    assert not complaints(log), f"{name}: {complaints(log)}"
    lines = (folder / "level.txt").read_text().splitlines()
    print(name, picture, *lines, sep="\n  ", flush=True)
    return lines, coloured_fraction(picture)


lines, coloured = session("MapSurface_held", held())
previews = [line.split() for line in lines if line.startswith("preview")]
levels = [float(line[1]) for line in previews]
assert len(levels) >= 2 and levels[-1] > levels[0], levels
assert all(line[2:-1] == ["MapSurface", "TextSource"] for line in previews), previews  # the contour, and no loops
assert max(float(line[-1]) for line in previews) < PATIENCE, previews
assert coloured < 0.001, f"loops are drawn on {coloured} of the view while the slider is held"
lines, coloured = session("MapSurface_released", released())
assert re.match(r"loops \d+ of \d+ loops shown", lines[-1]), lines[-1]
assert coloured > 0.002, f"loops are drawn on {coloured} of the view only"
