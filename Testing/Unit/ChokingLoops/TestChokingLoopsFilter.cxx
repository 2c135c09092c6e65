// vtkChokingLoops under control of an application: caching, abort, progress.

#include "ChokingLoops/ChokingLoops.h"
#include "ChokingLoops/ChokingLoopsOutput.h"
#include "ChokingSurfaces.h"
#include "vtkChokingLoops.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

class FilterUnderTest
{
public:
  explicit FilterUnderTest(const TriangleMesh& mesh)
  {
    vtkNew<vtkPolyData> surface;
    SetMesh(mesh, surface);
    this->Loops->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    this->Loops->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Pipeline);
    this->Loops->SetInputData(surface);
    this->Watch->SetClientData(this);
    this->Watch->SetCallback([](vtkObject*, unsigned long, void* self, void* fraction)
      { static_cast<FilterUnderTest*>(self)->RecordProgress(*static_cast<double*>(fraction)); });
    this->Loops->AddObserver(vtkCommand::ProgressEvent, this->Watch);
  }

  /// One update; stopped at the first progress that reaches `stop`.
  void Run(double stop = 2.0)
  {
    this->Stop = stop;
    this->ProgressSeen.clear();
    this->Loops->SetAbortExecute(0);
    this->Loops->Modified();
    this->Loops->Update();
  }

  std::vector<double> Times()
  {
    const double* seconds = this->Loops->GetStageTimes();
    return { seconds, seconds + 5 };
  }

  bool Empty()
  {
    for (int port = 0; port < 3; ++port)
    {
      if (vtkPolyData::SafeDownCast(this->Loops->GetOutputDataObject(port))->GetNumberOfPoints() >
        0)
      {
        return false;
      }
    }
    return vtkTable::SafeDownCast(this->Loops->GetOutputDataObject(3))->GetNumberOfRows() == 0;
  }

  /// A value of the field data.
  vtkIdType Count(const char* name)
  {
    vtkDataArray* array = this->Loops->GetOutput()->GetFieldData()->GetArray(name);
    return array ? static_cast<vtkIdType>(array->GetTuple1(0)) : -1;
  }

  bool HasReported() const { return this->Observer->GetError() || this->Observer->GetWarning(); }
  std::string Messages() const
  {
    return this->Observer->GetErrorMessage() + this->Observer->GetWarningMessage();
  }

  vtkNew<vtkChokingLoops> Loops;
  std::vector<double> ProgressSeen; ///< progress of the last run

private:
  void RecordProgress(double fraction)
  {
    this->ProgressSeen.push_back(fraction);
    if (fraction >= this->Stop)
    {
      this->Loops->SetAbortExecute(1);
    }
  }

  double Stop = 2.0;
  vtkNew<vtkCallbackCommand> Watch;
  vtkNew<vtkTest::ErrorObserver> Observer, Pipeline;
};

// Times identify an analysis: a second one would not take the same nanoseconds in all stages.
TEST(ChokingLoopsFilter, SteeringDoesNotAnalyseAgain)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/soccerball.obj");
  FilterUnderTest steered(ReadSurface("soccerball.obj"));
  vtkChokingLoops* loops = steered.Loops;
  steered.Run();
  const std::vector<double> first = steered.Times();
  EXPECT_GT(std::accumulate(first.begin(), first.end(), 0.0), 0.0);
  const std::vector<std::pair<std::function<void()>, vtkIdType>> changes = {
    { [loops] { loops->SetMinimumPersistence(4.0); }, 31 + 59 + 31 + 1 },
    { [loops] { loops->SetSide(vtkChokingLoops::Inside); }, 31 + 59 },
    { [loops] { loops->SetShortening(vtkChokingLoops::Geodesic); }, 31 + 59 },
    { [loops] { loops->SetSide(vtkChokingLoops::Outside); }, 31 + 1 },
    { [loops] { loops->SetMaximumRadius(25.0); }, 31 },
    { [loops] { loops->SetAlwaysIncludeHandles(false); }, 12 },
    { [loops] { loops->SetMaximumRadiusUnit(vtkChokingLoops::Absolute); }, 31 + 1 },
    { [loops] { loops->SetShorteningRounds(2); }, 31 + 1 },
    { [loops] { loops->SetIncludeBottlenecks(false); }, 31 },
    { [loops] { loops->SetIncludeTunnels(false); }, 0 },
    { [loops]
      {
        loops->SetSide(vtkChokingLoops::Inside);
        loops->SetAlwaysIncludeHandles(true);
      },
      31 },
    { [loops] { loops->SetIncludeHandles(false); }, 0 },
    { [loops]
      {
        loops->SetSide(vtkChokingLoops::Outside);
        loops->SetIncludeTunnels(true);
        loops->SetIncludeBottlenecks(true);
      },
      31 + 1 },
  };
  for (const auto& [change, count] : changes)
  {
    change();
    steered.Run();
    EXPECT_EQ(steered.Times(), first);
    EXPECT_EQ(vtkPolyData::SafeDownCast(loops->GetOutputDataObject(2))->GetNumberOfPoints(), count);
    EXPECT_EQ(steered.Count("NumberOfShownFeatures"), count);
    EXPECT_EQ(steered.Count("NumberOfFeatures"), count);
  }
  loops->SetMaximumNumberOfLoops(5);
  steered.Run();
  EXPECT_EQ(steered.Times(), first);
  EXPECT_EQ(steered.Count("NumberOfShownFeatures"), 5);
  EXPECT_EQ(steered.Count("NumberOfFeatures"), 31 + 1);
  // Also the converse: a new analysis has other times.
  loops->SetSampleSpacing(1.0);
  steered.Run();
  EXPECT_NE(steered.Times(), first);
}

