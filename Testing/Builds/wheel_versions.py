"""Which of the wheels of two minor versions of VTK pip takes, with the metadata that cmake/wheel/metadata.py writes for each. The
wheels and those of vtk are empty.

    wheel_versions.py
"""
import importlib.metadata
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest.mock
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "cmake/wheel"))
import metadata  # noqa: E402


def write(folder, name, version, requirements=()):
    head = f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n"
    with zipfile.ZipFile(folder / f"{name}-{version}-py3-none-any.whl", "w") as file:
        info = f"{name}-{version}.dist-info"
        file.writestr(f"{info}/METADATA", head + "".join(f"Requires-Dist: {entry}\n" for entry in requirements))
        file.writestr(f"{info}/WHEEL", "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n")
        file.writestr(f"{info}/RECORD", "")


def chosen(folder, *requirements):
    """Versions that pip would install."""
    done = subprocess.run([sys.executable, "-m", "pip", "install", "--quiet", "--dry-run", "--ignore-installed", "--no-index",
                           "--find-links", str(folder), "--report", "-", *requirements], capture_output=True, text=True,
                          env={**os.environ, "PIP_FIND_LINKS": ""}, check=True)
    return {entry["metadata"]["name"]: entry["metadata"]["version"] for entry in json.loads(done.stdout)["install"]}


def main():
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work)
        write(folder, "numpy", "2.0.0")
        for version in ("9.5.2", "9.6.0", "9.6.2", "9.7.2", "9.8.0"):
            write(folder, "vtk", version)
        for vtk, suffix in (("9.6.2", ""), ("9.7.2", ".post1")):
            with unittest.mock.patch.object(importlib.metadata, "version", lambda _, vtk=vtk: vtk), \
                    unittest.mock.patch.dict(os.environ, ISTHMUS_VERSION_SUFFIX=suffix):
                write(folder, "isthmus", *(metadata.dynamic_metadata(field) for field in ("version", "dependencies")))
        first = metadata.dynamic_metadata("version")
        for requirements, isthmus, vtk in ((["isthmus"], f"{first}.post1", "9.7.2"), (["isthmus", "vtk<9.7"], first, "9.6.2"),
                                           (["isthmus", "vtk==9.6.0"], first, "9.6.0")):
            found = chosen(folder, *requirements)
            assert (found["isthmus"], found["vtk"]) == (isthmus, vtk), f"{requirements}: {found}"
            print(*requirements, ": isthmus", isthmus, "with vtk", vtk)


if __name__ == "__main__":
    main()
