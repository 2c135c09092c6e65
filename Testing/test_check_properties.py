#!/usr/bin/env python3
"""check_properties.py complains about each thing it is there for, and about nothing in a tidy tree."""
import pathlib
import tempfile
import unittest

import check_properties

TIDY = """#ifndef vtkTube_h
class vtkTube
{
public:
  enum Sides
  {
    Inside,
    INSIDE ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use Inside") = Inside,
    CGAL
  };

  ///@{
  /// Isovalue of the tube. Default 0.5.
  vtkSetMacro(Level, double);
  vtkGetMacro(Level, double);
  ISTHMUS_DEPRECATED("1.0.0", "use SetLevel")
  void SetIsoValue(double level) { this->SetLevel(level); }
  ///@}

  ///@{
  /// Memory in MiB. Default 0. Whether it is open: default off.
  vtkSetMacro(MemoryLimit, int);
  vtkGetMacro(MemoryLimit, int);
  vtkSetMacro(Open, bool);
  vtkGetMacro(Open, bool);
  vtkBooleanMacro(Open, bool);
  ///@}

  vtkTypeBool ProcessRequest(int request) override;
};
"""


class CheckProperties(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.header = "Filters/Meshing/vtkTube.h"
        self.write(self.header, TIDY)
        self.write("Filters/Meshing/TubeProperties.h", "ISTHMUS_SWITCH(Round, true);\n"
                   "ISTHMUS_PROPERTY(double, Width, 1.0);\n")
        self.write("Plugin/Tube.xml", '<P name="IsoValue" label="Level" command="SetLevel"/>\n')

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def replace(self, old, new):
        self.assertIn(old, TIDY)
        self.write(self.header, TIDY.replace(old, new))

    def assert_complains(self, *words):
        complaints = check_properties.check(self.root)[0]
        self.assertEqual(len(complaints), 1, complaints)
        for word in words:
            self.assertIn(word, complaints[0])

    def test_tidy_tree(self):
        self.assertEqual(check_properties.check(self.root), ([], 5))

    def test_type_of_switches(self):
        self.replace("  vtkTypeBool Process", "  vtkTypeBool Open = 1;\n  vtkTypeBool Process")
        self.assert_complains("vtkTube.h:29 has a vtkTypeBool")

    def test_switch_without_on_and_off(self):
        self.replace("  vtkBooleanMacro(Open, bool);\n", "")
        self.assert_complains("Open is a bool")

    def test_on_and_off_of_a_number(self):
        self.replace("  vtkSetMacro(Open, bool);\n", "  vtkSetMacro(Open, int);\n")
        self.assert_complains("Open is a int")

    def test_isovalue(self):
        self.replace('  ISTHMUS_DEPRECATED("1.0.0", "use SetLevel")\n', "")
        self.assert_complains("SetIsoValue is not deprecated")

    def test_property_named_isovalue(self):
        self.replace("(Level, double)", "(IsoValue, double)")
        self.assert_complains("IsoValue is an isovalue")

    def test_side(self):
        self.replace("Open", "Superlevel")
        self.assert_complains("name it InsideIsHigher")

    def test_megabytes(self):
        self.replace("Memory in MiB", "Memory in MB")
        self.assert_complains("vtkTube.h:21 has MB")

    def test_enumerators(self):
        self.replace("    CGAL\n", "    CGAL,\n    BY_AREA\n")
        self.assert_complains("BY_AREA is not in PascalCase")
        self.replace("    CGAL\n", "    CGAL,\n    BOTH // sides\n")
        self.assert_complains("BOTH is not in PascalCase")

    def test_property_that_cannot_be_read(self):
        self.replace("  vtkGetMacro(MemoryLimit, int);\n", "")
        self.assert_complains("MemoryLimit can be set but not read")

    def test_default_that_is_not_stated(self):
        self.replace(" Default 0.5", "")
        self.assert_complains("vtkTube.h:14 does not state the default of Level")

    def test_macro_of_a_switch(self):
        self.write("Filters/Meshing/TubeProperties.h", "ISTHMUS_SWITCH(Round, true);\n"
                   "ISTHMUS_PROPERTY(bool, Long, true);\n")
        self.assert_complains("Long is on or off")

    def test_deprecated_command(self):
        self.write("Plugin/Tube.xml", '<P name="IsoValue" command="SetIsoValue"/>\n')
        self.assert_complains("SetIsoValue is deprecated")

    def test_megabytes_of_a_panel(self):
        self.write("Plugin/Tube.xml", "<Documentation>Memory in MB.</Documentation>\n")
        self.assert_complains("Tube.xml has MB")


if __name__ == "__main__":
    unittest.main()
