"""Each button of the Isthmus toolbar and README's first recipe in the real ParaView's window.

ParaView opens shared data by its command line and plays what a user does with ParaView's own recorder
(--test-script): Apply, a button of the toolbar or an entry of the menu, the answers to its dialogs.
The log must have no warning. The state that ParaView then has is told by a file that a last button
can't write, so it is judged by the picture (kept beside the test's other output): coloured pixels,
and what the pipeline browser of that picture shows was looked at.
"""

import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import numpy
from shared_data import shared_data
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

PATIENCE = 200  # seconds for one session, on a machine with other things to do
APPLY = ("pqClientMainWindow/propertiesDock/propertiesPanel/Accept", "activate", "")
BUTTON = "pqClientMainWindow/Isthmus/1QToolButton%d"
MENU = "pqClientMainWindow/menubar/menuFilters/Isthmus"


def button(index):
    return (BUTTON % index, "activate", "")


# Name, data, what the user does, least share of strongly coloured pixels.
SESSIONS = (
    ("map_to_surface", "maps/emd_1832.map", [button(0)], 0.0),
    ("map_to_curvature", "maps/emd_5043.map", [button(1)], 0.02),
    ("map_to_loops", "maps/emd_1832.map", [button(2)], 0.003),
    ("protein_to_surface", "molecules/1ajj_charged", [button(3)], 0.0),
    ("protein_to_sites", "molecules/1ajj_charged", [button(4)], 0.001),
    ("surface_to_loops", "surfaces/torus.obj", [button(5)], 0.0005),
)
FILES = {"molecules/1ajj_charged": "molecules/1AJJ_pH7_PARSE.pqr"}


def prepare(folder):
    """A home of its own, so that no setting of the user's counts and no welcome dialog shows."""
    shutil.rmtree(folder, ignore_errors=True)
    settings = folder / ".config" / "ParaView"
    settings.mkdir(parents=True)
    folder.chmod(0o700)
    (settings / "ParaView5.11.0.ini").write_text(
        "[General]\nGeneralSettings.ShowWelcomeDialog=false\n")


def write_script(path, events):
    pause = ("pqClientMainWindow", "pause", "4000")
    lines = ['<?xml version="1.0" ?>', "<pqevents>"]
    lines += ['  <pqevent object="%s" command="%s" arguments="%s"/>' % event
              for event in (pause, *events, ("pqClientMainWindow", "pause", "1000"))]
    path.write_text("\n".join(lines + ["</pqevents>"]) + "\n")


def widen():
    """The window over the whole screen, so that no toolbar hides behind an arrow."""
    found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "ParaView"],
                           capture_output=True, text=True).stdout.split()
    for window in found[-1:]:
        subprocess.run(["xdotool", "windowmove", window, "0", "0", "windowsize", window, "1600", "1000"],
                       capture_output=True)


def play(name, data, events, folder):
    """Plays a session and returns (log, picture)."""
    prepare(folder)
    script, log, picture = folder / "session.xml", folder / "paraview.log", folder / "window.png"
    write_script(script, events)
    environment = dict(os.environ, HOME=str(folder), XDG_RUNTIME_DIR=str(folder))
    environment.pop("XDG_CONFIG_HOME", None)
    started = time.monotonic()
    with log.open("w") as sink:
        paraview = subprocess.Popen(
            ["paraview", "--dr", f"--data={data}", f"--test-script={script}",
             f"--test-directory={folder}"], env=environment, cwd=folder, stdout=sink, stderr=sink)
    try:
        while "is finished" not in log.read_text(errors="replace"):
            if paraview.poll() is not None:
                sys.exit(f"{name}: paraview ended with {paraview.returncode}")
            if time.monotonic() - started > PATIENCE:
                sys.exit(f"{name}: more than {PATIENCE} s")
            widen()
            time.sleep(0.5)
        time.sleep(2)  # the window paints after the script
        subprocess.run(["import", "-window", "root", str(picture)], check=True, timeout=60)
    finally:
        paraview.kill()
        paraview.wait()
    return log.read_text(errors="replace"), picture


def coloured_fraction(path):
    """Share of the pixels of the view that are strongly coloured."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
    view = pixels.reshape(height, width, 3)[60:790, 310:1440]  # without bar, panels and toolbars
    return float(numpy.mean(view.max(axis=2) - view.min(axis=2) > 90))


def main():
    output = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "Toolbar"
    failures = []
    for name, data, events, least in SESSIONS:
        path = shared_data(FILES.get(data, data))
        started = time.monotonic()
        log, picture = play(name, path, events, output / name)
        said = [line for line in log.splitlines()
                if "ERR|" in line or "WARN|" in line or "rror:" in line or "Traceback" in line]
        fraction = coloured_fraction(picture)
        print(f"{name}: {time.monotonic() - started:.0f} s, {100 * fraction:.2f} % coloured, {picture}")
        if "Success =  true" not in log:
            failures.append(f"{name}: the session could not be played: {log[-2000:]}")
        failures += [f"{name}: {line}" for line in said]
        if fraction < least:
            failures.append(f"{name}: only {100 * fraction:.2f} % of the view is coloured")
    assert not failures, "\n".join(failures)


main()
