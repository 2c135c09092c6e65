#!/usr/bin/env python3
"""The check of the built guide's links finds files and anchors that are not there, and nothing else."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "Examples" / "guide" / "site"))
import links  # noqa: E402


class Links(unittest.TestCase):
    def complaints(self, body):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "other.html").write_text('<p id="here">text</p>')
            (root / "index.html").write_text(body)
            return links.check(root)

    def test_good(self):
        body = ('<a href="other.html">x</a><a href="other.html#here">x</a><a href="#top">x</a><p id="top">'
                '<a href="https://example.org/none">x</a>')
        self.assertEqual(self.complaints(body), ([], 3))

    def test_no_file(self):
        self.assertEqual(self.complaints('<img src="none.png">')[0], ["index.html: none.png leads nowhere"])

    def test_no_anchor(self):
        self.assertEqual(self.complaints('<a href="other.html#gone">x</a>')[0],
                         ["index.html: other.html#gone: no such anchor"])


if __name__ == "__main__":
    unittest.main()
