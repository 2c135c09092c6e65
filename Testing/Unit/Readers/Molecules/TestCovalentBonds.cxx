// Bonds by distance, compared with a search of all pairs; threads, dense atoms and coordinates of
// any size.

#include "Molecules/CovalentBonds.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>

using namespace isthmus;

namespace
{

/// A lattice of carbons with jitter, as many bonds as neighbours below 1.97 angstrom.
Macromolecule JitteredCarbons(int side)
{
  Macromolecule molecule;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  for (int i = 0; i < side * side * side; ++i)
  {
    Atom atom;
    atom.Element = 6;
    atom.Position = { 1.9 * (i % side) + jitter(random), 1.9 * (i / side % side) + jitter(random),
      1.9 * (i / side / side) + jitter(random) };
    molecule.Atoms.push_back(atom);
  }
  return molecule;
}

}

TEST(CovalentBonds, MatchBruteForce)
{
  Macromolecule molecule = JitteredCarbons(12);
  std::vector<std::pair<std::int64_t, std::int64_t>> expected;
  for (std::size_t i = 0; i < molecule.Atoms.size(); ++i)
  {
    for (std::size_t j = i + 1; j < molecule.Atoms.size(); ++j)
    {
      const auto& a = molecule.Atoms[i].Position;
      const auto& b = molecule.Atoms[j].Position;
      const double d = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
      if (d > 0.4 && d < 0.76 + 0.76 + 0.45)
      {
        expected.emplace_back(i, j);
      }
    }
  }
  AddCovalentBonds(molecule, {});
  ASSERT_GT(expected.size(), 1000u);
  ASSERT_EQ(molecule.Bonds.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_EQ(molecule.Bonds[i].First, expected[i].first);
    EXPECT_EQ(molecule.Bonds[i].Second, expected[i].second);
  }
}

TEST(CovalentBonds, AreTheSameOnAnyNumberOfThreads)
{
  std::vector<Bond> first;
  for (const int threads : { 1, 2, 5 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, std::string("STDThread"), false),
      [&]
      {
        Macromolecule molecule = JitteredCarbons(30);
        AddCovalentBonds(molecule, {});
        if (first.empty())
        {
          first = molecule.Bonds;
        }
        ASSERT_EQ(molecule.Bonds.size(), first.size());
        EXPECT_TRUE(std::equal(first.begin(), first.end(), molecule.Bonds.begin(),
          [](const Bond& a, const Bond& b) { return a.First == b.First && a.Second == b.Second; }));
      });
  }
}

TEST(CovalentBonds, CrowdsAndHugeCoordinatesEnd)
{
  Macromolecule crowd;
  crowd.Atoms.resize(200000);
  for (Atom& atom : crowd.Atoms)
  {
    atom.Element = 6;
  }
  AddCovalentBonds(crowd, {});
  EXPECT_TRUE(crowd.Bonds.empty());
  ASSERT_EQ(crowd.Warnings.size(), 1u);
  Macromolecule far = JitteredCarbons(2);
  const std::size_t bonds = [&]
  {
    AddCovalentBonds(far, {});
    return far.Bonds.size();
  }();
  far.Bonds.clear();
  far.Atoms.resize(10);
  far.Atoms[8].Element = far.Atoms[9].Element = 6;
  far.Atoms[8].Position = { 1e300, -1e300, 1e300 };
  far.Atoms[9].Position = { -1e300, 1e300, 1e300 };
  AddCovalentBonds(far, {});
  EXPECT_EQ(far.Bonds.size(), bonds);
}

TEST(CovalentBonds, NoneBetweenHydrogensConformersAndMetals)
{
  const auto bonds = [](int first, int second, char altLoc, double distance)
  {
    Macromolecule pair;
    pair.Atoms.resize(2);
    pair.Atoms[0].Element = first;
    pair.Atoms[1].Element = second;
    pair.Atoms[0].AltLoc = 'A';
    pair.Atoms[1].AltLoc = altLoc;
    pair.Atoms[1].Position[0] = distance;
    AddCovalentBonds(pair, {});
    return pair.Bonds.size();
  };
  EXPECT_EQ(bonds(6, 6, 'A', 1.5), 1u);
  EXPECT_EQ(bonds(6, 6, ' ', 1.5), 1u);
  EXPECT_EQ(bonds(6, 6, 'B', 1.5), 0u);
  EXPECT_EQ(bonds(1, 1, 'A', 0.74), 0u);
  EXPECT_EQ(bonds(6, 1, 'A', 1.09), 1u);
  EXPECT_EQ(bonds(6, 26, 'A', 1.9), 0u);
  EXPECT_EQ(bonds(6, 0, 'A', 1.5), 0u);
  // The limits: 0.4, and 0.76 + 0.66 + 0.45 = 1.87 angstrom for C-O.
  EXPECT_EQ(bonds(6, 8, 'A', 0.39), 0u);
  EXPECT_EQ(bonds(6, 8, 'A', 0.41), 1u);
  EXPECT_EQ(bonds(6, 8, 'A', 1.86), 1u);
  EXPECT_EQ(bonds(6, 8, 'A', 1.88), 0u);
}
