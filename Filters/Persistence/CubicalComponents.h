/**
 * @file CubicalComponents.h
 * @brief Pairs of dimension 0 and 2 of a volume: what union-find can do.
 */
#ifndef isthmus_CubicalComponents_h
#define isthmus_CubicalComponents_h

#include "CubicalGradient.h"
#include "LinkForest.h"

#include <algorithm>
#include <vector>

namespace isthmus
{

/**
 * Components: joins what each critical edge joins, in ascending order; the younger minimum ends.
 *
 * `edges` are the critical edges, sorted. negative[i] becomes 1 for those that join two components.
 * Pairs of equal value are left out. O(n log n) at worst; only nodes on descending paths from
 * critical edges are visited.
 */
template <typename Gradient>
void PairComponents(const Gradient& gradient, const std::vector<typename Gradient::Key>& edges,
  std::vector<char>& negative, std::vector<CubicalPair>& pairs)
{
  const LowerStars& stars = gradient.Lower();
  const auto descend = [&](std::int64_t node)
  {
    const int edge = stars[node].Partner[Star::Node];
    return edge == Star::Node ? node : node + stars.Offset(edge);
  };
  LinkForest<typename Gradient::Key::Link, decltype(descend)> forest(stars.NodeCount(), descend);
  negative.assign(edges.size(), 0);
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const auto ends = gradient.EndsOf(edges[i]);
    std::int64_t elder = forest.Root(ends[0]);
    std::int64_t younger = forest.Root(ends[1]);
    if (elder == younger)
    {
      continue;
    }
    if (gradient.IsLater(elder, younger))
    {
      std::swap(elder, younger);
    }
    forest.Join(younger, elder);
    negative[i] = 1;
    if (!gradient.EdgeKey(younger, 0).SameValue(edges[i]))
    {
      pairs.push_back({ gradient.Named(younger, Star::Node),
        gradient.Named(edges[i].Node(), edges[i].Place()), 0, gradient.Named(elder, Star::Node) });
    }
  }
  pairs.push_back({ gradient.Named(forest.Root(0), Star::Node), CubicalCell(), 0, CubicalCell() });
}

/**
 * Voids: the components of what is left, in descending order; beyond the grid is one that has
 * always been there. `faces` are the critical faces, sorted; those that close a void are taken out.
 */
template <typename Gradient>
void PairVoids(const Gradient& gradient, std::vector<typename Gradient::Key>& faces,
  std::vector<CubicalPair>& pairs)
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
    const int face = stars[node].Partner[static_cast<std::size_t>(cell)];
    if (face == cell)
    {
      return cube;
    }
    const auto sides = gradient.CofacesOf(node, face);
    return sides[0] == cube ? sides[1] : sides[0];
  };
  LinkForest<typename Gradient::Key::Link, decltype(ascend)> forest(stars.NodeCount() + 1, ascend);
  const auto nameOf = [&](std::int64_t cube)
  {
    const auto [node, cell] = gradient.StarCube(cube);
    return gradient.Named(node, cell);
  };
  const auto keyOf = [&](std::int64_t cube)
  {
    const auto [node, cell] = gradient.StarCube(cube);
    return gradient.CubeKey(node, cell);
  };
  std::size_t kept = faces.size();
  for (std::size_t i = faces.size(); i-- > 0;)
  {
    const auto sides = gradient.CofacesOf(faces[i].Node(), Gradient::FaceOf(faces[i]));
    std::int64_t stays = forest.Root(sides[0]);
    std::int64_t ends = forest.Root(sides[1]);
    if (stays == ends)
    {
      faces[--kept] = faces[i];
      continue;
    }
    if (ends == outside || (stays != outside && keyOf(stays) < keyOf(ends)))
    {
      std::swap(stays, ends);
    }
    forest.Join(ends, stays);
    const auto [node, cell] = gradient.StarCube(ends);
    if (!gradient.CubeKey(node, cell).SameValue(faces[i]))
    {
      pairs.push_back({ gradient.Named(faces[i].Node(), Gradient::FaceOf(faces[i])),
        gradient.Named(node, cell), 2, stays == outside ? CubicalCell() : nameOf(stays) });
    }
  }
  faces.erase(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(kept));
  std::reverse(pairs.begin(), pairs.end());
}

}

#endif
