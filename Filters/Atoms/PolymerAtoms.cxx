#include "Atoms/PolymerAtoms.h"

#include "Atoms/ChemicalElement.h"
#include "Atoms/PointBins.h"

#include <map>
#include <tuple>

namespace isthmus
{
namespace
{

/// A peptide bond is 1.33 angstrom long, a phosphodiester 1.6; the next neighbours are 2.4 away.
constexpr double LongestLink = 1.9;

const std::set<std::string>& StandardResidues()
{
  static const std::set<std::string> names{ "ALA", "ARG", "ASN", "ASP", "CYS", "GLN", "GLU", "GLY",
    "HIS", "ILE", "LEU", "LYS", "MET", "PHE", "PRO", "SER", "THR", "TRP", "TYR", "VAL", "ASX",
    "GLX", "UNK", "SEC", "PYL", "MSE", // protonation and bonds, as force fields name them
    "HID", "HIE", "HIP", "HSD", "HSE", "HSP", "CYX", "CYM", "ASH", "GLH", "LYN", "ARN", "TYM", "A",
    "C", "G", "U", "I", "DA", "DC", "DG", "DT", "DI", "DU", "RA", "RC", "RG", "RU", "ADE", "CYT",
    "GUA", "URA", "THY" };
  return names;
}

/// Groups that are part of a working protein although they are ligands by their bonds.
const std::set<std::string>& ProstheticGroups()
{
  static const std::set<std::string> names{ "HEM", "HEA", "HEB", "HEC", "HEV", "HAS", "DHE", "SRM",
    "CLA", "CHL", "BCL", "BCB", "BPH", "BPB", "PHO", "FAD", "FMN", "SF4", "FES", "F3S", "CLF",
    "CFM", "F43", "B12", "COB", "CNC", "PLP", "PQQ", "RET", "MTE", "MGD", "HDD", "TPP" };
  return names;
}

enum class Kind
{
  Polymer,
  Water,
  Ion,
  Prosthetic,
  Ligand
};

using ResidueKey = std::tuple<std::string, int, std::string, std::string>;

struct Residue
{
  std::vector<std::size_t> Atoms;
  std::size_t HeavyAtoms = 0;
  std::string Name;
  bool IsHetero = false;
  bool IsPolymer = false;
};

bool IsHydrogen(const NamedAtom& atom)
{
  return atom.Element == 1;
}

/// Residues in the order of their first atoms, and the residue of each atom.
std::vector<Residue> Residues(const std::vector<NamedAtom>& atoms, std::vector<std::size_t>& of)
{
  std::map<ResidueKey, std::size_t> numbers;
  std::vector<Residue> residues;
  of.resize(atoms.size());
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    const NamedAtom& a = atoms[i];
    const bool next = i > 0 && a.ResidueId == atoms[i - 1].ResidueId &&
      a.Residue == atoms[i - 1].Residue && a.Chain == atoms[i - 1].Chain &&
      a.InsertionCode == atoms[i - 1].InsertionCode;
    // Mostly the residue of the atom before, which spares the search; waters and alternate
    // locations may be interleaved.
    of[i] = next
      ? of[i - 1]
      : numbers
          .emplace(ResidueKey{ a.Chain, a.ResidueId, a.InsertionCode, a.Residue }, residues.size())
          .first->second;
    if (of[i] == residues.size())
    {
      residues.emplace_back();
      residues.back().Name = a.Residue;
    }
    Residue& residue = residues[of[i]];
    residue.Atoms.push_back(i);
    residue.IsHetero = residue.IsHetero || a.IsHetero;
    residue.HeavyAtoms += IsHydrogen(a) ? 0 : 1;
  }
  return residues;
}

/// 1 and 2 are linked by peptide bonds, 3 and 4 by phosphodiesters.
int LinkEnd(const NamedAtom& atom)
{
  if (atom.Name == "N" || atom.Name == "C")
  {
    return atom.Name == "N" ? 1 : 2;
  }
  if (atom.Name == "P")
  {
    return 3;
  }
  return atom.Name == "O3'" || atom.Name == "O3*" ? 4 : 0;
}

bool CanLink(int a, int b)
{
  return (a == 1 && b == 2) || (a == 2 && b == 1) || (a == 3 && b == 4) || (a == 4 && b == 3);
}

/// Marks residues linked to a residue of a chain as part of it.
void PropagateAlongChains(const std::vector<NamedAtom>& atoms, const std::vector<std::size_t>& of,
  std::vector<Residue>& residues)
{
  std::vector<std::size_t> ends;
  std::vector<Point3> places;
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    if (LinkEnd(atoms[i]) != 0)
    {
      ends.push_back(i);
      places.push_back(atoms[i].Place);
    }
  }
  const PointBins bins(places, 2.0 * LongestLink);
  std::vector<std::size_t> open;
  for (std::size_t r = 0; r < residues.size(); ++r)
  {
    if (residues[r].IsPolymer)
    {
      open.push_back(r);
    }
  }
  while (!open.empty())
  {
    const Residue from = residues[open.back()];
    open.pop_back();
    for (const std::size_t i : from.Atoms)
    {
      if (LinkEnd(atoms[i]) == 0)
      {
        continue;
      }
      bins.Near(atoms[i].Place, LongestLink,
        [&](std::int64_t end, double)
        {
          const std::size_t other = ends[static_cast<std::size_t>(end)];
          Residue& to = residues[of[other]];
          if (!to.IsPolymer && !IsWater(to.Name) &&
            CanLink(LinkEnd(atoms[i]), LinkEnd(atoms[other])))
          {
            to.IsPolymer = true;
            open.push_back(of[other]);
          }
        });
    }
  }
}

