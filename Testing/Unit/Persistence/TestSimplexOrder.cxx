// The order of simplices is that of a plain stable sort, for values of every kind.

#include "Persistence/CellFiltration.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>

using namespace isthmus;

namespace
{

void ExpectSorted(const std::vector<double>& value, const std::vector<char>& first)
{
  std::vector<SimplexId> expected(value.size());
  std::iota(expected.begin(), expected.end(), 0);
  std::stable_sort(expected.begin(), expected.end(),
    [&](std::int32_t a, std::int32_t b)
    {
      const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
      const bool firstA = !first.empty() && first[i], firstB = !first.empty() && first[j];
      return firstA != firstB ? firstA : value[i] < value[j];
    });
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, std::string("STDThread"), false),
      [&]
      {
        HandleVector<EdgeId, EdgeRank> rank;
        const auto order = SimplexOrder(
          HandleVector<EdgeId, double>(value), HandleVector<EdgeId, char>(first), rank);
        ASSERT_EQ(order.size(), expected.size());
        for (const EdgeRank at : order.Keys())
        {
          ASSERT_EQ(order[at].Value, expected[at.Index()]);
          ASSERT_EQ(rank[order[at]], at);
        }
      });
  }
}

std::vector<double> Values(std::size_t n, const std::function<double(std::mt19937&)>& one)
{
  std::mt19937 random(7);
  std::vector<double> values(n);
  std::generate(values.begin(), values.end(), [&] { return one(random); });
  return values;
}

constexpr std::size_t Many = 300'000; // several pieces

TEST(SimplexOrder, AnyValues)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<double> normal;
  ExpectSorted({}, {});
  ExpectSorted({ 1.0 }, {});
  ExpectSorted(Values(Many, [&](auto& random) { return unit(random); }), {});
  ExpectSorted(Values(Many, [&](auto& random) { return std::exp(200.0 * normal(random)); }), {});
  ExpectSorted(Values(Many, [&](auto& random) { return normal(random); }), {});
  // Neighbours that differ in their last bits only.
  ExpectSorted(Values(Many, [&](auto& random) { return 1e30 + 1e16 * unit(random); }), {});
}

TEST(SimplexOrder, LevelsAreSortedAsTheirNumbers)
{
  std::mt19937 random(11);
  for (const std::uint32_t most :
    { 1U, 2U, 1000U, 1U << 20, std::numeric_limits<std::uint32_t>::max() })
  {
    HandleVector<EdgeId, std::uint32_t> level(Many);
    std::generate(
      level.begin(), level.end(), [&] { return static_cast<std::uint32_t>(random()) % most; });
    const std::vector<double> value(level.begin(), level.end());
    HandleVector<EdgeId, EdgeRank> rank, expectedRank;
    const auto order = SimplexOrder(level, rank);
    EXPECT_EQ(order, SimplexOrder(HandleVector<EdgeId, double>(value), {}, expectedRank));
    EXPECT_EQ(rank, expectedRank);
  }
}

TEST(SimplexOrder, TiesAndExtremes)
{
  const std::vector<double> few{ 0.0, -0.0, 1.0, 1e-300, 5e-324, 1e300,
    std::numeric_limits<double>::infinity() };
  const auto pick = [&few](auto& random) { return few[random() % few.size()]; };
  ExpectSorted(Values(Many, pick), {});
  ExpectSorted(Values(Many, [](auto&) { return 3.0; }), {});
  ExpectSorted(Values(Many, [](auto&) { return 0.0; }), {});
  std::vector<char> first(Many, 0);
  for (std::size_t i = 0; i < Many; i += 5)
  {
    first[i] = 1;
  }
  ExpectSorted(Values(Many, pick), first);
  ExpectSorted(Values(Many, [&](auto& random) { return pick(random) - 1.0; }), {});
}

}
