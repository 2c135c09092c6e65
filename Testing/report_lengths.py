#!/usr/bin/env python3
"""Reports how the library is divided into files: a report, not a check; nothing fails.

    report_lengths.py [ROOT] [--longest N]

Number of files, mean and median of their lines, how many have fewer than 60, includes that cross modules,
and the N longest files and functions (default 10). Functions are found by the layout that clang-format
gives them (Allman braces, namespaces not indented): a body begins with a brace alone on its line, at
the margin or within a class, and ends with the brace below it; its length counts from the line of its
name.
"""
import argparse
import pathlib
import re
import statistics

FOLDERS = ("Filters", "Readers")
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


def library_files(root):
    return [path for folder in FOLDERS for path in sorted((root / folder).rglob("*"))
            if path.suffix in (".h", ".cxx")]


def crossing_includes(files):
    """How many includes lead from a file to a header of another folder."""
    folder_of = {path.name: path.parent for path in files}
    return sum(folder_of.get(name, path.parent) != path.parent for path in files
               for name in re.findall(r'^\s*#\s*include\s+[<"](?:\w+/)?(\w+\.h)[>"]', path.read_text(),
                                      re.MULTILINE))


def longest_functions(root, files):
    """[(lines, place)], the longest first."""
    found = [(length, f"{path.relative_to(root).as_posix()}:{first} {name}()") for path in files
             for name, first, length in functions_of(path.read_text())]
    return sorted(found, reverse=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("root", nargs="?", default=pathlib.Path(__file__).parents[1], type=pathlib.Path)
    parser.add_argument("--longest", type=int, default=10)
    options = parser.parse_args()
    files = library_files(options.root)
    lines = {path: path.read_text().count("\n") for path in files}
    counts = list(lines.values()) or [0]
    print(f"{len(files)} files, {sum(counts)} lines, mean {statistics.mean(counts):.0f}, "
          f"median {statistics.median(counts):.0f}, {sum(count < 60 for count in counts)} under 60 lines, "
          f"{crossing_includes(files)} includes of another module's headers")
    for path in sorted(files, key=lines.get, reverse=True)[:options.longest]:
        print(f"{lines[path]:6} {path.relative_to(options.root).as_posix()}")
    for length, place in longest_functions(options.root, files)[:options.longest]:
        print(f"{length:6} {place}")


if __name__ == "__main__":
    main()
