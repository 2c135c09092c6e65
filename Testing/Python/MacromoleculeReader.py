"""Every shared molecule against gemmi or an independent split of its lines; opening in ParaView."""

import bz2
import contextlib
import gzip
import io
import math
import os
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import gemmi
import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import corpus
import isthmus
from isthmus import command, data_pipelines
from shared_data import shared_data

OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "MacromoleculeReader"
FOLDER = shared_data("molecules")

# Atoms (grep -cE '^(ATOM|HETATM)') and chains, by hand.
TABLE = {
    "1A1P_assign-only_whitespace_AMBER.pqr": (205, ""), "1AJJ.pdb": (315, "A"),
    "1AJJ_pH2_CHARMM.pqr": (522, ""), "1AJJ_pH7_AMBER.pqr": (513, ""),
    "1AJJ_pH7_PARSE.pqr": (513, ""), "1FAS.cif": (575, "A"), "1UBI.pdb": (683, "A"),
    "1a1p.pdb": (208, ""), "1aon.pdb.gz": (58870, "ABCDEFGHIJKLMNOPQRSTU"),
    "1crn_apbs.pqr": (642, ""), "1grm_gramicidin_model1.pdb": (272, "AB"),
    "1hew.pdb": (1147, "AB"), "1hew/1hew.pqr": (1960, ""), "1oel_A.pdb": (3847, "A"),
    "1ubq.pdb": (660, "A"), "2LYZ.pdb": (1102, "A"), "2kix.pdb": (2228, "ABCD"),
    "4pti.pdb": (514, "A"), "pdb1ake.pdb": (1661, "A"),
    "apbs/actin-dimer/complex.pqr": (11754, ""), "apbs/actin-dimer/mol1.pqr": (5877, ""),
    "apbs/actin-dimer/mol2.pqr": (5877, ""), "apbs/alkanes/2-methylbutane.pdb": (17, ""),
    "apbs/alkanes/butane.pdb": (14, ""), "apbs/alkanes/cyclohexane.pdb": (18, "K"),
    "apbs/alkanes/cyclopentane.pdb": (13, "K"), "apbs/alkanes/ethane.pdb": (8, "K"),
    "apbs/alkanes/hexane.pdb": (20, ""), "apbs/alkanes/isobutane.pdb": (14, ""),
    "apbs/alkanes/methane.pdb": (5, ""), "apbs/alkanes/mol.pdb": (11, ""),
    "apbs/alkanes/neopentane.pdb": (17, ""), "apbs/alkanes/pentane.pdb": (17, ""),
    "apbs/alkanes/propane.pdb": (11, ""), "apbs/bem/test_proteins/1a63.pqr": (2065, ""),
    "apbs/bem/test_proteins/1ajj.pqr": (519, ""), "apbs/bem/test_proteins/1bbl.pqr": (576, ""),
    "apbs/bem/test_proteins/451c.pqr": (1216, ""), "apbs/bem/test_proteins/oneb.pqr": (1, ""),
    "apbs/bem/test_proteins/twob.pqr": (2, ""), "apbs/bem/test_proteins/twob2.pqr": (2, ""),
    "apbs/born/ion.pqr": (1, ""), "apbs/geoflow/1a63.pqr": (2065, ""),
    "apbs/geoflow/gly.pdb": (15, "A"), "apbs/geoflow/gly.pqr": (29, ""),
    "apbs/geoflow/imidazole_zap.pqr": (9, ""), "apbs/helix/Membrane-helix-0.pqr": (317, ""),
    "apbs/helix/Membrane-helix-12.pqr": (317, ""), "apbs/helix/Membrane-helix-16.pqr": (317, ""),
    "apbs/helix/Membrane-helix-4.pqr": (317, ""), "apbs/helix/Membrane-helix-8.pqr": (317, ""),
    "apbs/ion-pmf/ion-pmf.pdb": (2, ""), "apbs/ionize/acetate.pqr": (8, ""),
    "apbs/ionize/acetic-acid.pqr": (8, ""), "apbs/ionize/proton.pqr": (1, ""),
    "apbs/misc/fas2.pqr": (906, ""), "apbs/pka-lig/bx6_7_apo_apbs.pqr": (3423, ""),
    "apbs/pka-lig/bx6_7_bin_apbs.pqr": (3470, ""), "apbs/pka-lig/bx6_7_lig_apbs.pqr": (47, ""),
    "apbs/point-pmf/complex-0_1.pqr": (2, ""), "apbs/point-pmf/complex-0_2.pqr": (2, ""),
    "apbs/point-pmf/complex-0_3.pqr": (2, ""), "apbs/point-pmf/complex-0_4.pqr": (2, ""),
    "apbs/point-pmf/mol0.pqr": (1, ""), "apbs/point-pmf/mol1.pqr": (1, ""),
    "apbs/point-pmf/mol2.pqr": (1, ""), "apbs/point-pmf/mol3.pqr": (1, ""),
    "apbs/point-pmf/mol4.pqr": (1, ""), "apbs/solv/methanol.pqr": (3, ""),
    "apbs/solv/methoxide.pqr": (2, ""), "complexes/1atp.pdb.gz": (3070, "EI"),
    "channels/1grm_hole_example.pdb": (272, "AB"),
    "complexes/1drf.pdb.gz": (1788, "A"), "complexes/1lee.pdb.gz": (3008, "A"),
    "complexes/1pwc.pdb.gz": (3191, "A"), "complexes/1uyd.pdb.gz": (1950, "A"),
    "complexes/2src.pdb.gz": (3915, "A"), "complexes/3pa3.pdb.gz": (2444, "A"),
    "pqr_variants/1000-chain-whitespace.pqr": (36, "A"), "pqr_variants/1000-chain.pqr": (36, "A"),
    "pqr_variants/1000-custom.pqr": (36, ""), "pqr_variants/1000-pymol.pqr": (19, ""),
    "pqr_variants/1000-resi-whitespace.pqr": (36, ""), "pqr_variants/1000.pqr": (36, ""),
}

