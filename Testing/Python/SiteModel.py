"""The frozen site model: evaluated once more by other code, from the table in its source; and the arithmetic
of evaluate_pockets.py on data of which the answer is known."""

import re
import sys
from pathlib import Path

import numpy

import isthmus  # noqa: F401
import pocket_tools as tools
from vtkmodules.util.numpy_support import vtk_to_numpy

ROOT = Path(__file__).resolve().parents[2]
text = (ROOT / "Filters/Pockets/SiteModelTable.cxx").read_text()
header = (ROOT / "Filters/Pockets/PocketSites.h").read_text()
REACH, CROWDING = (float(re.search(name + r"Reach = ([0-9.]+)", header)[1]) for name in ("Density", "Crowding"))


def numbers(name):
    body = re.search(name + r"\[\] = \{(.*?)\};", text, re.S)[1]
    return [float(word) for word in re.findall(r"-?[0-9][0-9.]*(?:e[-+]?[0-9]+)?", body)]


nodes = numpy.array(numbers("Nodes")).reshape(-1, 4)
leaves = numpy.array(numbers("Leaves"), numpy.float32).astype(float)
first_nodes, first_leaves = (numpy.array(numbers(name), int) for name in ("FirstNodes", "FirstLeaves"))
propensity = numpy.array(numbers("Propensity"))
calibration = [float(word) for word in re.search(r"Propensity,\s+\{ (.*?) \}", text)[1].split(", ")]


def place_probabilities(values):
    """All rows go down one tree after the other."""
    odds = numpy.zeros(len(values))
    for first, first_leaf in zip(first_nodes, first_leaves):
        at = numpy.zeros(len(values), int)
        while (at >= 0).any():
            rows = numpy.flatnonzero(at >= 0)
            here = nodes[first + at[rows]]
            low = values[rows, here[:, 0].astype(int)] <= here[:, 1].astype(numpy.float32)
            at[rows] = numpy.where(low, here[:, 2], here[:, 3]).astype(int)
        odds += leaves[first_leaf - 1 - at]
    return 1.0 / (1.0 + numpy.exp(-odds))


def kernel(place, places, reach):
    d2 = ((places - place) ** 2).sum(axis=1) / reach**2
    return numpy.where(d2 < 1.0, (1.0 - d2) ** 2, 0.0)


def density_at(place, places, weights):
    weights = weights * kernel(place, places, REACH)
    return weights.sum(), weights @ places / weights.sum()


for name, lines, mask in list(tools.complexes())[:3]:
    atoms = tools.read([line for line, is_ligand in zip(lines, mask) if not is_ligand])
    finder = tools.pockets(atoms, arrays=["SiteDescriptors"])
    judged = finder.GetSiteSurface()
    places = vtk_to_numpy(judged.GetPoints().GetData())
    array = judged.GetPointData().GetArray("SiteDescriptors")
    names = [array.GetComponentName(k) for k in range(array.GetNumberOfComponents())]
    values, near = vtk_to_numpy(array)[:, :-40], vtk_to_numpy(array)[:, -40:].astype(float)
    assert numpy.isfinite(values).all() and len(values) > 200, name
    # Propensities are the mean of the table's over the residues that are near.
    mean = near @ propensity / numpy.maximum(near.sum(axis=1), 1e-9)
    assert numpy.allclose(mean, values[:, names.index("Propensity")], atol=1e-5), name
    probabilities = vtk_to_numpy(judged.GetPointData().GetArray("SiteProbability"))
    assert numpy.allclose(place_probabilities(values), probabilities, atol=1e-9), name
    # The sites' tetrahedra are among the places, with the same probability; and as many atoms are near.
    row_of = {place.tobytes(): row for row, place in enumerate(places)}
    rows = [row_of[ball.tobytes()] for ball in vtk_to_numpy(finder.GetAlphaBalls().GetPoints().GetData())]
    cells = finder.GetOutput().GetCellData()
    assert numpy.array_equal(vtk_to_numpy(cells.GetArray("SiteProbability")), probabilities[rows]), name
    assert numpy.array_equal(vtk_to_numpy(cells.GetArray("Burial")), values[rows, names.index("Atoms10")]), name
    # Centers are modes of the density; probabilities follow from the densities.
    table = tools.columns(finder.GetPocketTable())
    centers = tools.centers(finder)
    densities = []
    weights = probabilities / numpy.sqrt([kernel(place, places, CROWDING).sum() for place in places])
    for center in centers:
        density, after = density_at(center, places, weights)
        densities.append(density)
        assert numpy.linalg.norm(after - center) < 1e-3, (name, after, center)
    densities = numpy.array(densities)
    for first in set(table["CopyOf"]):  # copies of a site have the mean of their densities
        densities[table["CopyOf"] == first] = densities[table["CopyOf"] == first].mean()
    shares = densities / densities.sum()
    odds = calibration[0] + calibration[1] * numpy.log(numpy.maximum(densities, 1e-6)) + (
        calibration[2] * numpy.log(numpy.maximum(shares, 1e-6)))
    assert numpy.allclose(1.0 / (1.0 + numpy.exp(-odds)), table["Probability"], atol=1e-9), name
    assert (numpy.diff(table["Probability"]) <= 0.0).all(), name
    apart = numpy.linalg.norm(centers[:, None] - centers, axis=2) + 100.0 * numpy.eye(len(centers))
    assert apart.min() >= 4.0 - 1e-6, (name, apart.min())
    # The same sites without what only the training needs.
    plain = tools.pockets(atoms)
    assert numpy.array_equal(tools.centers(plain), centers), name
    print(f"{name}: {len(centers)} sites, the first {table['Probability'][0]:.2f}")

