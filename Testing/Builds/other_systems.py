#!/usr/bin/env python3
"""Compiles the sources of Filters and Readers against the libraries of another version of Debian.

    other_systems.py SUITE BUILD [PATTERN]

Fetches the packages with the headers of CGAL, gemmi, VTK, Boost, Eigen and the C library of SUITE (trixie,
testing) from the archive and unpacks them; nothing is installed, and root is not needed. Each source is compiled by
`g++ -fsyntax-only` with the flags it has in BUILD (compile_commands.json): templates are instantiated, but no code is
generated. Plugin, wrapping and tests are not covered. PATTERN: only sources whose path matches this regular expression.

ISTHMUS_CACHE_DIR (default: ~/.cache/isthmus) keeps headers and results. A source that compiled is not compiled again while
it, all headers of Isthmus that it includes, the names of all headers, flags, compiler, this script and versions of packages
are the same. An archive that cannot be reached is a failure.
"""
import concurrent.futures
import fcntl
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "cmake"))
from debian_archive import Archive, Unreachable  # noqa: E402

SYSTEMS = {"trixie": "Debian 13", "testing": "Debian testing"}
# The first alternative that the archive has; the libraries named in the report come first.
PACKAGES = ("libcgal-dev", "libgemmi-dev|gemmi-dev", "libvtk9-dev", "libboost-dev", "libeigen3-dev", "libgmp-dev",
            "libmpfr-dev", "libtbb-dev", "libisal-dev", "libbz2-dev", "zlib1g-dev", "tao-pegtl-dev", "nlohmann-json3-dev", "libc6-dev",
            "linux-libc-dev")
REPORTED = 5
COMPILER = "g++"
THREADS = 2  # as ctest reserves for each of these tests


def digest(*parts):
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()


def cache_folder():
    given = os.environ.get("ISTHMUS_CACHE_DIR")
    return pathlib.Path(given).resolve() if given else pathlib.Path.home() / ".cache" / "isthmus"


def candidates(archive):
    """The version of each package of PACKAGES. libboost-dev is a metapackage: the one it depends on is added."""
    names = " ".join(PACKAGES).replace("|", " ").split()
    depends = archive.apt("apt-cache", "depends", "libboost-dev").stdout
    names += re.findall(r"Depends: (libboost[\d.]+-dev)", depends)
    versions = archive.versions(names)
    chosen = {}
    for entry in PACKAGES:
        name = next((name for name in entry.split("|") if name in versions), None)
        if name is None:
            raise Unreachable(f"{archive.address} has no package {entry.replace('|', ' or ')}.")
        chosen[name] = versions[name]
    for name in versions.keys() - chosen.keys():
        if name.startswith("libboost"):
            chosen[name] = versions[name]
    return chosen


class System:
    """Headers of a suite, unpacked in the cache, which is locked as long as the object lives."""

    def __init__(self, suite):
        self.name = SYSTEMS[suite]
        self.folder = cache_folder() / "other_systems" / suite
        self.folder.mkdir(parents=True, exist_ok=True)
        self.lock = (self.folder / "lock").open("w")
        fcntl.flock(self.lock, fcntl.LOCK_EX)
        archive = Archive(suite, self.folder)
        archive.update()
        self.versions = candidates(archive)
        fingerprint = json.dumps(self.versions, sort_keys=True)
        self.headers = self.folder / "headers"
        known = self.folder / "headers.json"
        if not known.exists() or known.read_text() != fingerprint:
            known.unlink(missing_ok=True)
            shutil.rmtree(self.headers, ignore_errors=True)
            self.headers.mkdir()
            archive.unpack(list(self.versions), self.headers)
            known.write_text(fingerprint)
        search, compiler = self.search_path()
        self.compiler = [COMPILER]
        self.flags = ["-fsyntax-only", "-nostdinc"]
        for folder in search:
            self.flags += ["-isystem", str(folder)]
        self.fingerprint = digest(fingerprint, compiler, pathlib.Path(__file__).read_text())

    def search_path(self):
        """Header folders: the compiler's own and the suite's, nothing else of this machine; and the compiler's version."""
        output = subprocess.run([COMPILER, "-E", "-v", "-x", "c++", "/dev/null"], capture_output=True, text=True,
                                env={**os.environ, "LC_ALL": "C"}).stderr
        folders = re.search(r"#include <\.\.\.> search starts here:\n(.*?)\nEnd of", output, re.DOTALL)[1].split()
        own = [folder for folder in map(os.path.realpath, folders) if "/c++/" in folder or "/lib/gcc/" in folder]
        include = self.headers / "usr/include"
        triplet = re.search(r"^Target: (.*)$", output, re.M)[1]
        version = re.search(r"^gcc version .*$", output, re.M)[0]
        return [*own, *include.glob("vtk-9*"), include / "eigen3", include / triplet, include], version

    def report(self):
        return ", ".join(f"{name.removeprefix('lib').removesuffix('-dev')} {re.sub(r'^.*:|[-+].*$', '', version)}"
                         for name, version in list(self.versions.items())[:REPORTED])


def sources_of(build):
    """Pairs of a source of Filters and Readers and its flags. Sources compiled in groups are taken apart."""
    pairs = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = pathlib.Path(entry["file"])
        arguments = shlex.split(entry["command"])
        if "Unity" in path.parts:
            paths = [pathlib.Path(name) for name in re.findall(r'^#include "(.*)"$', path.read_text(), re.M)]
        else:
            paths = [path]
        flags = [flag for flag in arguments if flag.startswith(("-D", "-W", "-f", "-std=")) or
                 flag.startswith(("-I" + str(build), "-I" + str(ROOT)))]
        for path in paths:
            if path.is_relative_to(ROOT / "Filters") or path.is_relative_to(ROOT / "Readers"):
                pairs[path] = flags
    if not pairs:
        sys.exit(f"other_systems.py: {build}/compile_commands.json names no source of Filters or Readers.")
    return sorted(pairs.items())


