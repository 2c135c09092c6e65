"""Trajectories as simulation programs write them: times that are not equally spaced, molecules broken at the periodic
box, virtual sites, two atoms at one place."""

import shutil
import sys
import tempfile
import warnings
from pathlib import Path

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from isthmus_plugin import trajectories  # there once paraview.simple has loaded the plugin
from shared_data import shared_data

warnings.simplefilter("ignore")
try:
    import MDAnalysis
except ImportError:
    print("MDAnalysis is not installed (Debian: python3-mdanalysis)")
    sys.exit(77)


def texts(data, name):
    array = data.GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []


def frame(reader, time):
    reader.UpdatePipeline(time)
    atoms = servermanager.Fetch(reader)
    notes = " ".join(texts(atoms.GetFieldData(), "Notes"))
    return vtk_to_numpy(atoms.GetPoints().GetData()), texts(atoms.GetPointData(), "AtomName"), notes, atoms


def write(path, universe, frames, cells=None, times=None):
    """Frames as a trajectory."""
    with MDAnalysis.Writer(str(path), n_atoms=len(universe.atoms)) as writer:
        for i, places in enumerate(frames):
            universe.atoms.positions = places
            universe.trajectory.ts.dimensions = None if cells is None else cells[i]
            if times is not None:
                universe.trajectory.ts.time = times[i]
            writer.write(universe.atoms)


# Times of the file.
gap = simple.OpenDataFile(str(shared_data("reports/traj/gap/t.xtc")))
assert list(gap.TimestepValues) == [0, 10, 20, 100, 110], list(gap.TimestepValues)

# Atoms in the order of the topology, two of them at one place in the first frame.
folder = shared_data("reports/traj/drude")
there = sorted(file.name for file in folder.iterdir())
reader = simple.OpenDataFile(str(folder / "t.xtc"))
reader.UpdatePipelineInformation()
with tempfile.TemporaryDirectory() as copies:  # MDAnalysis keeps an index beside the file
    for name in ("top.pdb", "t.xtc"):
        shutil.copyfile(folder / name, Path(copies) / name)
    drude = MDAnalysis.Universe(f"{copies}/top.pdb", f"{copies}/t.xtc")
    for step in drude.trajectory:
        places, names, _, atoms = frame(reader, step.time)
        assert names == list(drude.atoms.names), step.frame
        assert abs(places - drude.atoms.positions).max() < 1e-4, step.frame
assert sorted(file.name for file in folder.iterdir()) == there

