"""A protein that breathes and a pore that does: all that stays is tracked through, nothing is swapped."""

import os
import tempfile

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import isthmus
import pocket_tools as tools
from shared_data import shared_data

FRAMES = 50


def slowest_mode(places):
    """Lowest mode that is no rigid motion, of springs between all within 8 angstrom of each other."""
    n = len(places)
    hessian = numpy.zeros((n, 3, n, 3))
    for i in range(n):
        d = places - places[i]
        squared = (d**2).sum(axis=1)
        for j in numpy.nonzero((squared > 0.0) & (squared < 64.0))[0]:
            block = numpy.outer(d[j], d[j]) / squared[j]
            hessian[i, :, j] -= block
            hessian[i, :, i] += block
    values, vectors = numpy.linalg.eigh(hessian.reshape(3 * n, 3 * n))
    assert values[5] < 1e-6 < values[6], values[:8]
    return vectors[:, 6].reshape(n, 3)


def column(table, name):
    return vtk_to_numpy(table.GetColumnByName(name))


def run(reader, filter_, features, lining=None):
    filter_.SetInputConnection(reader.GetOutputPort())
    tracks = isthmus.vtkFeatureTracks()
    tracks.SetInputConnection(filter_.GetOutputPort(features))
    if lining is not None:
        tracks.SetLiningConnection(filter_.GetOutputPort(lining))
    tracks.Update()
    return tracks


def open_models(text, suffix):
    handle, name = tempfile.mkstemp(suffix=suffix)
    with os.fdopen(handle, "w") as file:
        file.write(text)
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(name)
    return reader, name


# Lysozyme moves along its slowest mode (the cleft opens and closes), with noise.
lines = [
    line
    for line in tools.lines_of(shared_data("molecules/1hew.pdb"))
    if line.startswith("ATOM") and line[16] in " A"
]
places = numpy.array([tools.place_of(line) for line in lines])
residues = numpy.array([int(line[22:26]) for line in lines])
alphas = places[[line[12:16] == " CA " for line in lines]]
mode = slowest_mode(alphas)[residues - residues.min()]
mode *= 1.0 / numpy.sqrt((mode**2).sum(axis=1).mean())  # an angstrom for the average atom
random = numpy.random.default_rng(4)
text = []
for frame in range(FRAMES):
    moved = places + numpy.sin(2.0 * numpy.pi * frame / FRAMES) * mode
    moved = moved + random.normal(0.0, 0.05, places.shape)
    text.append(f"MODEL     {frame + 1:4d}\n")
    for line, place in zip(lines, moved):
        text.append(line[:30] + "".join(f"{x:8.3f}" for x in place) + line[54:])
    text.append("ENDMDL\n")
reader, name = open_models("".join(text) + "END\n", ".pdb")
reader.UpdateInformation()
finder = isthmus.vtkMolecularPockets()
tracks = run(reader, finder, 1, 4)
table = tracks.GetOutput()
track, time = column(table, "Track"), column(table, "Time")
assert sorted(set(time)) == list(range(FRAMES)), sorted(set(time))

# The pocket that has most residues of the cleft, found anew in each frame, is the truth.
cleft = None
truth = []
for frame in range(FRAMES):
    finder.UpdateTimeStep(float(frame))
    lining = finder.GetLiningResidues()
    owner, number = column(lining, "PocketId"), column(lining, "ResidueId")
    if cleft is None:
        cleft = set(number[owner == 1])
    common = [len(cleft & set(number[owner == p])) for p in range(1, owner.max() + 1)]
    truth.append(1 + int(numpy.argmax(common)))
os.remove(name)
feature = column(table, "FeatureId")
found = [track[(time == frame) & (feature == truth[frame])][0] for frame in range(FRAMES)]
share = numpy.mean(numpy.array(found) == found[0])
longest = max(numpy.bincount(track))
print(f"the cleft is one track in {100.0 * share:.0f} % of {FRAMES} frames; longest {longest}")
assert share == 1.0, found
for one in set(track):
    times = time[track == one]
    assert len(set(times)) == len(times), "two features of one time in a track"
chart = tracks.GetChart()
assert chart.GetNumberOfRows() == FRAMES
volumes = column(table, "Volume")[track == found[0]]
assert volumes.max() > 1.2 * volumes.min()  # it breathes

# A tube of carbon atoms whose width is known at all times.
widths = 4.5 + 0.6 * numpy.sin(2.0 * numpy.pi * numpy.arange(FRAMES) / FRAMES)
text = []
for frame, width in enumerate(widths):
    atoms = []
    for z in numpy.arange(-12.0, 12.1, 1.0):
        r = numpy.sqrt(width**2 + 0.2 * z**2)
        angles = 2.0 * numpy.pi * numpy.arange(24) / 24
        atoms += [(r * numpy.cos(a), r * numpy.sin(a), z) for a in angles]
    for z in (-12.0, 12.0):
        for r in numpy.arange(numpy.sqrt(width**2 + 28.8) + 1.5, 20.0, 1.5):
            angles = 2.0 * numpy.pi * numpy.arange(60) / 60
            atoms += [(r * numpy.cos(a), r * numpy.sin(a), z) for a in angles]
    text.append(f"{len(atoms)}\nframe {frame}\n")
    text += [f"C {x:.5f} {y:.5f} {z:.5f}\n" for x, y, z in atoms]
reader, name = open_models("".join(text), ".xyz")
reader.BondsByDistanceOff()
pores = isthmus.vtkPoreProfile()
pores.SetMode(pores.PointAndDirection)
tracks = run(reader, pores, 2)
os.remove(name)
table = tracks.GetOutput()
assert set(column(table, "Track")) == {1} and table.GetNumberOfRows() == FRAMES
radius = column(table, "Radius")[numpy.argsort(column(table, "Time"))]
difference = abs(radius - (widths - 1.7)).max()
print(f"radius in time against the known one: largest difference {difference:.5f}")
assert difference < 0.001, difference
