#!/usr/bin/env python3
"""Which tests run now: by module, by subset and by turn.

    select_tests.py BUILD [--module NAME]... [--changed REVISION] [--quick] [--all] [--turn N]
                    [--write FILE]
    select_tests.py BUILD --turns
    select_tests.py --modules [--module NAME]... [--changed REVISION] [--quick]

Long tests take turns, since all of them in every run would take an hour: turns.tsv lists them in groups,
each with the number of turns after which all of the group have run. Within a group the tests are in the
order of a hash of their names, and every n-th of them runs at a turn. The turn is ISTHMUS_TURN, --turn
or else the number of merges: commits on the first-parent line of HEAD, which amending does not change.

With --write, FILE gets the numbers of the tests in the form that `ctest -I FILE` reads. With --turns,
all tests that take turns are listed with the number of merges since they last ran. With --modules,
the folders of the modules (and Integration, whose tests need several) are printed instead of tests. --changed REVISION means the modules with
changes since then and all that depend on them. --quick: the unit tests that are not in turns.tsv,
and those that are marked `quick` there, whatever the turn; integration tests as well if no module is named.
--all: no test waits for its turn.
"""
import argparse
import fnmatch
import json
import os
import pathlib
import subprocess
import sys

import check_modules

TESTING = pathlib.Path(__file__).resolve().parent
ROOT = TESTING.parent
INTEGRATION = "Integration"  # the folder of tests of several modules, chosen as if it were one


def stable_hash(text):
    """FNV-1a of 32 bits, as in Unit/Core/LongTests.h."""
    value = 2166136261
    for byte in text.encode():
        value = (value ^ byte) * 16777619 % 2**32
    return value


class Group:
    """Tests of which every `turns`-th runs."""

    def __init__(self, name, turns):
        self.name = name
        self.turns = turns
        self.patterns = []
        self.quick = set()  # those of the patterns that --quick takes as well

    def has(self, test):
        return any(fnmatch.fnmatchcase(test, pattern) for pattern in self.patterns)

    def is_quick(self, test):
        return any(fnmatch.fnmatchcase(test, pattern) for pattern in self.quick)


def groups_of(table):
    """The groups of turns.tsv: lines of group, turns, a test's name or pattern and, for some, `quick`."""
    groups = {}
    for line in table.read_text().splitlines():
        if line and not line.startswith("#"):
            name, turns, pattern, *marks = line.split("\t")
            group = groups.setdefault(name, Group(name, int(turns)))
            group.patterns.append(pattern)
            if "quick" in marks:
                group.quick.add(pattern)
    return list(groups.values())


def places(tests, groups):
    """{test: (its group, its place there)} for the tests that take turns."""
    found = {}
    for group in groups:
        members = sorted((test for test in tests if test not in found and group.has(test)),
                         key=lambda test: (stable_hash(test), test))
        found.update((test, (group, place)) for place, test in enumerate(members))
    return found


def merges_since(group, place, turn):
    """How many turns ago the test at this place ran; 0: it runs now."""
    return (turn + place) % group.turns


def turn_of_head(root=ROOT):
    """The number of merges so far; 0 without git's history."""
    if os.environ.get("ISTHMUS_TURN"):
        return int(os.environ["ISTHMUS_TURN"])
    try:
        done = subprocess.run(["git", "-C", root, "rev-list", "--count", "--first-parent", "HEAD"],
                              capture_output=True, text=True)
    except OSError:  # no git at all
        return 0
    return int(done.stdout) if done.returncode == 0 else 0


