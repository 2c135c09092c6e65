"""Data sets that no filter expects: empty, broken, degenerate, without scale. By name."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_TETRA, VTK_TRIANGLE, vtkCellArray, vtkImageData, vtkPolyData, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource

NAN, INFINITE = float("nan"), float("inf")
CORNERS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]


def points_of(coordinates):
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for point in coordinates:
        points.InsertNextPoint(point)
    return points


def poly(coordinates, cells, kind="Polys"):
    cell_array = vtkCellArray()
    for cell in cells:
        cell_array.InsertNextCell(len(cell), cell)
    surface = vtkPolyData()
    surface.SetPoints(points_of(coordinates))
    getattr(surface, f"Set{kind}")(cell_array)
    return surface


def sphere(center=(0, 0, 0)):
    source = vtkSphereSource()
    source.SetCenter(center)
    source.SetThetaResolution(12)
    source.SetPhiResolution(12)
    source.Update()
    return source.GetOutput()


def moved(move):
    """A sphere whose points are where move(number, point) says."""
    surface = sphere()
    surface.SetPoints(points_of(
        move(i, surface.GetPoint(i)) for i in range(surface.GetNumberOfPoints())))
    return surface


def together(*surfaces):
    append = vtkAppendPolyData()
    for surface in surfaces:
        append.AddInputData(surface)
    append.Update()
    return append.GetOutput()


def surfaces():
    random = numpy.random.default_rng(0)
    flipped = sphere()
    flipped.ReverseCell(3)
    return {
        "empty": vtkPolyData(),
        "points only": poly(CORNERS, []),
        "one vertex": poly([(0, 0, 0)], [[0]], "Verts"),
        "a line": poly(CORNERS[:3], [[0, 1, 2, 0]], "Lines"),
        "a strip": poly(CORNERS, [[0, 1, 2, 3]], "Strips"),
        "one triangle": poly(CORNERS[:3], [[0, 1, 2]]),
        "triangles without area": poly(CORNERS[:3], [[0, 0, 1], [0, 1, 1]]),
        "a polygon of two corners": poly(CORNERS[:2], [[0, 1]]),
        "a corner beyond the points": poly(CORNERS[:3], [[0, 1, 7]]),
        "a negative corner": poly(CORNERS[:3], [[0, 1, -3]]),
        "one point is NaN": moved(lambda i, p: (NAN, 0, 0) if i == 3 else p),
        "all points are NaN": moved(lambda i, p: (NAN, NAN, NAN)),
        "one point is infinite": moved(lambda i, p: (INFINITE, 0, 0) if i == 3 else p),
        "huge": moved(lambda i, p: tuple(1e30 * x for x in p)),
        "tiny": moved(lambda i, p: tuple(1e-30 * x for x in p)),
        "far away": moved(lambda i, p: tuple(1e9 + x for x in p)),
        "flat": moved(lambda i, p: (p[0], p[1], 0)),
        "all in one point": moved(lambda i, p: (1, 1, 1)),
        "crossing itself": together(sphere(), sphere((0.5, 0, 0))),
        "doubled": together(sphere(), sphere()),
        "touching": together(sphere(), sphere((1, 0, 0))),
        "one triangle turned": flipped,
        "open": poly(CORNERS, [[0, 2, 1], [0, 1, 3], [1, 2, 3]]),
        "inside out": poly(CORNERS, [[0, 1, 2], [0, 3, 1], [1, 3, 2], [0, 2, 3]]),
        "triangle soup": poly(random.random((50, 3)), random.integers(0, 50, (100, 3)).tolist()),
    }


def image(dimensions, values, spacing=(1, 1, 1), components=1):
    grid = vtkImageData()
    grid.SetDimensions(dimensions)
    grid.SetSpacing(spacing)
    array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
    if components > 1:
        array = numpy_to_vtk(numpy.reshape(values, (-1, components)), deep=True)
    array.SetName("Values")
    grid.GetPointData().SetScalars(array)
    return grid


def images():
    side, size = (8, 8, 8), 512
    noise = numpy.random.default_rng(0).random(size).astype(numpy.float32)

    def with_value(value):
        values = noise.copy()
        values[77] = value
        return values

    bare = vtkImageData()
    bare.SetDimensions(3, 3, 3)
    short = image(side, noise)
    short.GetPointData().GetScalars().SetNumberOfTuples(100)
    return {
        "empty": vtkImageData(),
        "without scalars": bare,
        "one node": image((1, 1, 1), noise[:1]),
        "one row": image((8, 1, 1), noise[:8]),
        "one slice": image((8, 8, 1), noise[:64]),
        "two nodes each way": image((2, 2, 2), noise[:8]),
        "constant": image(side, numpy.ones(size)),
        "vectors": image((4, 4, 4), noise[:192], components=3),
        "one value is NaN": image(side, with_value(NAN)),
        "one value is infinite": image(side, with_value(INFINITE)),
        "all values are NaN": image(side, numpy.full(size, NAN)),
        "spacing of zero": image(side, noise, (1, 0, 1)),
        "negative spacing": image(side, noise, (1, -1, 1)),
        "spacing is NaN": image(side, noise, (1, NAN, 1)),
        "huge values": image(side, noise * numpy.float32(1e38)),
        "bytes": image(side, (noise * 255).astype(numpy.uint8)),
        "large integers": image(side, (noise * 1e15).astype(numpy.int64)),
        "too few values": short,
        "noise": image(side, noise),
    }


def grid(coordinates, cells):
    mesh = vtkUnstructuredGrid()
    mesh.SetPoints(points_of(coordinates))
    for kind, corners in cells:
        mesh.InsertNextCell(kind, len(corners), corners)
    return mesh


def grids():
    tetrahedron = (VTK_TETRA, [0, 1, 2, 3])
    return {
        "empty": vtkUnstructuredGrid(),
        "a corner beyond the points": grid(CORNERS, [(VTK_TETRA, [0, 1, 2, 9])]),
        "one point is NaN": grid([(NAN, 0, 0), *CORNERS[1:]], [tetrahedron]),
        "flat": grid([*CORNERS[:3], (1, 1, 0)], [tetrahedron]),
        "doubled": grid(CORNERS, [tetrahedron] * 3),
        "two corners are one": grid(CORNERS, [(VTK_TETRA, [0, 1, 1, 3])]),
        "a triangle among them": grid(CORNERS, [tetrahedron, (VTK_TRIANGLE, [0, 1, 2])]),
    }
