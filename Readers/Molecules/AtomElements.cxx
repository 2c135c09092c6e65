#include "Molecules/AtomElements.h"

#include "Atoms/ChemicalElement.h"
#include "Atoms/NameLetters.h"
#include "Core/ParallelFor.h"
#include "Files/TextLines.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <mutex>
#include <string>
#include <unordered_map>
#include <unordered_set>

namespace isthmus
{
namespace
{

using Names = std::unordered_set<std::string_view>;

// ------------------------------------------------------------------------------------------
// Residues

/// The twenty amino acids, and their protonation states and bonds in force fields.
const Names& StandardAminoAcids()
{
  static const Names names{ "ALA", "ARG", "ASN", "ASP", "CYS", "GLN", "GLU", "GLY", "HIS", "ILE",
    "LEU", "LYS", "MET", "PHE", "PRO", "SER", "THR", "TRP", "TYR", "VAL", "HID", "HIE", "HIP",
    "HSD", "HSE", "HSP", "CYX", "CYM", "CYN", "ASH", "GLH", "LYN", "ARN", "TYM", "LSN", "ARGN",
    "ASPH", "GLUH", "CYSH", "CYS1", "CYS2", "CYSD", "CYSF", "HISA", "HISB", "HISH", "HIS1", "HIS2",
    "HISD", "HISE", "HISP", "LYSH", "LYSP", "ARGP", "ASPP", "GLUP", "ASP1", "GLU1", "LYS1" };
  return names;
}

/// Modified ones, and caps of chains.
const Names& OtherAminoAcids()
{
  static const Names names{ "ASX", "GLX", "SEC", "PYL", "MSE", "SEP", "TPO", "PTR", "CSO", "CSD",
    "CME", "HYP", "MLY", "M3L", "KCX", "LLP", "PCA", "FME", "ACE", "NME", "NMA", "NH2", "NHE",
    "FOR", "CT1", "CT2", "CT3", "ORN", "NLE", "AIB", "DAL", "DLE", "DVA", "DTR", "ETA" };
  return names;
}

const Names& Nucleotides()
{
  static const Names names{ "A", "C", "G", "T", "U", "I", "DA", "DC", "DG", "DT", "DU", "DI", "RA",
    "RC", "RG", "RU", "ADE", "CYT", "GUA", "URA", "THY" };
  return names;
}

const Names& OtherWaters()
{
  static const Names names{ "TIP5", "TP5", "T5P", "OPC", "OPC3", "SWM4", "SWM6", "TP3M", "TIPS",
    "TIP2", "SPCF", "HO4", "HO5", "TIP4EW" };
  return names;
}

/// Tails of phospholipids, and heads (CHARMM, Slipids, Martini).
const Names& LipidTails()
{
  static const Names names{ "DA", "DB", "DC", "DD", "DE", "DF", "DG", "DI", "DL", "DM", "DN", "DO",
    "DP", "DR", "DS", "DT", "DU", "DV", "DX", "DY", "LP", "OP", "OS", "PA", "PD", "PE", "PI", "PL",
    "PO", "PS", "PU", "PV", "SA", "SD", "SE", "SI", "SL", "SO", "SP", "SU", "SV" };
  return names;
}
constexpr std::string_view LipidHeads = "ACEGIS";

const Names& OtherLipids()
{
  static const Names names{ "CHL1", "CHOL", "CLR", "CHLO", "ERG", "PSM", "SSM", "DPSM", "POSM",
    "CER1", "TMCL", "TOCL", "TLCL", "CARD", "LPPC", "LAUR", "PALM", "OLEO", "STEA", "PA", "OL",
    "MY", "LAL", "DHPC", "DIPC", "DYPC", "DFPC", "DUPC", "SDS", "DPC", "DDM" };
  return names;
}

/// Residues with a metal, and that element. Their other atoms have symbols of one letter.
const std::unordered_map<std::string_view, int>& Cofactors()
{
  static const std::unordered_map<std::string_view, int> metals{ { "HEM", 26 }, { "HEME", 26 },
    { "HEA", 26 }, { "HEB", 26 }, { "HEC", 26 }, { "HEO", 26 }, { "HAS", 26 }, { "SRM", 26 },
    { "HDD", 26 }, { "DHE", 26 }, { "SF4", 26 }, { "FES", 26 }, { "F3S", 26 }, { "FS4", 26 },
    { "CLF", 26 }, { "FEO", 26 }, { "CLA", 12 }, { "CHL", 12 }, { "CL0", 12 }, { "BCL", 12 },
    { "BCB", 12 }, { "B12", 27 }, { "CNC", 27 }, { "COB", 27 }, { "F43", 28 }, { "ATP", 0 },
    { "ADP", 0 }, { "AMP", 0 }, { "ANP", 0 }, { "ACP", 0 }, { "GTP", 0 }, { "GDP", 0 },
    { "GMP", 0 }, { "GNP", 0 }, { "CTP", 0 }, { "UTP", 0 }, { "TTP", 0 }, { "NAD", 0 },
    { "NAI", 0 }, { "NAP", 0 }, { "NDP", 0 }, { "FAD", 0 }, { "FMN", 0 }, { "COA", 0 },
    { "ACO", 0 }, { "SAM", 0 }, { "SAH", 0 }, { "PLP", 0 }, { "TPP", 0 }, { "BTN", 0 },
    { "H4B", 0 }, { "THF", 0 }, { "FOL", 0 }, { "RET", 0 }, { "PQN", 0 }, { "UQ1", 0 },
    { "U10", 0 }, { "NAG", 0 }, { "NDG", 0 }, { "BMA", 0 }, { "MAN", 0 }, { "GLC", 0 },
    { "BGC", 0 }, { "GAL", 0 }, { "GLA", 0 }, { "FUC", 0 }, { "SIA", 0 }, { "SUC", 0 },
    { "GOL", 0 }, { "EDO", 0 }, { "PEG", 0 }, { "SO4", 0 }, { "PO4", 0 }, { "ACT", 0 },
    { "DMS", 0 }, { "MPD", 0 }, { "TRS", 0 }, { "EPE", 0 }, { "CIT", 0 }, { "FMT", 0 } };
  return metals;
}

bool IsLipid(std::string_view name)
{
  return OtherLipids().count(name) > 0 ||
    (name.size() == 4 && name[2] == 'P' && LipidTails().count(name.substr(0, 2)) > 0 &&
      LipidHeads.find(name[3]) != std::string_view::npos);
}

/// "NALA" and "CALA" of AMBER.
bool IsTerminalAminoAcid(std::string_view name)
{
  return name.size() == 4 && (name[0] == 'N' || name[0] == 'C') &&
    StandardAminoAcids().count(name.substr(1)) > 0;
}

bool IsStandardAminoAcid(std::string_view name)
{
  return StandardAminoAcids().count(name) > 0 || IsTerminalAminoAcid(name);
}

/// "DA5", "RU3", "DGN" of AMBER: ends of chains.
bool IsTerminalNucleotide(std::string_view name)
{
  return (name.size() == 2 || name.size() == 3) &&
    (name.back() == '5' || name.back() == '3' || (name.back() == 'N' && name.size() == 3)) &&
    Nucleotides().count(name.substr(0, name.size() - 1)) > 0;
}

/// All but the non-metals with covalent bonds: metals, noble gases and elements that no molecule
/// has.
bool IsMetal(int element)
{
  constexpr int nonMetals[] = { 1, 5, 6, 7, 8, 9, 14, 15, 16, 17, 33, 34, 35, 53 };
  return std::find(std::begin(nonMetals), std::end(nonMetals), element) == std::end(nonMetals);
}

/// Can a residue of this family contain the element? The twenty amino acids, nucleotides and water
/// have few; modified residues, lipids and cofactors no metals but that of the cofactor.
/// `isStandard`: one of the twenty.
bool Contains(ResidueFamily family, bool isStandard, int element)
{
  constexpr int firstShortLived = 100; // fermium and all that follow, oganesson among them
  const auto isOneOf = [element](std::initializer_list<int> elements)
  { return std::find(elements.begin(), elements.end(), element) != elements.end(); };
  switch (family)
  {
    case ResidueFamily::AminoAcid:
      return isStandard ? isOneOf({ 1, 6, 7, 8, 15, 16, 34 }) : !IsMetal(element);
    case ResidueFamily::Nucleotide:
      return isOneOf({ 1, 6, 7, 8, 9, 15, 16, 34, 35, 53 });
    case ResidueFamily::Water:
      return isOneOf({ 1, 8 });
    case ResidueFamily::Lipid:
      return !IsMetal(element);
    default:
      return element < firstShortLived;
  }
}

// ------------------------------------------------------------------------------------------
// What is no element

/// Ghost atoms, dummies, lone pairs and virtual sites, by name or symbol.
bool IsDummy(std::string_view letters)
{
  static const Names names{ "X", "XX", "BQ", "GH", "DU", "DUM", "LP", "LPA", "LPB", "EP", "EPW",
    "MW", "VS", "VIS", "GHO", "Q" };
  return names.count(letters) > 0;
}

/// Names of beads in Martini residues that atomistic residues do not have.
bool IsBead(ResidueFamily family, std::string_view name, std::string_view residue)
{
  static const Names lipid{ "NC3", "NH3", "PO4", "CNO", "GL0", "GL1", "GL2", "AM1", "AM2", "ROH",
    "GLC", "PO1", "PO2" };
  static const Names waters{ "W", "WF", "PW", "SW", "TW", "WN" };
  static const Names nucleotide{ "BB1", "BB2", "BB3" };
  switch (family)
  {
    case ResidueFamily::AminoAcid:
      return name == "BB" || name == "BAS";
    case ResidueFamily::Lipid:
      return lipid.count(name) > 0;
    case ResidueFamily::Nucleotide:
      return nucleotide.count(name) > 0;
    default:
      return waters.count(residue) > 0;
  }
}

// ------------------------------------------------------------------------------------------
// Elements

/// The element in columns 77-78: a symbol of one or two letters, 0 if there is none.
int ElementFromColumns(const AtomColumns& columns)
{
  std::string_view symbol = Trim({ columns.Symbol.data(), columns.Symbol.size() });
  if (symbol.size() == 2 && !IsLetter(symbol[1]))
  {
    symbol.remove_suffix(1); // the charge of "N1+", one column off
  }
  return ElementFromSymbol(symbol);
}

/// Where names are right-justified as the format has them: the element by columns 13-14.
int ElementFromNameColumns(const AtomColumns& columns)
{
  const auto& c = columns.Name;
  if (c[0] == ' ')
  {
    return ElementFromSymbol({ &c[1], 1 });
  }
  if (!IsLetter(c[0]) || !IsLetter(c[1]) || c[3] != ' ')
  {
    return 0; // names of four letters fill all columns
  }
  const int element = ElementFromSymbol({ c.data(), 2 });
  return Contains(ResidueFamily::Unknown, false, element) ? element : 0;
}

int FindElementInFamily(ResidueFamily family, std::string_view residue, std::string_view name)
{
  const std::string letters = Capitals(FirstLetters(name));
  if (letters.empty())
  {
    return 0;
  }
  const auto isOneOf = [&letters](std::string_view symbols)
  { return symbols.find(letters[0]) != std::string_view::npos; };
  const int single = ElementFromSymbol(std::string_view(letters).substr(0, 1));
  switch (family)
  {
    case ResidueFamily::AminoAcid:
      if (letters == "SE" && !IsStandardAminoAcid(residue))
      {
        return 34;
      }
      return isOneOf("HDCNOPS") ? single : 0;
    case ResidueFamily::Nucleotide:
    case ResidueFamily::Lipid:
      return isOneOf("HDCNOPS") ? single : 0;
    case ResidueFamily::Water:
      return isOneOf("HDO") ? single : 0;
    case ResidueFamily::Cofactor:
    {
      const int metal = Cofactors().at(residue);
      const bool isMetal = metal > 0 && letters == Capitals(ElementSymbol(metal));
      return isMetal ? metal : (isOneOf("HDCNOPSF") ? single : 0);
    }
    default:
      return 0;
  }
}

enum class Method
{
  Column,
  Residue,
  NameColumns,
  NameLetters,
  Bead,
  Dummy,
  None ///< not an element, for all that is known
};

constexpr const char* Dummies = "Ghost or dummy atoms and virtual sites";

void WarnAbout(const char* what, std::size_t atoms, ReadingReport& report)
{
  if (atoms > 0)
  {
    report.Warn(
      what + std::string(", without element (0) and radius: ") + std::to_string(atoms) + ".");
  }
}

/// Determines the elements residue by residue, using information from the whole file.
class Decision
{
public:
  Decision(std::vector<Atom>& atoms, const std::vector<AtomColumns>& columns,
    const std::vector<std::size_t>& starts, ElementColumn column)
    : Atoms(atoms)
    , Columns(columns)
    , Starts(starts)
    , Where(column == ElementColumn::PDB ? "in columns 77-78" : "in the file")
    , IsUsual(column == ElementColumn::None)
    , Methods(atoms.size(), Method::Column)
  {
  }

