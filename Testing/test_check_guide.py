#!/usr/bin/env python3
"""check_guide.py complains about each thing it is there for, and about nothing in a complete guide."""
import pathlib
import tempfile
import unittest

import check_guide

PANEL = """<ServerManagerConfiguration>
  <ProxyGroup name="filters">
    <SourceProxy name="Tube" class="vtkTube" label="Long Tube">
      <Documentation short_help="Makes tubes">Makes tubes of lines, in angstrom.</Documentation>
      <OutputPort name="Walls" index="0"/>
      <OutputPort name="Ends" index="1"/>
      <InputProperty name="Input"><Documentation>The lines.</Documentation></InputProperty>
      <DoubleVectorProperty name="TubeRadius" label="Tube Radius" default_values="1.5">
        <DoubleRangeDomain name="range" min="0" max="9"/>
        <Documentation>Radius in angstrom.</Documentation>
      </DoubleVectorProperty>
    </SourceProxy>
    <SourceProxy name="WideTube" class="vtkTube" label="Wide Tube" base_proxygroup="filters" base_proxyname="Tube">
      <Documentation short_help="Makes wide tubes">As Tube.</Documentation>
    </SourceProxy>
  </ProxyGroup>
</ServerManagerConfiguration>
"""
HEADER = """/**
 * @class vtkTube
 * @brief makes tubes
 *
 * Output: tubes <wide>, in angstrom.
 */
"""


class CheckGuide(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("Plugin/Tube.xml", PANEL)
        self.write("Filters/Tubes/vtk.module", "NAME\n  Isthmus::FiltersTubes\n")
        self.write("Filters/Tubes/CMakeLists.txt", "")
        self.write("Filters/Tubes/vtkTube.h", HEADER)
        self.write("CMakeLists.txt", "project(Isthmus VERSION 1.2.3 LANGUAGES C CXX)\n")
        self.write("CITATION.cff", "version: 1.2.3\n")
        self.write("Examples/guide/index.md", "# Guide\n\n```{toctree}\n:hidden:\n\nlimits\n```\n")
        self.write("Examples/guide/limits.md", "# Limits\n")
        self.write("Examples/guide/filters/Tube.md", "# Long Tube\n\n![Tubes](Tube.png)\n")
        self.write("Examples/guide/filters/WideTube.md", "# Wide Tube\n\n![Tubes](Tube.png)\n")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def assert_complains(self, *texts):
        self.assertEqual(check_guide.check(self.root)[0], list(texts))

    def test_complete(self):
        self.assert_complains()
        self.assertEqual(check_guide.check(self.root)[1], 2)

    def test_page(self):
        site = check_guide.pages.Site(self.root, "")
        page = site.filter_page(site.panels["WideTube"], "# Wide Tube")
        self.assertIn("| Tube Radius | `1.5` | 0 to 9 | Radius in angstrom. |", page)
        self.assertIn("Output: tubes &lt;wide>, in angstrom.", page)
        self.assertIn("1. Ends", page)
        self.assertIn("BSD-3-Clause", page)

    def test_missing_part(self):
        (self.root / "Examples/guide/filters/Tube.md").unlink()
        self.assert_complains("Tube.xml: Tube has no Examples/guide/filters/Tube.md")

    def test_part_without_panel(self):
        self.write("Examples/guide/filters/Hose.md", "# Hose\n")
        self.assert_complains("Examples/guide/filters/Hose.md belongs to no panel")

    def test_heading(self):
        self.write("Examples/guide/filters/Tube.md", "# Tube\n\n![Tubes](Tube.png)\n")
        self.assert_complains("Examples/guide/filters/Tube.md is headed '# Tube', the panel 'Long Tube'")

    def test_no_picture(self):
        self.write("Examples/guide/filters/Tube.md", "# Long Tube\n\nMakes tubes.\n")
        self.assert_complains("Examples/guide/filters/Tube.md has no picture")

    def test_page_outside_of_contents(self):
        self.write("Examples/guide/trust.md", "# Trust\n")
        self.assert_complains("Examples/guide/trust.md is in no list of contents")

    def test_version(self):
        self.write("CITATION.cff", "version: 1.2.2\n")
        self.assert_complains("CITATION.cff does not have the version 1.2.3 of CMakeLists.txt")

    def test_named_tests(self):
        self.write("Testing/Unit/Tubes/TestTube.cxx", "TEST(Tube, IsLong)\n{\n}\n")
        self.write("Testing/Python/Pipes.py", "")
        self.write("Examples/guide/limits.md", "# Limits\n\n`-R Tube`, `-R Pipes`, `-R Tube.IsLong`, `-R Tub.e`\n")
        self.assert_complains("Examples/guide/limits.md: there is no test Tub.e")

    def test_lost_property(self):
        check_guide.pages.Site.property_tables, kept = lambda *_: [], check_guide.pages.Site.property_tables
        self.addCleanup(setattr, check_guide.pages.Site, "property_tables", kept)
        self.assertIn("Examples/guide/filters/Tube.md: the page lacks the property Tube Radius",
                      check_guide.check(self.root)[0])


if __name__ == "__main__":
    unittest.main()
