#!/usr/bin/env python3
"""check_features.py complains about each row that is missing, doubled, without a reason or names what is not there."""
import pathlib
import tempfile
import unittest

import check_features

ROOT = pathlib.Path(check_features.__file__).parents[1]
TABLE = ROOT / "Testing/thesis_features.tsv"
PLACE = "Testing/thesis_features.tsv: "


class CheckFeatures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name in ("Filters", "Readers", "Plugin", "Examples", "cmake", "Testing/Unit", "Testing/Python",
                     "Testing/Benchmarks"):
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).symlink_to(ROOT / name)
        self.text = TABLE.read_text()

    def complaints(self, text):
        (self.root / "Testing/thesis_features.tsv").write_text(text)
        return check_features.check(self.root)[0]

    def row(self, id_):
        return next(line for line in self.text.splitlines(True) if line.startswith(id_ + "\t"))

    def changed(self, id_, column, value):
        """Complaints where row `id_` has `value` in `column`."""
        fields = self.row(id_).rstrip("\n").split("\t")
        fields[check_features.COLUMNS.index(column)] = value
        return self.complaints(self.text.replace(self.row(id_), "\t".join(fields) + "\n"))

    def test_the_table(self):
        self.assertEqual(self.complaints(self.text), [])

    def test_rows(self):
        row = self.row("F3.14")
        self.assertEqual(self.complaints(self.text.replace(row, "")),
                         [PLACE + "F3.14 has no row", PLACE + "140 rows are core, not 141"])
        self.assertIn(PLACE + "F3.14 has 2 rows", self.complaints(self.text.replace(row, row * 2)))
        self.assertIn(PLACE + "F4.17 is no feature of the thesis",
                      self.complaints(self.text.replace(row, row.replace("F3.14", "F4.17"))))
        other = self.row("F3.15")
        self.assertEqual(self.complaints(self.text.replace(row + other, other + row)),
                         [PLACE + "the rows are not in the order of their ids"])
        number = self.text.splitlines(True).index(row) + 1
        self.assertIn(f"{PLACE}line {number} has 6 fields, not 7",
                      self.complaints(self.text.replace(row, row.replace("\tcore", ""))))

    def test_names_that_are_not_there(self):
        for column, value in (("code", "NoSuchFile"), ("code", "DartMap:NoSuchFunction"), ("code", "Examples/none.py"),
                              ("panel", "NoSuchFilter"), ("panel", "TetCutaway.NoSuchProperty"),
                              ("python", "vtkNothing"), ("python", "vtkTetCutaway.NoSuchProperty"),
                              ("python", "DartMap"), ("test", "TetCutaway.NoSuchTest"), ("test", "Python.Nothing"),
                              ("test", "BenchNothing")):
            with self.subTest(value):
                self.assertEqual(self.changed("F4.50", column, value), [f"{PLACE}F4.50: there is no {value} ({column})"])

    def test_states(self):
        for status in ("partial", "missing: ", "done"):
            self.assertEqual(self.changed("F4.50", "status", status),
                             [f"{PLACE}F4.50: the status {status!r} is none, or has no reason"])
        self.assertEqual(self.changed("F4.50", "test", "-"), [PLACE + "F4.50: it is whole, but names no test"])
        self.assertEqual(self.changed("F4.50", "code", "-"), [PLACE + "F4.50: it is whole, but names no code"])


if __name__ == "__main__":
    unittest.main()
