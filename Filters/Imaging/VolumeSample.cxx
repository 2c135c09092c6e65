#include "Imaging/VolumeSample.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace isthmus
{
namespace
{

constexpr std::int64_t wholeVolumeNodes =
  300000;                               ///< up to this many nodes, the whole volume is used
constexpr std::int64_t trialSide = 28;  ///< nodes across the inner part of a block
constexpr std::int64_t trialMargin = 6; ///< nodes around it
constexpr std::size_t trialBlocks = 6;
constexpr std::size_t mostNoiseBlocks = 512;  ///< the largest number evaluated
constexpr std::int64_t coarseNodes = 1 << 17; ///< of the coarse copy, about

std::int64_t Product(const Index3& n)
{
  return n[0] * n[1] * n[2];
}

/// The nodes of a box every `stride` nodes, in order, on every rank: each owner contributes its
/// own, the others nothing, so that the sum is exact.
template <typename T>
class Gatherer
{
public:
  Gatherer(const DiffusionGrid<T>& grid, const T* values)
    : Grid(grid)
    , Values(values)
    , Begin(grid.OwnedBegin)
    , End(grid.OwnedEnd)
  {
    if (this->End == Index3{ 0, 0, 0 } && !grid.SumOverRanks)
    {
      this->End = grid.Dimensions;
    }
  }

  std::vector<double> Box(const SampleBox& box, const Index3& stride = { 1, 1, 1 }) const
  {
    Index3 count;
    for (std::size_t a = 0; a < 3; ++a)
    {
      count[a] = (box.End[a] - box.Begin[a] + stride[a] - 1) / stride[a];
    }
    std::vector<double> gathered(static_cast<std::size_t>(Product(count)), 0.0);
    for (std::int64_t k = 0; k < count[2]; ++k)
    {
      for (std::int64_t j = 0; j < count[1]; ++j)
      {
        for (std::int64_t i = 0; i < count[0]; ++i)
        {
          const Index3 node{ box.Begin[0] + i * stride[0] - this->Grid.GlobalBegin[0],
            box.Begin[1] + j * stride[1] - this->Grid.GlobalBegin[1],
            box.Begin[2] + k * stride[2] - this->Grid.GlobalBegin[2] };
          if (this->Owns(node))
          {
            gathered[static_cast<std::size_t>(i + count[0] * (j + count[1] * k))] =
              static_cast<double>(this->Values[node[0] +
                this->Grid.Dimensions[0] * (node[1] + this->Grid.Dimensions[1] * node[2])]);
          }
        }
      }
    }
    if (this->Grid.SumOverRanks)
    {
      this->Grid.SumOverRanks(gathered.data(), static_cast<int>(gathered.size()));
    }
    return gathered;
  }

private:
  bool Owns(const Index3& node) const
  {
    bool owns = true;
    for (std::size_t a = 0; a < 3; ++a)
    {
      owns = owns && node[a] >= this->Begin[a] && node[a] < this->End[a];
    }
    return owns;
  }

  const DiffusionGrid<T>& Grid;
  const T* Values;
  Index3 Begin, End;
};

/// The whole cut into boxes of nearly equal size, about `side` nodes along each axis.
std::vector<SampleBox> Tiles(const Index3& whole, const Index3& side)
{
  Index3 parts;
  for (std::size_t a = 0; a < 3; ++a)
  {
    parts[a] = std::max<std::int64_t>(1, whole[a] / side[a]);
  }
  std::vector<SampleBox> tiles;
  for (std::int64_t n = 0; n < Product(parts); ++n)
  {
    const Index3 at{ n % parts[0], n / parts[0] % parts[1], n / (parts[0] * parts[1]) };
    SampleBox box;
    for (std::size_t a = 0; a < 3; ++a)
    {
      box.Begin[a] = whole[a] * at[a] / parts[a];
      box.End[a] = whole[a] * (at[a] + 1) / parts[a];
    }
    tiles.push_back(box);
  }
  return tiles;
}

/// Sides of a block of about `nodes` nodes where an axis may be short.
Index3 BlockSides(const Index3& whole, std::int64_t side)
{
  Index3 sides;
  double wanted = std::pow(static_cast<double>(side), 3);
  // Short axes first; the others become longer in compensation.
  std::array<std::size_t, 3> order{ 0, 1, 2 };
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return whole[a] < whole[b]; });
  for (std::size_t n = 0; n < 3; ++n)
  {
    const double share = std::pow(wanted, 1.0 / static_cast<double>(3 - n));
    const std::size_t axis = order[n];
    sides[axis] = std::clamp<std::int64_t>(std::llround(share), 1, whole[axis]);
    wanted /= static_cast<double>(sides[axis]);
  }
  return sides;
}

