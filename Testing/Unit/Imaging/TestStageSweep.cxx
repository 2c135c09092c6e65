// All stages in one sweep: the bits of stages done one after the other, on any number of threads;
// memory; progress and abort.

#include "DiffusionTestTools.h"
#include "Imaging/ChebyshevFilter.h"
#include "Imaging/StageSweep.h"
#include "Imaging/SuperTimeStepping.h"
#include "PeakMemory.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <limits>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// T_1, T_2, ... of the Laplacian, as Chebyshev's recurrence has them.
template <typename T>
std::vector<RowUpdate<T>> Recurrence(const DiffusionGrid<T>& grid, std::size_t stages)
{
  const double bound = LaplacianBound<T>(grid.Spacing);
  std::vector<RowUpdate<T>> updates(stages);
  for (RowUpdate<T>& update : updates)
  {
    update.CurrentFactor = 2;
    update.PreviousFactor = -1;
    update.RateFactor = static_cast<T>(4.0 / bound);
  }
  updates[0] = RowUpdate<T>();
  updates[0].RateFactor = static_cast<T>(2.0 / bound);
  return updates;
}

/// Two sums, of which one ends before the last stage.
template <typename T>
std::vector<StageSum<T>> Sums(std::size_t stages, std::vector<T>& all, std::vector<T>& first)
{
  std::vector<T> factors;
  for (std::size_t n = 0; n < stages; ++n)
  {
    factors.push_back(static_cast<T>((n % 2 == 0 ? 1.0 : -0.7) / static_cast<double>(n + 1)));
  }
  const std::vector<T> some(
    factors.begin(), factors.begin() + static_cast<std::ptrdiff_t>((stages + 1) / 2));
  return { { all.data(), factors }, { first.data(), some } };
}

template <typename T>
void ExpectTheBitsOfSingleStages(const DiffusionGrid<T>& grid, std::size_t stages, int threads)
{
  const std::vector<T> values = Noise(grid);
  const std::vector<RowUpdate<T>> updates = Recurrence(grid, stages);
  const std::vector<T> zero(values.size(), T(0));
  std::vector<T> all = zero, first = zero;

  DiffusionGrid<T> oneByOne = grid;
  oneByOne.ExchangeHalo = [](T*) {}; // as on a rank
  DiffusionOperator<T> laplacian;
  laplacian.Dimensions = grid.Dimensions;
  laplacian.Spacing = grid.Spacing;
  StageSequence<T> sequence;
  sequence.Updates = updates;
  sequence.Current = sequence.First = values.data();
  sequence.Sums = Sums(stages, all, first);
  const StageVolumes<T> volumes(oneByOne, laplacian);
  sequence.Volumes = volumes.Pointers();
  EvaluateStages<T>(oneByOne, laplacian, sequence, {});

  // What the volumes hold before must not matter.
  std::vector<T> sweptAll(values.size(), std::numeric_limits<T>::quiet_NaN()),
    sweptFirst = sweptAll;
  vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, std::string("STDThread"), false),
    [&] { SweepStages<T>(grid, updates, values.data(), Sums(stages, sweptAll, sweptFirst), {}); });
  EXPECT_EQ(sweptAll, all) << stages << " stages, " << threads << " threads";
  EXPECT_EQ(sweptFirst, first) << stages << " stages, " << threads << " threads";
}

}

TEST(StageSweep, HasTheBitsOfSingleStages)
{
  auto grid = Grid<float>(21, 37, 26);
  grid.Spacing = { 1.0, 1.3, 0.8 };
  for (const std::size_t stages : { 1, 2, 3, 17, 60 })
  {
    for (const int threads : { 1, 2, 5 })
    {
      ExpectTheBitsOfSingleStages(grid, stages, threads);
    }
  }
  ExpectTheBitsOfSingleStages(Grid<double>(33, 20, 45), 12, 3);
}

TEST(StageSweep, HasTheBitsOfSingleStagesInSlicesAndRows)
{
  for (const auto& size : { std::array<int, 3>{ 40, 30, 1 }, { 40, 1, 30 }, { 1, 40, 30 },
         { 50, 1, 1 }, { 1, 50, 1 }, { 1, 1, 50 }, { 1, 1, 1 } })
  {
    ExpectTheBitsOfSingleStages(Grid<float>(size[0], size[1], size[2]), 9, 2);
  }
}

TEST(StageSweep, ChebyshevSeriesNeedsNoVolumesBetweenItsTerms)
{
  const auto grid = Grid<float>(128, 192, 128);
  const std::vector<float> values = Noise(grid);
  std::vector<float> change(values.size(), 0.0f);
  const std::vector<double> series(21, 0.01);
  ResetPeakMemory();
  const double before = PeakMemory();
  if (before <= 0.0)
  {
    GTEST_SKIP() << "The kernel does not report the peak of a process.";
  }
  AddChebyshevSeries<float>(grid, { series }, values.data(), { change.data() }, {});
  const double bytes = PeakMemory() - before;
  const double volume = static_cast<double>(grid.Size()) * sizeof(float);
  // Two rows of 192 for each of 20 terms, padded from 128 to 160 nodes: 0.26 volumes, and threads.
  EXPECT_LT(bytes, 0.6 * volume);
}

TEST(StageSweep, ReportsProgressAndStops)
{
  const auto grid = Grid<float>(64, 96, 96);
  const std::vector<float> values = Noise(grid);
  std::vector<float> change(values.size());
  const auto updates = Recurrence(grid, 30);
  const std::vector<StageSum<float>> sums{ { change.data(), std::vector<float>(30, 0.1f) } };
  double last = 0.0;
  SweepStages<float>(grid, updates, values.data(), sums,
    [&last](double fraction)
    {
      EXPECT_GE(fraction, last);
      last = fraction;
      return true;
    });
  EXPECT_EQ(last, 1.0);
  EXPECT_THROW(SweepStages<float>(grid, updates, values.data(), sums, [](double) { return false; }),
    Cancelled);
}
