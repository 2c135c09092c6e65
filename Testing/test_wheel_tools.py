#!/usr/bin/env python3
"""What the Python wheel is built with: the message about missing packages, the check of an SDK of VTK, and the recipes for
conda-forge and ParaView's superbuild, which name what the build needs."""
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "cmake/wheel"))
import check_sdk  # noqa: E402
import metadata  # noqa: E402

NEEDS = (ROOT / "cmake/IsthmusWheelNeeds.cmake").read_text()
PACKAGES = ["g++", *re.findall(r"=([\w+-]+-dev)\b", NEEDS)]
# conda-forge's names; upstream's gemmi, which it has, brings PEGTL.
CONDA = {"libcgal-dev": "cgal-cpp", "libeigen3-dev": "eigen", "gemmi-dev": "gemmi", "nlohmann-json3-dev": "nlohmann_json",
         "libboost-dev": "libboost-headers", "libgmp-dev": "gmp", "libmpfr-dev": "mpfr", "libisal-dev": "isa-l",
         "libbz2-dev": "bzip2", "zlib1g-dev": "zlib"}


class Needs(unittest.TestCase):
    def test_one_message_names_all_packages(self):
        """On a system without headers and compiler: folders below another root, and a PATH with CMake alone."""
        with tempfile.TemporaryDirectory() as work:
            for program in ("cmake", "ninja"):
                os.symlink(shutil.which(program), f"{work}/{program}")
            done = subprocess.run(
                [f"{work}/cmake", "-S", str(ROOT), "-B", f"{work}/build", "-G", "Ninja", "-DISTHMUS_WHEEL=ON",
                 f"-DCMAKE_FIND_ROOT_PATH={work}", "-DCMAKE_FIND_ROOT_PATH_MODE_INCLUDE=ONLY"],
                capture_output=True, text=True, env={"PATH": work, "HOME": work})
        self.assertNotEqual(done.returncode, 0)
        self.assertEqual(done.stderr.count("CMake Error"), 1, done.stderr)
        self.assertEqual(re.search(r"apt install (.*)", done.stderr)[1].split(), PACKAGES)

    def test_the_guide_names_the_same(self):
        page = (ROOT / "Documentation/installation.md").read_text()
        self.assertEqual(re.search(r"To build it, Debian needs `([^`]*)`", page)[1].split(), PACKAGES)


class SDK(unittest.TestCase):
    """Headers and libraries with what check_sdk.py reads of them; the real ones are those of Build.Wheel."""

    def setUp(self):
        work = tempfile.TemporaryDirectory()
        self.addCleanup(work.cleanup)
        self.headers, self.libraries = pathlib.Path(work.name) / "headers", pathlib.Path(work.name) / "libraries"
        self.headers.mkdir()
        self.libraries.mkdir()
        self.header("vtkVersionMacros.h", '#define VTK_VERSION "9.6.2"')
        self.header("vtkOptions.h", "#define VTK_USE_64BIT_IDS")
        self.header("vtkSMP.h", "#define VTK_SMP_ENABLE_SEQUENTIAL 1\n#define VTK_SMP_ENABLE_STDTHREAD 1\n#define VTK_SMP_ENABLE_TBB 0\n")
        self.header("vtkLegacy.h", "/* #undef VTK_LEGACY_REMOVE */")
        self.header("vtkABINamespace.h", "#define VTK_ABI_NAMESPACE_NAME ")
        self.header("vtkConvexPointSet.h", "virtual vtkTypeBool HasFixedTopology();")
        self.core = "_ZN9vtkIdList14InsertUniqueIdEx\0" + "".join(
            f"_ZN3vtk6detail3smp15vtkSMPToolsImplILNS1_11BackendTypeE{number}EE10InitializeEi\0" for number in (0, 1))
        self.library(self.core)
        (self.libraries / "vtkCommonDataModel.cpython-312.so").write_text("\0HasFixedTopology\0")

    def header(self, name, text):
        (self.headers / name).write_text(text)

    def library(self, text):
        (self.libraries / "libvtkCommonCore.so").write_text(text)

    def differences(self, version="9.6.0"):
        sdk, installed = check_sdk.of_headers(self.headers), check_sdk.of_libraries(version, self.libraries)
        return {name: (sdk[name], installed[name]) for name in sdk if sdk[name] != installed[name]}

    def test_what_fits(self):
        self.assertEqual(self.differences(), {})

    def test_what_differs(self):
        self.assertEqual(list(self.differences("9.7.2")), ["version"])
        self.header("vtkSMP.h", "#define VTK_SMP_ENABLE_SEQUENTIAL 1\n#define VTK_SMP_ENABLE_STDTHREAD 1\n#define VTK_SMP_ENABLE_TBB 1\n")
        self.header("vtkLegacy.h", "#define VTK_LEGACY_REMOVE")
        self.assertEqual(self.differences(), {
            "backends of vtkSMPTools": (["SEQUENTIAL", "STDTHREAD", "TBB"], ["SEQUENTIAL", "STDTHREAD"]),
            "deprecated members": (False, True)})

    def test_ids_and_namespace(self):
        self.library(self.core.replace("IdEx", "IdEi"))
        self.assertEqual(self.differences(), {"vtkIdType": ("long long", "int")})
        self.library(self.core.replace("_ZN9vtkIdList", "_ZN3v969vtkIdList"))
        self.assertEqual(self.differences(), {"namespace of the ABI": ("none", "v96")})


