"""States that pvpython has saved, in the real ParaView by mouse: a click on a row of a table shows what it showed before,
and a colour that somebody has chosen stays.

Results of buttons are made and saved by pvpython; the window loads the state and has nothing else. Pictures of the window
are kept beside the test's other output.
"""

import os
import subprocess
import sys
import time
from pathlib import Path

from paraview import simple
from shared_data import shared_data
from window_play import NOTHING_TO_APPLY, click, complaints, play

from isthmus_plugin import pipelines  # there once paraview.simple has loaded the plugin

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "StateWindow"
SCRIPT = Path(__file__).parent / "state_session.py"
# Places in a window of 1600 x 1000: a row of the table to the right of a view, and of the table below it.
ROW_BESIDE, ROW_BELOW = (1200, 288), (400, 823)


def saved(name, data, function):
    """The state of a button's result; its main display has another colour."""
    state = FOLDER / f"{name}.pvsm"
    for proxy in list(simple.GetSources().values()):
        simple.Delete(proxy)
    pipelines.forget()
    simple.SetActiveSource(simple.OpenDataFile(str(shared_data(data))))
    pipelines.run(function)
    simple.SaveState(str(state))
    return state


def shown(folder):
    path = folder / "shown.txt"
    return path.read_text(encoding="utf-8").splitlines() if path.exists() else []


def picture(name):
    path = FOLDER / f"{name}.png"
    subprocess.run(["import", "-window", "root", str(path)], check=True, timeout=60)
    return path


def session(name, data, function, row, reached):
    state = saved(name, data, function)
    found = []

    def act():
        picture(f"{name}_loaded")
        for _ in range(4):
            click(*row)
            for _ in range(20):
                time.sleep(0.5)
                found[:] = shown(FOLDER / name)
                if found and reached(found[-1]):
                    break
            else:
                continue
            break
        time.sleep(3)
        picture(f"{name}_clicked")

    log, _ = play(name, state, [NOTHING_TO_APPLY], (), FOLDER / name, script=SCRIPT, act=act)
    assert not complaints(log), f"{name}: {complaints(log)}"
    print(f"{name}: {found[-1:]}, {FOLDER}/{name}_clicked.png", flush=True)
    assert found and reached(found[-1]), f"{name}: the click has shown nothing: {found}"


SESSIONS = {
    "pockets": ("molecules/1hew.pdb", "protein_to_pockets", ROW_BESIDE, lambda line: line.startswith("residues of 2")),
    "loops": ("surfaces/torus.obj", "surface_to_loops", ROW_BELOW, lambda line: line.startswith("1 ball, radius ")),
}
FOLDER.mkdir(parents=True, exist_ok=True)
for session_name, arguments in SESSIONS.items():
    if len(sys.argv) < 2 or session_name in sys.argv[1:]:
        session(session_name, *arguments)
