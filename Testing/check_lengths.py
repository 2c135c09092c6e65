#!/usr/bin/env python3
"""Checks that no file of the library is over 350 lines and no function of it over 60.

    check_lengths.py [ROOT]

Functions are found by the layout that clang-format gives them (Allman braces, namespaces not
indented): a body begins with a brace alone on its line, at the margin or within a class, and ends
with the brace below it; its length counts from the line of its name. OWED lists what is still longer,
and how long it may be until it is split; nothing may be added. Entries that are no longer needed are
told. Prints what is wrong, a line each, and ends with 1 then.
"""
import pathlib
import re
import sys

LONGEST_FILE = 350
LONGEST_FUNCTION = 60

# {file or file:function: lines it may have until it is split}, all in rooms that are being rebuilt
OWED = {
}

BEGIN = re.compile(r"^( *)\{$")
SCOPE = re.compile(r"^\s*(?:template\b.*>\s*)?(?:inline\s+)?"
                   r"(?:namespace|class|struct|union|enum|extern)\b(?![^;{]*\)\s*(?:const)?$)")


def heading_above(lines, brace):
    """(first line, text) of what stands before the brace on line `brace`, both from 0."""
    first = brace
    while first > 0 and lines[first - 1].strip() and not re.search(
            r"[;{}]$|^\s*(?://|\*|#|public:|private:|protected:)|^\s*///|\*/$", lines[first - 1]):
        first -= 1
    return first, " ".join(line.strip() for line in lines[first:brace])


def functions_of(text):
    """[(name, first line from 1, number of lines)] of the function bodies of a C++ file."""
    lines = text.split("\n")
    found, scopes, line = [], {0}, 0
    while line < len(lines):
        begin = BEGIN.match(lines[line])
        if not begin or len(begin.group(1)) not in scopes:
            line += 1
            continue
        indent = begin.group(1)
        first, heading = heading_above(lines, line)
        if SCOPE.match(heading) or heading.startswith(("namespace", "template <typename")) and (
                re.search(r"> *(?:class|struct)\b", heading)):
            if not heading.startswith("namespace"):
                scopes.add(len(indent) + 2)
            line += 1
            continue
        end = line
        while end < len(lines) - 1 and not re.match(rf"^{indent}\}}", lines[end]):
            end += 1
        name = re.search(r"([\w:~]+|operator\S+)\s*\(", heading)
        if name:
            found.append((name.group(1), first + 1, end - first + 1))
        line = end + 1
    return found


def check(root, owed=None):
    """Complaints about the tree under `root`, entries of OWED not needed, functions measured."""
    owed = dict(OWED if owed is None else owed)
    complaints, done, measured = [], [], 0

    def demand(what, place, length, limit):
        allowed = owed.pop(what, 0)
        if length > max(limit, allowed):
            complaints.append(f"{place} has {length} lines, over {max(limit, allowed)}: split it")
        elif allowed and length <= limit:
            done.append(what)

    for folder in ("Filters", "Readers", "Plugin"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".h", ".cxx"):
                continue
            text, place = path.read_text(), path.relative_to(root).as_posix()
            demand(place, place, text.count("\n"), LONGEST_FILE)
            for name, first, length in functions_of(text):
                measured += 1
                demand(f"{place}:{name}", f"{place}:{first} {name}()", length, LONGEST_FUNCTION)
    return complaints, done + list(owed), measured


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1])
    complaints, done, measured = check(root)
    if measured == 0:
        complaints.append(f"no function was found under {root}")
    for complaint in complaints:
        print(complaint)
    for what in done:
        print(f"OWED in check_lengths.py needs no entry for {what}")
    print(f"{measured} functions measured, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
