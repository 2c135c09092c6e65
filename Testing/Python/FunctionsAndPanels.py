"""Panel, function and class have the same properties with the same defaults: each in the panel of a filter is a
keyword of its function and is set by a method of its class; each setter of the class with a getter is in the panel.

Runs by pvpython, and by the Python of a wheel (Testing/Builds/wheel.sh)."""
import inspect
import math
import re

import isthmus
from isthmus import functions

# Setters of classes that are not properties of a panel, with the reason.
NOT_IN_PANELS = {
    "Controller": "of MPI", "NumberOfThresholds": "by their list", "NumberOfSecondThresholds": "by their list",
    "PolarizedArrayName": "of the second input, which ParaView 5.11 offers no list for",
    "PotentialArrayName": "likewise, or of the input that this panel does not have",
}


def close(a, b):
    if isinstance(a, (tuple, list)) or isinstance(b, (tuple, list)):
        a, b = list(a), list(b)
        return len(a) == len(b) and all(map(close, a, b))
    if isinstance(a, str) or isinstance(b, str):
        return (a or "") == (b or "")
    return math.isclose(float(a), float(b), rel_tol=1e-12, abs_tol=1e-300)


def rows_are_default(algorithm, found):
    """Thresholds, ions and species, as the class has them."""
    count = getattr(algorithm, f"GetNumberOf{found['xml']}", None)
    if found["number"] is None or count is None:
        return True
    return count() == len(found["default"]) and close(
        [getattr(algorithm, found["command"].replace("Set", "Get", 1))(i) for i in range(count())], found["default"])


def complaints_of(name, described):
    algorithm = functions.class_of(described["class"])()
    signature = inspect.signature(getattr(isthmus, name))
    named = [found["name"] for found in described["inputs"] + described["properties"]]
    if sorted(named) != sorted(signature.parameters):
        yield f"{name}: parameters {sorted(set(named) ^ set(signature.parameters))} differ from the panel"
    if len(set(named)) != len(named):
        yield f"{name}: two properties have one name: {sorted(named)}"
    if algorithm.GetNumberOfInputPorts() <= max((found["port"] for found in described["inputs"]), default=-1):
        yield f"{name}: the class has no input of the panel's"
    outputs = len(described["outputs"]) or (0 if described["kind"] == "writer" else 1)
    if algorithm.GetNumberOfOutputPorts() not in (outputs, outputs + (described["kind"] == "writer")):
        yield f"{name}: {outputs} outputs in the panel, {algorithm.GetNumberOfOutputPorts()} of the class"
    settable = set()
    for found in described["properties"]:
        command = found["command"]
        settable.add(re.sub("^(Set|Add)", "", command))
        if not hasattr(algorithm, command):
            yield f"{name}: the class has no {command}"
            continue
        if found["name"] in signature.parameters and not found["text"]:
            yield f"{name}: {found['name']} is not explained"
        if found["kind"] in ("array", "path"):
            continue
        if found["kind"] == "rows":
            if not rows_are_default(algorithm, found):
                yield f"{name}: {found['name']} is by default {found['default']} in the panel, not in the class"
            continue
        if found["kind"] == "arrays":
            selection = getattr(algorithm, command)()
            arrays = [selection.GetArrayName(i) for i in range(selection.GetNumberOfArrays())]
            chosen = [array for array in arrays if selection.ArrayIsEnabled(array)]
            if arrays != list(found["arrays"]) or chosen != found["default"]:
                yield f"{name}: {chosen} of {arrays} in the class, {found['default']} of {list(found['arrays'])} in its table"
            continue
        getter = getattr(algorithm, command.replace("Set", "Get", 1), None)
        if getter is None:
            yield f"{name}: the class has no getter for {found['name']}"
            continue
        value = getter()
        if not found.get("from_input") and not close(value, found["default"]):
            yield f"{name}: {found['name']} is {found['default']} in the panel, {value} in the class"
        shown = signature.parameters[found["name"]].default
        if found["kind"] == "choice":
            shown = found["choices"].get(shown, shown)
        if not close(shown, found["default"]):
            yield f"{name}: {found['name']} is {shown} in the function, {found['default']} in the panel"
    own = set(dir(algorithm)) - set(dir(base_of(algorithm)))
    stems = {word[3:] for word in own if word.startswith("Set") and f"Get{word[3:]}" in own}
    for stem in sorted(stems - settable - set(NOT_IN_PANELS)):
        yield f"{name}: {stem} of the class is in no panel"


def base_of(algorithm):
    """The nearest class of VTK itself."""
    return next(kind for kind in type(algorithm).__mro__ if kind.__module__.startswith("vtkmodules"))


def main():
    complaints, count = [], 0
    table = functions.table()
    wrapped = {name for name in table["classes"]}
    described_classes = {described["class"] for described in table["functions"].values()}
    for name in sorted(wrapped - described_classes):
        try:
            made = functions.class_of(name)()
        except (TypeError, NotImplementedError):
            continue  # abstract
        if not hasattr(made, "GetInputPortInformation"):
            continue  # an object that answers questions, no filter
        complaints.append(f"{name}: the class can be made and has no function")
    for name, described in table["functions"].items():
        complaints += complaints_of(name, described)
        count += len(described["properties"])
        if not described["example"]:
            complaints.append(f"{name}: function_examples.txt has no example")
    for complaint in complaints:
        print(complaint)
    assert count > 300 and not complaints, f"{len(complaints)} complaints about {count} properties"
    print(f"{count} properties of {len(table['functions'])} functions are those of panel and class.")


if __name__ == "__main__":
    main()