Kind ClassifyResidue(const Residue& residue, bool anyPolymer)
{
  if (IsWater(residue.Name))
  {
    return Kind::Water;
  }
  // Without a known residue (no names, or others), a chain does not determine the polymer.
  if (residue.IsPolymer || !anyPolymer)
  {
    return Kind::Polymer;
  }
  if (residue.HeavyAtoms <= 1)
  {
    return Kind::Ion;
  }
  return ProstheticGroups().count(residue.Name) > 0 ? Kind::Prosthetic : Kind::Ligand;
}

bool IsIncluded(const PolymerOptions& options, Kind kind)
{
  switch (kind)
  {
    case Kind::Water:
      return options.Waters;
    case Kind::Ion:
      return options.Ions;
    case Kind::Prosthetic:
      return options.ProstheticGroups || options.Ligands;
    case Kind::Ligand:
      return options.Ligands;
    default:
      return true;
  }
}

/// The alternate location to keep for each position in a chain, where there are any.
class Locations
{
public:
  explicit Locations(const std::vector<NamedAtom>& atoms)
  {
    for (const NamedAtom& a : atoms)
    {
      if (!a.AltLoc.empty())
      {
        this->Sums[Place(a)][a.AltLoc] += a.Occupancy;
        this->OfAtom[{ Place(a), a.Name }].insert(a.AltLoc);
      }
    }
  }

  bool IsIncluded(const NamedAtom& a) const
  {
    if (a.AltLoc.empty())
    {
      return true;
    }
    const auto& sums = this->Sums.at(Place(a));
    auto best = sums.begin();
    for (auto at = sums.begin(); at != sums.end(); ++at)
    {
      best = at->second > best->second ? at : best;
    }
    const auto& own = this->OfAtom.at({ Place(a), a.Name });
    // One location for the whole residue; atoms that lack it keep one of their own.
    return a.AltLoc == (own.count(best->first) > 0 ? best->first : *own.begin());
  }

private:
  using Key = std::tuple<std::string, int, std::string>;
  static Key Place(const NamedAtom& a) { return { a.Chain, a.ResidueId, a.InsertionCode }; }

  std::map<Key, std::map<std::string, double>> Sums;
  std::map<std::pair<Key, std::string>, std::set<std::string>> OfAtom;
};

/// Counts of the dropped atoms.
class DroppedAtoms
{
public:
  void Add(Kind kind, const Residue& residue)
  {
    auto& [residues, atoms] = this->Counts[kind][residue.Name];
    ++residues;
    atoms += residue.HeavyAtoms;
  }

  std::vector<std::string> Messages() const
  {
    std::vector<std::string> sentences;
    for (const auto& [kind, names] : this->Counts)
    {
      std::string text = kind == Kind::Water ? "Water was left out:"
        : kind == Kind::Ion                  ? "Ions were left out:"
        : kind == Kind::Prosthetic           ? "Prosthetic groups were left out:"
                                             : "Ligands were left out:";
      const char* separator = " ";
      for (const auto& [name, count] : names)
      {
        text += separator + std::to_string(count.first) + " " + name + " (" +
          std::to_string(count.second) + (count.second == 1 ? " heavy atom)" : " heavy atoms)");
        separator = ", ";
      }
      sentences.push_back(text + ".");
    }
    return sentences;
  }

private:
  std::map<Kind, std::map<std::string, std::pair<std::size_t, std::size_t>>> Counts;
};

}

PolymerChoice ChoosePolymer(const std::vector<NamedAtom>& atoms, const PolymerOptions& options)
{
  std::vector<std::size_t> of;
  std::vector<Residue> residues = Residues(atoms, of);
  bool anyPolymer = false;
  for (Residue& residue : residues)
  {
    // A free amino acid is written as HETATM: it may be the ligand.
    residue.IsPolymer = !residue.IsHetero && StandardResidues().count(residue.Name) > 0;
    anyPolymer = anyPolymer || residue.IsPolymer;
  }
  PropagateAlongChains(atoms, of, residues);
  DroppedAtoms leftOut;
  std::vector<char> kept(residues.size(), 1);
  for (std::size_t r = 0; r < residues.size(); ++r)
  {
    const Kind kind = ClassifyResidue(residues[r], anyPolymer);
    if (!IsIncluded(options, kind) && options.Residues.count(residues[r].Name) == 0)
    {
      kept[r] = 0;
      leftOut.Add(kind, residues[r]);
    }
  }
  const Locations locations(atoms);
  PolymerChoice choice;
  choice.Notes = leftOut.Messages();
  choice.AnyChain = anyPolymer;
  std::size_t hydrogens = 0;
  std::size_t alternates = 0;
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    const bool wanted = kept[of[i]] != 0;
    const bool hydrogen = IsHydrogen(atoms[i]) && !options.Hydrogens;
    const bool here = locations.IsIncluded(atoms[i]);
    hydrogens += wanted && hydrogen ? 1 : 0;
    alternates += wanted && !hydrogen && !here ? 1 : 0;
    if (wanted && !hydrogen && here)
    {
      choice.Kept.push_back(i);
    }
  }
  if (hydrogens > 0)
  {
    choice.Notes.push_back(std::to_string(hydrogens) + " hydrogens were left out.");
  }
  if (alternates > 0)
  {
    choice.Notes.push_back(
      std::to_string(alternates) + " atoms at less occupied alternate locations were left out.");
  }
  return choice;
}

