"""Ion Transport in ParaView: a tube of atoms, turned, closed, at several voltages, refused; gramicidin in a membrane, its
potassium, and its currents as streamlines."""

import os
import sys
from pathlib import Path

import isthmus
import numpy
from paraview import servermanager
from paraview.simple import (Clip, ColorBy, Contour, CreateView, GetColorTransferFunction,
                             IonTransportOnSurface, MolecularFlowSurface, PVTrivialProducer, ResetCamera,
                             SaveScreenshot, Show, StreamTracer)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkKdTreePointLocator, vtkPolyData

import robustness_trials
from good_data import channel, channel_surface
from shared_data import shared_data

sys.path.insert(0, os.environ["ISTHMUS_EXAMPLES_DIR"])
from gramicidin import AXIS, with_charges  # noqa: E402

OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "IonTransport"
OUTPUT.mkdir(parents=True, exist_ok=True)


def rows_of(table):
    return {table.GetColumnName(i): vtk_to_numpy(table.GetColumn(i)) for i in range(table.GetNumberOfColumns())}


def number(output, name):
    return output.GetFieldData().GetArray(name).GetValue(0)


def tube_filter(tube, moving=False):
    transport = isthmus.vtkIonTransportMovingSurface() if moving else isthmus.vtkIonTransport()
    transport.SetInputData(tube)
    transport.SetSpacing(0.8)
    transport.SetPadding(5.0)
    transport.SetMembraneThickness(8.0)
    return transport


# The tube: arrays, sections, a curve.
tube = channel()
transport = tube_filter(tube)
transport.Update()
image = transport.GetOutput()
for name in ("Potential", "Concentration_K", "Concentration_Cl", "Flux_K", "Flux_Cl", "CurrentDensity",
             "SignedDistance"):
    values = vtk_to_numpy(image.GetPointData().GetArray(name))
    assert numpy.isfinite(values).all(), name
    assert not name.startswith("Concentration") or values.min() >= 0.0
straight = number(image, "Current")
sections = rows_of(transport.GetSections())
assert numpy.allclose(sections["Current"], straight, rtol=1e-4)
assert numpy.allclose(sections["Current_K"] + sections["Current_Cl"], sections["Current"])
# At several voltages: a curve through the origin.
currents = {100: straight}
for voltage in (-100, 0):
    transport.SetVoltage(voltage)
    transport.Update()
    currents[voltage] = number(transport.GetOutput(), "Current")
print("tube:", currents, "pA")
assert currents[-100] < currents[0] < currents[100] and abs(currents[0]) < 1e-3 * straight
transport.SetVoltage(100)
transport.Update()
assert number(transport.GetOutput(), "Current") == straight
# No current within atoms and membrane.
density = vtk_to_numpy(image.GetPointData().GetArray("CurrentDensity"))
distance = vtk_to_numpy(image.GetPointData().GetArray("SignedDistance"))
assert abs(density[distance < -0.8]).max() == 0.0

# Turned by 30 degrees, the membrane with it.
turned = channel()
points = vtk_to_numpy(turned.GetPoints().GetData())
angle = numpy.pi / 6
matrix = numpy.array([[numpy.cos(angle), 0, numpy.sin(angle)], [0, 1, 0], [-numpy.sin(angle), 0, numpy.cos(angle)]])
turned.GetPoints().SetData(numpy_to_vtk(points @ matrix.T, deep=True))
oblique = tube_filter(turned)
oblique.SetMembraneNormal(numpy.sin(angle), 0.0, numpy.cos(angle))
oblique.Update()
print("turned:", number(oblique.GetOutput(), "Current"), "pA")
assert abs(number(oblique.GetOutput(), "Current") / straight - 1.0) < 0.001


def surface_points(filter_):
    producer = PVTrivialProducer()
    producer.GetClientSideObject().SetOutput(filter_.GetOutput())
    contour = Contour(Input=producer, ContourBy=["POINTS", "SignedDistance"], Isosurfaces=[0.0])
    return vtk_to_numpy(servermanager.Fetch(contour).GetPoints().GetData())


# ParaView's filters show it where it is: the contour of the turned channel, turned back, is that of the straight one.
straight_channel = tube_filter(channel())
straight_channel.Update()
locator = vtkKdTreePointLocator()
surface = vtkPolyData()
surface.SetPoints(vtkPoints())
surface.GetPoints().SetData(numpy_to_vtk(surface_points(straight_channel), deep=True))
locator.SetDataSet(surface)
locator.BuildLocator()
back = surface_points(oblique) @ matrix
inner = back[numpy.linalg.norm(back, axis=1) < 8.0]
nearest = numpy.array([surface.GetPoint(locator.FindClosestPoint(point)) for point in inner])
off = numpy.linalg.norm(inner - nearest, axis=1).max()
print("contour of the turned channel: up to", off, "angstrom from that of the straight one,", len(inner), "points")
assert len(inner) > 500 and off < 0.8  # one spacing: points of the two contours lie differently


