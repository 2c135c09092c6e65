#!/usr/bin/env python3
"""report_lengths.py finds each function where clang-format puts it, and counts its lines."""
import pathlib
import tempfile
import unittest

import report_lengths

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


class ReportLengths(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def test_bodies_of_functions_classes_and_templates(self):
        self.assertEqual(report_lengths.functions_of(SOURCE),
                         [("Part", 10, 5), ("Each", 23, 10), ("Pipe::Length", 37, 9)])

    def test_longest_functions_first(self):
        self.write("Filters/Tubes/Pipe.cxx", "void Short()\n{\n  f();\n}\n\nvoid Long()\n{\n  f();\n  g();\n}\n")
        files = report_lengths.library_files(self.root)
        self.assertEqual(report_lengths.longest_functions(self.root, files),
                         [(5, "Filters/Tubes/Pipe.cxx:6 Long()"), (4, "Filters/Tubes/Pipe.cxx:1 Short()")])

    def test_includes_of_other_modules(self):
        self.write("Filters/Core/View.h", "")
        self.write("Filters/Tubes/Pipe.h", '#include "Core/View.h"\n')
        self.write("Filters/Tubes/Pipe.cxx", '#include "Tubes/Pipe.h"\n#include "Core/View.h"\n#include <vector>\n')
        self.assertEqual(report_lengths.crossing_includes(report_lengths.library_files(self.root)), 2)


if __name__ == "__main__":
    unittest.main()