# What must be told of a file; all others need no warning.
WARNED = {
    "1grm_gramicidin_model1.pdb": "Columns 73-80",
    "channels/1grm_hole_example.pdb": "Columns 73-80",
    "apbs/geoflow/gly.pdb": "not in the columns",
    "apbs/ion-pmf/ion-pmf.pdb": "not in the columns",
    "complexes/1atp.pdb.gz": "2 atoms have no radius",
    **{f"apbs/alkanes/{name}.pdb": "by the columns of the name" for name in (
        "2-methylbutane", "butane", "cyclohexane", "cyclopentane", "ethane", "hexane", "isobutane",
        "methane", "mol", "neopentane", "pentane", "propane")},
}


def read(path, **settings):
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(str(path))
    for name, value in settings.items():
        getattr(reader, f"Set{name}")(value)
    warnings = []
    reader.AddObserver("WarningEvent", lambda *_: warnings.append(1))
    reader.Update()
    said = texts(reader.GetOutput().GetFieldData(), "Warnings")
    assert len(said) == len(warnings), (path, said)
    return reader, said


def texts(attributes, name):
    array = attributes.GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def numbers(output, name):
    return vtk_to_numpy(output.GetPointData().GetArray(name))


def same(a, b):
    return numpy.array_equal(numpy.asarray(a, dtype=float), numpy.asarray(b, dtype=float),
                             equal_nan=True)


def atom_lines(path):
    """The atoms' lines of a PDB file; nothing for mmCIF, whose blanks are question marks."""
    if path.suffix == ".cif":
        return []
    text = gzip.open(path, "rt").read() if path.suffix == ".gz" else path.read_text()
    return [line for line in text.splitlines() if line.startswith(("ATOM", "HETATM"))]


