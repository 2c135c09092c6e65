"""A walk through the real ParaView by mouse and keys alone, the same in each version: a map is opened, three buttons of
the toolbar are pressed, a filter is chosen from the menu and undone, the state is saved, and a second ParaView loads it.

A picture of the window after each step is kept beside the test's other output, for people to look at. By hand, in
whichever ParaView is installed: ctest -R WalkWindow, in the build folder. An argument is a state to be loaded in place
of the one that was saved, such as one of another version.
"""

import os
import subprocess
import sys
import time
from pathlib import Path

import numpy
import window_home
from shared_data import shared_data
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from window_play import STATUS_BAR, coloured_fraction, complaints, place_of_button, widen

PATIENCE = 120  # seconds for one step, on a machine with other things to do
FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "WalkWindow"
# In a window of 1600 x 1000: the menus File and Filters and Search, the first entry of the latter, and the first source
# of the pipeline browser.
FILE, FILTERS, SEARCH, FIRST_SOURCE = (20, 9), (209, 9), (230, 25), (100, 192)


def xdotool(*arguments):
    return subprocess.run(["xdotool", *map(str, arguments)], check=True, capture_output=True, text=True).stdout


class Window:
    def __init__(self, name):
        self.folder = FOLDER / name
        window_home.prepare(self.folder)
        environment = dict(os.environ, HOME=str(self.folder), XDG_RUNTIME_DIR=str(self.folder),
                           ISTHMUS_SESSION_DIR=str(self.folder))
        environment.pop("XDG_CONFIG_HOME", None)
        self.log = self.folder / "paraview.log"
        with self.log.open("w") as sink:
            self.paraview = subprocess.Popen(
                ["paraview", "--dr", f"--script={Path(__file__).parent / 'walk_session.py'}"],
                env=environment, cwd=self.folder, stdout=sink, stderr=sink)

    def __enter__(self):
        self.until("start", lambda: (self.folder / "sources.txt").exists())
        time.sleep(3)
        widen()
        return self

    def __exit__(self, *_):
        self.paraview.kill()
        self.paraview.wait()

    def sources(self):
        """Kinds of the pipeline's sources, in the order of their names."""
        return [line.split("\t")[0] for line in (self.folder / "sources.txt").read_text().splitlines()]

    def until(self, step, reached, again=None):
        """Waits; with `again` tries it once more, every 20 s, where the machine was too busy to heed it."""
        began = tried = time.monotonic()
        while not reached():
            now = time.monotonic()
            if self.paraview.poll() is not None or now - began > PATIENCE:
                said = self.log.read_text(errors="replace")[-2000:]
                self.picture(f"failed_{step}") if self.paraview.poll() is None else None
                sys.exit(f"{step} was not reached (paraview: {self.paraview.poll()}): {self.sources()} {said}")
            if again and now - tried > 20:
                again()
                tried = time.monotonic()
            time.sleep(0.5)

    def picture(self, step):
        path = self.folder / f"{step}.png"
        subprocess.run(["import", "-window", "root", str(path)], check=True, timeout=60)
        return path

    def reached(self, step, least=0.0):
        """Waits until nothing moves any more in the window, no bar of progress is in it, and that much is coloured. A
        cursor may blink: it is of fewer than 60 pixels."""
        began, last = time.monotonic(), None
        while True:
            time.sleep(3)
            path = self.picture(step)
            pixels = pixels_of(path)
            bar = pixels[976:, :1000]  # below the frame of the active view
            moves = 60 if last is None else (pixels[:960] != last[:960]).any(axis=2).sum()
            rests = moves < 60 and not (numpy.ptp(bar, axis=2) > 90).any()
            if rests and coloured_fraction(path) >= least:
                break
            assert time.monotonic() - began < PATIENCE, f"{step}: the window does not come to rest: {moves} pixels"
            last = pixels
        said = complaints(self.log.read_text(errors="replace"))
        if len(sys.argv) > 1:  # formats of scalar bars that states of ParaView 5 have
            said = [line for line in said if "is a printf format" not in line]
        assert not said, f"{step}: {said}"
        print(f"{step}: {len(self.sources())} sources, {100 * coloured_fraction(path):.2f} % coloured, {path}", flush=True)
        return path