def changed_modules(modules, revision, root=ROOT):
    """Folders with changes since `revision`, committed or not, and all whose modules depend on them."""
    def lines(*words):
        done = subprocess.run(["git", "-C", root, *words], capture_output=True, text=True)
        if done.returncode:
            sys.exit(done.stderr.strip())
        return done.stdout.splitlines()

    files = lines("diff", "--name-only", revision) + lines("ls-files", "--others", "--exclude-standard")
    by_name = {module.name: module for module in modules}
    folders = {module.folder.name: module.name for module in modules}
    changed, integration = set(), False
    for file in map(pathlib.PurePath, files):
        known = [folders[part] for part in file.parts[:-1] if part in folders]
        changed.update(known[-1:])
        integration |= file.parts[:2] == ("Testing", "Integration")
        if file.parts[:2] == ("Testing", "Python"): # X.py tests the class vtkX
            changed.update(module.name for module in modules
                           if (module.folder / f"vtk{file.stem}.h").exists())
        elif not known and (file.parts[0] == "cmake" or file.name == "CMakeLists.txt"):
            changed.update(by_name)
    depend = {name: module.declares(private=True) for name, module in by_name.items()}
    while True:
        more = {name for name, needed in depend.items() if needed & changed} - changed
        if not more:
            return sorted([by_name[name].folder.name for name in changed] + [INTEGRATION] * integration)
        changed |= more


def tests_of(build):
    """(name, labels) of the tests in ctest's order."""
    done = subprocess.run(["ctest", "--show-only=json-v1"], cwd=build, capture_output=True, text=True,
                          check=True)
    found = []
    for test in json.loads(done.stdout)["tests"]:
        labels = [p["value"] for p in test.get("properties", []) if p["name"] == "LABELS"]
        found.append((test["name"], labels[0] if labels else []))
    return found


def print_turns(tests, groups, turn):
    print(f"turn {turn}\nmerges since\tof\tgroup\ttest")
    where = places([name for name, _ in tests], groups)
    lines = [(merges_since(group, place, turn), group.turns, group.name, test)
             for test, (group, place) in where.items()]
    for line in sorted(lines, reverse=True):
        print(*line, sep="\t")


def chosen_tests(tests, groups, turn, folders, quick, all_turns):
    """(numbers, names of those left to other turns) of the tests to run."""
    where = places([name for name, _ in tests], groups)
    numbers, later = [], []
    for number, (name, labels) in enumerate(tests, start=1):
        if folders is not None and not set(labels) & set(folders):
            continue
        marked = name in where and where[name][0].is_quick(name)
        kinds = {"unit", "integration"} if folders is None or INTEGRATION in folders else {"unit"}
        if quick and ((name in where and not marked) or not kinds & set(labels)):
            continue
        if not all_turns and not (quick and marked) and name in where and merges_since(*where[name], turn) != 0:
            later.append(name)
        else:
            numbers.append(number)
    return numbers, later


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("build", type=pathlib.Path, nargs="?")
    parser.add_argument("--module", action="append", default=[])
    parser.add_argument("--changed")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--turn", type=int)
    parser.add_argument("--turns", action="store_true")
    parser.add_argument("--modules", action="store_true")
    parser.add_argument("--write", type=pathlib.Path)
    given = parser.parse_args()
    modules = check_modules.modules_of(ROOT)
    known = sorted(module.folder.name for module in modules)
    for name in given.module:
        if name not in [*known, INTEGRATION]:
            sys.exit(f"There is no module {name}; the modules are {', '.join(known)}.")
    folders = None
    if given.module or given.changed:
        folders = sorted({*given.module, *(changed_modules(modules, given.changed) if given.changed else [])})
    if given.modules:
        names = known if folders is None else folders
        # Tests of several modules need the whole library, so that --quick with modules has none of them.
        if names and INTEGRATION not in names and (folders is None or not given.quick):
            names = [*names, INTEGRATION]
        print(*names)
        return
    if given.build is None:
        parser.error("the build folder is missing")
    groups = groups_of(TESTING / "turns.tsv")
    turn = turn_of_head() if given.turn is None else given.turn
    tests = tests_of(given.build)
    if given.turns:
        print_turns(tests, groups, turn)
        return
    # Long tests of modules that someone asks for by name do not wait for their turn.
    all_turns = given.all or bool(given.module) or os.environ.get("ISTHMUS_LONG_TESTS") == "1"
    numbers, later = chosen_tests(tests, groups, turn, folders, given.quick, all_turns)
    if not numbers:
        sys.exit("No test was chosen.")
    if given.write:
        given.write.write_text("0,0,0," + ",".join(map(str, numbers)) + "\n")
    print(f"Turn {turn}: {len(numbers)} of {len(tests)} tests run, {len(later)} have other turns "
          "(Testing/turns.sh lists them).")


if __name__ == "__main__":
    main()
