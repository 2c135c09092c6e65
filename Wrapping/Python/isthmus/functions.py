"""The filters, readers and writers as functions of data: created from filters.json, which is generated from the panels.

A function takes VTK's data objects, PyVista's (which are VTK's), meshes of meshio or trimesh, or arrays of numpy, runs the
filter once, and returns its outputs: PyVista's objects where that is installed, otherwise VTK's. What a filter reports
as an error is raised as ValueError, what it reports as a warning is a warning of Python (IsthmusWarning).
"""
import collections
import contextlib
import difflib
import functools
import importlib
import inspect
import json
import numbers
import operator
import os
import re
import signal
import textwrap
import threading
import warnings

from . import notebooks, other_libraries

ASSOCIATIONS = {"point": 0, "points": 0, "cell": 1, "cells": 1}


class IsthmusWarning(UserWarning):
    """A warning: something that a filter dropped, repaired or assumed."""


@functools.lru_cache(maxsize=None)
def table():
    with open(os.path.join(os.path.dirname(__file__), "filters.json"), encoding="utf-8") as file:
        return json.load(file)


def names():
    """All functions, short names included."""
    return [*table()["functions"], *table()["short_names"]]


@functools.lru_cache(maxsize=None)
def pyvista():
    """The module, or None where it is not installed."""
    try:
        return importlib.import_module("pyvista")
    except ImportError:
        return None


# ---------------------------------------------------------------------------- progress

_callbacks = []


@contextlib.contextmanager
def progress(callback):
    """Calls callback(fraction, text) while a filter runs inside of this context.

    >>> import isthmus
    >>> seen = []
    >>> with isthmus.progress(lambda fraction, text: seen.append(fraction)):
    ...     _ = isthmus.choking_loops(isthmus.samples.torus())
    >>> bool(seen) and 0 <= min(seen) and max(seen) <= 1
    True
    """
    _callbacks.append(callback)
    try:
        yield
    finally:
        _callbacks.remove(callback)


class _Watch:
    """Errors, warnings, progress and Ctrl-C of one execution of an algorithm."""

    def __init__(self, algorithm, function):
        self.algorithm, self.errors, self.warnings, self.raised = algorithm, [], [], None
        self.bar = notebooks.Bar(function)
        executive = algorithm.GetExecutive()
        tags = []
        for watched in (algorithm, executive):
            for event, texts in (("ErrorEvent", self.errors), ("WarningEvent", self.warnings)):
                tags.append((watched, watched.AddObserver(event, self._collector(texts))))
        tags.append((algorithm, algorithm.AddObserver("ProgressEvent", self._advance)))
        self.tags = tags
        # Raised on entry to an observer, before it can catch anything, KeyboardInterrupt would end the program: VTK exits.
        self.before = signal.getsignal(signal.SIGINT) if threading.current_thread() is threading.main_thread() else None
        if callable(self.before):
            signal.signal(signal.SIGINT, self._interrupt)

    def _interrupt(self, number, frame):
        try:
            self.before(number, frame)
        except BaseException as error:
            self.raised = error
            self.algorithm.SetAbortExecute(1)

    @staticmethod
    def _collector(texts):
        def collect(_, __, text):
            texts.append(sentence(text))
        collect.CallDataType = "string0"
        return collect

    def _advance(self, algorithm, _):
        try:
            for callback in _callbacks:
                callback(algorithm.GetProgress(), algorithm.GetProgressText() or "")
            if not _callbacks:
                self.bar.advance(algorithm.GetProgress())
        except BaseException as error:  # Ctrl-C as well: VTK would print it and continue
            self.raised = error
            algorithm.SetAbortExecute(1)

    def end(self):
        for watched, tag in self.tags:
            watched.RemoveObserver(tag)
        self.bar.close()
        if callable(self.before):
            signal.signal(signal.SIGINT, self.before)


def sentence(text):
    """The message of vtkErrorMacro or vtkWarningMacro without file, line and address."""
    text = re.sub(r"^(ERROR|Warning|Generic Warning): In [^\n]*\n", "", text.strip())
    return " ".join(re.sub(r"^\w+ \((0x)?[0-9a-fA-F]+\): ", "", text).split())


# ---------------------------------------------------------------------------- what comes in

