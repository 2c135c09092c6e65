"""Progress and Cancel of buttons in the real ParaView, by mouse and keys.

While a button works, the status bar has its name, its step and a button Cancel. The loops of a trajectory are cancelled
by mouse between two frames; potential and sites by the Escape key within Poisson Boltzmann; nothing that was made is
left, and the note says so. Escape while a result is being shown comes too late, and does no harm. Then the loops of a
short trajectory are made to the end, with their chart. Pictures are kept beside the test's other output, for people to
look at.
"""

import os
import subprocess
import sys
import time
from pathlib import Path

import numpy
import ring_models
import window_home
from shared_data import shared_data
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from window_play import STATUS_BAR, coloured_fraction, complaints, place_of_button, widen

PATIENCE = 150  # seconds for one step, on a machine with other things to do
SOON = 15.0  # seconds from Cancel to its end, on such a machine
FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "ProgressWindow"
CANCEL = (30, 983)  # in a window of 1600 x 1000
SITES, POCKETS, TRAJECTORY = 4, 7, 10  # places in the toolbar


def xdotool(*arguments):
    subprocess.run(["xdotool", *map(str, arguments)], check=True, capture_output=True)


class Session:
    """ParaView with the data."""

    def __init__(self, name, data):
        self.folder = FOLDER / name
        window_home.prepare(self.folder)
        environment = dict(os.environ, HOME=str(self.folder), XDG_RUNTIME_DIR=str(self.folder),
                           ISTHMUS_SESSION_DIR=str(self.folder), ISTHMUS_SESSION_DATA=str(data))
        environment.pop("XDG_CONFIG_HOME", None)
        self.log = self.folder / "paraview.log"
        with self.log.open("w") as sink:
            self.paraview = subprocess.Popen(
                ["paraview", "--dr", f"--script={Path(__file__).parent / 'progress_session.py'}"],
                env=environment, cwd=self.folder, stdout=sink, stderr=sink)

    def __enter__(self):
        self.until("opened")
        time.sleep(4)
        widen()
        time.sleep(3)
        return self

    def __exit__(self, *_):
        self.paraview.kill()
        self.paraview.wait()

    def lines(self, what):
        path = self.folder / "steps.txt"
        lines = [line.split(" ", 2) for line in path.read_text().splitlines()] if path.exists() else []
        return [line for line in lines if len(line) > 1 and line[1] == what]

    def until(self, what, text="", again=None):
        """Waits for a line with that text; `again`: tried once more after 15 s, where the machine was too busy to heed
        it."""
        began = tried = time.monotonic()
        while not any(text in " ".join(line) for line in self.lines(what)):
            now = time.monotonic()
            if self.paraview.poll() is not None or now - began > PATIENCE:
                self.picture("failed") if self.paraview.poll() is None else None
                sys.exit(f"{self.folder.name}: no {what} {text}: {self.log.read_text(errors='replace')[-2000:]}")
            if again and now - tried > 15:
                again()
                tried = now
            time.sleep(0.1)

    def picture(self, name):
        path = self.folder / f"{name}.png"
        subprocess.run(["import", "-window", "root", str(path)], check=True, timeout=60)
        return path

    def press(self, place):
        def act():
            xdotool("mousemove", *place_of_button(place), "sleep", "0.7", "click", "1")

        act()
        self.until("begins", again=act)

    def cancel(self, when, act):
        """Acts in that step; checks what is left."""
        self.until("step", when)
        time.sleep(1.0)
        during = self.picture("during")
        acted = time.monotonic()
        act()
        self.until("ends")
        seconds = float(self.lines("ends")[0][0]) - acted
        time.sleep(2)
        after = self.picture("after")
        assert has_cancel(during) and not has_cancel(after), "Cancel is to be seen while the button works, and only then"
        assert self.lines("ends")[0][2] == self.lines("begins")[0][2], "sources are left"
        assert self.lines("note")[-1][2].startswith("Cancelled"), self.lines("note")
        texts = [line[2] for line in self.lines("step") if len(line) > 2 and line[2]]
        print(f"{self.folder.name}: cancelled {seconds:.1f} s after it was asked for, last step {texts[-1]}, {after}", flush=True)
        assert when in texts[-1] or when == "frame 3 of ", f"it went on: {texts}"
        assert seconds < SOON, seconds
        self.has_no_complaints()

    def has_no_complaints(self):
        # The trajectory has the C-alpha atoms alone.
        said = [line for line in complaints(self.log.read_text(errors="replace"))
                if "Side chains or bases are missing" not in line]
        assert not said, said


def pixels_of(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
    return pixels.reshape(1000, 1600, 3)[::-1]


def has_cancel(path):
    """Whether the frame of a button is in its place: a row of pixels darker than the status bar."""
    bar = pixels_of(path)[968:998, 8:52].mean(axis=2)
    return bool(((bar < numpy.median(bar) - 15).mean(axis=1) > 0.8).any())


def escape():
    xdotool("key", "Escape")


FOLDER.mkdir(parents=True, exist_ok=True)
ring_models.write(FOLDER / "long.pdb", 60)
ring_models.write(FOLDER / "ring.pdb", 4)
chosen = sys.argv[1:] or ["frames", "filter", "late", "chart"]
if "frames" in chosen:
    with Session("frames", FOLDER / "long.pdb") as session:
        session.press(TRAJECTORY)
        session.cancel("frame 3 of ", lambda: xdotool("mousemove", *CANCEL, "sleep", "0.2", "click", "1"))
if "filter" in chosen:
    with Session("filter", shared_data("molecules/1hew/1hew.pqr")) as session:  # with charges, without pdb2pqr
        xdotool("mousemove", *STATUS_BAR, "click", "1")
        session.press(SITES)
        session.cancel("1hew potential", escape)
if "late" in chosen:
    os.environ["ISTHMUS_SESSION_ESCAPE"] = "1"
    with Session("late", shared_data("molecules/1hew.pdb")) as session:
        xdotool("mousemove", *STATUS_BAR, "click", "1")
        session.press(POCKETS)
        session.until("ends")
        assert "1hew residue names" in session.lines("ends")[0][2], session.lines("ends")
        time.sleep(2)
        assert session.paraview.poll() is None and not session.lines("note"), session.lines("note")
        print(f"late: {session.picture('shown')}")
        session.has_no_complaints()
    del os.environ["ISTHMUS_SESSION_ESCAPE"]
if "chart" in chosen:
    with Session("chart", FOLDER / "ring.pdb") as session:
        session.press(TRAJECTORY)
        session.until("ends")
        time.sleep(5)
        made = session.picture("made")
        assert "ring loops over time" in session.lines("ends")[0][2], session.lines("ends")
        coloured = coloured_fraction(made)
        chart = pixels_of(made)[210:940, 1000:1590]
        white = float((chart.min(axis=2) > 240).mean())
        print(f"chart: {100 * coloured:.2f} % coloured, the chart's paper is {100 * white:.0f} % of its place, {made}")
        assert coloured > 0.002 and white > 0.5
        session.has_no_complaints()
