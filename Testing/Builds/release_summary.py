"""What ctest's report (--output-junit) says, with the versions of this system's packages. Run by
release.sh inside the root.

    release_summary.py TESTS.xml [SUMMARY.json]

Prints: the system, the versions, numbers of tests, each skipped test with its reason, each that failed.
The same is written to SUMMARY.json, for the table of tested versions (tested_versions.py). The VTK inside ParaView is
that of numbers.json beside the report (main_job_numbers.py).
"""

import datetime
import json
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

PACKAGES = {"ParaView": ("paraview",), "VTK": ("libvtk9-dev",), "Qt": ("qt6-base-dev", "qtbase5-dev"),
            "CGAL": ("libcgal-dev",), "gemmi": ("libgemmi-dev", "gemmi-dev"), "Python": ("python3",),
            "GCC": ("g++",)}


def version_of(names):
    """Of the first of these packages that is installed, without Debian's revision; else empty."""
    for name in names:
        asked = subprocess.run(["dpkg-query", "-W", "-f", "${db:Status-Status} ${Version}", name],
                               capture_output=True, text=True)
        status, _, version = asked.stdout.partition(" ")
        if asked.returncode == 0 and status == "installed":
            return version.split(":")[-1].split("-")[0].split("+")[0]
    return ""


def system_name():
    with open("/etc/os-release") as lines:
        return dict(line.strip().split("=", 1) for line in lines if "=" in line)["PRETTY_NAME"].strip('"')


def reason_of(case):
    """The last line that a skipped test wrote, where GoogleTest names the reason in the one above."""
    output = case.findtext("system-out") or ""
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    named = [below for above, below in zip(lines, lines[1:]) if above.endswith(": Skipped")]
    skipped = case.find("skipped")
    why = skipped.get("message", "") if skipped is not None else ""
    return (named or lines or [why or "no reason given"])[-1]


def main(report, summary=None):
    cases = list(ElementTree.parse(report).getroot().iter("testcase"))
    failed = [case.get("name") for case in cases if case.get("status") == "fail"]
    skipped = {case.get("name"): reason_of(case) for case in cases if case.get("status") in ("notrun", "disabled")}
    versions = {what: version_of(names) for what, names in PACKAGES.items()}
    numbers = pathlib.Path(report).with_name("numbers.json")
    if numbers.exists():
        versions["VTK"] = json.loads(numbers.read_text())["VTK"]
    passed = len(cases) - len(failed) - len(skipped)
    print(system_name() + ": " + ", ".join(f"{what} {version}" for what, version in versions.items() if version))
    print(f"{len(cases)} tests: {passed} passed, {len(failed)} failed, {len(skipped)} skipped")
    for name, reason in skipped.items():
        print(f"  skipped {name}: {reason}")
    for name in failed:
        print(f"  FAILED  {name}")
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True).stdout.strip()
    if summary:
        with open(summary, "w") as sink:
            json.dump({"system": system_name(), "versions": versions, "tests": len(cases), "passed": passed,
                       "failed": failed, "skipped": skipped, "date": str(datetime.date.today()),
                       "commit": commit}, sink, indent=1)


if __name__ == "__main__":
    main(*sys.argv[1:])
