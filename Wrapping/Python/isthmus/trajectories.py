"""Trajectories (DCD, XTC, TRR, ...) as molecules with time steps, read by MDAnalysis.

The reader Trajectory Reader of the plugin is a programmable source of ParaView that calls the functions of this
module. Names, radii and bonds come from vtkMacromoleculeReader for the first frame; each time step moves its atoms.
Times are those of the trajectory, in picoseconds.
"""

import os
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


class Trajectory:
    """The frames of a trajectory and its molecule."""

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
            # Some formats have no times, or the same time for all frames: then the frame numbers are used.
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
                f"{self.stamp[0]}: only {atoms.GetNumberOfPoints()} of {len(self.universe.atoms)} atoms could be read: "
                "the topology has atoms without names or coordinates.")
        # The reader groups atoms by residue, so the order of the trajectory has to be restored.
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
            raise ValueError(f"{self.stamp[0]}: frame {frame} has coordinates that are not finite.")
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
    except ValueError as error:
        output.Initialize()
        vtkOutputWindow.GetInstance().DisplayErrorText(f"ERROR: Trajectory Reader: {error}\n")
