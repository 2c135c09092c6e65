#include "Imaging/StageSweep.h"

#include "Core/ParallelFor.h"
#include "Core/Stopwatch.h"
#include "Imaging/DiffusionRows.h"
#include "Imaging/SuperTimeStepping.h"

#include <algorithm>
#include <memory>

namespace isthmus
{
namespace
{

/// Rows of a strip that the next one reads.
constexpr std::int64_t borderRows = 2;

std::int64_t CountParts(std::int64_t whole, std::int64_t part)
{
  return (whole + part - 1) / part;
}

/// How the work is divided. The result does not depend on it.
struct SweepPlan
{
  std::int64_t StripRows, Strips;
  std::int64_t Waves; ///< planes that a strip goes through, those behind the last one included
  std::int64_t BlockWaves, Blocks;
  std::int64_t Lanes; ///< strips at a time

  template <typename T>
  SweepPlan(const DiffusionGrid<T>& grid, std::int64_t stages)
  {
    // What a strip reads again soon should stay in the third level of the cache.
    constexpr std::int64_t laneBytes = std::int64_t{ 4 } << 20;
    constexpr std::int64_t rowsOfStage = 5; // three planes, the first values and the sum
    constexpr std::int64_t mostRows = 16;
    const std::int64_t rowBytes =
      PaddedStride(grid.Dimensions[0]) * static_cast<std::int64_t>(sizeof(T));
    this->StripRows =
      std::clamp(laneBytes / (rowsOfStage * stages * rowBytes), borderRows, mostRows);
    this->Strips = CountParts(grid.Dimensions[1] + stages, this->StripRows);
    this->Waves = grid.Dimensions[2] + stages;
    this->Lanes = std::min({ std::int64_t{ ParallelThreads() }, this->Strips, this->Waves });
    // Large enough to be worth a thread, small enough that a user who aborts need not wait.
    constexpr std::int64_t blockNodes = 1 << 23;
    this->BlockWaves = std::clamp<std::int64_t>(
      blockNodes / (this->StripRows * stages * grid.Dimensions[0]), 1, this->Waves / this->Lanes);
    this->Blocks = CountParts(this->Waves, this->BlockWaves);
  }
};

/// What all strips share.
template <typename T>
class SharedSweep
{
public:
  SharedSweep(const DiffusionGrid<T>& grid, const std::vector<RowUpdate<T>>& updates,
    const T* first, const std::vector<StageSum<T>>& sums)
    : Size(grid.Dimensions)
    , Stride(PaddedStride(grid.Dimensions[0]))
    , Updates(updates)
    , First(first)
    , Sums(sums)
    , Borders(NewVolume<T>(BorderSize(grid, updates.size())))
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Weights[axis] = static_cast<T>(1.0 / (grid.Spacing[axis] * grid.Spacing[axis]));
    }
  }

  /// Values between the strips: of all stages but the last.
  static std::int64_t BorderSize(const DiffusionGrid<T>& grid, std::size_t stages)
  {
    return static_cast<std::int64_t>(stages) * grid.Dimensions[2] * borderRows *
      PaddedStride(grid.Dimensions[0]);
  }

  std::int64_t Stages() const { return static_cast<std::int64_t>(this->Updates.size()); }

  /// A row at the end of a strip, with margins, from the row's first node.
  T* Border(std::int64_t stage, std::int64_t plane, std::int64_t nth) const
  {
    return this->Borders.get() +
      ((stage * this->Size[2] + plane) * borderRows + nth) * this->Stride + RowMargin;
  }

  const std::array<std::int64_t, 3> Size;
  const std::int64_t Stride;
  const std::vector<RowUpdate<T>>& Updates;
  const T* const First;
  const std::vector<StageSum<T>>& Sums;
  std::array<T, 3> Weights{}; ///< of second differences

private:
  std::unique_ptr<T[]> Borders;
};

/// One strip at a time, with the last three planes of each stage.
template <typename T>
class SweepLane
{
public:
  SweepLane(const SharedSweep<T>& shared, std::int64_t stripRows)
    : Shared(shared)
    , StripRows(stripRows)
    , Rows(static_cast<std::size_t>(RowCount(shared.Stages(), stripRows) * shared.Stride))
  {
  }