  void Run(ReadingReport& report)
  {
    this->TakeColumns();
    std::vector<std::size_t> open; // residues with atoms that are not decided
    for (std::size_t r = 0; r < this->Starts.size(); ++r)
    {
      const auto begin = this->Methods.begin() + static_cast<std::ptrdiff_t>(this->Starts[r]);
      const auto end = this->Methods.begin() + static_cast<std::ptrdiff_t>(this->End(r));
      if (std::find(begin, end, Method::None) != end)
      {
        open.push_back(r);
      }
    }
    if (!open.empty())
    {
      this->Survey(open);
      for (const std::size_t r : open)
      {
        this->DecideResidue(r);
      }
    }
    if (!open.empty() || this->Absurd > 0)
    {
      this->Report(report);
    }
    if (this->Absurd > 0)
    {
      report.Warn("Elements " + this->Where +
        " that the residue does not contain: " + std::to_string(this->Absurd) +
        " (first: " + ElementSymbol(ElementFromColumns(this->Columns[this->FirstAbsurd])) +
        " for " + Describe(this->Atoms[this->FirstAbsurd]) + ").");
    }
  }

private:
  std::size_t End(std::size_t residue) const
  {
    return residue + 1 < this->Starts.size() ? this->Starts[residue + 1] : this->Atoms.size();
  }

