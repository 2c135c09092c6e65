"""An APBS potential opened through ParaView, sampled at atoms beside scipy, written and read back."""

import gzip
import os
import tempfile

import numpy
from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from scipy.interpolate import RegularGridInterpolator
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkProbeFilter

from shared_data import shared_data


def independent_grid(path):
    """The file by numpy alone: axes x, y, z and the values indexed by them."""
    with gzip.open(path, "rt") as file:
        lines = file.read().splitlines()
    head = next(i for i, line in enumerate(lines) if "follows" in line)
    counts = [int(w) for line in lines if "gridpositions" in line for w in line.split()[-3:]]
    origin = [float(w) for line in lines if line.startswith("origin") for w in line.split()[1:]]
    deltas = numpy.array([line.split()[1:] for line in lines if line.startswith("delta")], float)
    words = " ".join(lines[head + 1 : head + 1 + -(-numpy.prod(counts) // 3)])
    values = numpy.array(words.split(), float).reshape(counts)
    axes = [origin[a] + deltas[a, a] * numpy.arange(counts[a]) for a in range(3)]
    return axes, values


def atoms(path):
    return numpy.array(
        [[float(w) for w in line.split()[-5:-2]] for line in open(path) if line.startswith("ATOM")]
    )


potential_file = shared_data("molecules/1hew/1hew_potential.dx.gz")
source = simple.OpenDataFile(str(potential_file))
assert source.GetXMLName() == "OpenDXReader", source.GetXMLName()
image = servermanager.Fetch(source)
axes, values = independent_grid(potential_file)
read = vtk_to_numpy(image.GetPointData().GetArray("Potential")).reshape(values.shape, order="F")
assert (read == values).all()
for extreme in (numpy.argmin, numpy.argmax):
    index = numpy.unravel_index(extreme(values), values.shape)
    found = image.GetPoint(int(extreme(read.ravel(order="F"))))
    assert numpy.allclose(found, [axes[a][index[a]] for a in range(3)], atol=1e-12)

points = atoms(shared_data("molecules/1hew/1hew.pqr"))
assert len(points) == 1960
poly = vtkPolyData()
poly.SetPoints(vtkPoints())
poly.GetPoints().SetDataTypeToDouble()
for point in points:
    poly.GetPoints().InsertNextPoint(point)
probe = vtkProbeFilter()
probe.SetInputData(poly)
probe.SetSourceData(image)
probe.Update()
sampled = vtk_to_numpy(probe.GetOutput().GetPointData().GetArray("Potential"))
expected = RegularGridInterpolator(axes, values)(points)
assert numpy.abs(sampled - expected).max() <= 1e-10 * numpy.abs(expected).max()

corner = simple.ExtractSubset(Input=source, VOI=[10, 60, 20, 50, 30, 90])
with tempfile.TemporaryDirectory() as folder:
    for name in ("copy.dx", "copy.dx.gz"):
        path = os.path.join(folder, name)
        simple.SaveData(path, corner)
        again = servermanager.Fetch(simple.OpenDataFile(path))
        assert again.GetSpacing() == image.GetSpacing()
        assert again.GetOrigin() == image.GetPoint(image.ComputePointId([10, 20, 30]))
        copied = vtk_to_numpy(again.GetPointData().GetArray("Potential"))
        assert (copied == read[10:61, 20:51, 30:91].ravel(order="F")).all()
# APBS' binary files have an ending of their own.
binary = simple.OpenDataFile(str(shared_data("reports/n01_apbs.dxbin")))
assert binary.GetXMLName() == "OpenDXReader", binary.GetXMLName()
image = servermanager.Fetch(binary)
assert image.GetDimensions() == (3, 3, 3)
# z runs fastest in the file, x in the image.
values = vtk_to_numpy(image.GetPointData().GetArray("Potential")).reshape((3, 3, 3), order="F")
assert (values.ravel() == numpy.arange(27)).all(), values
print("the potential is the file's")