  static std::int64_t RowCount(std::int64_t stages, std::int64_t stripRows)
  {
    return stages * planes * (stripRows + borderRows) + 2; // and the two scratch rows
  }

  /// Continues strip number `strip` with these waves: stage n is done in plane wave - n.
  void Run(std::int64_t strip, std::int64_t begin, std::int64_t end)
  {
    this->Strip = strip;
    for (std::int64_t wave = begin; wave < end; ++wave)
    {
      if (wave < this->Shared.Size[2])
      {
        this->LoadFirst(wave);
      }
      for (std::int64_t stage = 1; stage <= this->Shared.Stages(); ++stage)
      {
        if (wave >= stage && wave - stage < this->Shared.Size[2])
        {
          this->RunStage(stage, wave - stage);
        }
      }
    }
  }

private:
  static constexpr std::int64_t planes = 3;

  /// The first of the rows that this strip computes of a stage; may be outside of the grid.
  std::int64_t FirstRow(std::int64_t stage) const { return this->Strip * this->StripRows - stage; }

  bool Exists(std::int64_t row) const { return row >= 0 && row < this->Shared.Size[1]; }

  T* Row(std::int64_t stage, std::int64_t plane, std::int64_t row)
  {
    const auto slot = static_cast<std::uint32_t>(plane) % static_cast<std::uint32_t>(planes);
    const std::int64_t nth = row - this->FirstRow(stage) + borderRows;
    return this->Rows.data() +
      ((stage * planes + slot) * (this->StripRows + borderRows) + nth) * this->Shared.Stride +
      RowMargin;
  }

  /// Where the stage after the last one would be.
  T* Scratch(std::int64_t nth)
  {
    return this->Rows.data() +
      (this->Shared.Stages() * planes * (this->StripRows + borderRows) + nth) *
      this->Shared.Stride +
      RowMargin;
  }

  std::int64_t Offset(std::int64_t row, std::int64_t plane) const
  {
    return this->Shared.Size[0] * (row + this->Shared.Size[1] * plane);
  }

  void LoadFirst(std::int64_t plane)
  {
    for (std::int64_t row = this->FirstRow(0) - borderRows; row < this->FirstRow(0) + StripRows;
         ++row)
    {
      if (this->Exists(row))
      {
        T* const out = this->Row(0, plane, row);
        std::copy_n(this->Shared.First + this->Offset(row, plane), this->Shared.Size[0], out);
        RepeatEnds(out, this->Shared.Size[0]);
      }
    }
  }

  void RunStage(std::int64_t stage, std::int64_t plane)
  {
    const bool last = stage == this->Shared.Stages();
    const std::int64_t first = this->FirstRow(stage), end = first + this->StripRows;
    for (std::int64_t nth = 0; nth < borderRows && !last; ++nth)
    {
      const std::int64_t row = first - borderRows + nth;
      if (this->Exists(row))
      {
        this->CopyRow(this->Shared.Border(stage, plane, nth), this->Row(stage, plane, row));
      }
    }
    for (std::int64_t row = std::max<std::int64_t>(0, first);
         row < std::min(this->Shared.Size[1], end); ++row)
    {
      T* const out = last ? this->Scratch(0) : this->Row(stage, plane, row);
      this->Compute(stage, plane, row, out);
    }
    for (std::int64_t nth = 0; nth < borderRows && !last; ++nth)
    {
      const std::int64_t row = end - borderRows + nth;
      if (this->Exists(row))
      {
        this->CopyRow(this->Row(stage, plane, row), this->Shared.Border(stage, plane, nth));
      }
    }
  }

  void CopyRow(const T* from, T* to) const
  {
    std::copy_n(from - RowMargin, this->Shared.Stride, to - RowMargin);
  }

