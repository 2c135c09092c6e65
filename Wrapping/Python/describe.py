#!/usr/bin/env python3
"""The input of the Python functions: a description of each filter, reader and writer.

    describe.py SOURCE PACKAGE VERSION [VTK]

Reads the panels (Plugin/*.xml), the lists of classes (CMakeLists.txt of the modules) and the examples of
docstrings (function_examples.txt) of the tree SOURCE, and writes into the folder PACKAGE
filters.json, from which functions.py creates the functions, __init__.py with the names of the classes, and stubs
(__init__.pyi) for editors and type checkers. VTK, in a wheel, is the minor version that it needs.

A keyword is the name of the property in snake_case.
"""
import json
import pathlib
import re
import sys
import textwrap

import output_arrays
import panel_files

# Commands of panels that differ from the setters of the class, which Python calls.
PANEL_COMMANDS = {"SetLevelOnly": "SetLevel", "SetScaleOnly": "SetScale", "SetRangeOnly": "SetRange",
                  "SetThresholdOnly": "SetThreshold", "SetNamedInputArray": "SetInputArrayToProcess"}
# Proxies of the same class under another name, of ParaView's own readers, and those that are not filters of Isthmus.
SKIPPED = {"MRCSeriesReader", "DensityMapReader", "pdbreader", "xyzreader", "TrajectoryReader"}
# Names of proxies that differ from those of their class without a reason for Python.
RENAMED_PROXIES = {"MRCMapReaderOfOneFile": "MRCMapReader", "DatVolumeReader": "VolumeTextReader"}
# Short names beside the systematic ones.
SHORT_NAMES = {"pockets": "molecular_pockets", "pores": "pore_profile", "read_map": "mrc_map_reader",
               "read_molecule": "macromolecule_reader", "tetgen_mesh_reader": "tet_gen_mesh_reader",
               "tetgen_mesh_writer": "tet_gen_mesh_writer", "opendx_reader": "open_dx_reader",
               "opendx_writer": "open_dx_writer"}
NOT_PROPERTIES = {"TimestepValues", "FileNames"}


def snake_case(name):
    """MaximumRadius -> maximum_radius, PDETransform -> pde_transform."""
    name = re.sub(r"\W+", "", name)
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()


def keyword_of_choice(text):
    """Largest gap -> largest_gap; text in parentheses is explanation."""
    return re.sub(r"\W+", "_", re.sub(r"\([^)]*\)", "", text).strip().lower()).strip("_")


def text_of(element, path="Documentation"):
    found = element.find(path)
    return " ".join("".join(found.itertext()).split()) if found is not None else ""


def numbers(text, kind):
    return [kind(float(word)) if kind is int else kind(word) for word in (text or "").split()]


def describe_input(element):
    name = element.get("name")
    return {
        "name": snake_case(name), "xml": name, "port": int(element.get("port_index") or 0),
        "types": [found.get("value") for found in element.iter("DataType")],
        "optional": element.find("./Hints/Optional") is not None,
        "multiple": element.get("multiple_input") == "1", "text": text_of(element)}


def array_property(element, described):
    """Property that names an array: SetInputArrayToProcess(index, port, connection, association, name), or with a
    name by default SetNamedInputArray(name, index, connection, association, name) of ArrayProperty.h."""
    words = (element.get("default_values") or "").split(element.get("default_values_delimiter"))
    described["kind"] = "array"
    described["index"] = int(next((word for word in words if word.isdigit()), 0))
    described["default"] = words[-1] if words and not words[-1].isdigit() else None
    domain = element.find("ArrayListDomain")
    attribute = domain.get("attribute_type") if domain is not None else None
    described["association"] = {"Cells": "cell"}.get(attribute, "point")


def default_values(element):
    """The default values as text: those of the property, or of its hint if values are proposed from the data (IsthmusInitialization.cxx)."""
    hint = element.find("./Hints/DefaultWithoutData")
    return hint.get("values") if hint is not None else element.get("default_values")


