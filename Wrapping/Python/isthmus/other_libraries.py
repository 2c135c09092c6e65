"""Meshes of meshio and trimesh as VTK's data. Neither library is imported: their objects are known by their classes."""

# Linear cells by meshio's names; VTK numbers their points in the same order.
CELLS = {"vertex": 1, "line": 3, "triangle": 5, "polygon": 7, "quad": 9, "tetra": 10, "hexahedron": 12, "wedge": 13,
         "pyramid": 14}
POLYGONS = ("triangle", "quad", "polygon")


def data_of(value, where):
    """The vtkPolyData or vtkUnstructuredGrid of a mesh; None for other objects. ValueError if it cannot be converted."""
    library = type(value).__module__.split(".")[0]
    if library == "trimesh" and hasattr(value, "vertices"):
        faces = getattr(value, "faces", None)
        if faces is None:  # a PointCloud
            blocks = [("vertex", [[i] for i in range(len(value.vertices))])]
        else:
            blocks = [("triangle", faces)]
        return _data(value.vertices, blocks, getattr(value, "vertex_attributes", {}),
                     {name: [array] for name, array in getattr(value, "face_attributes", {}).items()}, where)
    if library == "meshio" and hasattr(value, "cells"):
        return _data(value.points, [(block.type, block.data) for block in value.cells], value.point_data,
                     value.cell_data, where)
    return None


def _data(points, blocks, point_arrays, cell_arrays, where):
    import numpy
    from vtkmodules.util import numpy_support
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkUnstructuredGrid
    unknown = sorted({kind for kind, _ in blocks if kind not in CELLS})
    if unknown:
        raise ValueError(f"{where} has cells of the type {unknown[0]}; those that can be passed are {', '.join(CELLS)}.")
    points = numpy.asarray(points, dtype=float)
    if points.ndim != 2 or points.shape[1] not in (2, 3):
        raise ValueError(f"{where} needs points of two or three coordinates; their shape is {points.shape}.")
    if points.shape[1] == 2:
        points = numpy.column_stack([points, numpy.zeros(len(points))])
    cells = [numpy.asarray(cell, dtype=numpy.int64) for _, block in blocks for cell in block]
    ids = numpy.concatenate(cells) if cells else numpy.zeros(0, dtype=numpy.int64)
    if len(ids) and not 0 <= ids.min() <= ids.max() < len(points):
        raise ValueError(f"{where} has cells of points that do not exist: ids go from 0 to {len(points) - 1}.")
    offsets = numpy.concatenate([[0], numpy.cumsum([len(cell) for cell in cells])]).astype(numpy.int64)
    array, places = vtkCellArray(), vtkPoints()
    array.SetData(numpy_support.numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_support.numpy_to_vtkIdTypeArray(ids, deep=True))
    places.SetData(numpy_support.numpy_to_vtk(numpy.ascontiguousarray(points), deep=True))
    kinds = {kind for kind, _ in blocks}
    if kinds <= set(POLYGONS):
        data = vtkPolyData()
        data.SetPolys(array)
    elif kinds == {"vertex"}:
        data = vtkPolyData()
        data.SetVerts(array)
    else:
        data = vtkUnstructuredGrid()
        types = numpy.concatenate([numpy.full(len(block), CELLS[kind], dtype=numpy.uint8) for kind, block in blocks])
        data.SetCells(numpy_support.numpy_to_vtk(types, deep=True), array)
    data.SetPoints(places)
    _add_arrays(data.GetPointData(), point_arrays, len(points))
    _add_arrays(data.GetCellData(), {name: numpy.concatenate([numpy.asarray(part) for part in parts])
                                     for name, parts in cell_arrays.items()}, len(cells))
    return data


def _add_arrays(attributes, arrays, count):
    """Numbers for each point or cell; what else a mesh carries has no place in VTK's data."""
    import numpy
    from vtkmodules.util import numpy_support
    for name, values in arrays.items():
        values = numpy.asarray(values)
        if values.dtype.kind in "iufb" and values.ndim in (1, 2) and len(values) == count:
            values = values.astype("uint8" if values.dtype.kind == "b" else values.dtype.newbyteorder("="))
            made = numpy_support.numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
            made.SetName(name)
            attributes.AddArray(made)
