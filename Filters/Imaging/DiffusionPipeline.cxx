#include "DiffusionPipeline.h"

namespace isthmus
{
namespace
{

bool NeedsCoefficient(DiffusionCoefficient coefficient)
{
  return coefficient != DiffusionCoefficient::Constant;
}

/// Planes that must be kept of a quantity with lag `own` for a stencil of one with lag `reader`.
int Depth(int reader, int own)
{
  return reader - own + 2;
}

/// Depths of u, L u, ..., W and c, in this order.
std::vector<int> Depths(const DiffusionLags& lags, DiffusionCoefficient coefficient)
{
  std::vector<int> depths(static_cast<std::size_t>(lags.W) + 1, 3);
  // u is read again at its own place by every higher order.
  depths.front() = std::max(3, lags.W + 1);
  depths.back() = Depth(lags.Out, lags.W);
  depths.push_back(NeedsCoefficient(coefficient) ? Depth(lags.Out, lags.C) : 0);
  return depths;
}

/// Repeats the ends of a row into its margins.
template <typename T>
void RepeatEnds(T* row, std::int64_t n)
{
  row[-1] = row[0];
  std::fill(row + n, row + PaddedLength(n) + 1, row[n - 1]);
}

template <typename T>
std::int64_t StrideOf(std::int64_t rowLength)
{
  return PaddedLength(rowLength) + 2 * RowMargin;
}

}

template <typename T>
PlaneRing<T>::PlaneRing(std::int64_t rowLength, std::int64_t tileRows, int depth)
  : RowCount(tileRows)
  , Depth(depth)
  , Stride(StrideOf<T>(rowLength))
  , Values(static_cast<std::size_t>(depth * tileRows * this->Stride))
{
}

template <typename T>
void PlaneRing<T>::Place(std::int64_t first, std::int64_t rows, std::int64_t planes)
{
  this->FirstRow = std::max<std::int64_t>(first, 0);
  this->GridRows = rows;
  this->GridPlanes = planes;
}

template <typename T>
std::int64_t DiffusionPipeline<T>::TileRowsThatFit(const DiffusionOperator<T>& diffusion)
{
  constexpr std::int64_t cacheBytes = 512 * 1024;
  constexpr std::int64_t fewestRows = 16; // fewer would mostly repeat their neighbours' work
  const DiffusionLags lags(diffusion);
  std::int64_t planes = 0;
  for (const int depth : Depths(lags, diffusion.Coefficient))
  {
    planes += depth;
  }
  const auto rowBytes =
    StrideOf<T>(diffusion.Dimensions[0]) * static_cast<std::int64_t>(sizeof(T)) * planes;
  return std::max(fewestRows, cacheBytes / rowBytes - 2 * lags.Out);
}

template <typename T>
DiffusionPipeline<T>::DiffusionPipeline(
  const DiffusionOperator<T>& diffusion, std::int64_t tileRows)
  : Diffusion(diffusion)
  , Lags(diffusion)
  , Length(diffusion.Dimensions[0])
  , C(this->Length, tileRows + 2 * this->Lags.Out, Depths(this->Lags, diffusion.Coefficient).back())
  , RateScratch(static_cast<std::size_t>(StrideOf<T>(this->Length)))
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double h = diffusion.Spacing[axis];
    this->SecondWeights[axis] = static_cast<T>(1.0 / (h * h));
    this->FirstWeights[axis] = static_cast<T>(0.5 / (h * diffusion.GradientScale));
  }
  const std::vector<int> depths = Depths(this->Lags, diffusion.Coefficient);
  for (int order = 0; order <= this->Lags.W; ++order)
  {
    this->Levels.emplace_back(
      this->Length, tileRows + 2 * this->Lags.Out, depths[static_cast<std::size_t>(order)]);
  }
}

template <typename T>
void DiffusionPipeline<T>::Run(const DiffusionStage<T>& stage, Range rows, Range planes)
{
  const auto& size = this->Diffusion.Dimensions;
  this->OwnRows = rows;
  this->OwnPlanes = planes;
  for (auto& level : this->Levels)
  {
    level.Place(rows.Begin - this->Lags.Out, size[1], size[2]);
  }
  this->C.Place(rows.Begin - this->Lags.Out, size[1], size[2]);
  // Runs `step` for the plane and rows that a quantity with this lag owes at this wave.
  auto owed = [&](std::int64_t wave, int lag, auto&& step)
  {
    const std::int64_t plane = wave - lag, margin = this->Lags.Out - lag;
    if (plane >= std::max<std::int64_t>(0, planes.Begin - margin) &&
      plane < std::min(size[2], planes.End + margin))
    {
      step(Range{ std::max<std::int64_t>(0, rows.Begin - margin),
             std::min(size[1], rows.End + margin) },
        plane);
    }
  };
  for (std::int64_t wave = planes.Begin - this->Lags.Out; wave < planes.End + this->Lags.Out;
       ++wave)
  {
    owed(wave, 0,
      [&](Range r, std::int64_t k) { this->Load(this->Levels.front(), stage.Current, r, k); });
    for (int order = 1; order <= this->Lags.W; ++order)
    {
      owed(wave, order, [&](Range r, std::int64_t k) { this->RaiseOrder(order, r, k); });
    }
    if (NeedsCoefficient(this->Diffusion.Coefficient))
    {
      owed(
        wave, this->Lags.C, [&](Range r, std::int64_t k) { this->FillCoefficient(stage, r, k); });
    }
    owed(wave, this->Lags.Out,
      [&](Range r, std::int64_t k)
      {
        for (std::int64_t row = r.Begin; row < r.End; ++row)
        {
          this->WriteRow(stage, row, k);
        }
      });
  }
}

