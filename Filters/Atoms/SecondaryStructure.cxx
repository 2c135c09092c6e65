#include "Atoms/SecondaryStructure.h"

#include "Atoms/PointBins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <utility>

namespace isthmus
{
namespace
{

constexpr double MostEnergyOfBond = -0.5;      ///< kcal/mol
constexpr double Coupling = 0.42 * 0.20 * 332; ///< kcal/mol angstrom
constexpr double LeastEnergy = -9.9;           ///< of atoms nearer than LeastDistance
constexpr double LeastDistance = 0.5;
constexpr double LongestReach = 9.0; ///< between CA of bonded residues

/// A single bridge: becomes coil, but cannot be part of a 3-10 or pi helix.
constexpr auto Bridge = static_cast<SecondaryStructure>(255);

struct HydrogenBond
{
  std::int64_t Acceptor = -1;
  double Energy = MostEnergyOfBond;
};

/// The hydrogen bonds of a protein, and the order of its residues.
class BackboneBonds
{
public:
  BackboneBonds(const std::vector<NamedAtom>& atoms, const std::vector<PolymerResidue>& residues)
    : Atoms(atoms)
    , Residues(residues)
    , Bonds(residues.size())
    , ChainOf(residues.size())
  {
    for (std::size_t r = 1; r < residues.size(); ++r)
    {
      this->ChainOf[r] = this->ChainOf[r - 1] + (residues[r - 1].IsLinked ? 0 : 1);
    }
    this->FindPairs();
    for (const auto& [i, j] : this->Pairs)
    {
      this->AddBond(i, j);
      if (j != i + 1 || !residues[static_cast<std::size_t>(i)].IsLinked)
      {
        this->AddBond(j, i);
      }
    }
  }

  /// Pairs of residues that are near each other, i < j, ascending.
  const std::vector<std::pair<std::int64_t, std::int64_t>>& Near() const { return this->Pairs; }

  /// N-H of `donor` is bonded to C=O of `acceptor`.
  bool Has(std::int64_t donor, std::int64_t acceptor) const
  {
    const auto& two = this->Bonds[static_cast<std::size_t>(donor)];
    return two[0].Acceptor == acceptor || two[1].Acceptor == acceptor;
  }

  bool IsUnbroken(std::int64_t first, std::int64_t last) const
  {
    return first >= 0 && last < static_cast<std::int64_t>(this->ChainOf.size()) &&
      this->ChainOf[static_cast<std::size_t>(first)] ==
      this->ChainOf[static_cast<std::size_t>(last)];
  }

private:
  const Point3& Place(std::int64_t atom) const
  {
    return this->Atoms[static_cast<std::size_t>(atom)].Place;
  }

  void FindPairs()
  {
    std::vector<std::int64_t> numbers;
    std::vector<Point3> places;
    for (std::size_t r = 0; r < this->Residues.size(); ++r)
    {
      const PolymerResidue& residue = this->Residues[r];
      if (residue.CA >= 0 && residue.N >= 0 && residue.C >= 0 && residue.O >= 0)
      {
        numbers.push_back(static_cast<std::int64_t>(r));
        places.push_back(this->Place(residue.CA));
      }
    }
    const PointBins bins(places, LongestReach);
    for (std::size_t p = 0; p < places.size(); ++p)
    {
      const std::size_t first = this->Pairs.size();
      bins.Near(places[p], LongestReach,
        [&](std::int64_t q, double)
        {
          if (q > static_cast<std::int64_t>(p))
          {
            this->Pairs.emplace_back(numbers[p], numbers[static_cast<std::size_t>(q)]);
          }
        });
      std::sort(this->Pairs.begin() + static_cast<std::ptrdiff_t>(first), this->Pairs.end());
    }
  }

  void AddBond(std::int64_t donor, std::int64_t acceptor)
  {
    const auto d = static_cast<std::size_t>(donor);
    const PolymerResidue& from = this->Residues[d];
    const bool hasHydrogen = d > 0 && this->Residues[d - 1].IsLinked &&
      this->Residues[d - 1].C >= 0 && this->Residues[d - 1].O >= 0 &&
      this->Atoms[from.Atoms.front()].Residue != "PRO";
    if (!hasHydrogen)
    {
      return;
    }
    const Point3 back = this->Place(this->Residues[d - 1].C) - this->Place(this->Residues[d - 1].O);
    const double length = Length(back);
    if (!(length > 0.0))
    {
      return;
    }
    const Point3& n = this->Place(from.N);
    const Point3 h = n + (1.0 / length) * back;
    const PolymerResidue& to = this->Residues[static_cast<std::size_t>(acceptor)];
    const double energy = Energy(n, h, this->Place(to.C), this->Place(to.O));
    auto& two = this->Bonds[d];
    if (energy < two[0].Energy)
    {
      two[1] = two[0];
      two[0] = { acceptor, energy };
    }
    else if (energy < two[1].Energy)
    {
      two[1] = { acceptor, energy };
    }
  }