  /// Elements that the file gives. All other atoms are marked None.
  void TakeColumns()
  {
    constexpr std::int64_t residuesAtOnce = 1 << 12;
    ParallelFor(0, static_cast<std::int64_t>(this->Starts.size()), residuesAtOnce,
      [this](std::int64_t first, std::int64_t last)
      {
        for (auto r = static_cast<std::size_t>(first); r < static_cast<std::size_t>(last); ++r)
        {
          this->TakeColumns(r);
        }
      });
  }

  void TakeColumns(std::size_t residue)
  {
    const std::string& name = this->Atoms[this->Starts[residue]].ResidueName;
    const ResidueFamily family = FindResidueFamily(name);
    const bool isStandard = family == ResidueFamily::AminoAcid && IsStandardAminoAcid(name);
    const bool isDummy = name == "DUM";
    for (std::size_t i = this->Starts[residue]; i < this->End(residue); ++i)
    {
      int element = isDummy ? 0 : ElementFromColumns(this->Columns[i]);
      if (element > 0 && !Contains(family, isStandard, element))
      {
        this->AddAbsurd(i);
        const int other = FindElementInFamily(family, name, this->Atoms[i].Name);
        this->Methods[i] = other > 0 ? Method::Residue : Method::None;
        element = other;
      }
      else if (element == 0)
      {
        this->Methods[i] = Method::None;
      }
      this->Atoms[i].Element = element;
    }
  }

