#!/usr/bin/env python3
"""Compiles sources of Filters and Readers for Windows or macOS, without these systems.

    other_targets.py TARGET BUILD [PATTERN]      TARGET: x86_64-windows-gnu or aarch64-macos

The compiler is zig, from PyPI's package `ziglang`, which has headers of these systems' C and C++ libraries. Checked are all
sources that include, also through other headers, neither VTK nor CGAL, Boost or a compiled library: of Eigen, gemmi and
nlohmann-json this machine's headers are used. They are compiled with the flags that they have in BUILD. PATTERN: only sources
whose path matches this regular expression.

Compiler and results are kept as other_systems.py keeps its own, and a source is compiled again when what it depends on has
changed. Where PyPI cannot be reached, the check fails.
"""
import fcntl
import pathlib
import re
import shutil
import subprocess
import sys

import other_systems
from other_systems import ROOT

ZIG = "0.17.1"
TARGETS = {"x86_64-windows-gnu": ("Windows", "Windows"), "aarch64-macos": ("macOS", "Mac|Posix")}
# Sources for one system are called after it.
ONE_SYSTEM = re.compile(r"(Windows|Mac|Linux|Posix)\.cxx$")
# Header-only, and for any system.
LIBRARIES = ("Eigen", "unsupported", "gemmi", "nlohmann")
INCLUDE = re.compile(r'^ *# *include *([<"])([^>"]+)', re.MULTILINE)
# Headers of libraries that are not here for these systems.
FOREIGN = re.compile(r"vtk(?!Isthmus\w+Module\.h)|CGAL/|boost/|bzlib|zlib|isa-l/|tao/")


class Target:
    """zig and its results for one target, in the cache, which is locked as long as the object lives."""

    def __init__(self, target):
        self.name = TARGETS[target][0]
        self.sources = TARGETS[target][1]
        self.folder = other_systems.cache_folder() / "other_targets" / target
        self.folder.mkdir(parents=True, exist_ok=True)
        self.lock = (self.folder.parent / "lock").open("w")
        fcntl.flock(self.lock, fcntl.LOCK_EX)
        packages = self.folder.parent / f"zig-{ZIG}"
        zig = packages / "ziglang/zig"
        if not zig.exists():
            shutil.rmtree(packages, ignore_errors=True)
            done = subprocess.run([sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--only-binary", ":all:", "--target",
                                   str(packages), f"ziglang=={ZIG}"], capture_output=True, text=True)
            if done.returncode:
                sys.exit(f"{self.name}: zig cannot be fetched from PyPI.\n{done.stderr.strip()}")
        headers = self.folder.parent / "headers"
        headers.mkdir(exist_ok=True)
        for name in LIBRARIES:
            link = headers / name
            found = [place / name for place in (pathlib.Path("/usr/include"), pathlib.Path("/usr/include/eigen3"))
                     if (place / name).exists()]
            if not found:
                sys.exit(f"{self.name}: the headers {name} were not found.")
            link.unlink(missing_ok=True)
            link.symlink_to(found[0])
        # Of VTK, headers of modules include this one alone, which has no other content unless VTK is put into a namespace.
        (headers / "vtkABINamespace.h").write_text("#define VTK_ABI_NAMESPACE_BEGIN\n#define VTK_ABI_NAMESPACE_END\n")
        self.compiler = ["env", f"ZIG_GLOBAL_CACHE_DIR={self.folder.parent / 'zig-cache'}",
                         f"ZIG_LOCAL_CACHE_DIR={self.folder.parent / 'zig-cache'}", str(zig), "c++", "-target", target]
        # Warnings are those of another compiler than the project's.
        self.flags = ["-c", "-w", "-O0", "-fno-sanitize=all", "-isystem", str(headers)]
        self.fingerprint = other_systems.digest(ZIG, target, pathlib.Path(__file__).read_text())

    def report(self):
        return f"zig {ZIG}"

    def fits(self, source):
        return not ONE_SYSTEM.search(source.name) or bool(re.search(rf"({self.sources})\.cxx$", source.name))


def foreign_headers(path, known):
    """Headers of other libraries that a file includes, also through headers of Isthmus."""
    if path not in known:
        known[path] = set()
        found = set()
        for quote, name in INCLUDE.findall(path.read_text()):
            ours = next((place for place in (path.parent / name, ROOT / "Filters" / name, ROOT / "Readers" / name)
                         if quote == '"' and place.exists()), None)
            if ours:
                found |= foreign_headers(ours, known)
            elif FOREIGN.match(name):
                found.add(name)
        known[path] = found
    return known[path]


def sources_for(target, build):
    """Pairs of a source and its flags. Those of another system than this have the flags of their neighbours."""
    here = dict(other_systems.sources_of(build))
    by_folder = {source.parent: flags for source, flags in here.items()}
    known = {}
    return [(source, here.get(source, by_folder.get(source.parent)))
            for folder in ("Filters", "Readers") for source in sorted((ROOT / folder).glob("*/*.cxx"))
            if source.parent in by_folder and target.fits(source) and not foreign_headers(source, known)]


def main(name, build, pattern=""):
    target = Target(name)
    build = pathlib.Path(build).resolve()
    pairs = [pair for pair in sources_for(target, build) if re.search(pattern, str(pair[0]))]
    if not pairs:
        sys.exit(f"other_targets.py: no source matches {pattern}.")
    other_systems.check_sources(target, build, pairs)


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4) or sys.argv[1] not in TARGETS:
        sys.exit(__doc__)
    main(*sys.argv[1:])
