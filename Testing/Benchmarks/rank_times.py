"""Run on every rank by ranks.py: seconds and memory of the image filters on this rank's part, to a file.

Usage: rank_times.py NODES NODES NODES STEM    the nodes of the whole map along each axis
"""

import atexit
import ctypes
import json
import resource
import sys
import time
from pathlib import Path

import isthmus
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkParallelCore import vtkMultiProcessController
from vtkmodules.vtkParallelMPI import vtkMPIController

TURNS = 3
HALO = 2  # nodes, of order 0
EXCHANGES = 20
NOISE = 0.3  # beside waves of height 1: without noise the default denoising does next to nothing
FILTERS = {"denoise": "vtkDenoiseMap", "high-pass": "vtkDiffusionHighPass",
           "curvature": "vtkHessianCurvature"}


class NoisyWaves(VTKPythonAlgorithmBase):
    """Any part of a map of waves and white noise, the same on however many ranks."""

    def __init__(self, nodes):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkImageData")
        self.nodes = nodes

    def RequestInformation(self, _request, _inputs, outputs):
        information = outputs.GetInformationObject(0)
        whole = [bound for count in self.nodes for bound in (0, count - 1)]
        information.Set(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT(), whole, 6)
        information.Set(vtkAlgorithm.CAN_PRODUCE_SUB_EXTENT(), 1)
        vtkDataObject.SetPointDataActiveScalarInfo(information, VTK_FLOAT, 1)
        return 1

    def RequestData(self, _request, _inputs, outputs):
        information = outputs.GetInformationObject(0)
        extent = [0] * 6
        information.Get(vtkStreamingDemandDrivenPipeline.UPDATE_EXTENT(), extent)
        i, j, k = (numpy.arange(extent[2 * axis], extent[2 * axis + 1] + 1) for axis in range(3))
        values = numpy.empty((len(k), len(j), len(i)), dtype=numpy.float32)
        plane = numpy.sin(j / 9.0)[:, None] * numpy.sin(i / 7.0)
        for number, z in enumerate(k):
            noise = numpy.random.default_rng(int(z)).standard_normal(self.nodes[1::-1], dtype=numpy.float32)
            values[number] = numpy.cos(z / 8.0) * plane + NOISE * noise[j[0]:j[-1] + 1, i[0]:i[-1] + 1]
        image = vtkImageData.GetData(information)
        image.SetExtent(extent)
        scalars = numpy_to_vtk(values.reshape(-1), deep=False)
        scalars.SetName("density")
        image.GetPointData().SetScalars(scalars)
        return 1


def processor_seconds():
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def restart_peak():
    """The kernel forgets how much memory this process has had at most."""
    Path("/proc/self/clear_refs").write_text("5", encoding="ascii")


def peak_bytes():
    """Resident memory of this process at most, since restart_peak."""
    for row in Path("/proc/self/status").read_text(encoding="ascii").splitlines():
        if row.startswith("VmHWM:"):
            return 1024 * int(row.split()[1])
    raise RuntimeError("/proc/self/status names no VmHWM")


def filter_times(name, nodes, rank, ranks, controller):
    """Of a default filter whose input is there: seconds of each turn, of the processor, nodes read, memory."""
    restart_peak()
    source = NoisyWaves(nodes)
    algorithm = getattr(isthmus, FILTERS[name])()
    if name == "curvature":
        algorithm.AutomaticScaleOff()
    algorithm.SetInputConnection(source.GetOutputPort())
    algorithm.UpdatePiece(rank, ranks, 0)
    walls, processors = [], []
    for _ in range(TURNS):
        algorithm.Modified()
        controller.Barrier()
        start, used = time.monotonic(), processor_seconds()
        algorithm.UpdatePiece(rank, ranks, 0)
        controller.Barrier()
        walls.append(time.monotonic() - start)
        processors.append(processor_seconds() - used)
    return {"walls": walls, "processors": processors, "own": algorithm.GetOutput().GetNumberOfPoints(),
            "read": source.GetOutputDataObject(0).GetNumberOfPoints(), "peak": peak_bytes()}


def exchange_seconds(nodes, rank, ranks, controller):
    """One exchange of a face HALO deep with the neighbours on both sides, without its packing."""
    face = vtkFloatArray()
    face.SetNumberOfValues(nodes[0] * nodes[1] * HALO)
    face.Fill(1.0)
    into = vtkFloatArray()
    controller.Barrier()
    start = time.monotonic()
    for _ in range(EXCHANGES):
        for neighbour in (rank - 1, rank + 1):
            if not 0 <= neighbour < ranks:
                continue
            for turn in (0, 1):
                if (rank < neighbour) == (turn == 0):
                    controller.Send(face, neighbour, 7)
                else:
                    controller.Receive(into, neighbour, 7)
    controller.Barrier()
    return (time.monotonic() - start) / EXCHANGES


def global_controller():
    """That of pvbatch; under Python alone, one of our own, which ends with the program."""
    controller = vtkMultiProcessController.GetGlobalController()
    if controller is None:
        ctypes.CDLL("libmpi.so.40", mode=ctypes.RTLD_GLOBAL).MPI_Init(None, None)
        controller = vtkMPIController()
        controller.Initialize()
        vtkMultiProcessController.SetGlobalController(controller)
        atexit.register(controller.Finalize)
    return controller


def main(nodes, path):
    controller = global_controller()
    rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
    result = {name: filter_times(name, nodes, rank, ranks, controller) for name in FILTERS}
    result["exchange"] = exchange_seconds(nodes, rank, ranks, controller)
    with open(f"{path}.{rank}.json", "w", encoding="utf-8") as file:
        json.dump(result, file)


main([int(count) for count in sys.argv[1:4]], sys.argv[4])
