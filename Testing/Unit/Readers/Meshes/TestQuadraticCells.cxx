// Quadratic cells of MEDIT and TetGen: VTK's order of nodes, from any order of the file; kinds that
// VTK lacks are named.

#include "MeshFileTrips.h"
#include "SharedData.h"
#include "TemporaryFile.h"
#include "vtkMEDITReader.h"
#include "vtkTetGenMeshReader.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// VTK's own parametric coordinates of the nodes of a cell: its order.
std::vector<double> GetNodes(int type)
{
  vtkNew<vtkGenericCell> cell;
  cell->SetCellType(type);
  const double* coordinates = cell->GetParametricCoords();
  return { coordinates, coordinates + 3 * cell->GetNumberOfPoints() };
}

/// A section of two cells of `type`, one slightly curved and much larger, whose nodes after the
/// corners are in the order `order`.
std::string TwoCells(
  const std::string& section, int type, std::size_t corners, const std::vector<std::size_t>& order)
{
  const std::vector<double> nodes = GetNodes(type);
  const std::size_t size = nodes.size() / 3;
  std::ostringstream vertices, cells;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> bend(-0.08, 0.08);
  for (int copy = 0; copy < 2; ++copy)
  {
    for (std::size_t n = 0; n < size; ++n)
    {
      const std::size_t node = n < corners ? n : corners + order[n - corners];
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double x = nodes[3 * node + axis];
        vertices << (copy == 0 || n < corners ? x : x + bend(random)) * (copy == 0 ? 1.0 : 40.0)
                 << " ";
      }
      vertices << "3\n";
      cells << static_cast<std::size_t>(copy) * size + n + 1 << " ";
    }
    cells << 5 + copy << "\n";
  }
  return "MeshVersionFormatted 2\nDimension 3\nVertices\n" + std::to_string(2 * size) + "\n" +
    vertices.str() + section + "\n2\n" + cells.str() + "End\n";
}

}

TEST(QuadraticCells, MEDITGivesVTKsOrderFromAnyOrder)
{
  const struct
  {
    const char* Section;
    int Type;
    std::size_t Corners;
  } cases[] = { { "EdgesP2", VTK_QUADRATIC_EDGE, 2 }, { "TrianglesP2", VTK_QUADRATIC_TRIANGLE, 3 },
    { "QuadrilateralsQ2", VTK_BIQUADRATIC_QUAD, 4 }, { "TetrahedraP2", VTK_QUADRATIC_TETRA, 4 },
    { "PrismsP2", VTK_BIQUADRATIC_QUADRATIC_WEDGE, 6 },
    { "HexahedraQ2", VTK_TRIQUADRATIC_HEXAHEDRON, 8 } };
  std::mt19937 random(7);
  for (const auto& c : cases)
  {
    const std::vector<double> nodes = GetNodes(c.Type);
    std::vector<std::size_t> order(nodes.size() / 3 - c.Corners);
    std::iota(order.begin(), order.end(), std::size_t{ 0 });
    for (int trial = 0; trial < 4; ++trial)
    {
      SCOPED_TRACE(std::string(c.Section) + ", trial " + std::to_string(trial));
      const TemporaryFile file(TwoCells(c.Section, c.Type, c.Corners, order), "x.mesh");
      const auto reader = OpenFile<vtkMEDITReader>(file.Path());
      vtkUnstructuredGrid* grid = reader->GetOutput();
      ASSERT_EQ(grid->GetNumberOfCells(), 2);
      EXPECT_EQ(grid->GetCellType(0), c.Type);
      EXPECT_EQ(grid->GetCellData()->GetArray("Reference")->GetComponent(1, 0), 6);
      for (vtkIdType i = 0; i < static_cast<vtkIdType>(nodes.size() / 3); ++i)
      {
        double p[3], q[3];
        grid->GetPoint(grid->GetCell(0)->GetPointId(static_cast<int>(i)), p);
        grid->GetPoint(grid->GetCell(1)->GetPointId(static_cast<int>(i)), q);
        for (int axis = 0; axis < 3; ++axis)
        {
          const double right = nodes[static_cast<std::size_t>(3 * i + axis)];
          EXPECT_NEAR(p[axis], right, 1e-5) << "node " << i;
          EXPECT_NEAR(q[axis], 40.0 * right, 3.3) << "node " << i;
        }
      }
      std::shuffle(order.begin(), order.end(), random);
    }
  }
}

TEST(QuadraticCells, KindsThatVTKLacksAreNamedWithTheirNumber)
{
  const TemporaryFile file(
    "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
    "TetrahedraP3\n2\n1 2 3 4 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 0\n"
    "1 2 3 4 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 0\n"
    "TetrahedraP2Ordering\n2\n1 0 0\n0 1 0\nTetrahedra\n1\n1 2 3 4 9\nEnd\n",
    "x.mesh");
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkMEDITReader> reader;
  reader->AddObserver(vtkCommand::WarningEvent, observer);
  reader->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->SetFileName(file.Path());
  reader->Update();
  EXPECT_FALSE(observer->GetError());
  EXPECT_SAYS(observer->GetWarningMessage(), "TetrahedraP3 (2 cells) was dropped");
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 1);
  auto* notes =
    vtkStringArray::SafeDownCast(reader->GetOutput()->GetFieldData()->GetAbstractArray("Notes"));
  ASSERT_TRUE(notes);
  EXPECT_EQ(notes->GetNumberOfValues(), 1);
}

