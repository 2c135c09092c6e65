#!/usr/bin/env python3
"""Checks that the properties of all vtk classes follow one policy.

    check_properties.py [ROOT]

In the headers of vtk classes and property macros (Filters, Readers) and in the panels (Plugin/*.xml):

- a switch is a `bool` with vtkSetMacro, vtkGetMacro and vtkBooleanMacro, never a vtkTypeBool;
- an isovalue is `Level`, in classes and panels;
- which side of an isosurface is inside is `InsideIsHigher`;
- memory is given in MiB, never in MB;
- enumerators are in PascalCase (`ByArea`), names of programs and formats as they are written elsewhere;
- a property with a setter has a getter; one of the parameters that is a bool is an ISTHMUS_PARAMETER_SWITCH.

Prints one line per error; the exit status is 1 if there are any.
"""
import pathlib
import re
import sys

MACRO = re.compile(r"\bvtk(Set|Get|Boolean)(\w*?)Macro\(\s*(\w+)\s*(?:,\s*([\w:]+))?")
# ISTHMUS_PARAMETER, _OF, _SWITCH, _SWITCH_OF, _VECTOR3 (FilterProperties.h): the kind and the arguments.
PARAMETER = re.compile(r"\bISTHMUS_PARAMETER(\w*)\(([^()]*)\)")
ENUM = re.compile(r"\benum\b[^{;]*\{([^}]*)\}")
ACRONYMS = {"AMBER", "CGAL", "GRO", "MMCIF", "MOL2", "PARSE", "PDB", "PDBQT", "PQR", "SDF", "XYZ"}
# Levels of a filtration and of an isosurface: only the latter have an inside.
FILTRATIONS = {"vtkScalarPersistence.h"}
OTHER_NAMES = re.compile(r"IsoValue|Isovalue|ContourValue")


def check_header(name, text):
    """Complaints about one header, and how many properties it has."""
    where = name.as_posix()
    complaints = []
    found = {"Set": {}, "Get": {}, "Boolean": {}}
    for match in MACRO.finditer(text):
        found[match[1]][match[3]] = match[4]
    for match in PARAMETER.finditer(text):
        is_switch = "_SWITCH" in match[1]
        words = match[2].split(", ")[1 if match[1].endswith("_OF") else 0:]
        for kind in ("Set", "Get", *["Boolean"] * is_switch):
            found[kind][words[0]] = "bool" if is_switch else words[1]
    for number, line in enumerate(text.split("\n"), 1):
        if re.search(r"\bvtkTypeBool\b", line) and "ProcessRequest" not in line:
            complaints.append(f"{where}:{number} has a vtkTypeBool: use bool")
        if re.search(r"\bMB\b", line):
            complaints.append(f"{where}:{number} has MB: give memory in MiB")
    for property_name, kind in found["Set"].items():
        if property_name not in found["Get"]:
            complaints.append(f"{where}: {property_name} can be set but not read")
        if (kind == "bool") != (property_name in found["Boolean"]):
            complaints.append(f"{where}: {property_name} is a {kind}: vtkBooleanMacro belongs to bool, "
                              "and to every bool")
        if OTHER_NAMES.search(property_name):
            complaints.append(f"{where}: {property_name} is an isovalue: name it Level")
        if property_name == "Superlevel" and name.name not in FILTRATIONS:
            complaints.append(f"{where}: Superlevel says which side is inside: name it InsideIsHigher")
    for match in re.finditer(r"\b[SG]et(\w*(?:IsoValue|Isovalue)\w*)\(", text):
        complaints.append(f"{where}: {match[0][:-1]}() is of an isovalue: name it Level")
    for match in ENUM.finditer(text):
        body = re.sub(r"//[^\n]*", "", match[1])
        for enumerator in body.split(","):
            words = re.match(r"\s*(\w+)", enumerator)
            if not words or words[1] in ACRONYMS:
                continue
            if "_" in words[1] or not re.match(r"[A-Z]\w*[a-z]", words[1]):
                complaints.append(f"{where}: the enumerator {words[1]} is not in PascalCase")
    return complaints, len(found["Set"])


def check_macros(name, text):
    """Complaints about a header of properties that several classes share (FilterProperties.h)."""
    complaints = []
    shared = re.findall(r"ISTHMUS_(PROPERTY|SWITCH)\((\w+)(?:, (\w+))?(?:, [^)]*)?\)", text)
    for kind, first, second in shared:
        if kind == "PROPERTY" and first in ("bool", "vtkTypeBool") and second != "name":
            complaints.append(f"{name.as_posix()}: {second} is on or off: use ISTHMUS_SWITCH")
    return complaints, len(shared)


def check_panel(name, text):
    complaints = []
    for word in re.findall(r'\b(?:name|command)="(\w+)"', text):
        if OTHER_NAMES.search(word):
            complaints.append(f"{name.as_posix()}: {word} is of an isovalue: name it Level")
    if re.search(r"\bMB\b", text):
        complaints.append(f"{name.as_posix()} has MB: give memory in MiB")
    return complaints


def check(root):
    """All complaints about the tree under `root`, and how many properties were looked at."""
    complaints, count = [], 0
    for kind in ("Filters", "Readers"):
        for path in sorted(root.glob(f"{kind}/*/*.h")):
            text = path.read_text()
            name = path.relative_to(root)
            if path.name.startswith("vtk"):
                found, number = check_header(name, text)
            elif "ISTHMUS_SWITCH(" in text or "ISTHMUS_PROPERTY(" in text:
                found, number = check_macros(name, text)
            else:
                continue
            complaints += found
            count += number
    for path in sorted(root.glob("Plugin/*.xml")):
        complaints += check_panel(path.relative_to(root), path.read_text())
    return complaints, count


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1])
    complaints, count = check(root.resolve())
    if count == 0:
        complaints.append(f"no header under {root} has properties")
    for complaint in complaints:
        print(complaint)
    print(f"{count} properties looked at, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
