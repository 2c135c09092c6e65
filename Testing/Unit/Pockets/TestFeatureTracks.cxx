// Features that move, cross, pause, merge and split, followed by hand; grouping by an id in VTK's
// data.

#include "Pockets/Assignment.h"
#include "Pockets/FeatureTracks.h"
#include "vtkFeatureTracks.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <tuple>

using namespace isthmus;

TEST(FeatureTracks, CrossingFeaturesAreSeparatedByRadiusAndResidues)
{
  std::vector<TrackFrame> frames;
  for (int t = 0; t <= 20; ++t)
  {
    const double x = -5.0 + 0.5 * t;
    const TrackedFeature right{ { x, 0.0, 0.0 }, 3.0, { "A|1", "A|2" } };
    const TrackedFeature left{ { -x, 0.2, 0.0 }, 1.0, { "A|8", "A|9" } };
    frames.push_back(t % 2 ? TrackFrame{ right, left } : TrackFrame{ left, right });
  }
  const FeatureTracks tracks = TrackFeatures(frames, {});
  EXPECT_EQ(tracks.NumberOfTracks, 2);
  for (int t = 0; t <= 20; ++t)
  {
    const auto& of = tracks.TrackOf[static_cast<std::size_t>(t)];
    EXPECT_EQ(of, t % 2 ? (std::vector<int>{ 1, 0 }) : (std::vector<int>{ 0, 1 }));
  }
  EXPECT_TRUE(tracks.Events.empty());
}

TEST(FeatureTracks, GapsAreBridgedUpToTheirLimit)
{
  const TrackedFeature one{ { 0, 0, 0 }, 2.0, {} };
  const std::vector<TrackFrame> frames{ { one }, {}, {}, { one }, {}, {}, {}, { one } };
  const FeatureTracks tracks = TrackFeatures(frames, { 4.0, 2 });
  EXPECT_EQ(tracks.TrackOf[3][0], 0);
  EXPECT_EQ(tracks.TrackOf[7][0], 1);
}

TEST(FeatureTracks, TheLastFourFeaturesAreRemembered)
{
  const auto at = [](double x) { return TrackFrame{ { { x, 0, 0 }, 2.0, {} } }; };
  const FeatureTracks fourth = TrackFeatures({ at(0), at(4), at(8), at(12), at(-4) }, { 4.0, 5 });
  EXPECT_EQ(fourth.TrackOf[4][0], 0);
  const FeatureTracks fifth =
    TrackFeatures({ at(0), at(4), at(8), at(12), at(16), at(-4) }, { 4.0, 5 });
  EXPECT_EQ(fifth.TrackOf[5][0], 1);
  EXPECT_EQ(fifth.NumberOfTracks, 2);
  // The step is at most MaximumDistance, inclusively.
  EXPECT_EQ(TrackFeatures({ at(0), at(4) }, { 4.0, 5 }).NumberOfTracks, 1);
  EXPECT_EQ(TrackFeatures({ at(0), at(4.001) }, { 4.0, 5 }).NumberOfTracks, 2);
}

TEST(FeatureTracks, LoopsOfDifferentKindOrSideAreDifferent)
{
  const auto loop = [](double x, int kind, int side) {
    return TrackedFeature{ { x, 0, 0 }, 2.0, {}, kind, side };
  };
  // Each is now where the other was.
  const auto kinds = TrackFeatures(
    { { loop(0, 0, 0), loop(1, 1, 1) }, { loop(1, 0, 0), loop(0, 1, 1) } }, { 4.0, 5 });
  EXPECT_EQ(kinds.TrackOf[1], (std::vector<int>{ 0, 1 }));
  const auto sides = TrackFeatures(
    { { loop(0, 2, 0), loop(1, 2, 1) }, { loop(1, 2, 0), loop(0, 2, 1) } }, { 4.0, 5 });
  EXPECT_EQ(sides.TrackOf[1], (std::vector<int>{ 0, 1 }));
}

