"""Molecule Cartoon: secondary structure beside DSSP's program, outputs, looks, labels, distances, selection by residue."""

import time

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from shared_data import shared_data

from isthmus_plugin import look, pipelines  # there once paraview.simple has loaded the plugin
from isthmus_plugin import molecule_views as molecules

# What mkdssp 4.2.2 (Debian 12) finds; its B, T, S, P and blank are C here.
DSSP = {
    "molecules/1ubq.pdb": "CEEEEEECCCCEEEEECCCCCCHHHHHHHHHHHHCCCGGGEEEEECCEECCCCCCCGGGCCCCCCEEEEEECCCCC",
    "molecules/4pti.pdb": "CCGGGGCCCCCCCCCCCEEEEEEECCCCEEEEEEECCCCCCCCCCCCHHHHHHHHCCC",
    "molecules/pdb1ake.pdb":
        "CEEEEEECCCCCHHHHHHHHHHHHCCCEEEHHHHHHHHHHHCCCCCGGGHHHHHHCCCCCHHHHHHHHHHHHHCGGGGGCEEEECCCCCHHHHHHHHHCCCCCCEEEEEE"
        "CCGGGHHHHHHCEEEECCCCEEEECCCCCCCCCCCCCCCCCCCCCCCCCCHHHHHHHHHHIIIIICCHHHHHHHHHHCCCCEEEEEECCCCHHHHHHHHHHHHC",
    "molecules/1hew.pdb":
        "CCCCHHHHHHHHHHCCCCCCCCCCHHHHHHHHHHHHCCCCCCEEECCCCCEEECCCCEECCCCCCCCCCCCCCCCCCCCGGGGGCCCCHHHHHHHHHHHCCCCGGGGCHH"
        "HHHHCCCCCGGGGGCCCCC",
    "molecules/complexes/1lee.pdb.gz":
        "CCCCCEEEEEEEECCCEEEEEEEECCCCEEEEEEEECCCCCEEEECCCCCCCGGGGCCCCCGGGCCCCEEEEEEEEEEECCEEEEEEEEEEEEEECCEEEEEEEEEEE"
        "ECGGGCCCGGGCCCCEEEECCCGGGCCCCCCCHHHHHHHCCCCCCCEEEEECCCCCCCCEEEEECCCCGGGEEEEEEEEECCEECCEEEEEEEEECCEEEEEEEEEEC"
        "CCCCCEEECHHHHHHHHCCCCCEECCCCCCEEEECCCCCCCCEEEECCCCEEEECHHHHEEECCCCCCCEEEECEEECCCCCCEEEECHHHHHHEEEEEECCCCEEEE"
        "EEECCCC"}


def rows(cartoon):
    """Residues of the table that are amino acids, by (name of the array -> values)."""
    table = servermanager.Fetch(cartoon, idx=molecules.RESIDUES)
    data = table.GetPointData()
    return {name: [data.GetAbstractArray(name).GetValue(i) for i in range(table.GetNumberOfPoints())]
            for name in ("Residue", "ResidueName", "Chain", "ResidueId", "SecondaryStructure", "ResidueIndex")}


def finite(data):
    for array in (data.GetPoints().GetData(), data.GetPointData().GetArray("Normals")):
        assert numpy.isfinite(vtk_to_numpy(array)).all()


# Secondary structure.
for path, expected in DSSP.items():
    cartoon = simple.MoleculeCartoon(simple.OpenDataFile(str(shared_data(path))), ComputeSecondaryStructure=1,
                                     IncludeLigands=0, IncludeIons=0)
    found = "".join("CHEGIN"[s] for s in rows(cartoon)["SecondaryStructure"])
    assert found == expected, f"{path}:\n{found}\n{expected}"

# HELIX and SHEET of the file: helices of 23 to 34 and 56 to 59, strands of 1 to 7 and 10 to 17 and more.
ubiquitin = simple.MoleculeCartoon(simple.OpenDataFile(str(shared_data("molecules/1ubq.pdb"))))
given = dict(zip(rows(ubiquitin)["ResidueId"], rows(ubiquitin)["SecondaryStructure"]))
assert [given[i] for i in (22, 23, 34, 35, 56, 59, 60)] == [0, 1, 1, 0, 3, 3, 0], given
assert [given[i] for i in (1, 7, 8, 9, 10, 17, 18)] == [2, 2, 0, 0, 2, 2, 0], given

# A ligand, water and the residues of the chain; of mmCIF without any record of helices, DSSP's.
lysozyme = simple.MoleculeCartoon(simple.OpenDataFile(str(shared_data("molecules/1hew.pdb"))))
of_lysozyme = rows(lysozyme)
assert of_lysozyme["ResidueName"][129:] == ["NAG"] * 3, of_lysozyme["ResidueName"][129:]
assert of_lysozyme["ResidueIndex"] == list(range(132))
for port in (molecules.CARTOON, molecules.STICKS):
    data = servermanager.Fetch(lysozyme, idx=port)
    finite(data)
    index = vtk_to_numpy(data.GetCellData().GetArray("ResidueIndex"))
    assert set(index) == set(range(129) if port == molecules.CARTOON else range(129, 132))
