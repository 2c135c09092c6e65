#include "Imaging/DiffusionEvaluation.h"

#include "Core/ParallelFor.h"
#include "Imaging/DiffusionRows.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace isthmus
{
namespace
{

/// The last few planes of a quantity, as far as a tile of rows needs them. Each row has margins. A
/// ring of depth 0 is empty.
template <typename T>
class PlaneRing
{
public:
  PlaneRing() = default;
  PlaneRing(std::int64_t rowLength, std::int64_t tileRows, int depth)
    : RowCount(tileRows)
    , Depth(depth)
    , Stride(PaddedStride(rowLength))
    , Values(static_cast<std::size_t>(depth * tileRows * this->Stride))
  {
  }

  /// The rows kept from now on: those from `first`, of a grid with `rows` rows and `planes` planes.
  void Place(std::int64_t first, std::int64_t rows, std::int64_t planes)
  {
    this->FirstRow = std::max<std::int64_t>(first, 0);
    this->GridRows = rows;
    this->GridPlanes = planes;
  }

  T* Row(std::int64_t row, std::int64_t plane)
  {
    // 32 bits: this is done for every row, and dividing 64 costs as much as a tenth of the row.
    const auto slot = static_cast<std::uint32_t>(plane) % static_cast<std::uint32_t>(this->Depth);
    return this->Values.data() +
      (static_cast<std::int64_t>(slot) * this->RowCount + (row - this->FirstRow)) * this->Stride +
      RowMargin;
  }

  /// The row with its neighbours; beyond the grid's ends, the outermost ones again (Neumann).
  RowStencil<T> Stencil(std::int64_t row, std::int64_t plane)
  {
    const std::int64_t lastRow = this->GridRows - 1, lastPlane = this->GridPlanes - 1;
    const T* center = this->Row(row, plane);
    return { center, row > 0 ? center - this->Stride : center,
      row < lastRow ? center + this->Stride : center,
      this->Row(row, std::max<std::int64_t>(plane - 1, 0)),
      this->Row(row, std::min(plane + 1, lastPlane)) };
  }

private:
  std::int64_t RowCount = 0, Depth = 0, Stride = 0;
  std::int64_t FirstRow = 0, GridRows = 0, GridPlanes = 0;
  std::vector<T> Values;
};

/**
 * One tile of rows walked through plane by plane, several stages behind each other.
 *
 * Each stage is u -> L u -> ... -> W, c -> rate -> update; its result is the next one's u. Each
 * stage runs behind the previous one by as many planes as its stencil reaches, so that only a few
 * planes between the first u and the last result are alive, and stay in cache.
 */
template <typename T>
class DiffusionPipeline
{
public:
  struct Range
  {
    std::int64_t Begin, End;
  };

  /// Rows of a tile whose planes fill about half a MiB, or 1.5 MiB with several stages.
  static std::int64_t TileRowsThatFit(const DiffusionOperator<T>& diffusion, int stages);

  DiffusionPipeline(const DiffusionOperator<T>& diffusion, int stages, std::int64_t tileRows);

  /// Performs the stages of a pass for these rows of these planes. Each tile recomputes what later
  /// stages need beyond its sides.
  void Run(const DiffusionPass<T>& pass, Range rows, Range planes);

private:
  /// The planes that one stage stores.
  struct Stage
  {
    std::vector<PlaneRing<T>> Levels; ///< L^m u with the lower orders added; the last is W
    PlaneRing<T> C;                   ///< empty where the coefficient is constant or stored
  };

  void RunStage(std::size_t stage, std::int64_t wave);
  /// The rows to compute of a quantity that lags `lag` planes behind the first u.
  Range Owed(std::int64_t plane, int lag) const;
  bool Own(std::int64_t row, std::int64_t plane) const;
  std::int64_t Offset(std::int64_t row, std::int64_t plane) const;
  void Load(PlaneRing<T>& ring, const T* volume, Range rows, std::int64_t plane);
  void RaiseOrder(Stage& stage, std::size_t level, Range rows, std::int64_t plane);
  void FillCoefficient(std::size_t stage, Range rows, std::int64_t plane);
  void FillRates(std::size_t stage, std::int64_t row, std::int64_t plane);
  void WriteRow(std::size_t stage, std::int64_t row, std::int64_t plane);
  void AddReactions(const T* current, std::int64_t offset);
  PlaneRing<T>& CoefficientRing(std::size_t stage);

  const DiffusionOperator<T>& Diffusion;
  DiffusionLags Lags;
  std::int64_t Length; ///< of a row
  std::array<T, 3> SecondWeights, FirstWeights;
  const DiffusionPass<T>* Pass = nullptr;
  Range OwnRows{ 0, 0 }, OwnPlanes{ 0, 0 }; ///< of the tile, without what its neighbours own
  std::vector<Stage> Stages;
  PlaneRing<T> StoredC; ///< shared by the stages
  std::vector<T> RateScratch;
};

bool NeedsCoefficient(DiffusionCoefficient coefficient)
{
  return coefficient != DiffusionCoefficient::Constant;
}

/// Planes that must be kept of a quantity with lag `own` for a stencil of one with lag `reader`.
int Depth(int reader, int own)
{
  return reader - own + 2;
}

/// Planes kept of u, L u, ..., W and c of a stage, in this order.
template <typename T>
std::vector<int> Depths(const DiffusionLags& lags, const DiffusionOperator<T>& diffusion, bool last)
{
  std::vector<int> depths(static_cast<std::size_t>(lags.W) + 1, 3);
  depths.back() = Depth(lags.Out, lags.W);
  // u is read again at its own place by every higher order, by its update, and as the previous
  // values by that of the next stage.
  depths.front() = std::max(depths.front(), (last ? 1 : 2) * lags.Out + 1);
  const bool own = NeedsCoefficient(diffusion.Coefficient) && !diffusion.StoredCoefficient;
  depths.push_back(own ? Depth(lags.Out, lags.C) : 0);
  return depths;
}

/// Planes kept of a coefficient that is read for all stages.
template <typename T>
int StoredDepth(const DiffusionLags& lags, const DiffusionOperator<T>& diffusion, int stages)
{
  return NeedsCoefficient(diffusion.Coefficient) && diffusion.StoredCoefficient
    ? Depth(stages * lags.Out, lags.Out - 1)
    : 0;
}

template <typename T>
std::int64_t DiffusionPipeline<T>::TileRowsThatFit(
  const DiffusionOperator<T>& diffusion, int stages)
{
  // Planes of several stages may be in the third level of the cache: larger tiles repeat less.
  const std::int64_t cacheBytes = (stages > 1 ? 1536 : 512) * 1024;
  constexpr std::int64_t fewestRows = 16; // fewer would mostly repeat their neighbours' work
  const DiffusionLags lags(diffusion);
  std::int64_t planes = StoredDepth(lags, diffusion, stages);
  for (int stage = 0; stage < stages; ++stage)
  {
    for (const int depth : Depths(lags, diffusion, stage + 1 == stages))
    {
      planes += depth;
    }
  }
  // The first values and rates are read in place, once by each stage.
  planes += stages > 1 ? 2 * (stages * lags.Out - lags.Out + 1) : 0;
  const auto rowBytes =
    PaddedStride(diffusion.Dimensions[0]) * static_cast<std::int64_t>(sizeof(T)) * planes;
  return std::max(fewestRows, cacheBytes / rowBytes - stages * lags.Out - lags.Out);
}

template <typename T>
DiffusionPipeline<T>::DiffusionPipeline(
  const DiffusionOperator<T>& diffusion, int stages, std::int64_t tileRows)
  : Diffusion(diffusion)
  , Lags(diffusion)
  , Length(diffusion.Dimensions[0])
  , RateScratch(static_cast<std::size_t>(PaddedStride(this->Length)))
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double h = diffusion.Spacing[axis];
    this->SecondWeights[axis] = static_cast<T>(1.0 / (h * h));
    this->FirstWeights[axis] = static_cast<T>(0.5 / (h * diffusion.GradientScale));
  }
  const std::int64_t rows = tileRows + 2 * stages * this->Lags.Out;
  this->StoredC = { this->Length, rows, StoredDepth(this->Lags, diffusion, stages) };
  for (int n = 0; n < stages; ++n)
  {
    const std::vector<int> depths = Depths(this->Lags, diffusion, n + 1 == stages);
    Stage stage;
    for (std::size_t level = 0; level + 1 < depths.size(); ++level)
    {
      stage.Levels.emplace_back(this->Length, rows, depths[level]);
    }
    stage.C = { this->Length, rows, depths.back() };
    this->Stages.push_back(std::move(stage));
  }
}

