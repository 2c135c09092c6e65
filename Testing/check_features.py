#!/usr/bin/env python3
"""Checks the table of the thesis' features, thesis_features.tsv.

    check_features.py [ROOT [SPECIFICATION]]

- Each core and each described feature of the thesis has one row (those that it only mentions have none), in
  the order of the ids.
- `status` is "whole", "whole: ON WHAT" (where named data stand in for those of the thesis), "partial: WHAT IS
  MISSING", "missing: WHAT" or "not built: WHY IT TEACHES NOTHING". What is whole has code and a test.
- `code` names files of Filters and Readers, with or without vtk: Name or Name:IDENTIFIER, which the file has, or
  paths such as Examples/curvature.py.
- `panel` names proxies of Plugin/*.xml: Proxy or Proxy.Property.
- `python` names VTK classes, which Python has: vtkClass or vtkClass.Property, for which its header has Set, Get or
  a macro; or paths.
- `test` names tests of Unit (Suite.Test), of Python (Python.File), and benchmarks (BenchName).
- Several names are divided by ", "; "-" is none.

With the SPECIFICATION (spec.md, which is not part of the repository), ids and kinds are compared with it.
Prints one line per error and the counts; the exit status is 1 if there are any errors.
"""
import collections
import pathlib
import re
import sys

COLUMNS = ["id", "kind", "status", "code", "panel", "python", "test"]
KINDS = {"core": 141, "described": 67}
FEATURES = {1: 4, 2: 24, 3: 33, 4: 69, 5: 50, 6: 47}
MENTIONED = set("F1.02 F1.03 F1.04 F3.30 F3.31 F3.32 F3.33 F4.17 F4.19 F4.24 F4.30 F4.66 F4.69 F5.16 F5.24 "
                "F6.30 F6.31 F6.43 F6.44".split())
IDS = [id_ for chapter, last in FEATURES.items() for number in range(1, last + 1)
       if (id_ := f"F{chapter}.{number:02}") not in MENTIONED]
STATUS = re.compile(r"whole(: .+)?|(partial|missing|not built): .+")


class Names:
    """All that a row may name."""

    def __init__(self, root):
        self.root = root
        self.files = collections.defaultdict(list)
        for folder in ("Filters", "Readers"):
            for path in sorted((root / folder).rglob("*")):
                if path.suffix in (".h", ".cxx"):
                    self.files[path.stem].append(path)
        self.proxies = {}
        for path in sorted((root / "Plugin").glob("*.xml")):
            for proxy in re.findall(r"<(?:Source|Writer)Proxy\b.*?</(?:Source|Writer)Proxy>", path.read_text(), re.DOTALL):
                name = re.search(r'\bname="(\w+)"', proxy)[1]
                properties = re.findall(r'<\w+Property\b[^>]*?\bname="(\w+)"', proxy)
                self.proxies.setdefault(name, set()).update(properties)
        self.tests = set()
        for path in sorted([*(root / "Testing/Unit").rglob("*.cxx"), *(root / "Testing/Integration").glob("*.cxx")]):
            self.tests |= {f"{suite}.{test}" for suite, test in
                           re.findall(r"^TEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\)", path.read_text(), re.MULTILINE)}
        self.tests |= {f"Python.{path.stem}" for path in (root / "Testing/Python").glob("[A-Z]*.py")}
        self.tests |= {path.stem for path in (root / "Testing/Benchmarks").glob("Bench*.cxx")}

    def code(self, name):
        if "/" in name:
            return (self.root / name).is_file()
        file, _, identifier = name.partition(":")
        return file in self.files and (not identifier or any(
            re.search(rf"\b{identifier}\b", path.read_text()) for path in self.files[file]))

    def panel(self, name):
        proxy, _, entry = name.partition(".")
        return proxy in self.proxies and (not entry or entry in self.proxies[proxy])

    def python(self, name):
        if "/" in name:
            return (self.root / name).is_file()
        wrapped, _, entry = name.partition(".")
        headers = [path for path in self.files.get(wrapped, []) if path.suffix == ".h"]
        declared = rf"\b(?:vtk\w*Macro|ISTHMUS_\w+)\(\s*(?:[\w.]+,\s*)?{entry}\b|\b[SG]et{entry}\("
        return wrapped.startswith("vtk") and bool(headers) and (
            not entry or any(re.search(declared, self.declarations(path)) for path in headers))

    def declarations(self, path):
        """A header, and those of ours that it includes: properties that several classes share are there."""
        text = path.read_text()
        for stem in re.findall(r'#include "(?:\w+/)?(\w+)\.h"', text):
            text += "".join(other.read_text() for other in self.files.get(stem, []) if other.suffix == ".h")
        return text

    def test(self, name):
        return name in self.tests


