#!/usr/bin/env python3
"""check_order.py complains about each arrow and name that is not as drawn, and about nothing else."""
import pathlib
import tempfile
import unittest

import check_order

PAGE = "# Tubes\n\n<!-- order from vtkTube -->\n\n{lines}\nText that names Wall again.\n"
DEMANDED = {"Filters/Tubes": ["vtkTube"]}


class CheckOrder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("vtkTube.h")
        self.write("vtkTube.cxx", '#include "vtkTube.h"\n#include "Wall.h"\n#include "Ends.h"\n')
        self.write("Wall.h", '#include "View.h"\n')
        self.write("Wall.cxx", '#include "Wall.h"\n#include "Ends.h"\n')
        self.write("Ends.h")
        self.write("Unused.h", '#include "Wall.h"\n')
        self.draw("vtkTube   the filter", "  Wall, made of", "", "    Ends")

    def write(self, name, text=""):
        path = self.root / "Filters/Tubes" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def draw(self, *lines):
        block = "".join(f"    {line}\n" if line else "\n" for line in lines)
        self.write("README.md", PAGE.format(lines=block))

    def assert_complains(self, complaint):
        self.assertEqual(check_order.check(self.root, DEMANDED)[0], [complaint])

    def test_tidy_tree(self):
        self.assertEqual(check_order.check(self.root, DEMANDED), ([], 3))

    def test_arrow_that_runs_back_in_the_drawing(self):
        self.draw("vtkTube", "  Ends", "  Wall")
        self.assert_complains(
            "Filters/Tubes/README.md draws Wall after Ends, but Wall includes Ends")

    def test_arrow_that_runs_back_in_the_code(self):
        self.write("Ends.cxx", '#include "Ends.h"\n#include "Wall.h"\n')
        self.assert_complains(
            "Filters/Tubes/README.md draws Ends after Wall, but Ends includes Wall")

    def test_file_that_is_not_drawn(self):
        self.draw("vtkTube", "  Wall")
        self.assert_complains("Filters/Tubes/README.md does not draw Ends, which vtkTube reaches")

    def test_file_that_is_not_reached(self):
        self.draw("vtkTube", "  Unused", "  Wall", "  Ends")
        self.assert_complains(
            "Filters/Tubes/README.md draws Unused, which vtkTube does not reach")

    def test_file_that_is_drawn_twice(self):
        self.draw("vtkTube", "  Wall", "    Ends", "  Ends")
        self.assert_complains("Filters/Tubes/README.md draws Ends twice in the order from vtkTube")

    def test_order_from_what_is_not_there(self):
        self.write("README.md", PAGE.format(lines="    vtkTube\n").replace("from vtkTube", "from Gone"))
        self.assertEqual(check_order.check(self.root, {})[0], [
            "Filters/Tubes/README.md draws an order from Gone, which is not in the module"])

    def test_start_that_is_not_first(self):
        self.write("vtkTube.cxx", '#include "Wall.h"\n')
        self.draw("Wall", "  Ends", "vtkTube")
        complaints = check_order.check(self.root, DEMANDED)[0]
        self.assertIn(
            "Filters/Tubes/README.md draws Wall before vtkTube, where the order begins", complaints)

    def test_order_that_is_missing(self):
        self.write("README.md", "# Tubes\n")
        self.assert_complains("Filters/Tubes/README.md draws no order from vtkTube")

    def test_the_house_is_looked_at(self):
        complaints, arrows = check_order.check(pathlib.Path(check_order.__file__).parents[1])
        self.assertEqual(complaints, [])
        self.assertGreater(arrows, 20)


if __name__ == "__main__":
    unittest.main()