/// The coarse copy: every stride-th node.
struct Coarse
{
  Index3 Stride{ 1, 1, 1 }, Size{ 0, 0, 0 };
  std::vector<double> Values;
};

template <typename T>
Coarse CoarseCopy(const Gatherer<T>& gatherer, const Index3& whole)
{
  Coarse coarse;
  const double ratio = static_cast<double>(Product(whole)) / static_cast<double>(coarseNodes);
  const std::int64_t stride = std::max<std::int64_t>(1, std::llround(std::ceil(std::cbrt(ratio))));
  for (std::size_t a = 0; a < 3; ++a)
  {
    coarse.Stride[a] = std::min(stride, whole[a]);
    coarse.Size[a] = (whole[a] + coarse.Stride[a] - 1) / coarse.Stride[a];
  }
  coarse.Values = gatherer.Box({ { 0, 0, 0 }, whole }, coarse.Stride);
  return coarse;
}

std::pair<double, double> MeanAndDeviation(const std::vector<double>& values)
{
  const double count = std::max<double>(1.0, static_cast<double>(values.size()));
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  const double squares = std::accumulate(values.begin(), values.end(), 0.0,
    [mean](double sum, double value) { return sum + (value - mean) * (value - mean); });
  return { mean, std::sqrt(squares / count) };
}

/// Standard deviation of the coarse nodes in a box, 0 without two.
double CoarseDeviation(const Coarse& coarse, const SampleBox& box)
{
  std::vector<double> inside;
  auto first = [&](std::size_t a)
  { return (box.Begin[a] + coarse.Stride[a] - 1) / coarse.Stride[a] * coarse.Stride[a]; };
  for (std::int64_t k = first(2); k < box.End[2]; k += coarse.Stride[2])
  {
    for (std::int64_t j = first(1); j < box.End[1]; j += coarse.Stride[1])
    {
      for (std::int64_t i = first(0); i < box.End[0]; i += coarse.Stride[0])
      {
        const std::int64_t n = i / coarse.Stride[0] +
          coarse.Size[0] * (j / coarse.Stride[1] + coarse.Size[1] * (k / coarse.Stride[2]));
        inside.push_back(coarse.Values[static_cast<std::size_t>(n)]);
      }
    }
  }
  return MeanAndDeviation(inside).second;
}

/// The largest modulus among the nodes that this rank owns.
template <typename T>
double LargestModulus(const DiffusionGrid<T>& grid, const T* values)
{
  auto begin = grid.OwnedBegin, end = grid.OwnedEnd;
  if (end == std::array<std::int64_t, 3>{ 0, 0, 0 } && !grid.SumOverRanks)
  {
    end = grid.Dimensions;
  }
  std::vector<double> ofPlanes(static_cast<std::size_t>(grid.Dimensions[2]), 0.0);
  ParallelFor(begin[2], end[2], 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
      {
        double largest = 0.0;
        for (std::int64_t j = begin[1]; j < end[1]; ++j)
        {
          const std::int64_t row = grid.Dimensions[0] * (j + grid.Dimensions[1] * k);
          for (std::int64_t n = row + begin[0]; n < row + end[0]; ++n)
          {
            largest = std::max(largest, std::abs(static_cast<double>(values[n])));
          }
        }
        ofPlanes[static_cast<std::size_t>(k)] = largest;
      }
    });
  return ofPlanes.empty() ? 0.0 : *std::max_element(ofPlanes.begin(), ofPlanes.end());
}

