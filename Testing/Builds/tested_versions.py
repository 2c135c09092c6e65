#!/usr/bin/env python3
"""Writes the table of Documentation/tested_versions.md from what release.sh has left: the last run of each system.

    tested_versions.py LOGS [PAGE]

LOGS is ISTHMUS_RELEASE_DIR of release.sh; each SUITE.json and SUITE-plain.json there replaces the row of its
system, other rows remain. Below the table, each failed test has a line `- SYSTEM, TEST: CAUSE`. Causes are written
by hand and remain as long as the test fails. The exit status is 1 while a cause is missing.
"""

import json
import pathlib
import re
import sys

PAGE = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "tested_versions.md"
SYSTEMS = {f"{suite}{kind}": system + what
           for suite, system in (("bookworm", "Debian 12"), ("trixie", "Debian 13"), ("testing", "Debian testing"))
           for kind, what in (("", ""), ("-plain", " without ParaView"))}
VERSIONS = ("ParaView", "VTK", "Qt", "CGAL", "gemmi", "Python", "GCC")
UNKNOWN = "cause not known"
TABLE = re.compile(r"(?<=<!-- versions -->\n).*(?=<!-- end of versions -->)", re.DOTALL)
CAUSE = re.compile(r"^- ([^,\n]+), (\S+):\s((?:.+\n)(?:  .+\n)*)", re.MULTILINE)


def row_of(system, summary):
    cells = [system, *(summary["versions"].get(key, "") for key in VERSIONS), summary["passed"], len(summary["failed"]),
             len(summary["skipped"]), f"{summary['date']} ({summary['commit']})"]
    return "| " + " | ".join(map(str, cells)) + " |"


def main(logs, page=PAGE):
    page = pathlib.Path(page)
    text = page.read_text()
    old = TABLE.search(text)[0]
    rows = {line.split("|")[1].strip(): line for line in old.splitlines() if line.startswith("|")}
    causes = {}
    for system, test, cause in CAUSE.findall(old):
        causes.setdefault(system, {})[test] = cause
    for name, system in SYSTEMS.items():
        path = pathlib.Path(logs) / f"{name}.json"
        if path.exists():
            summary = json.loads(path.read_text())
            rows[system] = row_of(system, summary)
            known = causes.get(system, {})
            causes[system] = {test: known.get(test, f"{UNKNOWN}\n") for test in summary["failed"]}
    head = ["system", *VERSIONS, "passed", "failed", "skipped", "date and commit"]
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += [rows[system] for system in SYSTEMS.values() if system in rows]
    found = [f"- {system}, {test}: {cause}" for system in SYSTEMS.values() for test, cause in causes.get(system, {}).items()]
    block = "\n".join(lines) + "\n" + ("\n" + "".join(found) if found else "")
    page.write_text(TABLE.sub(lambda _: block, text))
    missing = [line for line in found if line.endswith(f": {UNKNOWN}\n")]
    print(*missing, sep="", end="")
    sys.exit(bool(missing))


if __name__ == "__main__":
    main(*sys.argv[1:])
