"""Scalar Persistence in the real ParaView: a map, its Betti curves and its diagram as charts, and a
class picked by its FeatureId, which lights up in the diagram and at its saddle.

Starts `paraview` on this test's display with a session script, waits for it, takes a picture of the
whole window and looks for ParaView's selection colour in it.
"""

import os
import subprocess
import sys
import time
from pathlib import Path

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import window_home
from shared_data import shared_data

PATIENCE = 240  # seconds, for a machine with other things to do


def pixels_of(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars())[:, :3].reshape(height, width, 3).astype(int)


folder = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "PersistenceWindow"
window_home.prepare(folder)
environment = dict(os.environ, HOME=str(folder), XDG_RUNTIME_DIR=str(folder),
                   ISTHMUS_SESSION_DIR=str(folder),
                   ISTHMUS_SESSION_MAP=str(shared_data("maps/emd_5043.map")))
environment.pop("XDG_CONFIG_HOME", None)
session = Path(__file__).parent / "persistence_session.py"
log = folder / "paraview.log"
with log.open("w") as sink:
    paraview = subprocess.Popen(
        ["paraview", f"--script={session}"], env=environment, stdout=sink, stderr=sink)
try:
    started = time.monotonic()
    while not (folder / "done.txt").exists():
        if paraview.poll() is not None or time.monotonic() - started > PATIENCE:
            sys.exit(f"paraview did not come to the session's end: {log.read_text(errors='replace')}")
        time.sleep(0.5)
    time.sleep(3)  # the window paints after the script
    subprocess.run(["import", "-window", "root", str(folder / "window.png")], check=True, timeout=60)
finally:
    paraview.kill()
    paraview.wait()

complaints = [line for line in log.read_text(errors="replace").splitlines()
              if "ERR|" in line or "WARN|" in line]
assert not complaints, "\n".join(complaints)
said = (folder / "done.txt").read_text()
assert said.startswith("done ScalarPersistence"), said
red, green, blue = numpy.moveaxis(pixels_of(folder / "window.png"), 2, 0)
# Magenta in the chart; in the render view it lies behind the translucent surface.
picked = (red > 110) & (blue > 140) & (green < 70)
columns = numpy.nonzero(picked)[1]
middle = (columns.min() + columns.max()) // 2 if len(columns) else 0
in_view, in_chart = (columns < middle).sum(), (columns >= middle).sum()
print(f"{in_view} pixels in the colour of the selection in the render view, {in_chart} in the chart")
assert in_view > 40 and in_chart > 40 and columns.max() - columns.min() > 150