namespace
{

const std::set<std::string>& Nucleotides()
{
  static const std::set<std::string> names{ "A", "C", "G", "U", "I", "DA", "DC", "DG", "DT", "DI",
    "DU", "RA", "RC", "RG", "RU", "ADE", "CYT", "GUA", "URA", "THY" };
  return names;
}

/// What a residue of a chain consists of.
struct ResidueParts
{
  bool HasN = false, HasCA = false, HasC = false;
  bool HasPhosphorus = false, HasSugar = false;
  bool HasMore = false; ///< atoms beyond C-beta, of a base, or of unknown names

  void Add(const std::string& name, bool isNucleotide)
  {
    static const std::set<std::string> backbone{ "N", "CA", "C", "O", "OXT", "OT1", "OT2", "CB" };
    static const std::set<std::string> phosphate{ "P", "OP1", "OP2", "OP3", "O1P", "O2P", "O3P" };
    this->HasN = this->HasN || name == "N";
    this->HasCA = this->HasCA || name == "CA";
    this->HasC = this->HasC || name == "C";
    this->HasPhosphorus = this->HasPhosphorus || name == "P";
    const bool isSugar = !name.empty() && (name.back() == '\'' || name.back() == '*');
    this->HasSugar = this->HasSugar || isSugar;
    this->HasMore = this->HasMore ||
      (isNucleotide ? phosphate.count(name) == 0 && !isSugar : backbone.count(name) == 0);
  }

  bool IsIncomplete(bool isNucleotide, const std::string& residue) const
  {
    if (isNucleotide)
    {
      return !this->HasMore && (this->HasPhosphorus || this->HasSugar);
    }
    const bool isSmall = residue == "GLY" || residue == "ALA";
    return this->HasCA && !this->HasMore && !(isSmall && this->HasN && this->HasC);
  }
};

/// Counts of the residues of one chain.
struct ChainParts
{
  std::size_t Residues = 0, Incomplete = 0, CAOnly = 0, POnly = 0, Nucleotides = 0;
};

}

std::string DescribeMissingSideChains(const std::vector<NamedAtom>& atoms)
{
  std::vector<std::size_t> of;
  const std::vector<Residue> residues = Residues(atoms, of);
  std::map<std::string, ChainParts> chains;
  for (const Residue& residue : residues)
  {
    if (residue.IsHetero || StandardResidues().count(residue.Name) == 0)
    {
      continue;
    }
    const bool isNucleotide = Nucleotides().count(residue.Name) > 0;
    ResidueParts parts;
    for (const std::size_t i : residue.Atoms)
    {
      if (!IsHydrogen(atoms[i]))
      {
        parts.Add(atoms[i].Name, isNucleotide);
      }
    }
    ChainParts& chain = chains[atoms[residue.Atoms.front()].Chain];
    const bool isIncomplete = parts.IsIncomplete(isNucleotide, residue.Name);
    ++chain.Residues;
    chain.Incomplete += isIncomplete ? 1 : 0;
    chain.Nucleotides += isNucleotide ? 1 : 0;
    chain.CAOnly += isIncomplete && !isNucleotide && !parts.HasN && !parts.HasC ? 1 : 0;
    chain.POnly += isIncomplete && isNucleotide && !parts.HasSugar ? 1 : 0;
  }
  constexpr std::size_t fewest = 5;
  constexpr std::size_t mostNamed = 10;
  std::size_t found = 0;
  std::string list;
  for (const auto& [name, chain] : chains)
  {
    if (chain.Residues < fewest || 2 * chain.Incomplete <= chain.Residues || ++found > mostNamed)
    {
      continue;
    }
    const char* what = 2 * chain.CAOnly > chain.Incomplete ? "only C-alpha"
      : 2 * chain.POnly > chain.Incomplete                 ? "only phosphates"
                                                           : "only the backbone";
    list += (list.empty() ? "" : ", ") + (name.empty() ? std::string() : "chain " + name + ": ") +
      what + " of " + std::to_string(chain.Incomplete) + " of " + std::to_string(chain.Residues) +
      " residues";
  }
  return list.empty()
    ? list
    : "Side chains or bases are missing (" + list + (found > mostNamed ? ", ..." : "") +
      "), so pockets, pores and surfaces are not those of the molecule: use a complete model, or "
      "build the side chains first.";
}

}
