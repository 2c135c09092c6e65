"""Sliders of choking loops in the real ParaView, without Apply: a map of GroEL, its loops by the toolbar, the slider
of their number and that of their persistence.

The significant loops are shown first, with their number and that of all; each move of a slider is in the picture
soon, Apply has nothing to do then, and the number follows. How long that takes is printed. A filter from the menu starts with the same loops.
"""

import os
import re
from pathlib import Path

from shared_data import shared_data
from window_play import APPLY, MENU, NOTHING_TO_APPLY, PANEL, button, complaints, entry, play

MAP = shared_data("maps/emd_5043.map")
NUMBER = PANEL + "MaximumNumberOfLoops/IntRangeWidget/"
PERSISTENCE = PANEL + "MinimumPersistence/DoubleRangeWidget/Slider"
PAUSE = ("pqClientMainWindow", "pause", "2000")

MOVES = [(NUMBER + "Slider", "set_int", "40"), PAUSE, NOTHING_TO_APPLY,
         (NUMBER + "Slider", "set_int", "1000"), PAUSE, NOTHING_TO_APPLY,
         (NUMBER + "LineEdit", "check text", "77"),  # as many as there are
         (PERSISTENCE, "set_int", "60"), PAUSE, NOTHING_TO_APPLY]


def lines_of(folder):
    return [line.split(" ", 2) for line in (folder / "lively.txt").read_text().splitlines()]


def counts(lines):
    """What the view has said, each change once."""
    said = [text.split(" | ")[1] for _, what, text in lines if what == "count"]
    return [text for i, text in enumerate(said) if i == 0 or text != said[i - 1]]


def delays(lines):
    """Seconds from each change, as it is applied, to the begin of the picture with another number of loops, and to
    its end: a program that draws without a graphics card takes most of it."""
    found, changed, begun, number = [], None, None, None
    for moment, what, text in lines:
        if what == "change":
            changed = float(moment)
        elif what == "drawing":
            begun = float(moment)
        elif what == "drawn":
            if changed is not None and text != number:
                found.append((begun - changed, float(moment) - changed))
                changed = None
            number = text
    return found


def session(name, events):
    folder = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "LiveWindow" / name
    log, picture = play(name, MAP, events, (), folder, script=Path(__file__).parent / "live_session.py")
    assert "Success =  true" in log, f"{name}: the session could not be played: {log[-2000:]}"
    assert not complaints(log), f"{name}: {complaints(log)}"
    lines = lines_of(folder)
    print(f"{name}: {counts(lines)}, {picture}", flush=True)
    return lines


moved = session("sliders", [button(2), PAUSE, *MOVES])
said = counts(moved)
assert said[:3] == ["20 of 77 loops shown", "40 of 77 loops shown", "77 of 77 loops shown"], said
assert int(re.match(r"(\d+) of \1 ", said[-1])[1]) < 77, said
seconds = delays(moved)
print("from a change to the begin of the picture and to its end:",
      *[f"{begun:.2f} {drawn:.2f} s;" for begun, drawn in seconds])
assert len(seconds) == 3, seconds

by_hand = counts(session("by_hand", [button(0), entry("ChokingLoops"), APPLY, PAUSE]))
assert re.match(r"20 of \d+ loops shown", by_hand[0]), by_hand
