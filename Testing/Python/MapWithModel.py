"""pipelines.map_with_model, density_around, overlap: beside numpy, on two copies of ubiquitin as two chains."""

import os
from pathlib import Path

import numpy
from paraview import servermanager, simple
from shared_data import shared_data
from vtkmodules.util.numpy_support import vtk_to_numpy

from isthmus_plugin import pipelines  # there once paraview.simple has loaded the plugin
from isthmus_plugin import molecule_views as molecules

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "MapWithModel"
FOLDER.mkdir(parents=True, exist_ok=True)
ATOMS = [line for line in shared_data("molecules/1ubq.pdb").read_text().split("\n") if line.startswith("ATOM")]


def model_at(name, *chains):
    """A molecule whose chains (name, shift along x) are copies of ubiquitin."""
    lines = [f"{line[:21]}{chain}{line[22:30]}{float(line[30:38]) + shift:8.3f}{line[38:]}"
             for chain, shift in chains for line in ATOMS]
    path = FOLDER / f"{name}.pdb"
    path.write_text("\n".join([*lines, "END", ""]))
    return simple.OpenDataFile(str(path))


def points_of(source):
    return vtk_to_numpy(servermanager.Fetch(source).GetPoints().GetData()).astype(float)


def distances(points, others):
    return numpy.linalg.norm(points[:, None] - others[None], axis=2)


def refused(call, words):
    try:
        call()
    except ValueError as error:
        assert words in str(error), error
    else:
        raise AssertionError(f"not refused: {words}")


model = model_at("two", ("A", 0.0), ("B", 32.0))
density = simple.MolecularDensity(model, Spacing=1.5)
cartoon, coloured = pipelines.map_with_model(density, model)
data = servermanager.Fetch(coloured)
chains = vtk_to_numpy(data.GetPointData().GetArray("ChainIndex"))
residues = simple.OutputPort(cartoon, molecules.RESIDUES)
table = servermanager.Fetch(cartoon, idx=molecules.RESIDUES)
of_residue = vtk_to_numpy(table.GetPointData().GetArray("ChainIndex"))
places = vtk_to_numpy(table.GetPoints().GetData())
nearest = distances(points_of(coloured), places)
two = numpy.sort(nearest, axis=1)[:, :2]
clear = two[:, 1] - two[:, 0] > 1e-3
assert set(chains) == {0, 1} and (chains == of_residue[nearest.argmin(axis=1)])[clear].all()
assert data.GetPointData().GetArray("Normals") is not None

# All atoms of the model are inside; of one that is moved by 16 angstrom, some; of one elsewhere, none.
for name, shifts, lowest, highest, verdict in (
        ("two", (0.0, 32.0), 0.99, 1.0, "is fitted"), ("moved", (0.0, 200.0), 0.49, 0.51, "is partly fitted"),
        ("away", (400.0, 600.0), 0.0, 0.0, "is not fitted")):
    share, words = pipelines.overlap(density, model_at(name, *zip("AB", shifts)))
    assert lowest <= share <= highest and verdict in words, (name, share, words)

# The surface around one residue: all that is near, and nothing else.
surface = next(source for source in simple.GetSources().values() if source.SMProxy.GetXMLName() == "MapSurface")
reach = 5.0
atoms, part = pipelines.density_around(density, model, "B:48", reach)
own = points_of(atoms)
expected = numpy.array([[float(line[30:38]) + 32.0, float(line[38:46]), float(line[46:54])] for line in ATOMS
                        if int(line[22:26]) == 48])
assert sorted(map(tuple, own.round(3))) == sorted(map(tuple, expected.round(3))), own
grid = servermanager.Fetch(atoms)
bonds = sum(grid.GetCell(i).GetNumberOfPoints() == 2 for i in range(grid.GetNumberOfCells()))
assert bonds == len(expected) - 1, (bonds, len(expected))
farthest = distances(points_of(part), expected).min(axis=1).max()
assert farthest < reach + 0.2, farthest  # the border is interpolated along edges of up to 2 angstrom
near = (distances(points_of(surface), expected).min(axis=1) <= reach).sum()
kept = (vtk_to_numpy(servermanager.Fetch(part).GetPointData().GetArray("Distance")) < reach - 1e-6).sum()
assert near > 10 and abs(int(near) - int(kept)) <= 1, (near, kept)
refused(lambda: pipelines.density_around(density, model), "no ligand")
refused(lambda: pipelines.density_around(density, model, "A:500"), "no residue A:500")
refused(lambda: pipelines.density_around(density, model_at("far", ("A", 400.0)), "A:48"), "no point within")
refused(lambda: pipelines.map_with_model(model, model), "density map")
# The button: with the map selected, and one molecule open; the surface and the cartoon in the same colours.
for source in list(simple.GetSources().values()):
    simple.Delete(source)
volume = simple.OpenDataFile(str(shared_data("maps/1ake.mrc")))
refused(lambda: pipelines.map_with_model(volume), "no molecules are open")
simple.OpenDataFile(str(shared_data("molecules/pdb1ake.pdb")))
simple.SetActiveSource(volume)
pipelines.run("map_with_model")
view = simple.GetActiveView()
pipelines.first_look(*[display.GetGlobalID() for display in view.Representations])  # as the window does next
shown = [display for display in view.Representations if getattr(display, "Visibility", 0) and
         getattr(display, "ColorArrayName", ["", ""])[1] == "ChainIndex"]
assert len(shown) == 2 and shown[0].LookupTable.SMProxy == shown[1].LookupTable.SMProxy, shown
assert simple.GetActiveSource().SMProxy.GetXMLName() == "PointDatasetInterpolator"
print("chains, densities of residues, and overlap")
