"""Inputs that hold more than they show, each filter and each of its ports: hidden points and cells
(vtkGhostType), a position that is not finite, images with skewed axes, arrays of bits. The filter refuses them in one message
and has empty outputs; or repairs the surface with a warning, and all positions of the output are
finite; or gives for bits what it gives for the same numbers as bytes. Points that single precision has
moved visibly are warned about or refused. None may take them for something
else without any message.
"""

import re
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkBitArray, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSetAttributes

import robustness_trials
from good_data import INPUTS, filters, made, sound

GHOSTS = {vtkDataObject.POINT: vtkDataSetAttributes.HIDDENPOINT, vtkDataObject.CELL: vtkDataSetAttributes.HIDDENCELL}
# Columns of tables that are positions.
PLACES = ("CenterX", "CenterY", "CenterZ")
# Tables whose rows belong to features by number: their places are not read.
NO_PLACES = {("FeatureTracks", "Lining")}


def copy_of(data):
    result = data.NewInstance()
    result.DeepCopy(data)
    return result


def hidden(data):
    for kind, bit in GHOSTS.items():
        count = data.GetNumberOfElements(kind) if data.GetAttributes(kind) is not None else 0
        if count > 1 and data.IsA("vtkDataSet"):
            result = copy_of(data)
            ghosts = vtkUnsignedCharArray()
            ghosts.SetName(vtkDataSetAttributes.GhostArrayName())
            ghosts.SetNumberOfTuples(count)
            ghosts.Fill(0)
            ghosts.SetValue(count // 2, bit)
            result.GetAttributes(kind).AddArray(ghosts)
            yield f"hidden {'point' if kind == vtkDataObject.POINT else 'cell'}", r"are hidden", result


def nowhere(data):
    """One position with a coordinate that is none."""
    for value in (numpy.nan, numpy.inf):
        result = copy_of(data)
        # From VTK 9.3 on, images make points of their positions, which nobody reads back.
        if not data.IsA("vtkImageData") and hasattr(data, "GetPoints") and hasattr(data.GetPoints(), "SetPoint"):
            points = result.GetPoints()
            at = points.GetNumberOfPoints() // 2
            x, y, _ = points.GetPoint(at)
            points.SetPoint(at, x, y, value)
            yield f"position with {value}", r"finite|coordinate", result
        elif data.IsA("vtkTable") and data.GetColumnByName(PLACES[0]):
            result.GetColumnByName(PLACES[0]).SetTuple1(1, value)
            yield f"position with {value}", r"finite", result


def skewed(data):
    """Axes that are not perpendicular, one that is too long, a matrix of zeros."""
    if data.IsA("vtkImageData"):
        for matrix in ((1, 0.3, 0, 0, 1, 0, 0, 0, 1), (1, 0, 0, 0, 1.2, 0, 0, 0, 1), (0,) * 9):
            result = copy_of(data)
            result.SetDirectionMatrix(matrix)
            yield f"direction {matrix}", "not perpendicular unit vectors", result


def far_away(data):
    """The data so far from the origin that single precision rounds distances between the points."""
    if not data.IsA("vtkImageData") and hasattr(data, "GetPoints") and hasattr(data.GetPoints(), "SetPoint"):
        places = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
        points = vtkPoints()
        points.SetDataTypeToFloat()
        points.SetData(numpy_to_vtk((places + 1e7 * numpy.ptp(places, axis=0).max()).astype(numpy.float32), deep=True))
        result = copy_of(data)
        result.SetPoints(points)
        yield result


def in_bits(data):
    """(name, the data with this array as bits, the same as bytes)"""
    for kind in (vtkDataObject.POINT, vtkDataObject.CELL, vtkDataObject.ROW):
        arrays = data.GetAttributes(kind)
        for i in range(arrays.GetNumberOfArrays() if arrays else 0):
            old = arrays.GetArray(i)
            if not old or old.GetNumberOfComponents() != 1:
                continue
            values = vtk_to_numpy(old).astype(float)
            flags = values > numpy.median(values)
            both = []
            for make in (vtkBitArray, vtkUnsignedCharArray):
                changed = copy_of(data)
                array = make()
                array.SetName(old.GetName())
                array.SetNumberOfValues(len(flags))
                for n, flag in enumerate(flags):
                    array.SetValue(n, int(flag))
                attributes = changed.GetAttributes(kind)
                is_active = attributes.GetScalars() and attributes.GetScalars().GetName() == old.GetName()
                attributes.AddArray(array)
                if is_active:
                    attributes.SetActiveScalars(old.GetName())
                both.append(changed)
            yield old.GetName(), *both


def without(data, name):
    """`data` without the array that was handed on, in bits or bytes."""
    for leaf in robustness_trials.leaves(data):
        for kind in (vtkDataObject.POINT, vtkDataObject.CELL, vtkDataObject.ROW, vtkDataObject.FIELD):
            arrays = leaf.GetAttributesAsFieldData(kind) if hasattr(leaf, "GetAttributesAsFieldData") else None
            if arrays:
                arrays.RemoveArray(name)
    return data


def run(name, port, data, array=None, finite=None):
    """The messages, the sizes of the outputs, and a print of them without `array`."""
    proxy = made(name, replaced={port: data})
    algorithm = proxy.GetClientSideObject()
    listener = robustness_trials.Listener(algorithm)
    proxy.SMProxy.UpdatePipeline()
    outputs = [algorithm.GetOutputDataObject(i) for i in range(algorithm.GetNumberOfOutputPorts())]
    sizes = [robustness_trials.size_of(output) for output in outputs]
    if finite is not None:
        finite["finite"] = not any("points" in robustness_trials.not_finite(output) for output in outputs)
    prints = [robustness_trials.print_of(without(output, array)) for output in outputs] if array else []
    return listener, sizes, prints


def refusal(name, port, what, word, data):
    checks = {}
    listener, sizes, _ = run(name, port, data, finite=checks)
    if not listener.errors and "repair" in " ".join(listener.warnings) and checks["finite"]:
        return []
    if len(listener.errors) != 1 or not re.search(word, listener.errors[0]):
        return [f"{name}, {port}, {what}: {sizes} elements, said {listener.errors} {listener.warnings}"]
    return [f"{name}, {port}, {what}: {sizes} elements beside the error"] if any(sizes) else []


def bits(name, port, array, as_bits, as_bytes):
    listener, sizes, prints = run(name, port, as_bits, array)
    if listener.errors:
        good = len(listener.errors) == 1 and not any(sizes)
        return [] if good else [f"{name}, {port}, bits of {array}: {sizes} elements beside {listener.errors}"]
    wanted = run(name, port, as_bytes, array)
    return [] if prints == wanted[2] else [
        f"{name}, {port}, bits of {array}: {sizes} elements instead of {wanted[1]}, other numbers or places"]


def rounded(name, port, data):
    listener, sizes, _ = run(name, port, data)
    said = " ".join(listener.errors + listener.warnings)
    return [] if "single precision" in said or listener.errors else [f"{name}, {port}, rounded places: {sizes}, said {said}"]


def tried(name):
    complaints, count = [], 0
    for port, accepted, _ in INPUTS[name]:
        for kind in accepted if (name, port) not in NO_PLACES else ():
            try:
                data = sound(name, port, kind)
            except TypeError:  # no example of this type
                continue
            for what, word, changed in (*hidden(data), *nowhere(data), *skewed(data)):
                count += 1
                complaints += refusal(name, port, f"{kind} with {what}", word, changed)
            for changed in far_away(data):
                count += 1
                complaints += rounded(name, port, changed)
            for array, *both in in_bits(data):
                count += 1
                complaints += bits(name, port, array, *both)
    return "\n".join([str(count), *complaints])


wrong, all_trials = [], 0
for filter_name in filters():
    word, said, _ = robustness_trials.run(lambda: tried(filter_name), seconds=120)
    if word != "done":
        wrong.append(f"{filter_name}: {word}, {said[-600:]}")
        continue
    lines = said.split("\n")
    all_trials += int(lines[0])
    wrong += lines[1:]
print(*wrong, f"{all_trials} trials of {len(filters())} filters", sep="\n")
assert all_trials > 5 * len(filters())
sys.exit(1 if wrong else 0)
