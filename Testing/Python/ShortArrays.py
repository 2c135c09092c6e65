"""Arrays that end before the last point, cell or row they are to say something of: each filter, each
array of each of its inputs with half its values and with none, and an array besides that it does not
read. Read beyond their end they were numbers of other arrays, or the end of the program (SIGSEGV in
eight filters of molecules); each must be refused in a sentence that names the array.
"""

import sys

from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkDataObject

import robustness_trials
from good_data import INPUTS, filters, made, sound

KINDS = (vtkDataObject.POINT, vtkDataObject.CELL, vtkDataObject.VERTEX, vtkDataObject.ROW)


def attributes(data):
    """(attributes, how many values each array must have) of what has any elements."""
    for kind in KINDS:
        found, count = data.GetAttributes(kind), data.GetNumberOfElements(kind)
        if found is not None and count > 1:
            yield kind, found, count


def shortened(data, kind, name, count):
    """A copy of `data` whose array `name`, or a new one of that name, has `count` values."""
    result = data.NewInstance()
    result.DeepCopy(data)
    arrays = result.GetAttributes(kind)
    old = arrays.GetAbstractArray(name)
    array = old.NewInstance() if old else vtkDoubleArray()
    array.SetName(name)
    array.SetNumberOfComponents(old.GetNumberOfComponents() if old else 1)
    array.SetNumberOfTuples(count)
    for i in range(count):
        if old:
            array.SetTuple(i, i, old)
        else:
            array.SetValue(i, 1.0)
    arrays.AddArray(array)
    return result


def cases(name):
    for port, accepted, _ in INPUTS[name]:
        data = sound(name, port, accepted[0])
        for kind, arrays, count in attributes(data):
            names = [arrays.GetArrayName(i) for i in range(arrays.GetNumberOfArrays())]
            for array in (*names, "Unread"):
                # All columns of a table but the first are counted by that.
                if kind == vtkDataObject.ROW and array == names[0]:
                    continue
                for left in (count // 2, 0):
                    yield port, array, left, shortened(data, kind, array, left)


def trial(name, port, array, data):
    """What is wrong about how the filter ends, or nothing."""
    proxy = made(name, replaced={port: data})
    algorithm = proxy.GetClientSideObject()
    listener = robustness_trials.Listener(algorithm)
    proxy.SMProxy.UpdatePipeline()
    sizes = [robustness_trials.size_of(algorithm.GetOutputDataObject(i))
             for i in range(algorithm.GetNumberOfOutputPorts())]
    if not any(f"'{array}'" in sentence for sentence in listener.errors):
        return f"no sentence about it: {listener.errors}, {sizes} elements"
    return f"{sizes} elements beside the sentence" if any(sizes) else ""


def tried(name):
    complaints, count = [], 0
    for port, array, left, data in cases(name):
        count += 1
        wrong = trial(name, port, array, data)
        if wrong:
            complaints.append(f"{name}, {port}, {array} of {left}: {wrong}")
    return "\n".join([str(count), *complaints])


total, wrong = 0, []
for filter_name in sys.argv[1:] or filters():
    word, said, took = robustness_trials.run(lambda: tried(filter_name), seconds=60)
    if word != "done":
        wrong.append(f"{filter_name}: {word} {said[-300:]}")
        continue
    first, *complaints = said.splitlines()
    total += int(first)
    wrong += complaints
    print(f"{filter_name}: {first} arrays, {took:.1f} s, {len(complaints)} complaints", flush=True)
print(f"{total} trials")
print("\n".join(wrong))
assert not wrong and (total > 200 or len(sys.argv) > 1), f"{len(wrong)} complaints"
