"""Sites and whole pockets of the eight shared complexes: where the ligands are, whatever becomes of the ligands."""

import numpy
from paraview import servermanager, simple

import pocket_tools as tools
from shared_data import shared_data

SUCCESS = 4.0  # angstrom, from the nearest atom of the ligand


def moved(lines, mask):
    """The lines with the ligand 15 angstrom off, into whatever is there."""
    result = []
    for line, is_ligand in zip(lines, mask):
        if is_ligand:
            x, y, z = tools.place_of(line)
            line = f"{line[:30]}{x + 15.0:8.3f}{y:8.3f}{z:8.3f}{line[54:]}"
        result.append(line)
    return result


def same(first, second):
    a, b = (tools.columns(finder.GetPocketTable()) for finder in (first, second))
    return a.keys() == b.keys() and all(
        numpy.array_equal(a[name], b[name], equal_nan=True) for name in a
    )


plateau = [(inner, outer) for inner in (1.5, 1.7, 1.9) for outer in (2.8, 3.1, 3.5)]
first, three, whole, settings = 0, 0, [], dict.fromkeys(plateau, 0)
for name, lines, mask in tools.complexes():
    ligand = [tools.place_of(line) for line, is_ligand in zip(lines, mask) if is_ligand]
    removed = tools.read([line for line, is_ligand in zip(lines, mask) if not is_ligand])
    finder = tools.pockets(removed)
    assert same(finder, tools.pockets(tools.read(lines))), f"{name}: the ligand was seen"
    assert same(finder, tools.pockets(tools.read(moved(lines, mask)))), f"{name}: moved"
    found = tools.distances(finder, ligand)
    first += found[0] <= SUCCESS
    three += min(found) <= SUCCESS
    whole.append(tools.distances(tools.pockets(removed, FindSites=False), ligand))
    for inner, outer in plateau:
        other = tools.pockets(removed, InnerRadius=inner, OuterRadius=outer, FindSites=False)
        settings[inner, outer] += tools.distances(other, ligand, 1)[0] <= SUCCESS
    print(name, " ".join(f"{distance:.1f}" for distance in found))
print(f"first {first}, among three {three} of 8; settings: {sorted(settings.values())}")
assert first >= 7 and three == 8, (first, three)
# Whole pockets, as before there were sites.
assert sum(d[0] <= SUCCESS for d in whole) >= 7 and max(min(d) for d in whole) <= SUCCESS, whole
assert min(settings.values()) >= 7, settings

# Through ParaView's proxies, as the window has it.
atoms = simple.OpenDataFile(str(shared_data("molecules/1hew.pdb")))
pockets = simple.MolecularPockets(Input=atoms)
pockets.UpdatePipeline()
cells = servermanager.Fetch(pockets, idx=0)
table = servermanager.Fetch(pockets, idx=1)
count = table.GetNumberOfRows()
assert cells.GetCellData().GetArray("PocketId").GetRange() == (1.0, float(count))
notes = cells.GetFieldData().GetAbstractArray("Notes")
texts = [notes.GetValue(i) for i in range(notes.GetNumberOfValues())]
assert any("NAG" in text for text in texts) and any("Water" in text for text in texts), texts
residues = servermanager.Fetch(pockets, idx=4)
lining = [
    {
        residues.GetValueByName(row, "ResidueId").ToInt()
        for row in range(residues.GetNumberOfRows())
        if residues.GetValueByName(row, "PocketId").ToInt() == pocket
    }
    for pocket in (1, 2)
]
# Two sites of the cleft: the tryptophans, and the catalytic acids.
assert {62, 63, 108} & lining[0] and {35, 52} & lining[1], lining
parents = [table.GetValueByName(row, "Parent").ToInt() for row in (0, 1)]
assert parents == [1, 1], parents
pockets.ShownPocket = 2
pockets.UpdatePipeline()
lining = servermanager.Fetch(pockets, idx=5)
assert lining.GetPointData().GetArray("PocketId").GetRange() == (2.0, 2.0)
assert lining.GetNumberOfLines() > 0

# Numbers of one kind come from one place: what cells, balls and table say is the same.
finder = tools.pockets(tools.read(tools.lines_of(shared_data("molecules/1hew.pdb"))))
values = tools.columns(finder.GetPocketTable())
volumes = tools.vtk_to_numpy(finder.GetOutput().GetCellData().GetArray("EmptyVolume"))
owners = tools.vtk_to_numpy(finder.GetOutput().GetCellData().GetArray("PocketId"))
sums = numpy.bincount(owners, volumes)[1:]
assert numpy.allclose(sums, values["Volume"], rtol=1e-12), (sums, values["Volume"])
for column in ("Volume", "Area", "MouthArea", "Score"):  # two volumes were below 0 here
    assert values[column].min() >= 0.0, values[column]
assert volumes.min() >= 0.0
labels = finder.GetLiningAtoms().GetPointData().GetAbstractArray("ResidueLabel")
assert "TRP 62 A" in {labels.GetValue(i) for i in range(labels.GetNumberOfValues())}
assert numpy.allclose(values["PolarShare"] + values["ApolarShare"], 1.0)
assert finder.GetAlphaBalls().GetNumberOfPoints() == finder.GetOutput().GetNumberOfCells()

# Of names in a view, those that hide none of the ones before.
from isthmus import pocket_views  # noqa: E402

names = [("GLU 35 A", (100.0, 100.0), 7), ("ASP 52 A", (120.0, 110.0), 8), ("TRP 62 A", (100.0, 130.0), 9),
         ("TRP 63 A", (175.0, 100.0), 3)]
assert pocket_views.without_overlap(names) == [7, 9, 3]
assert pocket_views.without_overlap(names, letter=10.0) == [7, 9]
assert pocket_views.without_overlap(names, height=40.0) == [7, 3]
