"""The class comments of the headers as Markdown, and the dependencies of the modules."""

import re
from dataclasses import dataclass


@dataclass
class ClassComment:
    """The comment of one VTK class."""

    name: str
    module: str  # the folder, Filters/Imaging
    brief: str
    text: str  # Markdown
    see_also: list


def comment_lines(header):
    """The text of the first documentation comment of a header."""
    found = re.search(r"/\*\*(.*?)\*/", header, re.DOTALL)
    if not found:
        return []
    return [re.sub(r"^ ?\* ?", "", line.strip("\n")).rstrip() for line in
            re.sub(r"^ +\*", " *", found.group(1), flags=re.MULTILINE).split("\n")]


def escaped(line):
    """A line of text in which < and $ are escaped."""
    parts = re.split(r"(`[^`]*`)", line)
    for i in range(0, len(parts), 2):
        parts[i] = parts[i].replace("<", "&lt;").replace("$", "\\$")
    return "".join(parts)


def class_comment(path, root):
    lines = comment_lines(path.read_text())
    if not any("@class" in line for line in lines):
        return None
    brief, text, also, where = [], [], [], "text"
    for line in lines:
        if "@class" in line:
            continue
        if "@brief" in line:
            where, line = "brief", line.split("@brief", 1)[1].strip()
        elif line.startswith("@sa"):
            where, line = "also", line[3:]
        elif not line.strip() and where != "text":
            where = "text"
        if where == "brief":
            brief.append(line.strip())
        elif where == "also":
            also += re.findall(r"vtk\w+", line)
        else:
            # Lines of formulas are left unchanged, everything else is text.
            text.append(line if line.startswith("    ") else escaped(line))
    sentence = " ".join(brief)
    return ClassComment(
        name=path.stem, module=str(path.parent.relative_to(root)),
        brief=escaped(sentence[:1].upper() + sentence[1:].rstrip(".")) + ".",
        text="\n".join(text).strip(), see_also=also)


def read_classes(root):
    """The comments of all VTK classes, by name."""
    comments = (class_comment(path, root) for path in sorted(root.glob("[FR]*/*/vtk*.h")))
    return {comment.name: comment for comment in comments if comment}


def declared_modules(root):
    """{Filters/Imaging: [Filters/Core, ...]}: the modules of ours that each declares."""
    found = {}
    for path in sorted(root.glob("[FR]*/*/vtk.module")):
        text = path.read_text().split("TEST_DEPENDS")[0]
        names = re.findall(r"Isthmus::(Filters|Readers)(\w+)", text)
        folder = str(path.parent.relative_to(root))
        found[folder] = sorted({f"{kind}/{name}" for kind, name in names} - {folder})
    return found


def uses_cgal(root, declared):
    """The modules that are under the GPL when built: those that use CGAL and those that depend on them."""
    found = {folder for folder in declared
             if "CGAL" in (root / folder / "CMakeLists.txt").read_text()}
    while True:
        more = {folder for folder, needed in declared.items() if found & set(needed)} - found
        if not more:
            return found
        found |= more