/// The most frequent value among nodes whose neighbours in a block all have the same value.
void FindFill(
  const std::vector<std::vector<double>>& blocks, const Index3& size, VolumeSample& sample)
{
  std::map<double, std::int64_t> counts;
  std::int64_t nodes = 0;
  const Index3 step{ 1, size[0], size[0] * size[1] };
  for (const std::vector<double>& block : blocks)
  {
    nodes += static_cast<std::int64_t>(block.size());
    for (std::int64_t n = 0; n < static_cast<std::int64_t>(block.size()); ++n)
    {
      const Index3 at{ n % size[0], n / size[0] % size[1], n / step[2] };
      const double value = block[static_cast<std::size_t>(n)];
      bool all = true;
      for (std::size_t a = 0; all && a < 3; ++a)
      {
        all = (at[a] == 0 || block[static_cast<std::size_t>(n - step[a])] == value) &&
          (at[a] + 1 == size[a] || block[static_cast<std::size_t>(n + step[a])] == value);
      }
      if (all && (counts.size() < 64 || counts.count(value) > 0))
      {
        ++counts[value];
      }
    }
  }
  const auto most = std::max_element(
    counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most != counts.end() && 100 * most->second > nodes)
  {
    sample.HasFill = true;
    sample.Fill = most->first;
  }
}

/// Whether more than one node in fifty shares its value with three neighbours in the block.
bool HasFlatNodes(const std::vector<double>& block, const Index3& size)
{
  std::int64_t flat = 0;
  const Index3 step{ 1, size[0], size[0] * size[1] };
  for (std::int64_t n = 0; n < static_cast<std::int64_t>(block.size()); ++n)
  {
    const Index3 at{ n % size[0], n / size[0] % size[1], n / step[2] };
    const double value = block[static_cast<std::size_t>(n)];
    int equal = 0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      equal += at[a] > 0 && block[static_cast<std::size_t>(n - step[a])] == value;
      equal += at[a] + 1 < size[a] && block[static_cast<std::size_t>(n + step[a])] == value;
    }
    flat += equal >= 3;
  }
  return 50 * flat > static_cast<std::int64_t>(block.size());
}

/// `count` of `total` tiles in rows: one of each stratum, at the fractional parts of multiples of
/// the golden ratio, since even steps through rows of 2^n tiles stay on one face of the volume.
std::vector<std::size_t> SpreadOver(std::size_t total, std::size_t count)
{
  constexpr double goldenRatio = 0.61803398874989485;
  std::vector<std::size_t> chosen(count);
  for (std::size_t n = 0; n < count; ++n)
  {
    const std::size_t first = n * total / count, last = (n + 1) * total / count;
    const double within = std::fmod(static_cast<double>(n) * goldenRatio, 1.0);
    chosen[n] = first + static_cast<std::size_t>(within * static_cast<double>(last - first));
  }
  return chosen;
}

/// Blocks of `side` nodes across that hold no flat background, at most mostNoiseBlocks of them.
template <typename T>
NoiseBlocks GatherNoiseBlocks(const Gatherer<T>& gatherer, std::int64_t side, VolumeSample& sample)
{
  NoiseBlocks result;
  Index3& size = result.Size;
  for (std::size_t a = 0; a < 3; ++a)
  {
    size[a] = std::min(side, sample.Whole[a]);
  }
  std::vector<SampleBox> boxes = Tiles(sample.Whole, size);
  std::vector<std::vector<double>> blocks;
  for (const std::size_t n : SpreadOver(boxes.size(), std::min(boxes.size(), mostNoiseBlocks)))
  {
    SampleBox box = boxes[n];
    for (std::size_t a = 0; a < 3; ++a)
    {
      box.End[a] = box.Begin[a] + size[a];
    }
    blocks.push_back(gatherer.Box(box));
  }
  FindFill(blocks, size, sample);
  for (const std::vector<double>& block : blocks)
  {
    if (!HasFlatNodes(block, size))
    {
      std::vector<float> scaled(block.size());
      std::transform(block.begin(), block.end(), scaled.begin(),
        [&](double value) { return static_cast<float>((value - sample.Offset) / sample.Scale); });
      result.Values.push_back(std::move(scaled));
    }
  }
  return result;
}

