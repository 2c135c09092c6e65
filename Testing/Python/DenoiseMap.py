"""Denoise Map in ParaView's pipeline: what it chooses, and that its advice helps."""

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from output_window import said

# Named, since ParaView's Python takes the default from the active source, not from Input.
SCALARS = ["POINTS", "RTData"]


def array(proxy):
    proxy.UpdatePipeline()
    return vtk_to_numpy(servermanager.Fetch(proxy).GetPointData().GetArray("RTData")).astype(float)


def number(proxy, name):
    return proxy.FieldData[name].GetRange(0)[0]


source = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
original = array(source)
default = simple.DenoiseMap(Input=source, Scalars=SCALARS)
assert (default.Goal, default.KnownNoise, default.MaskInvalid) == ("Surfaces and curvature", 0, 0)
assert sorted(set(default.ListProperties())) == [
    "Goal", "Input", "KnownNoise", "MaskInvalid", "Scalars", "Strength"], default.ListProperties()

# The wavelet has no noise of its own.
denoised = simple.DenoiseMap(Input=source, Scalars=SCALARS, Goal="Volumes", KnownNoise=10)
smooth = array(denoised)
assert smooth.std() < original.std()
assert abs(smooth.mean() / original.mean() - 1) < 1e-6
field = servermanager.Fetch(denoised).GetFieldData()
assert field.GetArray("RiskValue").GetNumberOfTuples() > 1
assert "estimated gain" in field.GetAbstractArray("Choice").GetValue(0)
stronger = simple.DenoiseMap(Input=source, Scalars=SCALARS, Goal="Volumes", KnownNoise=10, Strength=1)
assert array(stronger).std() < smooth.std()

# A linear choice is the equation: the same by High-Order Diffusion, up to the errors of its steps.
linear = simple.DenoiseMap(Input=source, Scalars=SCALARS, KnownNoise=10)
change = array(linear) - original
assert number(linear, "UsedEdgeStopping") == 0
equation = simple.HighOrderDiffusion(Input=source, Scalars=SCALARS, EdgeStopping="None",
                                     Order=int(number(linear, "UsedOrder")), Time=number(linear, "UsedTime"))
difference = array(equation) - original - change
assert difference.std() < 0.02 * change.std(), difference.std() / change.std()

# The last sentence of the warning about a map without noise, word by word: it smooths.
with said("WarningEvent") as warnings:
    array(default)
assert any("use High-Order Diffusion: set EdgeStopping to None, and set Time" in each for each in warnings), warnings
smooth = array(simple.HighOrderDiffusion(Input=source, Scalars=SCALARS, EdgeStopping="None", Time=1))
assert numpy.abs(smooth - original).std() > 0.01 * original.std()
print("passed")