toxin = simple.MoleculeCartoon(simple.OpenDataFile(str(shared_data("molecules/1FAS.cif"))))
assert set(rows(toxin)["SecondaryStructure"]) >= {0, 2}  # three fingers of strands

# Looks.
view = simple.CreateView("RenderView")
display = molecules.show(lysozyme, view)
assert tuple(display.ColorArrayName) == ("CELLS", "SecondaryStructure"), display.ColorArrayName
assert list(display.LookupTable.Annotations) == ["0", "coil", "1", "helix", "2", "strand", "3", "3-10 helix"]
molecules.colour(display, view, "BFactor")
low, high = display.LookupTable.RGBPoints[0], display.LookupTable.RGBPoints[-4]
assert 0 < low < high < 100, (low, high)
molecules.colour(display, view, "ChainIndex")
assert list(display.LookupTable.Annotations) == ["0", "A"]
try:
    molecules.colour(display, view, "pLDDT")
except ValueError as error:
    assert "BFactor" in str(error), error
else:
    raise AssertionError("There is no pLDDT, and it was not refused.")

# Colours of AlphaFold's classes, from 0 to 100.
calculator = simple.Calculator(Input=simple.OpenDataFile(str(shared_data("molecules/1ubq.pdb"))),
                               ResultArrayName="pLDDT", Function="80 + 0*coordsX")
predicted = molecules.show(simple.MoleculeCartoon(calculator), view)
assert predicted.ColorArrayName[1] == "pLDDT"
table = predicted.LookupTable
for value, colour in ((10.0, (1.0, 0.490, 0.271)), (60.0, (1.0, 0.859, 0.075)), (80.0, (0.396, 0.796, 0.953)),
                      (95.0, (0.0, 0.325, 0.839))):
    got = [0.0] * 3
    table.GetClientSideObject().GetColor(value, got)
    assert max(abs(a - b) for a, b in zip(got, colour)) < 0.01, (value, got)

# Names of residues, distances, selection.
assert molecules.rows_of(lysozyme, "A:35, 52") == [34, 51]
assert molecules.rows_of(lysozyme, "NAG") == [129, 130, 131]
assert molecules.rows_of(lysozyme, "B:35") == []
names = molecules.label(lysozyme, "A:35 A:52", view)
assert names.SelectionPointLabelVisibility and names.SelectionPointFieldDataArrayName == "Residue"
places = {name: servermanager.Fetch(lysozyme, idx=molecules.RESIDUES).GetPoint(row)
          for name, row in (("A:35", 34), ("A:52", 51))}
length = numpy.linalg.norm(numpy.subtract(places["A:35"], places["A:52"]))
assert abs(molecules.distance(lysozyme, "A:35", "A:52", view) - length) < 1e-9
assert 5 < length < 15, length  # the catalytic residues
for wrong in ("NAG", "A:1000"):
    try:
        molecules.distance(lysozyme, "A:35", wrong, view)
    except ValueError as error:
        assert wrong in str(error)
    else:
        raise AssertionError(f"{wrong} was not refused.")
assert molecules.select(lysozyme, "A:35 A:52 NAG") == [34, 51, 129, 130, 131]
assert molecules.selected(lysozyme, molecules.CARTOON) == [34, 51]
assert molecules.selected(lysozyme, molecules.STICKS) == [129, 130, 131]
assert molecules.selected(lysozyme, molecules.RESIDUES) == [34, 51, 129, 130, 131]
# A row of the table that a user selects is selected in the cartoon, and polygons in the table.
picked = simple.IDSelectionSource(FieldType="POINT", IDs=[-1, 10])
lysozyme.SMProxy.SetSelectionInput(molecules.RESIDUES, picked.SMProxy, 0)
pipelines.selection_changed(lysozyme.GetGlobalID())  # as the window does
assert molecules.selected(lysozyme, molecules.CARTOON) == [10]
polygons = vtk_to_numpy(servermanager.Fetch(lysozyme, idx=0).GetCellData().GetArray("ResidueIndex"))
picked = simple.IDSelectionSource(FieldType="CELL", IDs=[-1, int(numpy.flatnonzero(polygons == 20)[0])])
lysozyme.SMProxy.SetSelectionInput(molecules.CARTOON, picked.SMProxy, 0)
pipelines.selection_changed(lysozyme.GetGlobalID())
assert molecules.selected(lysozyme, molecules.RESIDUES) == [20]
# A spreadsheet of residues begins with what names them.
sheet = simple.CreateView("SpreadSheetView")
shown = simple.Show(simple.OutputPort(lysozyme, molecules.RESIDUES), sheet, "SpreadSheetRepresentation")
look.first_look(shown.GetGlobalID())
assert "ChainIndex" in list(sheet.HiddenColumnLabels) and "ResidueName" not in list(sheet.HiddenColumnLabels)

# 8,000 residues of GroEL and GroES.
groel = simple.OpenDataFile(str(shared_data("molecules/1aon.pdb.gz")))
groel.UpdatePipeline()
start = time.process_time()
large = simple.MoleculeCartoon(groel, ComputeSecondaryStructure=1)
large.UpdatePipeline()
seconds = time.process_time() - start
assert len(rows(large)["Residue"]) > 8000
assert seconds < 5.0, seconds
