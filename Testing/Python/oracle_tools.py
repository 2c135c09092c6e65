"""Random inputs whose answer is known, for the tests Oracle*.py.

An oracle is a function of a Draw that runs a filter and yields, for each quantity, its name, the deviations
from the answer and the tolerances, both numbers or arrays: no deviation may exceed its tolerance. Tolerances
follow from the discretisation, by the reason in the oracle's docstring. Where the third item is a Standards,
it is the standard error as the filter states it: no more than 5 % of all deviations exceed two of them.

    Oracle*.py [COUNT [NAME [FIRST]]]    COUNT inputs (default 50) of the oracles whose names contain NAME,
                                         from number FIRST on; ISTHMUS_SEED (default 1) for other inputs
"""

import os
import sys
import time
import zlib

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_TETRA, vtkCellArray, vtkImageData, vtkPolyData, vtkUnstructuredGrid)

import robustness_trials

ORACLES = []



class Standards:
    """Standard errors of an array of deviations."""

    def __init__(self, errors):
        self.errors = numpy.asarray(errors, float)


def oracle(name):
    def take(function):
        ORACLES.append((name, function))
        return function
    return take


class Draw:
    """A random stream with the choices that all inputs share."""

    def __init__(self, *seed):
        self.random = numpy.random.default_rng(seed)
        # The unit of length: angstrom, nanometre, or any other.
        self.unit = float(self.choice([1.0, 0.1, self.between(0.02, 50.0)]))

    def between(self, low, high, size=None):
        return self.random.uniform(low, high, size)

    def whole(self, low, high):
        """low to high, both included."""
        return int(self.random.integers(low, high + 1))

    def choice(self, values):
        return values[self.whole(0, len(values) - 1)]

    def chance(self, share=0.5):
        return bool(self.random.random() < share)

    def direction(self):
        vector = self.random.normal(size=3)
        return vector / numpy.linalg.norm(vector)

    def rotation(self, mirrored=False):
        """A matrix of columns at right angles; along the axes in one of four draws."""
        if self.chance(0.25):
            matrix = numpy.eye(3)[self.random.permutation(3)] * self.random.choice([-1.0, 1.0], 3)
        else:
            matrix, _ = numpy.linalg.qr(self.random.normal(size=(3, 3)))
        if (numpy.linalg.det(matrix) < 0.0) != mirrored:
            matrix[:, 0] *= -1.0
        return matrix

    def center(self, size):
        return self.between(-3.0, 3.0, 3) * size


# ---- Surfaces

def icosphere(level):
    """Points on the unit sphere, triangles counter-clockwise from outside, largest circumradius."""
    if level not in icosphere.kept:
        points = [numpy.array(p, float) for p in
                  ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))]
        triangles = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
        for _ in range(level):
            middles, finer = {}, []

            def middle(a, b):
                key = (min(a, b), max(a, b))
                if key not in middles:
                    p = points[a] + points[b]
                    points.append(p / numpy.linalg.norm(p))
                    middles[key] = len(points) - 1
                return middles[key]
            for a, b, c in triangles:
                ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
                finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
            triangles = finer
        points, triangles = numpy.array(points), numpy.array(triangles)
        p = points[triangles]
        edges = [numpy.linalg.norm(p[:, i] - p[:, i - 1], axis=1) for i in range(3)]
        area = numpy.linalg.norm(numpy.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1) / 2
        icosphere.kept[level] = points, triangles, (edges[0] * edges[1] * edges[2] / (4 * area)).max()
    return icosphere.kept[level]


icosphere.kept = {}