def describe_property(element):
    """None for values that cannot be set."""
    name, command = element.get("name"), element.get("command") or ""
    if element.get("information_only") == "1" or name in NOT_PROPERTIES or not command:
        return None
    label = element.get("label") or name
    setter = PANEL_COMMANDS.get(command, command)
    described = {"xml": name, "command": setter, "text": text_of(element)}
    if setter == "SetInputArrayToProcess":
        described["name"] = keyword_of_choice(label) if " " in label else snake_case(label)
        array_property(element, described)
    else:
        described["name"] = snake_case(name)
        kind = {"IntVectorProperty": int, "DoubleVectorProperty": float, "IdTypeVectorProperty": int,
                "StringVectorProperty": str}[element.tag]
        count = int(element.get("number_of_elements") or 1)
        default = default_values(element)
        if element.get("si_class") == "vtkSIDataArraySelectionProperty":
            described["kind"], described["default"] = "arrays", []  # describe() adds those of the class
        elif element.get("repeat_command") == "1":
            described["kind"] = "rows"
            described["width"] = int(element.get("number_of_elements_per_command") or 1)
            described["clear"] = element.get("clean_command")
            described["number"] = element.get("set_number_command")
            described["columns"] = [found.get("label") for found in element.iter("ComponentLabel")]
            described["default"] = numbers(default, float)
        elif element.find("EnumerationDomain") is not None:
            described["kind"] = "choice"
            described["choices"] = {keyword_of_choice(entry.get("text")): int(entry.get("value"))
                                    for entry in element.iter("Entry")}
            described["default"] = int(default)
        elif element.find("BooleanDomain") is not None:
            described["kind"] = "bool"
            described["default"] = default not in (None, "", "0")
        elif kind is str:
            described["kind"] = "path" if name == "FileName" else "str"
            described["default"] = default or ""
        else:
            described["kind"] = kind.__name__
            described["count"] = count
            values = numbers(default, kind)
            described["default"] = (values or [kind(0)])[0] if count == 1 else values
            if element.find("ArrayRangeDomain") is not None or element.find("BoundsDomain") is not None:
                described["from_input"] = True # the panel proposes a value from the input
    return described


def describe_proxy(proxy, group, proxies):
    """Inputs, outputs and properties of a proxy and of its base proxies."""
    base = proxies.get(proxy.get("base_proxyname"))
    inherited = describe_proxy(base, group, proxies) if base is not None else None
    inputs = {found["xml"]: found for found in (inherited or {}).get("inputs", [])}
    properties = {found["xml"]: found for found in (inherited or {}).get("properties", [])}
    for element in proxy:
        if element.tag == "InputProperty":
            found = describe_input(element)
            before = inputs.get(found["xml"], {})
            inputs[found["xml"]] = {**before, **found, "text": found["text"] or before.get("text", "")}
        elif element.tag.endswith("VectorProperty"):
            found = describe_property(element)
            if found:
                before = properties.get(found["xml"], {})
                properties[found["xml"]] = {**before, **found, "text": found["text"] or before.get("text", "")}
    ports = sorted(proxy.findall("OutputPort"), key=lambda element: int(element.get("index") or 0))
    outputs = [snake_case(element.get("name").title()) for element in ports]
    documentation = proxy.find("Documentation")
    name = RENAMED_PROXIES.get(proxy.get("name"), proxy.get("name"))
    return {
        "name": snake_case(name), "proxy": proxy.get("name"), "class": proxy.get("class"),
        "label": proxy.get("label"), "kind": {"sources": "reader", "internal_sources": "reader", "writers": "writer"}
        .get(group, "filter"),
        "short": documentation.get("short_help") or "", "text": text_of(proxy),
        "inputs": sorted(inputs.values(), key=lambda found: found["optional"]),
        "outputs": outputs or (inherited or {}).get("outputs", []),
        "properties": list(properties.values()),
        "endings": ["." + ending for ending in panel_files.extensions(proxy)]}


def read_examples(path):
    """Sections `[name]` of lines; those above the first are comments."""
    _, *parts = re.split(r"^\[([a-z_0-9]+)\]\n", path.read_text(), flags=re.MULTILINE)
    examples = {name: code.strip("\n") for name, code in zip(parts[::2], parts[1::2])}
    return examples


def describe(source):
    """All functions, and the extension module of each class."""
    proxies, groups = {}, {}
    for path in sorted((source / "Plugin").glob("*.xml")):
        for group in panel_files.read_panel(path).iter("ProxyGroup"):
            for proxy in group:
                if (proxy.get("class") or "").startswith("vtk") and proxy.get("name") not in SKIPPED:
                    proxies[proxy.get("name")] = proxy
                    groups[proxy.get("name")] = group.get("name")
    examples = read_examples(source / "Wrapping" / "Python" / "function_examples.txt")
    tables = output_arrays.read_tables(source)
    functions = {}
    for name, proxy in proxies.items():
        described = describe_proxy(proxy, groups[name], proxies)
        for found in described["properties"]:
            if found["kind"] == "arrays":
                rows = output_arrays.optional(tables[described["class"]])
                found["arrays"] = {row["name"]: row["text"] + (f", {row['unit']}" if row["unit"] else "")
                                   for row in rows}
                found["default"] = [row["name"] for row in rows if row["choice"] == "on"]
        described["example"] = examples.pop(described["name"], "")
        functions[described["name"]] = described
    if examples:
        sys.exit(f"describe.py: function_examples.txt has examples of no function: {', '.join(examples)}")
    classes = {}
    for kind in ("Filters", "Readers"):
        for path in sorted((source / kind).glob("*/vtk.module")):
            text = (path.parent / "CMakeLists.txt").read_text()
            found = re.search(r"^  CLASSES\n((?:^    vtk\w+\n)+)", text, re.MULTILINE)
            if found and "EXCLUDE_WRAP" not in path.read_text():
                for name in found[1].split():
                    classes[name] = f"vtkIsthmus{kind}{path.parent.name}"
    return {"functions": functions, "classes": classes, "short_names": SHORT_NAMES}


