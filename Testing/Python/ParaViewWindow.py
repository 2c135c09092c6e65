"""The plugin in the real ParaView: open a .map, contour, curvature, colour, look at the window.

Starts `paraview` on this test's display with a session script, waits for it, takes a picture of the
whole window (kept beside the test's other output) and checks that the surface is on it in colour.
"""

import os
import subprocess
import sys
import time
from pathlib import Path

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

sys.path.insert(0, os.environ["ISTHMUS_EXAMPLES_DIR"])
import choose_map  # noqa: E402
import window_home  # noqa: E402

STARTED = time.monotonic()
PATIENCE = 240  # seconds, for a machine with other things to do


def wait_for(condition, process, what):
    while not condition():
        if process.poll() is not None:
            sys.exit(f"paraview ended with {process.returncode} before {what}")
        if time.monotonic() - STARTED > PATIENCE:
            process.kill()
            sys.exit(f"paraview took more than {PATIENCE} s for {what}")
        time.sleep(0.5)


def coloured_fraction(path):
    """Share of the pixels that are strongly coloured: neither grey nor ParaView's blue-grey."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
    return float(numpy.mean(pixels.max(axis=1) - pixels.min(axis=1) > 90))


folder = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "ParaViewWindow"
window_home.prepare(folder)
choose_map.write_phantom(folder / "phantom.map")
session = Path(__file__).parent / "window_session.py"
environment = dict(
    os.environ, HOME=str(folder), XDG_RUNTIME_DIR=str(folder), ISTHMUS_SESSION_DIR=str(folder))
environment.pop("XDG_CONFIG_HOME", None)
log = folder / "paraview.log"
with log.open("w") as sink:
    paraview = subprocess.Popen(
        ["paraview", f"--script={session}"], env=environment, stdout=sink, stderr=sink)
try:
    wait_for((folder / "done.txt").exists, paraview, "the session's end")
    time.sleep(3)  # the window paints after the script
    subprocess.run(["import", "-window", "root", str(folder / "window.png")], check=True, timeout=60)
finally:
    paraview.kill()
    paraview.wait()

complaints = [line for line in log.read_text(errors="replace").splitlines()
              if "ERR|" in line or "WARN|" in line]
assert not complaints, "\n".join(complaints)
result = (folder / "done.txt").read_text()
print(result)
assert result.startswith("DensityMapReader"), result
fraction = coloured_fraction(folder / "window.png")
print(f"{100 * fraction:.1f} % of the window is coloured: {folder / 'window.png'}")
assert fraction > 0.02