  static double Energy(const Point3& n, const Point3& h, const Point3& c, const Point3& o)
  {
    const double on = Distance(o, n);
    const double ch = Distance(c, h);
    const double oh = Distance(o, h);
    const double cn = Distance(c, n);
    if (std::min({ on, ch, oh, cn }) < LeastDistance)
    {
      return LeastEnergy;
    }
    // DSSP rounds, so that an energy of -0.5004 is not a bond.
    return std::round(1000.0 * Coupling * (1.0 / on + 1.0 / ch - 1.0 / oh - 1.0 / cn)) / 1000.0;
  }

  const std::vector<NamedAtom>& Atoms;
  const std::vector<PolymerResidue>& Residues;
  std::vector<std::array<HydrogenBond, 2>> Bonds;
  std::vector<std::int64_t> ChainOf; ///< number of the unbroken piece of a chain
  std::vector<std::pair<std::int64_t, std::int64_t>> Pairs;
};

enum class BridgeType
{
  None,
  Parallel,
  Antiparallel
};

/// Consecutive bridges between two pieces of chains, first to last residue of both.
struct Ladder
{
  BridgeType Type;
  std::int64_t FirstI, LastI, FirstJ, LastJ;
  std::int64_t Bridges = 1;
};

BridgeType ClassifyBridge(const BackboneBonds& bonds, std::int64_t i, std::int64_t j)
{
  if (!bonds.IsUnbroken(i - 1, i + 1) || !bonds.IsUnbroken(j - 1, j + 1))
  {
    return BridgeType::None;
  }
  if ((bonds.Has(i + 1, j) && bonds.Has(j, i - 1)) || (bonds.Has(j + 1, i) && bonds.Has(i, j - 1)))
  {
    return BridgeType::Parallel;
  }
  return (bonds.Has(i + 1, j - 1) && bonds.Has(j + 1, i - 1)) ||
      (bonds.Has(j, i) && bonds.Has(i, j))
    ? BridgeType::Antiparallel
    : BridgeType::None;
}

bool Extends(const Ladder& ladder, BridgeType type, std::int64_t j)
{
  return ladder.Type == type &&
    (type == BridgeType::Parallel ? ladder.LastJ + 1 == j : ladder.FirstJ - 1 == j);
}

std::vector<Ladder> FindLadders(const BackboneBonds& bonds, std::size_t residues)
{
  std::vector<Ladder> ladders;
  std::vector<std::vector<std::size_t>> ending(residues); // ladders by their last residue i
  for (const auto& [i, j] : bonds.Near())
  {
    const BridgeType type = j < i + 3 ? BridgeType::None : ClassifyBridge(bonds, i, j);
    if (type == BridgeType::None)
    {
      continue;
    }
    auto& before = ending[static_cast<std::size_t>(i - 1)];
    const auto at = std::find_if(before.begin(), before.end(),
      [&ladders, type = type, j = j](std::size_t l) { return Extends(ladders[l], type, j); });
    std::size_t number = ladders.size();
    if (at == before.end())
    {
      ladders.push_back({ type, i, i, j, j });
    }
    else
    {
      number = *at;
      before.erase(at);
      Ladder& ladder = ladders[number];
      ladder.LastI = i;
      (type == BridgeType::Parallel ? ladder.LastJ : ladder.FirstJ) = j;
      ++ladder.Bridges;
    }
    ending[static_cast<std::size_t>(i)].push_back(number);
  }
  return ladders;
}

/// Whether `b` continues `a` after a bulge: up to one more residue on a strand, four on the other.
bool ContinuesAfterBulge(const BackboneBonds& bonds, const Ladder& a, const Ladder& b)
{
  const std::int64_t gapI = b.FirstI - a.LastI;
  const std::int64_t gapJ =
    a.Type == BridgeType::Parallel ? b.FirstJ - a.LastJ : a.FirstJ - b.LastJ;
  return a.Type == b.Type && gapI > 0 && gapI < 6 && gapJ >= 0 &&
    ((gapJ < 6 && gapI < 3) || gapJ < 3) && bonds.IsUnbroken(a.FirstI, b.LastI) &&
    bonds.IsUnbroken(std::min(a.FirstJ, b.FirstJ), std::max(a.LastJ, b.LastJ));
}

void MergeAcrossBulges(const BackboneBonds& bonds, std::vector<Ladder>& ladders)
{
  std::stable_sort(ladders.begin(), ladders.end(),
    [](const Ladder& a, const Ladder& b) { return a.FirstI < b.FirstI; });
  for (std::size_t a = 0; a < ladders.size(); ++a)
  {
    for (std::size_t b = a + 1; b < ladders.size(); ++b)
    {
      Ladder& into = ladders[a];
      Ladder& from = ladders[b];
      if (into.Bridges == 0 || from.FirstI - into.LastI >= 6)
      {
        break;
      }
      if (from.Bridges > 0 && ContinuesAfterBulge(bonds, into, from))
      {
        into.LastI = from.LastI;
        into.FirstJ = std::min(into.FirstJ, from.FirstJ);
        into.LastJ = std::max(into.LastJ, from.LastJ);
        into.Bridges += from.Bridges;
        from.Bridges = 0;
      }
    }
  }
}

void Mark(std::vector<SecondaryStructure>& of, std::int64_t first, std::int64_t last,
  SecondaryStructure structure)
{
  std::fill(of.begin() + first, of.begin() + last + 1, structure);
}

void MarkStrands(const BackboneBonds& bonds, std::vector<SecondaryStructure>& of)
{
  std::vector<Ladder> ladders = FindLadders(bonds, of.size());
  MergeAcrossBulges(bonds, ladders);
  for (const auto structure : { Bridge, SecondaryStructure::Strand })
  {
    for (const Ladder& ladder : ladders)
    {
      if (ladder.Bridges == 1 ? structure == Bridge
                              : ladder.Bridges > 1 && structure == SecondaryStructure::Strand)
      {
        Mark(of, ladder.FirstI, ladder.LastI, structure);
        Mark(of, ladder.FirstJ, ladder.LastJ, structure);
      }
    }
  }
}

/// Helices of `stride` residues per turn, where two consecutive turns begin and all residues are
/// coil, or `over`.
void MarkHelices(const BackboneBonds& bonds, std::int64_t stride, SecondaryStructure helix,
  std::initializer_list<SecondaryStructure> over, std::vector<SecondaryStructure>& of)
{
  const auto isTurn = [&](std::int64_t i)
  { return bonds.IsUnbroken(i, i + stride) && bonds.Has(i + stride, i); };
  const auto isFree = [&](SecondaryStructure s)
  {
    return s == SecondaryStructure::Coil || s == helix ||
      std::find(over.begin(), over.end(), s) != over.end();
  };
  const auto count = static_cast<std::int64_t>(of.size());
  for (std::int64_t i = 1; i + stride < count; ++i)
  {
    if (isTurn(i - 1) && isTurn(i) && std::all_of(of.begin() + i, of.begin() + i + stride, isFree))
    {
      Mark(of, i, i + stride - 1, helix);
    }
  }
}

}

std::vector<SecondaryStructure> FindSecondaryStructure(
  const std::vector<NamedAtom>& atoms, const std::vector<PolymerResidue>& residues)
{
  std::vector<SecondaryStructure> of(residues.size(), SecondaryStructure::Coil);
  const BackboneBonds bonds(atoms, residues);
  MarkStrands(bonds, of);
  MarkHelices(bonds, 4, SecondaryStructure::AlphaHelix, { SecondaryStructure::Strand, Bridge }, of);
  MarkHelices(bonds, 3, SecondaryStructure::Helix310, {}, of);
  MarkHelices(bonds, 5, SecondaryStructure::PiHelix, { SecondaryStructure::AlphaHelix }, of);
  std::replace(of.begin(), of.end(), Bridge, SecondaryStructure::Coil);
  for (std::size_t r = 0; r < residues.size(); ++r)
  {
    if (residues[r].Kind == ResidueKind::Nucleotide)
    {
      of[r] = SecondaryStructure::NucleicAcid;
    }
  }
  return of;
}

}