def _is_array(value):
    return hasattr(value, "__array_interface__") and hasattr(value, "ndim")


def _usable(array, numpy, where):
    """The array in the byte order of this machine and of a number type that VTK has; ValueError if values are masked."""
    if isinstance(array, numpy.ma.MaskedArray):
        if numpy.ma.is_masked(array):
            raise ValueError(f"{where} is a numpy array with masked values, and VTK's arrays have no mask: fill it, for "
                             "example by array.filled(numpy.nan) for a volume of floats, or leave out masked rows.")
        array = array.data
    kind, size = array.dtype.kind, array.dtype.itemsize
    if kind not in "iufb":
        raise TypeError(f"{where} is an array of {array.dtype}; convert it to numbers, for example by "
                        "array.astype(float).")
    held = {("b", 1): "uint8", ("f", 2): "float32"}.get((kind, size))
    if kind == "f" and size > 8:
        held = "float64"
    return array.astype(held or array.dtype.newbyteorder("="), copy=False)


def _whole(ids, numpy, where):
    """Ids as integers; ValueError where one is not a whole number."""
    if ids.dtype.kind == "f" and not (numpy.isfinite(ids) & (ids == numpy.floor(ids))).all():
        raise ValueError(f"{where} has triangles with ids of points that are not whole numbers.")
    return ids


def _points(array, numpy, data):
    from vtkmodules.util import numpy_support
    from vtkmodules.vtkCommonCore import vtkPoints
    points = vtkPoints()
    points.SetData(numpy_support.numpy_to_vtk(numpy.ascontiguousarray(array, dtype=float), deep=True))
    data.SetPoints(points)


def _cells(count, width, connectivity, numpy):
    from vtkmodules.util import numpy_support
    from vtkmodules.vtkCommonDataModel import vtkCellArray
    cells = vtkCellArray()
    offsets = numpy.arange(0, (count + 1) * width, width, dtype=numpy.int64)
    flat = numpy.ascontiguousarray(connectivity, dtype=numpy.int64).ravel()
    cells.SetData(numpy_support.numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_support.numpy_to_vtkIdTypeArray(flat, deep=True))
    return cells


def _image_of(array):
    """vtkImageData of values at nodes [x, y, z], one unit apart; no copy of an array in Fortran's order."""
    from vtkmodules.util import numpy_support
    from vtkmodules.vtkCommonDataModel import vtkImageData
    image = vtkImageData()
    image.SetDimensions(array.shape)
    values = numpy_support.numpy_to_vtk(array.ravel(order="F"))
    values.SetName("Values")
    image.GetPointData().SetScalars(values)
    return image


def _from_numpy(value, types, where):
    """The data object of arrays, in the forms that the docstring of each function describes; None for others."""
    import numpy
    from vtkmodules.util import numpy_support
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    if _is_array(value) and value.ndim == 3 and "vtkImageData" in types:
        return _image_of(_usable(value, numpy, where))
    if _is_array(value) and value.ndim == 2 and value.shape[1] in (3, 4, 5) and "vtkPointSet" in types:
        value = _usable(value, numpy, where)
        atoms = vtkPolyData()
        _points(value[:, :3], numpy, atoms)
        atoms.SetVerts(_cells(len(value), 1, numpy.arange(len(value)), numpy))
        for column, name in zip(range(3, value.shape[1]), ("Radius", "Charge")):
            array = numpy_support.numpy_to_vtk(numpy.ascontiguousarray(value[:, column], dtype=float), deep=True)
            array.SetName(name)
            atoms.GetPointData().AddArray(array)
        return atoms
    if isinstance(value, tuple) and len(value) == 2 and all(map(_is_array, value)) and "vtkPolyData" in types:
        points, triangles = value
        if points.ndim != 2 or points.shape[1] != 3 or triangles.ndim != 2 or triangles.shape[1] != 3:
            raise ValueError(f"{where} as arrays needs points of shape (n, 3) and triangles of shape (m, 3), not "
                             f"{points.shape} and {triangles.shape}.")
        points = _usable(points, numpy, f"{where}, points")
        triangles = _whole(_usable(triangles, numpy, f"{where}, triangles"), numpy, where)
        if len(triangles) and not 0 <= triangles.min() <= triangles.max() < len(points):
            raise ValueError(f"{where} has triangles of points that do not exist: ids go from 0 to {len(points) - 1}.")
        surface = vtkPolyData()
        _points(points, numpy, surface)
        surface.SetPolys(_cells(len(triangles), 3, triangles, numpy))
        return surface
    return None


