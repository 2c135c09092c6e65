#include "vtkCellIncidence.h"

#include "Core/InvertedCells.h"
#include "GridFixtures.h"
#include "IncidenceCheck.h"
#include "SharedData.h"
#include "TopologyFilterRun.h"
#include "VolumeMeshFiles.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace
{

using namespace isthmus::testing;
using FilterRun = TopologyFilterRun<vtkCellIncidence>;

vtkIdType Id(vtkPolyData* data, const char* name, vtkIdType cell)
{
  return static_cast<vtkIdType>(data->GetCellData()->GetArray(name)->GetTuple1(cell));
}

/// Point data x, cell data 10 times the cell's number.
void AddData(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> x, ten;
  x->SetName("x");
  ten->SetName("Ten");
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    x->InsertNextValue(grid->GetPoint(p)[0]);
  }
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    ten->InsertNextValue(10.0 * static_cast<double>(c));
  }
  grid->GetPointData()->AddArray(x);
  grid->GetCellData()->AddArray(ten);
}

}

TEST(CellIncidence, AgreesWithBruteForce)
{
  for (const GridFixture& fixture : AllGridFixtures())
  {
    AddData(fixture.Grid);
    FilterRun run(fixture.Grid);
    EXPECT_EQ(run.Messages(), "") << fixture.Name;
    const isthmus::GridCells cells(fixture.Grid, isthmus::GridCells::Orientation::AsGiven);
    const BruteForce truth(cells.List());
    vtkPolyData* edges = run.Surface(0);
    ASSERT_EQ(edges->GetNumberOfLines(), static_cast<vtkIdType>(truth.CellsOfEdge.size()));
    vtkNew<vtkIdList> points;
    vtkIdType e = 0;
    for (const auto& [ends, owners] : truth.CellsOfEdge)
    {
      edges->GetCellPoints(e, points);
      ASSERT_EQ(Pair(points->GetId(0), points->GetId(1)), ends);
      ASSERT_EQ(Id(edges, "EdgeId", e), e);
      ASSERT_EQ(Id(edges, "OnBoundary", e) == 1, truth.BoundaryEdges.count(ends) == 1);
      ASSERT_EQ(Id(edges, "NumberOfIncidentCells", e), static_cast<vtkIdType>(owners.size()));
      ASSERT_EQ(Id(edges, "FirstIncidentCell", e), *owners.begin());
      ASSERT_EQ(Id(edges, "Ten", e), 10 * *owners.begin());
      ++e;
    }
    vtkPolyData* faces = run.Surface(1);
    ASSERT_EQ(faces->GetNumberOfPolys(), static_cast<vtkIdType>(truth.CellsOfFace.size()));
    vtkIdType f = 0;
    for (const auto& [corners, owners] : truth.CellsOfFace)
    {
      faces->GetCellPoints(f, points);
      Corners found(points->begin(), points->end());
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, corners);
      ASSERT_EQ(Id(faces, "FaceId", f), f);
      ASSERT_EQ(Id(faces, "FirstIncidentCell", f), owners[0]);
      ASSERT_EQ(Id(faces, "SecondIncidentCell", f), owners.size() > 1 ? owners[1] : -1);
      ASSERT_EQ(Id(faces, "OnBoundary", f), owners.size() > 1 ? 0 : 1);
      ++f;
    }
    EXPECT_EQ(faces->GetPoints(), fixture.Grid->GetPoints());
    EXPECT_NE(edges->GetPointData()->GetArray("x"), nullptr);
  }
}

TEST(CellIncidence, OmitsCellDataOnRequest)
{
  const GridPointer grid = MakeGrid(MixedCells(2));
  AddData(grid);
  FilterRun run(grid, [](vtkCellIncidence* filter) { filter->PassCellDataOff(); });
  EXPECT_EQ(run.Surface(1)->GetCellData()->GetArray("Ten"), nullptr);
  EXPECT_NE(run.Surface(1)->GetCellData()->GetArray("FaceId"), nullptr);
}

TEST(CellIncidence, WarnsAboutSimplifiedAndSkippedCells)
{
  const GridPointer grid = EmptyGrid();
  for (int p = 0; p < 10; ++p)
  {
    grid->GetPoints()->InsertNextPoint(p == 1 || p == 4, p == 2 || p == 5, p == 3 || p == 6);
  }
  const vtkIdType ids[] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 };
  grid->InsertNextCell(VTK_TRIANGLE, 3, ids);
  grid->InsertNextCell(VTK_QUADRATIC_TETRA, 10, ids);
  FilterRun run(grid);
  EXPECT_NE(run.Messages().find("1 cells of higher order"), std::string::npos);
  EXPECT_NE(run.Messages().find("1 cells that are points, lines or surfaces"), std::string::npos);
  EXPECT_EQ(run.Surface(0)->GetNumberOfLines(), 6);
  EXPECT_EQ(Id(run.Surface(1), "FirstIncidentCell", 3), 1);
}

