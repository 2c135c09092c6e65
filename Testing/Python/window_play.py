"""The real ParaView played as a user does: its own recorder for menus and buttons, the mouse (xdotool)
for what that can't see. For window tests.

A session opens data by the command line, presses Apply, and does what it is told; the picture of the
whole window is kept beside the test's other output.
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

from paraview import servermanager

PATIENCE = 200  # seconds for one session, on a machine with other things to do
APPLY = ("pqClientMainWindow/propertiesDock/propertiesPanel/Accept", "activate", "")
NOTHING_TO_APPLY = (APPLY[0], "check enabled", "false")
BUTTON = "pqClientMainWindow/Isthmus/1QToolButton%d"
PANEL = ("pqClientMainWindow/propertiesDock/propertiesPanel/scrollArea/qt_scrollarea_viewport/"
         "scrollAreaWidgetContents/PropertiesFrame/ProxyPanel/")
MENU = "pqClientMainWindow/menubar/menuFilters/Isthmus"
# From 5.13 on the menu of a category is made when the menu Filters opens.
OPEN_MENU = (("pqClientMainWindow/menubar", "activate", "menuFilters"),
             ("pqClientMainWindow/menubar/menuFilters", "activate", "Isthmus"))
VERSION = servermanager.vtkSMProxyManager.GetVersionMajor(), servermanager.vtkSMProxyManager.GetVersionMinor()
# Places in a window of 1600 x 1000. The status bar: a click there gives the window the keyboard, and does no more.
STATUS_BAR = (300, 987)
# The first button of our toolbar and the distance to the next; the width of the panels to the left of the views.
FIRST_BUTTON, NEXT_BUTTON = (
    ((893, 116), 33) if VERSION > (6,) else ((827, 116), 33) if VERSION > (5, 12) else ((818, 122), 34))
PANELS = 350 if VERSION > (6,) else 300


def button(index):
    """Of the toolbar."""
    return (BUTTON % index, "activate", "")


def place_of_button(index):
    """Of the toolbar, for the mouse."""
    return FIRST_BUTTON[0] + index * NEXT_BUTTON, FIRST_BUTTON[1]


def entry(name):
    """Of the menu Filters > Isthmus."""
    return (MENU, "activate", name)


def line_of(target, command, arguments):
    """What to do, or, after the word check, a property and the value it must have."""
    if command.startswith("check "):
        return f'  <pqcheck object="{target}" property="{command[6:]}" arguments="{arguments}"/>'
    return f'  <pqevent object="{target}" command="{command}" arguments="{arguments}"/>'


def write_script(path, events):
    """With Apply first, unless the session is about what happens without."""
    begin = () if NOTHING_TO_APPLY in events else (APPLY,)
    pause = ("pqClientMainWindow", "pause", "4000")
    lines = ['<?xml version="1.0" ?>', "<pqevents>"]
    for event in (pause, *begin, *events, ("pqClientMainWindow", "pause", "1000")):
        lines += [line_of(*each) for each in (OPEN_MENU if event[0] == MENU else ())]
        lines.append(line_of(*event))
    path.write_text("\n".join(lines + ["</pqevents>"]) + "\n")


def widen():
    """The window over the whole screen, so that no toolbar hides behind an arrow."""
    found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "ParaView"],
                           capture_output=True, text=True).stdout.split()
    for window in found[-1:]:
        subprocess.run(["xdotool", "windowmove", window, "0", "0", "windowsize", window, "1600", "1000"],
                       capture_output=True)


def place_of(title):
    """(x, y) of the window of that title, or None while it is not there."""
    found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", title],
                           capture_output=True, text=True).stdout.split()
    for window in found[-1:]:
        said = subprocess.run(["xdotool", "getwindowgeometry", "--shell", window],
                              capture_output=True, text=True).stdout
        values = dict(line.split("=", 1) for line in said.split() if "=" in line)
        if "X" in values and "Y" in values:
            return int(values["X"]), int(values["Y"])
    return None


def click(x, y):
    time.sleep(1.5)
    subprocess.run(["xdotool", "mousemove", str(x), str(y), "click", "1"], check=True)


def answer(places):
    """Answers the dialog by clicks at places in it, again where the machine was too busy to heed one;
    then Apply.
    """
    began = time.monotonic()
    asked = False
    while time.monotonic() - began < PATIENCE:
        corner = place_of("Change Input")
        if corner:
            asked = True
            for x, y in places:
                click(corner[0] + x, corner[1] + y)
        elif asked:
            break
        time.sleep(2)
    widen()
    for _ in range(3):  # while the panel is not yet there the key is lost, and after it Apply is grey
        time.sleep(2)
        click(*STATUS_BAR)
        subprocess.run(["xdotool", "key", "alt+a"], check=True)


def press(keys):
    """Keys, one after the other, with the mouse over the pipeline browser."""
    subprocess.run(["xdotool", "mousemove", "150", "400", "click", "1"], check=True)
    for key in keys:
        time.sleep(1.5)
        subprocess.run(["xdotool", "key", key], check=True)


def drag(start, end):
    """With the left button, from place to place."""
    subprocess.run(["xdotool", "mousemove", *map(str, start), "sleep", "0.5", "mousedown", "1"], check=True)
    for part in (0.3, 0.7, 1.0):
        place = [str(round(a + part * (b - a))) for a, b in zip(start, end)]
        subprocess.run(["xdotool", "mousemove", *place, "sleep", "0.3"], check=True)
    subprocess.run(["xdotool", "mouseup", "1"], check=True)


def play(name, data, events, clicks, folder, keys=(), script=None, act=None):
    """Plays a session, then presses `keys`, calls `act`, and returns (log, picture). script: what Python runs
    first, with the folder as ISTHMUS_SESSION_DIR; it opens the data, ISTHMUS_SESSION_DATA, itself."""
    window_home.prepare(folder)
    played, log, picture = folder / "session.xml", folder / "paraview.log", folder / "window.png"
    write_script(played, events)
    environment = dict(os.environ, HOME=str(folder), XDG_RUNTIME_DIR=str(folder), ISTHMUS_SESSION_DIR=str(folder),
                       ISTHMUS_SESSION_DATA=str(data))
    environment.pop("XDG_CONFIG_HOME", None)
    started = time.monotonic()
    with log.open("w") as sink:
        paraview = subprocess.Popen(
            ["paraview", "--dr", f"--script={script}" if script else f"--data={data}", f"--test-script={played}",
             f"--test-directory={folder}"], env=environment, cwd=folder, stdout=sink, stderr=sink)
    try:
        while "is finished" not in log.read_text(errors="replace"):
            if paraview.poll() is not None:
                sys.exit(f"{name}: paraview ended with {paraview.returncode}")
            if time.monotonic() - started > PATIENCE:
                sys.exit(f"{name}: more than {PATIENCE} s")
            widen()
            time.sleep(0.5)
            if clicks and "Playing" in log.read_text(errors="replace"):
                answer(clicks)
                clicks = ()
        time.sleep(5)  # the window paints after the script
        press(keys) if keys else None
        act() if act else None
        if paraview.poll() is not None:
            sys.exit(f"{name}: paraview ended with {paraview.returncode} after {keys}")
        subprocess.run(["import", "-window", "root", str(picture)], check=True, timeout=60)
    finally:
        paraview.kill()
        paraview.wait()
    return log.read_text(errors="replace"), picture


def pixels_of(path):
    """A picture as numbers: height x width x 3, from the top."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
    return pixels.reshape(height, width, 3)[::-1]


