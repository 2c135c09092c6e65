"""What other readers find in surfaces and meshes: JSON lines for each path on standard input.

Run by MeshCorpus.py in a Python that has meshio, and igl, trimesh, CGAL and Biopython if possible:

    {"path": ..., "meshio": {"points": 8, "coordinates": "5d3a...", "cells": {"tetra": 6},
     "vertices": {"tetra": "77e1..."}, "markers": {"tetra": "90ab..."}}, "igl": "why it refuses", ...}

Coordinates, vertices of cells (from 0, by kind) and markers of cells are checksums of their numbers in the
order of the file. A quantity that a reader does not give is missing.
"""

import re
import warnings
from pathlib import Path

import meshio
import numpy

from peer_tools import answer_paths, checksum

warnings.filterwarnings("ignore")
try:
    import igl
except ImportError:
    igl = None
try:
    import trimesh
except ImportError:
    trimesh = None
try:
    from CGAL.CGAL_Polyhedron_3 import Polyhedron_3
except ImportError:
    Polyhedron_3 = None
try:
    from Bio.PDB.ResidueDepth import _read_vertex_array
except ImportError:
    _read_vertex_array = None

POLYGONS = {3: "triangle", 4: "quad"}


def finding(points, cells, markers=None):
    """Of an array of points, and arrays of vertices and of markers by kind of cell."""
    points = numpy.asarray(points, dtype="<f8")
    if points.shape[1] == 2:
        points = numpy.column_stack([points, numpy.zeros(len(points))])
    found = {"points": len(points), "coordinates": checksum(points, "<f8"),
             "cells": {kind: len(vertices) for kind, vertices in cells.items()},
             "vertices": {kind: checksum(vertices, "<i8") for kind, vertices in cells.items()}}
    if markers:
        found["markers"] = {kind: checksum(values, "<i8") for kind, values in markers.items()}
    return found


def by_meshio(path):
    path = Path(path)
    if path.suffix not in (".off", ".mesh", ".meshb", ".ele", ".node"):
        return None
    mesh = meshio.read(path)
    cells, markers = {}, {}
    references = next((mesh.cell_data[name] for name in ("medit:ref", "tetgen:ref")
                       if name in mesh.cell_data), None)
    for i, block in enumerate(mesh.cells):
        cells.setdefault(block.type, []).append(block.data)
        if references is not None:
            markers.setdefault(block.type, []).append(references[i])
    if path.suffix == ".node":  # meshio takes the cells of the .ele beside it
        return finding(mesh.points, {})
    return finding(mesh.points, {kind: numpy.concatenate(blocks) for kind, blocks in cells.items()},
                   {kind: numpy.concatenate(blocks) for kind, blocks in markers.items()})


def by_igl(path):
    path = Path(path)
    if igl is None:
        return None
    if path.suffix == ".off":
        points, faces, _ = igl.readOFF(str(path))
        if not len(points):
            return "no points"
        return finding(points, {POLYGONS[faces.shape[1]]: faces})
    if path.suffix == ".mesh":
        points, tetrahedra, triangles = igl.readMESH(str(path))
        if not len(points):
            return "no points"
        cells = {"tetra": tetrahedra, "triangle": triangles}
        return finding(points, {kind: cell for kind, cell in cells.items() if len(cell)})
    return None


def by_trimesh(path):
    path = Path(path)
    if trimesh is None or path.suffix != ".off":
        return None
    with open(path) as file:
        loaded = trimesh.exchange.off.load_off(file)
    # It splits polygons, which has no counterpart: counts of faces of such files differ.
    found = finding(loaded["vertices"], {"triangle": numpy.asarray(loaded["faces"])})
    text = "\n".join(line.split("#")[0] for line in open(path))
    if len(loaded["faces"]) != int(re.findall(r"(?<![.\d])\d+", text)[1]):
        del found["cells"], found["vertices"]
    return found


def by_cgal(path):
    """Polyhedra, which keep the order of points but for those that no face has."""
    path = Path(path)
    if Polyhedron_3 is None or path.suffix != ".off":
        return None
    surface = Polyhedron_3(str(path))
    if not surface.size_of_vertices():
        return "no polyhedron"
    points = [vertex.point() for vertex in surface.vertices()]
    found = finding([(p.x(), p.y(), p.z()) for p in points], {})
    counts = {}
    for facet in surface.facets():
        kind = POLYGONS.get(facet.facet_degree(), "polygon")
        counts[kind] = counts.get(kind, 0) + 1
    found["cells"] = counts
    del found["vertices"]
    return found


def by_biopython(path):
    path = Path(path)
    if _read_vertex_array is None or path.suffix != ".vert":
        return None
    points = _read_vertex_array(str(path))
    return {"points": len(points), "coordinates": checksum(points, "<f8")}


if __name__ == "__main__":
    answer_paths({"meshio": by_meshio, "igl": by_igl, "trimesh": by_trimesh, "CGAL": by_cgal,
                  "Biopython": by_biopython})
