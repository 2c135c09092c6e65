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
finder.SetFindSites(False)  # two whole pockets; sites are many, and the unlikely ones come and go
tracks = run(reader, finder, 1, 4)
table = tracks.GetOutput()
track, time = column(table, "Track"), column(table, "Time")
assert sorted(set(time)) == list(range(FRAMES)), sorted(set(time))

# Who is who: each pocket of the first frame (without noise it is at rest there) is looked for in every
# frame by its residues alone, against the first frame and not the one before, as the filter does.
def residues_by_pocket(lining):
    owner, number = column(lining, "PocketId"), column(lining, "ResidueId")
    return [set(number[owner == p]) for p in range(1, int(owner.max()) + 1)]


residues_of = []
for frame in range(FRAMES):
    finder.UpdateTimeStep(float(frame))
    residues_of.append(residues_by_pocket(finder.GetLiningResidues()))
os.remove(name)
feature = column(table, "FeatureId")
together, swapped, seen = 0, 0, 0
cleft_track = None
for number, first in enumerate(residues_of[0], 1):
    shares = [[len(first & other) / len(first | other) for other in others] for others in residues_of]
    frames = [frame for frame in range(FRAMES) if max(shares[frame]) >= 0.3]
    found = [track[(time == f) & (feature == 1 + int(numpy.argmax(shares[f])))][0] for f in frames]
    own = found[0]
    other_pockets = {track[(time == 0) & (feature == k)][0] for k in range(1, len(residues_of[0]) + 1)} - {own}
    seen += len(frames)
    together += sum(f == own for f in found)
    swapped += sum(f in other_pockets for f in found)
    print(f"pocket {number}: recognised by its residues in {len(frames)} frames, on its track in "
          f"{sum(f == own for f in found)}")
    assert len(frames) >= 0.95 * FRAMES, frames
    cleft_track = own if number == 1 else cleft_track
print(f"all pockets: {100.0 * together / seen:.1f} % on their tracks, {swapped} swapped, of {seen}")
assert swapped == 0 and together == seen
for one in set(track):
    times = time[track == one]
    assert len(set(times)) == len(times), "two features of one time in a track"
chart = tracks.GetChart()
assert chart.GetNumberOfRows() == FRAMES
volumes = column(table, "Volume")[track == cleft_track]
assert volumes.max() > 1.2 * volumes.min()  # it breathes



def xyz(frames):
    """A reader of carbon atoms that move."""
    text = []
    for frame, atoms in enumerate(frames):
        text.append(f"{len(atoms)}\nframe {frame}\n")
        text += [f"C {x:.5f} {y:.5f} {z:.5f}\n" for x, y, z in atoms]
    reader, name = open_models("".join(text), ".xyz")
    reader.BondsByDistanceOff()
    return reader, name


def ring(r, z, count):
    angles = 2.0 * numpy.pi * numpy.arange(count) / count
    return [(r * numpy.cos(a), r * numpy.sin(a), z) for a in angles]


# The cells of pockets are one feature for each pocket: the same tracks as by the table.
half = {}
for port in (0, 1):
    reader, name = open_models("".join(text[: text.index("ENDMDL\n") * 6 + 6]) + "END\n", ".pdb")
    finder = isthmus.vtkMolecularPockets()
    finder.SetFindSites(False)  # the table's center of a site is a mode, that of its cells their mean
    table = run(reader, finder, port, 4).GetOutput()
    os.remove(name)
    half[port] = {
        (time, feature): (track, volume)
        for track, time, feature, volume in zip(
            *(column(table, word) for word in ("Track", "Time", "FeatureId", "Volume")))
    }
assert len({time for time, _ in half[0]}) == 6 and half[0].keys() == half[1].keys()
for key, (track, volume) in half[0].items():
    assert track == half[1][key][0] and abs(volume - half[1][key][1]) < 1e-9, key

# A tube of carbon atoms with three throats that breathe in turn, of known widths at all times.
phases = 2.0 * numpy.pi * (numpy.arange(FRAMES)[:, None] / FRAMES + numpy.arange(3) / 3.0)
throats = 4.2 + 0.4 * numpy.sin(phases)
frames = []
for widths in throats:
    atoms = []
    for z in numpy.arange(-14.0, 14.1, 1.0):
        near = min(range(3), key=lambda k: abs(z - 8.0 * (k - 1)))
        atoms += ring(numpy.sqrt(widths[near] ** 2 + 0.4 * (z - 8.0 * (near - 1)) ** 2), z, 24)
    for z in (-14.0, 14.0):
        for r in numpy.arange(7.5, 20.0, 1.5):
            atoms += ring(r, z, 60)
    frames.append(atoms)
reader, name = xyz(frames)
pores = isthmus.vtkPoreProfile()
pores.SetMode(pores.PointAndDirection)
table = run(reader, pores, 3).GetOutput()
os.remove(name)
track, time, z = (column(table, word) for word in ("Track", "Time", "Z"))
assert table.GetNumberOfRows() == 3 * FRAMES and set(track) == {1, 2, 3}, table.GetNumberOfRows()
for number in (1, 2, 3):
    own = track == number
    throat = int(round(z[own].mean() / 8.0)) + 1
    assert list(numpy.sort(time[own])) == list(range(FRAMES)) and abs(z[own] - z[own].mean()).max() < 0.5
    radius = column(table, "Radius")[own][numpy.argsort(time[own])]
    difference = abs(radius - (throats[:, throat] - 1.7)).max()
    print(f"throat {throat}: radius in time against the known one: largest difference {difference:.5f}")
    assert difference < 0.001, difference
