"""The radius of a pore in the real ParaView: gramicidin, the button, then the radii of HOLE in the panel. The chart names the
radii and the narrowest place, which is that of the guide; the view has its ball and its radius.

Pictures of the window are kept beside the test's other output.
"""

import os
from pathlib import Path

import numpy
from shared_data import shared_data
from window_play import APPLY, PANEL, button, complaints, pixels_of_view, play

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "PoreRadiusWindow"
PAUSE = ("pqClientMainWindow", "pause", "3000")
RADII = (PANEL + "RadiusTable/ComboBox", "set_string", "HOLE")
SCRIPT = Path(__file__).parent / "pore_radius_session.py"


def session(name, events):
    log, picture = play(name, shared_data("molecules/channels/1grm_hole_example.pdb"), [button(8), PAUSE, *events], (),
                        FOLDER / name, script=SCRIPT)
    assert "Success =  true" in log, f"{name}: the session could not be played: {log[-2000:]}"
    said = [line for line in complaints(log) if "as in old PDB files" not in line]  # of this file
    assert not said, f"{name}: {said}"
    chart = (FOLDER / name / "chart.txt").read_text(encoding="utf-8").splitlines()[-1]
    red, green, blue = numpy.moveaxis(pixels_of_view(picture), 2, 0)
    ball = int(((red > blue + 40) & (abs(red - green) < 40)).sum())
    print(f"{name}: {chart}; {ball} pixels of a yellow ball, {picture}", flush=True)
    assert ball > 200, "the narrowest place has no ball"
    return chart


atoms = session("atoms", [])
assert "Narrowest: 1.337 ± 0.0" in atoms and "radii of the atoms" in atoms and "label 1.34" in atoms, atoms
hole = session("hole", [RADII, PAUSE, APPLY, PAUSE, PAUSE])
assert "Narrowest: 1.200 ± 0.0" in hole and "radii of HOLE" in hole and "label 1.20" in hole, hole
