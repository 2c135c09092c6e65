// Matchings of lower stars against counting the components and holes of their links.

#include "Persistence/StarMatching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>

using namespace isthmus;

TEST(StarMatching, CriticalCellsMatchClassesThatAreBornOrDie)
{
  // Every closed star of 2000 drawn at random: the Euler number is that of the critical cells, and
  // no star can have fewer (components of the link less one, holes of the link).
  std::mt19937 random(3);
  for (int round = 0; round < 2000; ++round)
  {
    std::uint32_t mask =
      static_cast<std::uint32_t>(random()) | static_cast<std::uint32_t>(random());
    mask &= (1U << 26) - 1;
    mask &= Star::FacesOfEdges[mask & 63U] | ~(4095U << 6);
    mask &= Star::CubesOfFaces[mask >> 6 & 4095U] | ~(255U << 18);
    const StarMatching star = MatchStar(mask);
    int euler = 0;
    int critical[4] = { 0, 0, 0, 0 };
    for (int cell = 0; cell <= Star::Node; ++cell)
    {
      const bool present = cell == Star::Node || (mask >> cell & 1U) != 0;
      const auto partner = star.Partner[static_cast<std::size_t>(cell)];
      ASSERT_EQ(partner != Star::Absent, present);
      if (present && partner == cell)
      {
        ++critical[Star::Dimension(cell)];
        euler += Star::Dimension(cell) % 2 == 0 ? 1 : -1;
      }
      ASSERT_TRUE(!present || star.Partner[partner] == cell);
    }
    ASSERT_EQ(euler, star.EulerNumber);
    // Betti numbers of the link: components by flooding its vertices (edges) along its edges
    // (faces); the rest by the Euler number, since only a whole sphere has a void.
    const std::uint32_t edges = mask & 63U;
    if (edges == 0)
    {
      ASSERT_EQ(critical[0], 1);
      continue;
    }
    std::array<int, 6> label{};
    std::iota(label.begin(), label.end(), 0);
    for (int pass = 0; pass < 6; ++pass)
    {
      for (std::size_t face = 0; face < 12; ++face)
      {
        if ((mask >> (face + 6) & 1U) != 0)
        {
          const auto& both = Star::FaceEdges[face];
          label[both[0]] = label[both[1]] = std::min(label[both[0]], label[both[1]]);
        }
      }
    }
    int components = 0;
    for (int edge = 0; edge < 6; ++edge)
    {
      components += (edges >> edge & 1U) != 0 && label[static_cast<std::size_t>(edge)] == edge;
    }
    const int voids = mask == (1U << 26) - 1 ? 1 : 0;
    ASSERT_EQ(critical[1], components - 1);
    ASSERT_EQ(critical[3], voids);
    // Critical faces are the holes of the link: by the Euler number of the link, which is 1 less
    // that of the star.
    const int holes = components + voids - (1 - star.EulerNumber);
    ASSERT_EQ(critical[2], holes) << mask;
  }
}
