"""A correct run prints no lines of VTK's log, escape codes or names of source files: pipelines and buttons print
nothing, the scripts of Examples/run.sh at most 40 lines on the phantom, the command `isthmus` its result. Warnings of
their filters are sentences.

The terminal is one for which VTK would use colours."""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from shared_data import shared_data

EXAMPLES = Path(os.environ["ISTHMUS_EXAMPLES_DIR"])
sys.path.insert(0, str(EXAMPLES))
import choose_map  # noqa: E402

MOST_LINES = 40
LOG = re.compile(r"\x1b|\b(INFO|WARN|ERR)\||\w\.(cxx|h|txx|py)\b|\(0x[0-9a-f]+\)|Traceback")
PIPELINES = """
import sys
import isthmus
from paraview import simple
from isthmus_plugin import pipelines

phantom, molecule = (simple.OpenDataFile(path) for path in sys.argv[1:])
simple.ChokingLoops(Input=simple.MapSurface(Input=phantom)).UpdatePipeline()
simple.MolecularPockets(Input=molecule).UpdatePipeline()
for source, button in ((phantom, "map_to_curvature"), (phantom, "map_to_loops"), (molecule, "protein_to_pockets")):
    simple.SetActiveSource(source)
    pipelines.run(button)
    assert simple.GetActiveSource() != source, button
assert isthmus.choking_loops(isthmus.samples.torus()).loops.GetNumberOfCells() == 2
"""


def printed(*command, code=0):
    """What a program of ParaView prints to standard output, and to standard error."""
    done = subprocess.run(["pvpython", *map(str, command)], env=dict(os.environ, TERM="xterm"), capture_output=True,
                          text=True, timeout=300, check=False)
    texts = done.stdout, done.stderr
    assert done.returncode == code, f"{command}: {done.returncode}\n{''.join(texts)}"
    found = [line for text in texts for line in text.splitlines() if LOG.search(line)]
    assert not found, f"{command}: {found}"
    return texts


def check_main_job(folder, phantom):
    """The three scripts as Examples/run.sh runs them."""
    steps, numbers = [], []
    for script, *arguments in (("map_to_curvature.py", phantom, folder, 0.5), ("map_to_mesh.py", phantom, folder, 0.5),
                               ("choking_loops.py", folder / "surface_delaunay.vtp", folder / "choking_loops.png")):
        out, error = printed(EXAMPLES / script, *arguments)
        numbers += out.splitlines()
        steps += error.splitlines()
    print(*steps, *numbers, sep="\n", flush=True)
    assert len(steps) + len(numbers) <= MOST_LINES, len(steps) + len(numbers)
    for line in steps:
        assert re.match(r"[A-Z][a-z ]+: \d+\.\d s", line), line
    counts = [line for line in numbers if re.fullmatch(
        r"handles \d+, tunnels \d+, additional loops \d+ inside and \d+ outside", line)]
    assert len(counts) == 1, numbers


def check_faults(folder, damaged):
    """Where something is wrong, it is a sentence with the name of the filter."""
    _, error = printed(EXAMPLES / "choking_loops.py", damaged, folder / "damaged.png", code=1)
    assert error.startswith("Error of Choking Loops: "), error


with tempfile.TemporaryDirectory() as place:
    folder = Path(place)
    choose_map.write_phantom(folder / "phantom.mrc")
    check_main_job(folder, folder / "phantom.mrc")
    (folder / "open.off").write_text("OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n")
    check_faults(folder, folder / "open.off")
    out, error = printed("-m", "isthmus", "surface", folder / "phantom.mrc", "-o", folder / "surface.vtp")
    assert out.count("\n") == 1 and not error, (out, error)
    (folder / "pipelines").write_text(PIPELINES)
    out, error = printed(folder / "pipelines", folder / "phantom.mrc", shared_data("molecules/1hew.pdb"))
    assert not out + error, (out, error)
