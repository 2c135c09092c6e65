#!/usr/bin/env python3
"""Checks the modules: their declarations, includes and licences.

    check_modules.py [ROOT]

Each folder under Filters and Readers is a VTK module with a vtk.module and a CMakeLists.txt. A header
includes only its own module's headers and those of modules in DEPENDS, a source also those in
PRIVATE_DEPENDS (the compiler also accepts headers of indirect dependencies, this check does not). Algorithm
headers are included as "Folder/X.h", those of VTK classes as "vtkX.h". Neither modules nor the files of
a module have circular dependencies, with X.h and X.cxx as one unit. TEST_DEPENDS names no module that
depends on this one. Every source is listed in
CMakeLists.txt, and every name there is a file. Installed headers (vtkX.h and those under HEADERS)
include no others. No two headers define a class of one name. The modules in PERMISSIVE are built
without CGAL, which is GPL, and so is all that they depend on. Prints one line per violation; the
exit status is 1 if there are any.
"""
import collections
import pathlib
import re
import sys

KINDS = ("Filters", "Readers")
# Modules that a program can link to without the GPL.
PERMISSIVE = ["FiltersCore", "FiltersImaging", "FiltersCurvature", "FiltersSurfaces",
              "FiltersCellComplex", "FiltersAtoms", "FiltersElectrostatics", "ReadersFiles",
              "ReadersMaps", "ReadersPotentials", "ReadersMolecules", "ReadersMeshes"]
HEADINGS = ("DEPENDS", "PRIVATE_DEPENDS", "TEST_DEPENDS")


class Module:
    """A folder with its vtk.module and CMakeLists.txt."""

    def __init__(self, folder):
        self.folder = folder
        self.place = f"{folder.parent.name}/{folder.name}"
        self.name = folder.parent.name + folder.name
        self.headings = words_under_headings(folder / "vtk.module")
        self.listed = words_of_call(folder / "CMakeLists.txt")
        self.files = sorted(path for path in folder.iterdir() if path.suffix in (".h", ".cxx"))
        if "${formats}" in self.listed["SOURCES"]:  # of files, one source each: NAMEFile.cxx
            self.listed["SOURCES"] = self.listed["SOURCES"] - {"${formats}"} | {
                path.stem for path in self.files if path.name.endswith("File.cxx")}

    def declares(self, private):
        """Names of our modules that its sources (`private`) or its headers may include."""
        headings = ("DEPENDS", "PRIVATE_DEPENDS") if private else ("DEPENDS",)
        return {name.removeprefix("Isthmus::") for heading in headings
                for name in self.headings[heading] if name.startswith("Isthmus::")}


def words_under_headings(path):
    found, heading = collections.defaultdict(list), ""
    for line in path.read_text().splitlines() if path.exists() else ():
        if re.fullmatch(r"[A-Z_]+", line):
            heading = line
        elif line.strip():
            found[heading].append(line.strip())
    return found


def words_of_call(path):
    """{keyword: names under it} of the call of isthmus_add_module in a CMakeLists.txt."""
    call = re.search(r"isthmus_add_module\((.*?)\)", path.read_text() if path.exists() else "",
                     re.DOTALL)
    found, heading = collections.defaultdict(set), "NAME"
    for word in re.sub(r"#.*", "", call.group(1) if call else "").split():
        if word in ("CLASSES", "HEADERS", "SOURCES", "CGAL", "LARGE", "VECTORISED"):
            heading = word
        else:
            found[heading].add(word)
    return found


def modules_of(root):
    return [Module(path.parent) for kind in KINDS
            for path in sorted((root / kind).glob("*/vtk.module"))]


def included_names(path):
    return re.findall(r'^\s*#\s*include\s+"([^"]+)"', path.read_text(), re.MULTILINE)


def circles(graph):
    """The strongly connected components of more than one place (R. Tarjan, 1972), each sorted."""
    order, low, path, on_path, found = {}, {}, [], set(), []

    def visit(place):
        order[place] = low[place] = len(order)
        path.append(place)
        on_path.add(place)
        for other in sorted(graph.get(place, ())):
            if other not in order:
                visit(other)
                low[place] = min(low[place], low[other])
            elif other in on_path:
                low[place] = min(low[place], order[other])
        if low[place] == order[place]:
            component = []
            while not component or component[-1] != place:
                component.append(path.pop())
                on_path.discard(component[-1])
            if len(component) > 1:
                found.append(sorted(component))

    for place in sorted(graph):
        if place not in order:
            visit(place)
    return found


def check_lists(module):
    """Files that the CMakeLists.txt does not name, and names without a file."""
    listing, listed = f"{module.place}/CMakeLists.txt", module.listed
    sources = set().union(*(listed[key] for key in ("CLASSES", "SOURCES", "CGAL", "LARGE", "VECTORISED")))
    there = {path.stem for path in module.files if path.suffix == ".cxx"}
    complaints = [f"{listing} lists {name}.h, which does not exist"
                  for name in sorted(listed["HEADERS"]) if not (module.folder / f"{name}.h").exists()]
    complaints += [f"{module.place}/{name}.cxx is not in {listing}" for name in sorted(there - sources)]
    complaints += [f"{listing} lists {name}, which does not exist" for name in sorted(sources - there)]
    if listed["NAME"] != {f"Isthmus::{module.name}"} or module.headings["NAME"] != [
            f"Isthmus::{module.name}"]:
        complaints.append(f"{module.place} is not named Isthmus::{module.name}")
    return complaints


