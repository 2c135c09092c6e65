/**
 * @file CubicalComponents.h
 * @brief Pairs of dimension 0 and 2 of a volume, computed by union-find.
 */
#ifndef isthmus_CubicalComponents_h
#define isthmus_CubicalComponents_h

#include "Core/DisjointSets.h"
#include "Core/ParallelFor.h"
#include "Persistence/CubicalGradient.h"
#include "Persistence/GradientPaths.h"
#include "Persistence/VolumeView.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace isthmus
{

/// Disjoint sets of numbered elements, each represented by its eldest element.
class ElderRuleSets
{
public:
  explicit ElderRuleSets(std::size_t count)
    : Sets(static_cast<std::uint32_t>(count))
    , Eldest(count)
  {
    std::iota(this->Eldest.begin(), this->Eldest.end(), std::uint32_t{ 0 });
  }

  std::size_t FindEldest(std::size_t place)
  {
    return this->Eldest[this->Sets.Find(static_cast<std::uint32_t>(place))];
  }

  /// Joins the set of `younger` to that of `elder`; both must be the eldest of their sets.
  void Join(std::size_t younger, std::size_t elder)
  {
    const auto eldest = static_cast<std::uint32_t>(elder);
    this->Eldest[this->Sets.Join(static_cast<std::uint32_t>(younger), eldest)] = eldest;
  }

private:
  DisjointSets<std::uint32_t> Sets;
  std::vector<std::uint32_t> Eldest; ///< by root
};

/// The minima that the gradient leads to from both nodes of each edge; the last one is that from
/// node 0.
template <typename Gradient>
PathEnds<typename Gradient::Key::Link> FindMinima(
  const Gradient& gradient, const std::vector<typename Gradient::Key>& edges)
{
  const LowerStars& stars = gradient.Lower();
  const auto descend = [&](std::int64_t node)
  {
    const int edge = stars[node].Partner[Star::Node];
    return edge == Star::Node ? node : node + stars.Offset(StarCell(edge));
  };
  const auto starts = [&](std::int64_t i)
  {
    const auto edge = static_cast<std::size_t>(i);
    return edge == edges.size() ? std::array<std::int64_t, 2>{ 0, 0 }
                                : gradient.GetEnds(edges[edge]);
  };
  return { static_cast<std::int64_t>(edges.size()) + 1, starts, stars.NodeCount(), descend };
}

/// The cubes, or the outside, that the gradient comes from on both sides of each face.
template <typename Gradient>
PathEnds<typename Gradient::Key::Link> FindMaxima(
  const Gradient& gradient, const std::vector<typename Gradient::Key>& faces)
{
  const LowerStars& stars = gradient.Lower();
  const std::int64_t outside = gradient.NodeOutside();
  const auto ascend = [&](std::int64_t cube)
  {
    if (cube == outside)
    {
      return cube;
    }
    const auto [node, cell] = gradient.StarCube(cube);
    const StarCell face(stars[node].Partner[cell.Index()]);
    if (face == cell)
    {
      return cube;
    }
    const auto sides = gradient.GetCofaces(node, face);
    return sides[0] == cube ? sides[1] : sides[0];
  };
  const auto starts = [&](std::int64_t i)
  {
    const auto& face = faces[static_cast<std::size_t>(i)];
    return gradient.GetCofaces(face.Node(), Gradient::GetFace(face));
  };
  return { static_cast<std::int64_t>(faces.size()), starts, outside + 1, ascend };
}

/**
 * Components: joins the sets on both sides of each critical edge in ascending order; the component
 * of the younger minimum ends.
 *
 * `edges` are the critical edges, sorted; `minima` are theirs. negative[i] becomes 1 for those that
 * join two components. Pairs with equal values are omitted. Near linear.
 */
template <typename Gradient>
void PairComponents(const Gradient& gradient, const std::vector<typename Gradient::Key>& edges,
  const PathEnds<typename Gradient::Key::Link>& minima, std::vector<char>& negative,
  std::vector<CubicalPair>& pairs)
{
  ElderRuleSets components(minima.Places.size());
  const auto nodeOf = [&](std::size_t minimum)
  { return static_cast<std::int64_t>(minima.Places[minimum]); };
  negative.assign(edges.size(), 0);
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    std::size_t elder = components.FindEldest(minima.Numbers[i][0]);
    std::size_t younger = components.FindEldest(minima.Numbers[i][1]);
    if (elder == younger)
    {
      continue;
    }
    if (gradient.IsLater(nodeOf(elder), nodeOf(younger)))
    {
      std::swap(elder, younger);
    }
    components.Join(younger, elder);
    negative[i] = 1;
    if (!gradient.EdgeKey(nodeOf(younger), StarCell(0)).SameValue(edges[i]))
    {
      pairs.push_back({ gradient.MakeNodeCell(nodeOf(younger)),
        gradient.MakeCell(edges[i].Node(), Gradient::GetEdge(edges[i])), 0,
        gradient.MakeNodeCell(nodeOf(elder)) });
    }
  }
  const std::int64_t first = nodeOf(components.FindEldest(minima.Numbers.back()[0]));
  pairs.push_back({ gradient.MakeNodeCell(first), CubicalCell(), 0, CubicalCell() });
}

