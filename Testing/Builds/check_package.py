"""Run on the unpacked package: the plugin's filters, its toolbar's pipelines, and the VTK classes."""

from paraview import simple

import isthmus
import isthmus_pipelines

wavelet = simple.Wavelet()
surface, curvature = isthmus_pipelines.map_to_curvature(wavelet)
assert curvature.GetDataInformation().GetNumberOfPoints() > 100
assert isthmus.vtkMapSurface().GetAutomaticLevel()
from isthmus import pipelines  # noqa: E402

assert pipelines.DUST == isthmus_pipelines.DUST
print("the package works")
