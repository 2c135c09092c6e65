"""The slider of a level in the real ParaView, held and moved: Map Surface with choking loops of its surface. While it is held, the contour of each level is drawn soon, and the loops are hidden; when it is released,
they are found at the new level. The histogram above the slider sets the level as well, and the button beside it the automatic one. How long a contour takes until it is drawn is printed.
"""

import os
import re
from pathlib import Path

from shared_data import shared_data
from window_play import NOTHING_TO_APPLY, PANEL, coloured_fraction, complaints, play

MAP = shared_data("maps/emd_5043.map")
SLIDER = PANEL + "Level/DoubleRangeWidget/Slider"
HISTOGRAM, AUTOMATIC = PANEL + "Level/LevelHistogram", PANEL + "Level/UseAutomaticLevel"
PAUSE = ("pqClientMainWindow", "pause", "3000")
MIDDLE = 31  # of the slider in pixels, where its handle then is


def held():
    """Presses the handle and moves it twice: button, buttons, modifiers, and the place."""
    return [(SLIDER, "set_int", "50"), PAUSE, PAUSE, (SLIDER, "mousePress", f"1,1,0,{MIDDLE},12"), PAUSE,
            *[step for x in (1, 2) for step in ((SLIDER, "mouseMove", f"1,1,0,{MIDDLE + x},12"), PAUSE)]]


def released():
    return [*held(), (SLIDER, "mouseRelease", f"1,0,0,{MIDDLE + 2},12"), PAUSE, PAUSE, PAUSE, NOTHING_TO_APPLY]


def by_histogram():
    """Drags the line in the histogram, then returns to the automatic level."""
    return [PAUSE, (AUTOMATIC, "check enabled", "false"), (HISTOGRAM, "mousePress", "1,1,0,60,20"), PAUSE, (HISTOGRAM, "mouseMove", "1,1,0,80,20"), PAUSE,
            (HISTOGRAM, "mouseRelease", "1,0,0,80,20"), PAUSE, PAUSE, (AUTOMATIC, "check enabled", "true"), (AUTOMATIC, "activate", ""), PAUSE, PAUSE,
            NOTHING_TO_APPLY]


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
assert all(float(line[-1]) > 0.0 for line in previews), f"drawn before it was asked for: {previews}"
assert coloured < 0.001, f"loops are drawn on {coloured} of the view while the slider is held"
lines, coloured = session("MapSurface_released", released())
assert re.match(r"loops \d+ of \d+ loops shown", lines[-1]), lines[-1]
assert coloured > 0.002, f"loops are drawn on {coloured} of the view only"
lines, coloured = session("MapSurface_histogram", by_histogram())
found = [float(line.split()[1]) for line in lines if line.startswith("level")]
ranges = [list(map(float, line.split()[1:])) for line in lines if line.startswith("range")]
assert found[1] > 1.2 * found[0], f"the histogram does not set the level: {found}"
assert abs(found[-1] - found[0]) < 1e-6 * found[0], f"the button does not return to the automatic level: {found}"
low, high, all_low, all_high = ranges[-1]
assert all_low < low < found[0] < high < all_high, f"the slider covers {ranges}"
