"""Every property of every proxy of the plugin at its ends and beyond, through the server manager.

Numbers: the minimum and maximum of its range, NaN, -1, 0, 1e300 and the largest integer, one
property at a time on small good data. Each trial ends within 10 s and 1 GB, without a signal: with
a result that is finite, or with a sentence and nothing. Proxies are found by themselves.

    pvpython PropertySweep.py [PART OF A PROXY'S NAME]
"""

import math
import re
import sys

import robustness_trials
from good_data import filters, kinds, made
from PropertyEffects import NEEDS, conditions

NAN, HUGE, LARGEST = float("nan"), 1e300, 2147483647
# Arrays that are documented to hold NaN where there is nothing to tell.
MAY_BE_NAN = {"Death", "Persistence", "Potential"}
# Values that ask for long work by their very meaning, within the documented range, with the reason;
# all of them can be stopped.
LEFT_OUT = {
    ("MolecularFlowSurface", "Spacing", 0.1): "three million nodes for a ball of 5 angstrom",
    ("IonTransport", "Spacing", 0.25): "a million nodes for a tube of 10 angstrom",
    ("IonTransportOnSurface", "Spacing", 0.25): "the same",
    ("IonTransportMovingSurface", "Spacing", 0.25): "the same",
    ("OffsetSurface", "Resolution", 512): "512^3 nodes are 1 GB",
    ("PDETransform", "NumberOfModes", 16): "wavelengths that grow sixteen times over",
    ("PDETransform", "WavelengthRatio", 16.0): "wavelengths that grow sixteenfold",
    ("SurfaceRemesh", "RelativeEdgeLength", 0.01): "ten thousand triangles for each",
    ("TetrahedralMesher", "MinimumDihedralAngle", 40.0): "TetGen ends at TimeLimit, 600 s",
}
# Properties that NaN has a meaning for, or that nothing of the good data uses, with the reason.
ATOMS_OUTSIDE = "the good atoms lie on their surface, which is refused before"
IGNORES_NAN = {
    **{("BindingSitesInPockets", name, "vtkPolyData"): "a ball has no pockets"
       for name in ("MergeDistance", "MinimumArea", "Quantile", "Threshold")},
    ("DualContouring", "Spacing", "vtkImageData"): "of surfaces",
    ("DualContouring", "Level", "vtkPolyData"): "of volumes",
    **{("MapHandles", name, "vtkImageData"): "the good half maps are equal, which is refused before"
       for name in ("Level", "MinimumPersistence")},
    **{(name, ignored, "vtkPointSet"): ATOMS_OUTSIDE for name in ("PoissonBoltzmann", "PoissonBoltzmannOnSurface")
       for ignored in ("Ions", "Spacing")},
    **{("SolvationSurface", name, "vtkPointSet"): "the good atoms have no WellDepth, which is refused before"
       for name in ("EnergyTolerance", "Enlargement", "FieldRelaxation", "Padding", "Pressure", "ProbeRadius",
                    "SoluteDielectric", "SolventDielectric", "Spacing", "SurfaceRelaxation", "SurfaceTension",
                    "Temperature")},
    **{("SurfaceMeasures", name, "vtkPolyData"): "of volumes" for name in ("InsideValue", "Level", "OutsideValue")},
    ("SurfaceToGrid", "Level", "vtkPolyData"): "of volumes",
    ("SurfaceToGrid", "Spacing", "vtkPolyData"): "the good data have a grid",
    ("SurfaceToGrid", "Spacing", "vtkImageData"): "of surfaces",
}
SHOWN_WHERE = conditions()


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


def is_named(vector, sentence):
    """Whether an error says which property it is of: by its name, its setter, or a word of its label."""
    said = sentence.replace(" ", "").lower()
    names = [vector.GetXMLName(), vector.GetCommand().replace("Set", "", 1)]
    names += ["valence"] if vector.GetXMLName() == "Species" else []  # the first number of a row
    names += [word[:-1] for word in re.findall("[A-Z]?[a-z]{4,}", vector.GetXMLLabel())]
    return any(name.lower() in said for name in names)


def choose_what_shows(proxy, name, property_name):
    needs = [(other, float(value)) for other, value in SHOWN_WHERE.get((name, property_name), [])]
    for other, value in needs + list(NEEDS.get((name, property_name), {}).items()):
        if isinstance(value, list):  # names of arrays
            setattr(proxy, other, value)
        elif other != property_name:
            vector = proxy.SMProxy.GetProperty(other)
            vector.SetElement(0, value if vector.GetClassName() == "vtkSMDoubleVectorProperty" else int(value))


def trial(name, kind, property_name, value):
    """Runs a fresh filter with one property changed; 'result', 'refused' or a complaint."""
    proxy = made(name, kind)
    listener = robustness_trials.Listener(proxy.GetClientSideObject())
    vector = proxy.SMProxy.GetProperty(property_name)
    if math.isnan(value):
        choose_what_shows(proxy, name, property_name)
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
        if math.isnan(value) and (name, property_name, kind) not in IGNORES_NAN and (len(listener.errors) > 1 or not is_named(vector, listener.errors[0])):
            return f"NaN is not refused by one error that names the property: {listener.errors}"
        return "refused" if size == 0 else f"an error and {size} elements: {listener.errors[0]}"
    if math.isnan(value) and (name, property_name, kind) not in IGNORES_NAN:
        return f"NaN is accepted in silence: {listener.warnings}"
    bad -= MAY_BE_NAN
    return f"silently not finite: {sorted(bad)}" if bad and not listener.warnings else "result"


def trials_of(name):
    """All of (kind of input, property, value) for a filter."""
    for kind in kinds(name):
        for property_name, _, values in list(numbers_of(made(name, kind))):
            for value in values:
                if (name, property_name, value) not in LEFT_OUT:
                    yield kind, property_name, value


def sweep(part, only_nan=False):
    counts, complaints = {"result": 0, "refused": 0, "wrong": 0}, []
    for name in filters():
        if part not in name:
            continue
        for kind, property_name, value in trials_of(name):
            if only_nan and not math.isnan(value):
                continue
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
    part_of_name = next((word for word in sys.argv[1:] if word != "nan"), "")
    counted, wrong = sweep(part_of_name, "nan" in sys.argv[1:])
    print(f"{sum(counted.values())} trials: {counted}")
    assert not wrong, f"{len(wrong)} trials went wrong"
    assert sys.argv[1:] or counted["result"] > 300 and counted["refused"] > 50
