"""The same data in another form, each filter and each of its ports, gives the same numbers: volumes of whole
numbers in every type that holds them, also large ones that single precision rounds, surfaces and meshes with points
that no cell uses (far away, in the middle, at no finite place, several), atoms with copies of some. Outputs may keep
such points; one at no finite place may be refused. Points are atoms where cells do not matter, so ports for any points
have no unused ones. Finite values and coordinates of which no products can be computed are refused with one error.
"""

import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_BIT, vtkDataArray, vtkIdList, vtkPoints

import robustness_trials
from good_data import INPUTS, filters, made, sound

TYPES = ("SignedChar", "UnsignedChar", "Short", "UnsignedShort", "Int", "UnsignedInt", "Long", "UnsignedLong",
         "LongLong", "UnsignedLongLong", "Float")
LARGE = ("Int", "UnsignedLongLong")  # types of numbers from BASE to BASE + 120
BASE = 1e9
BITS = 1e-4  # of the largest number of an array: outputs may be of single precision
FAR = 1e5
OUT_OF_RANGE = {  # factors of an image's values or of coordinates; each is refused with one error
    "values of 1e-200": 1e-200, "values of 1e200": 1e200, "values of 3e38": 3e38,
    "coordinates of 1e-200": 1e-200, "coordinates of 1e200": 1e200, "a coordinate of 1e300": None}
# Ports for atoms whose outputs are sums over them, or depend on their number. Others give the atoms themselves.
ATOMS = {(name, "Input") for name in (
    "MolecularPockets", "PoreProfile", "MolecularDensity", "MolecularFlowSurface", "NonpolarSolvation",
    "PoissonBoltzmann", "PoissonBoltzmannOnSurface", "IonTransport", "IonTransportOnSurface",
    "IonTransportMovingSurface", "SolvationSurface",
    "FullereneStability")} | {("BindingSites", "Atoms"), ("BindingSitesInPockets", "Atoms")}


def in_type(image, name, base=0.0):
    """A copy with the scalars from base to base + 120, rounded, in that type ('Double': to compare with)."""
    result = image.NewInstance()
    result.DeepCopy(image)
    scalars = result.GetPointData().GetScalars()
    values = vtk_to_numpy(scalars).astype(float)
    values = numpy.round(120.0 * (values - values.min()) / (values.max() - values.min())) + base
    array = vtkDataArray.CreateDataArray({
        "Double": 11, "Float": 10, "SignedChar": 15, "UnsignedChar": 3, "Short": 4, "UnsignedShort": 5, "Int": 6,
        "UnsignedInt": 7, "Long": 8, "UnsignedLong": 9, "LongLong": 16, "UnsignedLongLong": 17}[name])
    array.SetName(scalars.GetName())
    array.SetNumberOfTuples(len(values))
    vtk_to_numpy(array)[:] = values
    result.GetPointData().SetScalars(array)
    return result


def shifted(image):
    """A copy with each value at the next node."""
    result = image.NewInstance()
    result.DeepCopy(image)
    values = vtk_to_numpy(result.GetPointData().GetScalars())
    values[:] = numpy.roll(values, 1)
    return result


def out_of_range(data, form):
    """A copy with scalars or coordinates of which no products can be computed."""
    result = data.NewInstance()
    result.DeepCopy(data)
    factor = OUT_OF_RANGE[form]
    if data.IsA("vtkImageData"):
        scalars = result.GetPointData().GetScalars()
        values = numpy.ascontiguousarray(
            vtk_to_numpy(scalars) * factor, numpy.float32 if factor == 3e38 else numpy.float64)
        array = numpy_to_vtk(values, deep=True)
        array.SetName(scalars.GetName())
        result.GetPointData().SetScalars(array)
        return result
    places = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    if factor is None:
        places[0, 0] = 1e300
    else:
        places *= factor
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    result.SetPoints(points)
    return result


