"""Trajectories (DCD, XTC, TRR, ...) as molecules with time steps, read by MDAnalysis.

The reader Trajectory Reader of the plugin is a programmable source of ParaView that calls the functions of this
module. Names, radii and bonds come from vtkMacromoleculeReader for the first frame; each time step moves its atoms, which are in
the order of the topology. Times are those of the trajectory, in picoseconds. Molecules that are broken at the periodic
box are made whole in each frame by its cell.
"""

import collections
import os
import struct
import tempfile
import warnings

import numpy

# Files that describe the atoms of a trajectory, in the order in which they are searched beside it.
TOPOLOGIES = (".pdb", ".psf", ".gro", ".prmtop", ".parm7", ".top", ".tpr", ".pqr", ".mol2")
MISSING = ("Trajectories are read by MDAnalysis, which is not installed here (Debian: apt install "
           "python3-mdanalysis; else: pip install MDAnalysis).")


def _mdanalysis():
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            import MDAnalysis
    except ImportError as error:
        raise ValueError(MISSING) from error
    return MDAnalysis


def topology_beside(trajectory):
    """The topology file with the name of the trajectory, or else the only topology file in its folder."""
    stem = os.path.splitext(trajectory)[0]
    for ending in TOPOLOGIES:
        if os.path.exists(stem + ending):
            return stem + ending
    folder = os.path.dirname(os.path.abspath(trajectory))
    others = [name for name in sorted(os.listdir(folder)) if name.lower().endswith(TOPOLOGIES)]
    if len(others) != 1:
        raise ValueError(
            f"{trajectory}: a trajectory contains only coordinates. Set Topology to the file with its atoms "
            f"({' '.join(TOPOLOGIES)}); its folder has {'several' if others else 'none'} of these.")
    return os.path.join(folder, others[0])


def _times(frames, path):
    """The times of all frames as the file has them, ps; for XTC without unpacking coordinates."""
    offsets = getattr(getattr(frames, "_xdr", None), "offsets", None)
    if path.lower().endswith(".xtc") and offsets is not None and len(offsets) == len(frames):
        times = []
        with open(path, "rb") as file:
            for offset in offsets:
                file.seek(int(offset))
                magic, _, _, time = struct.unpack(">iiif", file.read(16))
                if magic not in (1995, 2023):
                    break
                times.append(float(time))
        if len(times) == len(frames):
            return times
    return [float(frame.time) for frame in frames]