def check_against_gemmi(path, output):
    """All of what gemmi reads, in its order."""
    old = path.name.startswith("1grm")
    structure = (gemmi.read_pdb(str(path), max_line_length=72) if old
                 else gemmi.read_structure(str(path), merge_chain_parts=False))
    rows = [(chain, residue, atom) for chain in structure[0] for residue in chain
            for atom in residue]
    assert len(rows) == output.GetNumberOfPoints()
    assert same(vtk_to_numpy(output.GetPoints().GetData()), [a.pos.tolist() for *_, a in rows])
    data = output.GetPointData()
    assert texts(data, "AtomName") == [a.name for *_, a in rows]
    assert texts(data, "ResidueName") == [r.name for _, r, _ in rows]
    assert texts(data, "Chain") == [c.name for c, *_ in rows]
    assert same(numbers(output, "ResidueId"), [r.seqid.num for _, r, _ in rows])
    assert same(numbers(output, "IsHetero"), [r.het_flag == "H" for _, r, _ in rows])
    assert same(numbers(output, "Element"),
                [1 if a.element.name == "D" else a.element.atomic_number for *_, a in rows])
    for array, column, values in (("Occupancy", 54, [a.occ for *_, a in rows]),
                                  ("BFactor", 60, [a.b_iso for *_, a in rows])):
        known = ~numpy.isnan(numbers(output, array))
        assert numpy.allclose(numbers(output, array)[known], numpy.array(values)[known], atol=1e-4)
        # gemmi gives blanks a number; ours are NaN.
        assert numpy.sum(~known) == sum(not line[column:column + 6].strip()
                                        for line in atom_lines(path)), (path, array)
    charges = numbers(output, "Charge")
    assert same(charges, [a.charge if a.charge else math.nan for *_, a in rows])
    # gemmi's table is Bondi's and Mantina's, too; it fills its gaps with other numbers.
    for radius, (*_, atom) in zip(numbers(output, "Radius"), rows):
        assert math.isnan(radius) or abs(radius - atom.element.vdw_r) < 1e-6, atom.element.name


def pqr_rows(path):
    """Position, charge, radius of each line by another way than the reader's."""
    for line in path.read_text().splitlines():
        if not line.startswith(("ATOM", "HETATM")):
            continue
        if path.name in ("1000.pqr", "1000-chain.pqr"):  # numbers run together: columns
            yield [line[30:38], line[38:46], line[46:54], *line[54:].split()]
        else:
            yield line.split()[-5:]


def check_pqr(path, output):
    rows = [[float(word) for word in row] for row in pqr_rows(path)]
    assert same(vtk_to_numpy(output.GetPoints().GetData()), [row[:3] for row in rows])
    assert same(numbers(output, "Charge"), [row[3] for row in rows])
    assert same(numbers(output, "Radius"), [row[4] for row in rows])
    assert numpy.isnan(numbers(output, "BFactor")).all()
    assert (numbers(output, "Element") > 0).all()


found = {str(p.relative_to(FOLDER)) for p in FOLDER.rglob("*")
         if p.name.endswith((".pdb", ".pdb.gz", ".cif", ".pqr"))}
assert found == set(TABLE), found ^ set(TABLE)
for name, (atoms, chains) in TABLE.items():
    path = FOLDER / name
    reader, warnings = read(path, AltLoc="*")
    output = reader.GetOutput()
    assert output.GetNumberOfPoints() == atoms, (name, output.GetNumberOfPoints())
    assert "".join(sorted(set(texts(output.GetPointData(), "Chain")))) == chains, name
    expected = WARNED.get(name)
    assert (len(warnings) == 1 and expected in warnings[0]) if expected else not warnings, name
    molecule = reader.GetMolecule()
    assert molecule.GetNumberOfAtoms() == atoms
    assert molecule.GetNumberOfBonds() == output.GetNumberOfLines()
    if name.endswith(".pqr"):
        check_pqr(path, output)
    elif "not in the columns" not in (expected or ""):
        check_against_gemmi(path, output)
print(f"{len(TABLE)} files read")