  void Compute(std::int64_t stage, std::int64_t plane, std::int64_t row, T* out)
  {
    const auto& [length, rows, planeCount] = this->Shared.Size;
    const T* const center = this->Row(stage - 1, plane, row);
    const RowStencil<T> stencil{ center, row > 0 ? center - this->Shared.Stride : center,
      row + 1 < rows ? center + this->Shared.Stride : center,
      plane > 0 ? this->Row(stage - 1, plane - 1, row) : center,
      plane + 1 < planeCount ? this->Row(stage - 1, plane + 1, row) : center };
    T* const rate = this->Scratch(1);
    LaplacianRow(stencil, center, T(0), this->Shared.Weights, length, rate);
    const std::int64_t offset = this->Offset(row, plane);
    const T* const first = this->Shared.First + offset;
    const auto update = static_cast<std::size_t>(stage - 1);
    UpdateRow(this->Shared.Updates[update], center,
      stage > 1 ? this->Row(stage - 2, plane, row) : nullptr, first, rate, nullptr, length, out);
    RepeatEnds(out, length);
    for (const StageSum<T>& sum : this->Shared.Sums)
    {
      T* const total = sum.Volume + offset;
      if (stage == 1)
      {
        std::fill_n(total, length, T(0));
      }
      if (update < sum.StageFactors.size())
      {
        AddChangeRow(sum.StageFactors[update], out, first, length, total);
      }
    }
  }

  const SharedSweep<T>& Shared;
  std::int64_t StripRows, Strip = 0;
  std::vector<T> Rows;
};

}

template <typename T>
double SweepBytes(const DiffusionGrid<T>& grid, std::size_t stages)
{
  const auto count = static_cast<std::int64_t>(stages);
  const SweepPlan plan(grid, count);
  return static_cast<double>(sizeof(T)) *
    (static_cast<double>(SharedSweep<T>::BorderSize(grid, stages)) +
      static_cast<double>(plan.Lanes * SweepLane<T>::RowCount(count, plan.StripRows) *
        PaddedStride(grid.Dimensions[0])));
}

template <typename T>
void SweepStages(const DiffusionGrid<T>& grid, const std::vector<RowUpdate<T>>& updates,
  const T* first, const std::vector<StageSum<T>>& sums, const ProgressCallback& progress)
{
  if (grid.Size() == 0)
  {
    return;
  }
  const SharedSweep<T> shared(grid, updates, first, sums);
  const SweepPlan plan(grid, shared.Stages());
  std::vector<SweepLane<T>> lanes(
    static_cast<std::size_t>(plan.Lanes), SweepLane<T>(shared, plan.StripRows));
  // Lane n does strips n, n + Lanes, ..., at each step one block of waves. It starts n steps later
  // than the first, so that the strip before is always a block ahead; a lane has as many blocks as
  // there are lanes, or more, so none has to wait for the last.
  const std::int64_t steps = CountParts(plan.Strips, plan.Lanes) * plan.Blocks + plan.Lanes - 1;
  Stopwatch watch;
  double passed = 0.0;
  for (std::int64_t step = 0; step < steps; ++step)
  {
    ParallelFor(0, plan.Lanes, 1,
      [&](std::int64_t from, std::int64_t to)
      {
        for (std::int64_t lane = from; lane < to; ++lane)
        {
          const std::int64_t done = step - lane;
          const std::int64_t strip = done / plan.Blocks * plan.Lanes + lane;
          if (done >= 0 && strip < plan.Strips)
          {
            const std::int64_t begin = done % plan.Blocks * plan.BlockWaves;
            lanes[static_cast<std::size_t>(lane)].Run(
              strip, begin, std::min(plan.Waves, begin + plan.BlockWaves));
          }
        }
      });
    passed += watch.Lap();
    if (passed > 0.1 || step + 1 == steps)
    {
      Report(progress, static_cast<double>(step + 1) / static_cast<double>(steps));
      passed = 0.0;
    }
  }
}

#define ISTHMUS_STAGE_SWEEP(T)                                                                     \
  template double SweepBytes(const DiffusionGrid<T>&, std::size_t);                                \
  template void SweepStages(const DiffusionGrid<T>&, const std::vector<RowUpdate<T>>&, const T*,   \
    const std::vector<StageSum<T>>&, const ProgressCallback&);

ISTHMUS_STAGE_SWEEP(float)
ISTHMUS_STAGE_SWEEP(double)

}
