#!/usr/bin/env python3
"""check_floors.py complains about each thing it is there for, and about nothing in a tidy tree."""
import pathlib
import tempfile
import unittest

import check_floors

SOURCES = "isthmus_room(\n  SOURCES\n    {names})\n"


class CheckFloors(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("Filters/Support/View.h")
        self.write("Filters/Support/sources.cmake", "isthmus_room()\n")
        self.write("Filters/Meshing/Mesher.h", '#include "View.h"\n')
        self.write("Filters/Meshing/Mesher.cxx", '#include "Mesher.h"\n')
        self.write("Filters/Meshing/sources.cmake", SOURCES.format(names="Mesher"))

    def write(self, name, text=""):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def assert_complains(self, *words):
        complaints = check_floors.check(self.root)[0]
        self.assertEqual(len(complaints), 1, complaints)
        for word in words:
            self.assertIn(word, complaints[0])

    def test_tidy_tree(self):
        self.assertEqual(check_floors.check(self.root), ([], 2))

    def test_arrow_to_a_higher_floor(self):
        self.write("Filters/Support/View.h", '#include "Tube.h"\n')
        self.write("Filters/Curvature/Tube.h")
        self.write("Filters/Curvature/sources.cmake", "isthmus_room()\n")
        self.assert_complains("Support/View.h includes Tube.h", "Curvature")

    def test_arrow_to_a_room_of_the_same_floor(self):
        self.write("Filters/Curvature/Tube.h", '#include "Mesher.h"\n')
        self.write("Filters/Curvature/sources.cmake", "isthmus_room()\n")
        self.assert_complains("Curvature/Tube.h includes Mesher.h")

    def test_reader_that_uses_a_filter(self):
        self.write("Readers/Maps/Map.h", '#include "View.h"\n#include "Mesher.h"\n')
        self.write("Readers/Maps/sources.cmake", "isthmus_room()\n")
        self.assert_complains("Readers/Maps/Map.h includes Mesher.h")

    def test_circle_through_a_source(self):
        self.write("Filters/Meshing/Helper.h", '#include "Mesher.h"\n')
        self.write("Filters/Meshing/Mesher.cxx", '#include "Mesher.h"\n#include "Helper.h"\n')
        self.assert_complains("circle", "Meshing/Helper", "Meshing/Mesher")

    def test_file_outside_the_rooms(self):
        self.write("Filters/Lost.h")
        self.assert_complains("Filters/Lost.h", "no room")

    def test_unlisted_source(self):
        self.write("Filters/Meshing/Forgotten.cxx")
        self.assert_complains("Forgotten.cxx is not in sources.cmake")

    def test_listed_source_that_is_not_there(self):
        self.write("Filters/Meshing/sources.cmake", SOURCES.format(names="Mesher\n    Gone"))
        self.assert_complains("names Gone")

    def test_installed_header_that_includes_another(self):
        self.write("Filters/Meshing/vtkMesher.h", '#include "View.h"\n')
        self.assert_complains("vtkMesher.h includes View.h, which is not installed")

    def test_installed_headers_beside_the_classes(self):
        self.write("Filters/Support/sources.cmake", "isthmus_room(\n  HEADERS\n    View)\n")
        self.write("Filters/Meshing/vtkMesher.h", '#include "View.h"\n')
        self.assertEqual(check_floors.check(self.root)[0], [])
        self.write("Filters/Support/View.h", '#include "Hidden.h"\n')
        self.write("Filters/Support/Hidden.h")
        self.assert_complains("Support/View.h includes Hidden.h, which is not installed")

    def test_installed_header_that_is_not_there(self):
        self.write("Filters/Support/sources.cmake", "isthmus_room(\n  HEADERS\n    Gone)\n")
        self.assert_complains("names Gone.h, which is not there")

    def test_two_classes_of_one_name(self):
        self.write("Filters/Support/View.h", "namespace isthmus\n{\nstruct Box\n{\n};\n}\n")
        self.write("Filters/Meshing/Mesher.h",
                   '#include "View.h"\nnamespace isthmus\n{\nclass Box : public View\n{\n};\n}\n')
        self.assert_complains("class Box is defined in Mesher.h and in View.h")

    def test_two_headers_of_one_name(self):
        self.write("Filters/Support/Mesher.h")
        self.assert_complains("Mesher.h is in")


if __name__ == "__main__":
    unittest.main()
