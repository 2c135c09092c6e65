#!/usr/bin/env python3
"""Checks that names in comments exist, and that headers document what is thrown.

    check_contracts.py [ROOT]

In comments of the library (Filters, Readers, Plugin):

- a function `Name()` is declared or called by the file, by what it includes, or by what includes it;
  written `Owner::Name()`, or followed by its header in brackets, it may be anywhere in the tree;
- a file `Name.h`, `Name.cxx`, `Name.py`, `Name.md` exists in the tree or, for a header, among those
  that our code includes; this also applies to pages (*.md).

A header of an algorithm whose code throws documents it with @throws. Prints one line per error; the exit
status is 1 if there are any.
"""
import pathlib
import re
import sys

SOURCES = (".h", ".cxx")
STRING = r'"(?:\\.|[^"\\\n])*"'
COMMENT = r"//[^\n]*|/\*.*?\*/"
FUNCTION = re.compile(r"\b((?:\w+(?:::|\.|->))*)([A-Za-z_]\w*)\(\)(?=(?:[^\w(]*\((\w+\.h)\))?)")
FILE = re.compile(
    r"(?<![\w.*<>{}-])((?:[\w.-]+/)*[A-Za-z_]\w*\.(?:h|cxx|py|md|sh|cmake))(?![\w*(])")
CALL = re.compile(r"\b([A-Za-z_]\w*)\s*(?:<[^<>;(){}]*>)?\s*\(")
MACRO = re.compile(r"\bvtk(Get|Set|Boolean)\w*Macro\(\s*(\w+)")
PARAMETER = re.compile(r"\bISTHMUS_PARAMETER\w*\(([^()]*)\)")  # FilterProperties.h
# What stands for any name on the pages that say how files are named.
PLACEHOLDERS = re.compile(r"(?:Test|Bench|vtk)?(?:X|NAME)\.\w+$")
# Rooms whose headers still tell what they throw in prose alone; none may be added.
UNTOLD = {"Filters/Atoms", "Filters/ChokingLoops", "Filters/Electrostatics",
          "Filters/MolecularSurfaces", "Filters/Persistence", "Filters/Pockets"}


def parts_of(text):
    """(code, [(line, comment)]) of a C++ file; what looks like a comment in a string is none."""
    comments = []

    def take(match):
        if match.group()[0] == '"':
            return match.group()
        comments.append((text.count("\n", 0, match.start()) + 1, match.group()))
        return " "

    return re.sub(f"{STRING}|{COMMENT}", take, text, flags=re.DOTALL), comments


def functions_in(code):
    """Names that `code` declares, calls, or has made by VTK's macros."""
    made = {"Get": "Get{}", "Set": "Set{}", "Boolean": "{}On"}
    parameters = {kind + name for arguments in PARAMETER.findall(code)
                  for name in re.findall(r"\w+", arguments) for kind in ("Set", "Get")}
    return set(CALL.findall(code)) | parameters | {
        made[kind].format(name) for kind, name in MACRO.findall(code)}


class Tree:
    """What the tree has: names of files, and for each C++ file its functions, includes, comments."""

    def __init__(self, root):
        self.root = root
        built = {path.parent for path in root.glob("*/CMakeCache.txt")}
        self.files = sorted(path for path in root.rglob("*") if path.is_file()
                            and ".git" not in path.parts and not built & set(path.parents))
        self.names = {path.name for path in self.files}
        self.code, self.comments, self.functions = {}, {}, {}
        for path in self.files:
            if path.suffix in SOURCES:
                code, comments = parts_of(path.read_text(errors="replace"))
                self.code[path], self.comments[path] = code, comments
                self.functions[path] = functions_in(code)
                self.names |= set(re.findall(r'#\s*include\s*[<"](?:[^>"]*/)?([^/>"]+)[>"]', code))
        headers = {path.name: path for path in self.code if path.suffix == ".h"}
        self.includes = {path: {headers[name] for name in
                                re.findall(r'#\s*include\s*"(?:[^"]*/)?([^"/]+)"', code) if name in headers}
                         for path, code in self.code.items()}
        self.everywhere = set().union(*self.functions.values(), *(
            functions_in(path.read_text(errors="replace"))
            for path in self.files if path.suffix in (".py", ".xml")))

    def pair_of(self, path):
        return {path.with_suffix(suffix) for suffix in SOURCES} & self.code.keys()

    def near(self, path):
        """Functions known where `path` is: in its pair, what that includes, and who includes it."""
        seen, todo = set(), self.pair_of(path) | {p for p in self.code if path in self.includes[p]}
        while todo:
            place = todo.pop()
            seen.add(place)
            for header in self.includes[place]:
                todo |= self.pair_of(header) - seen
        return set().union(*(self.functions[place] for place in seen))


def missing_names(tree):
    """Complaints about names in comments and pages, and how many names were looked up."""
    complaints, looked_up = [], 0
    passages = [(path, 1, path.read_text()) for path in tree.files if path.suffix == ".md"]
    for path, comments in tree.comments.items():
        if path.relative_to(tree.root).parts[0] in ("Filters", "Readers", "Plugin"):
            passages += [(path, line, text) for line, text in comments]
    for path, first, text in passages:
        known = None
        names = []
        for match in FUNCTION.finditer(text) if path in tree.code else ():
            if known is None:
                known = tree.near(path)
            anywhere = match.group(1) or match.group(3)
            found = match.group(2) in (tree.everywhere if anywhere else known)
            names.append((match, match.group(1) + match.group(2) + "()", found))
        for match in FILE.finditer(text):
            name = pathlib.PurePath(match.group(1)).name
            found = name in tree.names or (path.suffix == ".md" and PLACEHOLDERS.match(name))
            names.append((match, match.group(1), found))
        looked_up += len(names)
        complaints += [f"{path.relative_to(tree.root)}:{first + text.count(chr(10), 0, match.start())}"
                       f" names {name}, which is not there" for match, name, found in names if not found]
    return complaints, looked_up


def untold_errors(tree):
    """Complaints about headers whose code throws and whose comments have no @throws."""
    complaints = []
    for path, comments in tree.comments.items():
        place = path.relative_to(tree.root)
        module = place.parent.as_posix()
        if path.suffix != ".h" or place.parts[0] not in ("Filters", "Readers"):
            continue
        if module in UNTOLD or path.name.startswith("vtk"): # VTK's classes turn them into messages
            continue
        throws = any(re.search(r"\bthrow\s+\w", tree.code[half]) for half in tree.pair_of(path))
        if throws and not any("@throws" in text for _, text in comments):
            complaints.append(f"{place} or its source throws, and no @throws tells it")
    return complaints


def check(root):
    """All complaints about the tree under `root`, and how many names were looked up."""
    tree = Tree(root)
    complaints, looked_up = missing_names(tree)
    return complaints + untold_errors(tree), looked_up


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1])
    complaints, looked_up = check(root.resolve())
    if looked_up == 0:
        complaints.append(f"no comment under {root} names a function or a file")
    for complaint in complaints:
        print(complaint)
    print(f"{looked_up} names looked up, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
