"""Molecular Density in ParaView: lysozyme from its PQR file to a closed surface around all atoms."""

import math
import os
from pathlib import Path

import numpy
from paraview import servermanager
from paraview.simple import (Contour, CreateView, MolecularDensity, OpenDataFile, ResetCamera,
                             SaveScreenshot, Show)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkFeatureEdges

from shared_data import shared_data

OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "MolecularDensity"
OUTPUT.mkdir(parents=True, exist_ok=True)

atoms = OpenDataFile(str(shared_data("molecules/1hew/1hew.pqr")))
density = MolecularDensity(Input=atoms, Spacing=0.5)
assert density.Radii[1] == "Radius", list(density.Radii)
density.UpdatePipeline()
image = servermanager.Fetch(density)
values = vtk_to_numpy(image.GetPointData().GetArray("Density")).reshape(image.GetDimensions()[::-1])
spacing = image.GetSpacing()[0]

# The integral of each Gaussian is known.
points = servermanager.Fetch(atoms, idx=0)
radii = vtk_to_numpy(points.GetPointData().GetArray("Radius"))
positions = vtk_to_numpy(points.GetPoints().GetData())
exact = math.exp(2.3) * (math.pi / 2.3) ** 1.5 * (radii ** 3).sum()
found = values.sum(dtype=float) * spacing ** 3
assert abs(found / exact - 1.0) < 2e-3, (found, exact)  # the border cuts the outermost tails

# Some nodes by brute force, with numpy.
for node in range(0, image.GetNumberOfPoints(), image.GetNumberOfPoints() // 50):
    q = ((positions - image.GetPoint(node)) ** 2).sum(axis=1)[radii > 0] / radii[radii > 0] ** 2
    direct = numpy.exp(-2.3 * (q - 1.0)).sum()
    assert abs(image.GetPointData().GetArray("Density").GetValue(node) - direct) < 1e-4 + 1e-5 * direct

# Contoured at 1: closed, and every atom with a radius is inside of it.
surface = Contour(Input=density, ContourBy=["POINTS", "Density"], Isosurfaces=[1.0])
triangles = servermanager.Fetch(surface)
edges = vtkFeatureEdges()
edges.SetInputData(triangles)
edges.FeatureEdgesOff()
edges.ManifoldEdgesOff()
edges.BoundaryEdgesOn()
edges.NonManifoldEdgesOn()
edges.Update()
assert edges.GetOutput().GetNumberOfCells() == 0 < triangles.GetNumberOfCells()
nearest = numpy.rint((positions - image.GetOrigin()) / spacing).astype(int)
distance = numpy.linalg.norm(nearest * spacing + image.GetOrigin() - positions, axis=1)
inside = distance < radii  # the nearest node lies in the ball
assert inside.sum() > 1000
assert (values[tuple(nearest[inside][:, ::-1].T)] >= 1.0).all()

# The union of balls: 0 and 1, and within the level 1.
density.Form = "Union Of Balls"
density.UpdatePipeline()
balls = vtk_to_numpy(servermanager.Fetch(density).GetPointData().GetArray("Density")).reshape(values.shape)
assert set(numpy.unique(balls)) == {0.0, 1.0}
assert (values[balls == 1.0] > 1.0 - 1e-6).all()

density.Form = "Gaussian Sum"
view = CreateView("RenderView")
view.ViewSize = [700, 700]
Show(surface, view)
ResetCamera(view)
SaveScreenshot(str(OUTPUT / "lysozyme.png"), view)
print(f"{triangles.GetNumberOfCells()} triangles")
