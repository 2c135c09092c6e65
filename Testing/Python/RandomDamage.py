"""Sound data, damaged at random, through every filter that takes them.

Each must end within 10 s and 1 GB without a signal: in a finite result, or in a sentence and an
empty output. Seed and number make the damage, so any case can be had again by itself: the arguments
are how many surfaces and volumes each (default 4, for ctest), the first number, and filters.

    ISTHMUS_SEED=7 pvpython RandomDamage.py 1000
    ISTHMUS_SEED=7 pvpython RandomDamage.py 1 312 MapHandles
"""

import math
import os
import sys
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData

import robustness_trials
from good_data import INPUTS, filters, image, kinds, made, surface

COUNT = int(sys.argv[1]) if len(sys.argv) > 1 else 4
FIRST = int(sys.argv[2]) if len(sys.argv) > 2 else 0
ONLY = sys.argv[3:]
SEED = int(os.environ.get("ISTHMUS_SEED", "1"))
ODD = [0.0, -0.0, 1e-300, 1e-38, 1e-20, 1e-16, 1e-12, 1e12, 1e38, 1e99, 1e150, 1e300, math.inf, math.nan]
# Documented to have NaN where there is nothing to tell.
MAY_BE_NAN = {"Death", "Persistence", "Potential"}
# Documented to be infinite for a cell without area or volume; never NaN.
MAY_BE_INFINITE = {"RadiusEdgeRatio"}


def damaged_surface(random):
    whole = surface()
    points = vtk_to_numpy(whole.GetPoints().GetData()).astype(float)
    corners = numpy.array([[whole.GetCell(i).GetPointId(k) for k in range(3)]
                           for i in range(whole.GetNumberOfCells())])
    way = random.integers(8)
    some = random.integers(len(points), size=random.integers(1, 6))
    if way == 0:
        points[some, random.integers(3)] = random.choice(ODD, size=len(some))
    elif way == 1:
        corners[random.integers(len(corners), size=3), random.integers(3)] = random.integers(
            -1, len(points) + 2)
    elif way == 2:  # holes and doubles
        corners = corners[random.integers(len(corners), size=len(corners))]
    elif way == 3:
        points *= random.choice([1e-90, 1e-40, 1e-20, 1e-6, 1e6, 1e20, 1e40, 1e90])
    elif way == 4:  # flat, or a needle
        points[:, :random.integers(1, 3)] *= random.choice([0.0, 1e-12, 1e-6])
    elif way == 5:
        points += random.normal(scale=random.choice([0.1, 1.0, 5.0]), size=points.shape)
    elif way == 6:
        flipped = random.random(len(corners)) < 0.2
        corners[flipped] = corners[flipped][:, ::-1]
    else:
        points[some] = points[random.integers(len(points), size=len(some))]
    result = vtkPolyData()
    where = vtkPoints()
    where.SetData(numpy_to_vtk(points, deep=True))
    result.SetPoints(where)
    cells = vtkCellArray()
    for corner in corners.tolist():
        cells.InsertNextCell(3, corner)
    result.SetPolys(cells)
    result.GetPointData().ShallowCopy(whole.GetPointData())
    if random.random() < 0.3:
        array = result.GetPointData().GetArray(int(random.integers(7)))
        array.SetComponent(int(random.integers(array.GetNumberOfTuples())), 0,
                           float(random.choice(ODD)) if array.GetDataTypeSize() == 8 else 0)
    sound = bool(numpy.isfinite(points).all() and all(
        numpy.isfinite(vtk_to_numpy(result.GetPointData().GetArray(i))).all()
        for i in range(result.GetPointData().GetNumberOfArrays())))
    return result, sound


