#!/usr/bin/env python3
"""What a build for pip's `vtk` must know of it, and whether an SDK agrees with it.

    check_sdk.py                prints version, folder of the libraries and ABI of strings (0 or 1) of the vtk of this Python
    check_sdk.py VTK_DIR        checks the headers of the SDK whose CMake package is in VTK_DIR: exit status 1, with all that
                                differs, where compiled code would not fit the libraries

Options that must agree, since headers depend on them: the minor version, the width of vtkIdType, the backends of
vtkSMPTools (the size of vtkSMPThreadLocal), whether deprecated members of classes exist, and the namespace of the ABI. The
strings of the C++ library are chosen, not checked. The zlib is that of the SDK: no call of VTK's passes its types. Windows is
not checked, where names of functions are encoded in another way.
"""
import importlib.metadata
import importlib.util
import pathlib
import re
import sys

DEPRECATED = "HasFixedTopology"  # virtual in vtkConvexPointSet unless VTK_LEGACY_REMOVE is on
BACKENDS = ("SEQUENTIAL", "STDTHREAD", "TBB", "OPENMP")


def vtk_of_this_python():
    """Version of the installed vtk, and the folder of its libraries."""
    try:
        version = importlib.metadata.version("vtk")
    except importlib.metadata.PackageNotFoundError:
        sys.exit(f"{sys.executable} has no vtk: install the version that pyproject.toml requires.")
    # Located, not imported: an import would load modules that a build does not need.
    return version, pathlib.Path(importlib.util.find_spec("vtkmodules").origin).parent


def library(folder, name):
    """Read as bytes: names of functions are found without tools of the platform."""
    # In pip's vtk on Linux and on macOS, and in conda's.
    for path in (*folder.glob(f"lib{name}.so"), *folder.glob(f".dylibs/lib{name}*.dylib"),
                 *pathlib.Path(sys.prefix, "lib").glob(f"lib{name}-*")):
        return path.read_bytes()
    sys.exit(f"The library {name} of vtk was not found in {folder}.")


def headers_of(cmake):
    for parent in (cmake, *cmake.parents[:4]):
        for found in (*parent.glob("vtk-*/vtkVersionMacros.h"), *parent.glob("include/vtk-*/vtkVersionMacros.h")):
            return found.parent
    sys.exit(f"No headers of VTK belong to {cmake}: vtkVersionMacros.h is missing.")


def defined(headers, file, name):
    """The value of a macro: None if it is not defined, "" if it has none."""
    found = re.search(rf"^ *# *define +{name}\b *(.*)$", (headers / file).read_text(), re.MULTILINE)
    return found and found[1].strip().strip('"')


def of_headers(headers):
    version = re.fullmatch(r"(\d+\.\d+).*", defined(headers, "vtkVersionMacros.h", "VTK_VERSION"))
    return {"version": version[1],
            "vtkIdType": "int" if defined(headers, "vtkOptions.h", "VTK_USE_64BIT_IDS") is None else "long long",
            "backends of vtkSMPTools": [name for name in BACKENDS
                                        if defined(headers, "vtkSMP.h", f"VTK_SMP_ENABLE_{name}") == "1"],
            "deprecated members": DEPRECATED in (headers / "vtkConvexPointSet.h").read_text() and
                                  defined(headers, "vtkLegacy.h", "VTK_LEGACY_REMOVE") is None,
            "namespace of the ABI": defined(headers, "vtkABINamespace.h", "VTK_ABI_NAMESPACE_NAME") or "none"}


def of_libraries(version, folder):
    core = library(folder, "vtkCommonCore")
    wrapper = next(folder.glob("vtkCommonDataModel.*.so")).read_bytes()
    # The one function that has the namespace and vtkIdType in its name.
    function = re.search(rb"_ZN(?:\d+(\w+?))?9vtkIdList14InsertUniqueIdE([xli])", core)
    if not function:
        sys.exit(f"vtkIdList::InsertUniqueId() was not found in the libraries of vtk {version} ({folder}).")
    return {"version": ".".join(version.split(".")[:2]),
            "vtkIdType": {b"x": "long long", b"l": "long", b"i": "int"}[function[2]],
            "backends of vtkSMPTools": [name for number, name in enumerate(BACKENDS)
                                        if f"vtkSMPToolsImplILNS1_11BackendTypeE{number}EE10Initialize".encode() in core],
            "deprecated members": f"{DEPRECATED}\0".encode() in wrapper,
            "namespace of the ABI": function[1].decode() if function[1] else "none"}


def main():
    version, folder = vtk_of_this_python()
    if len(sys.argv) == 1:
        # manylinux2014 is compiled with the C++ library's strings of before 2011.
        print(version, folder, int(sys.platform == "linux" and b"__cxx11" in library(folder, "vtkCommonCore")), sep="\n")
        return
    if sys.platform == "win32":
        return
    headers = headers_of(pathlib.Path(sys.argv[1]).resolve())
    sdk, installed = of_headers(headers), of_libraries(version, folder)
    differences = [f"  {name}: {sdk[name]} in the SDK, {installed[name]} in the libraries"
                   for name in sdk if sdk[name] != installed[name]]
    if differences:
        sys.exit(f"The SDK of VTK in {headers} does not fit the installed vtk {version} ({folder}); code compiled with it would "
                 "crash. Name another one in ISTHMUS_VTK_SDK, or unset it. They differ in\n" + "\n".join(differences))


if __name__ == "__main__":
    main()
