#!/usr/bin/env python3
"""check_modules.py complains about each thing it is there for, and about nothing in a tidy tree."""
import pathlib
import tempfile
import unittest

import check_modules


class CheckModules(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.module("Filters/Core")
        self.write("Filters/Core/View.h")
        self.module("Filters/Remeshing", "DEPENDS\n  Isthmus::FiltersCore\n", SOURCES="Mesher")
        self.write("Filters/Remeshing/Mesher.h", '#include "Core/View.h"\n')
        self.write("Filters/Remeshing/Mesher.cxx", '#include "Remeshing/Mesher.h"\n')

    def write(self, name, text=""):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def module(self, folder, depends="", **lists):
        """Writes vtk.module and CMakeLists.txt of a module."""
        name = "Isthmus::" + folder.replace("/", "")
        self.write(f"{folder}/vtk.module", f"NAME\n  {name}\n{depends}")
        words = "".join(f"\n  {key}\n    {names}" for key, names in lists.items())
        self.write(f"{folder}/CMakeLists.txt", f"isthmus_add_module({name}{words})\n")

    def assert_complains(self, *words):
        complaints = check_modules.check(self.root)[0]
        self.assertEqual(len(complaints), 1, complaints)
        for word in words:
            self.assertIn(word, complaints[0])

    def test_tidy_tree(self):
        self.assertEqual(check_modules.check(self.root), ([], 2))

    def test_undeclared_include(self):
        self.module("Filters/Curvature")
        self.write("Filters/Curvature/Tube.h", '#include "Remeshing/Mesher.h"\n')
        self.assert_complains("Curvature/Tube.h includes Mesher.h of FiltersRemeshing", "DEPENDS")

    def test_header_that_needs_a_private_dependency(self):
        self.module("Filters/Imaging", "PRIVATE_DEPENDS\n  Isthmus::FiltersCore\n")
        self.write("Filters/Imaging/Blur.h", '#include "Core/View.h"\n')
        self.assert_complains("Blur.h includes View.h", "not in DEPENDS")

    def test_declared_and_not_used(self):
        self.write("Filters/Remeshing/Mesher.h")
        self.assert_complains("declares Isthmus::FiltersCore")

    def test_bare_name(self):
        self.write("Filters/Remeshing/Mesher.cxx", '#include "Mesher.h"\n')
        self.assert_complains('write "Remeshing/Mesher.h"')

    def test_circle_through_a_source(self):
        self.write("Filters/Remeshing/Helper.h", '#include "Remeshing/Mesher.h"\n')
        self.write("Filters/Remeshing/Mesher.cxx",
                   '#include "Remeshing/Mesher.h"\n#include "Remeshing/Helper.h"\n')
        self.assert_complains("circle of includes in Filters/Remeshing", "Helper, Mesher")

    def test_circle_of_modules(self):
        self.module("Filters/Core", "DEPENDS\n  Isthmus::FiltersRemeshing\n")
        self.write("Filters/Core/View.h", '#include "Remeshing/Mesher.h"\n')
        self.assert_complains("circle of modules: FiltersCore, FiltersRemeshing")

    def test_cgal_below_a_module_that_is_free_of_it(self):
        self.module("Filters/Atoms", "DEPENDS\n  Isthmus::FiltersRemeshing\n")
        self.write("Filters/Atoms/Ball.h", '#include "Remeshing/Mesher.h"\n')
        self.assertEqual(check_modules.check(self.root)[0], [])
        self.write("Filters/Remeshing/Mesher.h", '#include "Core/View.h"\n#include <CGAL/Surface_mesh.h>\n')
        self.assert_complains("FiltersAtoms is to be free of CGAL, but FiltersRemeshing has it")

    def test_file_outside_the_modules(self):
        self.write("Filters/Lost.h")
        self.assert_complains("Filters/Lost.h is in no module")

    def test_unlisted_source(self):
        self.write("Filters/Remeshing/Forgotten.cxx")
        self.assert_complains("Forgotten.cxx is not in Filters/Remeshing/CMakeLists.txt")

    def test_listed_source_that_does_not_exist(self):
        self.module("Filters/Remeshing", "DEPENDS\n  Isthmus::FiltersCore\n",
                    SOURCES="Mesher\n    Gone")
        self.assert_complains("lists Gone")

    def test_name_of_another_folder(self):
        self.write("Filters/Core/vtk.module", "NAME\n  Isthmus::FiltersOther\n")
        self.assert_complains("Filters/Core is not named Isthmus::FiltersCore")

    def test_installed_header_that_includes_another(self):
        self.write("Filters/Remeshing/vtkMesher.h", '#include "Core/View.h"\n')
        self.assert_complains("vtkMesher.h is installed and includes View.h")

    def test_installed_headers_beside_the_classes(self):
        self.module("Filters/Core", HEADERS="View")
        self.write("Filters/Remeshing/vtkMesher.h", '#include "Core/View.h"\n')
        self.assertEqual(check_modules.check(self.root)[0], [])
        self.write("Filters/Core/View.h", '#include "Core/Hidden.h"\n')
        self.write("Filters/Core/Hidden.h")
        self.assert_complains("Core/View.h is installed and includes Hidden.h")

    def test_installed_header_that_does_not_exist(self):
        self.module("Filters/Core", HEADERS="Gone")
        self.assert_complains("lists Gone.h, which does not exist")

    def test_two_classes_of_one_name(self):
        self.write("Filters/Core/View.h", "namespace isthmus\n{\nstruct Box\n{\n};\n}\n")
        self.write("Filters/Remeshing/Mesher.h",
                   '#include "Core/View.h"\nnamespace isthmus\n{\nclass Box : public View\n{\n};\n}\n')
        self.assert_complains("class Box is defined in Mesher.h and in View.h")

    def test_two_headers_of_one_name(self):
        self.write("Filters/Core/Mesher.h")
        self.assert_complains("Mesher.h is in Filters/Core and in Filters/Remeshing")


if __name__ == "__main__":
    unittest.main()
