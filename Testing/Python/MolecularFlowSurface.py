"""Molecular Flow Surface in ParaView: a PDB file opened and applied, presets, gramicidin's pore."""

import os
from pathlib import Path

from paraview import servermanager
from paraview.simple import (CreateView, MolecularFlowSurface, OpenDataFile,
                             ResetCamera, SaveScreenshot, Show, SurfaceMeasures)
from vtkmodules.util.numpy_support import vtk_to_numpy

from shared_data import shared_data

OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "MolecularFlowSurface"
OUTPUT.mkdir(parents=True, exist_ok=True)


def measures(surface):
    """Area, volume, genus and components of a surface of the pipeline."""
    filter = SurfaceMeasures(Input=surface)
    filter.UpdatePipeline()
    field = filter.FieldData
    return {name: field[name].GetRange()[0] for name in ("Area", "Volume", "Genus", "Components")}


def measures_at(surface, time):
    """Area at a time of the pipeline."""
    filter = SurfaceMeasures(Input=surface)
    filter.UpdatePipeline(time)
    return filter.FieldData["Area"].GetRange()[0]


# A PDB file as it comes, with all defaults: 1HEW has water, which is left out.
atoms = OpenDataFile(str(shared_data("molecules/1hew.pdb")))
flow = MolecularFlowSurface(Input=atoms)
assert flow.Radii[1] == "Radius", list(flow.Radii)
flow.UpdatePipeline()
surface = servermanager.Fetch(flow)
assert surface.GetNumberOfCells() > 10000, surface.GetNumberOfCells()
assert surface.GetPointData().GetNormals() is not None
notes = surface.GetFieldData().GetAbstractArray("Notes")
assert notes.GetValue(0).startswith("Water was left out: "), notes.GetValue(0)
image = servermanager.Fetch(flow, idx=1)
distance = vtk_to_numpy(image.GetPointData().GetArray("SignedDistance"))
s = vtk_to_numpy(image.GetPointData().GetArray("S"))
assert distance.min() < -2.0 and distance.max() > 2.0
assert s.min() == 0.0 and s.max() == 1.0
shaped = distance.reshape(image.GetDimensions()[::-1])
for axis in range(3):
    assert shaped.take([0, -1], axis=axis).min() > 0.9
history = servermanager.Fetch(flow, idx=2)
assert [history.GetColumnName(i) for i in range(history.GetNumberOfColumns())] == [
    "Time", "Spacing", "Area", "Volume", "Energy"]

view = CreateView("RenderView")
view.ViewSize = [700, 700]
Show(flow, view)
ResetCamera(view)
SaveScreenshot(str(OUTPUT / "lysozyme.png"), view)

# Gramicidin, radii by element: water's probe keeps its pore open, the hull closes it.
gramicidin = OpenDataFile(str(shared_data("molecules/1grm_gramicidin_model1.pdb")))
channel = MolecularFlowSurface(Input=gramicidin, Preset="Channel")
hull = MolecularFlowSurface(Input=gramicidin, Preset="Hull")
excluded = MolecularFlowSurface(Input=gramicidin, Method="Solvent Excluded", ProbeRadius=1.4)
found = {}
for name, surface in (("channel", channel), ("hull", hull), ("excluded", excluded)):
    surface.UpdatePipeline()
    found[name] = measures(surface)
    print(name, found[name])
assert found["channel"]["Genus"] == 1 == found["channel"]["Components"], found
assert found["hull"]["Genus"] == 0, found
# The flow lies within the probe's surface and has no more area than it.
assert found["channel"]["Area"] <= found["excluded"]["Area"], found
assert found["channel"]["Volume"] <= found["excluded"]["Volume"], found

# A smaller probe finds the pore alone, too: the file has no hydrogens, so atoms are united ones. With
# Bondi's radii, two windows open where the hydrogens are missing.
pore = MolecularFlowSurface(Input=gramicidin, ProbeRadius=1.0, Steady=1)
pore.UpdatePipeline()
found = measures(pore)
print("probe 1.0", found)
assert found["Genus"] == 1 == found["Components"], found
notes = servermanager.Fetch(pore).GetFieldData().GetAbstractArray("Notes")
assert any("united atoms" in notes.GetValue(i) for i in range(notes.GetNumberOfValues()))
pore.UnitedAtoms = 0
pore.UpdatePipeline()
found = measures(pore)
print("probe 1.0, Bondi's radii", found)
assert found["Genus"] == 3, found

# Time as the flow's: what a time slider shows.
slow = MolecularFlowSurface(Input=atoms, EvolutionTime=2.0, TimeSteps=4)
slow.UpdatePipelineInformation()
assert list(slow.TimestepValues) == [0.0, 0.5, 1.0, 1.5, 2.0], list(slow.TimestepValues)
areas = []
for time in slow.TimestepValues:
    slow.UpdatePipeline(time)
    areas.append(measures_at(slow, time))
print("areas in time", areas)
assert areas == sorted(areas, reverse=True) and areas[-1] < 0.8 * areas[0], areas
