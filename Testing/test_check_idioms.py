#!/usr/bin/env python3
"""check_idioms.py finds each phrase that the list is there for, in each kind of text, and no plain one."""
import pathlib
import tempfile
import unittest

import check_idioms

# What a review found in names, panels, messages, READMEs, comments and commit subjects.
FOUND = """Thresholds answer at once, the analysis is kept
left out, which a warning tells
The level taken stands in the Information panel
Where it ends in any case; a warning tells
the difference of the halves tells it
until the energy rests
Surface and field are made in turn
What parts additional loops from noise
Who makes the tetrahedra
the border of the room that is left for the centre
could be drawn together to a point; it is given as it came
Handles of a smaller radius than this go
a want of memory ends in a sentence
nodes are asked for that the map does not have
it is the distance of nodes
their difference tells no noise
The iteration left the range of numbers
at least one species, as K and Cl
knows its output for a stopped one's
foretold from counts
ParaView 5.11 can't do with them
an empty image is taken in silence
goes on where it was ended
three shells of surface were given
Surface Remesh keeps its feet on stars of flat triangles""".split("\n")
PLAIN = """Threshold changes are instant; the analysis is cached
dropped, with a warning
The level used is shown in the Information panel
Iteration limit; reaching it issues a warning
the noise is estimated from the difference of the half maps
until the energy converges
surface and field are solved alternately
separates significant loops from noise
Meshing backend
the boundary of the region accessible to the probe centre
contractible; returned unchanged
Handles with a smaller radius are removed
allocation failure reports an error
the requested extent exceeds the map
it is the grid spacing
the iteration diverged
at least one species, e.g. K and Cl
the surface has three shells""".split("\n")


class Idioms(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.idioms = check_idioms.read_list()

    def complaints(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return check_idioms.check(self.root, self.idioms)[0]

    def test_review(self):
        for phrase in FOUND:
            self.assertTrue(any(e.search(phrase) for e, _, _ in self.idioms), phrase)

    def test_plain(self):
        for phrase in PLAIN:
            hits = [pattern for e, pattern, _ in self.idioms if e.search(phrase)]
            self.assertEqual(hits, [], phrase)

    def test_list(self):
        self.assertGreaterEqual(len(self.idioms), len(FOUND) + 40)
        self.assertTrue(all(replacement for _, _, replacement in self.idioms))

    def test_markdown(self):
        self.assertEqual(self.complaints("README.md", "# A\n\nThe current hangs\non it, `hangs on`.\n"),
                         ["README.md:3: 'hangs on': write depends on"])
        self.assertEqual(self.complaints("README.md", "```\nhangs on\n```\n\n    hangs on\n"), [])

    def test_header(self):
        found = self.complaints("Filters/Tubes/Tube.h", "int a;\n/**\n * It hangs\n * on b.\n */\nint hangs, on;\n")
        self.assertEqual(found, ["Filters/Tubes/Tube.h:3: 'hangs on': write depends on"])

    def test_message(self):
        text = 'Say("The current hangs "\n    "on it.");\n// this hangs on that\nf("hangs on");\n'
        self.assertEqual(self.complaints("Filters/Tubes/Tube.cxx", text),
                         ["Filters/Tubes/Tube.cxx:1: 'hangs on': write depends on"])

    def test_panel(self):
        text = "<A><Documentation>It hangs\n on b.</Documentation><Entry value='0' text='hangs on'/></A>"
        self.assertEqual(len(self.complaints("Plugin/Tube.xml", text)), 2)

    def test_python(self):
        text = '"""What it hangs on."""\nhangs_on = "hangs on"\n'
        self.assertEqual(self.complaints("Examples/tube.py", text),
                         ["Examples/tube.py:1: 'hangs on': write depends on"])


if __name__ == "__main__":
    unittest.main()