template <typename T>
void DiffusionPipeline<T>::Run(const DiffusionPass<T>& pass, Range rows, Range planes)
{
  const auto& size = this->Diffusion.Dimensions;
  const int reach = pass.Stages() * this->Lags.Out;
  this->Pass = &pass;
  this->OwnRows = rows;
  this->OwnPlanes = planes;
  auto place = [&](PlaneRing<T>& ring) { ring.Place(rows.Begin - reach, size[1], size[2]); };
  place(this->StoredC);
  for (Stage& stage : this->Stages)
  {
    std::for_each(stage.Levels.begin(), stage.Levels.end(), place);
    place(stage.C);
  }
  for (std::int64_t wave = planes.Begin - reach; wave < planes.End + reach; ++wave)
  {
    this->Load(this->Stages[0].Levels.front(), pass.Current, this->Owed(wave, 0), wave);
    if (NeedsCoefficient(this->Diffusion.Coefficient) && this->Diffusion.StoredCoefficient)
    {
      // Loaded when it is needed, so that it is stored for as short a time as possible.
      const int lag = this->Lags.Out - 1;
      this->Load(
        this->StoredC, this->Diffusion.StoredCoefficient, this->Owed(wave - lag, lag), wave - lag);
    }
    for (std::size_t stage = 0; stage < this->Stages.size(); ++stage)
    {
      this->RunStage(stage, wave);
    }
  }
}

