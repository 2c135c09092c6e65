#include "Persistence/ScalarSimplification.h"

#include "Persistence/StarMatching.h"

#include <algorithm>
#include <queue>
#include <utility>

namespace isthmus
{
namespace
{

/// Floods from seeds: every node ends at the lowest greatest value of a path to a seed, in the
/// order of `Less`, and not before its own value.
template <typename T, typename Less>
class Flood
{
public:
  Flood(T* values, const std::array<std::int64_t, 3>& dimensions, Less less)
    : Values(values)
    , Size(dimensions)
    , Before(less)
    , Reached(static_cast<std::size_t>(dimensions[0] * dimensions[1] * dimensions[2]), false)
    , Queue(Later{ less })
  {
  }

  void Seed(std::int64_t node)
  {
    if (!this->Reached[static_cast<std::size_t>(node)])
    {
      this->Reached[static_cast<std::size_t>(node)] = true;
      this->Queue.push({ this->Values[node], node });
    }
  }

  /// Through the first `cells` of the star's cells: 6 along the axes, 26 all round.
  void Run(bool allRound, const ProgressCallback& progress)
  {
    const std::int64_t count = this->Size[0] * this->Size[1] * this->Size[2];
    std::int64_t done = 0;
    while (!this->Queue.empty())
    {
      const auto [level, node] = this->Queue.top();
      this->Queue.pop();
      this->Values[node] = level;
      this->Spread(level, node, allRound ? 26U : 6U);
      if (++done % 65536 == 0)
      {
        Report(progress, static_cast<double>(done) / static_cast<double>(count));
      }
    }
  }

private:
  using Entry = std::pair<T, std::int64_t>;

  struct Later
  {
    bool operator()(const Entry& a, const Entry& b) const
    {
      return this->Before(b.first, a.first) ||
        (!this->Before(a.first, b.first) && b.second < a.second);
    }
    Less Before;
  };

  void Spread(T level, std::int64_t node, std::size_t cells)
  {
    const std::int64_t at[] = { node % this->Size[0], node / this->Size[0] % this->Size[1],
      node / (this->Size[0] * this->Size[1]) };
    for (std::size_t cell = 0; cell < cells; ++cell)
    {
      std::int64_t next = 0;
      bool inside = true;
      for (std::size_t axis = 3; axis-- > 0;)
      {
        const std::int64_t to = at[axis] + Star::Steps[cell][axis];
        inside = inside && to >= 0 && to < this->Size[axis];
        next = next * this->Size[axis] + to;
      }
      if (inside && !this->Reached[static_cast<std::size_t>(next)])
      {
        this->Reached[static_cast<std::size_t>(next)] = true;
        const T own = this->Values[next];
        this->Queue.push({ this->Before(own, level) ? level : own, next });
      }
    }
  }

  T* Values;
  std::array<std::int64_t, 3> Size;
  Less Before;
  std::vector<bool> Reached;
  std::priority_queue<Entry, std::vector<Entry>, Later> Queue;
};

template <typename T, typename Less>
void FloodMinima(T* values, const VolumeView& volume, const FeatureList& features, Less less,
  const ProgressCallback& progress)
{
  Flood<T, Less> flood(values, volume.Dimensions, less);
  for (std::size_t i = 0; i < features.Kept; ++i)
  {
    const CubicalPair& pair = features.Features[i].Pair;
    if (pair.Dimension == 0)
    {
      flood.Seed(pair.Birth.Node());
    }
  }
  flood.Run(false, progress);
}

template <typename T, typename Less>
void FloodVoids(T* values, const VolumeView& volume, const FeatureList& features, Less less,
  const ProgressCallback& progress)
{
  Flood<T, Less> flood(values, volume.Dimensions, less);
  const auto& n = volume.Dimensions;
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      const bool border = k == 0 || j == 0 || k + 1 == n[2] || j + 1 == n[1];
      for (std::int64_t i = 0; i < n[0]; i += border || n[0] == 1 ? 1 : n[0] - 1)
      {
        flood.Seed(i + n[0] * (j + n[1] * k)); // the outside
      }
    }
  }
  for (std::size_t i = 0; i < features.Kept; ++i)
  {
    const CubicalPair& pair = features.Features[i].Pair;
    if (pair.Dimension == 2)
    {
      flood.Seed(pair.Death.Node());
    }
  }
  flood.Run(true, progress);
}

}

void SimplifyScalar(const VolumeView& volume, const FeatureList& features, bool superlevel,
  void* result, const ProgressCallback& progress)
{
  WithTypedValues(volume,
    [&](const auto* typed)
    {
      using T = std::remove_const_t<std::remove_pointer_t<decltype(typed)>>;
      auto* values = static_cast<T*>(result);
      std::copy(typed, typed + volume.NodeCount(), values);
      const auto less = [superlevel](T a, T b) { return superlevel ? b < a : a < b; };
      const auto greater = [less](T a, T b) { return less(b, a); };
      FloodMinima(values, volume, features, less, Between(progress, 0.0, 0.5));
      FloodVoids(values, volume, features, greater, Between(progress, 0.5, 1.0));
    });
}

}