TEST(ChokingLoopsFilter, UntrustedFeaturesCanBeDropped)
{
  FeatureDiagram diagram;
  diagram.Reference = { 10.0, 10.0 };
  for (const bool trusted : { true, false, true, false })
  {
    ShapeFeature feature;
    feature.Kind = diagram.Features.size() < 2 ? FeatureKind::Handle : FeatureKind::Additional;
    feature.Dimension = diagram.Features.size() < 2 ? 1 : 2;
    feature.PairBirth = feature.PairDeath = 1.0;
    feature.Death = 2.0 + static_cast<double>(diagram.Features.size());
    feature.Trusted = trusted;
    diagram.Features.push_back(feature);
  }
  FeatureSelection selection;
  EXPECT_EQ(SelectFeatures(diagram, selection), (std::vector<std::size_t>{ 0, 1, 2, 3 }));
  selection.TrustedOnly = true;
  EXPECT_EQ(SelectFeatures(diagram, selection), (std::vector<std::size_t>{ 0, 2 }));
  selection.MaximumNumberOfLoops = 1; // of those that remain, the most persistent one
  EXPECT_EQ(SelectFeatures(diagram, selection), (std::vector<std::size_t>{ 2 }));
}

namespace
{

/// A plate with a round hole of radius 0.3 and a slot, 1.6 long and 0.4 wide.
TriangleMesh SlottedPlate()
{
  const auto f = [](double x, double y, double z)
  {
    const double hole = 0.3 - std::hypot(x + 1.507, y - 0.007);
    const double slot = std::min(0.8 - std::abs(y - 0.007), 0.2 - std::abs(x - 1.013));
    return std::max({ std::abs(x) - 2.8, std::abs(y) - 1.9, std::abs(z) - 0.5, hole, slot });
  };
  return LevelSet(f, { -3.1, -2.2, -0.8 }, { 3.1, 2.2, 0.8 }, { 93, 66, 24 });
}

/// Radii, lengths and reaches of the tunnels, in the order of the output.
std::vector<std::array<double, 3>> CollectTunnels(vtkChokingLoops* loops)
{
  vtkCellData* cells = loops->GetOutput()->GetCellData();
  std::vector<std::array<double, 3>> tunnels;
  for (vtkIdType i = 0; i < loops->GetOutput()->GetNumberOfCells(); ++i)
  {
    if (cells->GetArray("Kind")->GetTuple1(i) == 1.0)
    {
      tunnels.push_back({ cells->GetArray("Radius")->GetTuple1(i),
        cells->GetArray("Length")->GetTuple1(i), cells->GetArray("Reach")->GetTuple1(i) });
    }
  }
  return tunnels;
}

}

TEST(ChokingLoopsFilter, DropsLoopsThatAreTooLongOrOffTheSurface)
{
  FilterUnderTest steered(SlottedPlate());
  vtkChokingLoops* loops = steered.Loops;
  steered.Run();
  const std::vector<double> first = steered.Times();
  const auto all = CollectTunnels(loops);
  ASSERT_EQ(all.size(), 2U); // the slot is the narrower one, though its loop is longer
  EXPECT_NEAR(all[0][0], 0.2, 0.01);
  EXPECT_NEAR(all[0][1], 4.0, 0.2);
  EXPECT_NEAR(all[1][0], 0.3, 0.01);
  EXPECT_NEAR(all[1][1], 0.6 * M_PI, 0.05);
  EXPECT_NEAR(all[1][2], 1.0, 0.1);
  // The ball touches the slot's two sides anywhere along it: half its diagonal at least.
  EXPECT_GT(all[0][2], 0.95 * std::hypot(1.0, 4.0));
  EXPECT_LT(all[0][2], std::hypot(1.0, 8.0));
  loops->SetLoopOrder(vtkChokingLoops::ByLength);
  steered.Run();
  EXPECT_EQ(CollectTunnels(loops), (std::vector<std::array<double, 3>>{ all[1], all[0] }));
  loops->SetMaximumReach(2.0);
  steered.Run();
  EXPECT_EQ(CollectTunnels(loops), (std::vector<std::array<double, 3>>{ all[1] }));
  EXPECT_EQ(loops->GetOutput()->GetFieldData()->GetArray("NumberOfTunnels")->GetTuple1(0), 1.0);
  loops->SetMaximumReach(0.0);
  loops->SetMaximumLength(3.0);
  steered.Run();
  EXPECT_EQ(CollectTunnels(loops), (std::vector<std::array<double, 3>>{ all[1] }));
  loops->SetMaximumLength(1.0);
  steered.Run();
  EXPECT_TRUE(CollectTunnels(loops).empty());
  EXPECT_EQ(steered.Times(), first) << "analysed again";
  EXPECT_FALSE(steered.HasReported()) << steered.Messages();
}