def check_includes(module, owners, installed):
    """(complaints, includes checked, {concept: concepts of this module it includes})"""
    complaints, looked_at, graph = [], 0, collections.defaultdict(set)
    for path in module.files:
        place = f"{module.place}/{path.name}"
        for included in included_names(path):
            folder, _, name = included.rpartition("/")
            if name not in owners:
                continue
            looked_at += 1
            owner = owners[name]
            form = name if name.startswith("vtk") else f"{owner.folder.name}/{name}"
            if included != form:
                complaints.append(f'{place} includes "{included}": write "{form}"')
            if owner is module:
                if path.stem != pathlib.Path(name).stem:
                    graph[path.stem].add(pathlib.Path(name).stem)
            elif owner.name not in module.declares(private=path.suffix == ".cxx"):
                heading = "DEPENDS" if path.suffix == ".h" else "PRIVATE_DEPENDS"
                complaints.append(f"{place} includes {name} of {owner.name}, "
                                  f"which is not in {heading} of {module.place}/vtk.module")
            if path.name in installed and name not in installed:
                complaints.append(f"{place} is installed and includes {name}, which is not")
    return complaints, looked_at, graph


def check_unused(module, owners):
    """Modules that are declared and not included."""
    used = {owners[name.rpartition("/")[2]].name for path in module.files
            for name in included_names(path) if name.rpartition("/")[2] in owners}
    return [f"{module.place}/vtk.module declares Isthmus::{name}, of which it includes nothing"
            for name in sorted(module.declares(private=True) - used)]


def check_tests(modules):
    """Modules that TEST_DEPENDS names although they depend on the module."""
    by_name = {module.name: module for module in modules}

    def needed(name, seen):
        for other in by_name[name].declares(private=True) - seen if name in by_name else ():
            seen.add(other)
            needed(other, seen)
        return seen

    return [f"{module.place}/vtk.module: {name} of TEST_DEPENDS depends on {module.name}: such tests are those of "
            f"{name}, or of Testing/Integration"
            for module in modules for name in sorted(word.removeprefix("Isthmus::") for word in module.headings["TEST_DEPENDS"])
            if module.name in needed(name, set())]


def check_licences(modules):
    """PERMISSIVE modules that need CGAL, by themselves or by what they depend on."""
    by_name = {module.name: module for module in modules}
    complaints = []
    for name in PERMISSIVE:
        todo, seen = [name] if name in by_name else [], set()
        while todo:
            other = todo.pop()
            if other in seen or other not in by_name:
                continue
            seen.add(other)
            module = by_name[other]
            todo += module.declares(private=True)
            files = [path.name for path in module.files
                     if re.search(r"#\s*include\s*<(CGAL/|gmp|mpfr)", path.read_text())]
            if files or module.listed["CGAL"] or module.listed["LARGE"]:
                complaints.append(f"{name} is to be free of CGAL, but {other} has it")
    return complaints


def classes_of(path):
    """Names of the classes that a header defines in the namespace itself, not within another."""
    text = re.sub(r"//[^\n]*|/\*.*?\*/", "", path.read_text(), flags=re.DOTALL)
    found = re.finditer(r"\b(?:struct|class)\s+(?:VTKISTHMUS\w*_EXPORT\s+)?(\w+)\s*(?:final\s*)?"
                        r"(?::[^;{()]*)?\{", text)
    return [match.group(1) for match in found
            if text[:match.start()].count("{") - text[:match.start()].count("}") == 1]


def check_names(headers):
    """Classes that two headers define, each of them in namespace isthmus."""
    places = collections.defaultdict(set)
    for path in headers:
        for name in classes_of(path):
            places[name].add(path.name)
    return [f"class {name} is defined in " + " and in ".join(sorted(names))
            for name, names in sorted(places.items()) if len(names) > 1]


def check(root):
    """All complaints about the tree under `root`, and the number of includes checked."""
    modules = modules_of(root)
    complaints, owners = [], {}
    folders = {module.folder for module in modules}
    for kind in KINDS:
        for path in sorted((root / kind).rglob("*")):
            if path.suffix in (".h", ".cxx") and path.parent not in folders:
                complaints.append(f"{path.relative_to(root)} is in no module")
    for module in modules:
        for path in module.files:
            if path.name in owners:
                complaints.append(f"{path.name} is in {owners[path.name].place} and in {module.place}")
            owners[path.name] = module
    installed = {f"{name}.h" for module in modules for name in module.listed["HEADERS"]}
    installed |= {name for name in owners if re.match(r"vtk.*\.h$", name)}

    looked_at = 0
    for module in modules:
        found, count, graph = check_includes(module, owners, installed)
        looked_at += count
        complaints += found + check_unused(module, owners) + check_lists(module)
        complaints += [f"a circle of includes in {module.place}: " + ", ".join(circle)
                       for circle in circles(graph)]
    complaints += ["a circle of modules: " + ", ".join(circle) for circle in circles(
        {module.name: module.declares(private=True) for module in modules})]
    complaints += check_tests(modules) + check_licences(modules)
    complaints += check_names(path for module in modules for path in module.files
                              if path.suffix == ".h")
    return complaints, looked_at


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1])
    complaints, looked_at = check(root)
    if looked_at == 0:
        complaints.append(f"no include of a header of ours was found under {root}")
    for complaint in complaints:
        print(complaint)
    print(f"{looked_at} includes checked, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
