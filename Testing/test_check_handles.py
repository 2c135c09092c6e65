#!/usr/bin/env python3
"""check_handles.py complains about each mix of plain ids, and about nothing in a tidy tree."""
import pathlib
import tempfile
import unittest

import check_handles


class CheckHandles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("Filters/Support/Tidy.h", """
using TriangleId = Handle<struct TriangleKind, int>;
/// Not this one: f(int point, int edge)
void Link(TriangleId triangle, int point);
void Walk(int point, int pointCount, std::size_t edgeCount, int axis);
void Ends(int first, int last, const std::vector<int>& edges, int point);
double Between(int from, int to, double edge, double cell);
inline void Call(int edge) { Walk(edge, edge, point, cell); }
const char* words = "f(int point, int edge)";
""")

    def write(self, name, text=""):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def check(self, text, exceptions=None):
        self.write("Filters/Meshing/Mixed.cxx", text)
        return check_handles.check(self.root, exceptions or {})[0]

    def assert_complains(self, text, *words):
        complaints = self.check(text)
        self.assertEqual(len(complaints), 1, complaints)
        for word in words:
            self.assertIn(word, complaints[0])

    def test_tidy_tree(self):
        self.assertEqual(check_handles.check(self.root, {}), ([], 5))

    def test_declaration(self):
        self.assert_complains("\nvoid Add(int triangle, std::size_t edge);\n",
                              "Filters/Meshing/Mixed.cxx:2 Add(triangle, edge)",
                              "edge and triangle")

    def test_definition_over_lines_with_other_parameters(self):
        self.assert_complains("""
bool Mesh::Beyond(const Mesh& mesh, std::int64_t
    firstVertex, double part = Default(1, 2),
  const vtkIdType ownCell = -1) const
{
}
""", "Mixed.cxx:2 Beyond(firstVertex, ownCell)", "cell and point")

    def test_references_and_const(self):
        self.assert_complains("void Reduce(const int& rank, unsigned int& pivot);", "edge and rank")

    def test_alias_of_an_integer(self):
        self.assert_complains("using Number = std::int32_t;\nusing Own = Number;\n"
                              "void Add(Own node, Number species);", "node and species")

    def test_id_of_a_template(self):
        self.assert_complains("template <typename Id>\nvoid Add(Id vertex, Id edge);",
                              "edge and point")

    def test_lambda(self):
        self.assert_complains("auto add = [&](int p, long t) { return p + t; };",
                              "lambda(p, t)")

    def test_function_type(self):
        self.assert_complains("using Visit = std::function<void(int face, int node)>;",
                              "node and triangle")

    def test_constructor(self):
        self.assert_complains("struct Way\n{\n  Way(int cell, int triangle)\n    : Cell(cell)\n  {\n"
                              "  }\n};\n", "Mixed.cxx:3 Way(cell, triangle)")

    def test_readers_too(self):
        self.write("Readers/Meshes/Rows.h", "void Read(int component, long firstPoint);\n")
        self.assertEqual(len(check_handles.check(self.root, {})[0]), 1)

    def test_same_kind_twice(self):
        self.assertEqual(self.check("int FindEdge(int point, int otherPoint, int vertex);"), [])

    def test_handles_of_both_kinds(self):
        self.assertEqual(self.check("void Add(TriangleId triangle, EdgeId edge, int point);"), [])

    def test_exception(self):
        text = "void Add(int triangle, int edge);\n"
        self.assertEqual(self.check(text, {"Filters/Meshing/Mixed.cxx:Add": "a reason"}), [])

    def test_exception_that_nobody_needs(self):
        complaints = self.check("", {"Filters/Meshing/Mixed.cxx:Add": "a reason"})
        self.assertEqual(len(complaints), 1)
        self.assertIn("needs no entry for Filters/Meshing/Mixed.cxx:Add", complaints[0])


if __name__ == "__main__":
    unittest.main()