def torus(big, small, n, m):
    """A torus around z: n points around the axis, m around the tube, all on it."""
    u, v = numpy.meshgrid(2 * numpy.pi * numpy.arange(n) / n, 2 * numpy.pi * numpy.arange(m) / m, indexing="ij")
    rho = big + small * numpy.cos(v)
    points = numpy.stack([rho * numpy.cos(u), rho * numpy.sin(u), small * numpy.sin(v)], -1).reshape(-1, 3)
    i, j = numpy.meshgrid(numpy.arange(n), numpy.arange(m), indexing="ij")
    a, b = i * m + j, (i + 1) % n * m + j
    c, d = (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m
    triangles = numpy.concatenate([numpy.stack([a, b, c], -1).reshape(-1, 3),
                                   numpy.stack([a, c, d], -1).reshape(-1, 3)])
    return points, triangles, v.ravel()


def box(sides, n=1, draw=None):
    """A box around the origin, each face n x n squares in two triangles each; random diagonals with draw."""
    points, triangles, index = [], [], {}

    def point(p):
        key = tuple(p)
        if key not in index:
            index[key] = len(points)
            points.append(p)
        return index[key]
    for axis in range(3):
        for side in (0, n):
            for i in range(n):
                for j in range(n):
                    corners = []
                    for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        p = [0, 0, 0]
                        p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = side, i + di, j + dj
                        corners.append(point(p))
                    if side == 0:
                        corners.reverse()
                    k = 0 if draw is None else draw.whole(0, 1)
                    a, b, c, d = corners[k:] + corners[:k]
                    triangles += [(a, b, c), (a, c, d)]
    return (numpy.array(points) / n - 0.5) * sides, numpy.array(triangles)


def poly_data(draw, points, triangles, scalars=None, kind=None):
    """A surface with its points and triangles in random order, in single or double precision."""
    kind = kind or draw.choice([numpy.float32, numpy.float64])
    order = draw.random.permutation(len(points))
    rank = numpy.empty_like(order)
    rank[order] = numpy.arange(len(points))
    triangles = rank[triangles[draw.random.permutation(len(triangles))]]
    shift = draw.whole(0, 2)
    triangles = numpy.roll(triangles, shift, axis=1)
    data = vtkPolyData()
    data.SetPoints(vtk_points(points[order].astype(kind)))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(numpy.ascontiguousarray(triangles, numpy.int64).ravel(), deep=True))
    data.SetPolys(cells)
    for name, values in (scalars or {}).items():
        add_array(data.GetPointData(), name, values[order])
    return data


def vtk_points(points):
    result = vtkPoints()
    result.SetData(numpy_to_vtk(numpy.ascontiguousarray(points), deep=True))
    return result


def add_array(data, name, values):
    array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
    array.SetName(name)
    data.AddArray(array)


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def triangles_of(surface):
    cells = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
    assert len(cells) == 3 * surface.GetNumberOfPolys(), "not all cells are triangles"
    return cells.reshape(-1, 3)


def area_of(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1).sum() / 2


def volume_of(points, triangles):
    a, b, c = (points[triangles[:, k]] - points[0] for k in range(3))
    return (a * numpy.cross(b, c)).sum() / 6


def tetrahedra_of(grid):
    """Points, tetrahedra."""
    cells = grid.GetCells()
    ids = vtk_to_numpy(cells.GetConnectivityArray())
    assert len(ids) == 4 * grid.GetNumberOfCells(), "not all cells are tetrahedra"
    return points_of(grid), ids.reshape(-1, 4)


def tetrahedron_volumes(points, cells):
    a, b, c, d = (points[cells[:, k]] for k in range(4))
    return ((b - a) * numpy.cross(c - a, d - a)).sum(axis=1) / 6


def unstructured(points, cells):
    grid = vtkUnstructuredGrid()
    grid.SetPoints(vtk_points(points))
    array = vtkCellArray()
    array.SetData(4, numpy_to_vtkIdTypeArray(numpy.ascontiguousarray(cells, numpy.int64).ravel(), deep=True))
    grid.SetCells(VTK_TETRA, array)
    return grid


def euler_number(triangles):
    edges = numpy.sort(numpy.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    return len(numpy.unique(triangles)) - len(numpy.unique(edges, axis=0)) + len(triangles)


def triangle_angles(points, triangles):
    p = points[triangles]
    angles = []
    for i in range(3):
        a, b = p[:, (i + 1) % 3] - p[:, i], p[:, (i + 2) % 3] - p[:, i]
        cosine = (a * b).sum(1) / (numpy.linalg.norm(a, axis=1) * numpy.linalg.norm(b, axis=1))
        angles.append(numpy.degrees(numpy.arccos(numpy.clip(cosine, -1.0, 1.0))))
    return numpy.stack(angles, 1)


def dihedral_angles(points, cells):
    p = points[cells]
    angles = []
    for i, j in ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)):
        k, l = (m for m in range(4) if m not in (i, j))
        axis = p[:, j] - p[:, i]
        axis /= numpy.linalg.norm(axis, axis=1)[:, None]
        a, b = p[:, k] - p[:, i], p[:, l] - p[:, i]
        a, b = (q - (q * axis).sum(1)[:, None] * axis for q in (a, b))
        cosine = (a * b).sum(1) / (numpy.linalg.norm(a, axis=1) * numpy.linalg.norm(b, axis=1))
        angles.append(numpy.degrees(numpy.arccos(numpy.clip(cosine, -1.0, 1.0))))
    return numpy.stack(angles, 1)


