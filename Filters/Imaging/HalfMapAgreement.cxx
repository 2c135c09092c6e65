#include "Imaging/HalfMapAgreement.h"

#include "Core/ImageScalars.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace isthmus
{
namespace
{

constexpr int BlockSide = 4;
constexpr int FarthestBlocks = 4; // a shift of up to 16 nodes

/// Halves with a lower correlation have no common signal. Of independent noise, a map of 32^3 nodes
/// has 0.00 +- 0.04.
constexpr double LeastCorrelation = 0.1;
/// Below this correlation the line through the blocks is not well determined.
constexpr double LinearCorrelation = 0.5;
constexpr double LinearTolerance = 0.1;
/// How much higher the correlation must be after a shift, at least: chance changes that of n nodes
/// by about 1 / sqrt(n).
constexpr double ShiftGain = 0.03;
constexpr std::int64_t SampledNodes = std::int64_t{ 1 } << 17;
constexpr std::int64_t SampledBlocks = std::int64_t{ 1 } << 14;

using Indices = std::array<int, 3>;

/// Sums of the moments of pairs of numbers.
struct Moments
{
  double Count = 0.0, One = 0.0, Other = 0.0, OneOne = 0.0, OtherOther = 0.0, OneOther = 0.0;

  void Add(double one, double other)
  {
    this->Count += 1.0;
    this->One += one;
    this->Other += other;
    this->OneOne += one * one;
    this->OtherOther += other * other;
    this->OneOther += one * other;
  }

  double OneVariance() const { return this->OneOne - this->One * this->One / this->Count; }
  double OtherVariance() const
  {
    return this->OtherOther - this->Other * this->Other / this->Count;
  }

  /// NaN for fewer than three pairs, or if one number is always the same.
  double Correlation() const
  {
    const double scale = std::sqrt(this->OneVariance()) * std::sqrt(this->OtherVariance());
    return this->Count < 3.0 || !(scale > 0.0)
      ? std::numeric_limits<double>::quiet_NaN()
      : (this->OneOther - this->One * this->Other / this->Count) / scale;
  }
};

/// Two maps on one grid, with values that do not count as NaN.
struct MapPair
{
  Indices Size{ 0, 0, 0 };
  std::function<double(std::int64_t)> One, Other;

  std::int64_t Count() const { return std::int64_t{ 1 } * Size[0] * Size[1] * Size[2]; }

  /// Moments of a sample of about `sampled` nodes, the other map read at a distance of `shift`.
  Moments Compare(const Indices& shift, std::int64_t sampled) const
  {
    // An odd step that has no factor in common with rows or layers visits all columns equally
    // often.
    std::int64_t step = this->Count() / sampled + 1;
    while (step > 1 && (step % 2 == 0 || std::gcd(step, std::int64_t{ Size[0] } * Size[1]) > 1))
    {
      ++step;
    }
    Moments moments;
    for (std::int64_t n = 0; n < this->Count(); n += step)
    {
      const std::array<std::int64_t, 3> at{ n % Size[0], n / Size[0] % Size[1],
        n / Size[0] / Size[1] };
      std::int64_t there = 0, stride = 1;
      bool inside = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const std::int64_t moved = at[axis] + shift[axis];
        inside = inside && moved >= 0 && moved < Size[axis];
        there += stride * moved;
        stride *= Size[axis];
      }
      if (!inside)
      {
        continue;
      }
      const double a = this->One(n), b = this->Other(there);
      if (std::isfinite(a) && std::isfinite(b))
      {
        moments.Add(a, b);
      }
    }
    return moments;
  }

  /// The sum of the products over the overlap, over that of the squares of each map without a
  /// shift: values beyond the border count as the mean. (A coefficient of the overlap alone grows
  /// as the background is cut off.) 0 for shifts by more than a quarter of the grid, whose overlaps
  /// are so small that chance decides.
  double Overlap(const Indices& shift, std::int64_t sampled) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (4 * std::abs(shift[axis]) > this->Size[axis])
      {
        return 0.0;
      }
    }
    const Moments whole = this->Compare({ 0, 0, 0 }, sampled);
    const double scale = std::sqrt(whole.OneOne) * std::sqrt(whole.OtherOther);
    return scale > 0.0 ? this->Compare(shift, sampled).OneOther / scale : 0.0;
  }
};

