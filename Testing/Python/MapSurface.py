"""Map Surface and Curvature On Surface as a user has them: the level recommended beside the map, dust,
closing at the border; the automatic level on maps whose molecule is known; required second inputs."""

import shutil
import tempfile
from pathlib import Path

from paraview import servermanager, simple
from shared_data import shared_data

HEADER = """<emd emdb_id="EMD-5043"><map><contour_list><contour primary="true"><level>%s</level>
<source>AUTHOR</source></contour></contour_list></map></emd>"""
PER_DALTON = 1.21  # cubic angstrom, of protein
# Map and mass of what it shows (dalton): seven and fourteen chains of GroEL, Arp2/3, ubiquitin.
KNOWN = (("1oel_10.mrc", 7 * 57.2e3), ("emd_5043.map", 14 * 57.2e3), ("1tyq_10.mrc", 220e3),
         ("Ubi-8.5.mrc", 8.57e3))


def measures(surface):
    measured = simple.SurfaceMeasures(Input=surface)
    fields = servermanager.Fetch(measured).GetFieldData()
    return {name: fields.GetArray(name).GetValue(0)
            for name in ("Volume", "Components", "OpenEdges", "Genus", "Level", "ComponentsFound")}


for name, mass in KNOWN:
    reader = simple.OpenDataFile(str(shared_data(f"maps/{name}")))
    found = measures(simple.MapSurface(Input=reader))
    ratio = found["Volume"] / (PER_DALTON * mass)
    print(f"{name}: level {found['Level']:.4g}, {ratio:.2f} of the molecule's volume")
    assert 2 / 3 < ratio < 3 / 2, (name, ratio)
    assert found["OpenEdges"] == 0

with tempfile.TemporaryDirectory() as folder:
    path = Path(folder) / "emd_5043.map"
    shutil.copy(shared_data("maps/emd_5043.map"), path)
    (Path(folder) / "emd-5043.xml").write_text(HEADER % 1.75)
    density = simple.OpenDataFile(str(path))
    surface = simple.MapSurface(Input=density)
    assert measures(surface)["Level"] == 1.75
    surface.AutomaticLevel, surface.Level = 0, 2.4
    found = measures(surface)
    assert (found["Level"], found["Components"], found["Genus"]) == (2.4, 4, 22), found
    surface.LargestComponents = 1
    assert measures(surface)["Components"] == 1
    surface.LargestComponents = 0
    surface.MinimumComponentArea = 5000.0
    found = measures(surface)
    assert found["ComponentsFound"] == 4 and found["Components"] < 4, found

    # Both inputs are required: ParaView's window asks for what a menu entry has not.
    prototype = servermanager.ProxyManager().GetPrototypeProxy("filters", "CurvatureOnSurface")
    for name in ("Input", "Volume"):
        hints = prototype.GetProperty(name).GetHints()
        assert hints is None or hints.FindNestedElementByName("Optional") is None, name
    curvature = simple.CurvatureOnSurface(Input=surface, Volume=density)
    curvature.UpdatePipeline()
    data = servermanager.Fetch(curvature)
    assert data.GetNumberOfPoints() == servermanager.Fetch(surface).GetNumberOfPoints()
    assert data.GetPointData().GetScalars().GetName() == "MeanCurvature"
print("passed")
