"""Solvation Surface in ParaView: lysozyme's charges and surface in turn, from a PQR file with defaults;
beside Poisson Boltzmann on the surface that it ends with, and the potential on the probe's surface."""

import os
from pathlib import Path

import isthmus
import numpy
from paraview import servermanager
from paraview.simple import (AssignViewToLayout, ColorBy, CreateLayout, CreateView,
                             GetColorTransferFunction, MolecularFlowSurface, OpenDataFile,
                             PoissonBoltzmannOnSurface, ResetCamera, SaveScreenshot, Show,
                             SolvationSurface)
from vtkmodules.util.numpy_support import vtk_to_numpy

from shared_data import shared_data

OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "SolvationSurface"
OUTPUT.mkdir(parents=True, exist_ok=True)
SPACING = 0.7

atoms = OpenDataFile(str(shared_data("molecules/1hew/1hew.pqr")))
solvation = SolvationSurface(Input=atoms, Spacing=SPACING)
assert solvation.Charges[:] == ["POINTS", "Charge"] and solvation.Radii[:] == ["POINTS", "Radius"]
solvation.UpdatePipeline()
surface = servermanager.Fetch(solvation)
image = servermanager.Fetch(solvation, idx=1)
updates = servermanager.Fetch(solvation, idx=2)
columns = [updates.GetColumnName(i) for i in range(updates.GetNumberOfColumns())]
rows = numpy.array([[updates.GetValue(row, i).ToDouble() for i in range(len(columns))]
                    for row in range(updates.GetNumberOfRows())])
column = dict(zip(columns, rows.T))
for name, values in column.items():
    print(f"{name:17}", " ".join(f"{value:.3f}" for value in values))
assert surface.GetFieldData().GetArray("Converged").GetValue(0) == 1.0
assert 3 <= len(rows) <= 10
# Parts add up, and the energy falls on the way but for the noise of its discretisation.
parts = column["SurfaceEnergy"] + column["VolumeEnergy"] + column["DispersionEnergy"]
assert numpy.allclose(parts, column["NonpolarEnergy"])
assert numpy.allclose(parts + column["PolarEnergy"], column["TotalEnergy"])
assert (numpy.diff(column["TotalEnergy"]) < 1e-3 * abs(column["TotalEnergy"][-1])).all()
for name in ("Normals", "Potential", "NormalField", "SurfaceChargeDensity"):
    assert numpy.isfinite(vtk_to_numpy(surface.GetPointData().GetArray(name))).all(), name
for name in ("SignedDistance", "S", "Potential", "ReactionPotential", "Side"):
    assert numpy.isfinite(vtk_to_numpy(image.GetPointData().GetArray(name))).all(), name

# The polar energy is that of the Poisson-Boltzmann equation on the surface it ends with.
check = isthmus.vtkPoissonBoltzmann()
check.SetInputData(0, servermanager.Fetch(atoms))
check.SetInputData(1, surface)
check.SetSpacing(SPACING)
check.Update()
alone = check.GetOutput().GetFieldData().GetArray("SolvationEnergy").GetValue(0)
print("polar, by Poisson Boltzmann on the triangles:", alone)
assert abs(alone / column["PolarEnergy"][-1] - 1.0) < 0.03

# Figure 5.3: the potential on the probe's surface and on the one at rest, in the same colours.
excluded = MolecularFlowSurface(Input=atoms, Method="Solvent Excluded", ProbeRadius=1.4, Spacing=SPACING)
beside = PoissonBoltzmannOnSurface(Input=atoms, Surface=excluded, Spacing=SPACING)
layout = CreateLayout("Figure 5.3")
for hint, shown in ((1, servermanager.OutputPort(beside, 1)), (2, solvation)):
    view = CreateView("RenderView")
    if hint == 1:
        layout.SplitHorizontal(0, 0.5)
    AssignViewToLayout(view, layout, hint)
    display = Show(shown, view)
    ColorBy(display, ("POINTS", "Potential"))
    GetColorTransferFunction("Potential").RescaleTransferFunction(-5.0, 5.0)
    ResetCamera(view)
SaveScreenshot(str(OUTPUT / "potential.png"), layout, ImageResolution=[1200, 600])
