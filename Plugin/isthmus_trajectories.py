"""Trajectories (DCD, XTC, TRR, ...) as molecules with time steps, read by MDAnalysis.

The reader Trajectory Reader of the plugin is ParaView's programmable source with the functions of this
module as its scripts. Names, radii and bonds are those that vtkMacromoleculeReader gives for the first
frame; each time step moves its atoms. Times are those of the trajectory, in picoseconds.
"""

import os
import tempfile
import warnings

import numpy

# Files that say which atoms a trajectory moves, in the order in which they are looked for beside it.
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
    """The file of the same name with another ending that names the atoms, else the only one there is."""
    stem = os.path.splitext(trajectory)[0]
    for ending in TOPOLOGIES:
        if os.path.exists(stem + ending):
            return stem + ending
    folder = os.path.dirname(os.path.abspath(trajectory))
    others = [name for name in sorted(os.listdir(folder)) if name.lower().endswith(TOPOLOGIES)]
    if len(others) != 1:
        raise ValueError(
            f"{trajectory}: a trajectory holds places only. Name the file with its atoms as Topology "
            f"({' '.join(TOPOLOGIES)}); beside it there {'are several' if others else 'is none'}.")
    return os.path.join(folder, others[0])


class Trajectory:
    """The frames of a file, and the molecule whose coordinates they hold."""

    def __init__(self, path, topology=""):
        if not path or not os.path.exists(path):
            raise ValueError(f"{path or 'FileName'}: there is no such file.")
        self.stamp = (path, topology, os.path.getmtime(path))
        analysis = _mdanalysis()
        topology = topology or topology_beside(path)
        # MDAnalysis writes an index of the frames beside some trajectories: beside a link in a folder of
        # our own, and not among the user's files.
        self.folder = tempfile.TemporaryDirectory(prefix="isthmus-")
        link = os.path.join(self.folder.name, os.path.basename(path))
        os.symlink(os.path.abspath(path), link)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            try:
                self.universe = analysis.Universe(topology, link)
            except Exception as error:
                said = " ".join(str(error).split())
                raise ValueError(f"{path} with {topology}: MDAnalysis can't read them ({said}).") from error
            if not len(self.universe.trajectory):
                raise ValueError(f"{path}: there is no frame in it.")
            frames = self.universe.trajectory
            # Some formats have no times, or the same for all: then frames are counted.
            first, step = float(frames[0].time), float(getattr(frames, "dt", 1.0))
            self.times = [first + i * step for i in range(len(frames))]
            if not step > 0.0:
                self.times = [float(i) for i in range(len(frames))]
            frames[0]
            self.molecule = self._first_frame()

    def _first_frame(self):
        import isthmus

        handle, name = tempfile.mkstemp(suffix=".pdb")
        os.close(handle)
        try:
            self.universe.atoms.write(name)
            reader = isthmus.vtkMacromoleculeReader()
            reader.SetFileName(name)
            reader.SetAltLoc("*")
            reader.ModelsAsTimeStepsOff()
            reader.Update()
        finally:
            os.remove(name)
        atoms = reader.GetOutput()
        if atoms.GetNumberOfPoints() != len(self.universe.atoms):
            raise ValueError(
                f"{self.stamp[0]}: {len(self.universe.atoms)} atoms move, but {atoms.GetNumberOfPoints()} "
                "were understood: the topology has atoms without names or places.")
        # The reader brings the atoms of a residue together: back to the order of the trajectory.
        from scipy.spatial import cKDTree
        from vtkmodules.util.numpy_support import vtk_to_numpy

        places = vtk_to_numpy(atoms.GetPoints().GetData())
        distance, self.order = cKDTree(self.universe.atoms.positions).query(places)
        if len(set(self.order)) != len(self.order) or distance.max() > 0.01:
            self.order = numpy.arange(len(self.order))
        return atoms

    def fill(self, time, output):
        """The molecule at the frame whose time is nearest."""
        from vtkmodules.util.numpy_support import numpy_to_vtk
        from vtkmodules.vtkCommonCore import vtkPoints

        frame = int(numpy.argmin(numpy.abs(numpy.asarray(self.times) - time)))
        self.universe.trajectory[frame]
        places = numpy.array(self.universe.atoms.positions, dtype=float)[self.order]
        if not numpy.isfinite(places).all():
            raise ValueError(f"{self.stamp[0]}: frame {frame} has places that are no finite numbers.")
        points = vtkPoints()
        points.SetData(numpy_to_vtk(numpy.ascontiguousarray(places), deep=1))
        output.ShallowCopy(self.molecule)
        output.SetPoints(points)
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
        return  # RequestData says it
    for time in times:
        information.Append(Pipeline.TIME_STEPS(), time)
    information.Append(Pipeline.TIME_RANGE(), times[0])
    information.Append(Pipeline.TIME_RANGE(), times[-1])


def request_data(algorithm, path, topology, output):
    """Script of RequestData: the atoms at the time that is asked for."""
    from vtkmodules.vtkCommonCore import vtkOutputWindow
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

    information = algorithm.GetExecutive().GetOutputInformation(0)
    try:
        trajectory = _of(algorithm, path, topology)
        asked = information.Has(Pipeline.UPDATE_TIME_STEP())
        trajectory.fill(
            information.Get(Pipeline.UPDATE_TIME_STEP()) if asked else trajectory.times[0], output)
    except ValueError as error:
        output.Initialize()
        vtkOutputWindow.GetInstance().DisplayErrorText(f"ERROR: Trajectory Reader: {error}\n")
