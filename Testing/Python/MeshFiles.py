"""OFF, TetGen's and MEDIT's files through ParaView's own ways: opened, saved, opened again."""

import tempfile
from pathlib import Path

import numpy
from paraview import servermanager, simple
from paraview.vtk import VTK_TETRA
from paraview.vtk.util.numpy_support import vtk_to_numpy

from shared_data import shared_data


def opened(path, proxy):
    source = simple.OpenDataFile(str(path))
    assert source.GetXMLName() == proxy, (path, source.GetXMLName())
    return source, servermanager.Fetch(source)


def same(a, b):
    assert a.GetNumberOfCells() == b.GetNumberOfCells() > 0
    assert a.GetBounds() == b.GetBounds()


folder = Path(tempfile.mkdtemp())

source, surface = opened(shared_data("surfaces/fertility.off"), "OFFSurfaceReader")
assert (surface.GetNumberOfPoints(), surface.GetNumberOfCells()) == (4494, 9000)
simple.SaveData(str(folder / "surface.off"), source)
same(opened(folder / "surface.off", "OFFSurfaceReader")[1], surface)

source, mesh = opened(shared_data("volumes/octopus-low.mesh"), "MEDITReader")
assert mesh.GetNumberOfPoints() == 452
simple.SaveData(str(folder / "mesh.mesh"), source)
again, read = opened(folder / "mesh.mesh", "MEDITReader")
same(read, mesh)

tetrahedra = [cell for cell in range(mesh.GetNumberOfCells())
              if mesh.GetCellType(cell) == VTK_TETRA]
simple.SaveData(str(folder / "tets.ele"), again)
read = opened(folder / "tets.ele", "TetGenMeshReader")[1]
assert read.GetNumberOfCells() == len(tetrahedra) > 0
for cell in (0, len(tetrahedra) - 1):
    assert read.GetCell(cell).GetBounds() == mesh.GetCell(tetrahedra[cell]).GetBounds()

image = simple.Wavelet(WholeExtent=[0, 3, 0, 4, 0, 5])
simple.SaveData(str(folder / "volume.dat"), image)
lines = (folder / "volume.dat").read_text().splitlines()
assert lines[0] == "4 5 6" and len(lines) == 1 + 5 * 6, lines[:2]
values = numpy.array([float(word) for line in lines[1:] for word in line.split()], numpy.float32)
array = vtk_to_numpy(servermanager.Fetch(image).GetPointData().GetArray("RTData"))
assert numpy.array_equal(values, array)
read = opened(folder / "volume.dat", "DatVolumeReader")[1]
assert read.GetDimensions() == (4, 5, 6)
values = vtk_to_numpy(read.GetPointData().GetArray("Density"))
assert numpy.array_equal(values.astype(numpy.float32), array)
tecplot = folder / "other.dat"
tecplot.write_text('VARIABLES = "x", "y"\nZONE I=2, F=POINT\n0 1\n1 2\n')
assert simple.OpenDataFile(str(tecplot)).GetXMLName() != "DatVolumeReader"