FORMS = {"vtkImageData": "a volume: vtkImageData, pyvista.ImageData or a numpy array of values [x, y, z]",
         "vtkPolyData": "a surface: vtkPolyData, pyvista.PolyData, a mesh of trimesh or meshio, or (points, triangles) as numpy "
                        "arrays",
         "vtkPointSet": "points or atoms: vtkPointSet, pyvista.PolyData or a numpy array of rows x, y, z (, radius (, charge))",
         "vtkUnstructuredGrid": "a mesh: vtkUnstructuredGrid, pyvista.UnstructuredGrid or a mesh of meshio",
         "vtkMolecule": "a vtkMolecule", "vtkTable": "a vtkTable or pyvista.Table", "vtkDataSet": "any vtkDataSet"}


def forms_of(types):
    return ", or ".join(FORMS.get(name, name) for name in types)


def take_input(value, given, function):
    """The data object for an input; TypeError or ValueError if it cannot be converted."""
    where = f"{function}(): {given['name']}"
    data = value
    if not (hasattr(value, "IsA") and hasattr(value, "GetClassName")):
        data = other_libraries.data_of(value, where)
        if data is not None:
            return take_input(data, given, function)
        data = _from_numpy(value, given["types"], where)
        if data is None:
            shape = f" of shape {value.shape}" if _is_array(value) else ""
            raise TypeError(f"{where} must be {forms_of(given['types'])}; it is a "
                            f"{type(value).__module__}.{type(value).__qualname__}{shape}.")
    elif not any(data.IsA(name) for name in given["types"]):
        raise TypeError(f"{where} must be {forms_of(given['types'])}; it is a {data.GetClassName()}.")
    if data.IsA("vtkTable"):
        empty = "rows" if not data.GetNumberOfRows() else ""
    elif data.IsA("vtkMolecule"):
        empty = "atoms" if not data.GetNumberOfAtoms() else ""
    else:
        empty = "points" if not data.GetNumberOfPoints() else ""
        if not empty and set(given["types"]) <= {"vtkPolyData", "vtkUnstructuredGrid"} and not data.GetNumberOfCells():
            empty = "cells"
    if empty:
        raise ValueError(f"{where} is empty: it has no {empty}.")
    return data


def _number(value, kind, where):
    if isinstance(value, str) or not isinstance(value, (numbers.Number, *_numpy_numbers())):
        raise TypeError(f"{where} must be {'an integer' if kind == 'int' else 'a number'}, not a "
                        f"{type(value).__name__}.")
    if kind == "int":
        try:
            return operator.index(value)
        except TypeError:
            if float(value) != int(value):
                raise TypeError(f"{where} must be an integer, not {value}.") from None
            return int(value)
    return float(value)


def _numpy_numbers():
    import numpy
    return (numpy.number, numpy.bool_)


def _truth(value, where):
    if isinstance(value, (bool, *_numpy_numbers()[1:])) or (isinstance(value, int) and value in (0, 1)):
        return bool(value)
    raise TypeError(f"{where} must be True or False, not {value!r}.")


def _choice(value, found, where):
    words = ", ".join(repr(word) for word in found["choices"])
    if isinstance(value, str):
        word = re.sub(r"\W+", "_", re.sub(r"\([^)]*\)", "", value).strip()).strip("_")
        word = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", word).lower()
        for form in (word, word.replace("_", "")):
            for known, number in found["choices"].items():
                if form in (known, known.replace("_", "")):
                    return number
        raise ValueError(f"{where} is {value!r}; choose one of {words}.")
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise TypeError(f"{where} must be one of {words}, or its number; it is {value!r}.")
    if operator.index(value) not in found["choices"].values():
        raise ValueError(f"{where} is {value}; choose one of {words}.")
    return operator.index(value)