TEST(FeatureTracks, MergesAndSplitsAreNamed)
{
  const TrackedFeature a{ { -1, 0, 0 }, 2.0, { "A|1", "A|2", "A|3" } };
  const TrackedFeature b{ { 1.5, 0, 0 }, 1.5, { "A|7", "A|8" } };
  const TrackedFeature both{ { -0.5, 0, 0 }, 2.2, { "A|1", "A|2", "A|3", "A|7", "A|8" } };
  const FeatureTracks tracks =
    TrackFeatures({ { a, b }, { both }, { both }, { a, b } }, { 4.0, 0 });
  ASSERT_EQ(tracks.Events.size(), 2u);
  EXPECT_EQ(tracks.Events[0].Kind, TrackEventKind::Merge);
  EXPECT_EQ(tracks.Events[0].Track, 1);
  EXPECT_EQ(tracks.Events[0].Other, 0);
  EXPECT_EQ(tracks.Events[1].Kind, TrackEventKind::Split);
  EXPECT_EQ(tracks.Events[1].Frame, 3u);
  EXPECT_EQ(tracks.Events[1].Other, 0);
}

TEST(FeatureTracks, EmptyFramesAndBadOptions)
{
  EXPECT_EQ(TrackFeatures({}, {}).NumberOfTracks, 0);
  EXPECT_EQ(TrackFeatures({ {}, {} }, {}).NumberOfTracks, 0);
  EXPECT_THROW(TrackFeatures({}, { 0.0, 1 }), std::invalid_argument);
  EXPECT_THROW(TrackFeatures({}, { std::nan(""), 1 }), std::invalid_argument);
  EXPECT_THROW(TrackFeatures({}, { 4.0, -1 }), std::invalid_argument);
}

TEST(FeatureTracks, APocketThatGrowsForATimeStepKeepsItsTrack)
{
  // Its center moves by more than MaximumDistance and back; the new pocket stays separate for a
  // while.
  const TrackedFeature a{ { 0, 0, 0 }, 3.0, { "A|1", "A|2", "A|3", "A|4" } };
  const TrackedFeature room{ { 9, 0, 0 }, 3.0, { "A|6", "A|7", "A|8", "A|9" } };
  const TrackedFeature both{ { 4.5, 0, 0 }, 3.0,
    { "A|1", "A|2", "A|3", "A|4", "A|6", "A|7", "A|8", "A|9" } };
  const FeatureTracks tracks =
    TrackFeatures({ { a }, { a }, { both }, { a }, { both }, { room, a }, { both }, { a } }, {});
  for (std::size_t t = 0; t < 8; ++t)
  {
    const auto& of = tracks.TrackOf[t];
    EXPECT_EQ(t == 5 ? of[1] : of[0], 0) << t;
  }
  EXPECT_EQ(tracks.NumberOfTracks, 2);
  ASSERT_EQ(tracks.Events.size(), 2u); // the pocket splits off and merges again
  EXPECT_EQ(tracks.Events[0].Kind, TrackEventKind::Split);
  EXPECT_EQ(tracks.Events[1].Kind, TrackEventKind::Merge);
  EXPECT_EQ(tracks.Events[1].Track, 1);
}

TEST(FeatureTracks, TracksDoNotShiftWhenOneEndsAndAnotherBegins)
{
  // Bottlenecks 3 apart, each with residues of its own: the first one disappears, a new one appears
  // at the end.
  const auto at = [](int i)
  {
    return TrackedFeature{ { 3.0 * i, 0.0, 0.0 }, 1.5,
      { "A|" + std::to_string(i), "A|" + std::to_string(i + 1) } };
  };
  const FeatureTracks tracks =
    TrackFeatures({ { at(1), at(2), at(3) }, { at(2), at(3), at(4) } }, {});
  EXPECT_EQ(tracks.TrackOf[1], (std::vector<int>{ 1, 2, 3 }));
}

TEST(Assignment, IsTheBestOfAllPermutations)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> cost(0.0, 3.0);
  for (int round = 0; round < 200; ++round)
  {
    const std::size_t rows = 1 + random() % 5;
    const std::size_t columns = random() % 5;
    std::vector<std::vector<double>> costs(rows, std::vector<double>(columns));
    for (auto& row : costs)
    {
      for (double& value : row)
      {
        value = random() % 4 ? cost(random) : HUGE_VAL;
      }
    }
    constexpr double alone = 2.0;
    const auto sum = [&](const std::vector<int>& of)
    {
      double all = 0.0;
      for (std::size_t r = 0; r < rows; ++r)
      {
        const bool has = of[r] >= 0 && static_cast<std::size_t>(of[r]) < columns;
        all += has ? costs[r][static_cast<std::size_t>(of[r])] : alone;
      }
      return all;
    };
    std::vector<int> places(columns + rows); // those after the columns: alone
    std::iota(places.begin(), places.end(), 0);
    double best = HUGE_VAL;
    do
    {
      best = std::min(best, sum(places));
    } while (std::next_permutation(places.begin(), places.end()));
    EXPECT_NEAR(sum(AssignAtLeastCost(costs, columns, alone)), best, 1e-12);
  }
}