# Residues, insertion codes and names of the variants, by hand from their first atoms.
for name, chain in (("1000", ""), ("1000-chain", "A"), ("1000-custom", ""),
                    ("1000-chain-whitespace", "A"), ("1000-resi-whitespace", "")):
    data = read(FOLDER / "pqr_variants" / f"{name}.pqr")[0].GetOutput().GetPointData()
    residue = 1003 if "resi" in name else 3
    last = data.GetNumberOfTuples() - 1
    assert data.GetArray("ResidueId").GetValue(last) == residue, name
    assert data.GetAbstractArray("ResidueName").GetValue(last) == "ASP", name
    assert data.GetAbstractArray("Chain").GetValue(last) == chain, name
    assert data.HasArray("InsertionCode") == (residue == 1003)
four_letters = read(FOLDER / "apbs/pka-lig/bx6_7_apo_apbs.pqr")[0].GetOutput().GetPointData()
assert texts(four_letters, "ResidueName")[0] == "GLNN"
assert numbers(read(FOLDER / "apbs/born/ion.pqr")[0].GetOutput(), "Charge")[0] == 1.0

# Selections of lysozyme with its sugar: counts by grep.
lysozyme = FOLDER / "1hew.pdb"
lines = atom_lines(lysozyme)
count = lambda test: sum(1 for l in lines if test(l))  # noqa: E731
water = lambda l: l[17:20] == "HOH"  # noqa: E731
for settings, expected in (
        (dict(ReadWater=False), count(lambda l: not water(l))),
        (dict(ReadHetero=False), count(lambda l: l.startswith("ATOM") or water(l))),
        (dict(ReadHetero=False, ReadWater=False), count(lambda l: l.startswith("ATOM"))),
        (dict(Chains="B"), count(lambda l: l[21] == "B"))):
    output = read(lysozyme, **settings)[0].GetOutput()
    assert output.GetNumberOfPoints() == expected > 0, settings
# Each of its four disulfide bridges is named by the file, and each sugar ring bond.
bonds = read(lysozyme, BondsByDistance=False)[0].GetOutput()
names = texts(bonds.GetPointData(), "AtomName")
ends = [(names[bonds.GetCell(c).GetPointId(0)], names[bonds.GetCell(c).GetPointId(1)])
        for c in range(bonds.GetNumberOfPoints(), bonds.GetNumberOfCells())]
assert ends.count(("SG", "SG")) == 4

# The class, the panel, Python, pvpython and the command line read files with the endings of MoleculeFormats.h, plain
# and compressed. A format without a sample here is chosen by its endings, and refuses the text of another one.
SAMPLES = {
    "PDB": "HETATM    1  O   HOH A   1       1.000   2.000   3.000  1.00 10.00           O\n",
    "MMCIF": "data_w\nloop_\n" + "".join(f"_atom_site.{name}\n" for name in (
        "label_atom_id", "type_symbol", "Cartn_x", "Cartn_y", "Cartn_z")) + "O O 1 2 3\n",
    "PQR": "ATOM 1 O HOH 1 1.0 2.0 3.0 -0.8 1.7\n",
    "XYZ": "1\nwater\nO 1 2 3\n",
    "PDBQT": "HETATM    1  O   HOH A   1       1.000   2.000   3.000  1.00 10.00    -0.800 OA\n",
    "GRO": "water\n    1\n    1SOL     OW    1   0.100   0.200   0.300\n   1.0 1.0 1.0\n",
    "MOL2": "@<TRIPOS>MOLECULE\nw\n1 0\nSMALL\nNO_CHARGES\n@<TRIPOS>ATOM\n1 O 1 2 3 O.3\n",
    "SDF": "w\n\n\n  1  0  0  0  0  0  0  0  0  0999 V2000\n"
           "    1.0000    2.0000    3.0000 O   0  0\nM  END\n$$$$\n"}
panel = ElementTree.parse(Path(os.environ["ISTHMUS_PANELS_DIR"]) / "MacromoleculeReader.xml").getroot()
panel_endings = panel.find(".//ReaderFactory").get("extensions").split()
plain = [ending[1:] for ending in isthmus.vtkMacromoleculeReader.GetFileExtensions().split()]
assert {"bcif", "pdb1", "pdb9", "ent", "cif", "txyz"} <= set(plain), plain
assert sorted(panel_endings) == sorted(ending + packed for ending in plain for packed in ("", ".gz", ".bz2"))
assert ["." + ending for ending in plain] == list(data_pipelines.READERS["macromolecule_reader"])
# The panel's list of formats is that of the class.
entries = panel.find(".//IntVectorProperty[@name='Format']").findall(".//Entry")
formats = [value for value in vars(isthmus.vtkMacromoleculeReader).values()
           if isinstance(value, isthmus.vtkMacromoleculeReader.Formats)]
