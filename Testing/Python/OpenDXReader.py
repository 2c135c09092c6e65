"""An APBS potential opened through ParaView, sampled at atoms beside scipy, written and read back."""

import gzip
import os
import tempfile

import isthmus
import numpy
from isthmus.command import main
from isthmus.vtkIsthmusReadersPotentials import vtkOpenDXReader
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


def write_binary(path, axes, values, kind, order):
    """A file as APBS writes it; `order` is nothing, lsb or msb."""
    counts = " ".join(map(str, values.shape))
    deltas = [" ".join(str(axis[1] - axis[0] if a == b else 0) for b in range(3)) for a, axis in enumerate(axes)]
    head = (f"object 1 class gridpositions counts {counts}\norigin {' '.join(str(axis[0]) for axis in axes)}\n"
            + "".join(f"delta {delta}\n" for delta in deltas) + f"object 2 class gridconnections counts {counts}\n"
            f"object 3 class array type {kind} rank 0 items {values.size} {order}{' ' * bool(order)}binary data follows\n")
    typed = values.astype(numpy.dtype({"double": "f8", "float": "f4"}[kind]).newbyteorder(
        {"": "=", "lsb": "<", "msb": ">"}[order]))
    content = head.encode() + typed.tobytes() + b'\nattribute "dep" string "positions"\n'
    with (gzip.open if path.endswith(".gz") else open)(path, "wb") as file:
        file.write(content)


def by_every_door(path):
    """The image by ParaView's list of files, by isthmus.read() and by the class."""
    opened = simple.OpenDataFile(path)
    assert opened.GetXMLName() == "OpenDXReader", opened.GetXMLName()
    reader = vtkOpenDXReader()
    reader.SetFileName(path)
    reader.Update()
    assert vtkOpenDXReader.CanReadFile(path), path
    return [servermanager.Fetch(opened), isthmus.read(path), reader.GetOutput()]


# APBS' binary files have an ending of their own.
for image in by_every_door(str(shared_data("reports/n01_apbs.dxbin"))):
    assert image.GetDimensions() == (3, 3, 3)
    # z runs fastest in the file, x in the image.
    values = vtk_to_numpy(image.GetPointData().GetArray("Potential")).reshape((3, 3, 3), order="F")
    assert (values.ravel() == numpy.arange(27)).all(), values
with tempfile.TemporaryDirectory() as folder:
    axes = [numpy.arange(n) * h - o for n, h, o in ((4, 0.5, 1.0), (5, 0.25, -3.0), (7, 2.0, 8.0))]
    expected = numpy.random.default_rng(1).normal(size=(4, 5, 7)).astype("f4").astype(float)
    for name, kind, order in (("double.dxbin", "double", ""), ("float.dxbin", "float", "lsb"),
                              ("swapped.dxbin", "double", "msb"), ("packed.dxbin.gz", "float", "msb"),
                              ("UPPER.DXBIN", "double", "lsb")):
        path = os.path.join(folder, name)
        write_binary(path, axes, expected, kind, order)
        for image in by_every_door(path):
            assert image.GetDimensions() == expected.shape, (name, image.GetDimensions())
            assert image.GetOrigin() == (-1.0, 3.0, -8.0) and image.GetSpacing() == (0.5, 0.25, 2.0), name
            found = vtk_to_numpy(image.GetPointData().GetArray("Potential")).reshape(expected.shape, order="F")
            assert (found == expected).all(), name
    # On the command line, a potential in binary has the same sites as the same in text.
    molecule = str(shared_data("molecules/1crn_apbs.pqr"))
    low, high = atoms(molecule).min(axis=0) - 6.0, atoms(molecule).max(axis=0) + 6.0
    axes = [numpy.arange(low[a], high[a] + 1.0, 1.0) for a in range(3)]
    x, y, z = numpy.meshgrid(*axes, indexing="ij")
    expected = numpy.round(numpy.sin(0.3 * x) + numpy.cos(0.4 * y) * z / 9.0, 6)
    text = os.path.join(folder, "potential.dx")
    binary = os.path.join(folder, "potential.dxbin")
    write_binary(binary, axes, expected, "double", "")
    isthmus.open_dx_writer(isthmus.read(binary), text)
    tables = []
    for path in (text, binary):
        table = os.path.join(folder, "sites.csv")
        assert main(["potential", molecule, "--potential", path, "--table", table, "--quiet"]) == 0
        with open(table) as file:
            tables.append(file.read())
    assert tables[0] == tables[1] and tables[0].count("\n") > 1, tables
print("the potential is the file's")
