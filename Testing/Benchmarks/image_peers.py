"""What a user of Python would take for a volume, beside ours: scikit-image, scipy, mrcfile.

Usage: image_peers.py RESULT.json, with PYTHONPATH set as for any script. The median of three turns of
all trials, after one that is not counted. Ours run on all threads, theirs on those they take (one).
"""

import importlib
import json
import statistics
import sys
import tempfile
import time
from pathlib import Path

import isthmus
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

TURNS = 3
NODES = 128
LEVEL = 0.5


def balls_in_noise(n):
    """As in BenchHighOrderDiffusion: floats, noise as strong as the balls."""
    x, y, z = (numpy.indices((n, n, n), dtype="f4") % 32) - 16
    noise = numpy.random.default_rng(1).normal(0, 0.4, (n, n, n))
    return ((x * x + y * y + z * z < 100) + noise).astype("f4")


def image_of(values):
    image = vtkImageData()
    image.SetDimensions(values.shape[::-1])
    array = numpy_to_vtk(values.ravel())
    array.SetName("Density")
    image.GetPointData().SetScalars(array)
    return image


def ours(name, values, **properties):
    """A trial of a filter of ours on a volume."""
    image = image_of(values)

    def run():
        algorithm = getattr(isthmus, name)()
        for key, value in properties.items():
            getattr(algorithm, "Set" + key)(value)
        algorithm.SetInputData(image)
        algorithm.Update()
        assert algorithm.GetOutputDataObject(0).GetNumberOfPoints() > 0, name

    return run


def read_by_us(path):
    reader = isthmus.vtkMRCMapReader()
    reader.SetFileName(str(path))
    reader.Update()
    assert reader.GetOutput().GetNumberOfPoints() > 0


class Peer:
    """A trial that needs a module of Debian's package."""

    def __init__(self, module, package, work):
        self.work = work
        self.missing = None
        try:
            self.module = importlib.import_module(module)
        except ImportError:
            self.missing = f"missing: {package}"

    def __call__(self):
        self.work(self.module)


def hessian_eigenvalues(feature, values):
    elements = feature.hessian_matrix(values, sigma=1.0, order="xyz")
    return feature.hessian_matrix_eigvals(elements)


def filter_trials(noisy, smooth):
    return {
        "denoise": ours("vtkDenoiseMap", noisy),
        "total variation": Peer("skimage.restoration", "python3-skimage",
                                lambda m: m.denoise_tv_chambolle(noisy)),
        "median": Peer("scipy.ndimage", "python3-scipy", lambda m: m.median_filter(noisy, 3)),
        "high-pass": ours("vtkDiffusionHighPass", noisy),
        "two Gaussians": Peer("scipy.ndimage", "python3-scipy",
                              lambda m: m.gaussian_filter(noisy, 1.0) - m.gaussian_filter(noisy, 3.0)),
        "curvature": ours("vtkHessianCurvature", smooth, AutomaticScale=False),
        "Hessian eigenvalues": Peer("skimage.feature", "python3-skimage",
                                    lambda m: hessian_eigenvalues(m, smooth)),
        "surface": ours("vtkMapSurface", smooth, AutomaticLevel=False, Level=LEVEL),
        "marching cubes": Peer("skimage.measure", "python3-skimage",
                               lambda m: m.marching_cubes(smooth, LEVEL)),
    }


def reading_trials(folder, values):
    """The same floats in a plain and a compressed file."""
    trials = {}
    writer = Peer("mrcfile", "python3-mrcfile", None)
    for name, suffix, compression in (("map", "mrc", None), ("map.gz", "mrc.gz", "gzip"),
                                      ("map.bz2", "mrc.bz2", "bzip2")):
        path = Path(folder, f"map.{suffix}")
        peer = Peer("mrcfile", "python3-mrcfile", lambda m, path=path: m.read(path))
        trials["mrcfile " + name] = peer
        trials["read " + name] = lambda path=path: read_by_us(path)
        if writer.missing:
            del trials["read " + name]  # nothing to read
        else:
            with writer.module.new(path, values, compression=compression) as file:
                file.voxel_size = 1.0
    return trials


def measured(trials):
    """name -> seconds of each turn that counts."""
    times = {name: [] for name, trial in trials.items() if not getattr(trial, "missing", None)}
    for turn in range(TURNS + 1):
        for name, took in times.items():
            start = time.monotonic()
            trials[name]()
            if turn > 0:
                took.append(time.monotonic() - start)
    return times


def main(path):
    noisy = balls_in_noise(NODES)
    smooth = numpy.ascontiguousarray(
        sum(numpy.roll(noisy, shift, axis) for axis in range(3) for shift in (-2, -1, 0, 1, 2)) / 15)
    with tempfile.TemporaryDirectory() as folder:
        trials = {**filter_trials(noisy, smooth), **reading_trials(folder, noisy)}
        times = measured(trials)
    rows = [{"name": name, "real_time": statistics.median(times[name]), "time_unit": "s"}
            if name in times else
            {"name": name, "real_time": 0, "time_unit": "s", "error_occurred": True,
             "error_message": trial.missing}
            for name, trial in trials.items()]
    with open(path, "w", encoding="utf-8") as file:
        json.dump({"benchmarks": rows}, file, indent=1)


if __name__ == "__main__":
    main(sys.argv[1])