assert [int(entry.get("value")) for entry in entries] == sorted(formats), formats
OUTPUT.mkdir(parents=True, exist_ok=True)


def said_by_command(path):
    """What `isthmus pockets` says about a file with a water, in which there is no pocket."""
    with contextlib.redirect_stderr(io.StringIO()) as said:
        assert command.main(["pockets", "--quiet", str(path)]) == command.FAILED
    return said.getvalue()


guide = (Path(os.environ["ISTHMUS_EXAMPLES_DIR"]).parent / "Documentation/filters/MacromoleculeReader.md").read_text()
for ending in plain:
    assert re.search(rf"`\.{ending}[` ]| \.{ending}[` ]", guide), f".{ending} is not in the guide"
    for packed, pack in (("", bytes), (".gz", gzip.compress), (".bz2", bz2.compress)):
        path = OUTPUT / f"water.{ending}{packed}"
        reads = []
        for name, sample in SAMPLES.items():
            path.write_bytes(pack(sample.encode()))
            assert isthmus.vtkMacromoleculeReader.CanReadFile(str(path)), path
            reader = isthmus.vtkMacromoleculeReader()
            reader.SetFileName(str(path))
            if not corpus.errors_of_update(reader) and reader.GetOutput().GetNumberOfPoints() == 1:
                reads.append(name)
                break
        if not reads:
            continue
        found = isthmus.read(path)
        assert found.GetNumberOfPoints() == 1 and found.GetPoint(0) == (1.0, 2.0, 3.0), path
        source = simple.OpenDataFile(str(path))
        assert source.GetXMLName() == "MacromoleculeReader", (path, source.GetXMLName())
        assert servermanager.Fetch(source, idx=0).GetNumberOfPoints() == 1, path
        simple.Delete(source)
        assert "ending" not in said_by_command(path), path
        path.unlink()
for ending in ("pdb0", "txt"):
    path = OUTPUT / f"named.{ending}"
    path.write_text(SAMPLES["PDB"])
    assert not isthmus.vtkMacromoleculeReader.CanReadFile(str(path)), ending
    assert "no reader for the ending" in said_by_command(path), ending
    path.unlink()

# In ParaView: each extension, plain and compressed, is ours or offered; NaN radius for manganese only.
OUTPUT.mkdir(parents=True, exist_ok=True)
cif = OUTPUT / "1FAS.cif.gz"
cif.write_bytes(gzip.compress((FOLDER / "1FAS.cif").read_bytes()))
fullerene = shared_data("fullerenes/C60-Ih.xyz")
for path, atoms, bonds in ((cif, 573, 482), (lysozyme, 1147, 1070), (fullerene, 60, 90),
                           (FOLDER / "complexes/1uyd.pdb.gz", 1949, 1704),
                           (FOLDER / "1hew/1hew.pqr", 1960, 1984)):
    source = simple.OpenDataFile(str(path))
    assert source.GetXMLName() == "MacromoleculeReader", (path, source.GetXMLName())
    data = servermanager.Fetch(source, idx=0)
    assert (data.GetNumberOfPoints(), data.GetNumberOfLines()) == (atoms, bonds), path
    assert servermanager.Fetch(source, idx=1).GetNumberOfBonds() == bonds

view = simple.CreateView("RenderView")
view.ViewSize = [700, 700]
source = simple.OpenDataFile(str(lysozyme))
molecule = simple.Show(simple.OutputPort(source, 1), view)
assert molecule.Representation == "Molecule", molecule.Representation
simple.ResetCamera(view)
simple.SaveScreenshot(str(OUTPUT / "lysozyme.png"), view)
