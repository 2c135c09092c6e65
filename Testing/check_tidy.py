#!/usr/bin/env python3
"""Runs clang-tidy (.clang-tidy says with which checks) over sources of the library.

    check_tidy.py [--build FOLDER] [--base REV] [--seconds N] [--jobs N] [FILE...]

Without FILE: the library's files in the order of their last change, newest first, until SECONDS have
passed (0, the default: no limit); with --base only those changed since REV, or, if REV is the word
tidy, since .clang-tidy was added. For a header, its own source is checked, or the first one that
includes it. FOLDER (default: build) has
the compile_commands.json of cmake. Prints each finding once, and how many files were checked; the
exit status is 1 if anything was found, and 77 without clang-tidy, unless ISTHMUS_REQUIRE_DATA=1
requires all tests.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

FOLDERS = ("Filters", "Readers", "Plugin")
LONGEST = 900  # seconds that one file may take
FOUND = re.compile(r"^(\S.*?:\d+:\d+): (?:error|warning): .*$", re.MULTILINE)


def commands_of(build, root, folder):
    """The library's sources in the build, as paths below `root`; writes their commands to `folder`.

    The build compiles sources in groups, each through a file that includes them. clang-tidy looks at each
    source alone, with the command of its group.
    """
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = pathlib.Path(entry["directory"], entry["file"]).resolve()
        group = path.parent.name == "Unity" and path.exists()
        for source in re.findall(r'^#include "(.+)"', path.read_text(), re.MULTILINE) if group else [path]:
            command = entry["command"].replace(entry["file"], str(source))
            found[pathlib.Path(source)] = {**entry, "file": str(source), "command": command}
    (folder / "compile_commands.json").write_text(json.dumps(list(found.values())))
    below = {path.relative_to(root) for path in found if path.is_relative_to(root)}
    return sorted(path for path in below if path.parts[0] in FOLDERS)


def changed_files(root, base):
    """Files that are changed or new now, then those of commits, the newest first."""
    def names(*words):
        done = subprocess.run(["git", "-C", root, *words], capture_output=True, text=True, check=True)
        return [pathlib.Path(line) for line in done.stdout.splitlines() if line]

    commits = [f"{base}..HEAD"] if base else []
    return (names("diff", "--name-only", "HEAD") +
            names("ls-files", "--others", "--exclude-standard") +
            names("log", "-m", "--first-parent", "--format=", "--name-only", *commits))


def arrival_of_checks(root):
    """The commit that brought .clang-tidy."""
    done = subprocess.run(["git", "-C", root, "log", "--diff-filter=A", "--format=%H", "--", ".clang-tidy"],
                          capture_output=True, text=True, check=True)
    return done.stdout.split()[-1]


def source_for(path, root, sources):
    """The source that shows what is in `path`: itself, its pair, or the first that includes it."""
    own = path.with_suffix(".cxx")
    if own in sources:
        return own
    if path.suffix != ".h":
        return None
    asked = re.compile(rf'^\s*#\s*include\s+"{re.escape(path.name)}"', re.MULTILINE)
    return next((source for source in sources if asked.search((root / source).read_text())), None)


def look_at(source, root, build):
    """clang-tidy's status and what it says of one source."""
    # GCC's builds judge the warnings; clang has others. The commands say no standard where it is the
    # compiler's own, which is an older one with clang.
    words = ["clang-tidy", "-p", str(build), "--quiet", "--extra-arg-before=-std=gnu++17",
             "--extra-arg=-Wno-error", "--extra-arg=-Wno-unknown-warning-option", str(root / source)]
    try:
        done = subprocess.run(words, cwd=root, capture_output=True, text=True, timeout=LONGEST)
    except subprocess.TimeoutExpired:
        return 1, f"{source}:1:1: error: not done within {LONGEST} s\n"
    if done.returncode != 0 and not FOUND.search(done.stdout):
        return done.returncode, f"{source}:1:1: error: clang-tidy failed: {done.stderr.strip()}\n"
    return done.returncode, done.stdout


def check(sources, root, build, seconds=0, jobs=1, say=print):
    """(places found, sources checked) of `sources`, in their order until the time is over,
    but one at least: a slow machine must not pass without having checked any."""
    end = time.monotonic() + seconds if seconds > 0 else float("inf")
    seen, looked_at = set(), 0

    def look(source):
        late = time.monotonic() > end and source != sources[0]
        return None if late else look_at(source, root, build)

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for result in pool.map(look, sources):
            if result is None:
                continue
            looked_at += 1
            for part in re.split(r"(?m)^(?=\S.*?:\d+:\d+: (?:error|warning): )", result[1]):
                place = FOUND.match(part)
                if result[0] != 0 and place and place.group() not in seen:
                    seen.add(place.group())
                    say(part.rstrip().replace(f"{root}/", ""))
    return len(seen), looked_at


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    root = pathlib.Path(__file__).resolve().parents[1]
    parser.add_argument("--root", type=pathlib.Path, default=root)
    parser.add_argument("--build", type=pathlib.Path)
    parser.add_argument("--base")
    parser.add_argument("--seconds", type=float, default=0)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    given = parser.parse_args()
    root = given.root.resolve()
    build = (given.build or root / "build").resolve()
    if not shutil.which("clang-tidy"):
        print("clang-tidy is not installed: nothing was checked.")
        return 1 if os.environ.get("ISTHMUS_REQUIRE_DATA") == "1" else 77
    if not given.files and not ((root / ".git").exists() and shutil.which("git")):
        print("Not a clone, or git is not installed: no changed files are known.")
        return 77
    if not (build / "compile_commands.json").exists():
        print(f"{build} has no compile_commands.json: run cmake there with -DISTHMUS_TESTING=ON.")
        return 1
    commands = tempfile.TemporaryDirectory()
    build, sources = pathlib.Path(commands.name), commands_of(build, root, pathlib.Path(commands.name))
    asked = [path.resolve().relative_to(root) for path in given.files]
    base = arrival_of_checks(root) if given.base == "tidy" else given.base
    files = asked or changed_files(root, base)
    chosen = [source_for(path, root, sources) for path in files
              if path.parts[0] in FOLDERS and path.suffix in (".h", ".cxx") and (root / path).exists()]
    chosen = list(dict.fromkeys(source for source in chosen if source))
    if not asked and not given.base:  # sources that no commit names: a shallow clone has few
        chosen += [source for source in sources if source not in set(chosen)]
    found, looked_at = check(chosen, root, build, given.seconds, given.jobs)
    print(f"{looked_at} of {len(chosen)} sources checked (of {len(sources)} in all), {found} complaints")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