/// The finite values' mean.
double FindMean(vtkDataArray* array)
{
  double sum = 0.0, count = 0.0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double value = array->GetComponent(i, 0);
    sum += std::isfinite(value) ? value : 0.0;
    count += std::isfinite(value) ? 1.0 : 0.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

/// Means over blocks with at least half of their nodes, of those of both maps that count.
MapPair AverageBlocks(const MapPair& nodes)
{
  MapPair blocks;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    blocks.Size[axis] = (nodes.Size[axis] + BlockSide - 1) / BlockSide;
  }
  const auto count = static_cast<std::size_t>(blocks.Count());
  std::vector<double> one(count, 0.0), other(count, 0.0);
  std::vector<std::array<int, 2>> counts(count, { 0, 0 });
  std::int64_t node = 0;
  for (int k = 0; k < nodes.Size[2]; ++k)
  {
    for (int j = 0; j < nodes.Size[1]; ++j)
    {
      for (int i = 0; i < nodes.Size[0]; ++i, ++node)
      {
        const auto block = static_cast<std::size_t>(i / BlockSide +
          blocks.Size[0] *
            (std::int64_t{ j / BlockSide } + std::int64_t{ blocks.Size[1] } * (k / BlockSide)));
        const double a = nodes.One(node), b = nodes.Other(node);
        ++counts[block][0];
        if (std::isfinite(a) && std::isfinite(b))
        {
          ++counts[block][1];
          one[block] += a;
          other[block] += b;
        }
      }
    }
  }
  for (std::size_t block = 0; block < count; ++block)
  {
    const bool isEnough = 2 * counts[block][1] >= counts[block][0];
    const double weight =
      isEnough ? 1.0 / counts[block][1] : std::numeric_limits<double>::quiet_NaN();
    one[block] *= weight;
    other[block] *= weight;
  }
  blocks.One = [one](std::int64_t n) { return one[static_cast<std::size_t>(n)]; };
  blocks.Other = [other](std::int64_t n) { return other[static_cast<std::size_t>(n)]; };
  return blocks;
}

/// The shift of highest correlation: among the shifts by whole blocks, then uphill by single nodes.
Indices FindShift(const MapPair& nodes, const MapPair& blocks)
{
  Indices best{ 0, 0, 0 };
  double strength = std::abs(blocks.Overlap(best, SampledBlocks));
  for (int k = -FarthestBlocks; k <= FarthestBlocks; ++k)
  {
    for (int j = -FarthestBlocks; j <= FarthestBlocks; ++j)
    {
      for (int i = -FarthestBlocks; i <= FarthestBlocks; ++i)
      {
        const Indices shift{ i, j, k };
        const double here = std::abs(blocks.Overlap(shift, SampledBlocks));
        if (here > strength)
        {
          best = shift;
          strength = here;
        }
      }
    }
  }
  for (int& steps : best)
  {
    steps *= BlockSide;
  }
  strength = std::abs(nodes.Overlap(best, SampledNodes));
  for (int climbs = 0; climbs < 3 * BlockSide; ++climbs)
  {
    Indices next = best;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const int step : { -1, 1 })
      {
        Indices near = best;
        near[axis] += step;
        const double here = std::abs(nodes.Overlap(near, SampledNodes));
        if (here > strength)
        {
          next = near;
          strength = here;
        }
      }
    }
    if (next == best)
    {
      break;
    }
    best = next;
  }
  return best;
}

std::string Correlations(double value)
{
  return FixedNumber(value, 2);
}

}

HalfMapAgreement CompareHalfMaps(
  const std::array<int, 3>& dimensions, vtkDataArray* one, vtkDataArray* other)
{
  // Minus their means, so that no digits are lost when values are squared.
  const double oneMean = FindMean(one), otherMean = FindMean(other);
  const auto read = [one, other](vtkDataArray* from, double mean)
  {
    return [=](std::int64_t n)
    {
      const double value = from->GetComponent(n, 0);
      const bool differs = one->GetComponent(n, 0) != other->GetComponent(n, 0);
      return differs ? value - mean : std::numeric_limits<double>::quiet_NaN();
    };
  };
  const MapPair nodes{ dimensions, read(one, oneMean), read(other, otherMean) };
  const MapPair blocks = AverageBlocks(nodes);
  const Indices none{ 0, 0, 0 };
  const Moments line = blocks.Compare(none, blocks.Count());
  HalfMapAgreement found;
  found.Correlation = line.Correlation();
  if (!std::isfinite(found.Correlation))
  {
    return found;
  }
  found.NodeCorrelation = nodes.Overlap(none, SampledNodes);
  found.ShiftedCorrelation = found.NodeCorrelation;
  const Indices shift = FindShift(nodes, blocks);
  const double shifted = nodes.Overlap(shift, SampledNodes);
  const auto sampled = static_cast<double>(std::min(nodes.Count(), SampledNodes));
  const double gain = std::max(ShiftGain, 6.0 / std::sqrt(sampled));
  if (std::abs(shifted) > std::abs(found.NodeCorrelation) + gain)
  {
    found.Shift = shift;
    found.ShiftedCorrelation = shifted;
  }
  if (std::abs(line.Correlation()) < LinearCorrelation)
  {
    return found;
  }
  const double deviation = std::sqrt(line.OneVariance() / line.Count);
  double factor =
    std::copysign(std::sqrt(line.OtherVariance() / line.OneVariance()), line.Correlation());
  const bool isScaled = std::abs(factor - 1.0) > LinearTolerance;
  factor = isScaled ? factor : 1.0;
  const double offset =
    (line.Other - factor * line.One) / line.Count + otherMean - factor * oneMean;
  if (isScaled || std::abs(offset) > LinearTolerance * deviation)
  {
    found.Factor = factor;
    found.Offset = offset;
  }
  return found;
}