def rounding(data_or_points):
    """Largest error of a coordinate's rounding: half a unit in the last place of the largest one."""
    if hasattr(data_or_points, "GetPoints"):
        points = vtk_to_numpy(data_or_points.GetPoints().GetData())
    else:
        points = data_or_points
    return float(numpy.finfo(points.dtype).eps) * float(numpy.abs(points).max())


def box_distance(points, sides):
    """Signed distance to a box around the origin along the axes, negative inside, exact."""
    q = numpy.abs(points) - numpy.asarray(sides) / 2
    return numpy.linalg.norm(numpy.maximum(q, 0.0), axis=1) + numpy.minimum(q.max(axis=1), 0.0)


def torus_distance(points, big, small):
    rho = numpy.hypot(points[:, 0], points[:, 1])
    return numpy.hypot(rho - big, points[:, 2]) - small


class Pose:
    """From local coordinates to the world's: a rotation, then a translation."""

    def __init__(self, draw, size):
        self.axes, self.center = draw.rotation(), draw.center(size)

    def world(self, points):
        return points @ self.axes.T + self.center

    def local(self, points):
        return (points - self.center) @ self.axes


# ---- Volumes

class Volume:
    """An image of field(points), which is positive inside or not, as `kind` has it.

    The stored values are Offset + Scale x field, rounded for whole numbers, so that levels convert by
    stored(). `quantum` is the largest error of a value by its type, in units of the field. The grid covers
    a ball of `half` around `center`, with about `nodes` nodes along it; its axes, spacings (up to
    1 : stretch) and first indices are random.
    """

    def __init__(self, draw, field, center, half, nodes, kinds=None, stretch=1.6, dimensions=None):
        kind = draw.choice(kinds or [numpy.float32, numpy.float64, numpy.int16, numpy.uint8, numpy.int32])
        self.axes = draw.rotation(mirrored=draw.chance(0.25))
        h = 2.0 * half / (nodes - 1)
        self.spacing = h / draw.between(1.0, stretch, 3)
        counts = numpy.ceil(2.0 * half / self.spacing).astype(int) + 1
        if dimensions is not None:
            counts, self.spacing = numpy.array(dimensions), h * draw.between(1.0 / stretch, 1.0, 3)
        first = numpy.array([draw.whole(-20, 20) for _ in range(3)])
        # A fraction of a cell, so that nodes are nowhere special.
        low = -self.spacing * (counts - 1) / 2 + draw.between(-0.4, 0.4, 3) * self.spacing
        origin = center + self.axes @ (low - first * self.spacing)
        k, j, i = numpy.meshgrid(*(numpy.arange(c) for c in counts[::-1]), indexing="ij")
        index = numpy.stack([i.ravel(), j.ravel(), k.ravel()], 1)
        self.counts, self.index = counts, index
        self.points = center + (low + index * self.spacing) @ self.axes.T
        self.values = field(self.points)
        self.scale, self.offset, self.quantum = self.conversion(draw, kind)
        stored = self.stored(self.values)
        if numpy.issubdtype(kind, numpy.integer):
            stored = numpy.rint(stored)
        self.data = vtkImageData()
        self.data.SetExtent(first[0], first[0] + counts[0] - 1, first[1], first[1] + counts[1] - 1,
                            first[2], first[2] + counts[2] - 1)
        self.data.SetSpacing(*self.spacing)
        self.data.SetOrigin(*origin)
        self.data.SetDirectionMatrix(*self.axes.ravel())
        add_array(self.data.GetPointData(), "Field", stored.astype(kind))
        self.data.GetPointData().SetActiveScalars("Field")
        self.h = float(self.spacing.max())
        self.kind = kind

    def conversion(self, draw, kind):
        low, high = self.values.min(), self.values.max()
        if not numpy.issubdtype(kind, numpy.integer):
            scale = draw.choice([1.0, draw.between(0.01, 100.0)])
            offset = draw.choice([0.0, scale * draw.between(-1.0, 1.0) * (high - low)])
            largest = max(abs(scale * low + offset), abs(scale * high + offset))
            return scale, offset, float(numpy.finfo(kind).eps) * largest / scale
        # All of a type's range, so that nothing is known of the zero.
        room = numpy.iinfo(kind)
        first, last = float(room.min) / 2 + 1, float(room.max) / 2 - 1
        if kind == numpy.uint8:
            first, last = 0.0, 255.0
        scale = (last - first) / (high - low)
        return scale, first - scale * low, 0.5 / scale

    def stored(self, values):
        return self.offset + self.scale * numpy.asarray(values)