def damaged_volume(random):
    result = vtkImageData()
    result.DeepCopy(image())
    values = vtk_to_numpy(result.GetPointData().GetScalars())
    way = random.integers(6)
    some = random.integers(len(values), size=random.integers(1, 20))
    if way == 0:
        values[some] = random.choice(ODD, size=len(some))
    elif way == 1:
        result.SetSpacing(*random.choice([1e-90, 1e-30, 1e-6, 0.0, -1.0, 1.0, 1e6, 1e30, math.nan],
                                         size=3))
    elif way == 2:
        result.SetOrigin(*random.choice([0.0, 1e9, 1e40, -1e99, math.inf], size=3))
    elif way == 3:
        values[:] = random.normal(size=len(values))
    elif way == 4:
        values[:] = values > random.random()
    else:
        values *= random.choice([1e-300, 1e-100, 0.0, 1e100, 1e300])
    sound = bool(numpy.isfinite(values).all() and numpy.isfinite(result.GetSpacing()).all()
                 and numpy.isfinite(result.GetOrigin()).all())
    return result, sound


def trial(name, kind, data, sound):
    proxy = made(name, kind, {INPUTS[name][0][0]: data}, optional=False)
    if len(INPUTS[name]) > 1 and not INPUTS[name][1][2]:
        proxy = made(name, kind, {INPUTS[name][0][0]: data})
    algorithm = proxy.GetClientSideObject()
    listener = robustness_trials.Listener(algorithm)
    proxy.SMProxy.UpdatePipeline()
    outputs = [algorithm.GetOutputDataObject(i) for i in range(algorithm.GetNumberOfOutputPorts())]
    size = sum(robustness_trials.size_of(output) for output in outputs[:1])
    if listener.errors:
        return "refused" if size == 0 else f"an error and {size} elements: {listener.errors[0]}"
    bad = set().union(*(robustness_trials.not_finite(output, MAY_BE_INFINITE)
                        for output in outputs)) - MAY_BE_NAN
    return f"silently not finite: {sorted(bad)}" if sound and bad and not listener.warnings else "ok"


def names_for(kind):
    return [name for name in ONLY or filters()
            if kind in kinds(name) or (kind == "vtkPolyData" and "vtkPointSet" in kinds(name))]


def first_wrong(names, kind, data, sound):
    """The first filter that goes wrong, and how; or 'ok'."""
    for name in names:
        began = time.process_time()
        said = trial(name, kind, data, sound)
        took = time.process_time() - began
        if said not in ("ok", "refused") or took > robustness_trials.SECONDS:
            return f"{name}: {said}, {took:.1f} s"
    return "ok"


def complaints(names, kind, data, sound):
    """What goes wrong, filter by filter. One child tries them all; only where that does not end well,
    each has a child, a clock and a bound of its own."""
    word, said, took = robustness_trials.run(lambda: first_wrong(names, kind, data, sound),
                                             seconds=5 * robustness_trials.SECONDS)
    if (word, said) == ("done", "ok"):
        return []
    wrong = []
    for name in names:
        alone, sentence, took = robustness_trials.run(lambda: trial(name, kind, data, sound))
        if alone != "done" or sentence not in ("ok", "refused"):
            wrong.append(f"{name}: {alone}, {took:.1f} s: {sentence[-400:]}")
    if not wrong and word in ("signal", "failed"):
        wrong.append(f"{' '.join(names)}, only one after the other: {word}: {said[-400:]}")
    return wrong


def main():
    counts, wrong = {"vtkPolyData": 0, "vtkImageData": 0}, []
    runs = 0
    for number in range(FIRST, FIRST + COUNT):
        for kind, damaged in (("vtkPolyData", damaged_surface), ("vtkImageData", damaged_volume)):
            data, sound = damaged(numpy.random.default_rng([SEED, number]))
            names = names_for(kind)
            counts[kind] += 1
            runs += len(names)
            for complaint in complaints(names, kind, data, sound):
                wrong.append(f"seed {SEED}, {kind} {number}, {complaint}")
                print(wrong[-1], flush=True)
    print(f"soak: surfaces {counts['vtkPolyData']} volumes {counts['vtkImageData']} runs {runs}")
    assert not wrong, f"{len(wrong)} of {runs} runs went wrong"


main()
