"""Gramicidin against HOLE's own profile, a potassium channel, and proteins that no pore runs through."""

import csv

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import isthmus
import pocket_tools as tools
from shared_data import shared_data

# HOLE's simple.rad, by atomic number
HOLE_RADII = {1: 1.0, 6: 1.85, 7: 1.75, 8: 1.65, 15: 2.10, 16: 2.0}


def molecule(path, hole_radii=True):
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(str(shared_data(path)))
    reader.Update()
    atoms = reader.GetOutput()
    if hole_radii:
        elements = vtk_to_numpy(atoms.GetPointData().GetArray("Element"))
        radii = numpy.array([HOLE_RADII.get(element, 1.8) for element in elements])
        array = numpy_to_vtk(radii, deep=1)
        array.SetName("Radius")
        atoms.GetPointData().AddArray(array)
    return atoms


def profile(atoms, **settings):
    pores = isthmus.vtkPoreProfile()
    pores.SetInputData(atoms)
    for name, value in settings.items():
        getattr(pores, "Set" + name)(value)
    pores.Update()
    return pores


gramicidin = molecule("molecules/channels/1grm_hole_example.pdb")
pores = profile(gramicidin)
table = tools.columns(pores.GetPoreTable())
assert len(table["Radius"]) == 1, table
assert abs(table["Radius"][0] - 1.200) <= 0.005, table["Radius"]
same = profile(molecule("molecules/channels/1grm_hole_example.pdb", hole_radii=False),
               RadiusTable=isthmus.vtkPoreProfile.Hole)
assert abs(tools.columns(same.GetPoreTable())["Radius"][0] - table["Radius"][0]) < 1e-9

# HOLE's planes lie across y of this file.
rows = csv.DictReader(open(shared_data("molecules/channels/1grm_hole_profile.csv")))
hole = numpy.array([[float(value) for value in row.values()] for row in rows])
middle = len(hole) // 2
along = profile(
    gramicidin,
    Mode=isthmus.vtkPoreProfile.PointAndDirection,
    Point=(0.1, hole[middle, 0], 3.97),
    Direction=(0.0, 1.0, 0.0),
    Spacing=0.125,
)
samples = tools.columns(along.GetProfile())
order = numpy.argsort(samples["Y"])
ours = numpy.interp(hole[:, 0], samples["Y"][order], samples["Radius"][order])
inside = numpy.abs(hole[:, 0]) < 11.0  # farther out the mouth is wide open
difference = (ours - hole[:, 1])[inside]
print(f"HOLE: mean {abs(difference).mean():.4f}, largest {abs(difference).max():.4f}")
assert abs(difference).mean() <= 0.005 and abs(difference).max() <= 0.03
assert difference.min() > -1e-3  # HOLE searches at random, from below
open_end = numpy.abs(hole[:, 0]) < 16.5
assert abs(ours - hole[:, 1])[open_end].mean() <= 0.01

potassium = tools.columns(profile(molecule("molecules/2kix.pdb")).GetPoreTable())
assert abs(potassium["Radius"][0] - 1.40) <= 0.02, potassium["Radius"]
# Where the balls of neighbouring planes do not meet, a note says that the radius in between is unknown.
channels = profile(molecule("molecules/2kix.pdb", hole_radii=False))
samples = tools.columns(channels.GetProfile())
expected = {int(samples["PoreId"][i]) for i in range(len(samples["PoreId"]) - 1)
            if samples["PoreId"][i] == samples["PoreId"][i + 1] and samples["ArcLength"][i + 1] - samples["ArcLength"][i] >
            samples["Radius"][i] + samples["Radius"][i + 1]}
notes = channels.GetOutput().GetFieldData().GetAbstractArray("Notes")
notes = [notes.GetValue(i) for i in range(notes.GetNumberOfValues())] if notes else []
told = {int(note.split()[1]) for note in notes if " jumps by " in note}
assert told == expected and len(expected) == 1, (told, expected, notes)

for name in ("1ubq.pdb", "1hew.pdb", "4pti.pdb"):
    for hole_radii in (True, False):
        found = profile(molecule("molecules/" + name, hole_radii)).GetPoreTable()
        assert found.GetNumberOfRows() == 0, name

# Through ParaView's proxies, with the radii of the reader.
atoms = simple.OpenDataFile(str(shared_data("molecules/channels/1grm_hole_example.pdb")))
proxy = simple.PoreProfile(Input=atoms)
proxy.UpdatePipeline()
lines = servermanager.Fetch(proxy, idx=0)
assert lines.GetNumberOfLines() == 1
data = lines.GetPointData()
for name in ("Radius", "ArcLength", "NearestAtom", "NearestResidue", "WidthClass", "PoreId"):
    assert data.GetAbstractArray(name), name
names = data.GetAbstractArray("NearestResidue")
residues = {names.GetValue(i) for i in range(names.GetNumberOfValues())}
assert any(residue.startswith("VAL") for residue in residues), residues
tubes = servermanager.Fetch(proxy, idx=5)
assert tubes.GetNumberOfPolys() + tubes.GetNumberOfStrips() > 0


# GroEL without its lid (1AON, chains A to N): first comes the channel along its sevenfold axis.
reader = isthmus.vtkMacromoleculeReader()
reader.SetFileName(str(shared_data("molecules/1aon.pdb.gz")))
reader.SetChains("A B C D E F G H I J K L M N")
reader.Update()
groel = reader.GetOutput()
pores = profile(groel, MaximumPores=1)
places = vtk_to_numpy(groel.GetPoints().GetData())
chains = groel.GetPointData().GetAbstractArray("Chain")
chains = numpy.array([chains.GetValue(i) for i in range(len(places))])
rings = [places[numpy.isin(chains, list(names))].mean(axis=0) for names in ("ABCDEFG", "HIJKLMN")]
axis = (rings[1] - rings[0]) / numpy.linalg.norm(rings[1] - rings[0])
samples = tools.columns(pores.GetProfile())
line = numpy.stack([samples[name] for name in "XYZ"], axis=1) - rings[0]
off = numpy.linalg.norm(line - numpy.outer(line @ axis, axis), axis=1)
span = numpy.ptp(line @ axis)
# The room on the axis, by all atoms, is no more than that of the largest ball in the plane there.
radii = vtk_to_numpy(groel.GetPointData().GetArray("Radius"))
picked = range(0, len(line), max(1, len(line) // 25))
room = [(numpy.linalg.norm(places - rings[0] - (line[i] @ axis) * axis, axis=1) - radii).min() for i in picked]
excess = numpy.array([samples["Radius"][i] for i in picked]) - room
print(f"GroEL: {span:.0f} angstrom long, at most {off.max():.2f} off the axis, least radius "
      f"{samples['Radius'].min():.2f}, above the room on the axis by {excess.min():.3f} to {excess.max():.3f}")
assert span > 150.0 and off.max() < 2.0 and samples["Radius"].min() > 12.0
assert excess.min() > -0.05 and excess.max() < 2.0
