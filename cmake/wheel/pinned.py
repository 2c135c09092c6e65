"""Metadata of the wheel: it depends on the vtk that pyproject.toml pins for its build."""
import pathlib
import re

PYPROJECT = pathlib.Path(__file__).parents[2] / "pyproject.toml"


def dynamic_metadata(field, settings=None):
    if field != "dependencies":
        raise RuntimeError(f"pinned.py knows dependencies only, not {field}.")
    return [re.search(r'^ *"(vtk==[^"]+)",$', PYPROJECT.read_text(), re.MULTILINE)[1], "numpy"]
