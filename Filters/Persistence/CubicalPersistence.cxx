#include "Persistence/CubicalPersistence.h"

#include "Core/MemoryBudget.h"
#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Persistence/CubicalComponents.h"
#include "Persistence/CubicalLoops.h"

#include <algorithm>
#include <bitset>
#include <cmath>

namespace isthmus
{
namespace
{

/// Numbers, added up place by place.
struct Histogram
{
  std::vector<std::int64_t> Counts;

  Histogram& operator+=(const Histogram& other)
  {
    for (std::size_t i = 0; i < this->Counts.size(); ++i)
    {
      this->Counts[i] += other.Counts[i];
    }
    return *this;
  }
};

/// The contribution of the stars to the Euler number, summed up to each level.
std::vector<std::int64_t> EulerNumbers(
  const VolumeView& volume, const LowerStars& stars, const CubicalParameters& parameters)
{
  const std::vector<double>& levels = parameters.Levels;
  if (levels.empty())
  {
    return {};
  }
  // At [i + 1], the cells that enter at the i-th level (sublevels: or since the one before it); the
  // last and first entries count those beyond all levels.
  const Histogram none{ std::vector<std::int64_t>(levels.size() + 1, 0) };
  const std::int64_t block = std::max<std::int64_t>(65536, volume.NodeCount() / 64);
  Histogram total = ParallelReduce(volume.NodeCount(), block, none,
    [&](Histogram& part, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first; node < last; ++node)
      {
        const int change = stars[node].EulerNumber;
        if (change != 0)
        {
          const double value = volume.Value(node);
          const auto at = parameters.Superlevel
            ? std::upper_bound(levels.begin(), levels.end(), value)
            : std::lower_bound(levels.begin(), levels.end(), value);
          part.Counts[static_cast<std::size_t>(at - levels.begin())] += change;
        }
      }
    });
  std::vector<std::int64_t>& counts = total.Counts;
  if (parameters.Superlevel)
  {
    // counts[i]: values in [levels[i - 1], levels[i]): on from level i - 1 downwards.
    for (std::size_t i = levels.size(); i-- > 1;)
    {
      counts[i] += counts[i + 1];
    }
    counts.erase(counts.begin());
    return counts;
  }
  for (std::size_t i = 1; i < levels.size(); ++i)
  {
    counts[i] += counts[i - 1];
  }
  counts.pop_back();
  return counts;
}

template <typename Gradient>
void PairLoops(const Gradient& gradient, const std::vector<typename Gradient::Key>& edges,
  const std::vector<char>& negative, const std::vector<typename Gradient::Key>& faces,
  std::vector<CubicalPair>& pairs, const ProgressCallback& progress)
{
  LoopReduction<Gradient> reduction(gradient, edges, negative);
  reduction.FillAll(
    faces,
    [&](std::int64_t i, const typename Gradient::Key& edge)
    {
      const auto& face = faces[static_cast<std::size_t>(i)];
      if (!edge.SameValue(face))
      {
        pairs.push_back({ gradient.MakeCell(edge.Node(), Gradient::GetEdge(edge)),
          gradient.MakeCell(face.Node(), Gradient::GetFace(face)), 1, CubicalCell() });
      }
    },
    progress);
}

template <typename Gradient>
std::vector<CubicalPair> PairAll(const Gradient& gradient, const ProgressCallback& progress)
{
  CubicalCritical<Gradient> critical(gradient);
  Report(progress, 0.3);
  std::vector<CubicalPair> pairs;
  pairs.swap(critical.Components);
  PairLoops(gradient, critical.Edges, critical.Negative, critical.Faces, pairs,
    Between(progress, 0.3, 1.0));
  pairs.insert(pairs.end(), critical.Voids.begin(), critical.Voids.end());
  return pairs;
}

}

CubicalDiagram CubicalPersistence(
  const VolumeView& volume, const CubicalParameters& parameters, const ProgressCallback& progress)
{
  if (volume.NodeCount() == 0)
  {
    return { {}, std::vector<std::int64_t>(parameters.Levels.size(), 0) };
  }
  RejectNaN(volume);
  Report(progress, 0.0);
  CubicalDiagram diagram;
  WithGradient(volume, parameters.Superlevel, Between(progress, 0.0, 0.4),
    [&](const auto& gradient)
    {
      diagram.EulerNumbers = EulerNumbers(volume, gradient.Lower(), parameters);
      diagram.Pairs = PairAll(gradient, Between(progress, 0.4, 1.0));
    });
  return diagram;
}