namespace
{

/// The table of tracks of data without time.
vtkNew<vtkTable> FindTracks(vtkDataObject* data)
{
  vtkNew<vtkFeatureTracks> filter;
  filter->SetInputDataObject(0, data);
  filter->Update();
  vtkNew<vtkTable> table;
  table->ShallowCopy(filter->GetOutputDataObject(0));
  return table;
}

double Value(vtkTable* table, vtkIdType row, const char* column)
{
  return table->GetValueByName(row, column).ToDouble();
}

template <typename Array>
void Add(vtkDataSetAttributes* data, const char* name, std::initializer_list<double> values)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextTuple1(value);
  }
  data->AddArray(array);
}

}

TEST(FeatureTracks, TetrahedraOfOnePocketAreOneFeature)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  for (int t = 0; t < 3; ++t)
  {
    for (int k = 0; k < 4; ++k)
    {
      points->InsertNextPoint(
        10.0 * t + (k == 1 ? 4.0 : 0.0), k == 2 ? 4.0 : 0.0, k == 3 ? 4.0 : 0.0);
    }
  }
  grid->SetPoints(points);
  grid->Allocate(3);
  for (vtkIdType t = 0; t < 3; ++t)
  {
    const vtkIdType corners[] = { 4 * t, 4 * t + 1, 4 * t + 2, 4 * t + 3 };
    grid->InsertNextCell(VTK_TETRA, 4, corners);
  }
  Add<vtkIntArray>(grid->GetCellData(), "PocketId", { 2, 2, 1 });
  Add<vtkDoubleArray>(grid->GetCellData(), "Clearance", { 2.0, 3.0, 2.5 });
  Add<vtkDoubleArray>(grid->GetCellData(), "EmptyVolume", { 6.0, 2.0, 5.0 });
  Add<vtkIdTypeArray>(grid->GetCellData(), "Burial", { 100, 100, 200 });
  const auto table = FindTracks(grid);
  ASSERT_EQ(table->GetNumberOfRows(), 2);
  EXPECT_EQ(Value(table, 0, "FeatureId"), 1.0);
  EXPECT_EQ(Value(table, 1, "FeatureId"), 2.0);
  EXPECT_DOUBLE_EQ(Value(table, 0, "X"), 21.0);
  EXPECT_DOUBLE_EQ(Value(table, 0, "Score"), 20.0); // 5 angstrom^3 x (200/100)^2
  EXPECT_DOUBLE_EQ(Value(table, 1, "X"), (6.0 * 1.0 + 2.0 * 11.0) / 8.0);
  EXPECT_DOUBLE_EQ(Value(table, 1, "Volume"), 8.0);
  EXPECT_DOUBLE_EQ(Value(table, 1, "Radius"), 3.0);
}

TEST(FeatureTracks, FeaturesWithoutDataLeaveNoGapInTheTable)
{
  vtkNew<vtkPolyData> cells;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 6; ++i)
  {
    points->InsertNextPoint(i, 0.0, 0.0);
  }
  cells->SetPoints(points);
  cells->Allocate(4);
  const vtkIdType ids[] = { 0, 1, 2, 3, 4, 5 };
  cells->InsertNextCell(VTK_POLY_LINE, 2, ids);
  cells->InsertNextCell(VTK_POLY_LINE, 2, ids + 2);
  cells->InsertNextCell(VTK_POLY_LINE, 2, ids + 4);
  cells->InsertNextCell(VTK_POLY_LINE, 0, ids);
  Add<vtkDoubleArray>(cells->GetCellData(), "PocketId", { 1, 1, std::nan(""), 2 });
  Add<vtkDoubleArray>(cells->GetCellData(), "EmptyVolume", { -1.0, 0.0, 5.0, 5.0 });
  Add<vtkIdTypeArray>(cells->GetCellData(), "Burial", { 10, 0, 100, 100 });
  const auto table = FindTracks(cells);
  ASSERT_EQ(table->GetNumberOfRows(), 1);
  EXPECT_EQ(Value(table, 0, "FeatureId"), 1.0);
  EXPECT_DOUBLE_EQ(Value(table, 0, "X"), 1.5); // of both lines alike
}