template <typename T>
void DiffusionPipeline<T>::RunStage(std::size_t number, std::int64_t wave)
{
  Stage& stage = this->Stages[number];
  const int before = static_cast<int>(number) * this->Lags.Out;
  for (int order = 1; order <= this->Lags.W; ++order)
  {
    const int lag = before + order;
    this->RaiseOrder(
      stage, static_cast<std::size_t>(order), this->Owed(wave - lag, lag), wave - lag);
  }
  if (NeedsCoefficient(this->Diffusion.Coefficient) && !this->Diffusion.StoredCoefficient)
  {
    const int lag = before + this->Lags.C;
    this->FillCoefficient(number, this->Owed(wave - lag, lag), wave - lag);
  }
  const int lag = before + this->Lags.Out;
  const Range rows = this->Owed(wave - lag, lag);
  for (std::int64_t row = rows.Begin; row < rows.End; ++row)
  {
    this->FillRates(number, row, wave - lag);
    this->WriteRow(number, row, wave - lag);
  }
}

template <typename T>
typename DiffusionPipeline<T>::Range DiffusionPipeline<T>::Owed(std::int64_t plane, int lag) const
{
  const auto& size = this->Diffusion.Dimensions;
  const std::int64_t margin = this->Pass->Stages() * this->Lags.Out - lag;
  if (plane < std::max<std::int64_t>(0, this->OwnPlanes.Begin - margin) ||
    plane >= std::min(size[2], this->OwnPlanes.End + margin))
  {
    return { 0, 0 };
  }
  return { std::max<std::int64_t>(0, this->OwnRows.Begin - margin),
    std::min(size[1], this->OwnRows.End + margin) };
}

template <typename T>
bool DiffusionPipeline<T>::Own(std::int64_t row, std::int64_t plane) const
{
  return plane >= this->OwnPlanes.Begin && plane < this->OwnPlanes.End &&
    row >= this->OwnRows.Begin && row < this->OwnRows.End;
}

template <typename T>
std::int64_t DiffusionPipeline<T>::Offset(std::int64_t row, std::int64_t plane) const
{
  return this->Length * (row + this->Diffusion.Dimensions[1] * plane);
}

template <typename T>
PlaneRing<T>& DiffusionPipeline<T>::CoefficientRing(std::size_t stage)
{
  return this->Diffusion.StoredCoefficient ? this->StoredC : this->Stages[stage].C;
}

