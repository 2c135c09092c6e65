"""The main job of Examples/run.sh on the phantom and, where there is one, on GroEL (EMD-5043)."""

import json
import os
import subprocess
import sys
from pathlib import Path

import isthmus
import mrcfile
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from shared_data import shared_data

EXAMPLES = Path(os.environ["ISTHMUS_EXAMPLES_DIR"])
OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "MapToCurvature"
# The contour of GroEL at Otsu's level: 4 pieces with 22 handles, by V - E + F, which is exact, and so by the angle
# defects, whose sum is 4 pi (4 - 22). The curvature of the volume is as exact as the map resolves the surface: 1 % of
# its area bends within a voxel (curvedness beyond 1 / spacing) and gives a third of the integral. Where it does not,
# both integrals are over the same points; errors of second-order differences are of the order of (spacing x
# curvedness)^2 / 4 there, a quarter at most.
GROEL_GENUS, GROEL_PIECES, GROEL_SPACING = 22, 4, 3.05
RESOLVED_TOLERANCE = 0.25
sys.path.insert(0, str(EXAMPLES))
import choose_map  # noqa: E402


def run_example(path, folder, *level):
    subprocess.run(["pvpython", str(EXAMPLES / "map_to_curvature.py"), str(path), str(folder), *level],
                   check=True, timeout=300)
    return json.loads((folder / "report.json").read_text())


def check_picture(path):
    """Six cells, each with a coloured surface on a white ground, and no two alike."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    picture = reader.GetOutput()
    assert picture.GetDimensions()[:2] == (1800, 1200), picture.GetDimensions()
    pixels = vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(1200, 1800, -1)[..., :3].astype(int)
    cells = [pixels[y:y + 600, x:x + 600] for y in (0, 600) for x in (0, 600, 1200)]
    for number, cell in enumerate(cells):
        coloured = (cell.max(axis=2) - cell.min(axis=2) > 40).mean()
        white = (cell.min(axis=2) > 240).mean()
        assert 0.03 < coloured < 0.9 and white > 0.05, (number, coloured, white)
        for other in cells[:number]:
            assert abs(cell - other).mean() > 1.0, number
    # The mean curvature (rows count from below) is mostly positive, and red says so.
    mean = cells[4]
    assert (mean[..., 0] - mean[..., 2] > 40).mean() > 0.05


def check_files(folder):
    """The picture shows six descriptors; surface and state can be read back."""
    check_picture(folder / "curvature.png")
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
    choose_map.write_phantom(OUTPUT / "phantom.mrc")
    report = run_example(OUTPUT / "phantom.mrc", OUTPUT / "phantom", "0.5")
    surface = report["surface"]
    assert surface["closed"] and surface["components"] == 1, surface
    counted, integrated = (surface["genus_from_euler_number"], surface["genus_from_gaussian_curvature"])
    assert abs(counted - integrated) < 0.05, (counted, integrated)
    for name, row in report["descriptors"].items():
        assert row["minimum"] <= row["area_weighted_mean"] <= row["maximum"], (name, row)
    assert report["descriptors"]["MeanCurvature"]["area_weighted_mean"] > 0
    check_files(OUTPUT / "phantom")


def check_ball():
    """A ball's curvature adds up to 4 pi: a scale that is wrong shows, as it does not on the phantom's ring."""
    steps = numpy.indices((40, 40, 40)) - 19.5
    with mrcfile.new(OUTPUT / "ball.mrc", numpy.exp(-(steps ** 2).sum(0) / 200).astype("f4"), overwrite=True) as file:
        file.voxel_size = 3.0
    surface = run_example(OUTPUT / "ball.mrc", OUTPUT / "ball", "0.5")["surface"]
    assert surface["genus_from_euler_number"] == 0, surface
    assert abs(surface["genus_from_gaussian_curvature"]) < 0.01, surface


def resolved_integrals(folder):
    """Gaussian curvature over 4 pi where the surface does not bend within a voxel: of the volume, and by defects."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(folder / "surface.vtp"))
    reader.Update()
    surface = reader.GetOutput()
    defects = isthmus.vtkSurfaceCurvature()
    defects.SetInputData(surface)
    defects.SetDualArea(isthmus.vtkSurfaceCurvature.Barycentric)
    defects.Update()
    values = {name: vtk_to_numpy(surface.GetPointData().GetArray(name)).astype(float)
              for name in ("GaussianCurvature", "Curvedness", "CurvatureValid")}
    exact = vtk_to_numpy(defects.GetOutput().GetPointData().GetArray("GaussianCurvature"))
    areas = vtk_to_numpy(defects.GetOutput().GetPointData().GetArray("PointArea"))
    whole = (exact * areas).sum() / (4 * numpy.pi)
    assert abs(whole - (GROEL_PIECES - GROEL_GENUS)) < 1e-6, whole
    resolved = (values["Curvedness"] * GROEL_SPACING < 1.0) & (values["CurvatureValid"] > 0)
    assert areas[resolved].sum() > 0.98 * areas.sum()
    return [(k * areas)[resolved].sum() / (4 * numpy.pi) for k in (values["GaussianCurvature"], exact)]


def check_groel():
    """EMD-5043 at the automatic level: the whole assembly, its handles, and Gauss-Bonnet where it is resolved."""
    report = run_example(shared_data("maps/emd_5043.map"), OUTPUT / "groel")
    assert report["map"]["dimensions"] == [100, 100, 100]
    surface = report["surface"]
    assert surface["closed"] and 1e5 < surface["enclosed_volume_A3"] < 2e6, surface
    counted, integrated = (surface["genus_from_euler_number"], surface["genus_from_gaussian_curvature"])
    assert surface["components"] == GROEL_PIECES and counted == GROEL_GENUS, surface
    volume, defects = resolved_integrals(OUTPUT / "groel")
    print(f"GroEL: genus {counted} by counting, {integrated:.2f} by the integral of the curvature; where it is resolved "
          f"the integrals are {volume:.2f} and {defects:.2f} of 4 pi")
    assert abs(volume - defects) < RESOLVED_TOLERANCE * abs(defects), (volume, defects)
    check_files(OUTPUT / "groel")


check_phantom()
check_ball()
check_groel()
