/**
 * @file CubicalComponents.h
 * @brief Pairs of dimension 0 and 2 of a volume: what union-find can do.
 */
#ifndef isthmus_CubicalComponents_h
#define isthmus_CubicalComponents_h

#include "Core/DisjointSets.h"
#include "Persistence/CubicalGradient.h"
#include "Persistence/PathEnds.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace isthmus
{

/// Sets of numbered places, each known by its eldest.
class ElderSets
{
public:
  explicit ElderSets(std::size_t count)
    : Sets(static_cast<std::uint32_t>(count))
    , Eldest(count)
  {
    std::iota(this->Eldest.begin(), this->Eldest.end(), std::uint32_t{ 0 });
  }

  std::size_t EldestOf(std::size_t place)
  {
    return this->Eldest[this->Sets.Find(static_cast<std::uint32_t>(place))];
  }

  /// Joins the set of `younger` to that of `elder`, both eldest of theirs.
  void Join(std::size_t younger, std::size_t elder)
  {
    const auto eldest = static_cast<std::uint32_t>(elder);
    this->Eldest[this->Sets.Join(static_cast<std::uint32_t>(younger), eldest)] = eldest;
  }

private:
  DisjointSets<std::uint32_t> Sets;
  std::vector<std::uint32_t> Eldest; ///< by root
};

/// The minima that the gradient leads to from both nodes of each edge, and at the end from node 0.
template <typename Gradient>
PathEnds<typename Gradient::Key::Link> MinimaOf(
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
                                : gradient.EndsOf(edges[edge]);
  };
  return { static_cast<std::int64_t>(edges.size()) + 1, starts, stars.NodeCount(), descend };
}

/// The cubes, or the outside, that the gradient comes from on both sides of each face.
template <typename Gradient>
PathEnds<typename Gradient::Key::Link> MaximaOf(
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
    const auto sides = gradient.CofacesOf(node, face);
    return sides[0] == cube ? sides[1] : sides[0];
  };
  const auto starts = [&](std::int64_t i)
  {
    const auto& face = faces[static_cast<std::size_t>(i)];
    return gradient.CofacesOf(face.Node(), Gradient::FaceOf(face));
  };
  return { static_cast<std::int64_t>(faces.size()), starts, outside + 1, ascend };
}

/**
 * Components: joins what each critical edge joins, in ascending order; the younger minimum ends.
 *
 * `edges` are the critical edges, sorted; `minima` are theirs. negative[i] becomes 1 for those that
 * join two components. Pairs of equal value are left out. Near linear.
 */
template <typename Gradient>
void PairComponents(const Gradient& gradient, const std::vector<typename Gradient::Key>& edges,
  const PathEnds<typename Gradient::Key::Link>& minima, std::vector<char>& negative,
  std::vector<CubicalPair>& pairs)
{
  ElderSets components(minima.Places.size());
  const auto nodeOf = [&](std::size_t minimum)
  { return static_cast<std::int64_t>(minima.Places[minimum]); };
  negative.assign(edges.size(), 0);
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    std::size_t elder = components.EldestOf(minima.Numbers[i][0]);
    std::size_t younger = components.EldestOf(minima.Numbers[i][1]);
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
      pairs.push_back({ gradient.NamedNode(nodeOf(younger)),
        gradient.Named(edges[i].Node(), Gradient::EdgeOf(edges[i])), 0,
        gradient.NamedNode(nodeOf(elder)) });
    }
  }
  const std::int64_t first = nodeOf(components.EldestOf(minima.Numbers.back()[0]));
  pairs.push_back({ gradient.NamedNode(first), CubicalCell(), 0, CubicalCell() });
}

/**
 * Voids: the components of what is left, in descending order; beyond the grid is one that has
 * always been there. `faces` are the critical faces, sorted, and `maxima` theirs; those that close
 * a void are taken out.
 */
template <typename Gradient>
void PairVoids(const Gradient& gradient, std::vector<typename Gradient::Key>& faces,
  const PathEnds<typename Gradient::Key::Link>& maxima, std::vector<CubicalPair>& pairs)
{
  ElderSets voids(maxima.Places.size());
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
    return gradient.Named(node, cell);
  };
  std::size_t kept = faces.size();
  for (std::size_t i = faces.size(); i-- > 0;)
  {
    std::size_t stays = voids.EldestOf(maxima.Numbers[i][0]);
    std::size_t ends = voids.EldestOf(maxima.Numbers[i][1]);
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
      pairs.push_back({ gradient.Named(faces[i].Node(), Gradient::FaceOf(faces[i])), nameOf(ends),
        2, cubeOf(stays) == outside ? CubicalCell() : nameOf(stays) });
    }
  }
  faces.erase(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(kept));
  std::reverse(pairs.begin(), pairs.end());
}

}

#endif