template <typename T>
void DiffusionPipeline<T>::Load(PlaneRing<T>& ring, const T* volume, Range rows, std::int64_t plane)
{
  for (std::int64_t row = rows.Begin; row < rows.End; ++row)
  {
    T* out = ring.Row(row, plane);
    std::copy_n(volume + this->Offset(row, plane), this->Length, out);
    RepeatEnds(out, this->Length);
  }
}

template <typename T>
void DiffusionPipeline<T>::RaiseOrder(
  Stage& stage, std::size_t level, Range rows, std::int64_t plane)
{
  const T weight = this->Diffusion.Weights[stage.Levels.size() - 1 - level];
  for (std::int64_t row = rows.Begin; row < rows.End; ++row)
  {
    T* out = stage.Levels[level].Row(row, plane);
    LaplacianRow(stage.Levels[level - 1].Stencil(row, plane), stage.Levels.front().Row(row, plane),
      weight, this->SecondWeights, this->Length, out);
    RepeatEnds(out, this->Length);
  }
}

template <typename T>
void DiffusionPipeline<T>::FillCoefficient(std::size_t number, Range rows, std::int64_t plane)
{
  Stage& stage = this->Stages[number];
  const bool gaussian = this->Diffusion.Coefficient == DiffusionCoefficient::Gaussian;
  T* const stored = number == 0 ? this->Pass->StoreCoefficient : nullptr;
  PlaneRing<T>& source = gaussian ? stage.Levels.front() : stage.Levels.back();
  for (std::int64_t row = rows.Begin; row < rows.End; ++row)
  {
    T* out = stage.C.Row(row, plane);
    GradientSquaredRow(source.Stencil(row, plane), this->FirstWeights, this->Length, out);
    if (gaussian)
    {
      ExponentialRow(this->Length, out);
    }
    RepeatEnds(out, this->Length);
    if (stored && this->Own(row, plane))
    {
      std::copy_n(out, this->Length, stored + this->Offset(row, plane));
    }
  }
}

/// The rates of a row of a stage's u.
template <typename T>
void DiffusionPipeline<T>::FillRates(std::size_t number, std::int64_t row, std::int64_t plane)
{
  Stage& stage = this->Stages[number];
  T* rate = this->RateScratch.data();
  const RowStencil<T> w = stage.Levels.back().Stencil(row, plane);
  if (this->Diffusion.Coefficient == DiffusionCoefficient::Constant)
  {
    LaplacianRow(w, w.Center, T(0), this->SecondWeights, this->Length, rate);
  }
  else if (this->Diffusion.Coefficient == DiffusionCoefficient::Gram)
  {
    GramDivergenceRow(w, this->CoefficientRing(number).Stencil(row, plane), this->SecondWeights,
      this->Length, rate);
  }
  else
  {
    DivergenceRow(w, this->CoefficientRing(number).Stencil(row, plane), this->SecondWeights,
      this->Length, rate);
  }
  const std::int64_t offset = this->Offset(row, plane);
  this->AddReactions(stage.Levels.front().Row(row, plane), offset);
  if (number == 0 && this->Pass->StoreRate && this->Own(row, plane))
  {
    std::copy_n(rate, this->Length, this->Pass->StoreRate + offset);
  }
}

/// Computes a stage's result in a row from its rates: the next stage's u, or the pass's result.
template <typename T>
void DiffusionPipeline<T>::WriteRow(std::size_t number, std::int64_t row, std::int64_t plane)
{
  const DiffusionPass<T>& pass = *this->Pass;
  const std::int64_t offset = this->Offset(row, plane);
  auto at = [offset](auto* volume) { return volume ? volume + offset : nullptr; };
  const bool last = number + 1 == this->Stages.size();
  T* out = last ? at(pass.Out) : this->Stages[number + 1].Levels.front().Row(row, plane);
  const T* previous = at(pass.Previous);
  if (number > 0 && pass.First)
  {
    previous = this->Stages[number - 1].Levels.front().Row(row, plane);
  }
  UpdateRow(pass.Updates[number], this->Stages[number].Levels.front().Row(row, plane), previous,
    at(pass.First), this->RateScratch.data(), at(pass.FirstRate), this->Length, out);
  if (!last)
  {
    RepeatEnds(out, this->Length);
  }
  if (!this->Own(row, plane))
  {
    return;
  }
  if (pass.OutBefore && number + 2 == this->Stages.size())
  {
    std::copy_n(out, this->Length, at(pass.OutBefore));
  }
  for (const StageSum<T>& sum : pass.Sums)
  {
    if (number >= sum.StageFactors.size())
    {
      continue;
    }
    AddChangeRow(sum.StageFactors[number], out, at(pass.First), this->Length, at(sum.Volume));
  }
}