with tempfile.TemporaryDirectory() as folder:
    folder = Path(folder)
    # Residues whose atoms are apart in the topology, virtual sites, and B factors of the topology.
    topology = folder / "sites.pdb"
    rows = [("OW", "SOL", 1), ("HW1", "SOL", 1), ("CA", "ALA", 2), ("MW", "SOL", 1), ("CB", "ALA", 2), ("MW", "SOL", 3),
            ("OW", "SOL", 3)]
    still = numpy.array([[0, 0, 0], [0.9, 0, 0], [9, 0, 0], [0, 0, 0], [9, 1.5, 0], [20, 0, 0], [20, 0, 0]], dtype=float)
    topology.write_text("".join(
        f"ATOM  {i + 1:5d}  {name:<3s} {residue} A{number:4d}    {x:8.3f}{y:8.3f}{z:8.3f}  1.00{i + 5:6.2f}\n"
        for i, ((name, residue, number), (x, y, z)) in enumerate(zip(rows, still))))
    sites = MDAnalysis.Universe(str(topology))
    moving = [still + 0.3 * n + 0.01 * numpy.arange(len(rows))[:, None] * n for n in range(3)]
    write(folder / "sites.trr", sites, moving, times=[1.5, 7.0, 8.0])
    reader = simple.OpenDataFile(str(folder / "sites.trr"))
    assert list(reader.TimestepValues) == [1.5, 7.0, 8.0], list(reader.TimestepValues)
    for time, wanted in zip((1.5, 7.0, 8.0), moving):
        places, names, _, atoms = frame(reader, time)
        assert names == [name for name, *_ in rows], names
        assert abs(places - wanted).max() < 1e-4
    b = vtk_to_numpy(atoms.GetPointData().GetArray("BFactor"))
    assert list(b) == [5, 6, 7, 8, 9, 10, 11], b
    ends = {tuple(sorted(atoms.GetCell(c).GetPointId(k) for k in range(2)))
            for c in range(atoms.GetNumberOfVerts(), atoms.GetNumberOfCells())}
    assert (0, 1) in ends and (2, 4) in ends, ends

    # The same time twice: frame numbers, with a note.
    write(folder / "same.xtc", sites, moving, times=[0.0, 5.0, 5.0])
    reader = simple.OpenDataFile(str(folder / "same.xtc"))
    reader.Topology = str(topology)
    reader.UpdatePipelineInformation()
    assert list(reader.TimestepValues) == [0, 1, 2], list(reader.TimestepValues)
    assert "do not increase" in frame(reader, 1.0)[2]

    # Two chains in contact, broken at boxes that change; a triclinic one.
    whole = MDAnalysis.Universe(str(shared_data("reports/m01c_whole.gro")))
    still = whole.atoms.positions.astype(float)
    # The corner of the last box lies between the first atoms of the chains.
    moves = [9.0, 18.0, 27.0, -0.5 * (still[0] + still[len(still) // 2])]
    cells = ([36.0, 38.0, 40.0, 90, 90, 90], [35.0, 35.0, 36.0, 90, 90, 90], [40.0, 40.0, 40.0, 60, 60, 90],
             [36.0, 38.0, 40.0, 90, 90, 90])
    wrapped = []
    for move, cell in zip(moves, cells):
        vectors = MDAnalysis.lib.mdamath.triclinic_vectors(cell).astype(float)
        fractions = (still + move) @ numpy.linalg.inv(vectors)
        wrapped.append((fractions - numpy.floor(fractions)) @ vectors)
    chains = MDAnalysis.Universe(str(shared_data("reports/m01c_whole.gro")))
    write(folder / "broken.xtc", chains, wrapped, cells, [0.0, 1.0, 2.0, 3.0])
    reader = simple.OpenDataFile(str(folder / "broken.xtc"))
    reader.Topology = str(shared_data("reports/m01c_whole.gro"))
    reader.UpdatePipelineInformation()
    for time in (0.0, 1.0, 2.0, 3.0):
        places, _, notes, atoms = frame(reader, time)
        assert "made whole by the cell of this frame" in notes, notes
        assert abs((places - places[0]) - (still - still[0])).max() < 0.05, time
        assert notes.count("periodic box") == 1, notes

    # Whole frames stay as they are; without a cell there is one warning.
    write(folder / "whole.xtc", chains, [still, still + 1.0], [cells[0]] * 2, [0.0, 1.0])
    trajectory = trajectories.Trajectory(str(folder / "whole.xtc"), str(shared_data("reports/m01c_whole.gro")))
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    output = vtkPolyData()
    trajectory.fill(1.0, output)
    assert abs(vtk_to_numpy(output.GetPoints().GetData()) - still - 1.0).max() < 0.01
    notes = texts(output.GetFieldData(), "Notes")
    # Not any(): the scripts of programmable sources run here, and import functions of that name.
    assert not [note for note in notes if "periodic" in note], notes
    write(folder / "bare.dcd", chains, [still, *wrapped[:2]])
    trajectory = trajectories.Trajectory(str(folder / "bare.dcd"), str(shared_data("reports/m01c_whole.gro")))
    for index in (0, 1, 2):
        trajectory.fill(trajectory.times[index], output)
    found = [warning for warning in trajectory.warnings if "no cell" in warning]
    assert len(found) == 1 and found[0].startswith("Frame 1 "), trajectory.warnings
