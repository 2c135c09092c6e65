"""Run on every rank by ranks.py: seconds of the image filters on this rank's part, to a file."""

import json
import resource
import sys
import time

import isthmus
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController

TURNS = 3
HALO = 2  # nodes, of order 0
EXCHANGES = 20
FILTERS = {"denoise": "vtkHighOrderDiffusion", "high-pass": "vtkDiffusionHighPass",
           "curvature": "vtkHessianCurvature"}


def processor_seconds():
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def filter_times(name, nodes, rank, ranks, controller):
    """Of a default filter whose input is there: seconds of each turn, of the processor, nodes read."""
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(0, nodes - 1, 0, nodes - 1, 0, nodes - 1)
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
            "read": source.GetOutput().GetNumberOfPoints()}


def exchange_seconds(nodes, rank, ranks, controller):
    """One exchange of a face HALO deep with the neighbours on both sides, without its packing."""
    face = vtkFloatArray()
    face.SetNumberOfValues(nodes * nodes * HALO)
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


def main(nodes, path):
    controller = vtkMultiProcessController.GetGlobalController()
    rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
    result = {name: filter_times(name, nodes, rank, ranks, controller) for name in FILTERS}
    result["exchange"] = exchange_seconds(nodes, rank, ranks, controller)
    with open(f"{path}.{rank}.json", "w", encoding="utf-8") as file:
        json.dump(result, file)


main(int(sys.argv[1]), sys.argv[2])