def _rows(value, found, where):
    """Rows of numbers, also where one row or a flat list is given."""
    try:
        rows = [list(row) if hasattr(row, "__iter__") and not isinstance(row, str) else row for row in value]
    except TypeError:
        raise TypeError(f"{where} must be a sequence of rows of {found['width']} numbers.") from None
    flat = [_number(entry, "float", where) for row in rows for entry in (row if isinstance(row, list) else [row])]
    if len(flat) % found["width"]:
        raise ValueError(f"{where} must have rows of {found['width']} numbers; {len(flat)} numbers are given.")
    return [flat[first:first + found["width"]] for first in range(0, len(flat), found["width"])]


def set_array(algorithm, value, found, inputs, where):
    """Chooses an input array: by its name, or ("point" or "cell", name)."""
    if value is None:
        return
    association = found.get("association", "point")
    if isinstance(value, (tuple, list)) and len(value) == 2:
        association, value = value
        association = str(association).lower()
        if association not in ASSOCIATIONS:
            raise ValueError(f"{where} is of {association!r}; choose 'point' or 'cell'.")
    if not isinstance(value, str):
        raise TypeError(f"{where} must be the name of an array, not a {type(value).__name__}.")
    number = ASSOCIATIONS[association]
    data = inputs.get(0)
    for candidate in inputs.values():
        if candidate.GetAttributes(number) and candidate.GetAttributes(number).HasArray(value):
            data = candidate
            break
    else:
        attributes = data.GetAttributes(number) if data is not None else None
        known = [attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())] if attributes else []
        raise ValueError(f"{where}: the input has no {association} array {value!r}; it has "
                         f"{', '.join(repr(name) for name in known if name) or 'none'}.")
    port = next((port for port, given in inputs.items() if given is data), 0)
    algorithm.SetInputArrayToProcess(found["index"], port, 0, number, value)


def choose_arrays(selection, value, found, where):
    """Enables the named arrays of a vtkDataArraySelection, and no other."""
    names = [value] if isinstance(value, str) else list(value)
    unknown = [name for name in names if name not in found["arrays"]]
    if unknown:
        raise ValueError(f"{where} has {unknown[0]!r}; choose among {', '.join(map(repr, found['arrays']))}.")
    for name in found["arrays"]:
        selection.SetArraySetting(name, int(name in names))


def set_property(algorithm, value, found, inputs, function):
    where = f"{function}(): {found['name']}"
    kind, setter = found["kind"], getattr(algorithm, found["command"], None)
    if kind == "array":
        set_array(algorithm, value, found, inputs, where)
    elif kind == "arrays":
        choose_arrays(setter(), value, found, where)
    elif kind == "rows":
        rows = _rows(value, found, where)
        if found["clear"]:
            getattr(algorithm, found["clear"])()
        if found["number"]:
            getattr(algorithm, found["number"])(len(rows))
        for index, row in enumerate(rows):
            setter(*([index] if found["number"] else []), *row)
    elif kind == "bool":
        setter(_truth(value, where))
    elif kind == "choice":
        setter(_choice(value, found, where))
    elif kind == "path":
        setter(os.fspath(value))
    elif kind == "str":
        if value is not None and not isinstance(value, str):
            raise TypeError(f"{where} must be a string, not a {type(value).__name__}.")
        setter(value or "")
    elif found["count"] == 1:
        setter(_number(value, kind, where))
    else:
        values = list(value) if hasattr(value, "__iter__") and not isinstance(value, str) else [value]
        if len(values) != found["count"]:
            raise ValueError(f"{where} must have {found['count']} numbers; it has {len(values)}.")
        setter(*[_number(entry, kind, where) for entry in values])


# ---------------------------------------------------------------------------- what comes out

def give(data, as_array=False):
    """An output, disconnected from the filter that created it: PyVista's object where that is installed."""
    if data is None:
        return None
    if as_array and data.IsA("vtkImageData"):
        from vtkmodules.util import numpy_support
        scalars = data.GetPointData().GetScalars() or data.GetPointData().GetArray(0)
        if scalars is not None and scalars.GetNumberOfComponents() == 1:
            return numpy_support.vtk_to_numpy(scalars).reshape(data.GetDimensions(), order="F")
    free = data.NewInstance()
    free.ShallowCopy(data)
    module = pyvista()
    if module is not None and data.IsA("vtkTable"):
        return module.Table(free) if free.GetNumberOfColumns() else free
    return module.wrap(free) if module is not None and data.IsA("vtkDataSet") else free


