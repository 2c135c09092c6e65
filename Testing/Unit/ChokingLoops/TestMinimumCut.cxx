// The cheapest set of links that separates two nodes, compared with all separations of a small
// graph.

#include "ChokingLoops/MinimumCutMembrane.h"
#include "Core/Index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace isthmus;

namespace
{

std::vector<FlowLink> RandomLinks(std::mt19937& random, std::int32_t nodes, std::size_t count)
{
  std::uniform_int_distribution<std::int32_t> node(0, nodes - 1);
  std::uniform_int_distribution<std::int64_t> capacity(0, 9);
  std::vector<FlowLink> links;
  while (links.size() < count)
  {
    const std::int32_t a = node(random);
    const std::int32_t b = node(random);
    if (a != b) // parallel links, and links of capacity 0, are valid
    {
      links.push_back({ { a, b }, capacity(random) });
    }
  }
  return links;
}

/// The cost of the links between a set of nodes, given as bits, and the others.
std::int64_t EstimateCost(const std::vector<FlowLink>& links, unsigned set)
{
  std::int64_t cost = 0;
  for (const FlowLink& link : links)
  {
    const bool isCut = (set >> link.Nodes[0] & 1U) != (set >> link.Nodes[1] & 1U);
    cost += isCut ? link.Capacity : 0;
  }
  return cost;
}

unsigned ToBitSet(const std::vector<char>& reached)
{
  unsigned set = 0;
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    set |= reached[i] ? 1U << i : 0U;
  }
  return set;
}

// Of all sets with the sources (nodes 0 and 1) and without the sink (the last), none is cheaper,
// and the set found is a subset of each other cheapest set.
TEST(MinimumCut, IsTheSmallestOfTheCheapest)
{
  std::mt19937 random(4);
  for (int trial = 0; trial < 500; ++trial)
  {
    const std::int32_t nodes = 4 + trial % 7;
    const auto links = RandomLinks(random, nodes, static_cast<std::size_t>(2 + trial % 29));
    const unsigned found = ToBitSet(MinimumCut(nodes, links, { 0, 1 }, { nodes - 1 }));
    ASSERT_EQ(found & 3U, 3U);
    ASSERT_EQ(found >> (nodes - 1), 0U);
    const std::int64_t cost = EstimateCost(links, found);
    for (unsigned set = 3U; set < 1U << (nodes - 1); ++set)
    {
      if ((set & 3U) != 3U)
      {
        continue;
      }
      const std::int64_t other = EstimateCost(links, set);
      ASSERT_GE(other, cost) << "trial " << trial;
      ASSERT_TRUE(other > cost || (found & ~set) == 0U) << "trial " << trial;
    }
  }
}

// A grid of n x n x n nodes between two plates, narrow in one layer: that is where it is cut.
TEST(MinimumCut, OfAGridIsItsWaist)
{
  constexpr std::int32_t N = 20;
  constexpr std::int32_t Waist = 13;
  const auto at = [](std::int32_t i, std::int32_t j, std::int32_t k)
  { return 2 + i + N * (j + N * k); };
  std::vector<FlowLink> links;
  for (std::int32_t k = 0; k < N; ++k)
  {
    for (std::int32_t j = 0; j < N; ++j)
    {
      for (std::int32_t i = 0; i < N; ++i)
      {
        const auto link = [&](std::int32_t other, std::int64_t capacity) {
          links.push_back({ { at(i, j, k), other }, capacity });
        };
        if (i + 1 < N)
        {
          link(at(i + 1, j, k), 1000);
        }
        if (j + 1 < N)
        {
          link(at(i, j + 1, k), 1000);
        }
        link(k + 1 < N ? at(i, j, k + 1) : 1, k == Waist ? 7 : 8);
        if (k == 0)
        {
          link(0, 8);
        }
      }
    }
  }
  const auto reached = MinimumCut(2 + N * N * N, links, { 0 }, { 1 });
  for (std::int32_t node = 2; node < 2 + N * N * N; ++node)
  {
    EXPECT_EQ(reached[At(node)] != 0, (node - 2) / (N * N) <= Waist) << node;
  }
}

TEST(MinimumCut, OfUnlinkedNodesCostsNothing)
{
  const auto reached = MinimumCut(5, { { { 0, 2 }, 3 }, { { 3, 1 }, 4 } }, { 0 }, { 1 });
  EXPECT_EQ(reached, (std::vector<char>{ 1, 0, 1, 0, 0 }));
}

TEST(MinimumCut, StopsOnRequest)
{
  EXPECT_THROW(
    MinimumCut(2, { { { 0, 1 }, 1 } }, { 0 }, { 1 }, [](double) { return false; }), Cancelled);
}

}
