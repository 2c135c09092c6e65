// A helix of 1,000 residues, with 5 atoms each: secondary structure by hydrogen bonds, and the
// ribbon. Residues per second.

#include "Atoms/MoleculeCartoon.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{

/// Backbone of an ideal alpha helix: radius and angle of N, CA, C and O, 1.5 angstrom and 100
/// degrees per residue.
std::vector<isthmus::NamedAtom> Helix(int residues)
{
  struct Place
  {
    const char* Name;
    double Radius, Angle, Rise;
    int Element;
  };
  const std::vector<Place> places{ { "N", 1.55, -27.7, -0.9, 7 }, { "CA", 2.29, 0.0, 0.0, 6 },
    { "C", 1.66, 26.4, 1.13, 6 }, { "O", 1.99, 22.6, 2.33, 8 } };
  std::vector<isthmus::NamedAtom> atoms;
  for (int r = 0; r < residues; ++r)
  {
    for (const Place& place : places)
    {
      const double angle = (100.0 * r + place.Angle) * isthmus::Pi / 180.0;
      isthmus::NamedAtom atom;
      atom.Place = { place.Radius * std::cos(angle), place.Radius * std::sin(angle),
        1.5 * r + place.Rise };
      atom.Name = place.Name;
      atom.Residue = "ALA";
      atom.Chain = "A";
      atom.ResidueId = r + 1;
      atom.Element = place.Element;
      atoms.push_back(atom);
    }
  }
  return atoms;
}

}

static void BM_MoleculeCartoon(benchmark::State& state)
{
  const auto atoms = Helix(static_cast<int>(state.range(0)));
  std::vector<std::size_t> all(atoms.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i] = i;
  }
  for (auto _ : state)
  {
    const auto residues = isthmus::FindResidues(atoms, all);
    isthmus::CartoonMesh mesh;
    isthmus::DrawCartoon(
      atoms, residues, isthmus::FindSecondaryStructure(atoms, residues), {}, mesh);
    benchmark::DoNotOptimize(mesh.Points.data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(BM_MoleculeCartoon)->Arg(1000)->Arg(10000);

BENCHMARK_MAIN();