  /// Counts impossible elements, and records the first one.
  void AddAbsurd(std::size_t atom)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    ++this->Absurd;
    this->FirstAbsurd = std::min(this->FirstAbsurd, atom);
  }

  /// Whether names are right-justified, and whether there are beads instead of atoms.
  void Survey(const std::vector<std::size_t>& residues)
  {
    std::size_t beads = 0;
    std::size_t others = 0;
    std::size_t right = 0; // of known residues, with symbols of one letter
    std::size_t left = 0;
    std::size_t anyRight = 0;
    for (const std::size_t r : residues)
    {
      const ResidueFamily family = FindResidueFamily(this->Atoms[this->Starts[r]].ResidueName);
      const bool isBead = this->HasBead(r, family);
      (isBead ? beads : others) += this->End(r) - this->Starts[r];
      for (std::size_t i = this->Starts[r]; i < this->End(r); ++i)
      {
        const auto& c = this->Columns[i].Name;
        const bool isShort = c[3] == ' ' && (c[0] == ' ' || IsLetter(c[0]));
        anyRight += isShort && c[0] == ' ' ? 1 : 0;
        if (isShort && family != ResidueFamily::Unknown && family != ResidueFamily::Cofactor)
        {
          (c[0] == ' ' ? right : left) += 1;
        }
      }
    }
    this->IsCoarse = beads > 0 && beads >= others;
    this->IsRightJustified = right + left > 0 ? right > left : anyRight > 0;
  }