/// Boxes for trials with their weights, from the deviation of the coarse copy in each.
std::vector<TrialBlock> ChooseTrials(const Coarse& coarse, const Index3& whole)
{
  std::vector<TrialBlock> trials;
  if (Product(whole) <= wholeVolumeNodes)
  {
    TrialBlock all;
    all.Box = all.Inner = { { 0, 0, 0 }, whole };
    trials.push_back(all);
    return trials;
  }
  const std::vector<SampleBox> tiles = Tiles(whole, BlockSides(whole, trialSide));
  std::vector<double> sizes;
  std::transform(tiles.begin(), tiles.end(), std::back_inserter(sizes),
    [&](const SampleBox& tile) { return CoarseDeviation(coarse, tile); });
  const double mean =
    std::accumulate(sizes.begin(), sizes.end(), 0.0) / static_cast<double>(sizes.size());
  std::vector<std::size_t> order(tiles.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] < sizes[b]; });
  // Tiles without structure count as well, since noise is everywhere.
  auto measure = [&](std::size_t tile) { return sizes[tile] + 0.3 * mean + 1e-30; };
  double total = 0.0;
  for (const std::size_t tile : order)
  {
    total += measure(tile);
  }
  double passed = 0.0;
  std::size_t next = 0;
  for (const std::size_t tile : order)
  {
    passed += measure(tile);
    double weight = 0.0;
    while (next < trialBlocks &&
      (static_cast<double>(next) + 0.5) / static_cast<double>(trialBlocks) * total < passed)
    {
      weight += total / measure(tile);
      ++next;
    }
    if (weight > 0.0)
    {
      TrialBlock block;
      block.Inner = block.Box = tiles[tile];
      for (std::size_t a = 0; a < 3; ++a)
      {
        block.Box.Begin[a] = std::max<std::int64_t>(0, block.Inner.Begin[a] - trialMargin);
        block.Box.End[a] = std::min(whole[a], block.Inner.End[a] + trialMargin);
      }
      block.Weight = weight;
      trials.push_back(block);
    }
  }
  return trials;
}

}

template <typename T>
bool IsFillNode(const T* values, const Index3& size, const Index3& node, T fill)
{
  const std::int64_t at = node[0] + size[0] * (node[1] + size[1] * node[2]);
  if (values[at] != fill)
  {
    return false;
  }
  const Index3 step{ 1, size[0], size[0] * size[1] };
  int equal = 0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    equal += values[node[a] > 0 ? at - step[a] : at] == fill;
    equal += values[node[a] + 1 < size[a] ? at + step[a] : at] == fill;
  }
  return equal >= 3;
}

