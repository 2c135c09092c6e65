"""A program that is killed leaves neither TetGen nor its folder behind.

A child of this test meshes a surface with a program in TetGen's place that sleeps; the child is
killed with the signal that nothing can catch; the sleeper and the folder must go within seconds.
"""

import os
import signal
import stat
import subprocess
import sys
import tempfile
import time
from pathlib import Path

MESH = """
import sys, isthmus
from vtkmodules.vtkFiltersSources import vtkSphereSource
sphere = vtkSphereSource()
mesher = isthmus.vtkTetrahedralMesher()
mesher.SetInputConnection(sphere.GetOutputPort())
mesher.SetLibrary(0)
mesher.SetTetGenCommand(sys.argv[1])
mesher.Update()
"""


def alive(pid):
    try:
        with open(f"/proc/{pid}/stat", encoding="ascii") as file:
            return file.read().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


def wait(condition, seconds):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.05)
    return condition()


with tempfile.TemporaryDirectory() as made:
    place = Path(made) / "tmp"
    place.mkdir()
    sleeper = Path(made) / "sleeper"
    told = Path(made) / "pid"
    sleeper.write_text(f"#!/bin/sh\necho $$ > {told}.new; mv {told}.new {told}; exec sleep 300\n")
    sleeper.chmod(sleeper.stat().st_mode | stat.S_IXUSR)
    script = Path(made) / "mesh.py"
    script.write_text(MESH)
    child = subprocess.Popen(["pvpython", str(script), str(sleeper)],
                             env={**os.environ, "TMPDIR": str(place)}, start_new_session=True)
    assert wait(told.exists, 60), "the program in TetGen's place never began"
    pid = int(told.read_text())
    assert alive(pid) and any(place.glob("isthmus-*"))
    # pvpython may be a script that starts another: the parent of the sleeper is what dies.
    with open(f"/proc/{pid}/stat", encoding="ascii") as file:
        parent = int(file.read().rsplit(")", 1)[1].split()[1])
    os.kill(parent, signal.SIGKILL)
    child.wait(20)
    assert wait(lambda: not alive(pid), 10), "TetGen's process outlived its parent"
    assert wait(lambda: not any(place.glob("isthmus-*")), 10), list(place.iterdir())
print("neither the process nor its folder was left", file=sys.stderr)
