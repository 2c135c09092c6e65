#include "vtkTetCutaway.h"

#include "GridFixtures.h"
#include "TopologyFilterRun.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <utility>

namespace
{

using namespace isthmus::testing;
using FilterRun = TopologyFilterRun<vtkTetCutaway>;

/// Volume inside a closed surface whose faces look outwards.
double VolumeInside(vtkPolyData* surface)
{
  double six = 0.0;
  vtkNew<vtkIdList> points;
  for (vtkIdType f = 0; f < surface->GetNumberOfCells(); ++f)
  {
    surface->GetCellPoints(f, points);
    double a[3], b[3], c[3];
    surface->GetPoint(points->GetId(0), a);
    for (vtkIdType i = 2; i < points->GetNumberOfIds(); ++i)
    {
      surface->GetPoint(points->GetId(i - 1), b);
      surface->GetPoint(points->GetId(i), c);
      six += vtkMath::Determinant3x3(a, b, c);
    }
  }
  return six / 6.0;
}

vtkIdType CountExposed(vtkPolyData* surface)
{
  vtkIdType count = 0;
  for (vtkIdType f = 0; f < surface->GetNumberOfCells(); ++f)
  {
    count += surface->GetCellData()->GetArray("Exposed")->GetTuple1(f) > 0.0 ? 1 : 0;
  }
  return count;
}

}

TEST(TetCutaway, RemovesTheRequestedNumber)
{
  const GridPointer grid = MakeGrid(Tetrahedra(6));
  for (const vtkIdType number : { 0, 1, 100, 1295, 1296, 5000 })
  {
    FilterRun run(grid, [&](vtkTetCutaway* filter) { filter->SetNumberOfCells(number); });
    EXPECT_EQ(run.Messages(), "");
    const vtkIdType left = std::max<vtkIdType>(0, 1296 - number);
    EXPECT_EQ(run.Grid(1)->GetNumberOfCells(), left);
    EXPECT_NEAR(VolumeInside(run.Surface(0)), static_cast<double>(left) / 6.0, 1e-9);
    EXPECT_EQ(CountExposed(run.Surface(0)) > 0, number > 0 && left > 0);
  }
}

// Cubes that share a face are neighbours: removed in breadth-first order from a corner, by number
// of steps; so the removed part is connected, and the first n + 1 cells are the first n and
// another.
TEST(TetCutaway, RemovesTheNearestFirst)
{
  constexpr int side = 5;
  const GridPointer grid = MakeGrid(Hexahedra(side));
  std::set<vtkIdType> last;
  for (vtkIdType number = 1; number <= side * side * side; number += 3)
  {
    FilterRun run(grid,
      [&](vtkTetCutaway* filter)
      {
        filter->SetNumberOfCells(number);
        filter->SetSeedPoint(0.0, 0.0, 0.0);
      });
    std::set<vtkIdType> gone;
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      gone.insert(i);
    }
    auto* kept = run.Grid(1)->GetCellData()->GetArray("OriginalCellIds");
    for (vtkIdType i = 0; kept && i < kept->GetNumberOfTuples(); ++i)
    {
      gone.erase(static_cast<vtkIdType>(kept->GetTuple1(i)));
    }
    ASSERT_EQ(gone.size(), static_cast<std::size_t>(number));
    EXPECT_TRUE(std::includes(gone.begin(), gone.end(), last.begin(), last.end())) << number;
    last = gone;
    int farthest = 0, nearest = 3 * side;
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      double box[6];
      grid->GetCellBounds(i, box);
      const int steps = static_cast<int>(std::lround(box[0] + box[2] + box[4]));
      (gone.count(i) ? farthest : nearest) =
        gone.count(i) ? std::max(farthest, steps) : std::min(nearest, steps);
    }
    EXPECT_LE(farthest, nearest) << number;
  }
}

TEST(TetCutaway, OneCubeLeavesThreeFacesExposed)
{
  // The corner cube of 2^3: three of its faces were inside.
  FilterRun run(MakeGrid(Hexahedra(2)), [](vtkTetCutaway* filter) { filter->SetNumberOfCells(1); });
  EXPECT_EQ(run.Grid(1)->GetNumberOfCells(), 7);
  EXPECT_EQ(CountExposed(run.Surface(0)), 3);
  EXPECT_EQ(run.Surface(0)->GetNumberOfCells(), 24 - 3 + 3);
  EXPECT_EQ(run.Grid(1)->GetCellData()->GetArray("OriginalCellIds")->GetTuple1(0), 1.0);
}

