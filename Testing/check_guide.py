#!/usr/bin/env python3
"""Checks that the guide is complete.

    check_guide.py [ROOT]

- each filter, reader and writer of Plugin/*.xml has a hand-written part Documentation/filters/NAME.md that is
  headed by its label, those of filters have a picture, and each such part has a panel;
- the classes of filters and readers have a table of their output arrays, which the page shows (ResultDigests compares
  it with the outputs);
- each page of Documentation is in a list of contents;
- tests that pages name as `-R NAME` exist;
- the version in CITATION.cff is that of the root CMakeLists.txt, from which all others come.

Prints one line per error; the exit status is 1 if there are any.
"""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "Documentation" / "site"))
import pages  # noqa: E402

# Parts of filters/ that belong to no panel.
OTHER = {"index"}


def check_panels(site, root):
    folder = root / pages.GUIDE / "filters"
    parts = {path.stem: path.read_text() for path in folder.glob("*.md")}
    for name in sorted(set(parts) - set(site.panels) - OTHER):
        yield f"Documentation/filters/{name}.md belongs to no panel"
    for name, panel in sorted(site.panels.items()):
        if name not in parts:
            yield f"{panel.file}: {name} has no Documentation/filters/{name}.md"
            continue
        heading = parts[name].split("\n", 1)[0]
        if heading != f"# {panel.label}":
            yield f"Documentation/filters/{name}.md is headed {heading!r}, the panel {panel.label!r}"
        if panel.kind == "filter" and not re.search(r"^!\[[^\]]+\]\([^)]+\)$", parts[name], re.MULTILINE):
            yield f"Documentation/filters/{name}.md has no picture"
        if panel.kind != "writer" and panel.vtk_class in site.classes and panel.vtk_class not in site.arrays:
            yield f"{panel.vtk_class}, the class of {name}, has no OutputArrayTable() in its .cxx"


def check_contents(root):
    folder = root / pages.GUIDE
    listed = {"index"}
    for path in folder.rglob("*.md"):
        for block in re.findall(r"^```\{toctree\}\n(.*?)^```", path.read_text(), re.DOTALL | re.MULTILINE):
            listed.update(line.strip() for line in block.split("\n") if line and not line.startswith(":"))
    for path in sorted(folder.glob("*.md")):
        if path.stem not in listed:
            yield f"Documentation/{path.name} is in no list of contents"


def check_version(root):
    found = re.search(r"^project\(Isthmus VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text(), re.MULTILINE)
    if not found:
        yield "CMakeLists.txt has no project(Isthmus VERSION ...)"
        return
    version = found.group(1)
    citation = re.search(r"^version: (\S+)", (root / "CITATION.cff").read_text(), re.MULTILINE)
    if not citation or citation.group(1) != version:
        yield f"CITATION.cff does not have the version {version} of CMakeLists.txt"


def check_tests(root):
    """Tests that pages name as `-R NAME` exist."""
    names = {"Python." + path.stem for path in (root / "Testing" / "Python").glob("[A-Z]*.py")}
    for path in [*(root / "Testing/Unit").rglob("*.cxx"), *(root / "Testing/Integration").glob("*.cxx")]:
        names.update(".".join(pair) for pair in re.findall(r"^TEST(?:_F|_P)?\((\w+),\s*(\w+)", path.read_text(),
                                                           re.MULTILINE))
    for page in sorted((root / pages.GUIDE).glob("*.md")):
        for name in re.findall(r"`-R ([\w.]+)`", page.read_text()):
            if not any(name in test for test in names):
                yield f"Documentation/{page.name}: there is no test {name}"


def check(root):
    site = pages.Site(root, "")
    complaints = [*check_panels(site, root), *check_contents(root), *check_version(root),
                  *check_tests(root)]
    for lines in pages.GENERATED.values():  # as the guide makes them
        lines(site)
    return complaints, len(site.panels)


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1]).resolve()
    complaints, looked_at = check(root)
    if looked_at == 0:
        complaints.append(f"no panel was found under {root}")
    for complaint in complaints:
        print(complaint)
    print(f"{looked_at} panels checked, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
