"""Curvature of this rank's part of a few cases, saved to FOLDER/<case>.<ranks>.<rank>.npz.

Run by `mpirun -np N pvbatch --sym curvature_ranks.py FOLDER`; HessianCurvature.py compares.
"""

import sys
from pathlib import Path

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkParallelCore import vtkMultiProcessController

AUTOMATIC = -1.0  # instead of a scale
ARRAYS = ("GaussianCurvature", "MeanCurvature", "MaximumCurvature", "MinimumCurvature",
          "ShapeIndex", "Curvedness", "SurfaceType", "CurvatureValid")


def save_part(folder, case, filter_proxy):
    controller = vtkMultiProcessController.GetGlobalController()
    part = f"{controller.GetNumberOfProcesses()}.{controller.GetLocalProcessId()}"
    data = filter_proxy.GetClientSideObject().GetOutputDataObject(0)
    positions = [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]
    names = ARRAYS + (("CurvatureScale", "CurvatureError") if filter_proxy.AutomaticScale else ())
    arrays = {name: vtk_to_numpy(data.GetPointData().GetArray(name)) for name in names}
    numpy.savez(folder / f"{case}.{part}.npz",
                positions=numpy.array(positions).reshape(-1, 3), **arrays)


def main(folder):
    wavelet = simple.Wavelet(WholeExtent=[-17, 15, -14, 18, -12, 20])
    field = simple.Calculator(Input=wavelet, Function="RTData", ResultArrayName="Field",
                              ResultArrayType="Double")
    field.UpdatePipeline()
    # A contour lies where its rank's piece of the volume does, the pieces of a sphere do not.
    contour = simple.Contour(Input=field, ContourBy=["POINTS", "Field"], Isosurfaces=[130.0])
    sphere = simple.Sphere(Radius=7.5, Center=[0.2, 0.1, 3.0], ThetaResolution=40)
    surfaces = {"nodes": {}, "contour": {"Surface": contour}, "sphere": {"Surface": sphere}}
    for accuracy in (2, 4):
        for scale in (0.0, 1.2, AUTOMATIC):
            for name, surface in surfaces.items():
                curvature = simple.HessianCurvature(
                    Input=field, Scalars=["POINTS", "Field"], Accuracy=accuracy,
                    AutomaticScale=scale == AUTOMATIC, Scale=max(scale, 0.0), **surface)
                curvature.OutputArrays = ["GaussianCurvature", "MeanCurvature", "MaximumCurvature", "MinimumCurvature",
                                          "ShapeIndex", "Curvedness", "SurfaceType"]
                curvature.UpdatePipeline()
                save_part(folder, f"{name}_{accuracy}_{scale}", curvature)


main(Path(sys.argv[1]))
