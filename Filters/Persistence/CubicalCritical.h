/**
 * @file CubicalCritical.h
 * @brief The critical edges and faces of a volume, and what union-find says about them.
 */
#ifndef isthmus_CubicalCritical_h
#define isthmus_CubicalCritical_h

#include "Core/ParallelFor.h"
#include "Persistence/CubicalComponents.h"
#include "Persistence/VolumeView.h"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

namespace isthmus
{

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
            edgesOf[part].push_back(gradient.EdgeKey(node, StarCell(cell)));
          }
          else if ((critical >> cell & 1U) != 0)
          {
            facesOf[part].push_back(gradient.FaceKey(node, StarCell(cell)));
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

/// Critical edges and those critical faces that close no void, sorted, and the pairs of dimension 0
/// and 2.
template <typename Gradient>
struct CubicalCritical
{
  std::vector<typename Gradient::Key> Edges;
  std::vector<char> Negative; ///< 1: the edge joins two components
  std::vector<typename Gradient::Key> Faces;
  std::vector<CubicalPair> Components;
  std::vector<CubicalPair> Voids;

  explicit CubicalCritical(const Gradient& gradient)
  {
    CollectCritical(gradient, this->Edges, this->Faces);
    AtOnce([this]() { std::sort(this->Edges.begin(), this->Edges.end()); },
      [this]() { std::sort(this->Faces.begin(), this->Faces.end()); });
    const auto minima = MinimaOf(gradient, this->Edges);
    const auto maxima = MaximaOf(gradient, this->Faces);
    AtOnce([&]()
      { PairComponents(gradient, this->Edges, minima, this->Negative, this->Components); },
      [&]() { PairVoids(gradient, this->Faces, maxima, this->Voids); });
  }

private:
  /// Both, which do not know of each other.
  template <typename First, typename Second>
  static void AtOnce(First&& first, Second&& second)
  {
    ParallelFor(0, 2, 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t task = begin; task < end; ++task)
        {
          task == 0 ? first() : second();
        }
      });
  }
};

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

/// Calls `work` with the gradient of the volume, of a type that has room for its values and nodes.
template <typename Work>
void WithGradient(
  const VolumeView& volume, bool superlevel, const ProgressCallback& progress, Work&& work)
{
  WithTypedValues(volume,
    [&](const auto* typed)
    {
      using Stored = typename StoredAs<std::decay_t<decltype(*typed)>>::Type;
      const OrderedValues<Stored> values(
        static_cast<const Stored*>(volume.Data), volume.Signed, superlevel);
      const LowerStars stars(values, volume.Dimensions, progress);
      if constexpr (sizeof(Stored) <= 4)
      {
        if (volume.NodeCount() <= NarrowKey::MostNodes)
        {
          work(CubicalGradient<Stored, NarrowKey>(values, stars));
          return;
        }
      }
      work(CubicalGradient<Stored, WideKey>(values, stars));
    });
}

}

#endif