sys.path.insert(0, str(ROOT / "Testing/Studies"))
import evaluate_pockets as evaluation  # noqa: E402

# Two chains of one fold, the second turned by half about z and moved: a site of one has its copy there.
random = numpy.random.default_rng(2)
alphas = random.uniform(-10.0, 10.0, (30, 3))
other = alphas * [-1.0, -1.0, 1.0] + [50.0, 0.0, 3.0]
lines = [f"ATOM  {i + 1:5d}  CA  ALA {chain}{i + 1:4d}    {p[0]:8.3f}{p[1]:8.3f}{p[2]:8.3f}\n"
         for chain, points in (("A", alphas), ("B", other)) for i, p in enumerate(points)]
copies = evaluation.Copies(lines)
ligand = numpy.array([[1.0, 2.0, 0.5], [2.0, 2.0, 0.5]])
there = numpy.array([49.0, -2.0, 3.5])
nowhere = numpy.array([20.0, 30.0, 0.0])
centers = numpy.array([nowhere, there, ligand[0]])
counts = evaluation.counts_of(centers, [ligand, ligand + [0.0, 9.0, 0.0]], copies)
assert counts["copy a miss"].tolist() == [[False, False, True], [False] * 3], counts
assert counts["copy a hit"].tolist() == [[False, True, True], [False] * 3], counts
assert counts["copies one rank"].tolist() == [[False, True], [False, False]], counts  # the two copies are one
assert counts["12 angstrom"].tolist() == [[False, False, True]] * 2, counts
# Two ligands: the first two ranks, and the first four.
assert evaluation.found_by([counts["copy a miss"]], 0) == [False, False]
assert evaluation.found_by([counts["copy a miss"]], 2) == [True, False]
assert evaluation.count_redundant(numpy.array([nowhere, ligand[0], ligand[1], nowhere + [0.0, 0.0, 4.9]])) == 2
moved = list(evaluation.moved(1000 * lines[:1], random))
shift = numpy.array([evaluation.place_of(line) for line in moved]) - evaluation.place_of(lines[0])
assert abs((shift**2).sum(axis=1).mean() ** 0.5 - evaluation.NOISE) < 0.01

# 400 pockets of which as many are right as the probability says, and 100 that say too much.
probability = numpy.concatenate([numpy.repeat([0.1, 0.3, 0.5, 0.9], 100), numpy.repeat(0.7, 100)])
right = numpy.concatenate([numpy.arange(100) < 100 * p for p in (0.1, 0.3, 0.5, 0.9)] + [numpy.arange(100) < 40])
bins = evaluation.reliability_bins(probability, right)
assert sum(len(some) for some in bins) == 500 and min(len(some) for some in bins) >= 50
one_each = [numpy.flatnonzero(probability == p) for p in (0.1, 0.3, 0.5, 0.9, 0.7)]
assert abs(evaluation.calibration_error(probability, right, one_each) - 0.3 / 5) < 1e-12
low, high = evaluation.interval(right, numpy.arange(500))
assert low < right.mean() < high and high - low < 0.1