TEST(QuadraticCells, TetGensMarkersAreNotMiddlesOfEdges)
{
  ISTHMUS_NEEDS_SHARED_DATA("reports/tetgen_o2/cube.1.face");
  const auto folder = SharedDataFolder() / "reports/tetgen_o2";
  const auto faces = OpenFile<vtkTetGenMeshReader>((folder / "cube.1.face").string());
  ASSERT_EQ(faces->GetOutput()->GetNumberOfCells(), 12);
  std::map<double, int> counts;
  vtkDataArray* markers = faces->GetOutput()->GetCellData()->GetArray("BoundaryMarker");
  ASSERT_TRUE(markers);
  for (vtkIdType c = 0; c < 12; ++c)
  {
    ++counts[markers->GetComponent(c, 0)];
    EXPECT_EQ(faces->GetOutput()->GetCellType(c), VTK_QUADRATIC_TRIANGLE);
    vtkPoints* points = faces->GetOutput()->GetCell(c)->GetPoints();
    for (int e = 0; e < 3; ++e)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_EQ(points->GetPoint(3 + e)[axis],
          0.5 *
            (points->GetData()->GetComponent(e, axis) +
              points->GetData()->GetComponent((e + 1) % 3, axis)));
      }
    }
  }
  EXPECT_EQ(
    counts, (std::map<double, int>{ { 1, 2 }, { 2, 2 }, { 3, 2 }, { 4, 2 }, { 5, 2 }, { 6, 2 } }));
  const auto tetrahedra = OpenFile<vtkTetGenMeshReader>((folder / "cube.1.ele").string());
  ASSERT_EQ(tetrahedra->GetOutput()->GetNumberOfCells(), 6);
  EXPECT_EQ(tetrahedra->GetOutput()->GetCell(0)->GetNumberOfPoints(), 10);
}

TEST(QuadraticCells, EachLayoutOfAFaceFileIsRecognised)
{
  const std::string nodes = "6 3 0 0\n0 0 0 0\n1 2 0 0\n2 0 2 0\n3 1 0 0\n4 1 1 0\n5 0 1 0\n";
  const struct
  {
    const char* Faces;
    int Points;
    double Marker; // -1: none
  } cases[] = { { "1 0\n0 0 1 2\n", 3, -1 }, { "1 1\n0 0 1 2 7\n", 3, 7 },
    { "1 1\n0 0 1 2 7 5 -1\n", 3, 7 },             // -nn
    { "1 0\n0 0 1 2 3 4 5\n", 6, -1 },             // -o2
    { "1 1\n0 0 1 2 5 3 4 7\n", 6, 7 },            // -o2, nodes in another order
    { "1 1\n0 0 1 2 4 5 3 7 5 -1 # end\n", 6, 7 }, // -o2 -nn
    { "1 0\n0 0 1 2 5 -1\n", 3, -1 } };            // -nn
  for (const auto& c : cases)
  {
    SCOPED_TRACE(c.Faces);
    const TemporaryFile file(c.Faces, "x.face");
    std::ofstream(std::filesystem::path(file.Path()).parent_path() / "x.node") << nodes;
    const auto reader = OpenFile<vtkTetGenMeshReader>(file.Path());
    ASSERT_EQ(reader->GetOutput()->GetNumberOfCells(), 1);
    vtkCell* cell = reader->GetOutput()->GetCell(0);
    ASSERT_EQ(cell->GetNumberOfPoints(), c.Points);
    for (int i = 0; i < c.Points; ++i)
    {
      EXPECT_EQ(cell->GetPointId(i), i);
    }
    vtkDataArray* markers = reader->GetOutput()->GetCellData()->GetArray("BoundaryMarker");
    EXPECT_EQ(markers ? markers->GetComponent(0, 0) : -1.0, c.Marker);
  }
  const auto why = [&nodes](const std::string& faces)
  {
    return CatchMessage(
      [](const char* path, const ProgressCallback&)
      {
        vtkNew<vtkTest::ErrorObserver> observer;
        vtkNew<vtkTetGenMeshReader> reader;
        reader->AddObserver(vtkCommand::ErrorEvent, observer);
        reader->SetFileName(path);
        reader->Update();
        throw std::runtime_error(observer->GetErrorMessage());
      },
      faces, "x.face", nodes);
  };
  EXPECT_SAYS(why("1 1\n0 0 1 2 3 4 9 7\n"), "names vertex 9");
  EXPECT_SAYS(why("2 1\n0 0 1 2 3 4 5 7\n1 0 1 2 7\n"), "row 2, above this line, has 1 numbers");
  EXPECT_SAYS(why("1 1\n0 0 1 2\n"), "0 numbers after its corners instead of 1");
  EXPECT_SAYS(why("1 1\n0 0 1 2 red\n"), "'red'");
}

/// Alone, the curved cell would have two of its nodes exchanged; the straight one, a thousandth of
/// its size, has the same weight.
TEST(QuadraticCells, SmallAndLargeCellsCountEqually)
{
  const TemporaryFile file(
    "MeshVersionFormatted 2\nDimension 3\nVertices\n12\n"
    "0 0 0 0\n1 0 0 0\n0 1 0 0\n0.4 0.3 0 0\n0.5 0.1 0 0\n0 0.5 0 0\n"
    "0 0 0 0\n0.001 0 0 0\n0 0.001 0 0\n0.0005 0 0 0\n0.0005 0.0005 0 0\n0 0.0005 0 0\n"
    "TrianglesP2\n2\n1 2 3 4 5 6 0\n7 8 9 10 11 12 0\nEnd\n",
    "x.mesh");
  const auto reader = OpenFile<vtkMEDITReader>(file.Path());
  ASSERT_EQ(reader->GetOutput()->GetNumberOfCells(), 2);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(reader->GetOutput()->GetCell(0)->GetPointId(i), i);
    EXPECT_EQ(reader->GetOutput()->GetCell(1)->GetPointId(i), 6 + i);
  }
}