  bool HasBead(std::size_t residue, ResidueFamily family) const
  {
    for (std::size_t i = this->Starts[residue]; i < this->End(residue); ++i)
    {
      if (this->Methods[i] == Method::None &&
        IsBead(family, this->Atoms[i].Name, this->Atoms[i].ResidueName))
      {
        return true;
      }
    }
    return false;
  }

  bool HasOneName(std::size_t residue) const
  {
    const std::string& first = this->Atoms[this->Starts[residue]].Name;
    return std::all_of(this->Atoms.begin() + static_cast<std::ptrdiff_t>(this->Starts[residue]),
      this->Atoms.begin() + static_cast<std::ptrdiff_t>(this->End(residue)),
      [&first](const Atom& atom) { return atom.Name == first; });
  }

  void DecideResidue(std::size_t residue)
  {
    const std::string& name = this->Atoms[this->Starts[residue]].ResidueName;
    const ResidueFamily family = FindResidueFamily(name);
    const bool isCoarse = this->IsCoarse || this->HasBead(residue, family);
    const bool mayBeIon = family == ResidueFamily::Unknown || this->HasOneName(residue);
    for (std::size_t i = this->Starts[residue]; i < this->End(residue); ++i)
    {
      if (this->Methods[i] != Method::None)
      {
        continue;
      }
      Atom& atom = this->Atoms[i];
      const std::string letters = Capitals(FirstLetters(atom.Name));
      const std::string symbol =
        Capitals(Trim({ this->Columns[i].Symbol.data(), this->Columns[i].Symbol.size() }));
      const auto set = [&](int element, Method way)
      {
        atom.Element = element;
        this->Methods[i] = element > 0 ? way : Method::None;
      };
      if (isCoarse)
      {
        this->Methods[i] = Method::Bead;
      }
      else if (name == "DUM" || IsDummy(symbol) ||
        (IsDummy(letters) && FindElementInFamily(family, name, atom.Name) == 0) ||
        (family == ResidueFamily::Water && FindElementInFamily(family, name, atom.Name) == 0))
      {
        this->Methods[i] = Method::Dummy;
      }
      else if (const int ion = mayBeIon ? ElementFromIon(atom.Name, name) : 0;
               this->IsPlausible(ion, i))
      {
        set(ion, Method::Residue);
      }
      else if (family != ResidueFamily::Unknown)
      {
        set(FindElementInFamily(family, name, atom.Name), Method::Residue);
      }
      else if (const int byColumns =
                 this->IsRightJustified ? ElementFromNameColumns(this->Columns[i]) : 0;
               this->IsPlausible(byColumns, i))
      {
        set(byColumns, Method::NameColumns);
      }
      else
      {
        const int metal = this->CoordinatedMetal(i);
        const int byLetters = metal > 0 ? metal : ElementFromAtomName(atom.Name, name);
        set(byLetters == 0 || this->IsPlausible(byLetters, i)
            ? byLetters
            : ElementFromSymbol(std::string_view(letters).substr(0, 1)),
          Method::NameLetters);
      }
    }
  }

