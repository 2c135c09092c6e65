#!/usr/bin/env python3
"""Checks that where ids of two kinds meet in one function, their types differ.

    check_handles.py [ROOT]

Reads the headers and sources of the library (Filters, Readers). Of each signature (declaration,
definition, function type, lambda) it takes the parameters that are plain integers, signed or not,
by value or by reference, an alias of one or a template's own id type, and sorts them by the last word
of their names into kinds of ids. Two kinds in one signature could be exchanged by mistake
without an error: use the handles of Filters/Core/Handles.h (or of the module) for them. Handles are not
plain integers, so a signature with handles passes.

Prints one line per error; the exit status is 1 if there are any.
"""
import pathlib
import re
import sys

# Kinds by the last word of a parameter's name, in singular; letters stand for what they do in the
# library. No ids are: sizes and counts; coordinates (i, j, k, row, column, plane, section, axis,
# direction, level of a grid); ends of a range (first, last, begin, end); numbers within one thing
# (side, place, stage); `order`, which is a whole list or a value as an integer; and what has
# no kind (id, index, a, b, from, to, other).
KINDS = {
    "point": ("point", "vertex", "site", "sample", "anchor", "contact", "corner", "p", "q", "v"),
    "edge": ("edge", "segment", "pivot", "e"),
    "half edge": ("halfedge", "half", "h"),
    "triangle": ("triangle", "face", "facet", "choke", "t"),
    "cell": ("cell", "tetrahedron", "cube", "voxel"),
    "dart": ("dart",),
    "simplex": ("simplex",),
    "rank": ("rank", "position", "limit"),
    "node": ("node",),
    "feature": ("feature", "pair", "bar"),
    "atom": ("atom", "ball"),
    "region": ("region", "component", "label", "basin", "pocket"),
    "loop": ("loop", "chain", "cycle"),
    "brick": ("brick",),
    "species": ("species",),
    "frame": ("frame",),
    "residue": ("residue",),
    "track": ("track",),
}
INTEGERS = {"int", "unsigned", "long", "short", "size_t", "ptrdiff_t", "vtkIdType", "vtkTypeInt64",
            "vtkTypeUInt64", "vtkTypeInt32", "vtkTypeUInt32"} | {
                f"{sign}int{bits}_t" for sign in ("", "u") for bits in (8, 16, 32, 64)}
# {file:function: why its ids stay plain}
EXCEPTIONS = {
}

NO_FUNCTIONS = {"if", "for", "while", "switch", "return", "catch", "sizeof", "decltype", "alignas"}
NO_TYPES = {"return", "new", "delete", "const", "throw", "typename"}  # an argument, so a call
KIND_OF = {word: kind for kind, words in KINDS.items() for word in words}
NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*',
                   re.DOTALL | re.MULTILINE)
HEAD = re.compile(r"([A-Za-z_~]\w*|\]|operator\S{1,3})\s*\(")
PARAMETER = re.compile(r"(?:const\s+)?([\w:]+(?:\s+(?:int|long|const))*)\s*&{0,2}\s*\b(\w+)(?:\s*=.*)?$",
                       re.DOTALL)


def code_of(text):
    """`text` without comments, strings and preprocessor lines; lines stay where they are."""
    return NOISE.sub(lambda match: "\n" * match.group().count("\n") or " ", text)


def split_top(text):
    """Parts of a parameter list between its own commas."""
    parts, depth, start = [], 0, 0
    for i, char in enumerate(text):
        if char in "(<[{":
            depth += 1
        elif char in ")]}" or (char == ">" and text[i - 1] != "-"):
            depth -= 1
        elif char == "," and depth == 0:
            parts.append(text[start:i])
            start = i + 1
    return [part.strip() for part in parts + [text[start:]]]


def closing(text, start):
    """Place of the bracket that closes the one at `start`, or -1."""
    depth = 0
    for i in range(start, len(text)):
        depth += {"(": 1, ")": -1}.get(text[i], 0)
        if depth == 0:
            return i
    return -1


def kind_of(name):
    """The kind of id that a parameter of this name is, or None."""
    if re.search(r"^(?:numberOf|n[A-Z]|max|min)|(?:Count|Size)$", name):
        return None
    word = re.findall(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])", name)
    return KIND_OF.get(word[-1].lower()) if word else None


def plain_types(codes):
    """Names of all types that are integers by another name."""
    plain, aliases = set(INTEGERS), []
    for code in codes:
        aliases += re.findall(r"\busing\s+(\w+)\s*=\s*(?:\w+::)*(\w+(?:\s+(?:int|long))*)\s*;", code)
    for _ in range(3):
        plain |= {name for name, of in aliases if set(of.split()) <= plain}
    return plain


def template_ids(code):
    """Type parameters of templates that stand for integers, by their names."""
    return set(re.findall(r"\btypename\s+(\w*(?:Id|Index|Integer))\b", code))


def signatures_of(code):
    """[(name, line, [(type, parameter)])] of what has named parameters in `code`."""
    found = []
    for head in HEAD.finditer(code):
        name = head.group(1)
        end = closing(code, head.end() - 1)
        if name in NO_FUNCTIONS or end < 0:
            continue
        parts = (PARAMETER.match(part) for part in split_top(code[head.end():end]))
        parameters = [match.groups() for match in parts
                      if match and match.group(1) not in NO_TYPES]
        if parameters:
            found.append((name, code.count("\n", 0, head.start()) + 1, parameters))
    return found


def check(root, exceptions=None):
    """Complaints about the tree under `root`, and how many signatures were looked at."""
    unused = set(EXCEPTIONS if exceptions is None else exceptions)
    excepted = set(unused)
    codes = {path.relative_to(root).as_posix(): code_of(path.read_text())
             for folder in ("Filters", "Readers") for path in sorted((root / folder).rglob("*"))
             if path.suffix in (".h", ".cxx")}
    plain, complaints, looked_at = plain_types(codes.values()), [], 0
    for place, code in codes.items():
        integers = plain | template_ids(code)
        for name, line, parameters in signatures_of(code):
            looked_at += 1
            ids = [(parameter, kind_of(parameter)) for type_, parameter in parameters
                   if {word.split("::")[-1] for word in type_.split()} <= integers]
            kinds = sorted({kind for _, kind in ids if kind})
            if len(kinds) < 2:
                continue
            function = "lambda" if name == "]" else name
            what = f"{place}:{function}"
            if what in excepted:
                unused.discard(what)
                continue
            names = ", ".join(parameter for parameter, kind in ids if kind)
            complaints.append(f"{place}:{line} {function}({names}) takes plain integers for ids "
                              f"of {' and '.join(kinds)}")
    complaints += [f"EXCEPTIONS in check_handles.py needs no entry for {what}" for what in sorted(unused)]
    return complaints, looked_at


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1])
    complaints, looked_at = check(root)
    if looked_at == 0:
        complaints.append(f"no signature was found under {root}")
    for complaint in complaints:
        print(complaint)
    print(f"{looked_at} signatures looked at, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
