#!/usr/bin/env python3
"""Writes the tables of Examples/guide/tested_versions.md from what release.sh has left: the versions with
their tests, and the main job's numbers side by side.

    tested_versions.py LOGS [PAGE]

LOGS is ISTHMUS_RELEASE_DIR of release.sh: SUITE.json and SUITE-numbers.json, for the plain builds
SUITE-plain.json. Tables of suites without these files say so. What is between the lines <!-- NAME --> and
<!-- end of NAME --> of PAGE is replaced. The exit status is 1 if numbers differ by more than they may.
"""

import json
import pathlib
import re
import sys

PAGE = pathlib.Path(__file__).resolve().parents[2] / "Examples" / "guide" / "tested_versions.md"
SUITES = {"bookworm": "Debian 12", "trixie": "Debian 13", "testing": "Debian testing"}
VERSIONS = ("ParaView", "VTK", "Qt", "CGAL", "gemmi", "Python", "GCC")
# Row of the main job's table: key of the numbers, largest relative difference from Debian 12; 0: equal.
# Without a limit: Delaunay refinement and tetrahedra of another CGAL.
ROWS = (("genus", 0), ("handles", 0), ("tunnels", 0), ("additional loops inside", 0),
        ("additional loops outside", 0), ("area", 1e-3), ("volume", 1e-3), ("loops: birth", 1e-3),
        ("loops: death", 1e-3), ("loops: length", None), ("Delaunay triangles", None), ("Delaunay area", 1e-3),
        ("tetrahedra", None), ("volume of the tetrahedra", 1e-3))
NODES = 1e-6 # of the curvature at nodes, relative to the largest


def read(path):
    return json.loads(path.read_text()) if path.exists() else None


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows]


def skipped_lines(skipped):
    """One line for each reason, with the tests without the parameters of their cases."""
    tests = {}
    for test, reason in skipped.items():
        tests.setdefault(reason.strip().removeprefix("skipped: "), []).append(re.sub(r"^\w+/|/.*", "", test) if "/" in test else test)
    for reason, names in tests.items():
        yield f"skipped, {reason}: {', '.join(sorted(set(names)))} ({len(names)})"


def versions_table(logs):
    rows, skips = [], []
    for suite, system in SUITES.items():
        for name, what in ((suite, system), (f"{suite}-plain", f"{system}, without ParaView")):
            summary = read(logs / f"{name}.json")
            if summary is None:
                if name == suite:
                    rows.append([what, *["" for _ in VERSIONS], "not yet run by release.sh", "", "", "", ""])
                continue
            numbers = read(logs / f"{name}-numbers.json") or {}
            versions = dict(summary["versions"])
            if numbers.get("VTK"):
                versions["VTK"] = numbers["VTK"]
            rows.append([what, *(versions.get(key, "") for key in VERSIONS), summary["tests"], summary["passed"],
                         len(summary["skipped"]), len(summary["failed"]),
                         f"{summary['date']} ({summary['commit']})"])
            skips += [f"- {what}, {line}" for line in skipped_lines(summary["skipped"])]
            if summary["failed"]:
                skips.append(f"- {what}, failed: {', '.join(summary['failed'])}")
    head = ["system", *VERSIONS, "tests", "passed", "skipped", "failed", "date and commit"]
    return table(head, rows) + ([""] + skips if skips else [])


def difference(a, b):
    """Relative difference of two numbers."""
    return 0.0 if a == b else abs(a - b) / max(abs(a), abs(b))


def compared(a, b, limit):
    """(text, whether it may be so) of numbers or ascending lists; without a limit lists are not matched."""
    if not isinstance(a, list):
        apart = difference(a, b)
        return f"{apart:.1e}" if apart else "0", limit is None or apart <= limit
    if limit is None:
        if len(a) != len(b):
            return "other number", True
        limit = float("inf")
    a, b, apart, alone = list(a), list(b), 0.0, []
    while a and b:
        if difference(a[0], b[0]) <= limit:
            apart = max(apart, difference(a.pop(0), b.pop(0)))
        else:
            alone.append((a if a[0] < b[0] else b).pop(0))
    alone += a + b
    text = f"{apart:.1e}" if apart else "0"
    return text + (f"; on one only: {', '.join(f'{x:.4g}' for x in alone)}" if alone else ""), not alone


def of_nodes(a, b):
    """Largest difference of the curvatures at nodes, relative to the largest curvature."""
    return max(max(abs(x - y) for x, y in zip(a[name], b[name])) / a[name][0] for name in a)


def shown(value):
    if isinstance(value, list):
        return f"{len(value)} from {value[0]:.6g} to {value[-1]:.6g}"
    return f"{value:.9g}"


def results_table(logs):
    """(lines, complaints)."""
    found = {suite: read(logs / f"{suite}-numbers.json") for suite in SUITES}
    found = {suite: numbers for suite, numbers in found.items() if numbers}
    first, *others = found
    rows, wrong = [], []
    for key, limit in ROWS:
        row = [key, shown(found[first][key])]
        for suite in others:
            text, fine = compared(found[first][key], found[suite][key], limit)
            row += [shown(found[suite][key]), text]
            if not fine:
                wrong.append(f"{key} of {SUITES[suite]}: {row[-1]}, where {limit:g} is allowed")
        rows.append(row)
    row = ["curvature at nodes of EMD-1832, relative to the largest", ""]
    for suite in others:
        apart = of_nodes(found[first]["curvature at nodes"], found[suite]["curvature at nodes"])
        row += ["", f"{apart:.1e}" if apart else "0"]
        if apart > NODES:
            wrong.append(f"curvature at nodes of {SUITES[suite]}: {apart:.1e}, where {NODES:g} is allowed")
    head = ["result", SUITES[first]]
    for suite in others:
        head += [SUITES[suite], "relative difference"]
    return table(head, [*rows, row]), wrong


def replaced(text, name, lines):
    begin, end = f"<!-- {name} -->", f"<!-- end of {name} -->"
    before, rest = text.split(begin)
    return before + begin + "\n" + "\n".join(lines) + "\n" + end + rest.split(end)[1]


def main(logs, page=PAGE):
    logs, page = pathlib.Path(logs), pathlib.Path(page)
    lines, wrong = results_table(logs)
    text = replaced(page.read_text(), "versions", versions_table(logs))
    page.write_text(replaced(text, "results", lines))
    print(*wrong, sep="\n")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main(*sys.argv[1:])
