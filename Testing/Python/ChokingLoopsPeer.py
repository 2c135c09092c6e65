"""The persistence diagram of choking loops against GUDHI's exact alpha complex, on six surfaces
and on three larger ones in turns (long_tests.py).

Both get the same points, those of the surface: SampleSpacing is larger than any edge. GUDHI's
pairs of dimension 2 must be ours, and its deaths of dimension 1, one for one, as far as they lie
above the sampling error: below it we keep none. This is more than pairs above the trust rule.
"""

import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import isthmus
from long_tests import share
from shared_data import shared_data

try:
    import gudhi
except ImportError as missing:
    print("needs python3-gudhi:", missing)
    raise SystemExit(77)

TOLERANCE = 1e-9  # of radii, relative; the issue asks for 1e-6
SHORTEST = 1e-6   # pairs whose radii are nearer to each other than this, relative, are rounding's


def read(name):
    """Points and triangles of an OFF or OBJ file, without points that nothing uses."""
    lines = [line.split() for line in shared_data("surfaces/" + name).read_text().split("\n")]
    if name.endswith(".off"):
        rows = [row for row in lines if row and not row[0].startswith(("#", "OFF"))]
        count, faces = int(rows[0][0]), int(rows[0][1])
        points = [row[:3] for row in rows[1:count + 1]]
        triangles = numpy.array([row[1:4] for row in rows[count + 1:count + faces + 1]], dtype=int)
    else:
        points = [row[1:4] for row in lines if row and row[0] == "v"]
        triangles = numpy.array([[corner.split("/")[0] for corner in row[1:4]]
                                 for row in lines if row and row[0] == "f"], dtype=int) - 1
    used, numbers = numpy.unique(triangles, return_inverse=True)
    holder = vtkPoints()
    holder.SetDataTypeToDouble()
    holder.SetData(numpy_to_vtk(numpy.array(points, dtype=float)[used], deep=True))
    cells = vtkCellArray()
    for triangle in numbers.reshape(-1, 3):
        cells.InsertNextCell(3, [int(p) for p in triangle])
    surface = vtkPolyData()
    surface.SetPoints(holder)
    surface.SetPolys(cells)
    return surface


def ours(surface):
    """Pairs by dimension and the sampling error; column 2 tells the generators of the surface."""
    loops = isthmus.vtkChokingLoops()
    loops.SetInputData(surface)
    loops.SetSampleSpacing(1e30)
    loops.Update()
    table = loops.GetOutputDataObject(3)
    column = {name: vtk_to_numpy(table.GetColumnByName(name))
              for name in ("Dimension", "Birth", "Death", "Kind")}
    facts = loops.GetOutputDataObject(0).GetFieldData()
    assert facts.GetArray("NumberOfSamples").GetTuple1(0) == surface.GetNumberOfPoints()
    error = facts.GetArray("LargestSamplingError").GetTuple1(0)
    pairs = {}
    for dimension in (1, 2):
        chosen = column["Dimension"] == dimension
        pairs[dimension] = numpy.stack(
            [column[name][chosen] for name in ("Birth", "Death", "Kind")], axis=1)
    return pairs, error


def theirs(surface):
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    tree = gudhi.AlphaComplex(points=points, precision="exact").create_simplex_tree()
    tree.compute_persistence(homology_coeff_field=2, min_persistence=0.0)
    return {dimension: numpy.sqrt(numpy.maximum(
        tree.persistence_intervals_in_dimension(dimension), 0.0)) for dimension in (1, 2)}


def above(pairs, error):
    """Pairs that die above the sampling error and are longer than rounding."""
    return pairs[(pairs[:, 1] > error) & (pairs[:, 1] - pairs[:, 0] > SHORTEST * pairs[:, 1])]


def in_order(rows):
    """Sorted by the first column, rows that rounding alone tells apart there by the last."""
    rows = rows[numpy.argsort(rows[:, 0])]
    steps = numpy.diff(rows[:, 0], prepend=0.0) > 1e-12 * rows[:, 0]
    return rows[numpy.lexsort((rows[:, -1], numpy.cumsum(steps)))]


def agree(name, what, mine, peer):
    """Each row of one has a row of the other, counted as often."""
    assert len(mine) == len(peer), f"{name}: {len(mine)} {what}, GUDHI has {len(peer)}"
    a, b = in_order(mine), in_order(peer)
    worst = float(numpy.max(numpy.abs(a - b) / b, initial=0.0))
    assert worst < TOLERANCE, f"{name}: {what} differ by {worst:.1e}"
    return worst


surfaces = ["eight.off", "knot1.off", "Kitten.off", "bunny.off", "fertility.off", "genus3.off"]
surfaces += share(["armadillo.obj", "soccerball.obj", "emd_5043.obj"], 3)
for name in surfaces:
    start = time.time()
    surface = read(name)
    pairs, error = ours(surface)
    middle = time.time()
    peer = theirs(surface)
    end = time.time()
    long = {d: above(p, error) for d, p in peer.items()}
    voids, loops = above(pairs[2], error), above(pairs[1], error)
    worst = agree(name, "pairs of dimension 2", voids[:, :2], long[2])
    worst = max(worst, agree(name, "deaths of dimension 1", loops[:, 1:2], long[1][:, 1:2]))
    generators = numpy.sum(loops[:, 2] < 3)
    assert len(voids) > 0 and len(loops) > 0
    trusted = numpy.sum(long[2][:, 1] ** 2 - long[2][:, 0] ** 2 > error ** 2)
    print(f"{name}: {len(voids)} pairs of dimension 2 ({trusted} above the trust rule everywhere), "
          f"{len(loops)} deaths of dimension 1 ({generators} of generators), "
          f"worst relative difference {worst:.1e}; {middle - start:.1f} s, GUDHI {end - middle:.1f} s")
print("passed")