class _Bonds:
    """Trees of bonds through all molecules, along which they are made whole in each frame."""

    def __init__(self, first, second, places, residues, names):
        """`first` and `second`: the atoms of each bond; `places` in the first frame, whole."""
        from scipy.sparse import coo_matrix
        from scipy.sparse.csgraph import connected_components

        count = len(places)
        self.ends = (first, second)
        graph = coo_matrix((numpy.ones(len(first)), (first, second)), (count, count)).tocsr()
        _, self.label = connected_components(graph, directed=False)
        graph = (graph + graph.T).tocsr()
        _, frontier = numpy.unique(self.label, return_index=True)
        seen = numpy.zeros(count, dtype=bool)
        seen[frontier] = True
        self.levels = []
        while len(frontier):
            counts = graph.indptr[frontier + 1] - graph.indptr[frontier]
            parents = numpy.repeat(frontier, counts)
            starts = numpy.repeat(graph.indptr[frontier] - numpy.cumsum(counts) + counts, counts)
            children = graph.indices[starts + numpy.arange(len(parents))]
            new = ~seen[children]
            children, at = numpy.unique(children[new], return_index=True)
            seen[children] = True
            if len(children):
                self.levels.append((children, parents[new][at]))
            frontier = children
        self.anchors = self._contacts(places, residues, names)

    def _contacts(self, places, residues, names):
        """Molecules that touch a chain in the first frame, with an atom of each, in the order in which they are
        moved: chains from the largest one on, then molecules of which there are at most 50."""
        from scipy.spatial import cKDTree

        order = numpy.argsort(self.label, kind="stable")
        members = numpy.split(order, numpy.flatnonzero(numpy.diff(self.label[order])) + 1)
        chains = [atoms for atoms in members if len(atoms) > 2 and len(numpy.unique(residues[atoms])) > 2]
        chains.sort(key=len, reverse=True)
        few = collections.Counter(names[atoms[0]] for atoms in members)
        others = [atoms for atoms in members if len(numpy.unique(residues[atoms])) < 3 and few[names[atoms[0]]] <= 50]
        anchors, placed = [], None
        for number, atoms in enumerate(chains + others if chains else []):
            if placed is not None:
                distance, nearest = cKDTree(places[placed]).query(places[atoms])
                best = distance.argmin()
                if distance[best] < 5.0:
                    anchors.append((atoms, atoms[best], placed[nearest[best]]))
            if number < len(chains):
                placed = atoms if placed is None else numpy.concatenate((placed, atoms))
        return anchors

    def longest(self, places):
        """The length of the longest bond."""
        first, second = self.ends
        return numpy.linalg.norm(places[first] - places[second], axis=1).max(initial=0.0)

    def make_whole(self, places, cell):
        """Whether any molecule was broken; then its atoms are moved by whole cells."""
        inverse = numpy.linalg.inv(cell)
        shifts = numpy.zeros(places.shape)
        for children, parents in self.levels:
            steps = -numpy.rint((places[children] - places[parents]) @ inverse)
            shifts[children] = shifts[parents] + steps
        if not shifts.any():
            return False
        places += shifts @ cell
        for atoms, own, other in self.anchors:
            places[atoms] -= numpy.rint((places[own] - places[other]) @ inverse) @ cell
        return True


def _texts(data, name):
    array = data.GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []


def _set_texts(data, name, texts):
    from vtkmodules.vtkCommonCore import vtkStringArray

    array = vtkStringArray()
    array.SetName(name)
    for text in texts:
        array.InsertNextValue(text)
    data.AddArray(array)


