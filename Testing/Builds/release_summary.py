"""What ctest's report (--output-junit) says, with the versions of this system's packages. Run by
release.sh inside the root.

    release_summary.py tests.xml

Prints: the system, the versions, numbers of tests, each skipped test with its reason, each that failed;
last, a row for the table of tested versions (Examples/guide/tested_versions.md).
"""

import datetime
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

PACKAGES = {"ParaView": ("paraview",), "VTK": ("libvtk9-dev",), "CGAL": ("libcgal-dev",),
            "gemmi": ("libgemmi-dev", "gemmi-dev"), "Python": ("python3",), "GCC": ("g++",)}


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


def main(report):
    cases = list(ElementTree.parse(report).getroot().iter("testcase"))
    failed = [case for case in cases if case.get("status") == "fail"]
    skipped = [case for case in cases if case.get("status") in ("notrun", "disabled")]
    passed = len(cases) - len(failed) - len(skipped)
    versions = {what: version_of(names) for what, names in PACKAGES.items()}
    print(system_name() + ": " + ", ".join(f"{what} {version}" for what, version in versions.items() if version))
    print(f"{len(cases)} tests: {passed} passed, {len(failed)} failed, {len(skipped)} skipped")
    for case in skipped:
        print(f"  skipped {case.get('name')}: {reason_of(case)}")
    for case in failed:
        print(f"  FAILED  {case.get('name')}")
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True).stdout.strip()
    row = [system_name(), *(version or "-" for version in versions.values()), str(len(cases)), str(passed),
           str(len(skipped)), str(len(failed)), f"{datetime.date.today()} ({commit})"]
    print("| " + " | ".join(row) + " |")


if __name__ == "__main__":
    main(*sys.argv[1:])
