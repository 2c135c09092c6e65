"""Trajectories that MDAnalysis writes, read back as molecules with time steps; what is missing is told."""

import sys
import tempfile
import warnings
from pathlib import Path

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from isthmus_plugin import trajectories  # there once paraview.simple has loaded the plugin
from shared_data import shared_data

FRAMES = 6


def sentence_of(*arguments):
    try:
        trajectories.Trajectory(*arguments)
    except ValueError as error:
        return str(error)
    return ""


# Without MDAnalysis there is a sentence.
sys.modules["MDAnalysis"] = None
said = sentence_of(__file__)
assert "python3-mdanalysis" in said, said
del sys.modules["MDAnalysis"]

try:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        import MDAnalysis
except ImportError:
    print("MDAnalysis is not installed (Debian: python3-mdanalysis)")
    sys.exit(77)
warnings.simplefilter("ignore")

with tempfile.TemporaryDirectory() as folder:
    folder = Path(folder)
    assert "no such file" in sentence_of(str(folder / "none.dcd"))
    molecule = MDAnalysis.Universe(str(shared_data("molecules/1ubq.pdb")))
    still = molecule.atoms.positions.copy()
    random = numpy.random.default_rng(3)
    frames = (still + random.normal(0.0, 0.3, (FRAMES, *still.shape))).astype(numpy.float32)
    moving = MDAnalysis.Universe(str(shared_data("molecules/1ubq.pdb")), frames)
    for kind, exact in (("dcd", 1e-4), ("xtc", 0.011), ("trr", 1e-4)):  # XTC rounds to 0.01 angstrom
        path = folder / kind / f"moving.{kind}"
        path.parent.mkdir()
        with MDAnalysis.Writer(str(path), n_atoms=len(still), dt=2.0) as writer:
            for _ in moving.trajectory:
                writer.write(moving.atoms)
        assert "its folder has none of these" in sentence_of(str(path)), sentence_of(str(path))
        molecule.atoms.write(str(path.with_suffix(".pdb")))
        reader = simple.OpenDataFile(str(path))
        assert reader.SMProxy.GetXMLName() == "TrajectoryReader"
        times = list(reader.TimestepValues)
        assert len(times) == FRAMES and numpy.diff(times).min() > 0.0, times
        for frame in (0, 4, 1):
            reader.UpdatePipeline(times[frame])
            atoms = servermanager.Fetch(reader)
            places = vtk_to_numpy(atoms.GetPoints().GetData())
            assert places.shape == still.shape and atoms.GetNumberOfLines() > 500
            names = atoms.GetPointData().GetAbstractArray("AtomName")
            # Atoms in the order of the trajectory or, of one residue, together: each has its own place.
            nearest = numpy.array([abs(frames[frame] - place).sum(axis=1).argmin() for place in places])
            assert sorted(nearest) == list(range(len(still)))
            assert abs(frames[frame][nearest] - places).max() < exact, kind
            assert [names.GetValue(i) for i in range(len(nearest))] == [
                molecule.atoms[i].name for i in nearest]
        # What follows atoms follows these, too.
        pockets = simple.MolecularPockets(Input=reader)
        tracks = simple.FeatureTracks(Input=simple.OutputPort(pockets, 1))
        tracks.UpdatePipeline()
        chart = servermanager.Fetch(tracks, idx=1)
        assert chart.GetNumberOfRows() == FRAMES, chart.GetNumberOfRows()
        # MDAnalysis keeps an index beside some kinds: not among the user's files.
        there = sorted(file.name for file in path.parent.iterdir())
        assert there == sorted(["moving.pdb", path.name]), there
        print(kind, times, chart.GetNumberOfColumns() - 1, "tracks")
    broken = folder / "broken.dcd"
    broken.write_bytes(b"no trajectory")
    said = sentence_of(str(broken), str(shared_data("molecules/1ubq.pdb")))
    assert "cannot read" in said, said
