"""The files of public bug reports in reports/ of the shared data, opened as users open them, with what its
PROVENANCE.md says is right."""

import collections
import os
import tempfile
import warnings

import isthmus
from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy

from shared_data import shared_data

from isthmus_plugin import pipelines  # there once paraview.simple has loaded the plugin

SYMBOLS = {0: "X", 1: "H", 6: "C", 7: "N", 8: "O", 16: "S", 17: "Cl", 20: "Ca"}


def opened(name):
    source = simple.OpenDataFile(str(shared_data(f"reports/{name}")))
    source.UpdatePipeline()
    return source, servermanager.Fetch(source)


def texts(data, name):
    array = data.GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []


def molecule(name):
    """The reader, and columns of its atoms."""
    source, data = opened(name)
    assert source.GetXMLName() == "MacromoleculeReader", (name, source.GetXMLName())
    points = data.GetPointData()
    atoms = {column: texts(points, column) for column in
             ("Element", "AtomName", "ResidueName", "ResidueId", "InsertionCode", "Chain", "Charge")}
    atoms["Elements"] = dict(collections.Counter(SYMBOLS[e] for e in atoms["Element"]))
    atoms["Notes"] = " ".join(texts(data.GetFieldData(), "Notes"))
    atoms["Frames"] = len(list(source.TimestepValues)) or 1
    return source, atoms


def volume(source):
    measures = simple.SurfaceMeasures(Input=source)
    measures.UpdatePipeline()
    field = servermanager.Fetch(measures).GetFieldData()
    return field.GetArray("Volume").GetValue(0)


# Elements by names: the molecule, and its surface, which calcium and mercury had given 23 handles.
adk, atoms = molecule("adk_open.pdb.gz")
assert atoms["Elements"] == {"N": 289, "H": 1685, "C": 1040, "S": 7, "O": 320}, atoms["Elements"]
surface, = pipelines.protein_to_surface(adk)
simple.SetActiveSource(None)
measures = simple.SurfaceMeasures(Input=surface)
measures.UpdatePipeline()
genus = servermanager.Fetch(measures).GetFieldData().GetArray("Genus").GetValue(0)
assert genus == 3, genus
_, atoms = molecule("adk_open.pqr")
assert atoms["Elements"] == {"N": 289, "H": 1685, "C": 1040, "S": 7, "O": 320}, atoms["Elements"]
_, atoms = molecule("amoeba-ion-in-water.pdb")
assert atoms["Elements"] == {"Ca": 1, "O": 215, "H": 430}, atoms["Elements"]

# Columns missing, other columns, frames, parts.
for name in ("m01_esmfold2_no_occupancy.cif", "m02_no_B_iso.cif", "m03b_phenix_no_label_asym.cif"):
    _, atoms = molecule(name)
    assert len(atoms["Element"]) == 33, name
for name in ("n01_end_separated_frames.pdb", "n02_model_col7.pdb"):
    _, atoms = molecule(name)
    assert atoms["Frames"] == 5, (name, atoms["Frames"])
for name in ("n10_chains_repeat_after_end.pdb", "n14_clusplus_rec_lig.pdb"):
    _, atoms = molecule(name)
    assert set(atoms["Chain"]) == {"A", "B"} and len(atoms["Chain"]) == 6, name
    assert atoms["Frames"] == 1 and "read as one structure" in atoms["Notes"], name
_, atoms = molecule("5dhfr_cube.pdb.gz")
assert set(atoms["Chain"]) == {"X"}
waters = [n for n in atoms["ResidueName"] if n.startswith("TIP")]
assert waters and set(waters) == {"TIP3"}
_, atoms = molecule("5digitResid.pdb.gz")
assert atoms["ResidueId"] == [1, 10, 100, 1000, 10000]
assert not any(str(code).strip() for code in atoms["InsertionCode"]), atoms["InsertionCode"]
_, atoms = molecule("p13_hex_popcl.pdb")
assert atoms["ResidueName"] == ["SER", "POPC", "POPC", "POPC", "POPC"]
_, atoms = molecule("vermouth_tests_data_2dn2.pdb.gz")
assert len(atoms["Element"]) == 4384
_, atoms = molecule("b01_bom.pqr")
assert len(atoms["Charge"]) == 2 and sum(atoms["Charge"]) == 0.0

