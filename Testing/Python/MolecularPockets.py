"""Sites and whole pockets of the eight shared complexes: where the ligands are, whatever becomes of the ligands."""

import numpy
from paraview import servermanager, simple

from isthmus_plugin import pipelines, pocket_views  # there once paraview.simple has loaded the plugin
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
# The cleft: the tryptophans, and the catalytic acids at its other end. The second site is elsewhere.
assert {35, 52, 62, 63, 108} <= lining[0] and not {35, 52, 62, 63, 108} & lining[1], lining
parent = table.GetValueByName(0, "Parent").ToInt()
assert parent == 1, parent
pockets.ShownPocket = 2
pockets.UpdatePipeline()
lining = servermanager.Fetch(pockets, idx=5)
assert lining.GetPointData().GetArray("PocketId").GetRange() == (2.0, 2.0)
assert lining.GetNumberOfLines() > 0

# The residues of each pocket in the table, those with the largest area first.
areas = {}
for row in range(residues.GetNumberOfRows()):
    name = " ".join(residues.GetValueByName(row, column).ToString() for column in ("ResidueName", "ResidueId", "Chain"))
    areas.setdefault(residues.GetValueByName(row, "PocketId").ToInt(), {})[name] = (
        residues.GetValueByName(row, "Area").ToDouble())
for row in range(count):
    named = table.GetValueByName(row, "Residues").ToString().split("; ")
    assert named == sorted(areas[row + 1], key=lambda name: -areas[row + 1][name]), (row, named)

# The window: headers with units; a chosen row shows its pocket; Shown Pocket hides the others.
view = simple.CreateView("RenderView")
simple.AssignViewToLayout(view)
pocket_views.show(pockets, view)
assert all(True for _ in "of Python"), "a script has put numpy's functions in place of Python's"
(headed,) = [source for source in simple.GetSources().values() if source.SMProxy.GetXMLName() == "RenameArrays"]
shown = servermanager.Fetch(headed)
headers = {shown.GetColumnName(i) for i in range(shown.GetNumberOfColumns())}
assert {"# Rank", "Volume (\u00c5\u00b3)", "Area (\u00c5\u00b2)", "MeanPotential (kT/e)", "Residues"} <= headers, headers
(sheet,) = [other for other in simple.GetViews() if other.SMProxy.GetXMLName() == "SpreadSheetView"]
assert "MouthArea (\u00c5\u00b2)" in sheet.HiddenColumnLabels and "Residues" not in sheet.HiddenColumnLabels


def opacities():
    """Opacity of each shown surface of pockets, by the pockets that it has."""
    found = {}
    for display in view.Representations:
        part = getattr(display, "Input", None)
        if part is not None and display.Visibility and part.SMProxy.GetXMLName() == "Threshold" and (
                part.CellData["PocketId"] is not None):
            found[part.CellData["PocketId"].GetRange()] = display.Opacity
    return found


assert opacities() == {(1.0, 3.0): pocket_views.FAINT, (1.0, 1.0): pocket_views.STRONG}, opacities()
pocket_views.show_only(pockets, 2)
assert opacities() == {(2.0, 2.0): pocket_views.STRONG}, opacities()
pocket_views.show_only(pockets, 0)
assert opacities() == {(1.0, 3.0): pocket_views.FAINT, (1.0, 1.0): pocket_views.STRONG}, opacities()
headed.SMProxy.SetSelectionInput(0, simple.IDSelectionSource(FieldType="ROW", IDs=[-1, 3]).SMProxy, 0)
pipelines.selection_changed(headed.GetGlobalID())  # as the window does
chosen = pocket_views.residues_of(pockets)
assert chosen.LowerThreshold == 4.0, chosen.LowerThreshold
lining = servermanager.Fetch(pocket_views.lining_of(pockets))  # what Save Data writes
assert {lining.GetValueByName(row, "PocketId").ToInt() for row in range(lining.GetNumberOfRows())} == {4}

# What belongs to deleted pockets is deleted, too: ParaView gives it their input.
names = pocket_views.names_of(chosen)
chosen.Input = pockets.Input
pipelines.forget()
assert not {chosen, names} & set(simple.GetSources().values()) and headed in simple.GetSources().values()

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
names = [("GLU 35 A", (100.0, 100.0), 7), ("ASP 52 A", (120.0, 110.0), 8), ("TRP 62 A", (100.0, 130.0), 9),
         ("TRP 63 A", (175.0, 100.0), 3)]
assert pocket_views.without_overlap(names) == [7, 9, 3]
assert pocket_views.without_overlap(names, letter=10.0) == [7, 9]
assert pocket_views.without_overlap(names, height=40.0) == [7, 3]
