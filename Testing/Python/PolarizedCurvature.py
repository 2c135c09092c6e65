"""Polarized curvature by ParaView's proxies beside numpy and scipy, on a sphere in a made potential."""

import os
import tempfile

import numpy
from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from scipy.interpolate import RegularGridInterpolator

AXES = [numpy.linspace(-4.0, 4.0, n) for n in (21, 25, 33)]
RADIUS = 3.0


def made_potential():
    x, y, z = numpy.meshgrid(*AXES, indexing="ij")
    return 2.0 * z - x * y + 0.3


def write_dx(path, values):
    """The file by hand, so that the reader is not judged by our writer."""
    steps = [axis[1] - axis[0] for axis in AXES]
    with open(path, "w") as file:
        file.write("object 1 class gridpositions counts %d %d %d\n" % values.shape)
        file.write("origin -4 -4 -4\n")
        file.write("delta %.17g 0 0\ndelta 0 %.17g 0\ndelta 0 0 %.17g\n" % tuple(steps))
        file.write(f"object 3 class array type double rank 0 items {values.size} data follows\n")
        file.write("\n".join("%.17g" % value for value in values.ravel()) + "\n")


with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "made.dx")
    values = made_potential()
    write_dx(path, values)
    potential = simple.OpenDataFile(path)
    sphere = simple.Sphere(Radius=RADIUS, ThetaResolution=120, PhiResolution=121)
    curved = simple.SurfaceCurvature(Input=sphere, PointAreaRule="Mixed")
    polarized = simple.PolarizedCurvature(Input=curved, PotentialImage=potential)
    result = servermanager.Fetch(polarized)
    alone = simple.PolarizedCurvature(Input=polarized)  # the potential is an array now
    again = servermanager.Fetch(alone)


def array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name)).astype(float)


points = vtk_to_numpy(result.GetPoints().GetData()).astype(float)
phi = RegularGridInterpolator(AXES, values)(points)
assert numpy.abs(array(result, "Potential") - phi).max() < 1e-9
kappa1, kappa2 = array(result, "MaximumCurvature"), array(result, "MinimumCurvature")
assert numpy.abs(kappa1[5:-5] - 1.0 / RADIUS).max() < 0.05
for name, expected in {
    "PositivePotentialKappa1": numpy.maximum(phi, 0.0) * kappa1,
    "PositivePotentialKappa2": numpy.maximum(phi, 0.0) * kappa2,
    "NegativePotentialKappa1": numpy.minimum(phi, 0.0) * kappa1,
    "NegativePotentialKappa2": numpy.minimum(phi, 0.0) * kappa2,
    "PolarizedCurvature": phi * kappa2,
}.items():
    assert numpy.abs(array(result, name) - expected).max() < 1e-8, name
    assert (array(result, name) == array(again, name)).all(), name
convex = (kappa1 > 0.0) & (kappa2 > 0.0)
assert (array(result, "SiteClass")[convex] == numpy.where(phi > 0.0, 1, 3)[convex]).all()
assert result.GetFieldData().GetAbstractArray("SiteClassNames").GetValue(3).endswith("protein")
print("products and classes are numpy's")