def rows_of(path):
    """(number of the line, its fields) of each line that is not a comment."""
    return [(number, line.split("\t")) for number, line in enumerate(path.read_text().splitlines(), 1)
            if line and not line.startswith("#")]


def check_row(row, names):
    if row["kind"] not in KINDS:
        yield f"{row['kind']!r} is neither core nor described"
    if not STATUS.fullmatch(row["status"]):
        yield f"the status {row['status']!r} is none, or has no reason"
    for column in COLUMNS[3:]:
        found = [] if row[column] == "-" else row[column].split(", ")
        if not found and row["status"].startswith("whole") and column in ("code", "test"):
            yield f"it is whole, but names no {column}"
        for name in found:
            if not getattr(names, column)(name):
                yield f"there is no {name} ({column})"


def check_ids(rows):
    found = [row["id"] for row in rows]
    for id_, count in collections.Counter(found).items():
        if count > 1:
            yield f"{id_} has {count} rows"
        if id_ not in IDS:
            yield f"{id_} is not a feature of the thesis"
    yield from (f"{id_} has no row" for id_ in IDS if id_ not in found)
    if sorted(found) != found:
        yield "the rows are not in the order of their ids"
    for kind, expected in KINDS.items():
        count = sum(row["kind"] == kind for row in rows)
        if count != expected:
            yield f"{count} rows are {kind}, not {expected}"


def check_specification(rows, text):
    kinds = {id_: level.split()[0] for id_, level in re.findall(r"^\| (F\d\.\d\d) \|.*\| (\w+[^|]*) \|$", text, re.MULTILINE)}
    if sorted(id_ for id_, kind in kinds.items() if kind in KINDS) != IDS:
        yield "the specification has other ids than this script"
    for row in rows:
        if row["kind"] != kinds.get(row["id"]):
            yield f"{row['id']} is {row['kind']} here, {kinds.get(row['id'])} in the specification"


def counts(rows):
    """Lines of a table: how many rows of each kind have each status."""
    states = ("whole", "partial", "missing", "not built")
    for kind in KINDS:
        of_kind = [row["status"] for row in rows if row["kind"] == kind]
        numbers = [sum(status.startswith(state) for status in of_kind) for state in states]
        named = sum(status.startswith("whole: ") for status in of_kind)
        yield (f"{kind}: {len(of_kind)}, " +
               ", ".join(f"{state} {number}" for state, number in zip(states, numbers)) +
               f" (of the whole ones {named} with a remark)")


def check(root, specification=None):
    """All complaints about the table under `root`, and its rows."""
    (_, header), *lines = rows_of(root / "Testing/thesis_features.tsv")
    if header != COLUMNS:
        return [f"the columns are {header}, not {COLUMNS}"], []
    complaints = [f"line {number} has {len(fields)} fields, not {len(COLUMNS)}"
                  for number, fields in lines if len(fields) != len(COLUMNS)]
    rows = [dict(zip(COLUMNS, fields)) for _, fields in lines if len(fields) == len(COLUMNS)]
    names = Names(root)
    complaints += check_ids(rows)
    complaints += [f"{row['id']}: {complaint}" for row in rows for complaint in check_row(row, names)]
    if specification:
        complaints += check_specification(rows, specification.read_text())
    return [f"Testing/thesis_features.tsv: {complaint}" for complaint in complaints], rows


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1])
    complaints, rows = check(root, pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None)
    for complaint in complaints:
        print(complaint)
    print("\n".join(counts(rows)))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