template <typename T>
void DiffusionPipeline<T>::AddReactions(const T* current, std::int64_t offset)
{
  T* rate = this->RateScratch.data();
  const T leading = this->Diffusion.Leading, fidelity = this->Diffusion.Fidelity;
  if (leading != T(1))
  {
    std::for_each(rate, rate + this->Length, [leading](T& value) { value *= leading; });
  }
  if (fidelity != T(0))
  {
    const T* input = this->Diffusion.Input + offset;
    for (std::int64_t i = 0; i < this->Length; ++i)
    {
      rate[i] += fidelity * (input[i] - current[i]);
    }
  }
  if (this->Diffusion.Source)
  {
    const T* source = this->Diffusion.Source + offset;
    std::transform(rate, rate + this->Length, source, rate, [](T a, T b) { return a + b; });
  }
}

/// Provides pipelines, so that each thread has one and their memory is first touched once and not
/// for every tile.
template <typename T>
class PipelinePool
{
public:
  using Pipeline = std::unique_ptr<DiffusionPipeline<T>>;

  Pipeline Take(const DiffusionOperator<T>& diffusion, int stages, std::int64_t tileRows)
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (!this->Idle.empty())
      {
        Pipeline pipeline = std::move(this->Idle.back());
        this->Idle.pop_back();
        return pipeline;
      }
    }
    return std::make_unique<DiffusionPipeline<T>>(diffusion, stages, tileRows);
  }

  void Return(Pipeline pipeline)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Idle.push_back(std::move(pipeline));
  }

private:
  std::mutex Mutex;
  std::vector<Pipeline> Idle;
};

std::int64_t Parts(std::int64_t whole, std::int64_t part)
{
  return (whole + part - 1) / part;
}

}

template <typename T>
int StagesPerPass(const DiffusionOperator<T>& diffusion)
{
  // The overlap of tiles grows with the reach of each stage: from order 1 on, it costs more than
  // the saved memory traffic gains.
  return diffusion.Order() == 0 ? 4 : 1;
}

template <typename T>
void Evaluate(const DiffusionOperator<T>& diffusion, const DiffusionPass<T>& pass,
  const ProgressCallback& progress)
{
  if (diffusion.Size() == 0)
  {
    return;
  }
  const std::int64_t rows = diffusion.Dimensions[1];
  const std::int64_t planes = diffusion.Dimensions[2];
  const int stages = pass.Stages();
  const std::int64_t chunkPlanes = 64 * stages; // so that little is computed twice
  const std::int64_t fitting = DiffusionPipeline<T>::TileRowsThatFit(diffusion, stages);
  const std::int64_t tileRows = Parts(rows, Parts(rows, fitting)); // tiles of nearly equal height
  const std::int64_t tiles = Parts(rows, tileRows);
  const std::int64_t chunks = Parts(planes, chunkPlanes);
  PipelinePool<T> pool;
  ParallelFor(
    0, tiles * chunks, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      auto pipeline = pool.Take(diffusion, stages, tileRows);
      for (std::int64_t item = first; item < last; ++item)
      {
        const std::int64_t row = item % tiles * tileRows;
        const std::int64_t plane = item / tiles * chunkPlanes;
        pipeline->Run(pass, { row, std::min(rows, row + tileRows) },
          { plane, std::min(planes, plane + chunkPlanes) });
      }
      pool.Return(std::move(pipeline));
    },
    progress);
}

template int StagesPerPass(const DiffusionOperator<float>&);
template int StagesPerPass(const DiffusionOperator<double>&);
template void Evaluate(
  const DiffusionOperator<float>&, const DiffusionPass<float>&, const ProgressCallback&);
template void Evaluate(
  const DiffusionOperator<double>&, const DiffusionPass<double>&, const ProgressCallback&);

}
