"""Run on the unpacked package: the plugin's filters, its toolbar's pipelines, and the VTK classes."""

from paraview import simple

import isthmus
from isthmus_plugin import pipelines

wavelet = simple.Wavelet()
surface, curvature = pipelines.map_to_curvature(wavelet)
assert curvature.GetDataInformation().GetNumberOfPoints() > 100
assert isthmus.vtkMapSurface().GetAutomaticLevel()
# The package and the plugin's copy of its modules are the same.
import isthmus.pipelines  # noqa: E402

assert isthmus.pipelines.DUST == pipelines.DUST
print("the package works")
