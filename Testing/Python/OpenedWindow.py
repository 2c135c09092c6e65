"""A map and a molecule opened by keys in the real ParaView, and Apply: the surface of the map with its box, the cartoon of
the molecule, on a light background. With the settings switched off, ParaView's own displays and background.

Pictures of the window are kept beside the test's other output.
"""

import os
import subprocess
import sys
import time
from pathlib import Path

from shared_data import shared_data
from window_play import STATUS_BAR, click, complaints, pixels_of_view, place_of, play

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "OpenedWindow"
SCRIPT = Path(__file__).parent / "opened_session.py"
PAUSE = ("pqClientMainWindow", "pause", "1000")


def shown(name):
    path = FOLDER / name / "shown.txt"
    return path.read_text().splitlines()[-1] if path.exists() else ""


def open_file(name, path, reached):
    """Ctrl+O, the path, Enter, and Apply; again where a busy window did not heed it."""
    for _ in range(4):
        click(*STATUS_BAR)
        subprocess.run(["xdotool", "key", "ctrl+o"], check=True)
        for _ in range(20):
            time.sleep(0.5)
            if place_of("Open File"):
                break
        else:
            continue
        time.sleep(2)
        subprocess.run(["xdotool", "type", "--delay", "20", str(path)], check=True)
        subprocess.run(["xdotool", "sleep", "1", "key", "Return"], check=True)
        for _ in range(8):
            time.sleep(3)
            click(*STATUS_BAR)
            subprocess.run(["xdotool", "key", "alt+a"], check=True)
            time.sleep(3)
            if reached(shown(name)):
                return


def session(name, data, expected, least, setting=True):
    os.environ["ISTHMUS_SESSION_SETTING"] = "1" if setting else "0"
    log, picture = play(name, "", [("pqClientMainWindow/propertiesDock/propertiesPanel/Accept", "check enabled", "false"), PAUSE],
                        (), FOLDER / name, script=SCRIPT,
                        act=lambda: open_file(name, shared_data(data), lambda line: line == expected))
    print(f"{name}: {shown(name)}, {picture}", flush=True)
    assert "Success =  true" in log, f"{name}: the session could not be played: {log[-2000:]}"
    assert not complaints(log), f"{name}: {complaints(log)}"
    assert shown(name) == expected, f"{name}: {shown(name)}, not {expected}"
    covered = float((pixels_of_view(picture).min(axis=2) < 220).mean())
    assert covered > least and (covered < 0.7) == setting, f"{name}: {100 * covered:.0f} % of the view are not light"


# Share of the view that is covered at least: less than half of it if the camera shows the box of the map, or the water.
SESSIONS = {
    "map": ("maps/emd_1832.map", "DensityMapReader Outline, MapSurface Surface", 0.12),
    "molecule": ("molecules/1hew.pdb", "MoleculeCartoon Surface, MoleculeCartoon Surface", 0.05),
    "map_off": ("maps/emd_1832.map", "DensityMapReader Outline", 0.9, False),
}
FOLDER.mkdir(parents=True, exist_ok=True)
for session_name, arguments in SESSIONS.items():
    if len(sys.argv) < 2 or session_name in sys.argv[1:]:
        session(session_name, *arguments)
