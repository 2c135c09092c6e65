"""Run on every rank by HighOrderDiffusion.py: each rank's part of the results, saved as .npz."""

import sys

import isthmus
import numpy
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController


def filters():
    """Name, filter and its result arrays, for everything that exchanges halos in its own way."""
    for order, stopping in ((0, 1), (1, 1), (2, 2), (3, 0)):
        diffusion = isthmus.vtkHighOrderDiffusion()
        diffusion.SetOrder(order)
        diffusion.SetEdgeStopping(stopping)
        diffusion.SetWindow(9)
        diffusion.SetTime(0.5)
        yield f"diffusion{order}", diffusion, ["RTData"]
    for goal in (0, 1):
        chosen = isthmus.vtkDenoiseMap()
        chosen.SetGoal(goal)
        chosen.SetKnownNoise(12.0)  # the image has no noise of its own
        yield f"chosen{goal}", chosen, ["RTData"]
    geometric = isthmus.vtkHighOrderDiffusion()
    geometric.SetFlow(1)
    geometric.SetOrder(1)
    geometric.SetFidelity(0.5)
    geometric.SetTime(0.5)
    yield "geometric", geometric, ["RTData"]
    yield "highpass", isthmus.vtkDiffusionHighPass(), ["HighPass"]
    transform = isthmus.vtkPDETransform()
    transform.SetNumberOfModes(2)
    yield "transform", transform, ["Mode1", "Residue"]


def main(output):
    controller = vtkMultiProcessController.GetGlobalController()
    rank = controller.GetLocalProcessId() if controller else 0
    ranks = controller.GetNumberOfProcesses() if controller else 1
    results = {}
    # The small image has too few cells for four ranks: some of them have nothing.
    for size, whole in (("", (-9, 10, -8, 9, -7, 12)), ("small", (0, 2, 0, 1, 0, 1))):
        source = vtkRTAnalyticSource()
        source.SetWholeExtent(*whole)
        for name, algorithm, arrays in filters():
            algorithm.SetInputConnection(source.GetOutputPort())
            algorithm.UpdatePiece(rank, ranks, 1)
            image = algorithm.GetOutput()
            data = dataset_adapter.WrapDataObject(image).PointData
            if image.GetNumberOfPoints() == 0:
                print(f"rank {rank} of {ranks} has no nodes of the {size} image", flush=True)
                continue
            for array in arrays:
                results[f"{size}{name}.{array}"] = numpy.array(data[array])
            results[f"{size}{name}.extent"] = numpy.array(image.GetExtent())
            results[f"{size}{name}.whole"] = numpy.array(whole)
    numpy.savez(f"{output}.{rank}.npz", **results)


main(sys.argv[1])