# Other formats, and what has no elements.
_, atoms = molecule("1544173.cif")
assert len(atoms["Element"]) > 0 and "asymmetric unit" in atoms["Notes"]
_, atoms = molecule("pdbqt_inputpdbqt.pdbqt")
assert len(atoms["Element"]) == 1805
_, atoms = molecule("p21_martini.pdb")
assert atoms["Elements"] == {"X": 11} and "Martini" in atoms["Notes"]

# Quadratic meshes.
_, data = opened("tetgen_o2/cube.1.face")
markers = collections.Counter(texts(data.GetCellData(), "BoundaryMarker"))
assert markers == dict.fromkeys(range(1, 7), 2), markers
_, data = opened("tetgen_o2/cube.1.ele")
assert {data.GetCell(i).GetNumberOfPoints() for i in range(data.GetNumberOfCells())} == {10}

# Surfaces: a torus of radii 10 and 3 twice, and a shell between spheres of radii 10 and 4.
torus, shell = 2 * 3.14159265 ** 2 * 10 * 9, 4 / 3 * 3.14159265 * (1000 - 64)
for name, right in (("s02_flipped_patch.obj", torus), ("s04_jitter_cracks.stl", torus),
                    ("s09_cavity_same_orientation.obj", shell)):
    source, _ = opened(name)
    found = volume(source)
    assert abs(found - right) < 0.02 * right, (name, found, right)

# A mesh that overlaps itself: its outside has the volume 8, six of its 48 tetrahedra are inverted. Every reader says so, and
# every filter that takes tetrahedra. Variations: another point moved, all cells ordered the other way round, another format.


def words_of(run):
    """The warnings of a function, and its result."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        result = run()
    return " ".join(str(warning.message) for warning in caught), result


def rewritten(path, change):
    lines = open(path).read().splitlines()
    first = lines.index("Tetrahedra") + 2
    return "\n".join(change(i, line, first) for i, line in enumerate(lines)) + "\n"


def farther(i, line, first):
    return line.replace("2.6 1 1", "1 3.5 1") if i < first else line


def reversed_order(i, line, first):
    words = line.split()
    return " ".join([words[1], words[0], *words[2:]]) if i >= first and len(words) == 5 else line


tangled = str(shared_data("reports/n02f_tangled.mesh"))
with tempfile.TemporaryDirectory() as folder:
    files = {tangled: 6}
    for name, change in (("farther.mesh", farther), ("reversed.mesh", reversed_order)):
        files[os.path.join(folder, name)] = 6
        with open(os.path.join(folder, name), "w") as file:
            file.write(rewritten(tangled, change))
    tetgen = os.path.join(folder, "tangled.ele")
    isthmus.tet_gen_mesh_writer(words_of(lambda: isthmus.read(tangled))[1], tetgen)
    files[tetgen] = 6
    for path, inverted in files.items():
        named = f"{inverted} of 48 cells are inverted (cells "
        said, mesh = words_of(lambda: isthmus.read(path))
        assert named in said, (path, said)
        said, quality = words_of(lambda: isthmus.mesh_quality_report(mesh))
        assert named in said, (path, said)
        volumes = vtk_to_numpy(quality.mesh.GetCellData().GetArray("Volume"))
        assert abs(abs(volumes.sum()) - 8.0) < 1e-12 and min((volumes < 0).sum(), (volumes > 0).sum()) == inverted
        for function in (isthmus.cell_incidence, isthmus.tet_cutaway):
            said, _ = words_of(lambda: function(mesh))
            assert named in said, (path, function.__name__, said)
    said, straight = words_of(lambda: isthmus.read(str(shared_data("reports/n02e_ok.mesh"))))
    assert not said, said
    assert not words_of(lambda: isthmus.cell_incidence(straight))[0]

# A map compressed by MRCZ is refused by name, whichever way it is read.
mrcz = str(shared_data("reports/y01e_mrcz_5002.mrcz"))
for read in (isthmus.read, isthmus.mrc_map_reader):
    try:
        read(mrcz)
    except ValueError as error:
        assert "this is an MRCZ file" in str(error) and "compressor=None" in str(error), error
    else:
        raise AssertionError("an MRCZ file was read")
