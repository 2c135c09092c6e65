// Ends of paths against walking each of them step by step: one long chain, random forests, fixed
// places; their numbers in the order of places.

#include "Persistence/GradientPaths.h"

#include <gtest/gtest.h>

#include <random>

using namespace isthmus;

namespace
{

/// Walks from every place and its opposite and compares with the known ends of the forest.
void ExpectPathEnds(const std::vector<std::int64_t>& next)
{
  const auto places = static_cast<std::int64_t>(next.size());
  const auto after = [&](std::int64_t place) { return next[static_cast<std::size_t>(place)]; };
  const auto starts = [&](std::int64_t i) {
    return std::array<std::int64_t, 2>{ i, places - 1 - i };
  };
  const PathEnds<std::uint32_t> ends(places, starts, places, after);
  EXPECT_TRUE(std::is_sorted(ends.Places.begin(), ends.Places.end()));
  // Paths go down, so the end of each place follows from that of an earlier one.
  std::vector<std::int64_t> expected(next.size());
  for (std::size_t i = 0; i < next.size(); ++i)
  {
    const auto to = static_cast<std::size_t>(next[i]);
    expected[i] = to == i ? next[i] : expected[to];
  }
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < next.size(); ++i)
  {
    const auto& both = ends.Numbers[i];
    wrong += ends.Places[both[0]] != expected[i] ? 1 : 0;
    wrong += ends.Places[both[1]] != expected[next.size() - 1 - i] ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0u);
}

}

TEST(PathEnds, OfOneLongChainAndOfPlacesThatStay)
{
  // Step by step, all paths of the chain are 2e10 steps.
  std::vector<std::int64_t> chain(200000);
  std::vector<std::int64_t> still(5000);
  for (std::size_t i = 0; i < chain.size(); ++i)
  {
    chain[i] = static_cast<std::int64_t>(i == 0 ? 0 : i - 1);
  }
  for (std::size_t i = 0; i < still.size(); ++i)
  {
    still[i] = static_cast<std::int64_t>(i);
  }
  ExpectPathEnds(chain);
  ExpectPathEnds(still);
  ExpectPathEnds({ 0 });
}

TEST(PathEnds, OfRandomForests)
{
  std::mt19937 random(11);
  for (const std::int64_t reach : { 1, 2, 9, 64, 5000 })
  {
    std::vector<std::int64_t> next(20000);
    for (std::size_t i = 0; i < next.size(); ++i)
    {
      const auto at = static_cast<std::int64_t>(i);
      next[i] = at - std::uniform_int_distribution<std::int64_t>(0, std::min(at, reach))(random);
    }
    ExpectPathEnds(next);
  }
}
