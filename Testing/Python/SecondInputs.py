"""Second inputs of another molecule, in another place or in nanometres, each filter and each further port:
no filter takes them without a message. Without overlap one error and empty outputs; a smaller overlap than a
half, or ten times the size, a warning at least; sound inputs neither.
"""

import sys

from vtkmodules.vtkCommonDataModel import vtkImageData

import robustness_trials
from good_data import INPUTS, filters, made, sound

# Ports whose data may be of any size, as the headers say: no word about units.
ANY_SIZE = {("LoopShortening", "Surface")}
# Ports whose data may be anywhere: their atoms are found by place or by name.
ANY_PLACE = {("ForceFieldChargesAndLigands", "Ligands")}
UNITS, ELSEWHERE = "nanometres", "do not overlap"


def placed(data, scale, shift):
    """A copy, scaled about the origin and moved along x."""
    result = data.NewInstance()
    result.DeepCopy(data)
    if isinstance(result, vtkImageData):
        x, y, z = data.GetOrigin()
        result.SetOrigin(scale * x + shift, scale * y, scale * z)
        result.SetSpacing(*(scale * h for h in data.GetSpacing()))
        return result
    points = result.GetPoints()
    for i in range(points.GetNumberOfPoints()):
        x, y, z = points.GetPoint(i)
        points.SetPoint(i, scale * x + shift, scale * y, scale * z)
    points.Modified()
    return result


def has_place(data):
    return data is not None and data.IsA("vtkDataSet") and data.GetNumberOfPoints() > 0


def size(data):
    low_x, high_x, low_y, high_y, low_z, high_z = data.GetBounds()
    return ((high_x - low_x) ** 2 + (high_y - low_y) ** 2 + (high_z - low_z) ** 2) ** 0.5


def run(name, replaced):
    proxy = made(name, replaced=replaced)
    algorithm = proxy.GetClientSideObject()
    listener = robustness_trials.Listener(algorithm)
    proxy.SMProxy.UpdatePipeline()
    outputs = [algorithm.GetOutputDataObject(i) for i in range(algorithm.GetNumberOfOutputPorts())]
    return listener, sum(robustness_trials.size_of(output) for output in outputs)


def judged(name, port, first, second):
    """What is wrong with the messages of a filter, and how many trials that took."""
    said, _ = run(name, {port: second})
    words = " ".join(said.errors + said.warnings)
    if UNITS in words or ELSEWHERE in words or "lie within the other" in words:
        yield f"{name}, {port}: sound inputs, yet {words}"
    said, elements = run(name, {port: placed(second, 1.0, 5000.0)})
    if len(said.errors) != 1 or elements > 0:
        yield f"{name}, {port}, 5000 away: {elements} elements, said {said.errors} {said.warnings}"
    elif ELSEWHERE not in said.errors[0]:
        yield f"{name}, {port}, 5000 away: another message, {said.errors[0]}"
    # A tenth of the diagonal is what boxes are grown by: at 0.95 of the width less than a fifth overlaps.
    wide = max(second.GetBounds()[1] - first.GetBounds()[0], first.GetBounds()[1] - second.GetBounds()[0])
    said, elements = run(name, {port: placed(second, 1.0, 0.95 * wide + 0.1 * max(size(first), size(second)))})
    if not said.errors and not any("lie within the other" in word for word in said.warnings):
        yield f"{name}, {port}, hardly overlapping: {elements} elements, said {said.warnings}"
    # Sizes are made equal first, so that a tenth is a tenth.
    tenth = placed(second, 0.1 * size(first) / size(second), 0.0)
    said, elements = run(name, {port: tenth})
    if (name, port) not in ANY_SIZE and not any(UNITS in word for word in said.errors + said.warnings):
        yield f"{name}, {port}, a tenth as large: {elements} elements, said {said.errors} {said.warnings}"


def tried(name):
    complaints, count = [], 0
    first_port, first_kinds, _ = INPUTS[name][0]
    first = sound(name, first_port, first_kinds[0])
    for port, accepted, _ in INPUTS[name][1:]:
        second = sound(name, port, accepted[0])
        if has_place(first) and has_place(second) and (name, port) not in ANY_PLACE:
            count += 1
            complaints += judged(name, port, first, second)
    return "\n".join([str(count), *complaints])


wrong, ports = [], 0
several = [name for name in filters() if len(INPUTS[name]) > 1]
for filter_name in several:
    outcome, text, _ = robustness_trials.run(lambda: tried(filter_name), seconds=60)
    if outcome != "done":
        wrong.append(f"{filter_name}: {outcome}, {text[-600:]}")
        continue
    lines = text.split("\n")
    ports += int(lines[0])
    wrong += lines[1:]
print(*wrong, f"{ports} further inputs of {len(several)} filters", sep="\n")
assert ports >= 10
sys.exit(1 if wrong else 0)
