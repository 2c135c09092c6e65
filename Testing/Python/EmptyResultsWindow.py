"""Buttons and filters in the real ParaView on inputs that have no result: a ball without choking loops, pockets, pores,
handles or cavities. The window stays alive, the view says what to try, and no legend is empty. A dialog of ParaView's that
opens while a button works can be answered; 6.1 opens none here.

Pictures of the window are kept beside the test's other output.
"""

import os
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy
from shared_data import shared_data
from window_play import APPLY, STATUS_BAR, VERSION, button, click, complaints, entry, place_of, play

import isthmus

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "EmptyResultsWindow"
PAUSE = ("pqClientMainWindow", "pause", "2000")
QUESTION = "iscrete"  # in the title of ParaView's question for the values of categories
OK = (258, 98)  # the place of its button
SCRIPT = Path(__file__).parent / "empty_session.py"


def ball_map(path):
    x, y, z = numpy.meshgrid(*[numpy.arange(24) - 11.5] * 3, indexing="ij")
    isthmus.open_dx_writer(numpy.exp(-(x**2 + y**2 + z**2) / 60.0), path)
    return path


def one_residue(path):
    atoms = (("N", 0.0, 0.0, 0.0), ("CA", 1.45, 0.0, 0.0), ("C", 2.0, 1.4, 0.0), ("O", 1.3, 2.4, 0.0), ("CB", 2.0, -0.8, 1.2))
    path.write_text("".join(
        f"ATOM  {i:5d}  {name:<3} ALA A   1    {x:8.3f}{y:8.3f}{z:8.3f}  1.00  0.00           {name[0]}\n"
        for i, (name, x, y, z) in enumerate(atoms, 1)) + "END\n")
    return path


def facts(folder):
    return (folder / "facts.txt").read_text(encoding="utf-8").splitlines()


def has_file_dialog():
    """Whether the window heeds a key: Ctrl+O opens its dialog, and Escape closes it."""
    for _ in range(3):
        click(*STATUS_BAR)
        subprocess.run(["xdotool", "key", "ctrl+o"], check=True)
        for _ in range(10):
            time.sleep(1)
            if place_of("Open File"):
                subprocess.run(["xdotool", "key", "Escape"], check=True)
                return True
    return False


def session(name, data, events, expected, allowed=()):
    alive = []
    log, picture = play(name, data, [*events, PAUSE, PAUSE], (), FOLDER / name, script=SCRIPT,
                        act=lambda: alive.append(has_file_dialog()))
    said = [line for line in complaints(log) if not any(words in line for words in allowed)]
    found = facts(FOLDER / name)
    print(f"{name}: {found[-1]}, {picture}", flush=True)
    assert "Success =  true" in log, f"{name}: the session could not be played: {log[-2000:]}"
    assert not said, f"{name}: {said}"
    assert alive == [True], f"{name}: the window does not heed keys"
    assert expected in found[-1], f"{name}: {found}"


def dialog():
    """ParaView's dialog, opened within a button, is closed by its button."""
    answered = []

    def answer():
        began = time.monotonic()
        while time.monotonic() - began < 180 and not answered:
            place = place_of(QUESTION)
            if place:
                subprocess.run(["import", "-window", "root", str(FOLDER / "question.png")], check=True, timeout=60)
                for _ in range(3):
                    click(place[0] + OK[0], place[1] + OK[1])
                    time.sleep(2)
                    if not place_of(QUESTION):
                        break
                answered.append(not place_of(QUESTION))
            time.sleep(0.5)

    waiting = threading.Thread(target=answer)
    waiting.start()
    os.environ["ISTHMUS_SESSION_DIALOG"] = "1"
    try:
        session("dialog", shared_data("surfaces/sphere.off"), [button(5)], "", ["Could not determine array range"])
    finally:
        del os.environ["ISTHMUS_SESSION_DIALOG"]
        waiting.join()
    assert answered == [True], f"the dialog was not there, or not answered: {answered}"


FOLDER.mkdir(parents=True, exist_ok=True)
chosen = sys.argv[1:]
NO_LOOPS = "No choking loops\\nTry a lower Minimum Persistence"
SESSIONS = {
    "surface_to_loops": (shared_data("surfaces/sphere.off"), [button(5)], NO_LOOPS),
    "map_to_loops": (ball_map(FOLDER / "ball.dx"), [button(2)], NO_LOOPS),
    "loops_by_menu": (shared_data("surfaces/sphere.off"), [entry("ChokingLoops"), APPLY], NO_LOOPS),
    "pockets": (shared_data("molecules/1AJJ_pH7_PARSE.pqr"), [button(7)], "", ["has no pockets"]),
    "pores": (one_residue(FOLDER / "one.pdb"), [button(8)], "", ["No channel runs"]),
    "pockets_by_menu": (shared_data("molecules/1AJJ_pH7_PARSE.pqr"), [entry("MolecularPockets"), APPLY], "coloured by nothing"),
    "pores_by_menu": (one_residue(FOLDER / "one.pdb"), [entry("PoreProfile"), APPLY], "coloured by nothing"),
    "handles_by_menu": (ball_map(FOLDER / "ball.dx"), [entry("MapHandles"), APPLY], ""),
}
for session_name, arguments in SESSIONS.items():
    if not chosen or session_name in chosen:
        session(session_name, *arguments)
if VERSION < (6,) and (not chosen or "dialog" in chosen):  # ParaView 6.1 only warns
    dialog()