NOWHERE = "an unused point nowhere"  # may be refused by one error
UNUSED = {"an unused point far away": [(3.0 * FAR, -2.0 * FAR, FAR)],
          "an unused point in the middle": [(0.1, -0.2, 0.3)],
          NOWHERE: [(numpy.nan, numpy.nan, numpy.nan)],
          "unused points": [(3.0 * FAR, -2.0 * FAR, FAR), (0.1, -0.2, 0.3), (0.1, -0.2, 0.3), (-FAR, FAR, 2.0 * FAR)]}


def with_unused_points(data, places):
    """Points that no cell uses, behind those of the data."""
    result = data.NewInstance()
    result.DeepCopy(data)
    points = vtkPoints()
    points.SetDataType(data.GetPoints().GetDataType())
    points.DeepCopy(data.GetPoints())
    arrays = result.GetPointData()
    for place in places:
        points.InsertNextPoint(place)
        for i in range(arrays.GetNumberOfArrays()):
            array = arrays.GetArray(i)
            array.InsertNextTuple(array.GetTuple(0))
    result.SetPoints(points)
    return result


def with_copies(data):
    """Each second atom once more, behind the others, with all that it has; no cells."""
    result = data.NewInstance()
    if data.IsA("vtkMolecule"):
        result.DeepCopy(data)
        for i in range(0, data.GetNumberOfAtoms(), 2):
            result.AppendAtom(data.GetAtomAtomicNumber(i), *data.GetAtomPosition(i))
        return result
    result.SetPoints(vtkPoints())
    result.GetPoints().DeepCopy(data.GetPoints())
    result.GetPointData().DeepCopy(data.GetPointData())
    for i in range(0, data.GetNumberOfPoints(), 2):
        result.GetPoints().InsertNextPoint(data.GetPoint(i))
        for k in range(result.GetPointData().GetNumberOfArrays()):
            array = result.GetPointData().GetArray(k)
            array.InsertNextTuple(array.GetTuple(i))
    return result


def without_cells(data):
    result = data.NewInstance()
    result.SetPoints(data.GetPoints())
    result.GetPointData().ShallowCopy(data.GetPointData())
    return result


def used(data, points):
    """Of the points of an output, those of its cells; without cells, those that are near and not one of UNUSED, which
    filters may keep that keep all points."""
    if data.GetNumberOfCells() == 0:
        kept = numpy.abs(points[:, None, :] - numpy.array(UNUSED["unused points"])).max(axis=2) < 1e-6
        return (numpy.abs(points).max(axis=1, initial=0.0) < FAR) & ~kept.any(axis=1)
    result = numpy.zeros(len(points), dtype=bool)
    ids = vtkIdList()
    for cell in range(data.GetNumberOfCells()):
        data.GetCellPoints(cell, ids)
        for i in range(ids.GetNumberOfIds()):
            result[ids.GetId(i)] = True
    return result


def numbers(proxy):
    """{what: array} of all outputs."""
    algorithm = proxy.GetClientSideObject()
    listener = robustness_trials.Listener(algorithm)
    proxy.SMProxy.UpdatePipeline()
    found = {"errors": numpy.array([float(len(listener.errors))])}
    for port in range(algorithm.GetNumberOfOutputPorts()):
        for number, leaf in enumerate(robustness_trials.leaves(algorithm.GetOutputDataObject(port))):
            where = f"{port}.{number}"
            near = slice(None)
            if leaf.IsA("vtkDataSet"):
                found[f"{where} cells"] = numpy.array([float(leaf.GetNumberOfCells())])
            if leaf.IsA("vtkPointSet") and leaf.GetPoints():
                points = vtk_to_numpy(leaf.GetPoints().GetData()).astype(float)
                near = used(leaf, points)
                found[f"{where} points"] = points[near]
            for kind in ("GetPointData", "GetCellData", "GetRowData", "GetFieldData"):
                fields = getattr(leaf, kind)() if hasattr(leaf, kind) else None
                for i in range(fields.GetNumberOfArrays() if fields else 0):
                    array = fields.GetArray(i)
                    if array and array.GetDataType() != VTK_BIT:
                        values = vtk_to_numpy(array).astype(float)
                        found[f"{where} {kind} {array.GetName()}"] = (
                            values[near] if kind == "GetPointData" else values)
    return found