# ---- Running

def settle(algorithm, inputs, arrays=(), **properties):
    """A filter with inputs by port, optional arrays and properties, run; an error of it is one of the test."""
    listener = robustness_trials.Listener(algorithm)
    for name in arrays:
        algorithm.GetOutputArraySelection().EnableArray(name)
    for name, value in properties.items():
        setter = getattr(algorithm, "Set" + name)
        setter(*value) if isinstance(value, (tuple, list)) else setter(value)
    for port, data in enumerate(inputs):
        if data is not None:
            algorithm.SetInputDataObject(port, data)
    algorithm.Update()
    if listener.errors:
        raise AssertionError(f"{algorithm.GetClassName()} said: {listener.errors}")
    return algorithm


def array(data, name):
    values = data.GetArray(name)
    assert values is not None, f"no array {name}"
    return vtk_to_numpy(values).astype(float)


def field(data, name):
    return float(array(data.GetFieldData(), name)[0])


def column(table, name):
    values = table.GetColumnByName(name)
    assert values is not None, f"no column {name}"
    return vtk_to_numpy(values).astype(float)


class Judged:
    """What one quantity of an oracle came to."""

    def __init__(self):
        self.worst, self.outside, self.beyond, self.count = 0.0, [], 0, 0

    def add(self, number, deviations, tolerances):
        if isinstance(tolerances, Standards):
            deviations = numpy.abs(numpy.asarray(deviations, float)).ravel()
            self.count += deviations.size
            self.beyond += int((~(deviations <= 2.0 * tolerances.errors.ravel())).sum())
            return
        deviations, tolerances = numpy.broadcast_arrays(numpy.abs(numpy.asarray(deviations, float)), tolerances)
        if not (deviations <= tolerances).all():  # not a number is outside as well
            self.outside.append((number, deviations, tolerances))
        wide = tolerances > 0.0
        if wide.any():
            self.worst = max(self.worst, float((deviations[wide] / tolerances[wide]).max()))

    def text(self):
        if self.count:
            return f"{100.0 * self.beyond / self.count:.1f} % of {self.count} beyond two standard errors"
        return f"at most {self.worst:.2g} of the tolerance"


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 50
    name = sys.argv[2] if len(sys.argv) > 2 else ""
    first = int(sys.argv[3]) if len(sys.argv) > 3 else 0
    seed = int(os.environ.get("ISTHMUS_SEED", "1"))
    script = os.path.basename(sys.argv[0])
    print(f"{count} inputs of each oracle, ISTHMUS_SEED={seed}")
    failures, inputs = [], 0
    for title, function in ORACLES:
        if name.lower() not in title.lower():
            continue
        began, judged = time.process_time(), {}
        for number in range(first, first + count):
            draw = Draw(seed, zlib.crc32(title.encode()), number)
            again = f"ISTHMUS_SEED={seed} {script} 1 '{title}' {number}"
            try:
                for quantity, deviations, tolerances in function(draw):
                    judged.setdefault(quantity, Judged()).add(number, deviations, tolerances)
            except Exception as error:  # whatever it is, the other inputs have their turn
                if os.environ.get("ISTHMUS_ORACLE_RAISE") == "1":
                    raise
                failures.append(f"{title}: {type(error).__name__}: {error}; {again}")
            inputs += 1
        print(f"{title}: {time.process_time() - began:.1f} s")
        for quantity, result in judged.items():
            print(f"  {quantity}: {result.text()}")
            for number, deviations, tolerances in result.outside:
                bad = ~(deviations <= tolerances)
                failures.append(
                    f"{title}: {quantity} of {int(bad.sum())} of {bad.size} values off by "
                    f"{deviations[bad].flat[0]:.3g} where {tolerances[bad].flat[0]:.3g} are allowed; "
                    f"ISTHMUS_SEED={seed} {script} 1 '{title}' {number}")
            # A few percent of a few values is chance.
            if result.count >= 100 and result.beyond > 0.05 * result.count:
                failures.append(f"{title}: {quantity}: {result.text()}")
        sys.stdout.flush()
    print(f"soak: {inputs} inputs with known answers")
    for failure in failures:
        print(failure)
    if failures:
        sys.exit(f"{len(failures)} outside")
