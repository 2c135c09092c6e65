#!/usr/bin/env python3
"""One line for each failed test: its name, the cause, and where its whole output is. One line for skipped ones.

    report_tests.py TESTS.xml FOLDER

TESTS.xml is what `ctest --output-junit` writes. The output of each failed test is written to
FOLDER/NAME.log. The cause is the first failed assertion of GoogleTest, the exception of Python,
the first error of CMake or a compiler, a sanitizer's summary, or else the last line of the output.
"""
import pathlib
import re
import sys
import xml.etree.ElementTree

GTEST = re.compile(r"^(\S+?:\d+): Failure\n((?:(?!\[ )[^\n]*\n){1,8})", re.MULTILINE)
PYTHON = re.compile(r"^((?:\w+\.)*(?:\w*(?:Error|Exception|Interrupt|Exit))\b(?:: .*)?)$", re.MULTILINE)
PLACE = re.compile(r'^  File "([^"]+)", line (\d+)', re.MULTILINE)
OTHERS = (re.compile(r"^SUMMARY: .*$", re.MULTILINE), # sanitizers
          re.compile(r"^.*?:\d+(?::\d+)?: (?:fatal )?error: .*$", re.MULTILINE),
          re.compile(r"^CMake Error.*(?:\n+ +.*)?", re.MULTILINE))


def cause_of(output, status=""):
    """The cause in one line, from what a test printed; `status` is ctest's word for its end."""
    found = GTEST.search(output)
    if found:
        where = pathlib.PurePath(found[1]).name
        return f"{where}: " + " | ".join(line.strip() for line in found[2].splitlines() if line.strip())
    found = list(PYTHON.finditer(output))
    if found and "Traceback" in output:
        places = list(PLACE.finditer(output[:found[-1].start()]))
        where = f"{pathlib.PurePath(places[-1][1]).name}:{places[-1][2]}: " if places else ""
        return where + found[-1][1]
    for pattern in OTHERS:
        found = pattern.search(output)
        if found:
            return " ".join(found[0].split())
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    last = lines[-1] if lines else "no output"
    return f"{status}: {last}" if status not in ("", "Failed") else last


def main(results, folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.log"):
        old.unlink()
    skipped, without_data = 0, 0
    for test in xml.etree.ElementTree.parse(results).getroot().iter("testcase"):
        output = test.findtext("system-out") or ""
        if test.get("status") == "notrun":
            skipped += 1
            for line in output.splitlines():
                if line.startswith("skipped: "):
                    print(f"{test.get('name')} {line}")
            without_data += "ISTHMUS_DATA_DIR" in output or "shared data" in output.lower()
        if test.get("status") != "fail":
            continue
        failure = test.find("failure")
        status = failure.get("message", "") if failure is not None else ""
        log = folder / (re.sub(r"[^\w.-]+", "_", test.get("name"))[:120] + ".log")
        log.write_text(output)
        print(f"FAILED {test.get('name')}\n  {cause_of(output, status)[:300]}\n  whole output: {log}")
    if skipped:
        print(f"Skipped tests: {skipped}, {without_data} of them because shared data are missing "
              "(Testing/fetch_data.sh downloads them).")


if __name__ == "__main__":
    main(*sys.argv[1:])
