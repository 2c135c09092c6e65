#!/usr/bin/env python3
"""Runs clang-tidy (.clang-tidy says with which checks) over sources of the library.

    check_tidy.py [--build FOLDER] [--base REV] [--newest N] [--jobs N] [FILE...]

Without FILE: the library's sources in the order of their last change, newest first, N of them (0, the
default: all), whatever the speed of the machine; with --base only those changed since REV, or, if REV
is the word tidy, since .clang-tidy was added. For a header, its own source is checked, or the first
one that includes it. FOLDER (default: build) has the compile_commands.json of cmake. Prints each
finding once, and how many sources were checked; the exit status is 1 if anything was found, and 77
without clang-tidy, unless ISTHMUS_REQUIRE_DATA=1 requires all tests.

ISTHMUS_CACHE_DIR (default: ~/.cache/isthmus) keeps which sources were clean: they are not checked
again while they, the headers that they include, their commands, .clang-tidy, clang-tidy and this
script are the same.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

FOLDERS = ("Filters", "Readers", "Plugin")
LONGEST = 900  # seconds that one file may take
INCLUDE = re.compile(r'^\s*#\s*include\s+["<]([^">]+)[">]', re.MULTILINE)
FOUND = re.compile(r"^(\S.*?:\d+:\d+): (?:error|warning): .*$", re.MULTILINE)


def digest(*parts):
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()


class Cache:
    """The sources that were clean, by the content of everything that clang-tidy looks at."""

    def __init__(self, root, build, commands):
        given = os.environ.get("ISTHMUS_CACHE_DIR")
        self.folder = (pathlib.Path(given).resolve() if given else pathlib.Path.home() / ".cache" / "isthmus") / "tidy"
        self.root, self.build, self.commands = root, build, commands
        version = subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True, check=True).stdout
        self.common = digest(version, pathlib.Path(__file__).read_text(), (root / ".clang-tidy").read_text())
        self.files = {}

    def label(self, text):
        """A text without the places of clone and build."""
        return text.replace(str(self.build), "build:").replace(str(self.root), "source:")

    def read(self, path):
        """A digest of a file, and what it includes. Of files of the system, only the state of the file."""
        if path not in self.files:
            if path.is_relative_to(self.root) or path.is_relative_to(self.build):
                text = path.read_text()
                self.files[path] = digest(text), INCLUDE.findall(text)
            else:
                state = path.stat()
                self.files[path] = f"{state.st_size} {state.st_mtime_ns}", []
        return self.files[path]

    def key(self, source):
        command = self.commands[self.root / source]
        folders = [pathlib.Path(name) for name in re.findall(r"-(?:I|isystem) ?(\S+)", command)]
        found, left = {}, [self.root / source]
        while left:
            path = left.pop()
            label = self.label(str(path))
            if label not in found:
                found[label], includes = self.read(path)
                for name in includes:
                    places = [folder / name for folder in (path.parent, *folders)]
                    left += [place for place in places if place.is_file()][:1]
        return digest(self.common, self.label(command), json.dumps(sorted(found.items())))

    def has(self, source):
        known = self.folder / digest(str(source))
        return known.exists() and known.read_text() == self.key(source)

    def add(self, source):
        self.folder.mkdir(parents=True, exist_ok=True)
        partial = self.folder / f"{digest(str(source))}.{os.getpid()}"
        partial.write_text(self.key(source))
        partial.replace(self.folder / digest(str(source)))


def commands_of(build, root, folder):
    """The library's sources in the build, as paths below `root`, and all commands, which are also written to `folder`.

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
    sources = sorted(path for path in below if path.parts[0] in FOLDERS)
    return sources, {path: entry["command"] for path, entry in found.items()}


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


def sources_for(files, root, sources):
    """The sources that show what is in `files`: themselves, their pairs, or the first that includes them."""
    by_header = {}
    for source in sources:
        for name in INCLUDE.findall((root / source).read_text()):
            by_header.setdefault(pathlib.PurePath(name).name, source)
    known, chosen = set(sources), {}
    for path in dict.fromkeys(files):
        if path.parts[0] in FOLDERS and path.suffix in (".h", ".cxx") and (root / path).exists():
            own = path.with_suffix(".cxx")
            source = own if own in known else by_header.get(path.name) if path.suffix == ".h" else None
            if source:
                chosen[source] = True
    return list(chosen)


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


def check(sources, root, build, cache, jobs=1, say=print):
    """(places found, sources that clang-tidy looked at now) of `sources`."""
    seen, looked_at = set(), 0

    def look(source):
        if cache.has(source):
            return None
        result = look_at(source, root, build)
        if result[0] == 0:
            cache.add(source)
        return result

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
    parser.add_argument("--newest", type=int, default=0)
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
    folder = tempfile.TemporaryDirectory()
    sources, commands = commands_of(build, root, pathlib.Path(folder.name))
    cache = Cache(root, build, commands)
    asked = [path.resolve().relative_to(root) for path in given.files]
    base = arrival_of_checks(root) if given.base == "tidy" else given.base
    files = asked or changed_files(root, base)
    chosen = sources_for(files, root, sources)
    if not asked and not given.base:  # sources that no commit names: a shallow clone has few
        chosen += [source for source in sources if source not in set(chosen)]
    newest = chosen[:given.newest] if given.newest > 0 else chosen
    found, looked_at = check(newest, root, pathlib.Path(folder.name), cache, given.jobs)
    print(f"{len(newest)} of {len(chosen)} sources checked (of {len(sources)} in all), {len(newest) - looked_at} of them "
          f"unchanged since they were clean, {found} complaints")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