template <typename T>
void DiffusionPipeline<T>::Load(PlaneRing<T>& ring, const T* volume, Range rows, std::int64_t plane)
{
  for (std::int64_t row = rows.Begin; row < rows.End; ++row)
  {
    T* out = ring.Row(row, plane);
    std::copy_n(
      volume + this->Length * (row + this->Diffusion.Dimensions[1] * plane), this->Length, out);
    RepeatEnds(out, this->Length);
  }
}

template <typename T>
void DiffusionPipeline<T>::RaiseOrder(int order, Range rows, std::int64_t plane)
{
  const auto level = static_cast<std::size_t>(order);
  const T weight = this->Diffusion.Weights[this->Levels.size() - 1 - level];
  for (std::int64_t row = rows.Begin; row < rows.End; ++row)
  {
    T* out = this->Levels[level].Row(row, plane);
    LaplacianRow(this->Levels[level - 1].Stencil(row, plane), this->Levels.front().Row(row, plane),
      weight, this->SecondWeights, this->Length, out);
    RepeatEnds(out, this->Length);
  }
}

template <typename T>
void DiffusionPipeline<T>::FillCoefficient(
  const DiffusionStage<T>& stage, Range rows, std::int64_t plane)
{
  if (this->Diffusion.StoredCoefficient)
  {
    this->Load(this->C, this->Diffusion.StoredCoefficient, rows, plane);
    return;
  }
  const bool gaussian = this->Diffusion.Coefficient == DiffusionCoefficient::Gaussian;
  const bool stored =
    stage.StoreCoefficient && plane >= this->OwnPlanes.Begin && plane < this->OwnPlanes.End;
  PlaneRing<T>& source = gaussian ? this->Levels.front() : this->Levels.back();
  for (std::int64_t row = rows.Begin; row < rows.End; ++row)
  {
    T* out = this->C.Row(row, plane);
    GradientSquaredRow(source.Stencil(row, plane), this->FirstWeights, this->Length, out);
    if (gaussian)
    {
      ExponentialRow(this->Length, out);
    }
    RepeatEnds(out, this->Length);
    if (stored && row >= this->OwnRows.Begin && row < this->OwnRows.End)
    {
      std::copy_n(out, this->Length,
        stage.StoreCoefficient + this->Length * (row + this->Diffusion.Dimensions[1] * plane));
    }
  }
}

template <typename T>
void DiffusionPipeline<T>::WriteRow(
  const DiffusionStage<T>& stage, std::int64_t row, std::int64_t plane)
{
  T* rate = this->RateScratch.data();
  const RowStencil<T> w = this->Levels.back().Stencil(row, plane);
  if (this->Diffusion.Coefficient == DiffusionCoefficient::Constant)
  {
    LaplacianRow(w, w.Centre, T(0), this->SecondWeights, this->Length, rate);
  }
  else if (this->Diffusion.Coefficient == DiffusionCoefficient::Gram)
  {
    GramDivergenceRow(w, this->C.Stencil(row, plane), this->SecondWeights, this->Length, rate);
  }
  else
  {
    DivergenceRow(w, this->C.Stencil(row, plane), this->SecondWeights, this->Length, rate);
  }
  const std::int64_t offset = this->Length * (row + this->Diffusion.Dimensions[1] * plane);
  this->AddReactions(stage.Current + offset, offset);
  auto at = [offset](auto* volume) { return volume ? volume + offset : nullptr; };
  if (stage.StoreRate)
  {
    std::copy_n(rate, this->Length, at(stage.StoreRate));
  }
  UpdateRow(stage.Update, at(stage.Current), at(stage.Previous), at(stage.First), rate,
    at(stage.FirstRate), this->Length, at(stage.Out));
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

template class PlaneRing<float>;
template class PlaneRing<double>;
template class DiffusionPipeline<float>;
template class DiffusionPipeline<double>;

}