def pixels_of_window(path):
    """Keeps a picture of the whole window as it is, and returns its pixels."""
    subprocess.run(["import", "-window", "root", str(path)], check=True, timeout=60)
    return pixels_of(path)


def pixels_of_view(path):
    """height x width x 3 from the bottom, without bar, panels, toolbars and the blue frame of the active view, of any
    ParaView: panels are 260 pixels wide in 5.11 and 350 in 6.1."""
    return pixels_of(path)[::-1][60:790, 360:1440]


def asks_for_apply(pixels):
    """Whether Apply is green in a picture of the whole window, of 1600 x 1000."""
    red, green, blue = numpy.moveaxis(pixels[435:540, 8:88], 2, 0)
    return int(((green > red + 20) & (green > blue + 20)).sum()) > 500


def coloured_fraction(path):
    """Share of the pixels of the view that are strongly coloured."""
    view = pixels_of_view(path)
    return float(numpy.mean(view.max(axis=2) - view.min(axis=2) > 90))


def complaints(log):
    """Lines of the log that a user would take for something wrong."""
    return [line for line in log.splitlines()
            if line.startswith("Isthmus: ") or "ERR|" in line or "WARN|" in line or "rror:" in line or "Traceback" in line]


def play_all(test, sessions):
    """Plays the sessions (name, data, events, least share of strongly coloured pixels, clicks in a
    dialog) or those named on the command line; ends the test with what was wrong."""
    output = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / test
    failures = []
    for name, data, events, least, clicks in sessions:
        if len(sys.argv) > 1 and name not in sys.argv[1:]:
            continue
        path = shared_data(data)
        started = time.monotonic()
        log, picture = play(name, path, events, clicks, output / name)
        fraction = coloured_fraction(picture)
        print(f"{name}: {time.monotonic() - started:.0f} s, {100 * fraction:.2f} % coloured, {picture}",
              flush=True)
        if "Success =  true" not in log:
            failures.append(f"{name}: the session could not be played: {log[-2000:]}")
        failures += [f"{name}: {line}" for line in complaints(log)]
        if fraction < least:
            failures.append(f"{name}: only {100 * fraction:.2f} % of the view is coloured")
    assert not failures, "\n".join(failures)
