"""The second half of Examples/run.sh, on the phantom: Delaunay surface, tetrahedra, their pictures,
and the choking loops of that surface."""

import os
import subprocess
import sys
from pathlib import Path

from paraview import servermanager, simple

EXAMPLES = Path(os.environ["ISTHMUS_EXAMPLES_DIR"])
OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "MapToMesh"
sys.path.insert(0, str(EXAMPLES))
import choose_map  # noqa: E402


def run(script, *arguments):
    return subprocess.run(["pvpython", str(EXAMPLES / script), *map(str, arguments)], check=True,
                          timeout=300, stdout=subprocess.PIPE, text=True).stdout


OUTPUT.mkdir(parents=True, exist_ok=True)
choose_map.write_phantom(OUTPUT / "phantom.mrc")
printed = run("map_to_mesh.py", OUTPUT / "phantom.mrc", OUTPUT, 0.5)
text = (OUTPUT / "mesh.txt").read_text()
assert text.endswith(printed) and printed.count("\n") == 3, printed

# Each histogram holds all angles; marching cubes has some below 30 degrees, Delaunay has none.
rows = [line for line in text.splitlines() if " - " in line]
assert len(rows) == 18, text
shares = [[float(row[12:].split("%")[0]), float(row[12 + 49:].split("%")[0])] for row in rows]
for column in (0, 1):
    assert abs(sum(share[column] for share in shares) - 100) < 1, text
assert sum(share[0] for share in shares[:3]) > 1 and sum(share[1] for share in shares[:3]) == 0, text

# The tetrahedra fill just what the surface encloses.
surface = simple.OpenDataFile(str(OUTPUT / "surface_delaunay.vtp"))
measures = servermanager.Fetch(simple.SurfaceMeasures(Input=surface)).GetFieldData()
sizes = simple.CellSize(Input=simple.OpenDataFile(str(OUTPUT / "tetrahedra.vtu")))
volume = sum(servermanager.Fetch(simple.IntegrateVariables(Input=sizes)).GetCellData()
             .GetArray("Volume").GetTuple(0))
enclosed = measures.GetArray("Volume").GetValue(0)
assert abs(volume / enclosed - 1) < 1e-9, (volume, enclosed)

printed = run("choking_loops.py", OUTPUT / "surface_delaunay.vtp", OUTPUT / "choking_loops.png")
genus = int(measures.GetArray("Genus").GetValue(0))
assert f"handles {genus}, tunnels {genus}" in printed, (genus, printed)
for picture in ("angles", "cutaway", "choking_loops"):
    assert (OUTPUT / f"{picture}.png").stat().st_size > 20000, picture
