"""The curvature filter through ParaView: with and without a surface; on 1, 2 and 4 MPI ranks."""

import os
import shutil
import subprocess
from pathlib import Path

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "HessianCurvature"
SIX = ("GaussianCurvature", "MeanCurvature", "MaximumCurvature", "MinimumCurvature", "ShapeIndex",
       "Curvedness")


def values(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def check_pipeline():
    """A sphere of radius 8 from a density, coloured at nodes and on a contour."""
    wavelet = simple.Wavelet(WholeExtent=[-15, 15, -15, 15, -15, 15])
    density = simple.Calculator(Input=wavelet, ResultArrayName="Density",
                                Function="64/(64+coordsX^2+coordsY^2+coordsZ^2)")
    at_nodes = simple.HessianCurvature(Input=density, Scalars=["POINTS", "Density"], Accuracy=4)
    data = servermanager.Fetch(at_nodes)
    assert data.IsA("vtkImageData") and data.GetPointData().GetArray("RTData"), data
    for name in SIX:
        assert values(data, name).shape == (31 ** 3,), name

    contour = simple.Contour(Input=density, ContourBy=["POINTS", "Density"], Isosurfaces=[0.5])
    at_points = simple.HessianCurvature(
        Input=density, Surface=contour, Scalars=["POINTS", "Density"], Accuracy=4,
        ShapeIndexConvention="Koenderink (peak +1, pit -1)", OutputArrays=[*SIX, "SurfaceType", "PrincipalDirection1"])
    data = servermanager.Fetch(at_points)
    assert data.IsA("vtkPolyData") and data.GetNumberOfPolys() > 1000, data
    assert values(data, "CurvatureValid").all()
    expected = (("MeanCurvature", 1 / 8, 5e-4), ("GaussianCurvature", 1 / 64, 2e-4),
                ("ShapeIndex", 1.0, 1e-2), ("SurfaceType", 8, 0.0))
    for name, exact, tolerance in expected:
        worst = numpy.abs(values(data, name) - exact).max()
        assert worst <= tolerance, (name, worst)
    lengths = numpy.linalg.norm(values(data, "PrincipalDirection1"), axis=1)
    assert numpy.allclose(lengths, 1.0, atol=1e-6)
    names = data.GetFieldData().GetAbstractArray("SurfaceTypeNames")
    assert names.GetValue(8) == "Peak", names


def run_on(ranks):
    script = Path(__file__).parent / "curvature_ranks.py"
    # pvpython is an MPI program itself and leaves settings that a second mpirun must not see.
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("OMPI_", "PMIX_", "ORTE_"))}
    subprocess.run(["mpirun", "--oversubscribe", "--allow-run-as-root", "-np", str(ranks),
                    "pvbatch", "--sym", str(script), str(OUTPUT)],
                   check=True, timeout=150, env=environment)


def load(case, ranks):
    parts = [numpy.load(OUTPUT / f"{case}.{ranks}.{rank}.npz") for rank in range(ranks)]
    return {name: numpy.concatenate([part[name] for part in parts]) for name in parts[0].files}


def compare(case, ranks):
    """Every point of every rank has the values of one rank at its place, and none is missing. The scale is the same
    in every bit; values may differ by rounding, since positions count from the first node of the rank's piece, and a
    point's place in its block decides whether the vectorised loop or its remainder computes it."""
    whole, parts = load(case, 1), load(case, ranks)
    places = [tuple(p) for p in numpy.round(whole["positions"], 4)]
    index = {place: i for i, place in enumerate(places)}
    match = numpy.array([index[tuple(p)] for p in numpy.round(parts["positions"], 4)])
    assert len(set(match)) == len(index), f"{case}, {ranks} ranks: places are missing"
    worst = 0.0
    for name in whole.keys() - {"positions"}:
        expected, found = whole[name][match].astype(float), parts[name].astype(float)
        assert name != "CurvatureScale" or (found == expected).all(), (case, ranks)
        relative = numpy.abs(found - expected) / numpy.maximum(numpy.abs(expected), 1e-300)
        worst = max(worst, relative.max())
    valid = int(whole["CurvatureValid"].sum())
    print(f"{case}, {ranks} ranks: {len(index)} places, {valid} valid, "
          f"largest relative difference {worst:.1e}")
    assert valid > 0 and worst <= 1e-10, (case, ranks, worst)


def check_ranks():
    shutil.rmtree(OUTPUT, ignore_errors=True)
    OUTPUT.mkdir(parents=True)
    for ranks in (1, 2, 4):
        run_on(ranks)
    for ranks in (2, 4):
        for place in ("nodes", "contour", "sphere"):
            for accuracy in (2, 4):
                for scale in (0.0, 1.2, -1.0):  # -1: automatic
                    compare(f"{place}_{accuracy}_{scale}", ranks)


check_pipeline()
check_ranks()