def said(change, warning=False, moving=False):
    refused = tube_filter(channel(), moving)
    listener = robustness_trials.Listener(refused)
    change(refused)
    refused.Update()
    sentences = listener.warnings if warning else listener.errors
    assert len(sentences) == 1, sentences
    assert warning or refused.GetOutput().GetNumberOfPoints() == 0
    assert warning or refused.GetSections().GetNumberOfRows() == 0
    return sentences[0]


# Each refusal has its sentence; what does not converge is kept and marked.
closed = said(lambda it: it.SetProbeRadius(4.0))
print(closed)
assert "blocked at (" in closed and "radius of -" in closed
assert "blocked at (" in said(lambda it: it.SetLumenRadius(0.0))
assert "neutral" in said(lambda it: it.AddSpecies(2.0, 0.1, 0.0, 0.79))
assert "called" in said(lambda it: it.SetSpeciesNames("K K"))
assert "no ions" in said(lambda it: it.ClearSpecies())
assert "Voltage" in said(lambda it: it.SetVoltage(numpy.nan))
assert "normal" in said(lambda it: it.SetMembraneNormal(0, 0, 0))
assert "memory" in said(lambda it: (it.SetSpacing(0.002), it.SetPadding(100.0)))
assert "Charge" in said(lambda it: it.GetInput().GetPointData().RemoveArray("Charge"))


def lose_charges(it):  # as the atoms of PDB and mmCIF files have them
    vtk_to_numpy(it.GetInput().GetPointData().GetArray("Charge"))[1:] = numpy.nan


uncharged = said(lose_charges)
print(uncharged)
assert "Apply Force Field Charges" in uncharged and "atom 0" not in uncharged, uncharged


def lose(it):  # a barrier before a well, in hardly any salt
    charges = vtk_to_numpy(it.GetInput().GetPointData().GetArray("Charge"))
    charges[:] = numpy.where(numpy.arange(len(charges)) < len(charges) / 2, 1.0, -1.0)
    it.ClearSpecies()
    it.AddSpecies(3.0, 1e-6, 1e-6, 0.5)
    it.AddSpecies(-1.0, 3e-6, 3e-6, 2.0)


assert "is not conserved along the channel" in said(lose, warning=True)
assert "after 1 iterations" in said(lambda it: it.SetMaximumIterations(1), warning=True)
kept = tube_filter(tube)
kept.SetMaximumIterations(1)
kept.Update()
assert number(kept.GetOutput(), "Converged") == 0.0 and number(kept.GetOutput(), "Current") > 0.0

# A moving surface: it starts from the fixed one, and its table has a row for each update.
moving = tube_filter(tube, moving=True)
moving.Update()
updates = rows_of(moving.GetUpdates())
print("moving:", updates["Current"], "pA, area", updates["AreaChange"])
assert number(moving.GetOutput(), "Converged") == 1.0 and 3 <= len(updates["Update"]) <= 10
assert abs(updates["Current"][0] / straight - 1.0) < 0.03  # another mean of permittivities (PermittivityMean)
assert updates["Time"][0] == updates["AreaChange"][0] == 0.0 and (numpy.diff(updates["Time"]) > 0).all()
assert updates["AreaChange"][-1] < 0.0 and updates["EnergyChange"][-1] < 0.0  # tension closes creases
shown = number(moving.GetOutput(), "Current")
assert numpy.isclose(shown, updates["Current"][int(number(moving.GetOutput(), "ShownUpdate")) - 1], rtol=1e-4)
assert numpy.isclose(updates["Current_K"] + updates["Current_Cl"], updates["Current"]).all()
assert number(moving.GetOutput(), "CurrentSpread") < 1e-4
assert vtk_to_numpy(moving.GetOutput().GetPointData().GetArray("Concentration_Cl")).min() >= 0.0
# It starts from the surface on input 1.
given = tube_filter(tube)
given.SetInputData(1, channel_surface())
given.Update()
wide = number(given.GetOutput(), "Current")
assert abs(number(given.GetOutput(), "BottleneckRadius") - 2.45) < 0.3
given = tube_filter(tube, moving=True)
given.SetInputData(1, channel_surface())
given.Update()
print("on a surface:", wide, "pA, moving from there", rows_of(given.GetUpdates())["Current"])
assert abs(rows_of(given.GetUpdates())["Current"][0] / wide - 1.0) < 0.02


def moved(change, warning=False):
    return said(change, warning, moving=True)