// A mesh of 48 tetrahedra whose middle point is moved beyond its neighbours: it overlaps itself,
// while its cells are numbered alike, or all the other way round.
TEST(CellIncidence, NamesInvertedTetrahedra)
{
  ISTHMUS_NEEDS_SHARED_DATA("reports/n02f_tangled.mesh");
  const auto path = SharedDataFolder() / "reports/n02f_tangled.mesh";
  for (const double x : { 2.6, 1.0, -3.0, 1.9 })
  {
    for (const bool reversed : { false, true })
    {
      const auto mesh = ReadVolumeMesh(path);
      mesh->GetPoints()->SetPoint(13, x, 1.0, 1.0);
      vtkNew<vtkUnstructuredGrid> grid;
      grid->SetPoints(mesh->GetPoints());
      int inverted = 0, cells = 0;
      for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
      {
        vtkNew<vtkIdList> ids;
        mesh->GetCellPoints(c, ids);
        if (mesh->GetCellType(c) != VTK_TETRA)
        {
          continue;
        }
        std::array<isthmus::Point3, 4> p;
        for (int i = 0; i < 4; ++i)
        {
          mesh->GetPoint(ids->GetId(i), p[static_cast<std::size_t>(i)].data());
        }
        inverted += isthmus::SixSignedVolumes(p[0], p[1], p[2], p[3]) < 0.0 ? 1 : 0;
        ++cells;
        vtkIdType corners[4] = { ids->GetId(0), ids->GetId(1), ids->GetId(2), ids->GetId(3) };
        std::swap(corners[0], corners[reversed ? 1 : 0]);
        grid->InsertNextCell(VTK_TETRA, 4, corners);
      }
      ASSERT_EQ(cells, 48);
      inverted = std::min(inverted, cells - inverted);
      EXPECT_EQ(inverted > 0, x > 2.0 || x < 0.0);
      FilterRun run(grid);
      const std::string expected = std::to_string(inverted) + " of 48 cells are inverted";
      EXPECT_EQ(run.Messages().find(expected) != std::string::npos, inverted > 0)
        << x << reversed << run.Messages();
    }
  }
}

TEST(CellIncidence, EmptyInputGivesEmptyOutputs)
{
  FilterRun run(vtkSmartPointer<vtkUnstructuredGrid>::New());
  EXPECT_EQ(run.Messages(), "");
  EXPECT_EQ(run.Surface(0)->GetNumberOfCells(), 0);
  EXPECT_EQ(run.Surface(1)->GetNumberOfCells(), 0);
}

TEST(CellIncidence, ReportsErrorsWithEmptyOutputs)
{
  const auto refusal = [](vtkUnstructuredGrid* grid)
  {
    FilterRun run(grid);
    EXPECT_EQ(run.Surface(0)->GetNumberOfPoints(), 0);
    EXPECT_EQ(run.Surface(1)->GetNumberOfPoints(), 0);
    return run.Messages();
  };
  GridPointer grid = MakeGrid(Tetrahedra(1));
  const vtkIdType again[] = { 0, 1, 3, 7 }; // cell 0
  grid->InsertNextCell(VTK_TETRA, 4, again);
  grid->InsertNextCell(VTK_TETRA, 4, again);
  const std::string overlap = refusal(grid);
  EXPECT_NE(overlap.find("share a face with a third cell"), std::string::npos) << overlap;
  grid = MakeGrid(Tetrahedra(1));
  const vtkIdType outside[] = { 0, 1, 2, 8 };
  grid->InsertNextCell(VTK_TETRA, 4, outside);
  EXPECT_NE(refusal(grid).find("Cell 6: a vertex number is not in 0 ... 7"), std::string::npos);
  const vtkIdType twice[] = { 0, 1, 1, 2 };
  grid = MakeGrid(Tetrahedra(1));
  grid->InsertNextCell(VTK_TETRA, 4, twice);
  EXPECT_NE(refusal(grid).find("Cell 6: the same vertex occurs twice"), std::string::npos);
  grid = MakeGrid(Tetrahedra(1));
  grid->InsertNextCell(VTK_CONVEX_POINT_SET, 4, twice);
  EXPECT_NE(refusal(grid).find("Cell 6 is of the type"), std::string::npos);
  grid = MakeGrid(Tetrahedra(1));
  const vtkIdType open[] = { 3, 0, 1, 2, 3, 0, 1, 3, 3, 1, 2, 3 };
  grid->InsertNextCell(VTK_POLYHEDRON, 3, open);
  EXPECT_NE(refusal(grid).find("Cell 6 is not valid"), std::string::npos);
}

TEST(CellIncidence, StopsOnRequest)
{
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn(); });
  FilterRun run(MakeGrid(Tetrahedra(12)),
    [&](vtkCellIncidence* filter) { filter->AddObserver(vtkCommand::ProgressEvent, stop); });
  EXPECT_EQ(run.Messages(), "");
  EXPECT_EQ(run.Surface(0)->GetNumberOfCells(), 0);
  EXPECT_EQ(run.Surface(1)->GetNumberOfCells(), 0);
}