namespace
{

/// A block of nodes with those around it, which decide on the critical cells of the inner ones.
using SampledBlock = std::array<std::int64_t, 6>;

/// Blocks of 16^3 nodes, spread over the volume; all of it if it is small.
std::vector<SampledBlock> SampleBlocks(const std::array<std::int64_t, 3>& dimensions)
{
  constexpr std::int64_t side = 16, most = 512;
  std::array<std::int64_t, 3> tiles{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    tiles[axis] = (dimensions[axis] + side - 1) / side;
  }
  const std::int64_t total = tiles[0] * tiles[1] * tiles[2], count = std::min(total, most);
  std::vector<SampledBlock> blocks;
  for (std::int64_t n = 0; n < count; ++n)
  {
    // Multiples of the golden ratio: even steps could stay on one face of the volume.
    constexpr double goldenRatio = 0.61803398874989485;
    const double place = std::fmod(static_cast<double>(n) * goldenRatio, 1.0);
    const std::int64_t tile =
      count == total ? n : static_cast<std::int64_t>(place * static_cast<double>(total));
    const std::array<std::int64_t, 3> at{ tile % tiles[0], tile / tiles[0] % tiles[1],
      tile / (tiles[0] * tiles[1]) };
    SampledBlock block{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      block[2 * axis] = at[axis] * side;
      block[2 * axis + 1] = std::min(dimensions[axis], (at[axis] + 1) * side);
    }
    blocks.push_back(block);
  }
  return blocks;
}

/// Numbers of critical cells and of nodes.
struct CriticalCount
{
  double Cells = 0.0, Nodes = 0.0;

  CriticalCount& operator+=(const CriticalCount& other)
  {
    this->Cells += other.Cells;
    this->Nodes += other.Nodes;
    return *this;
  }
};

CriticalCount CountCritical(const VolumeView& volume, bool superlevel, const SampledBlock& block)
{
  std::array<std::int64_t, 3> first{}, size{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    first[axis] = std::max<std::int64_t>(0, block[2 * axis] - 1);
    size[axis] = std::min(volume.Dimensions[axis], block[2 * axis + 1] + 1) - first[axis];
  }
  CriticalCount count;
  WithTypedValues(volume,
    [&](const auto* typed)
    {
      std::vector<std::decay_t<decltype(*typed)>> values;
      for (std::int64_t k = first[2]; k < first[2] + size[2]; ++k)
      {
        for (std::int64_t j = first[1]; j < first[1] + size[1]; ++j)
        {
          const auto* row =
            typed + first[0] + volume.Dimensions[0] * (j + volume.Dimensions[1] * k);
          values.insert(values.end(), row, row + size[0]);
        }
      }
      WithGradient(VolumeView(values.data(), size), superlevel, {},
        [&](const auto& gradient)
        {
          for (std::int64_t node = 0; node < size[0] * size[1] * size[2]; ++node)
          {
            const std::array<std::int64_t, 3> at{ first[0] + node % size[0],
              first[1] + node / size[0] % size[1], first[2] + node / (size[0] * size[1]) };
            bool inner = true;
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
              inner = inner && at[axis] >= block[2 * axis] && at[axis] < block[2 * axis + 1];
            }
            if (inner)
            {
              count.Cells +=
                static_cast<double>(std::bitset<32>(gradient.Lower()[node].Critical).count());
              count.Nodes += 1.0;
            }
          }
        });
    });
  return count;
}

/// Measured; the test BytesAreWithinAFactorOfTwo measures them again.
constexpr double bytesOfNode = 5.0, bytesOfCritical = 100.0;

}

double CubicalBytes(const VolumeView& volume, bool superlevel)
{
  const std::vector<SampledBlock> blocks = SampleBlocks(volume.Dimensions);
  const CriticalCount count =
    ParallelReduce(static_cast<std::int64_t>(blocks.size()), 1, CriticalCount(),
      [&](CriticalCount& part, std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          part += CountCritical(volume, superlevel, blocks[static_cast<std::size_t>(n)]);
        }
      });
  const double density = count.Nodes > 0.0 ? count.Cells / count.Nodes : 0.0;
  return static_cast<double>(volume.NodeCount()) * (bytesOfNode + bytesOfCritical * density);
}

void RequireCubicalMemory(const VolumeView& volume, bool superlevel, double more)
{
  const MemoryBudget budget;
  const auto nodes = static_cast<double>(volume.NodeCount());
  // White noise has 0.73 critical cells for each node. What fits with 1 needs no sample.
  if (budget.Allows(nodes * (bytesOfNode + bytesOfCritical) + more))
  {
    return;
  }
  const auto& [nx, ny, nz] = volume.Dimensions;
  budget.Require(CubicalBytes(volume, superlevel) + more,
    JoinText("The persistence of ", nx, " x ", ny, " x ", nz, " values"),
    "crop the map (Extract Subset), bin it (SampleRate of its reader), or denoise it first");
}

}
