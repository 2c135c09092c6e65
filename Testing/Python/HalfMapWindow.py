"""Map Handles with a second half map in the real ParaView, by mouse: the filter from the menu on one half map, then Edit >
Change Input, Other Half, the other half map, OK and Apply. Its bridges get p-values.

The pictures of the window are kept beside the test's other output, for people to look at.
"""

import os
import subprocess
import time
from pathlib import Path

import numpy
from shared_data import shared_data
from window_play import APPLY, STATUS_BAR, complaints, entry, play

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "HalfMapWindow"
# In a window of 1600 x 1000 of ParaView 5.11: the filter in the pipeline browser, the menu Edit and its entry Change
# Input, and in its dialog Other Half, the first source, OK.
FILTER, EDIT, CHANGE_INPUT = (100, 241), (60, 9), (130, 343)
OTHER_HALF, FIRST, OK = (558, 334), (775, 308), (903, 636)
PATIENCE = 60  # seconds, on a machine with other things to do


def window(name):
    subprocess.run(["import", "-window", "root", str(FOLDER / "session" / f"{name}.png")], check=True, timeout=60)


def click(place):
    subprocess.run(["xdotool", "mousemove", *map(str, place), "sleep", "0.5", "click", "1"], check=True)
    time.sleep(2.0)


def results():
    path = FOLDER / "session" / "results.txt"
    return path.read_text().splitlines() if path.exists() else []


def has_p_values():
    return any(line.startswith("True") for line in results())


def act():
    for _ in range(3):  # again where the machine was too busy to heed it
        for place in (FILTER, EDIT, CHANGE_INPUT):
            click(place)
        time.sleep(2)
        window("dialog")
        for place in (OTHER_HALF, FIRST):
            click(place)
        window("chosen")
        click(OK)
        began = time.monotonic()
        while not has_p_values() and time.monotonic() - began < PATIENCE:
            click(STATUS_BAR)
            subprocess.run(["xdotool", "key", "alt+a"], check=True)
            time.sleep(3)
        if has_p_values():
            return
        subprocess.run(["xdotool", "key", "Escape"], check=True)


FOLDER.mkdir(parents=True, exist_ok=True)
content = Path(shared_data("maps/emd_1832.map")).read_bytes()
values = numpy.frombuffer(content[1024:], "<f4")
random = numpy.random.default_rng(1)
for half in (1, 2):
    noisy = values + random.normal(0.0, 0.2 * values.std(), values.size)
    (FOLDER / f"half_{half}.map").write_bytes(content[:1024] + noisy.astype("<f4").tobytes())
log, picture = play("HalfMapWindow", FOLDER / "half_1.map",
                    [entry("MapHandles"), APPLY, ("pqClientMainWindow", "pause", "2000")], (), FOLDER / "session",
                    script=Path(__file__).parent / "half_map_session.py", act=act)
assert "Success =  true" in log, f"the session could not be played: {log[-2000:]}"
assert not complaints(log), complaints(log)
print(results(), picture)
assert results()[0] == "False None", "one half map has no p-values"
assert has_p_values() and float(results()[-1].split()[1]) > 0.9