TEST(ChokingLoopsFilter, ASharedLoopStaysWhenItsFirstFeatureIsDropped)
{
  ChokingLoops loops(Torus(1.0, 0.3, 60, 20));
  const auto& features = loops.Diagram().Features;
  const auto indexOf = [&features](FeatureKind kind)
  {
    const auto found = std::find_if(
      features.begin(), features.end(), [kind](const ShapeFeature& f) { return f.Kind == kind; });
    return static_cast<std::size_t>(found - features.begin());
  };
  const std::size_t handle = indexOf(FeatureKind::Handle);
  const std::size_t tunnel = indexOf(FeatureKind::Tunnel);
  const LoopFeature loop = MakeLoopFeature(loops, handle, 100);
  // The same loop, seen from the middle of the ring as well: 1.3 away, that is 1.86 radii of 0.7.
  const ShownFeature first{ tunnel, &loop, -1 };
  std::vector<ShownFeature> shown{ first, { handle, &loop, static_cast<std::ptrdiff_t>(tunnel) } };
  EXPECT_NEAR(ComputeReach(loops, first), 1.3 / 0.7, 0.05);
  ApplyLimits(loops, { 0.0, 2.0 }, shown);
  EXPECT_EQ(shown.size(), 2U);
  ApplyLimits(loops, { 0.0, 1.5 }, shown);
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_EQ(shown[0].Index, handle);
  EXPECT_EQ(shown[0].SharedWith, -1);
}

TEST(ChokingLoopsFilter, ProgressOnlyMovesForward)
{
  FilterUnderTest steered(Torus(1.0, 0.3, 60, 20));
  steered.Loops->SetSampleSpacing(0.2);
  steered.Loops->SetShortening(vtkChokingLoops::Geodesic);
  steered.Run();
  EXPECT_TRUE(std::is_sorted(steered.ProgressSeen.begin(), steered.ProgressSeen.end()));
  ASSERT_FALSE(steered.ProgressSeen.empty());
  EXPECT_LE(steered.ProgressSeen.back(), 1.0);
  // Progress advances: no step is a third of the whole, and few reports repeat a value.
  const auto distinct = std::set<double>(steered.ProgressSeen.begin(), steered.ProgressSeen.end());
  EXPECT_GT(distinct.size(), steered.ProgressSeen.size() / 2);
  for (std::size_t i = 1; i < steered.ProgressSeen.size(); ++i)
  {
    EXPECT_LT(steered.ProgressSeen[i] - steered.ProgressSeen[i - 1], 0.45);
  }
}

/// Aborted at every tenth of the progress: empty outputs, no message; then a full run.
void ExpectStops(FilterUnderTest& steered)
{
  for (double stop = 0.0; stop < 0.995; stop += 0.1)
  {
    steered.Run(stop);
    EXPECT_TRUE(steered.Empty()) << "stopped at " << stop;
    EXPECT_FALSE(steered.HasReported()) << "stopped at " << stop;
    // The next run starts from the cached stages, so its result is the same.
    steered.Loops->SetSampleSpacing(steered.Loops->GetSampleSpacing() + 1e-9);
  }
  steered.Run();
  EXPECT_FALSE(steered.Empty());
}

TEST(ChokingLoopsFilter, StopsInEveryStage)
{
  FilterUnderTest steered(Torus(1.0, 0.3, 60, 20));
  steered.Loops->SetSampleSpacing(0.2);
  steered.Loops->SetShortening(vtkChokingLoops::Geodesic);
  ExpectStops(steered);
}

TEST(ChokingLoopsFilter, StopsWhileTetGenRuns)
{
  FilterUnderTest steered(Torus(1.0, 0.3, 30, 12));
  steered.Loops->SetFiltration(vtkChokingLoops::TetrahedralMesh);
  steered.Run();
  ASSERT_FALSE(steered.HasReported()) << steered.Messages();
  ExpectStops(steered);
}

// At any progress. By the fraction, since the number of reports depends on the time.
TEST(ChokingLoopsFilter, StopsAnywhere)
{
  const TriangleMesh torus = Torus(1.0, 0.3, 60, 20);
  ChokingLoopParameters parameters;
  parameters.SampleSpacing = 0.2;
  for (int stop = 0; stop <= 25; ++stop)
  {
    EXPECT_THROW(ChokingLoops(TriangleMesh(torus), parameters,
                   [stop](double fraction) { return fraction < 0.04 * stop; }),
      Cancelled)
      << stop;
  }
}

}
