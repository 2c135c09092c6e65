"""The main job of Examples/run.sh on the phantom and, where there is one, on GroEL (EMD-5043)."""

import json
import os
import subprocess
import sys
from pathlib import Path

from paraview import simple
from vtkmodules.vtkIOImage import vtkPNGReader

from shared_data import shared_data

EXAMPLES = Path(os.environ["ISTHMUS_EXAMPLES_DIR"])
OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "MapToCurvature"
sys.path.insert(0, str(EXAMPLES))
import ChooseMap  # noqa: E402


def run_example(path, folder, *level):
    subprocess.run(["pvpython", str(EXAMPLES / "MapToCurvature.py"), str(path), str(folder), *level],
                   check=True, timeout=300)
    return json.loads((folder / "report.json").read_text())


def check_files(folder):
    """The picture is one of some size and not of one colour; surface and state can be read back."""
    reader = vtkPNGReader()
    reader.SetFileName(str(folder / "curvature.png"))
    reader.Update()
    picture = reader.GetOutput()
    assert picture.GetDimensions()[:2] == (1800, 1200), picture.GetDimensions()
    assert picture.GetPointData().GetScalars().GetRange(0)[1] > 200
    assert (folder / "denoising.png").stat().st_size > 20000
    assert (folder / "report.txt").read_text().count("\n") > 8

    surface = simple.OpenDataFile(str(folder / "surface.vtp"))
    arrays = surface.PointData.keys()
    for name in ("GaussianCurvature", "MeanCurvature", "MaximumCurvature", "MinimumCurvature",
                 "ShapeIndex", "Curvedness", "CurvatureValid"):
        assert name in arrays, (name, arrays)

    simple.ResetSession()
    simple.LoadState(str(folder / "pipeline.pvsm"))
    names = sorted(name for name, _ in simple.GetSources())
    assert any("HessianCurvature" in name for name in names), names
    assert len(simple.GetViews()) == 6


def check_phantom():
    """Two rings of seven blobs that touch: one closed piece whose two genus counts agree."""
    OUTPUT.mkdir(parents=True, exist_ok=True)
    ChooseMap.write_phantom(OUTPUT / "phantom.mrc")
    report = run_example(OUTPUT / "phantom.mrc", OUTPUT / "phantom", "0.5")
    surface = report["surface"]
    assert surface["closed"] and surface["components"] == 1, surface
    counted, integrated = (surface["genus_from_euler_number"], surface["genus_from_gaussian_curvature"])
    assert abs(counted - integrated) < 0.25, (counted, integrated)
    for name, row in report["descriptors"].items():
        assert row["minimum"] <= row["area_weighted_mean"] <= row["maximum"], (name, row)
    assert report["descriptors"]["MeanCurvature"]["area_weighted_mean"] > 0
    check_files(OUTPUT / "phantom")


def check_groel():
    """EMD-5043 at the automatic level: the whole assembly, and Gauss-Bonnet to a few handles."""
    report = run_example(shared_data("maps/emd_5043.map"), OUTPUT / "groel")
    assert report["map"]["dimensions"] == [100, 100, 100]
    surface = report["surface"]
    assert surface["closed"] and 1e5 < surface["enclosed_volume_A3"] < 2e6, surface
    check_files(OUTPUT / "groel")


check_phantom()
check_groel()
