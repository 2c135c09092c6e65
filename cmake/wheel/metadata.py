"""Metadata of the package that pyproject.toml leaves to the build.

Version: that of CMakeLists.txt, and ISTHMUS_VERSION_SUFFIX. An index has one file for a version, a Python and a system: the wheels
for a second minor version of VTK need a version of their own, such as 2.0.0.post1.
Dependencies: the minor version of the vtk beside which the wheel is built.
"""
import importlib.metadata
import os
import pathlib
import re

PROJECT = pathlib.Path(__file__).resolve().parents[2] / "CMakeLists.txt"


def dynamic_metadata(field, settings=None):
    if field == "version":
        return re.search(r"project\(Isthmus VERSION ([0-9.]+)", PROJECT.read_text())[1] + os.environ.get("ISTHMUS_VERSION_SUFFIX", "")
    if field == "dependencies":
        major, minor = map(int, importlib.metadata.version("vtk").split(".")[:2])
        return [f"vtk>={major}.{minor},<{major}.{minor + 1}", "numpy"]
    raise RuntimeError(f"metadata.py knows version and dependencies, not {field}.")
