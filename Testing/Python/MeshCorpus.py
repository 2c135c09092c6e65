"""Surfaces and meshes of a folder, read by Isthmus and by meshio, libigl, trimesh, CGAL and Biopython.

    ISTHMUS_CORPUS_DIR      the folder; without it this test is skipped
    ISTHMUS_CORPUS_PYTHON   a Python with the other readers; else the one on the path

Each folder in it is a data set. Testing/Data/mesh_corpus.txt lists those in the table of
Readers/Meshes/Agreement.md, and explains what does not agree.

Compared are points and their coordinates, bit by bit; cells of each kind and their points; and markers. A
quantity agrees if one of the other readers finds the same.
"""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import corpus
import isthmus
from peer_tools import checksum

FOLDER = corpus.folder()
READERS = {"off": isthmus.vtkOFFSurfaceReader, "mesh": isthmus.vtkMEDITReader,
           "meshb": isthmus.vtkMEDITReader, "ele": isthmus.vtkTetGenMeshReader,
           "node": isthmus.vtkTetGenMeshReader, "face": isthmus.vtkTetGenMeshReader,
           "vert": isthmus.vtkMSMSReader}
QUANTITIES = ("points", "coordinates", "cells", "vertices", "markers")
KINDS = {1: "vertex", 3: "line", 5: "triangle", 7: "polygon", 9: "quad", 10: "tetra", 12: "hexahedron",
         13: "wedge", 14: "pyramid", 21: "line3", 22: "triangle6", 24: "tetra10", 28: "quad9",
         29: "hexahedron27", 32: "wedge18"}


def read(path):
    """What Isthmus finds, or its message."""
    reader = READERS[corpus.extension(path)]()
    if path.suffix == ".vert" or path.suffix == ".face" and path.with_suffix(".vert").exists():
        reader = isthmus.vtkMSMSReader()
        reader.SetAllComponents(False)  # other readers read one file
    reader.SetFileName(str(path))
    messages = corpus.errors_of_update(reader)
    output = reader.GetOutputDataObject(0)
    if messages:
        return messages
    points = numpy.zeros((0, 3))
    if output.GetNumberOfPoints():
        points = vtk_to_numpy(output.GetPoints().GetData())
    kinds = {}
    for cell in range(output.GetNumberOfCells()):
        kinds.setdefault(KINDS[output.GetCellType(cell)], []).append(cell)
    found = {"points": len(points), "coordinates": checksum(points, "<f8"),
             "cells": {kind: len(cells) for kind, cells in kinds.items()}, "vertices": {}}
    for kind, cells in kinds.items():
        if kind != "polygon":
            size = output.GetCell(cells[0]).GetNumberOfPoints()
            ids = [output.GetCell(cell).GetPointId(i) for cell in cells for i in range(size)]
            found["vertices"][kind] = checksum(numpy.array(ids).reshape(-1, size), "<i8")
    for name in ("Reference", "BoundaryMarker", "Attribute"):
        array = output.GetCellData().GetArray(name)
        if array:
            values = vtk_to_numpy(array)
            found["markers"] = {kind: checksum(values[cells], "<i8")
                                for kind, cells in kinds.items()}
    return found


def same(quantity, theirs, ours):
    """Other readers need not have all kinds of cells, but those that they have must be ours."""
    if not isinstance(theirs, dict):
        return theirs == ours
    given = {kind: value for kind, value in theirs.items() if value not in (0, EMPTY)}
    ours = ours or {}
    return bool(given or not any(ours.values())) and all(ours.get(kind) == value for kind, value in given.items())


EMPTY = checksum([], "<i8")
corpus.check_files(FOLDER, "mesh_corpus.txt")
paths = corpus.files(FOLDER, READERS)
others = corpus.peers("mesh_peers.py", paths)
table = corpus.Table(FOLDER, corpus.explanations("mesh_corpus.txt"), QUANTITIES)
for path in paths:
    corpus.add(table, path, read(path), others.get(str(path), {}), QUANTITIES, same)
table.finish()