# ---------------------------------------------------------------------------- stubs

TYPES = {"bool": "bool", "int": "int", "float": "float", "str": "str", "path": "str | os.PathLike[str]",
         "choice": "int | str", "array": "str | None", "arrays": "Sequence[str]", "rows": "Sequence[float] | Sequence[Sequence[float]]"}


def default_of(described):
    if described["kind"] == "choice":
        for word, value in described["choices"].items():
            if value == described["default"]:
                return repr(word)
    if described["kind"] == "array":
        return repr(described["default"])
    return repr(tuple(described["default"]) if isinstance(described["default"], list) else described["default"])


def stub_parameters(described):
    parameters = []
    for given in described["inputs"]:
        parameters.append(f"{given['name']}: Data" + (" | None = None" if given["optional"] else ""))
    properties = described["properties"]
    for found in [found for found in properties if found["kind"] == "path"]:
        parameters.append(f"{found['name']}: {TYPES['path']}")
    parameters.append("*")
    for found in [found for found in properties if found["kind"] != "path"]:
        kind = TYPES[found["kind"]] if found.get("count", 1) == 1 else "Sequence[float]"
        parameters.append(f"{found['name']}: {kind} = {default_of(found)}")
    return parameters[:-1] if parameters[-1] == "*" else parameters


def stub(described, short_names):
    result = "Data"
    lines = []
    if described["kind"] == "writer":
        result = "None"
    elif len(described["outputs"]) > 1:
        result = "".join(word.title() for word in described["name"].split("_")) + "Result"
        lines.append(f"class {result}(NamedTuple):")
        lines += [f"    {name}: Data" for name in described["outputs"]]
    wrapped = textwrap.fill(", ".join(stub_parameters(described)), 100, initial_indent="    ",
                            subsequent_indent="    ", break_long_words=False)
    for name in [described["name"]] + [short for short, long in short_names.items() if long == described["name"]]:
        lines.append(f"def {name}(\n{wrapped}\n) -> {result}: ...")
    return "\n".join(lines)


def stubs(table, pipelines):
    lines = ['"""Stubs of isthmus, written by describe.py from the panels of the filters."""',
             "import os", "from typing import Any, Callable, ContextManager, NamedTuple, Sequence", "",
             "# A VTK object, or PyVista's where that is installed, or arrays of numpy.", "Data = Any", "",
             "__version__: str", "",
             "def progress(callback: Callable[[float, str], Any]) -> ContextManager[None]: ..."]
    for described in table["functions"].values():
        lines.append(stub(described, table["short_names"]))
    lines += [f"def {name}({parameters}) -> Data: ..." for name, parameters in pipelines]
    for module in sorted(set(table["classes"].values())):
        names = sorted(name for name, place in table["classes"].items() if place == module)
        lines += [f"from .{module} import {name} as {name}" for name in names]
    return "\n".join(lines) + "\n"


def pipelines_of(source):
    """Names and parameters of the public functions of data_pipelines.py."""
    text = (source / "Wrapping" / "Python" / "isthmus" / "data_pipelines.py").read_text()
    return re.findall(r"^def ([a-z]\w*)\(([^)]*)\):", text, re.MULTILINE)


def main():
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    source, package = map(pathlib.Path, sys.argv[1:3])
    table = describe(source)
    pipelines = pipelines_of(source)
    table["pipelines"] = [name for name, _ in pipelines]
    package.mkdir(parents=True, exist_ok=True)
    (package / "filters.json").write_text(json.dumps(table, separators=(",", ":")) + "\n")
    (package / "__init__.pyi").write_text(stubs(table, pipelines))
    classes = "".join(f'    "{name}": "{module}",\n' for name, module in table["classes"].items())
    init = (source / "Wrapping" / "Python" / "isthmus" / "__init__.py.in").read_text()
    for name, value in (("VERSION", sys.argv[3]), ("VTK", "".join(sys.argv[4:])), ("CLASSES", classes)):
        init = init.replace(f"@{name}@", value)
    (package / "__init__.py").write_text(init)


if __name__ == "__main__":
    main()
