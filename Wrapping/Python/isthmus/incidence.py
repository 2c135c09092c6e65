"""Incidences in a volume mesh: stars of vertices, fans of edges, all pairs of kinds, as numpy arrays.

>>> from isthmus import incidence, samples
>>> complex_ = incidence.CombinatorialMap(isthmus.isosurface_stuffing(samples.volume(), level=0.5))
>>> complex_.star(0)                       # the cells around point 0
>>> complex_.fan(7)                        # those around edge 7, in their order
>>> offsets, cells = complex_.incidence("vertex", "cell")   # all stars at once
>>> valence = complex_.attribute("edge", int)               # one value for each edge

Kinds of elements: "vertex", "edge", "face", "cell", "half face", "dart". Their numbers are those of
vtkCombinatorialMap: points and cells as in the mesh, edges and faces as Cell Incidence numbers them.
"""
import numpy

KINDS = ("vertex", "edge", "face", "cell", "half face", "dart")


def _number(kind):
    if kind not in KINDS:
        raise ValueError(f"kind {kind!r}: choose one of {', '.join(map(repr, KINDS))}")
    return KINDS.index(kind)


class CombinatorialMap:
    """The incidence of one mesh (vtkUnstructuredGrid of volume cells), built once."""

    def __init__(self, mesh):
        from . import vtkCombinatorialMap
        self._map = vtkCombinatorialMap()
        messages = []
        self._map.AddObserver("ErrorEvent", _Listener(messages))
        if not self._map.SetMesh(mesh):
            raise ValueError(messages[0] if messages else "The mesh has no combinatorial map.")

    def count(self, kind):
        """Number of elements of a kind in the mesh."""
        return self._map.GetNumber(_number(kind))

    def incident(self, kind, number, other):
        """The elements of kind `other` incident to one element: an array of numbers. The cost is proportional to their number."""
        from vtkmodules.vtkCommonCore import vtkIdList
        if not 0 <= number < self.count(kind):
            raise IndexError(f"there is no {kind} {number}: the mesh has {self.count(kind)}, from 0")
        self._require(kind, other)
        found = vtkIdList()
        self._map.GetIncident(_number(kind), number, _number(other), found)
        return numpy.array([found.GetId(i) for i in range(found.GetNumberOfIds())], dtype=numpy.int64)

    def star(self, vertex):
        """The cells around a vertex."""
        return self.incident("vertex", vertex, "cell")

    def fan(self, edge):
        """The cells around an edge, counter-clockwise seen from its larger vertex."""
        return self.incident("edge", edge, "cell")

    def incidence(self, kind, other):
        """(offsets, numbers) for all elements of a kind: those of element i are numbers[offsets[i]:offsets[i + 1]]."""
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkCommonCore import vtkIdTypeArray
        self._require(kind, other)
        offsets, numbers = vtkIdTypeArray(), vtkIdTypeArray()
        self._map.GetIncidence(_number(kind), _number(other), offsets, numbers)
        return vtk_to_numpy(offsets).copy(), vtk_to_numpy(numbers).copy()

    def each(self, kind, other):
        """Iterates over the elements of a kind: an array of the elements of kind `other` for each."""
        offsets, numbers = self.incidence(kind, other)
        for begin, end in zip(offsets[:-1], offsets[1:]):
            yield numbers[begin:end]

    def stars(self):
        """Iterates over the vertices: the cells around each."""
        return self.each("vertex", "cell")

    def fans(self):
        """Iterates over the edges: the cells around each, in their order."""
        return self.each("edge", "cell")

    def beta(self, dimension):
        """beta_1, beta_2 or beta_3 of all darts; -1 where there is no cell beyond."""
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkCommonCore import vtkIdTypeArray
        if dimension not in (1, 2, 3):
            raise ValueError(f"there is no beta_{dimension}: choose 1, 2 or 3")
        darts = vtkIdTypeArray()
        self._map.GetBeta(dimension, darts)
        return vtk_to_numpy(darts).copy()

    def attribute(self, kind, dtype=float, initial=0):
        """An array with one value for each element of a kind."""
        return numpy.full(self.count(kind), initial, dtype=dtype)

    def memory_report(self):
        """{table: bytes} of the map's tables in use; those of edges and faces are built when first needed."""
        return {self._map.GetTableName(i): self._map.GetTableBytes(i) for i in range(self._map.GetNumberOfTables())}

    def estimated_bytes(self):
        """The thesis' estimate for tetrahedra with their coordinates (Table 3.8): 4 (8.7 n3 + n_b)."""
        return self._map.GetEstimatedBytes()

    @staticmethod
    def _require(kind, other):
        _number(kind), _number(other)
        if kind == other and kind not in ("vertex", "cell", "half face"):
            raise ValueError(f"only vertices, cells and half faces have neighbours of their own kind, not a {kind}")


class _Listener:
    """Keeps the texts of errors."""
    CallDataType = "string0"

    def __init__(self, texts):
        self._texts = texts

    def __call__(self, _caller, _event, text):
        self._texts.append(text.strip())
