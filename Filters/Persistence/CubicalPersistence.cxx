#include "CubicalPersistence.h"

#include "CubicalComponents.h"
#include "CubicalLoops.h"
#include "ParallelFor.h"
#include "ParallelReduce.h"

#include <algorithm>
#include <iterator>
#include <type_traits>

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

/// What the stars add to the Euler number, summed up to each level.
std::vector<std::int64_t> EulerNumbers(
  const VolumeView& volume, const LowerStars& stars, const CubicalParameters& parameters)
{
  const std::vector<double>& levels = parameters.Levels;
  if (levels.empty())
  {
    return {};
  }
  // At [i + 1], what enters at the i-th level (sublevels: or since the one before it); the last
  // and first entries are what is past all levels.
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

/// Keys of the critical edges and faces, in the order of the nodes.
template <typename Gradient>
void CollectCritical(const Gradient& gradient, std::vector<typename Gradient::Key>& edges,
  std::vector<typename Gradient::Key>& faces)
{
  using Keys = std::vector<typename Gradient::Key>;
  const LowerStars& stars = gradient.Lower();
  const std::int64_t count = stars.NodeCount();
  constexpr std::int64_t block = 262144;
  std::vector<Keys> edgesOf(static_cast<std::size_t>((count + block - 1) / block));
  std::vector<Keys> facesOf(edgesOf.size());
  ParallelFor(0, static_cast<std::int64_t>(edgesOf.size()), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first * block; node < std::min(count, last * block); ++node)
      {
        const auto part = static_cast<std::size_t>(node / block);
        std::uint32_t critical = stars[node].Critical & ~(1U << Star::Node);
        for (int cell = 0; critical != 0 && cell < Star::FirstCube; ++cell)
        {
          if ((critical >> cell & 1U) != 0 && cell < Star::FirstFace)
          {
            edgesOf[part].push_back(gradient.EdgeKey(node, cell));
          }
          else if ((critical >> cell & 1U) != 0)
          {
            facesOf[part].push_back(gradient.FaceKey(node, cell));
          }
          critical &= ~(1U << cell);
        }
      }
    });
  const auto join = [](std::vector<Keys>& parts, Keys& all)
  {
    std::size_t size = 0;
    for (const Keys& part : parts)
    {
      size += part.size();
    }
    all.reserve(size);
    for (Keys& part : parts)
    {
      all.insert(all.end(), part.begin(), part.end());
      Keys().swap(part);
    }
  };
  join(edgesOf, edges);
  join(facesOf, faces);
}

template <typename Gradient>
void PairLoops(const Gradient& gradient, const std::vector<typename Gradient::Key>& edges,
  const std::vector<char>& negative, const std::vector<typename Gradient::Key>& faces,
  std::vector<CubicalPair>& pairs, const ProgressCallback& progress)
{
  LoopReduction<Gradient> reduction(gradient, edges, negative);
  std::int64_t nextReport = 0;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const auto edge = reduction.Fill(faces[i]);
    if (!edge.SameValue(faces[i]))
    {
      pairs.push_back({ gradient.Named(edge.Node(), edge.Place()),
        gradient.Named(faces[i].Node(), Gradient::FaceOf(faces[i])), 1 });
    }
    if (reduction.Steps() >= nextReport)
    {
      Report(progress, static_cast<double>(i + 1) / static_cast<double>(faces.size()));
      nextReport = reduction.Steps() + 100000;
    }
  }
}

template <typename Gradient>
std::vector<CubicalPair> PairAll(const Gradient& gradient, const ProgressCallback& progress)
{
  using Keys = std::vector<typename Gradient::Key>;
  Keys edges;
  Keys faces;
  CollectCritical(gradient, edges, faces);
  Report(progress, 0.1);
  std::vector<char> negative;
  std::vector<CubicalPair> pairs;
  std::vector<CubicalPair> voids;
  // Dimensions 0 and 2 do not know of each other.
  ParallelFor(0, 2, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t task = first; task < last; ++task)
      {
        if (task == 0)
        {
          std::sort(edges.begin(), edges.end());
          PairComponents(gradient, edges, negative, pairs);
        }
        else
        {
          std::sort(faces.begin(), faces.end());
          PairVoids(gradient, faces, voids);
        }
      }
    });
  Report(progress, 0.4);
  PairLoops(gradient, edges, negative, faces, pairs, Between(progress, 0.4, 1.0));
  pairs.insert(pairs.end(), voids.begin(), voids.end());
  return pairs;
}

template <typename Stored>
CubicalDiagram PairsOf(const VolumeView& volume, const Stored* stored,
  const CubicalParameters& parameters, const ProgressCallback& progress)
{
  const OrderedValues<Stored> values(stored, volume.Signed, parameters.Superlevel);
  const LowerStars stars(values, volume.Dimensions, Between(progress, 0.0, 0.4));
  CubicalDiagram diagram;
  diagram.EulerNumbers = EulerNumbers(volume, stars, parameters);
  const ProgressCallback rest = Between(progress, 0.4, 1.0);
  if constexpr (sizeof(Stored) <= 4)
  {
    if (volume.NodeCount() <= NarrowKey::MostNodes)
    {
      diagram.Pairs = PairAll(CubicalGradient<Stored, NarrowKey>(values, stars), rest);
      return diagram;
    }
  }
  diagram.Pairs = PairAll(CubicalGradient<Stored, WideKey>(values, stars), rest);
  return diagram;
}

/// The unsigned integer of the same size, or the floating-point type itself.
template <typename T, bool Floating = std::is_floating_point_v<T>>
struct StoredAs
{
  using Type = T;
};
template <typename T>
struct StoredAs<T, false>
{
  using Type = std::make_unsigned_t<T>;
};

}

CubicalDiagram CubicalPersistence(const VolumeView& volume, const CubicalParameters& parameters,
  const ProgressCallback& progress)
{
  if (volume.NodeCount() == 0)
  {
    return { {}, std::vector<std::int64_t>(parameters.Levels.size(), 0) };
  }
  if (volume.Floating)
  {
    MeasureVolume(volume); // refuses what is not a number
  }
  Report(progress, 0.0);
  return WithTypedValues(volume,
    [&](const auto* typed)
    {
      using Stored = typename StoredAs<std::decay_t<decltype(*typed)>>::Type;
      return PairsOf(volume, static_cast<const Stored*>(volume.Data), parameters, progress);
    });
}

}