  /// Whether an element that a name can mean is likely: a metal whose name also begins with the
  /// symbol of H, C, N, O, P or S (CA, CD, HG, NA, ...) has no neighbour as near as in a bond of
  /// these.
  bool IsPlausible(int element, std::size_t atom) const
  {
    const std::string letters = Capitals(FirstLetters(this->Atoms[atom].Name));
    if (element == 0 || !IsMetal(element) ||
      std::string_view("HCNOPS").find(letters[0]) == std::string_view::npos)
    {
      return element > 0;
    }
    return this->Near(atom, LongestBond) == 0;
  }

  /// The metal that the name of an atom means which is as far from others of its residue as metals
  /// are from their ligands (CO of a cobalamin, IR of a hexammine), where names are not
  /// right-justified. 0: no metal.
  int CoordinatedMetal(std::size_t atom) const
  {
    constexpr double longestToLigand = 2.8;
    constexpr std::size_t fewestLigands = 2;
    const std::string& name = this->Atoms[atom].Name;
    if (name.size() != 2 || FirstLetters(name).size() != 2)
    {
      return 0;
    }
    const int element = ElementFromSymbol(name);
    return IsMetal(element) && Contains(ResidueFamily::Unknown, false, element) &&
        this->Near(atom, LongestBond) == 0 && this->Near(atom, longestToLigand) >= fewestLigands
      ? element
      : 0;
  }

  static constexpr double LongestBond = 1.75; ///< C-S is 1.8, Mg-O and Zn-N 1.95 and more

  /// How many atoms of its residue are nearer to an atom.
  std::size_t Near(std::size_t atom, double distance) const
  {
    constexpr std::size_t farthest = 500; // atoms of large residues are near those they follow
    const auto next = std::upper_bound(this->Starts.begin(), this->Starts.end(), atom);
    const auto residue = static_cast<std::size_t>(next - this->Starts.begin()) - 1;
    const std::size_t begin = std::max(this->Starts[residue], atom - std::min(atom, farthest));
    const std::size_t end = std::min(this->End(residue), atom + farthest);
    std::size_t near = 0;
    for (std::size_t i = begin; i < end; ++i)
    {
      double squared = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double d = this->Atoms[i].Position[axis] - this->Atoms[atom].Position[axis];
        squared += d * d;
      }
      near += i != atom && squared < distance * distance ? 1 : 0;
    }
    return near;
  }

  void Report(ReadingReport& report) const
  {
    std::size_t counts[static_cast<std::size_t>(Method::None) + 1] = {};
    const Atom* unknown = nullptr;
    for (std::size_t i = 0; i < this->Atoms.size(); ++i)
    {
      ++counts[static_cast<std::size_t>(this->Methods[i])];
      unknown = this->Methods[i] == Method::None && !unknown ? &this->Atoms[i] : unknown;
    }
    const auto count = [&counts](Method way) { return counts[static_cast<std::size_t>(way)]; };
    std::string ways;
    std::size_t decided = 0;
    const auto add = [&](std::size_t atoms, const char* how)
    {
      ways += atoms > 0 ? (ways.empty() ? " " : ", ") + std::to_string(atoms) + how : "";
      decided += atoms;
    };
    add(count(Method::Residue), " by residue and atom name");
    add(count(Method::NameColumns), " by the columns of the name");
    add(count(Method::NameLetters), " by the letters of the name");
    if (decided > 0)
    {
      const std::string sentence = "Atoms without a usable element " + this->Where + ": " +
        std::to_string(decided) + "; decided" + ways + ".";
      this->IsUsual ? report.Note(sentence) : report.Warn(sentence);
    }
    WarnAbout("Beads of a coarse-grained model (Martini)", count(Method::Bead), report);
    WarnAbout(Dummies, count(Method::Dummy), report);
    if (unknown)
    {
      report.Warn("Atoms whose names match no element (Element is 0): " +
        std::to_string(count(Method::None)) + " (first: " + Describe(*unknown) + ").");
    }
  }

  std::vector<Atom>& Atoms;
  const std::vector<AtomColumns>& Columns;
  const std::vector<std::size_t>& Starts;
  std::string Where;
  bool IsUsual;
  std::vector<Method> Methods;
  std::mutex Mutex;
  std::size_t Absurd = 0;
  std::size_t FirstAbsurd = static_cast<std::size_t>(-1);
  bool IsCoarse = false;
  bool IsRightJustified = true;
};

}

