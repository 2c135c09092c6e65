#!/usr/bin/env python3
"""check_lengths.py finds each function where clang-format puts it, and counts its lines."""
import pathlib
import tempfile
import unittest

import check_lengths

SOURCE = """#include "Pipe.h"

namespace isthmus
{
namespace
{

struct Part
{
  explicit Part(int n)
    : Count(n)
  {
    this->Count += 1;
  }
  int Twice() const { return 2 * this->Count; }
  int Count = 0;
};

template <typename T>
class Box : public Part
{
public:
  template <typename Body>
  void Each(
    const Body& body) const
  {
    const auto inner = [&](int i)
    {
      body(i);
    };
    inner(1);
  }
};

}

int Pipe::Length(int a,
  int b)
{
  if (a)
  {
    return b;
  }
  return a;
}

}
"""


class CheckLengths(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "Filters" / "Meshing").mkdir(parents=True)
        self.pipe = self.root / "Filters" / "Meshing" / "Pipe.cxx"

    def write(self, lines):
        self.pipe.write_text("void Long()\n{\n" + "  f();\n" * (lines - 3) + "}\n")

    def test_bodies_of_functions_classes_and_templates(self):
        self.assertEqual(check_lengths.functions_of(SOURCE),
                         [("Part", 10, 5), ("Each", 23, 10), ("Pipe::Length", 37, 9)])

    def test_function_at_the_limit(self):
        self.write(60)
        self.assertEqual(check_lengths.check(self.root, {}), ([], [], 1))

    def test_function_over_the_limit(self):
        self.write(61)
        complaints = check_lengths.check(self.root, {})[0]
        self.assertEqual(len(complaints), 1, complaints)
        self.assertIn("Pipe.cxx:1 Long() has 61 lines, over 60", complaints[0])

    def test_file_over_the_limit(self):
        self.pipe.write_text("int a;\n" * 351)
        self.assertIn("has 351 lines, over 350", check_lengths.check(self.root, {})[0][0])

    def test_what_is_owed_is_bounded_and_told_when_it_is_done(self):
        owed = {"Filters/Meshing/Pipe.cxx:Long": 70}
        self.write(70)
        self.assertEqual(check_lengths.check(self.root, owed)[:2], ([], []))
        self.write(71)
        self.assertIn("over 70", check_lengths.check(self.root, owed)[0][0])
        self.write(50)
        self.assertEqual(check_lengths.check(self.root, owed)[:2], ([], list(owed)))
        self.pipe.unlink()
        self.assertEqual(check_lengths.check(self.root, owed)[:2], ([], list(owed)))


if __name__ == "__main__":
    unittest.main()
