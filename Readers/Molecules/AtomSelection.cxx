#include "Molecules/AtomSelection.h"

#include "Atoms/ChemicalElement.h"
#include "Core/NumberText.h"
#include "Core/ParallelFor.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

namespace isthmus
{
namespace
{

std::set<std::string> ChainNames(const std::string& list)
{
  std::set<std::string> names;
  for (std::size_t at = 0; at < list.size();)
  {
    const std::size_t end = std::min(list.find_first_of(" ,;\t", at), list.size());
    if (end > at)
    {
      names.insert(list.substr(at, end - at));
    }
    at = end + 1;
  }
  return names;
}

/// Throws where one of `wanted` is not a chain of the molecule.
void CheckChains(const Macromolecule& molecule, const std::set<std::string>& wanted)
{
  if (wanted.empty())
  {
    return;
  }
  std::set<std::string> there;
  for (const Atom& atom : molecule.Atoms)
  {
    there.insert(atom.Chain.empty() ? "(no name)" : atom.Chain);
  }
  for (const std::string& name : wanted)
  {
    if (there.count(name) == 0)
    {
      std::string list;
      for (const std::string& other : there)
      {
        list += " " + other;
      }
      throw std::runtime_error(JoinText("There is no chain ", name, "; there are:", list, "."));
    }
  }
}

/// The alternate locations of one residue.
struct Locations
{
  std::map<char, double> Occupancy; ///< sums, blank left out
  std::map<std::string, std::map<char, double>> OfAtom;
  std::set<std::string> ResidueNames;

  char Best() const { return Highest(this->Occupancy); }

  bool IsIncluded(const Atom& atom) const
  {
    const char best = this->Best();
    if (atom.AltLoc == best || this->ResidueNames.size() > 1)
    {
      return atom.AltLoc == best;
    }
    const auto& own = this->OfAtom.at(atom.Name);
    return own.count(best) == 0 && atom.AltLoc == Highest(own);
  }

private:
  static char Highest(const std::map<char, double>& sums)
  {
    return std::max_element(
      sums.begin(), sums.end(), [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
  }
};

class AltLocChoice
{
public:
  AltLocChoice(const Macromolecule& molecule, const std::string& altLoc)
    : Wanted(altLoc)
  {
    bool found = altLoc.empty() || altLoc == "*";
    for (const Atom& atom : molecule.Atoms)
    {
      found = found || altLoc[0] == atom.AltLoc;
      if (atom.AltLoc != ' ' && altLoc.empty())
      {
        const double occupancy = atom.Occupancy > 0.0 ? atom.Occupancy : 0.0;
        Locations& locations = this->Residues[MakeKey(atom)];
        locations.Occupancy[atom.AltLoc] += occupancy;
        locations.OfAtom[atom.Name][atom.AltLoc] += occupancy;
        locations.ResidueNames.insert(atom.ResidueName);
      }
    }
    if (!found || altLoc.size() > 1)
    {
      throw std::runtime_error("No atom has the alternate location " + altLoc +
        ": give one letter of the file, * for all, or nothing for the most occupied.");
    }
  }

  bool IsIncluded(const Atom& atom) const
  {
    if (atom.AltLoc == ' ' || this->Wanted == "*")
    {
      return true;
    }
    return this->Wanted.empty() ? this->Residues.at(MakeKey(atom)).IsIncluded(atom)
                                : this->Wanted[0] == atom.AltLoc;
  }

private:
  using Key = std::tuple<std::string, int, char>;
  static Key MakeKey(const Atom& atom)
  {
    return { atom.Chain, atom.ResidueId, atom.InsertionCode };
  }

  std::string Wanted;
  std::map<Key, Locations> Residues;
};

void KeepAtoms(Macromolecule& molecule, const std::vector<char>& keep)
{
  if (std::find(keep.begin(), keep.end(), 0) == keep.end())
  {
    return;
  }
  constexpr std::int64_t gone = -1;
  std::vector<std::int64_t> place(keep.size(), gone);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < keep.size(); ++i)
  {
    if (keep[i] != 0)
    {
      place[i] = static_cast<std::int64_t>(kept);
      if (kept != i)
      {
        molecule.Atoms[kept] = std::move(molecule.Atoms[i]);
      }
      ++kept;
    }
  }
  molecule.Atoms.resize(kept);
  std::vector<Bond> bonds;
  for (const Bond& bond : molecule.Bonds)
  {
    const std::int64_t a = place[static_cast<std::size_t>(bond.First)];
    const std::int64_t b = place[static_cast<std::size_t>(bond.Second)];
    if (a != gone && b != gone)
    {
      bonds.push_back({ a, b, bond.FromFile });
    }
  }
  molecule.Bonds = std::move(bonds);
}

}

void SelectAtoms(Macromolecule& molecule, const MoleculeOptions& options)
{
  const std::set<std::string> chains = ChainNames(options.Chains);
  CheckChains(molecule, chains);
  const AltLocChoice altLocs(molecule, options.AltLoc);
  std::vector<char> keep(molecule.Atoms.size());
  std::atomic<std::size_t> otherLocations{ 0 };
  constexpr std::int64_t atomsAtOnce = 1 << 14;
  ParallelFor(0, static_cast<std::int64_t>(keep.size()), atomsAtOnce,
    [&](std::int64_t first, std::int64_t last)
    {
      std::size_t others = 0;
      bool isWater = false;
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
      {
        const Atom& atom = molecule.Atoms[i];
        // Called once for the atoms of a residue, which are consecutive.
        isWater = i > static_cast<std::size_t>(first) &&
            atom.ResidueName == molecule.Atoms[i - 1].ResidueName
          ? isWater
          : IsWater(atom.ResidueName);
        const bool kind = isWater ? options.ReadWater : options.ReadHetero || !atom.IsHetero;
        const bool wanted = kind && (chains.empty() || chains.count(atom.Chain) > 0);
        keep[i] = wanted && altLocs.IsIncluded(atom) ? 1 : 0;
        others += wanted && keep[i] == 0 ? 1 : 0;
      }
      otherLocations += others;
    });
  if (otherLocations > 0)
  {
    molecule.Notes.emplace_back("Atoms at other alternate locations, left out: " +
      std::to_string(otherLocations.load()) + ".");
  }
  KeepAtoms(molecule, keep);
}

}
