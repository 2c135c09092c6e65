"""Every property of every proxy of the plugin at its ends and beyond, through the server manager.

Numbers: the minimum and maximum of its range, NaN, -1, 0, 1e300 and the largest integer, one
property at a time on small good data. Each trial ends within 10 s and 1 GB, without a signal: with
a result that is finite, or with a sentence and nothing. Proxies are found by themselves.

    pvpython PropertySweep.py [PART OF A PROXY'S NAME]
"""

import sys

import robustness_trials
from good_data import filters, kinds, made

NAN, HUGE, LARGEST = float("nan"), 1e300, 2147483647
# Arrays that are documented to hold NaN where there is nothing to tell.
MAY_BE_NAN = {"Death", "Persistence", "Potential"}
# Values that ask for long work by their very meaning, within the documented range, with the reason;
# all of them can be stopped.
LEFT_OUT = {
    ("MolecularFlowSurface", "Spacing", 0.1): "three million nodes for a ball of 5 angstrom",
    ("IonTransport", "Spacing", 0.25): "a million nodes for a tube of 10 angstrom",
    ("IonTransportOnSurface", "Spacing", 0.25): "the same",
    ("OffsetSurface", "Resolution", 512): "512^3 nodes are 1 GB",
    ("PDETransform", "NumberOfModes", 16): "wavelengths that grow sixteen times over",
    ("PDETransform", "WavelengthRatio", 16.0): "wavelengths that grow sixteenfold",
    ("SurfaceRemesh", "RelativeEdgeLength", 0.01): "ten thousand triangles for each",
    ("TetrahedralMesher", "MinimumDihedralAngle", 40.0): "TetGen ends at TimeLimit, 600 s",
}


def numbers_of(proxy):
    """(name, elements, values to try) of each property of numbers."""
    for name in proxy.ListProperties():
        vector = proxy.SMProxy.GetProperty(name)
        kind = vector.GetClassName() if vector else ""
        if vector is None or vector.GetInformationOnly() or not vector.GetCommand():
            continue
        if kind == "vtkSMDoubleVectorProperty":
            values = [NAN, -1.0, 0.0, HUGE, float(LARGEST)]
        elif kind in ("vtkSMIntVectorProperty", "vtkSMIdTypeVectorProperty"):
            values = [-1, 0, LARGEST]
        else:
            continue
        yield name, vector, values + ends_of(vector)


def ends_of(vector):
    """Minimum and maximum of the property's ranges."""
    ends = []
    iterator = vector.NewDomainIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        domain = iterator.GetDomain()
        if domain.IsA("vtkSMDoubleRangeDomain") or domain.IsA("vtkSMIntRangeDomain"):
            for there, end in ((domain.GetMinimumExists, domain.GetMinimum),
                               (domain.GetMaximumExists, domain.GetMaximum)):
                if there(0):
                    ends.append(end(0))
        iterator.Next()
    return ends


def trial(name, kind, property_name, value):
    """Runs a fresh filter with one property changed; 'result', 'refused' or a complaint."""
    proxy = made(name, kind)
    listener = robustness_trials.Listener(proxy.GetClientSideObject())
    vector = proxy.SMProxy.GetProperty(property_name)
    for element in range(max(1, vector.GetNumberOfElements())):
        vector.SetElement(element, value)
    proxy.SMProxy.UpdateVTKObjects()
    proxy.SMProxy.UpdatePipeline()
    algorithm = proxy.GetClientSideObject()
    bad = set()
    size = 0
    for port in range(algorithm.GetNumberOfOutputPorts()):
        output = algorithm.GetOutputDataObject(port)
        size += robustness_trials.size_of(output)
        bad |= robustness_trials.not_finite(output)
    if listener.errors:
        if any(len(sentence) < 40 for sentence in listener.errors):
            return f"short sentence: {listener.errors}"
        return "refused" if size == 0 else f"an error and {size} elements: {listener.errors[0]}"
    bad -= MAY_BE_NAN
    return f"silently not finite: {sorted(bad)}" if bad and not listener.warnings else "result"


def trials_of(name):
    """All of (kind of input, property, value) for a filter."""
    for kind in kinds(name):
        for property_name, _, values in list(numbers_of(made(name, kind))):
            for value in values:
                if (name, property_name, value) not in LEFT_OUT:
                    yield kind, property_name, value


def sweep(part):
    counts, complaints = {"result": 0, "refused": 0, "wrong": 0}, []
    for name in filters():
        if part not in name:
            continue
        for kind, property_name, value in trials_of(name):
            word, said, took = robustness_trials.run(
                lambda: trial(name, kind, property_name, value))
            outcome = said if word == "done" else word
            if outcome in ("result", "refused"):
                counts[outcome] += 1
                continue
            counts["wrong"] += 1
            complaints.append(f"{name}({kind}).{property_name} = {value}: {word}, {took:.1f} s: "
                              f"{said[-600:]}")
            print(complaints[-1], flush=True)
    return counts, complaints


if __name__ == "__main__":
    part_of_name = sys.argv[1] if len(sys.argv) > 1 else ""
    counted, wrong = sweep(part_of_name)
    print(f"{sum(counted.values())} trials: {counted}")
    assert not wrong, f"{len(wrong)} trials went wrong"
    assert part_of_name or counted["result"] > 300 and counted["refused"] > 50
