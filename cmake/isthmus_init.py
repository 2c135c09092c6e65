"""Geometry and topology of large, complex shapes: the VTK classes of Isthmus.

>>> import isthmus
>>> reader = isthmus.vtkMRCMapReader()
>>> reader.SetFileName("emd_5043.map")
>>> curvature = isthmus.vtkHessianCurvature()
>>> curvature.SetInputConnection(reader.GetOutputPort())
"""

from .vtkIsthmus import *  # noqa: F401,F403