def differences(expected, found, of_spread):
    """`of_spread`: tolerances are shares of the difference between the largest and the smallest number of an array."""
    for what in sorted(set(expected) | set(found)):
        if what not in expected or what not in found:
            yield f"{what} only once"
            continue
        first, second = expected[what], found[what]
        if first.shape != second.shape:
            yield f"{what}: {len(second)} instead of {len(first)}"
            continue
        finite = first[numpy.isfinite(first)]
        size = numpy.abs(finite).max(initial=0.0)
        if of_spread and len(finite) > 1:
            size = numpy.ptp(finite)
        relative = 0.0 if of_spread else BITS
        if not numpy.allclose(first, second, rtol=relative, atol=BITS * size + 1e-12, equal_nan=True):
            yield f"{what}: off by {numpy.nanmax(numpy.abs(first - second)):.3g} of {size:.3g}"


def compared(name, port, kind, form, first, second):
    number = [p[0] for p in INPUTS[name]].index(port)
    is_large = form.startswith("large")

    def result(data):
        # A second volume, such as another half map, is of the same type.
        others = {p[0]: shifted(data) for p in INPUTS[name] if is_large and "vtkImageData" in p[1]}
        proxy = made(name, kind if number == 0 else None, replaced={**others, port: data})
        if is_large and "Level" in proxy.ListProperties():
            proxy.Level = BASE + 60.25
        return numbers(proxy)

    if form in OUT_OF_RANGE:
        found = result(second)
        if found["errors"] != 1.0:
            return f"{found['errors'][0]:.0f} errors instead of 1"
        return ", ".join(what for what in found if what.endswith("cells") and found[what].any())
    expected, found = result(first), result(second)
    if form == NOWHERE and found["errors"] == 1.0 and not any(found[what].any() for what in found if what.endswith("cells")):
        return ""
    return "; ".join(differences(expected, found, is_large))


def trials(name):
    """(name of the form, port, kind, sound data, the same in that form)."""
    for port, accepted, _ in INPUTS[name]:
        for kind in accepted:
            data = sound(name, port, kind)
            if data is None:
                continue
            if (name, port) in ATOMS:
                yield "copies", port, kind, data if data.IsA("vtkMolecule") else without_cells(data), with_copies(data)
            if data.IsA("vtkImageData") and data.GetPointData().GetScalars():
                for type_name in TYPES:
                    yield type_name, port, kind, in_type(data, "Double"), in_type(data, type_name)
                for type_name in LARGE:
                    yield f"large {type_name}", port, kind, in_type(data, "Double", BASE), in_type(
                        data, type_name, BASE)
                for form in OUT_OF_RANGE:
                    if form.startswith("values") and (name, port) != ("SurfaceToGrid", "Grid"):  # only its nodes count
                        yield form, port, kind, None, out_of_range(data, form)
            elif data.IsA("vtkPointSet") and kind in ("vtkPolyData", "vtkUnstructuredGrid"):
                for form, places in UNUSED.items():
                    yield form, port, kind, data, with_unused_points(data, places)
            if data.IsA("vtkPointSet"):
                for form in OUT_OF_RANGE:
                    if "coordinate" in form:
                        yield form, port, kind, None, out_of_range(data, form)


def main(names):
    wrong, count = [], 0
    for name in names or filters():
        for form, port, kind, first, second in trials(name):
            word, said, _ = robustness_trials.run(
                lambda a=(name, port, kind, form, first, second): compared(*a), 30)
            count += 1
            if word != "done" or said:
                wrong.append(f"{name}, {port} ({kind}), {form}: {word} {said[-300:]}")
    print(f"{count} trials")
    print("\n".join(wrong))
    return 1 if wrong or count < 100 else 0


sys.exit(main(sys.argv[1:]))