TEST(TetCutaway, ByDistanceAndByPlane)
{
  const GridPointer grid = MakeGrid(MixedCells(6));
  FilterRun distance(grid,
    [](vtkTetCutaway* filter)
    {
      filter->SetStopRule(vtkTetCutaway::ByDistance);
      filter->SetSeedPoint(6.0, 6.0, 0.0);
      filter->SetDistance(2.5);
    });
  EXPECT_EQ(distance.Messages(), "");
  EXPECT_LT(distance.Grid(1)->GetNumberOfCells(), grid->GetNumberOfCells());
  EXPECT_GT(distance.Grid(1)->GetNumberOfCells(), grid->GetNumberOfCells() / 2);

  FilterRun plane(grid,
    [](vtkTetCutaway* filter)
    {
      filter->SetStopRule(vtkTetCutaway::ByPlane);
      filter->SetSeedPoint(6.0, 3.0, 3.0);
      filter->SetPlaneOrigin(3.0, 0.0, 0.0);
      filter->SetPlaneNormal(2.0, 0.0, 0.0);
    });
  vtkNew<vtkIdList> points;
  for (vtkIdType c = 0; c < plane.Grid(1)->GetNumberOfCells(); ++c)
  {
    plane.Grid(1)->GetCellPoints(c, points);
    double mean = 0.0;
    for (const vtkIdType point : *points)
    {
      mean += plane.Grid(1)->GetPoint(point)[0] / static_cast<double>(points->GetNumberOfIds());
    }
    EXPECT_LE(mean, 3.0);
  }
  EXPECT_GT(CountExposed(plane.Surface(0)), 0);
}

TEST(TetCutaway, StartsAtANumberedFace)
{
  // Face 0 of the grid of cubes has the vertices 0, 1 and two more: it belongs to cell 0.
  FilterRun run(MakeGrid(Hexahedra(3)),
    [](vtkTetCutaway* filter)
    {
      filter->SetSeedMode(vtkTetCutaway::AtFace);
      filter->SetSeedFace(0);
      filter->SetNumberOfCells(1);
    });
  EXPECT_EQ(run.Grid(1)->GetCellData()->GetArray("OriginalCellIds")->GetTuple1(0), 1.0);
  FilterRun wrong(MakeGrid(Hexahedra(3)),
    [](vtkTetCutaway* filter)
    {
      filter->SetSeedMode(vtkTetCutaway::AtFace);
      filter->SetSeedFace(108);
    });
  EXPECT_NE(
    wrong.Messages().find("SeedFace is 108, but it must be from 0 to 107"), std::string::npos);
  EXPECT_EQ(wrong.Surface(0)->GetNumberOfPoints(), 0);
  EXPECT_EQ(wrong.Grid(1)->GetNumberOfPoints(), 0);
}

TEST(TetCutaway, ReportsValuesOutOfRange)
{
  const std::pair<const char*, std::function<void(vtkTetCutaway*)>> cases[] = {
    { "SeedMode is 2, but it must be from 0 to 1", [](auto* f) { f->SetSeedMode(2); } },
    { "StopRule is 3, but it must be from 0 to 2", [](auto* f) { f->SetStopRule(3); } },
    { "NumberOfCells is -1", [](auto* f) { f->SetNumberOfCells(-1); } },
    { "Distance is -1", [](auto* f) { f->SetDistance(-1.0); } },
    { "SeedPoint is not a number", [](auto* f) { f->SetSeedPoint(0.0, std::nan(""), 0.0); } },
    { "PlaneNormal is not a number", [](auto* f) { f->SetPlaneNormal(0.0, 0.0, std::nan("")); } },
  };
  for (const auto& [words, spoil] : cases)
  {
    FilterRun run(MakeGrid(Hexahedra(3)), spoil);
    EXPECT_NE(run.Messages().find(words), std::string::npos) << words << ": " << run.Messages();
  }
}

TEST(TetCutaway, WarnsWhenTheSeedIsOnTheOtherSide)
{
  const GridPointer grid = MakeGrid(MixedCells(3), true);
  FilterRun run(grid,
    [](vtkTetCutaway* filter)
    {
      filter->SetStopRule(vtkTetCutaway::ByPlane);
      filter->SetPlaneOrigin(0.0, 0.0, 2.0);
    });
  EXPECT_NE(run.Messages().find("Nothing is removed"), std::string::npos);
  EXPECT_EQ(run.Grid(1)->GetNumberOfCells(), grid->GetNumberOfCells());
  EXPECT_EQ(run.Grid(1)->GetCellType(0), VTK_POLYHEDRON);
}

TEST(TetCutaway, EmptyInputGivesEmptyOutputs)
{
  FilterRun run(vtkSmartPointer<vtkUnstructuredGrid>::New());
  EXPECT_EQ(run.Messages(), "");
  EXPECT_EQ(run.Grid(1)->GetNumberOfCells(), 0);
}