class Checker:
    def __init__(self, system, build):
        self.system = system
        self.build = build
        self.hashes = {}
        # A new header may be found before one of the same name.
        names = {path.name for folder in (ROOT / "Filters", ROOT / "Readers", build / "Filters", build / "Readers")
                 for path in folder.rglob("*.h")}
        self.header_names = digest(*sorted(names))

    def label(self, path):
        """A path that does not depend on where clone and build are."""
        path = pathlib.Path(path)
        for name, folder in (("build", self.build), ("source", ROOT)):
            if path.is_relative_to(folder):
                return f"{name}:{path.relative_to(folder)}"
        return str(path)

    def hash_of(self, label):
        if label not in self.hashes:
            name, _, rest = label.partition(":")
            path = {"build": self.build, "source": ROOT}[name] / rest if rest else pathlib.Path(label)
            self.hashes[label] = digest(path.read_text()) if path.exists() else ""
        return self.hashes[label]

    def check(self, source, flags, text=None):
        """The messages of `source`, or of `text` in its place; whether the compiler ran for them."""
        relative = str(source.relative_to(ROOT))
        text = source.read_text() if text is None else text
        key = digest(self.system.fingerprint, self.header_names, text, *(re.sub(re.escape(str(self.build)), "build", flag)
                                                      .replace(str(ROOT), "source") for flag in flags))
        known = self.system.folder / "results" / (digest(relative, text) + ".json")
        if known.exists():
            result = json.loads(known.read_text())
            if result["key"] == key and all(value and self.hash_of(name) == value
                                            for name, value in result["headers"].items()):
                return "", False
        with tempfile.TemporaryDirectory() as work:
            dependencies = pathlib.Path(work) / "dependencies"
            # Read from the standard input, messages name the path in the repository.
            done = subprocess.run([*self.system.compiler, "-iquote", str(source.parent), *flags, *self.system.flags, "-MMD", "-MF",
                                   str(dependencies), "-MT", "x", "-o", f"{work}/object", "-x", "c++", "-"], input=f'# 1 "{relative}"\n{text}', capture_output=True, text=True, cwd=ROOT,
                                  env={**os.environ, "LC_ALL": "C"})
            names = re.split(r"(?<!\\)\s+", dependencies.read_text().replace("\\\n", " ").strip())[1:] \
                if dependencies.exists() else []
        if done.returncode:
            return done.stderr or "the compiler was stopped", True
        names = [name.replace("\\ ", " ") for name in names]
        headers = sorted({self.label(os.path.realpath(ROOT / name)) for name in names
                          if name not in ("-", relative) and not name.endswith("-stdin.cpp")})
        known.parent.mkdir(exist_ok=True)
        partial = known.with_suffix(f".{os.getpid()}")
        partial.write_text(json.dumps({"key": key, "headers": {name: self.hash_of(name) for name in headers}}))
        partial.replace(known)
        return "", True


def errors_of(system, source, messages):
    """One line for each error, with the names of system and source; everything where the compiler gave none."""
    relative = str(source.relative_to(ROOT))
    lines = [line for line in messages.splitlines() if re.search(r"\b(fatal )?error: ", line)]
    return "\n".join(f"{system.name}: " + (line if line.startswith(relative) else f"{relative}: {line}")
                     for line in lines or messages.splitlines())


def check_sources(system, build, pairs):
    """Compiles the pairs of a source and its flags, prints what fails, and ends the program."""
    start = time.monotonic()
    checker = Checker(system, build)
    with concurrent.futures.ThreadPoolExecutor(THREADS) as pool:
        results = list(pool.map(lambda pair: checker.check(*pair), pairs))
    for (source, _), (messages, _) in zip(pairs, results):
        if messages:
            print(errors_of(system, source, messages))
    failed = sum(bool(messages) for messages, _ in results)
    ran = sum(ran for _, ran in results)
    print(f"{system.name} ({system.report()}): sources: {len(results)}, compiled now: {ran} in "
          f"{time.monotonic() - start:.0f} s, failed: {failed}")
    sys.exit(bool(failed))


def check_all(suite, build, pattern):
    system = System(suite)
    # Those with most to instantiate first.
    pairs = sorted(((source, flags) for source, flags in sources_of(build) if re.search(pattern, str(source))),
                   key=lambda pair: "CGAL" not in pair[0].read_text())
    if not pairs:
        sys.exit(f"other_systems.py: no source matches {pattern}.")
    check_sources(system, build, pairs)


def main(suite, build, pattern=""):
    for program in (COMPILER, "apt-get", "dpkg-deb"):
        if not shutil.which(program):
            sys.exit(f"{SYSTEMS[suite]}: the headers cannot be checked, since {program} is not installed.")
    try:
        check_all(suite, pathlib.Path(build).resolve(), pattern)
    except Unreachable as reason:
        sys.exit(f"{SYSTEMS[suite]}: the headers cannot be fetched. {reason}")
    except (OSError, subprocess.CalledProcessError, ValueError, re.error) as reason:
        sys.exit(f"{SYSTEMS[suite]}: the headers cannot be checked: {reason}")


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4) or sys.argv[1] not in SYSTEMS:
        sys.exit(__doc__)
    main(*sys.argv[1:])