vtkSmartPointer<vtkDataArray> RemoveLinearDifference(
  const HalfMapAgreement& agreement, vtkDataArray* other)
{
  if (!agreement.IsLinear())
  {
    return other;
  }
  const vtkIdType count = other->GetNumberOfTuples();
  const auto values = NamedArray<vtkDoubleArray>(
    other->GetName() ? other->GetName() : "", static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    values->SetValue(i, (other->GetComponent(i, 0) - agreement.Offset) / agreement.Factor);
  }
  return values.Get();
}

namespace
{

/// Whether all values that are finite are equal.
bool IsConstant(vtkDataArray* values)
{
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    low = std::isfinite(value) ? std::min(low, value) : low;
    high = std::isfinite(value) ? std::max(high, value) : high;
  }
  return !(low < high);
}

}

HalfMapMean AverageHalfMaps(vtkDataArray* one, vtkDataArray* other)
{
  const int type = FitsFloat(one) && FitsFloat(other) ? VTK_FLOAT : VTK_DOUBLE;
  const vtkIdType count = one->GetNumberOfTuples();
  HalfMapMean result{ ArrayOfType(type, one->GetName(), count), ArrayOfType(type, nullptr, count) };
  bool differs = false;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double a = one->GetComponent(i, 0), b = other->GetComponent(i, 0);
    result.Mean->SetComponent(i, 0, a / 2.0 + b / 2.0);
    const double noise = a / 2.0 - b / 2.0;
    result.HalfDifference->SetComponent(i, 0, std::isfinite(noise) ? noise : 0.0);
    differs = differs || (noise != 0.0 && std::isfinite(noise));
  }
  if (!differs)
  {
    throw std::invalid_argument(
      "The half maps are equal, so the noise cannot be estimated from their difference: take "
      "two halves, not one map twice.");
  }
  if (IsConstant(one) || IsConstant(other))
  {
    throw std::invalid_argument("The " + std::string(IsConstant(one) ? "first" : "second") +
      " half map has the same value at all nodes: it holds no data. Read it again, or choose "
      "another "
      "array.");
  }
  return result;
}

std::string HalfMapAgreement::Message() const
{
  std::string message;
  if (std::isfinite(this->Correlation) && std::abs(this->Correlation) < LeastCorrelation &&
    !this->IsShifted())
  {
    message = JoinText("The half maps have a correlation of only ", Correlations(this->Correlation),
      " (of means over 4 x 4 x 4 nodes), so they do not share a signal: results computed from them "
      "describe noise. Check that both are halves of one map.");
  }
  if (this->IsLinear())
  {
    message = JoinText("The values of the second half map are ", FormatNumber(this->Factor, 3),
      " times those of the first", this->Offset < 0.0 ? " minus " : " plus ",
      FormatNumber(std::abs(this->Offset), 3), this->Factor < 0.0 ? " (inverted contrast)" : "",
      ", with a correlation of ", Correlations(this->Correlation),
      ": this difference is removed first. Check that both are halves of one map.");
  }
  if (this->IsShifted())
  {
    message += JoinText(message.empty() ? "" : " ", "The second half map is shifted by ",
      this->Shift[0], ", ", this->Shift[1], ", ", this->Shift[2],
      " nodes along x, y, z: the correlation is ", Correlations(this->NodeCorrelation),
      " as they are and ", Correlations(this->ShiftedCorrelation),
      " without the shift, which counts as noise here. Align the halves first.");
  }
  return message;
}

}
