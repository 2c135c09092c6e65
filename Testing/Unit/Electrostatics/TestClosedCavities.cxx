// Which cavities are closed: compared with a plain flood fill from the border, on random sides.

#include "Electrostatics/ClosedCavities.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

using namespace isthmus;

namespace
{

struct Sides
{
  SolverBox Box;
  std::vector<unsigned char> Inside;
  std::vector<InterfaceCrossing> Crossings;

  std::array<std::int64_t, 3> At(std::int64_t node) const
  {
    const auto& n = this->Box.Dimensions;
    return { node % n[0], node / n[0] % n[1], node / (n[0] * n[1]) };
  }
  bool IsInside(std::int64_t node) const
  {
    return this->Inside[static_cast<std::size_t>(node)] != 0;
  }
  /// Calls `each` for the neighbours of a node along edges.
  template <typename Each>
  void ForNeighbours(std::int64_t node, Each&& each) const
  {
    const auto at = this->At(node);
    for (std::size_t a = 0; a < 3; ++a)
    {
      if (at[a] > 0)
      {
        each(node - this->Box.Steps()[a], static_cast<int>(a));
      }
      if (at[a] + 1 < this->Box.Dimensions[a])
      {
        each(node + this->Box.Steps()[a], static_cast<int>(a));
      }
    }
  }
};

/// Calls `each` for the neighbours of a node along edges and diagonals of faces.
template <typename Each>
void ForTouching(const Sides& sides, std::int64_t node, Each&& each)
{
  sides.ForNeighbours(node,
    [&](std::int64_t other, int axis)
    {
      each(other);
      sides.ForNeighbours(other,
        [&](std::int64_t diagonal, int second)
        {
          if (second != axis)
          {
            each(diagonal);
          }
        });
    });
}

/// Nodes are inside with probability `share`, except on the border.
Sides RandomSides(double share, unsigned int seed)
{
  Sides sides;
  sides.Box.Dimensions = { 13, 11, 9 };
  std::mt19937 generator(seed);
  for (std::int64_t node = 0; node < sides.Box.Size(); ++node)
  {
    const auto at = sides.At(node);
    const auto& n = sides.Box.Dimensions;
    bool border = false;
    for (std::size_t a = 0; a < 3; ++a)
    {
      border = border || at[a] == 0 || at[a] == n[a] - 1;
    }
    const bool in = static_cast<double>(generator()) < share * 4294967296.0;
    sides.Inside.push_back(!border && in ? 1 : 0);
  }
  for (std::int64_t node = 0; node < sides.Box.Size(); ++node)
  {
    sides.ForNeighbours(node,
      [&](std::int64_t other, int axis)
      {
        if (other > node && sides.IsInside(node) != sides.IsInside(other))
        {
          sides.Crossings.push_back({ node, axis, 0.5, {} });
        }
      });
  }
  return sides;
}

/// The lowest node of the component outside that each node belongs to.
std::vector<std::int64_t> LabelByFlooding(const Sides& sides)
{
  std::vector<std::int64_t> lowest(sides.Inside.size(), -1);
  for (std::int64_t start = 0; start < sides.Box.Size(); ++start)
  {
    std::vector<std::int64_t> front{ start };
    while (!front.empty())
    {
      const std::int64_t node = front.back();
      front.pop_back();
      if (!sides.IsInside(node) && lowest[static_cast<std::size_t>(node)] < 0)
      {
        lowest[static_cast<std::size_t>(node)] = start;
        ForTouching(sides, node, [&](std::int64_t other) { front.push_back(other); });
      }
    }
  }
  return lowest;
}

TEST(ClosedCavities, AreThoseThatAFloodFromTheBorderDoesNotReach)
{
  std::size_t cavities = 0;
  for (unsigned int seed = 0; seed < 20; ++seed)
  {
    const Sides sides = RandomSides(seed < 10 ? 0.8 : 0.9, seed);
    const std::vector<std::int64_t> lowest = LabelByFlooding(sides);
    std::map<std::int64_t, std::vector<std::int64_t>> wanted;
    for (std::size_t c = 0; c < sides.Crossings.size(); ++c)
    {
      const InterfaceCrossing& crossing = sides.Crossings[c];
      const std::int64_t upper =
        crossing.Node + sides.Box.Steps()[static_cast<std::size_t>(crossing.Axis)];
      const std::int64_t outer = sides.IsInside(crossing.Node) ? upper : crossing.Node;
      const std::int64_t component = lowest[static_cast<std::size_t>(outer)];
      if (component != 0) // that of the border
      {
        wanted[component].push_back(static_cast<std::int64_t>(c));
      }
    }
    const auto found = FindCavityWalls(sides.Box, sides.Inside, sides.Crossings);
    std::map<std::int64_t, std::vector<std::int64_t>> byFirst;
    for (const auto& [component, wall] : wanted)
    {
      byFirst[wall.front()] = wall;
    }
    ASSERT_EQ(found.size(), byFirst.size()) << seed;
    std::size_t i = 0;
    for (const auto& [first, wall] : byFirst)
    {
      EXPECT_EQ(found[i++], wall) << seed;
    }
    cavities += found.size();
  }
  EXPECT_GT(cavities, 50u);
}

}