ResidueFamily FindResidueFamily(std::string_view name)
{
  static const std::unordered_map<std::string_view, ResidueFamily> named = []
  {
    std::unordered_map<std::string_view, ResidueFamily> families;
    const auto add = [&families](const Names& names, ResidueFamily family)
    {
      for (const std::string_view one : names)
      {
        families.emplace(one, family);
      }
    };
    add(StandardAminoAcids(), ResidueFamily::AminoAcid);
    add(OtherAminoAcids(), ResidueFamily::AminoAcid);
    add(Nucleotides(), ResidueFamily::Nucleotide);
    add(OtherWaters(), ResidueFamily::Water);
    for (const auto& [cofactor, metal] : Cofactors())
    {
      families.emplace(cofactor, ResidueFamily::Cofactor);
    }
    return families;
  }();
  const auto found = named.find(name);
  if (found != named.end())
  {
    return found->second;
  }
  if (IsTerminalAminoAcid(name) || IsTerminalNucleotide(name))
  {
    return IsTerminalAminoAcid(name) ? ResidueFamily::AminoAcid : ResidueFamily::Nucleotide;
  }
  return IsWater(name) ? ResidueFamily::Water
    : IsLipid(name)    ? ResidueFamily::Lipid
                       : ResidueFamily::Unknown;
}

bool IsLongResidueName(std::string_view name)
{
  return name.size() == 4 && FindResidueFamily(name) != ResidueFamily::Unknown;
}

bool IsDummyName(std::string_view name)
{
  const std::string capitals = Capitals(name);
  const auto ends = [&capitals](std::string_view with)
  {
    return capitals.size() > with.size() &&
      capitals.compare(capitals.size() - with.size(), with.size(), with) == 0;
  };
  return IsDummy(FirstLetters(capitals)) || ends("-BQ") || ends("_BQ") ||
    capitals.compare(0, 2, "BQ") == 0 || (!capitals.empty() && capitals[0] == '@');
}

void SetElements(std::vector<Atom>& atoms, const std::vector<AtomColumns>& columns,
  const std::vector<std::size_t>& starts, ReadingReport& report, ElementColumn column)
{
  Decision(atoms, columns, starts, column).Run(report);
}

void SetElements(std::vector<Atom>& atoms, ReadingReport& report, ElementColumn column,
  const std::vector<bool>& isDummy)
{
  std::vector<AtomColumns> columns(atoms.size());
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    const Atom& atom = atoms[i];
    const bool isSame = i > 0 && atom.ResidueId == atoms[i - 1].ResidueId &&
      atom.InsertionCode == atoms[i - 1].InsertionCode &&
      atom.ResidueName == atoms[i - 1].ResidueName && atom.Chain == atoms[i - 1].Chain;
    if (!isSame)
    {
      starts.push_back(i);
    }
    std::string_view(atom.Name).copy(columns[i].Name.data(), columns[i].Name.size());
    if (atom.Element > 0)
    {
      std::string_view(ElementSymbol(atom.Element))
        .copy(columns[i].Symbol.data(), columns[i].Symbol.size());
    }
    else if (!isDummy.empty() && isDummy[i])
    {
      columns[i].Symbol = { ' ', 'X' };
    }
  }
  SetElements(atoms, columns, starts, report, column);
}

void ReportMissingElements(const std::vector<Atom>& atoms, ReadingReport& report)
{
  std::size_t dummies = 0;
  std::size_t unknown = 0;
  const Atom* first = nullptr;
  for (const Atom& atom : atoms)
  {
    if (atom.Element == 0)
    {
      const bool isDummy = IsDummyName(atom.Name);
      dummies += isDummy ? 1 : 0;
      unknown += isDummy ? 0 : 1;
      first = first || isDummy ? first : &atom;
    }
  }
  WarnAbout(Dummies, dummies, report);
  if (first)
  {
    report.Warn("Atoms whose types or symbols match no element (Element is 0): " +
      std::to_string(unknown) + " (first: " + Describe(*first) + ").");
  }
}

}