/**
 * Voids: the components of the complement, in descending order; the exterior of the grid is one
 * that has always existed. `faces` are the critical faces, sorted, and `maxima` their maxima; the
 * faces that close a void are removed.
 */
template <typename Gradient>
void PairVoids(const Gradient& gradient, std::vector<typename Gradient::Key>& faces,
  const PathEnds<typename Gradient::Key::Link>& maxima, std::vector<CubicalPair>& pairs)
{
  ElderRuleSets voids(maxima.Places.size());
  const std::int64_t outside = gradient.NodeOutside();
  const auto cubeOf = [&](std::size_t maximum)
  { return static_cast<std::int64_t>(maxima.Places[maximum]); };
  const auto keyOf = [&](std::size_t maximum)
  {
    const auto [node, cell] = gradient.StarCube(cubeOf(maximum));
    return gradient.CubeKey(node, cell);
  };
  const auto nameOf = [&](std::size_t maximum)
  {
    const auto [node, cell] = gradient.StarCube(cubeOf(maximum));
    return gradient.MakeCell(node, cell);
  };
  std::size_t kept = faces.size();
  for (std::size_t i = faces.size(); i-- > 0;)
  {
    std::size_t stays = voids.FindEldest(maxima.Numbers[i][0]);
    std::size_t ends = voids.FindEldest(maxima.Numbers[i][1]);
    if (stays == ends)
    {
      faces[--kept] = faces[i];
      continue;
    }
    if (cubeOf(ends) == outside || (cubeOf(stays) != outside && keyOf(stays) < keyOf(ends)))
    {
      std::swap(stays, ends);
    }
    voids.Join(ends, stays);
    if (!keyOf(ends).SameValue(faces[i]))
    {
      pairs.push_back({ gradient.MakeCell(faces[i].Node(), Gradient::GetFace(faces[i])),
        nameOf(ends), 2, cubeOf(stays) == outside ? CubicalCell() : nameOf(stays) });
    }
  }
  faces.erase(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(kept));
  std::reverse(pairs.begin(), pairs.end());
}

//--------------------------------------------------------------------------------------------------
// The critical edges and faces of a volume, and their classes by union-find.

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

/// The critical edges and those critical faces that do not close a void, sorted, and the pairs of
/// dimension 0 and 2.
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
    RunConcurrently([this]() { std::sort(this->Edges.begin(), this->Edges.end()); },
      [this]() { std::sort(this->Faces.begin(), this->Faces.end()); });
    const auto minima = FindMinima(gradient, this->Edges);
    const auto maxima = FindMaxima(gradient, this->Faces);
    RunConcurrently([&]()
      { PairComponents(gradient, this->Edges, minima, this->Negative, this->Components); },
      [&]() { PairVoids(gradient, this->Faces, maxima, this->Voids); });
  }

private:
  /// Computes components and voids, which are independent of each other.
  template <typename First, typename Second>
  static void RunConcurrently(First&& first, Second&& second)
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

/// Calls `work` with the gradient of the volume, in a type that is large enough for its values and
/// nodes.
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
