"""Every filter of the module on data that no filter expects.

Each must come back: with an output, or with an error event, a sentence and an empty output. A
crash or a hang ends this test. Filters are found by themselves, so that a new one is in.
"""

import isthmus
from vtkmodules.vtkCommonCore import VTK_STRING
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from damaged_data import grids, images, surfaces

# Cases in which a filter must not have a result.
HOPELESS = ("without scalars", "vectors", "too few values", "spacing is NaN", "spacing of zero",
            "a corner beyond the points", "a negative corner", "all points are NaN",
            "one point is infinite")
# Topology alone: these ask neither for coordinates nor for the values of an image.
WITHOUT_GEOMETRY = ("vtkAtomSelection", "vtkCellIncidence", "vtkTetCutaway")


def filters():
    for name in sorted(dir(isthmus)):
        kind = getattr(isthmus, name)
        if name.startswith("vtk") and isinstance(kind, type) and issubclass(kind, vtkAlgorithm):
            try:
                made = kind()
            except TypeError:  # an abstract base
                continue
            if made.GetNumberOfInputPorts() > 0 and made.GetNumberOfOutputPorts() > 0:
                yield name, kind


def takes(algorithm, port, data):
    key = vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE()
    wanted = algorithm.GetInputPortInformation(port)
    return any(data.IsA(wanted.Get(key, i)) for i in range(wanted.Length(key)))


def attack(name, kind, case, data):
    """Runs a filter with `data` on each input that takes it; what it complained."""
    algorithm, complaints, warnings = kind(), [], []

    def complain(_, event, sentence):
        complaints.append(sentence)

    complain.CallDataType = VTK_STRING
    algorithm.AddObserver("ErrorEvent", complain)
    algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    algorithm.AddObserver("WarningEvent", lambda *_: warnings.append(1))
    ports = [p for p in range(algorithm.GetNumberOfInputPorts()) if takes(algorithm, p, data)]
    if 0 not in ports:
        return None
    for port in ports:
        algorithm.SetInputDataObject(port, data)
    algorithm.Update()
    output = algorithm.GetOutputDataObject(0)
    size = output.GetNumberOfPoints() if hasattr(output, "GetNumberOfPoints") else 0
    if complaints:
        assert size == 0, f"{name}, {case}: an error and still {size} points"
        assert all(len(sentence) > 40 for sentence in complaints), (name, case, complaints)
    else:
        hopeless = case in HOPELESS and name not in WITHOUT_GEOMETRY
        # The mesher leaves out what is hopeless and says so in a warning.
        assert not hopeless or size == 0 or warnings, f"{name}, {case}: {size} points and no word"
    return complaints


cases = [(label, data) for some in (surfaces(), images(), grids()) for label, data in some.items()]
runs = refusals = 0
for filter_name, filter_kind in filters():
    for label, data in cases:
        said = attack(filter_name, filter_kind, f"{label}", data)
        runs += said is not None
        refusals += bool(said)
        if label == "empty":
            assert not said, f"{filter_name} complains about empty input: {said}"
print(f"{runs} runs, {refusals} refusals")
assert runs > 200 and refusals > 100
