"""The installed package and plugin, used as a user would. Usage: check_installed.py PREFIX MAP"""

import sys

import isthmus
from paraview import servermanager, simple

prefix, path = sys.argv[1:3]
assert isthmus.__file__.startswith(prefix), isthmus.__file__

reader = isthmus.vtkMRCMapReader()
reader.SetFileName(path)
reader.Update()
assert reader.GetOutput().GetNumberOfPoints() == 80**3

# PV_PLUGIN_PATH alone has loaded the plugin.
source = simple.OpenDataFile(path)
assert source.GetXMLName() == "DensityMapReader", source.GetXMLName()
curvature = simple.HessianCurvature(Input=source)
arrays = servermanager.Fetch(curvature).GetPointData()
assert arrays.GetArray("MeanCurvature") is not None

# The installed library finds TetGen's program.
grid = servermanager.Fetch(simple.TetrahedralMesher(Input=simple.Sphere()))
assert grid.GetNumberOfCells() > 50