class Trajectory:
    """The frames of a trajectory and its molecule, whose atoms are in the order of the topology."""

    def __init__(self, path, topology=""):
        if not path or not os.path.exists(path):
            raise ValueError(f"{path or 'FileName'}: there is no such file.")
        self.stamp = (path, topology, os.path.getmtime(path))
        analysis = _mdanalysis()
        topology = topology or topology_beside(path)
        # MDAnalysis writes an index of the frames beside some trajectories: a link in a temporary folder keeps it
        # out of the user's folder.
        self.folder = tempfile.TemporaryDirectory(prefix="isthmus-")
        link = os.path.join(self.folder.name, os.path.basename(path))
        os.symlink(os.path.abspath(path), link)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            try:
                self.universe = analysis.Universe(topology, link)
            except Exception as error:
                said = " ".join(str(error).split())
                raise ValueError(f"{path} with {topology}: MDAnalysis cannot read them ({said}).") from error
            if not len(self.universe.trajectory):
                raise ValueError(f"{path}: the file has no frames.")
            frames = self.universe.trajectory
            self.notes = []
            self.torn = False
            self.times = _times(frames, link)
            # Some formats have no times, and some files the same time twice: time steps must differ.
            if not (numpy.diff(self.times) > 0.0).all():
                self.times = [float(i) for i in range(len(frames))]
                self.notes.append("The times of the frames do not increase, so the time steps are the numbers of the "
                                  "frames, from 0.")
            frames[0]
            self.molecule = self._first_frame()
            self.bonds = self._find_bonds()

    def _first_frame(self):
        """The molecule of the first frame, its atoms in the order of the topology."""
        import isthmus

        atoms = self.universe.atoms
        count = len(atoms)
        # The reader groups atoms by residue, and two atoms may be at one place: occupancy and B factor carry the
        # number of each atom through the file.
        kept = {name: getattr(atoms, name).copy() if hasattr(atoms, name) else None
                for name in ("occupancies", "tempfactors")}
        numbers = {"occupancies": numpy.arange(count) // 100000, "tempfactors": numpy.arange(count) % 100000 / 100.0}
        handle, name = tempfile.mkstemp(suffix=".pdb")
        os.close(handle)
        warned = []
        try:
            for attribute, values in numbers.items():
                self.universe.add_TopologyAttr(attribute, values.astype(float))
            atoms.write(name)
            reader = isthmus.vtkMacromoleculeReader()
            reader.SetFileName(name)
            reader.SetAltLoc("*")
            reader.ModelsAsTimeStepsOff()
            reader.AddObserver("WarningEvent", lambda *_: warned.append(1))  # they are in the field data
            reader.Update()
        finally:
            os.remove(name)
        read = reader.GetOutput()
        if read.GetNumberOfPoints() != count:
            raise ValueError(
                f"{self.stamp[0]}: only {read.GetNumberOfPoints()} of {count} atoms could be read: "
                "the topology has atoms without names or coordinates.")
        self.warnings = _texts(read.GetFieldData(), "Warnings")
        return self._in_order(read, kept)

    def _in_order(self, read, kept):
        """`read` with its atoms in the order of the topology, and `kept` instead of their numbers."""
        from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
        from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

        data, count = read.GetPointData(), read.GetNumberOfPoints()
        number = (numpy.rint(vtk_to_numpy(data.GetArray("Occupancy"))) * 100000 +
                  numpy.rint(vtk_to_numpy(data.GetArray("BFactor")) * 100)).astype(numpy.int64)
        if not numpy.array_equal(numpy.sort(number), numpy.arange(count)):
            raise ValueError(f"{self.stamp[0]}: the atoms of the topology could not be distinguished.")
        place = numpy.argsort(number)  # in what was read, of each atom of the topology
        molecule = vtkPolyData()
        points = vtkPoints()
        points.SetData(numpy_to_vtk(numpy.ascontiguousarray(vtk_to_numpy(read.GetPoints().GetData())[place]), deep=1))
        molecule.SetPoints(points)
        ids = vtkIdList()
        ids.SetNumberOfIds(count)
        for i, at in enumerate(place):
            ids.SetId(i, int(at))
        for index in range(data.GetNumberOfArrays()):
            array = data.GetAbstractArray(index)
            moved = array.NewInstance()
            moved.SetName(array.GetName())
            moved.SetNumberOfComponents(array.GetNumberOfComponents())
            moved.SetNumberOfTuples(count)
            array.GetTuples(ids, moved)
            molecule.GetPointData().AddArray(moved)
        for name, attribute in (("Occupancy", "occupancies"), ("BFactor", "tempfactors")):
            values = kept[attribute] if kept[attribute] is not None else numpy.full(count, numpy.nan)
            array = numpy_to_vtk(numpy.array(values, dtype=float), deep=1)
            array.SetName(name)
            molecule.GetPointData().AddArray(array)
        molecule.SetVerts(read.GetVerts())
        ends = vtk_to_numpy(read.GetLines().GetConnectivityArray())
        lines = vtkCellArray()
        lines.SetData(numpy_to_vtkIdTypeArray(numpy.arange(0, len(ends) + 1, 2, dtype=numpy.int64), deep=1),
                      numpy_to_vtkIdTypeArray(numpy.ascontiguousarray(number[ends]), deep=1))
        molecule.SetLines(lines)
        molecule.GetCellData().ShallowCopy(read.GetCellData())
        molecule.GetFieldData().ShallowCopy(read.GetFieldData())
        notes = [note for note in _texts(read.GetFieldData(), "Notes") if not note.startswith("Molecules broken")]
        self.notes = notes + self.notes
        return molecule

    def _find_bonds(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy

        ends = vtk_to_numpy(self.molecule.GetLines().GetConnectivityArray())
        places = vtk_to_numpy(self.molecule.GetPoints().GetData())
        atoms = self.universe.atoms
        return _Bonds(ends[::2], ends[1::2], places, atoms.resindices, _texts(
            self.molecule.GetPointData(), "ResidueName"))

    def fill(self, time, output):
        """The molecule at the frame whose time is nearest."""
        from vtkmodules.util.numpy_support import numpy_to_vtk
        from vtkmodules.vtkCommonCore import vtkPoints

        frame = int(numpy.argmin(numpy.abs(numpy.asarray(self.times) - time)))
        step = self.universe.trajectory[frame]
        places = numpy.array(self.universe.atoms.positions, dtype=float)
        if not numpy.isfinite(places).all():
            raise ValueError(f"{self.stamp[0]}: frame {frame} has coordinates that are not finite.")
        notes = list(self.notes)
        cell = step.triclinic_dimensions if step.dimensions is not None else None
        if cell is not None and numpy.isfinite(cell).all() and abs(numpy.linalg.det(cell)) > 27.0:
            if self.bonds.make_whole(places, numpy.array(cell, dtype=float)):
                notes.append("Molecules broken at the periodic box were made whole by the cell of this frame.")
        elif (longest := self.bonds.longest(places)) > 10.0 and not self.torn:
            self.torn = True  # one warning for all frames
            self.warnings.append(
                f"Frame {frame} has a bond of {longest:.0f} angstrom: molecules are broken at a periodic box, and the "
                "frame has no cell by which they could be joined. Write whole molecules, e.g. by 'gmx trjconv -pbc "
                "whole'.")
        points = vtkPoints()
        points.SetData(numpy_to_vtk(numpy.ascontiguousarray(places), deep=1))
        output.ShallowCopy(self.molecule)
        output.SetPoints(points)
        output.GetFieldData().ShallowCopy(self.molecule.GetFieldData())
        _set_texts(output.GetFieldData(), "Notes", notes)
        output.GetInformation().Set(output.DATA_TIME_STEP(), self.times[frame])


_open = {}  # the trajectory of each reader


def _of(algorithm, path, topology):
    key = algorithm.__this__ if hasattr(algorithm, "__this__") else id(algorithm)
    known = _open.get(key)
    if known is None or not path or not os.path.exists(path) or (
            known.stamp != (path, topology, os.path.getmtime(path))):
        _open.pop(key, None)
        known = _open[key] = Trajectory(path, topology)
    return known


def request_information(algorithm, path, topology):
    """Script of RequestInformation: reports the times."""
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

    information = algorithm.GetExecutive().GetOutputInformation(0)
    information.Remove(Pipeline.TIME_STEPS())
    information.Remove(Pipeline.TIME_RANGE())
    try:
        times = _of(algorithm, path, topology).times
    except ValueError:
        return  # RequestData reports the error
    for time in times:
        information.Append(Pipeline.TIME_STEPS(), time)
    information.Append(Pipeline.TIME_RANGE(), times[0])
    information.Append(Pipeline.TIME_RANGE(), times[-1])


def request_data(algorithm, path, topology, output):
    """Script of RequestData: outputs the atoms at the requested time."""
    from vtkmodules.vtkCommonCore import vtkOutputWindow
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

    information = algorithm.GetExecutive().GetOutputInformation(0)
    try:
        trajectory = _of(algorithm, path, topology)
        asked = information.Has(Pipeline.UPDATE_TIME_STEP())
        trajectory.fill(
            information.Get(Pipeline.UPDATE_TIME_STEP()) if asked else trajectory.times[0], output)
        if trajectory.warnings:  # once for each file
            vtkOutputWindow.GetInstance().DisplayWarningText(
                f"Warning: Trajectory Reader: {path}: {' '.join(trajectory.warnings)}\n")
            trajectory.warnings = []
    except ValueError as error:
        output.Initialize()
        vtkOutputWindow.GetInstance().DisplayErrorText(f"ERROR: Trajectory Reader: {error}\n")
