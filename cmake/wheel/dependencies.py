"""Metadata of the wheel: it depends on the minor version of the vtk that it is built against."""
import importlib.metadata


def dynamic_metadata(field, settings=None):
    if field != "dependencies":
        raise RuntimeError(f"dependencies.py knows dependencies only, not {field}.")
    major, minor = map(int, importlib.metadata.version("vtk").split(".")[:2])
    return [f"vtk>={major}.{minor},<{major}.{minor + 1}", "numpy"]