def result_type(described):
    name = "".join(word.title() for word in described["name"].split("_")) + "Result"
    return _result_type(name, tuple(described["outputs"]))


@functools.lru_cache(maxsize=None)
def _result_type(name, outputs):
    made = notebooks.shows_html(collections.namedtuple(name, outputs))
    made.__module__ = "isthmus.functions"
    globals()[name] = made  # where pickle searches for it
    return made


# ---------------------------------------------------------------------------- calls

def class_of(name):
    module = importlib.import_module(f"isthmus.{table()['classes'][name]}")
    return getattr(module, name)


def run(algorithm, function, execute=None):
    """Executes; errors of the algorithm are raised, its warnings issued."""
    watch = _Watch(algorithm, function)
    try:
        (execute or algorithm.Update)()
    finally:
        watch.end()
    for text in watch.warnings:
        warnings.warn(f"{function}(): {text}", IsthmusWarning, stacklevel=4)
    if watch.raised is not None:
        raise watch.raised
    if watch.errors:
        raise ValueError(f"{function}(): {' '.join(dict.fromkeys(watch.errors))}")


def _bind(described, arguments, given):
    """Inputs by port, and properties with values, of a call."""
    function = described["name"]
    positional = [found["name"] for found in described["inputs"]]
    positional += [found["name"] for found in described["properties"] if found["kind"] == "path"]
    if len(arguments) > len(positional):
        raise TypeError(f"{function}() takes {len(positional)} positional arguments ({', '.join(positional)}); "
                        f"{len(arguments)} were given. Properties are given by keyword.")
    values = dict(zip(positional, arguments))
    known = {found["name"] for found in described["inputs"] + described["properties"]}
    for name, value in given.items():
        if name not in known:
            close = difflib.get_close_matches(name, known, 1, 0.5)
            raise TypeError(f"{function}() has no argument {name!r}" +
                            (f"; did you mean {close[0]!r}?" if close else "."))
        if name in values:
            raise TypeError(f"{function}() has several values for {name!r}.")
        values[name] = value
    return values


def call(described, arguments, given):
    """The function of a description."""
    function = described["name"]
    values = _bind(described, arguments, given)
    algorithm = class_of(described["class"])()
    inputs, from_array = {}, False
    for found in described["inputs"]:
        value = values.pop(found["name"], None)
        if value is None:
            if not found["optional"]:
                raise TypeError(f"{function}() needs {found['name']}: {forms_of(found['types'])}.")
            continue
        several = value if found["multiple"] and isinstance(value, (list, tuple)) else [value]
        for entry in several:
            data = take_input(entry, found, function)
            from_array = from_array or (_is_array(entry) and data.IsA("vtkImageData"))
            algorithm.AddInputDataObject(found["port"], data)
            inputs.setdefault(found["port"], data)
    # A given value switches the automatic one off, unless that is requested as well.
    ordered = sorted(described["properties"], key=lambda found: found["name"].startswith("automatic_"))
    for found in ordered:
        if found["kind"] == "path":
            if found["name"] not in values:
                raise TypeError(f"{function}() needs {found['name']}: the path of a file.")
            if described["kind"] == "reader" and not os.path.exists(os.fspath(values[found["name"]])):
                raise FileNotFoundError(2, "No such file", os.fspath(values[found["name"]]))
        if found["name"] in values:
            set_property(algorithm, values[found["name"]], found, inputs, function)
        elif found["kind"] == "array" and found["default"] and not inputs.get(0) is None:
            algorithm.SetInputArrayToProcess(found["index"], 0, 0, ASSOCIATIONS[found["association"]],
                                             found["default"])
    if described["kind"] == "writer":
        run(algorithm, function, algorithm.Write)
        return None
    run(algorithm, function)
    outputs = [give(algorithm.GetOutputDataObject(port), from_array)
               for port in range(len(described["outputs"]) or 1)]
    return result_type(described)(*outputs) if len(outputs) > 1 else outputs[0]


# ---------------------------------------------------------------------------- signatures and docstrings

