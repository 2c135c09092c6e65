"""The resampling example against the trilinear formula, written down plainly."""

import os
import sys

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.insert(0, os.environ["ISTHMUS_EXAMPLES_DIR"])
from resample_map import resample  # noqa: E402
from shared_data import shared_data  # noqa: E402


def trilinear(values, nodes):
    """5.17 (corrected) to 5.20; `values` and the result are indexed x, y, z."""
    axes = []
    for size, count in zip(values.shape, nodes):
        x = (size - 1) * numpy.arange(count) / (count - 1)
        cell = numpy.minimum(x.astype(int), size - 2)  # the last node belongs to the last cell
        axes.append((cell, 2 * (x - cell) - 1))
    result = numpy.zeros(nodes)
    for corner in numpy.ndindex(2, 2, 2):
        index = numpy.ix_(*[cell + c for (cell, _), c in zip(axes, corner)])
        weights = [(1 + (2 * c - 1) * xi) / 2 for (_, xi), c in zip(axes, corner)]
        result += values[index] * numpy.einsum("i,j,k->ijk", *weights)
    return result


def check(volume, array, nodes):
    resampled = resample(volume, nodes)
    before = servermanager.Fetch(volume)
    resampled.UpdatePipeline()
    after = servermanager.Fetch(resampled)
    assert after.GetDimensions() == tuple(nodes)
    numpy.testing.assert_allclose(after.GetBounds(), before.GetBounds(), rtol=1e-12)
    values = vtk_to_numpy(before.GetPointData().GetArray(array)).astype(float)
    values = values.reshape(before.GetDimensions(), order="F")
    got = vtk_to_numpy(after.GetPointData().GetArray(array)).reshape(nodes, order="F")
    valid = vtk_to_numpy(after.GetPointData().GetArray("vtkValidPointMask"))
    error = abs(got - trilinear(values, nodes)).max() / numpy.ptp(values)
    print(f"{before.GetDimensions()} -> {tuple(nodes)}: largest error {error:.1e} of the range, "
          f"{(valid == 0).sum()} nodes without a value")
    assert valid.all()
    assert error < 1e-6  # of floats


wavelet = simple.Wavelet(WholeExtent=[-7, 12, 0, 16, 3, 20])
for nodes in ((21, 21, 21), (39, 33, 35), (5, 40, 2)):
    check(wavelet, "RTData", nodes)
emd = simple.OpenDataFile(str(shared_data("maps/emd_1832.map")))
for nodes in ((21, 21, 21), (77, 33, 50)):
    check(emd, "Density", nodes)