TEST(FeatureTracks, LinesByPoreLoopsByFeatureAndPointsByThemselves)
{
  vtkNew<vtkPolyData> lines;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 5; ++i)
  {
    points->InsertNextPoint(i, 0.0, 0.0);
  }
  lines->SetPoints(points);
  lines->Allocate(2);
  const vtkIdType ids[] = { 0, 1, 2, 3, 4 };
  lines->InsertNextCell(VTK_POLY_LINE, 3, ids);
  lines->InsertNextCell(VTK_POLY_LINE, 2, ids + 3);
  Add<vtkDoubleArray>(lines->GetPointData(), "Radius", { 3, 1, 2, 5, 4 });
  EXPECT_EQ(FindTracks(lines)->GetNumberOfRows(), 5); // choke points
  Add<vtkIdTypeArray>(lines->GetCellData(), "FeatureId", { 7, 3 });
  const auto loops = FindTracks(lines);
  ASSERT_EQ(loops->GetNumberOfRows(), 2);
  EXPECT_EQ(Value(loops, 0, "FeatureId"), 3.0);
  EXPECT_DOUBLE_EQ(Value(loops, 0, "X"), 3.5);
  Add<vtkIntArray>(lines->GetPointData(), "PoreId", { 1, 1, 1, 2, 2 });
  const auto pores = FindTracks(lines);
  ASSERT_EQ(pores->GetNumberOfRows(), 2);
  EXPECT_DOUBLE_EQ(Value(pores, 0, "X"), 1.0); // where it is narrowest
  EXPECT_DOUBLE_EQ(Value(pores, 0, "Radius"), 1.0);
  EXPECT_DOUBLE_EQ(Value(pores, 1, "X"), 4.0);
  vtkNew<vtkFeatureTracks> filter;
  filter->SetInputDataObject(0, lines);
  filter->Update();
  vtkPolyData* const paths = filter->GetPaths();
  ASSERT_EQ(paths->GetNumberOfPoints(), 2);
  EXPECT_EQ(paths->GetNumberOfLines(), 2);
  for (const auto& [name, first, second] :
    { std::make_tuple("Track", 1.0, 2.0), { "Time", 0.0, 0.0 }, { "Radius", 1.0, 4.0 } })
  {
    vtkDataArray* const array = paths->GetPointData()->GetArray(name);
    ASSERT_NE(array, nullptr) << name;
    ASSERT_EQ(array->GetNumberOfTuples(), 2) << name;
    EXPECT_EQ(array->GetTuple1(0), first) << name;
    EXPECT_EQ(array->GetTuple1(1), second) << name;
  }
  Add<vtkIntArray>(lines->GetPointData(), "Rank", { 1, 2, 3, 1, 2 });
  EXPECT_EQ(FindTracks(lines)->GetNumberOfRows(), 5); // bottlenecks
}

TEST(FeatureTracks, TheTableHasTheKindsOfLoops)
{
  vtkNew<vtkPolyData> chokes;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(9.0, 0.0, 0.0);
  chokes->SetPoints(points);
  Add<vtkIdTypeArray>(chokes->GetPointData(), "FeatureId", { 1, 2 });
  EXPECT_EQ(FindTracks(chokes)->GetColumnByName("Kind"), nullptr);
  Add<vtkIntArray>(chokes->GetPointData(), "Kind", { 2, 1 });
  Add<vtkIntArray>(chokes->GetPointData(), "Side", { 0, 1 });
  const auto table = FindTracks(chokes);
  ASSERT_EQ(table->GetNumberOfRows(), 2);
  for (const char* const name : { "Kind", "Side" })
  {
    ASSERT_NE(table->GetColumnByName(name), nullptr) << name;
  }
  EXPECT_EQ(Value(table, 0, "Kind"), 2.0);
  EXPECT_EQ(Value(table, 0, "Side"), 0.0);
  EXPECT_EQ(Value(table, 1, "Kind"), 1.0);
  EXPECT_EQ(Value(table, 1, "Side"), 1.0);
}
