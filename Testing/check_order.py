#!/usr/bin/env python3
"""Checks the order in which a module's README lists the files behind a function.

    check_order.py [ROOT]

A block of a README headed by `<!-- order from X -->` names, each once, exactly the concepts of the module
(X.h and X.cxx are one) that X reaches by its includes, X first, in an order in which each includes only
those after it, or files of other modules. Functions
are declared in included headers, directly or indirectly, so a callee is also listed later. Headers are
searched for in ROOT/Filters; vtkChokingLoops must have such a block. Prints one line per error; the exit
status is 1 if there are any.
"""
import pathlib
import re
import sys

from check_modules import included_names

# {module: the start of each order that its README must draw}
DRAWN = {"Filters/ChokingLoops": ["vtkChokingLoops"]}
MOST = 13  # concepts that a reader has to visit, the parameters included
BLOCK = re.compile(r"<!-- order from (\w+) -->\n+((?: {4}.*\n|\n)+)")


def arrows_of(module):
    """{concept: concepts of the module that its files include}."""
    files = [path for path in sorted(module.iterdir()) if path.suffix in (".h", ".cxx")]
    concepts = {path.stem for path in files}
    arrows = {concept: set() for concept in concepts}
    for path in files:
        included = {pathlib.Path(name).stem for name in included_names(path)}
        arrows[path.stem] |= (included & concepts) - {path.stem}
    return arrows


def reached_from(start, arrows):
    seen, todo = set(), [start]
    while todo:
        concept = todo.pop()
        if concept not in seen:
            seen.add(concept)
            todo.extend(arrows[concept])
    return seen


def check_block(place, start, drawn, arrows):
    """Complaints about one block, whose words `drawn` are concepts of the module, in its order."""
    twice = sorted({concept for concept in drawn if drawn.count(concept) > 1})
    complaints = [f"{place} draws {concept} twice in the order from {start}" for concept in twice]
    if len(set(drawn)) > MOST:
        complaints.append(f"{place} draws {len(set(drawn))} files from {start}, more than {MOST}")
    reached = reached_from(start, arrows)
    complaints += [f"{place} does not draw {concept}, which {start} reaches"
                   for concept in sorted(reached - set(drawn))]
    complaints += [f"{place} draws {concept}, which {start} does not reach"
                   for concept in sorted(set(drawn) - reached)]
    if drawn and drawn[0] != start:
        complaints.append(f"{place} draws {drawn[0]} before {start}, where the order begins")
    position = {concept: i for i, concept in reversed(list(enumerate(drawn)))}
    complaints += [f"{place} draws {concept} after {other}, but {concept} includes {other}"
                   for concept in drawn for other in sorted(arrows[concept])
                   if other in position and position[other] < position[concept]]
    return complaints


def check(root, demanded=None):
    """All complaints about the tree under `root`, and how many arrows the drawn orders have."""
    complaints, looked_at, found = [], 0, set()
    for page in sorted(root.glob("Filters/*/README.md")):
        module = page.parent.relative_to(root).as_posix()
        arrows = arrows_of(page.parent)
        for start, block in BLOCK.findall(page.read_text() + "\n"):
            found.add((module, start))
            place = page.relative_to(root).as_posix()
            if start not in arrows:
                complaints.append(f"{place} draws an order from {start}, which is not in the module")
                continue
            drawn = [word for word in re.findall(r"\w+", block) if word in arrows]
            looked_at += sum(len(arrows[concept]) for concept in set(drawn))
            complaints += check_block(place, start, drawn, arrows)
    complaints += [f"{module}/README.md draws no order from {start}"
                   for module, starts in sorted((DRAWN if demanded is None else demanded).items())
                   for start in starts if (module, start) not in found]
    return complaints, looked_at


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1])
    complaints, looked_at = check(root)
    for complaint in complaints:
        print(complaint)
    print(f"{looked_at} arrows of drawn orders looked at, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