def default_of(found):
    if found["kind"] == "choice":
        for word, number in found["choices"].items():
            if number == found["default"]:
                return word
    return tuple(found["default"]) if isinstance(found["default"], list) else found["default"]


def signature_of(described):
    kinds = inspect.Parameter
    parameters = [kinds(found["name"], kinds.POSITIONAL_OR_KEYWORD,
                        default=None if found["optional"] else kinds.empty) for found in described["inputs"]]
    parameters += [kinds(found["name"], kinds.POSITIONAL_OR_KEYWORD)
                   for found in described["properties"] if found["kind"] == "path"]
    parameters.sort(key=lambda parameter: parameter.default is not kinds.empty)
    parameters += [kinds(found["name"], kinds.KEYWORD_ONLY, default=default_of(found))
                   for found in described["properties"] if found["kind"] != "path"]
    return inspect.Signature(parameters)


def _paragraph(text, indent=""):
    return textwrap.fill(text, 96, initial_indent=indent, subsequent_indent=indent, break_on_hyphens=False,
                         break_long_words=False)


def _type_text(found):
    kind = found["kind"]
    if kind == "choice":
        text = "{" + ", ".join(repr(word) for word in found["choices"]) + "}"
    elif kind == "array":
        text = "str: name of an array, or (\"point\" or \"cell\", name)"
    elif kind == "arrays":
        text = "sequence of names of arrays"
    elif kind == "rows":
        columns = ", ".join(word.lower() for word in found["columns"]) or "number"
        text = f"sequence of rows ({columns})"
    elif kind == "path":
        return "str or os.PathLike"
    elif found.get("count", 1) > 1:
        text = f"{found['count']} {kind}s"
    else:
        text = kind
    if found.get("from_input"):
        return f"{text}, default {default_of(found)!r}; panels propose a value by the input"
    return f"{text}, default {default_of(found)!r}"


def docstring_of(described):
    short = described["short"].rstrip(".")
    parts = [f"{short}.", "", _paragraph(described["text"]), "", "Parameters", "----------"]
    for found in described["inputs"]:
        parts.append(f"{found['name']} : {forms_of(found['types'])}{', optional' if found['optional'] else ''}")
        parts.append(_paragraph(found["text"] or "Input.", "    "))
    for found in described["properties"]:
        parts.append(f"{found['name']} : {_type_text(found)}")
        parts.append(_paragraph(found["text"] or "Path of the file.", "    "))
        parts += [_paragraph(f"{name}: {text}", "        ") for name, text in found.get("arrays", {}).items()]
    parts += ["", "Returns", "-------"]
    if described["kind"] == "writer":
        parts += ["None", "    The file is written."]
    elif len(described["outputs"]) > 1:
        parts += [result_type(described).__name__, _paragraph(
            f"A named tuple of the outputs: {', '.join(described['outputs'])}; PyVista's objects where PyVista is "
            "installed, otherwise VTK's.", "    ")]
    else:
        parts += ["data", _paragraph("The output: PyVista's object where PyVista is installed, otherwise VTK's; a "
                                     "numpy array for a volume given as one.", "    ")]
    parts += ["", "Raises", "------", "TypeError", "    An argument has the wrong type or an unknown name.",
              "ValueError", "    An input is empty, an array is missing, or the filter reports an error: its message."]
    if described["kind"] == "reader":
        parts += ["FileNotFoundError", "    There is no such file."]
    parts += ["", "Warns", "-----", "IsthmusWarning", "    The filter dropped, repaired or assumed something.",
              "", "See Also", "--------", f"isthmus.{described['class']} : the same as a class of VTK"]
    if described["example"]:
        parts += ["", "Examples", "--------", ">>> import isthmus", described["example"]]
    return "\n".join(parts) + "\n"


@functools.lru_cache(maxsize=None)
def function(name):
    """The function of that name; KeyError where there is none."""
    full = table()["short_names"].get(name, name)
    described = table()["functions"][full]

    def made(*arguments, **properties):
        return call(described, arguments, properties)

    made.__name__ = made.__qualname__ = name
    made.__module__ = "isthmus"
    made.__doc__ = docstring_of(described)
    made.__signature__ = signature_of(described)
    return made