def pixels_of(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
    return pixels.reshape(1000, 1600, 3)[::-1]


def click(x, y):
    xdotool("mousemove", x, y, "sleep", "0.7", "click", "1")
    time.sleep(1)


def keys(*names):
    for name in names:
        xdotool("key", name)
        time.sleep(1)


def keyboard():
    """Gives the main window the keyboard."""
    click(*STATUS_BAR)


def window_of(title):
    found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", title], capture_output=True, text=True)
    return found.stdout.split()[-1:]


def file_dialog(window, title, path, act):
    """Opens the dialog by `act`, types the path, and Enter."""
    act()
    window.until(title, lambda: window_of(title), act)
    time.sleep(2)
    for dialog in window_of(title):
        xdotool("windowfocus", dialog)
    time.sleep(1)
    xdotool("type", "--delay", "30", str(path))
    time.sleep(2)
    keys("Return")
    window.until(f"end of {title}", lambda: not window_of(title), lambda: keys("Return"))


def by_key(key):
    keyboard()
    keys(key)


def in_file_menu(letter):
    """The entry of the menu File with that letter underlined."""
    keys("Escape")
    keyboard()
    click(*FILE)
    keys(letter)


def has(window, *kinds):
    return lambda: set(kinds) <= set(window.sources())


def press(window, index, *kinds):
    """The button of that place in the toolbar."""
    def act():
        click(*place_of_button(index))

    act()
    window.until(f"button {index}", has(window, *kinds), act)


def search(window, name, kind):
    """A filter by the menu Filters, its entry Search, and its name."""
    before = window.sources().count(kind)

    def act():
        keys("Escape")
        click(*FIRST_SOURCE)
        click(*FILTERS)
        click(*SEARCH)
        time.sleep(2)
        xdotool("type", "--delay", "60", name)
        time.sleep(2)
        keys("Return")

    act()
    window.until(name, lambda: window.sources().count(kind) > before, act)


def walk(window, state):
    file_dialog(window, "Open File", shared_data("maps/emd_5043.map"), lambda: by_key("ctrl+o"))
    window.until("file", has(window, "DensityMapReader"))
    by_key("alt+a")
    window.reached("1_map")
    press(window, 1, "CurvatureOnSurface")
    window.reached("2_map_to_curvature", 0.02)
    click(*FIRST_SOURCE)
    press(window, 2, "ChokingLoops", "TextSource")
    window.reached("3_map_to_loops", 0.003)
    press(window, 6, "ProgrammableFilter")
    before = pixels_of(window.reached("4_diagram", 0.003))
    sources = window.sources()
    search(window, "Map Surface", "MapSurface")
    window.reached("5_filter_by_name")
    by_key("alt+a")
    window.reached("6_filter_applied")
    by_key("ctrl+z")
    by_key("ctrl+z")
    window.until("undo", lambda: window.sources() == sources, lambda: by_key("ctrl+z"))
    window.reached("7_undone")
    file_dialog(window, "Save State", state, lambda: in_file_menu("s"))
    window.until("state", state.exists)
    window.reached("8_saved")
    return sources, before


def load(window, state):
    file_dialog(window, "Load State", state, lambda: in_file_menu("l"))
    time.sleep(3)
    for dialog in window_of("Load State"):  # where the files are: as they were
        xdotool("windowfocus", dialog)
        keys("Return")
    window.until("loaded state", has(window, "ChokingLoops", "ProgrammableFilter"))
    shown = pixels_of(window.reached("9_loaded", 0.003))
    return window.sources(), shown


saved = FOLDER / "walk.pvsm"
saved.parent.mkdir(parents=True, exist_ok=True)
saved.unlink(missing_ok=True)
if len(sys.argv) > 1:
    saved = Path(sys.argv[1])
else:
    with Window("walk") as first:
        walked, shown = walk(first, saved)
with Window("load") as second:
    loaded, shown_again = load(second, saved)
if len(sys.argv) == 1:
    assert sorted(loaded) == sorted(walked), f"saved were {walked}, loaded {loaded}"
    # Columns of the table below may have other widths.
    differ = float(numpy.mean(numpy.abs(shown - shown_again)[210:720, 370:1590].max(axis=2) > 24))
    print(f"{100 * differ:.2f} % of the views differ between the window before and after")
    assert differ < 0.02
