"""Poisson Boltzmann in ParaView: a PQR file to its coloured surface, energies as the sum of atoms'."""

import os
import shutil
from pathlib import Path

import numpy
from paraview import servermanager
from paraview.simple import (ColorBy, CreateView, GetColorTransferFunction, MolecularDensity,
                             OpenDataFile, PoissonBoltzmann, ResetCamera, SaveScreenshot, Show)
from vtkmodules.util.numpy_support import vtk_to_numpy

from outputs import output_of
from shared_data import shared_data

OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "PoissonBoltzmann"
OUTPUT.mkdir(parents=True, exist_ok=True)


atoms = OpenDataFile(str(shared_data("molecules/1hew/1hew.pqr")))
solver = PoissonBoltzmann(Input=atoms, Spacing=1.0)
assert solver.Charges[:] == ["POINTS", "Charge"] and solver.Radii[:] == ["POINTS", "Radius"], (solver.Charges, solver.Radii)
solver.UpdatePipeline()
image = output_of(solver, 0)
surface = output_of(solver, 1)
parts = output_of(solver, 2)


def number(name):
    return image.GetFieldData().GetArray(name).GetValue(0)


# Lysozyme carries 8 e; its solvation energy from the shared trial, on a surface a little farther out
# (decay 2 there, 2.3 here), is -884 kcal/mol at this spacing.
assert abs(number("NetCharge") - 8.0) < 1e-6
assert -1000.0 < number("SolvationEnergy") < -850.0, number("SolvationEnergy")
assert number("Iterations") <= 12
energies = vtk_to_numpy(parts.GetPointData().GetArray("AtomEnergy"))
assert abs(energies.sum() - number("SolvationEnergy")) < 1e-6

# The surface: closed, finite, with the charge that Gauss' law asks of it.
potential = vtk_to_numpy(surface.GetPointData().GetArray("Potential"))
assert numpy.isfinite(potential).all() and surface.GetNumberOfPolys() > 5000
assert potential.mean() > 0.5, potential.mean()
points = vtk_to_numpy(surface.GetPoints().GetData())
triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
corners = points[triangles]
areas = 0.5 * numpy.linalg.norm(
    numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
density = vtk_to_numpy(surface.GetPointData().GetArray("SurfaceChargeDensity"))
induced = (areas * density[triangles].mean(axis=1)).sum()
assert abs(induced + 8.0 * (1 / 2.0 - 1 / 80.0)) < 0.6, induced  # charges lie nearer to it than nodes

# The same surface as a volume that is passed in gives the same energy.
volume = MolecularDensity(Input=atoms, Radii=["POINTS", "Radius"], Spacing=1.0,
                          Padding=[4.0, 4.0, 4.0])
given = PoissonBoltzmann(Input=atoms, Surface=volume, Level=1.0)
given.UpdatePipeline()
other = output_of(given, 0)
energy = other.GetFieldData().GetArray("SolvationEnergy").GetValue(0)
assert abs(energy / number("SolvationEnergy") - 1.0) < 0.01, (energy, number("SolvationEnergy"))
assert other.GetDimensions() == servermanager.Fetch(volume).GetDimensions()

# One permittivity for each edge instead of the jump: another number, near it.
solver.DielectricModel = "Smooth Dielectric"
solver.UpdatePipeline()
image = output_of(solver, 0)
smooth, sharp = number("SolvationEnergy"), energies.sum()
assert 1e-4 < abs(smooth / sharp - 1.0) < 0.06, (smooth, sharp)
solver.DielectricModel = "Sharp Interface"

# Salt screens.
reach = numpy.abs(vtk_to_numpy(image.GetPointData().GetArray("Potential")))[
    vtk_to_numpy(image.GetPointData().GetArray("Side")) == 0].mean()
solver.IonicStrength = 0.15
solver.UpdatePipeline()
image = output_of(solver, 0)
screened = numpy.abs(vtk_to_numpy(image.GetPointData().GetArray("Potential")))[
    vtk_to_numpy(image.GetPointData().GetArray("Side")) == 0].mean()
assert screened < 0.7 * reach, (screened, reach)

# A file without charges: pdb2pqr finds them where it is installed, and a sentence says so where not.
bare = PoissonBoltzmann(Input=OpenDataFile(str(shared_data("molecules/1hew.pdb"))), Spacing=1.0)
if shutil.which("pdb2pqr"):
    bare.UpdatePipeline()
    found = output_of(bare, 2)
    assert found.GetNumberOfPoints() == parts.GetNumberOfPoints(), found.GetNumberOfPoints()
    net = output_of(bare, 0).GetFieldData().GetArray("NetCharge").GetValue(0)
    assert abs(net - 8.0) < 1e-6, net
    ratio = output_of(bare, 0).GetFieldData().GetArray("SolvationEnergy").GetValue(0) / sharp
    assert abs(ratio - 1.0) < 0.01, ratio
os.environ["PATH"] = str(OUTPUT / "nowhere")
bare.ForceField = "PARSE"
bare.UpdatePipeline()
assert output_of(bare, 0).GetNumberOfPoints() == 0

view = CreateView("RenderView")
view.ViewSize = [700, 700]
shown = Show(servermanager.OutputPort(solver, 1), view)
ColorBy(shown, ("POINTS", "Potential"))
table = GetColorTransferFunction("Potential")
table.RGBPoints = [-5.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 5.0, 0.0, 0.0, 1.0]
ResetCamera(view)
SaveScreenshot(str(OUTPUT / "lysozyme.png"), view)
print(f"{number('SolvationEnergy'):.1f} kcal/mol in salt, induced charge {induced:.2f} e")
