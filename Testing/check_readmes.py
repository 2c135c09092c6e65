#!/usr/bin/env python3
"""Checks that every header is named in the README of its module.

    check_readmes.py [ROOT]

A header X.h is named when `X` or [X](...) is. Pages beside a README (BindingSites.md, say) count as
part of it. Prints one line per missing header; the exit status is 1 if there are any.
"""
import pathlib
import re
import sys


def pages_of(room):
    """The README of a module, then the other pages."""
    return sorted(room.glob("*.md"), key=lambda page: (page.name != "README.md", page.name))


def names_in(pages):
    text = "\n".join(page.read_text() for page in pages)
    return {name.removesuffix(".h") for name in re.findall(r"[`\[]([A-Za-z][\w.]*)[`\]]", text)}


def check(root):
    complaints, looked_at = [], 0
    for room in sorted(path.parent for path in root.glob("[FR]*/*/vtk.module")):
        pages = pages_of(room)
        if not pages or pages[0].name != "README.md":
            complaints.append(f"{room.relative_to(root)} has no README.md")
            continue
        named = names_in(pages)
        for header in sorted(room.glob("*.h")):
            looked_at += 1
            if header.stem not in named:
                complaints.append(f"{header.relative_to(root)} is not in {pages[0].relative_to(root)}")
    return complaints, looked_at


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1])
    complaints, looked_at = check(root)
    if looked_at == 0:
        complaints.append(f"no header was found under {root}")
    for complaint in complaints:
        print(complaint)
    print(f"{looked_at} headers looked at, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
