"""The diffusion filters in ParaView's pipeline, and the same results on 1, 2 and 4 ranks."""

import os
import subprocess
import tempfile
from pathlib import Path

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from output_window import said

HERE = Path(__file__).resolve().parent


def array(proxy, name):
    proxy.UpdatePipeline()
    return vtk_to_numpy(servermanager.Fetch(proxy).GetPointData().GetArray(name)).astype(float)


def check_pipeline():
    """Diffused, decomposed and filtered in the pipeline browser's terms."""
    source = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
    original = array(source, "RTData")
    # Named, since ParaView's Python takes the default from the active source, not from Input.
    wavelet = {"Input": source, "Scalars": ["POINTS", "RTData"]}
    diffused = simple.HighOrderDiffusion(**wavelet, Order=1, Time=1)
    smooth = array(diffused, "RTData")
    assert smooth.std() < original.std()
    assert abs(smooth.mean() / original.mean() - 1) < 1e-6
    assert servermanager.Fetch(diffused).GetFieldData().GetArray("StepChange").GetNumberOfTuples() > 1
    edges = array(simple.DiffusionHighPass(**wavelet), "HighPass")
    assert edges.min() < 0 < edges.max()
    transform = simple.PDETransform(**wavelet, NumberOfModes=3)
    total = sum(array(transform, name) for name in ("Mode1", "Mode2", "Mode3", "Residue"))
    assert numpy.abs(total - original).max() < 1e-4


def check_error():
    """Scripts that relied on the automatic default of before: an error that names Denoise Map, no result."""
    wavelet = simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5])
    for name in ("Automatic", "Goal", "Strength", "KnownNoise"):
        assert not hasattr(simple.HighOrderDiffusion(Input=wavelet), name), name
    for settings in ({}, {"EdgeStopping": "None"}, {"Flow": "Geometric flow", "Fidelity": 0.5}):
        with said("ErrorEvent") as errors:
            diffused = simple.HighOrderDiffusion(Input=wavelet, **settings)
            diffused.UpdatePipeline()
        assert any("Denoise Map chooses" in each for each in errors), (settings, errors)
        assert servermanager.Fetch(diffused).GetNumberOfPoints() == 0


def results_on(ranks, folder):
    """Whole images of diffusion_ranks.py's results, put together from the ranks' parts."""
    output = folder / f"on{ranks}"
    command = ["mpirun", "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
    # This pvpython is itself a process of MPI and has told so in its environment.
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("OMPI_COMM", "OMPI_MCA", "PMIX_", "ORTE_"))}
    told = subprocess.run(
        command + ["pvbatch", *(["--sym"] if ranks > 1 else []), str(HERE / "diffusion_ranks.py"),
                   str(output)],
        check=True, timeout=240, env=dict(environment, DISPLAY=""), stdout=subprocess.PIPE, text=True)
    assert ranks < 4 or "has no nodes of the small image" in told.stdout
    whole = {}
    for rank in range(ranks):
        part = numpy.load(f"{output}.{rank}.npz")
        for name in part.files:
            stem, key = name.split(".")
            if key in ("extent", "whole"):
                continue
            e, w = part[f"{stem}.extent"], part[f"{stem}.whole"]
            image = whole.setdefault(name, numpy.full(w[5::-2] - w[4::-2] + 1, numpy.nan))
            box = tuple(slice(e[2 * a] - w[2 * a], e[2 * a + 1] - w[2 * a] + 1) for a in (2, 1, 0))
            image[box] = part[name].reshape(image[box].shape)
    return whole


def check_ranks():
    with tempfile.TemporaryDirectory() as folder:
        single = results_on(1, Path(folder))
        for ranks in (2, 4):
            several = results_on(ranks, Path(folder))
            for name, expected in single.items():
                error = numpy.abs(several[name] - expected).max() / numpy.abs(expected).max()
                print(f"{name} on {ranks} ranks: relative difference {error:.1e}")
                assert error < 1e-10, name
                assert error == 0 or "chosen" not in name, "the choice depends on the ranks"


check_pipeline()
check_error()
check_ranks()
