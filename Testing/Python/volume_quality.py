"""Phantoms, noise and measures for the tests of the denoising filters."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import (
    vtkFlyingEdges3D, vtkMassProperties, vtkPolyDataConnectivityFilter)


def sigmoid(distance):
    """A wall one voxel thick between inside (1, negative distance) and outside (0)."""
    return 1 / (1 + numpy.exp(numpy.clip(2 * distance, -60, 60)))


def phantom(seed, n=64):
    """Blobs, tubes, shells and boxes with sharp edges at random places of an n^3 volume."""
    random = numpy.random.default_rng(seed)
    grid = numpy.stack(numpy.meshgrid(*[numpy.arange(n)] * 3, indexing="ij")).astype(float)
    volume = numpy.zeros((n, n, n))

    def from_center():
        return grid - random.uniform(0.2 * n, 0.8 * n, 3)[:, None, None, None]

    for _ in range(8):
        square = (from_center() ** 2).sum(axis=0)
        volume += random.uniform(0.6, 1.2) * numpy.exp(-square / (2 * random.uniform(3, 6) ** 2))
    for _ in range(5):
        offset = from_center()
        axis = random.normal(size=3)
        along = numpy.tensordot(axis / numpy.linalg.norm(axis), offset, 1)
        across = numpy.sqrt(numpy.maximum((offset**2).sum(axis=0) - along**2, 0))
        tube = sigmoid(across - random.uniform(2, 3.5))
        volume = numpy.maximum(volume, tube * sigmoid(abs(along) - random.uniform(10, 20)))
    for _ in range(3):
        radius = numpy.sqrt((from_center() ** 2).sum(axis=0))
        volume = numpy.maximum(volume, abs(radius - random.uniform(7, 12)) < 1.6)
    for _ in range(3):
        half = random.uniform(4, 8, 3)[:, None, None, None]
        inside = (abs(from_center()) < half).all(axis=0)
        volume = numpy.maximum(volume, inside * random.uniform(0.8, 1.2))
    return volume


def with_noise(volume, signal_to_noise, seed):
    """Added white noise; the ratio is that of the variances."""
    noise = numpy.random.default_rng(seed).normal(size=volume.shape)
    return volume + noise * numpy.sqrt(volume.var() / signal_to_noise)


def as_image(volume):
    """A vtkImageData of spacing 1 with the volume (indexed z, y, x) as float scalars."""
    image = vtkImageData()
    image.SetDimensions(volume.shape[::-1])
    scalars = numpy_to_vtk(volume.astype(numpy.float32).ravel(), deep=True)
    scalars.SetName("Density")
    image.GetPointData().SetScalars(scalars)
    return image


def as_volume(image):
    """The active scalars of an image, indexed z, y, x."""
    scalars = vtk_to_numpy(image.GetPointData().GetScalars())
    return scalars.reshape(image.GetDimensions()[::-1]).astype(float)


def filtered(algorithm, volume):
    """What a vtk filter makes of a volume."""
    algorithm.SetInputData(as_image(volume))
    algorithm.Update()
    return as_volume(algorithm.GetOutput())


def signal_to_noise_peak(volume, truth):
    """PSNR in dB."""
    return 10 * numpy.log10(numpy.ptp(truth) ** 2 / numpy.mean((volume - truth) ** 2))


def shell_correlation(a, b):
    """Fourier shell correlation by whole frequencies (cycles a box), from 1 to Nyquist's."""
    n = a.shape[0]
    frequency = numpy.fft.fftfreq(n, 1 / n)
    radius = numpy.sqrt(sum(f**2 for f in numpy.meshgrid(*[frequency] * 3, indexing="ij")))
    shell = radius.round().astype(int).ravel()
    fa, fb = numpy.fft.fftn(a).ravel(), numpy.fft.fftn(b).ravel()
    cross = numpy.bincount(shell, (fa * fb.conj()).real)
    power = numpy.bincount(shell, abs(fa) ** 2) * numpy.bincount(shell, abs(fb) ** 2)
    return (cross / numpy.sqrt(numpy.maximum(power, 1e-300)))[1 : n // 2]


def half_crossing(correlation):
    """Index of the first shell below 0.5, or how many shells there are."""
    below = numpy.flatnonzero(correlation < 0.5)
    return int(below[0]) if len(below) else len(correlation)


def surface_measures(volume, level):
    """Area and number of components of an isosurface."""
    contour = vtkFlyingEdges3D()
    contour.SetInputData(as_image(volume))
    contour.SetValue(0, level)
    area = vtkMassProperties()
    area.SetInputConnection(contour.GetOutputPort())
    area.Update()
    parts = vtkPolyDataConnectivityFilter()
    parts.SetInputConnection(contour.GetOutputPort())
    parts.SetExtractionModeToAllRegions()
    parts.Update()
    return area.GetSurfaceArea(), parts.GetNumberOfExtractedRegions()