class Metadata(unittest.TestCase):
    def test_of_a_second_minor_version(self):
        with unittest.mock.patch("importlib.metadata.version", lambda _: "9.7.2"), \
                unittest.mock.patch.dict(os.environ, ISTHMUS_VERSION_SUFFIX=".post1"):
            self.assertRegex(metadata.dynamic_metadata("version"), r"^\d+\.\d+\.\d+\.post1$")
            self.assertEqual(metadata.dynamic_metadata("dependencies")[0], "vtk>=9.7,<9.8")


class Recipes(unittest.TestCase):
    def setUp(self):
        self.project = (ROOT / "CMakeLists.txt").read_text()
        self.recipe = yaml.safe_load((ROOT / "cmake/recipes/conda-forge.yaml").read_text())

    def test_conda_forge(self):
        self.assertEqual(self.recipe["context"]["version"], re.search(r"project\(Isthmus VERSION (\S+)", self.project)[1])
        self.assertEqual({*CONDA, "g++", "tao-pegtl-dev"}, set(PACKAGES))
        outputs = {output["package"]["name"]: output for output in self.recipe["outputs"]}
        self.assertEqual(set(outputs), {"isthmus", "paraview-isthmus"})
        for output in outputs.values():
            host = {entry.split()[0]: entry for entry in output["requirements"]["host"]}
            self.assertEqual(set(CONDA.values()) - set(host), set())
            self.assertLessEqual({"build", "host", "run"}, set(output["requirements"]))
            self.assertTrue(output["tests"] and output["build"]["script"]["content"])
        ranges = re.search(r'"vtk(>=[^"]+)"', (ROOT / "pyproject.toml").read_text())[1]
        self.assertIn(f"vtk-base {ranges}", outputs["isthmus"]["requirements"]["host"])
        self.assertIn("ISTHMUS_VTK_SDK", outputs["isthmus"]["build"]["script"]["env"])
        for path in self.recipe["about"]["license_file"]:
            self.assertTrue((ROOT / path).exists(), path)

    def test_superbuild(self):
        """The file is run with a stand-in for the superbuild's function, which prints its arguments."""
        with tempfile.TemporaryDirectory() as work:
            script = pathlib.Path(work) / "run.cmake"
            script.write_text('function (superbuild_add_project name)\n  message("${name};${ARGN}")\nendfunction ()\n'
                              f'include("{ROOT}/cmake/recipes/superbuild.cmake")\n')
            done = subprocess.run(["cmake", "-P", str(script)], capture_output=True, text=True, check=True)
        name, *words = done.stderr.strip().split(";")
        self.assertEqual(name, "isthmus")
        options = [word for word in words if word.startswith("-D")]
        for option in options:
            known = re.match(r"-D(\w+)", option)[1]
            self.assertTrue(known.startswith("CMAKE_") or re.search(rf"option\({known}\b", self.project), option)
        for path in words[words.index("LICENSE_FILES") + 1:words.index("SPDX_LICENSE_IDENTIFIER")]:
            self.assertTrue((ROOT / path).exists(), path)
        self.assertIn("paraview", words[words.index("DEPENDS") + 1:words.index("LICENSE_FILES")])

    def test_filled(self):
        version = self.recipe["context"]["version"]
        with tempfile.TemporaryDirectory() as work:
            tarball, out = pathlib.Path(work) / f"isthmus-{version}.tar.gz", pathlib.Path(work) / "out"
            tarball.write_bytes(b"sources")
            subprocess.run([sys.executable, "-B", str(ROOT / "cmake/recipes/fill.py"), str(tarball), "someone", str(out)], check=True)
            text, lines = (out / "recipe.yaml").read_text(), (out / "versions.cmake").read_text()
        recipe = yaml.safe_load(text)
        self.assertEqual(recipe["source"]["sha256"], hashlib.sha256(b"sources").hexdigest())
        self.assertNotIn("ISTHMUS_OWNER", text)
        self.assertIn(f'URL_MD5 {hashlib.md5(b"sources").hexdigest()})', lines)
        self.assertEqual(re.search(r'URL +"(.*)"', lines)[1], recipe["source"]["url"].replace("${{ version }}", version))


if __name__ == "__main__":
    unittest.main()
