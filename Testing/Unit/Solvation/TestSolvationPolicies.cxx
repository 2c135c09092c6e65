// Lysozyme (1HEW): the policy of updating surface and field hardly changes the final energy, and
// the energy decreases monotonically.

#include "ChargedProtein.h"
#include "Solvation/SolvationFlow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr const char* Lysozyme = "molecules/1hew/1hew.pqr";

/// The final energy by each policy; prints each update.
std::vector<double> EnergiesAtRest(double probe, const std::vector<int>& periods)
{
  const SolvationAtoms atoms = ProteinAtoms(Lysozyme);
  std::vector<double> totals;
  for (const double relaxation : { 1.0, 0.5 })
  {
    for (const int period : periods)
    {
      SolvationParameters p;
      p.Flow.Spacing = 1.0;
      p.Flow.ProbeRadius = probe;
      p.Potential.Padding = 6.0;
      p.Policy.UpdatePeriod = period;
      p.Policy.AdaptiveUpdate = false;
      p.Policy.FieldRelaxation = relaxation;
      SolvationFlow flow(atoms, p);
      flow.Run();
      const std::vector<SolvationUpdate>& updates = flow.GetUpdates();
      EXPECT_TRUE(flow.HasConverged());
      EXPECT_LE(updates.size(), 10u);
      std::cout << "period " << period << ", alpha' " << relaxation << ":";
      for (std::size_t u = 0; u < updates.size(); ++u)
      {
        std::cout << " " << updates[u].Total();
        const double rise = u > 0 ? updates[u].Total() - updates[u - 1].Total() : 0.0;
        EXPECT_LT(rise, 1e-3 * std::abs(updates[u].Total()));
      }
      std::cout << " kcal/mol, polar " << updates.back().PolarEnergy << ", "
                << updates.back().OnObstacle << " of it on the obstacle\n";
      totals.push_back(updates.back().Total());
    }
  }
  return totals;
}

double MeasureSpread(const std::vector<double>& totals)
{
  const auto [least, most] = std::minmax_element(totals.begin(), totals.end());
  const double spread = (*most - *least) / std::abs(*least);
  std::cout << "spread " << 100.0 * spread << " %\n";
  return spread;
}

}

TEST(SolvationPolicies, ConvergeToTheSameResultOnLysozyme)
{
  ISTHMUS_NEEDS_SHARED_DATA(Lysozyme);
  EXPECT_LT(MeasureSpread(EnergiesAtRest(1.4, { 10, 20, 50, 100 })), 5e-3);
}

TEST(SolvationPolicies, ConvergeToTheSameResultOnLysozymesAtoms)
{
  // Without a probe the field draws the surface into the creases between the atoms, where it has
  // room to move: here policies could differ.
  ISTHMUS_NEEDS_SHARED_DATA(Lysozyme);
  EXPECT_LT(MeasureSpread(EnergiesAtRest(0.0, { 20, 50 })), 5e-3);
}
