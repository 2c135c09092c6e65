#!/usr/bin/env python3
"""An SDK for the Linux wheel of VTK: what find_package(VTK) needs to build against pip's `vtk`.

    linux_sdk.py FOLDER VERSION

Where no SDK is given (ISTHMUS_VTK_SDK), this one is assembled: headers, hierarchy files, CMake package and wrapping
programs of Debian testing's packages of VTK, which are unpacked into FOLDER, not installed, and adapted to the libraries
of the wheel. Nothing of VTK is compiled. The minor version must be that of VERSION, which is the installed vtk's. The
programs need a newer C library than that of this machine may be, so they run with the one of testing.

Libraries are in the folder ISTHMUS_VTK_LIBRARIES, a variable of CMake, so that one SDK serves every Python. The archive is
that of the machine's apt configuration, or ISTHMUS_MIRROR. The last line of the output is the folder for VTK_DIR. A complete
FOLDER is left as it is.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from debian_archive import Archive, Unreachable  # noqa: E402

SUITE = "testing"
TOOLS = ("vtkWrapHierarchy", "vtkWrapPython", "vtkWrapPythonInit")


def minor(version):
    return ".".join(version.split(".")[:2])


def fetch(version, work):
    """Debian's files in WORK/root, and their version."""
    for program in ("apt-get", "dpkg-deb"):
        if not shutil.which(program):
            raise Unreachable(f"{program} is not installed.")
    archive = Archive(SUITE, work)
    archive.update()
    packages = ("libvtk9-dev", "vtk9", "python3-vtk9", f"libvtk{minor(version)}", "libc6")
    found = archive.versions(packages)
    if len(found) < len(packages) or minor(found["libvtk9-dev"]) != minor(version):
        raise Unreachable(f"Debian {SUITE} has VTK {found.get('libvtk9-dev', '(none)')}, not {minor(version)}.")
    root = work / "root"
    root.mkdir()
    archive.unpack(packages, root)
    return root / "usr", re.match(r"[\d.]+", found["libvtk9-dev"])[0]


def copy(usr, folder, version):
    """What the build reads or runs; the same places below FOLDER as below /usr. Returns the folder of the CMake package."""
    name = f"vtk-{minor(version)}"
    (cmake,) = usr.glob(f"lib/*/cmake/{name}")
    lib = cmake.parents[1]
    target = folder / lib.relative_to(usr)
    shutil.copytree(usr / "include" / name, folder / "include" / name)
    shutil.copytree(cmake, target / "cmake" / name)
    shutil.copytree(lib / name / "hierarchy", target / name / "hierarchy")
    tools = folder / "tools"
    tools.mkdir()
    (loader,) = [*lib.glob("ld-linux*.so.*"), *lib.glob("ld.so.*")][:1]
    for path in (loader, lib / "libc.so.6", *lib.glob("libvtkWrappingTools-*.so.1")):
        shutil.copy(path, tools)
    (folder / "bin").mkdir()
    for tool in TOOLS:
        shutil.copy(usr / "bin" / f"{tool}-{minor(version)}", tools / tool)
        program = folder / "bin" / f"{tool}-{minor(version)}"
        program.write_text(f"#!/bin/sh\nexec '{tools}/{loader.name}' --library-path '{tools}' '{tools}/{tool}' \"$@\"\n")
        program.chmod(0o755)
    return target / "cmake" / name


def edit(path, *replacements):
    """Regular expressions with what replaces each; one that is not found is an error."""
    text = path.read_text()
    for pattern, replacement in replacements:
        text, count = re.subn(pattern, replacement, text, flags=re.MULTILINE)
        if not count:
            sys.exit(f"linux_sdk.py: {path.name} has no {pattern!r}: this package of VTK is of another form.")
    path.write_text(text)


def adapt(cmake, headers):
    """The targets are the libraries of the wheel; options that it was not built with are off."""
    libraries = "${ISTHMUS_VTK_LIBRARIES}"
    # The wheel has other modules than Debian's VTK, so that not all files exist.
    unchecked = (r"^list\(APPEND _cmake_import_check_.*$", "")
    edit(cmake / "VTK-targets-none.cmake",
         unchecked,
         (r"libvtkWrappingPythonCore[\d.]+-", "libvtkWrappingPythonCore${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}-"),
         (r"\$\{_IMPORT_PREFIX\}/lib/[^/\"]+/(lib[^\"]+?)-9\.\d+\.so\.[\d.]+", rf"{libraries}/\1.so"),
         (r"\"(lib[^\"/]+?)-9\.\d+\.so\.\d+\"", r'"\1.so"'))
    edit(cmake / "VTKPython-targets-none.cmake",
         unchecked,
         (r"\$\{_IMPORT_PREFIX\}/lib/python3/dist-packages/vtkmodules/(\w+)\.[^\"]+", rf"{libraries}/\1.${{Python3_SOABI}}.so"))
    edit(cmake / "VTK-targets.cmake",
         (r";TBB::tbb", ""),
         (r"^foreach\(_target (\"viskores::\w+\" )+\)", "foreach(_target )"))
    edit(cmake / "vtk-config.cmake",
         (r"^(set\(\"\S+_HAS_(?:VISKORES|VTKm)\" )\"ON\"", r'\1"OFF"'),
         (r"_SMP_BACKENDS\" \"TBB;", '_SMP_BACKENDS" "'))
    # What headers of the modules in use include. The rest of Debian's list is needed by other modules.
    (cmake / "VTK-vtk-module-find-packages.cmake").write_text("\n".join(
        f"find_package({package} REQUIRED)" for package in ("Threads", "ZLIB", "nlohmann_json")) + "\n")
    # Deprecated members are part of the layout of classes.
    edit(headers / "vtkLegacy.h",
         (r"^#define VTK_LEGACY_REMOVE$", "/* #undef VTK_LEGACY_REMOVE */"),
         (r"^/\* #undef VTK_LEGACY_SILENT \*/$", "#define VTK_LEGACY_SILENT"))
    edit(headers / "vtkSMP.h",
         (r"VTK_SMP_TBB$", "VTK_SMP_Sequential"),
         (r"(VTK_SMP_BACKEND) \"TBB\"", r'\1 "Sequential"'),
         (r"(VTK_SMP_ENABLE_TBB) 1", r"\1 0"),
         (r"(VTK_SMP_DEFAULT_IMPLEMENTATION_TBB) 1", r"\1 0"),
         (r"(VTK_SMP_DEFAULT_IMPLEMENTATION_SEQUENTIAL) 0", r"\1 1"))


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    folder, version = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    done = folder / "complete.txt"
    # One of another place or form is made again: programs name their folder.
    form = f"{minor(version)} {folder}\n{pathlib.Path(__file__).read_text()}"
    if not (done.exists() and done.read_text() == form):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        try:
            with tempfile.TemporaryDirectory() as work:
                usr, found = fetch(version, pathlib.Path(work))
                cmake = copy(usr, folder, found)
        except Unreachable as reason:
            sys.exit(f"There is no SDK for vtk {version}. {reason} Name a folder with one in ISTHMUS_VTK_SDK: Kitware's "
                     "`vtk-sdk` of this version, unpacked, or an installed VTK of the same options.")
        adapt(cmake, folder / "include" / f"vtk-{minor(version)}")
        done.write_text(form)
    (config,) = folder.glob("lib/*/cmake/vtk-*/vtk-config.cmake")
    print(config.parent)


if __name__ == "__main__":
    main()