template <typename T>
VolumeSample SampleVolume(const DiffusionGrid<T>& grid, const T* values, const T* noise)
{
  VolumeSample sample;
  sample.Whole = grid.Whole();
  const Gatherer<T> gatherer(grid, values);
  const Coarse coarse = CoarseCopy(gatherer, sample.Whole);
  const auto [mean, deviation] = MeanAndDeviation(coarse.Values);
  sample.Offset = mean;
  sample.Scale = deviation > 0.0 ? deviation : 1.0;
  sample.Small = GatherNoiseBlocks(gatherer, 8, sample);
  sample.Large = GatherNoiseBlocks(gatherer, 16, sample);
  sample.Trials = ChooseTrials(coarse, sample.Whole);
  double sum = 0.0;
  for (const TrialBlock& trial : sample.Trials)
  {
    sum += trial.Weight * static_cast<double>(trial.Inner.Count());
  }
  for (TrialBlock& trial : sample.Trials)
  {
    trial.Weight /= sum;
    const std::vector<double> gathered = gatherer.Box(trial.Box);
    trial.IsFill.assign(gathered.size(), 0);
    const Index3 size = trial.Box.Size();
    for (std::int64_t n = 0; sample.HasFill && n < trial.Box.Count(); ++n)
    {
      const Index3 at{ n % size[0], n / size[0] % size[1], n / (size[0] * size[1]) };
      trial.IsFill[static_cast<std::size_t>(n)] =
        IsFillNode(gathered.data(), size, at, sample.Fill);
    }
    trial.Values.resize(gathered.size());
    std::transform(gathered.begin(), gathered.end(), trial.Values.begin(),
      [&](double value) { return static_cast<float>((value - sample.Offset) / sample.Scale); });
    if (noise)
    {
      const std::vector<double> like = Gatherer<T>(grid, noise).Box(trial.Box);
      trial.Noise.resize(like.size());
      std::transform(like.begin(), like.end(), trial.Noise.begin(),
        [&](double value) { return static_cast<float>(value / sample.Scale); });
    }
  }
  return sample;
}

namespace
{

/// Mean of values to this power, 1 or 2.
template <int Power, typename T>
double ExactMeanOfPower(const DiffusionGrid<T>& grid, const T* values)
{
  // The largest exponent over all ranks: each marks its own, and marks are added.
  constexpr int lowest = -1100, exponents = 2300;
  std::vector<double> marks(exponents, 0.0);
  const double largest = LargestModulus(grid, values);
  int exponent = lowest;
  if (largest > 0.0)
  {
    std::frexp(largest, &exponent);
  }
  marks[static_cast<std::size_t>(std::clamp(exponent - lowest, 0, exponents - 1))] = 1.0;
  if (grid.SumOverRanks)
  {
    grid.SumOverRanks(marks.data(), exponents);
  }
  const auto last = std::find_if(marks.rbegin(), marks.rend(), [](double n) { return n > 0.0; });
  exponent = lowest + static_cast<int>(marks.rend() - last) - 1;
  const auto nodes = static_cast<double>(Product(grid.Whole()));
  if (exponent == lowest || nodes == 0.0)
  {
    return 0.0;
  }
  // Powers are at most 1 after scaling; as whole numbers of this unit their sum is below 2^53.
  const int bits = 52 - static_cast<int>(std::ceil(std::log2(nodes + 1.0)));
  const double scale = std::ldexp(1.0, -exponent), steps = std::ldexp(1.0, bits);
  const auto total = SumRows<1>(grid,
    [=](std::int64_t begin, std::int64_t end, std::array<double, 1>& sum)
    {
      for (std::int64_t n = begin; n < end; ++n)
      {
        const double value = static_cast<double>(values[n]) * scale;
        sum[0] += std::nearbyint((Power == 1 ? value : value * value) * steps);
      }
    });
  return total[0] / steps / (Power == 1 ? scale : scale * scale) / nodes;
}

}

template <typename T>
double ExactMean(const DiffusionGrid<T>& grid, const T* values)
{
  return ExactMeanOfPower<1>(grid, values);
}

template <typename T>
double ExactMeanSquare(const DiffusionGrid<T>& grid, const T* values)
{
  return ExactMeanOfPower<2>(grid, values);
}

template VolumeSample SampleVolume(const DiffusionGrid<float>&, const float*, const float*);
template VolumeSample SampleVolume(const DiffusionGrid<double>&, const double*, const double*);
template bool IsFillNode(const float*, const Index3&, const Index3&, float);
template bool IsFillNode(const double*, const Index3&, const Index3&, double);
template double ExactMean(const DiffusionGrid<float>&, const float*);
template double ExactMean(const DiffusionGrid<double>&, const double*);
template double ExactMeanSquare(const DiffusionGrid<float>&, const float*);
template double ExactMeanSquare(const DiffusionGrid<double>&, const double*);

}
