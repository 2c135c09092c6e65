#!/usr/bin/env python3
"""check_contracts.py complains about each thing it is there for, and about nothing in a tidy tree."""
import pathlib
import tempfile
import unittest

import check_contracts


class CheckContracts(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("Filters/Core/View.h", "/// @throws std::runtime_error\nvoid Look();\n")
        self.write("Filters/Core/View.cxx",
                   '#include "View.h"\nvoid Look() { throw std::runtime_error("dark"); }\n')
        self.write("Filters/Meshing/Mesher.h",
                   '#include "View.h"\n/// After Look(), see Mesher.cxx and <vector>.\nvoid Mesh();\n')
        self.write("Filters/Meshing/Mesher.cxx", '#include "Mesher.h"\nvoid Mesh() { Look(); }\n')
        self.write("Filters/Contouring/README.md", "`Mesher.h`, and TestX.cxx of each concept X.\n")

    def write(self, name, text=""):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def assert_complains(self, *words):
        complaints = check_contracts.check(self.root)[0]
        self.assertEqual(len(complaints), 1, complaints)
        for word in words:
            self.assertIn(word, complaints[0])

    def test_tidy_tree(self):
        self.assertEqual(check_contracts.check(self.root), ([], 4))

    def test_function_that_nobody_has(self):
        self.write("Filters/Meshing/Tube.h", "\n/* Like\n   Tubes() */\nint x;\n")
        self.assert_complains("Filters/Meshing/Tube.h:3 names Tubes()")

    def test_function_of_a_file_that_has_nothing_to_do_with_it(self):
        self.write("Filters/Meshing/Tube.h", "/// See Look().\n")
        self.assert_complains("names Look()")

    def test_function_whose_owner_is_told(self):
        self.write("Filters/Meshing/Tube.h", "/// See isthmus::Look() and Mesh() (Mesher.h).\n")
        self.assertEqual(check_contracts.check(self.root)[0], [])

    def test_owner_told_in_vain(self):
        self.write("Filters/Meshing/Tube.h", "/// See View::Listen().\n")
        self.assert_complains("names View::Listen()")

    def test_functions_made_by_macros(self):
        self.write("Filters/Meshing/vtkTube.h", "/// SetLevel(), GetLevel(), OpenOn()\n"
                   "vtkSetMacro(Level, double);\nvtkGetMacro(Level, double);\n"
                   "vtkBooleanMacro(Open, bool);\n")
        self.assertEqual(check_contracts.check(self.root)[0], [])

    def test_call_in_a_comment_defines_nothing(self):
        self.write("Filters/Meshing/Tube.h", "/// Tubes(1) is gone, Tubes() too.\n")
        self.assert_complains("names Tubes()")

    def test_comment_in_a_string_is_none(self):
        self.write("Filters/Meshing/Tube.h", 'const char* url = "https://x.org/Tubes()";\n')
        self.assertEqual(check_contracts.check(self.root)[0], [])

    def test_file_that_is_not_there(self):
        self.write("Filters/Meshing/Tube.h", "/// As in Meshing/Hose.h.\n")
        self.assert_complains("names Meshing/Hose.h")

    def test_file_that_a_page_names(self):
        self.write("README.md", "Run `Testing/Python/Hose.py`.\n")
        self.assert_complains("README.md:1 names Testing/Python/Hose.py")

    def test_error_that_no_header_tells(self):
        self.write("Filters/Core/View.h", "/// Throws up.\nvoid Look();\n")
        self.assert_complains("Filters/Core/View.h", "@throws")


if __name__ == "__main__":
    unittest.main()