assert "not converged after 2 updates" in moved(lambda it: it.SetMaximumUpdates(2), warning=True)
stopped = tube_filter(tube, moving=True)
stopped.SetMaximumUpdates(2)
stopped.Update()
assert number(stopped.GetOutput(), "Converged") == 0.0
assert "has closed the channel at (" in moved(lambda it: (it.SetPressure(-0.2), it.SetMaximumUpdates(30)))
assert "SurfaceTension" in moved(lambda it: it.SetSurfaceTension(0.0))
assert "UpdatePeriod" in moved(lambda it: it.SetUpdatePeriod(0))
assert "WellDepth" in moved(lambda it: it.GetInput().GetPointData().RemoveArray("WellDepth"))

# Gramicidin on the surface of a little flow, which keeps the pore and closes the creases in its wall; on
# the default surface, the solvent-excluded one, chloride gets in.
reader = isthmus.vtkMacromoleculeReader()
reader.SetFileName(str(shared_data("molecules/channels/1grm_hole_example.pdb")))
reader.Update()
molecule = with_charges(reader.GetOutput())
atoms = PVTrivialProducer(registrationName="gramicidin")
atoms.GetClientSideObject().SetOutput(molecule)
atoms.UpdatePipeline()
bounds = numpy.array(molecule.GetBounds()).reshape(3, 2)
surface = MolecularFlowSurface(Input=atoms, EvolutionTime=0.25, Spacing=0.4)
gramicidin = IonTransportOnSurface(
    Input=atoms, Surface=surface, MembraneNormal=list(AXIS), LumenRadius=4.0,
    Spacing=0.6, Padding=3.0, Species=[1, 0.1, 0.1, 1.96, 1, -1, 0.1, 0.1, 2.03, 1])
assert numpy.allclose(gramicidin.MembraneCenter, bounds.mean(axis=1))  # the panel's, until it is moved
middle = vtk_to_numpy(molecule.GetPoints().GetData()).mean(axis=0)
gramicidin.MembraneCenter = list(middle)
gramicidin.UpdatePipeline()
volume = servermanager.Fetch(gramicidin)
share = number(volume, "Current_K") / number(volume, "Current")
print("gramicidin:", number(volume, "Current"), "pA at 100 mV,", share, "of it potassium")
assert share >= 0.95
assert 0.3 < number(volume, "Current") < 10.0
assert number(volume, "CurrentSpread") < 1e-4 and number(volume, "Converged") == 1.0
default = isthmus.vtkIonTransport()
default.SetInputData(molecule)
default.SetMembraneCenter(*middle)
default.SetMembraneNormal(*AXIS)
default.SetLumenRadius(4.0)
default.SetSpacing(0.6)
default.SetPadding(3.0)
default.Update()
excluded = number(default.GetOutput(), "Current_K") / number(default.GetOutput(), "Current")
print("on the solvent-excluded surface:", number(default.GetOutput(), "Current"), "pA,", excluded)
assert 0.85 < excluded < share  # the README says why
# Its currents as streamlines, between the halves of the surface.
view = CreateView("RenderView")
lines = StreamTracer(Input=gramicidin, Vectors=["POINTS", "CurrentDensity"], SeedType="Point Cloud",
                     MaximumStreamlineLength=120.0)
lines.SeedType.Center = list(middle)
lines.SeedType.Radius = 1.2
lines.SeedType.NumberOfPoints = 60
lines.UpdatePipeline()
assert servermanager.Fetch(lines).GetNumberOfLines() > 10
reach = numpy.ptp(vtk_to_numpy(servermanager.Fetch(lines).GetPoints().GetData())[:, 1])
print("streamlines reach", reach, "angstrom along the pore")
assert reach > 24.0
walls = Contour(Input=gramicidin, ContourBy=["POINTS", "SignedDistance"], Isosurfaces=[0.0])
half = Clip(Input=walls, ClipType="Plane")
half.ClipType.Origin = list(middle)
half.ClipType.Normal = [0, 0, 1]
shown = Show(half, view)
ColorBy(shown, ("POINTS", "Potential"))
colours = GetColorTransferFunction("Potential")
colours.RescaleTransferFunction(-5.0, 5.0)
colours.InvertTransferFunction()  # red is negative
drawn = Show(lines, view)
ColorBy(drawn, None)
drawn.DiffuseColor = drawn.AmbientColor = [0.1, 0.1, 0.1]
drawn.LineWidth = 2.0
view.CameraPosition = [middle[0], middle[1], middle[2] + 90]
view.CameraFocalPoint = list(middle)
view.CameraViewUp = [0, 1, 0]
ResetCamera(view)
SaveScreenshot(str(OUTPUT / "gramicidin.png"), view, ImageResolution=[900, 700])
