// MOL2 (Tripos): MOLECULE, ATOM and BOND sections; elements from the types, charges unless the
// molecule says NO_CHARGES, bonds of the file. Each molecule is a model.

#include "Atoms/ChemicalElement.h"
#include "Molecules/AtomElements.h"
#include "Molecules/MoleculeFields.h"

#include <algorithm>
#include <unordered_map>

namespace isthmus
{
namespace
{

/// "C.ar" is carbon; "Du" and "LP" are no element; "Cl" is chlorine.
int ElementFromTriposType(std::string_view type)
{
  return ElementFromSymbol(type.substr(0, type.find('.')));
}

/// Whether this is one of SYBYL's types: an element symbol, with or without a suffix, or a dummy.
/// AMBER's "ca", "CT" and "os" are not.
bool IsTriposType(std::string_view type)
{
  constexpr std::array<std::string_view, 6> others{ "Du", "LP", "Hal", "Het", "Hev", "Any" };
  const std::string_view head = type.substr(0, type.find('.'));
  const int element = ElementFromSymbol(head);
  return std::find(others.begin(), others.end(), head) != others.end() ||
    (element > 0 && (head == ElementSymbol(element) || head == "D" || head == "T"));
}

Atom ReadMOL2Atom(std::string_view line, bool hasCharges, std::string& otherType,
  const TextLines& lines, ReadingReport& report)
{
  Atom atom;
  IsNumber(NextWord(line), atom.Serial);
  atom.Name = NextWord(line);
  for (double& x : atom.Position)
  {
    x = FiniteNumber(NextWord(line), lines, "a coordinate");
  }
  const std::string_view type = NextWord(line);
  if (type.empty())
  {
    lines.Fail("the type of an atom is missing. The file may be truncated.");
  }
  atom.Element = ElementFromTriposType(type);
  if (otherType.empty() && !IsTriposType(type))
  {
    otherType = type;
  }
  atom.ResidueId = IntegerOrZero(NextWord(line), OddResidueNumbers, lines, report);
  const std::string_view residue = NextWord(line);
  atom.ResidueName = residue == "****" || residue == "<0>" ? std::string_view() : residue;
  if (hasCharges)
  {
    atom.Charge = NumberOrUnknown(NextWord(line), OddCharges, lines, report);
  }
  return atom;
}

/// The contents of a molecule of a MOL2 file, and how much of it has been read.
struct MOL2Counts
{
  std::int64_t Atoms = 0, Bonds = 0;
  bool HasAtoms = false, HasBonds = false;
  bool HasCharges = true;

  void Check(const TextLines& lines) const
  {
    if ((this->Atoms > 0 && !this->HasAtoms) || (this->Bonds > 0 && !this->HasBonds))
    {
      lines.Fail("a molecule ends without its " +
        (this->HasAtoms ? std::to_string(this->Bonds) + " bonds"
                        : std::to_string(this->Atoms) + " atoms") +
        ". The file may be truncated: fetch or write it again.");
    }
  }
};

/// Refuses the last line of a file if it ends before the words of the line before, or `fewest`.
void CheckWhole(std::string_view line, std::size_t fewest, const TextLines& lines)
{
  if (lines.IsUnfinished() && CountWords(line) < fewest)
  {
    lines.Fail("the file ends within this line. Fetch or write it again.");
  }
}

/// SYBYL names substructures by residue and number ("ALA12"), others by the residue alone, which
/// may end in a digit itself ("DC5" of AMBER, "SO4").
void SplitNamesOfResidues(std::vector<Atom>& atoms)
{
  const auto digitsOf = [](const std::string& name)
  { return name.find_last_not_of("0123456789") + 1; };
  const auto hasNumber = [&digitsOf](const Atom& atom)
  {
    const std::size_t digits = digitsOf(atom.ResidueName);
    return digits > 0 && digits < atom.ResidueName.size();
  };
  if (!std::all_of(atoms.begin(), atoms.end(), hasNumber))
  {
    return;
  }
  const bool isOne = std::all_of(atoms.begin(), atoms.end(),
    [&atoms](const Atom& atom) { return atom.ResidueName == atoms[0].ResidueName; });
  for (Atom& atom : atoms)
  {
    const std::size_t digits = digitsOf(atom.ResidueName);
    const ResidueFamily family = FindResidueFamily(atom.ResidueName);
    const bool isWhole =
      isOne && family != ResidueFamily::Unknown && family != ResidueFamily::AminoAcid;
    int number = 0;
    if (!isWhole && IsNumber(std::string_view(atom.ResidueName).substr(digits), number))
    {
      atom.ResidueId = number;
      atom.ResidueName.resize(digits);
    }
  }
}

}

bool IsMOL2(std::string_view text)
{
  return text.find("@<TRIPOS>MOLECULE") != std::string_view::npos;
}

Macromolecule ParseMOL2(std::string_view text, const std::string& path,
  const StructureChoice& choice, const ProgressCallback& progress)
{
  Macromolecule molecule;
  ReadingReport report;
  ReadingReport ofOthers;
  TextLines lines(text, path, progress);
  MOL2Counts counted;
  std::unordered_map<std::int64_t, std::int64_t> place; // of the numbers of atoms
  std::string notRead;                                  // sections
  std::string otherType;                                // the first one that is not a SYBYL type
  std::string_view line;
  while (lines.Next(line))
  {
    const std::string_view section = Trim(line);
    const bool isWanted = molecule.NumberOfModels - 1 == choice.Model;
    if (section == "@<TRIPOS>MOLECULE")
    {
      counted.Check(lines);
      counted = {};
      ++molecule.NumberOfModels;
      NextLine(lines); // the name
      std::string_view counts = NextLine(lines);
      counted.Atoms = ReadCount(NextWord(counts), lines, "the number of atoms");
      const std::string_view second = NextWord(counts);
      counted.Bonds = second.empty() ? 0 : ReadCount(second, lines, "the number of bonds");
      NextLine(lines); // the kind of molecule
      counted.HasCharges = Trim(NextLine(lines)) != "NO_CHARGES";
    }
    else if (section == "@<TRIPOS>ATOM")
    {
      counted.HasAtoms = true;
      std::size_t words = 0; // of the atom before
      for (std::int64_t i = 0; i < counted.Atoms; ++i)
      {
        std::string ignored;
        const std::string_view row = NextLine(lines);
        CheckWhole(row, words, lines);
        words = CountWords(row);
        Atom atom = ReadMOL2Atom(row, counted.HasCharges, isWanted ? otherType : ignored, lines,
          isWanted ? report : ofOthers);
        if (isWanted)
        {
          place.emplace(atom.Serial, static_cast<std::int64_t>(molecule.Atoms.size()));
          molecule.Atoms.push_back(std::move(atom));
        }
      }
    }
    else if (section == "@<TRIPOS>BOND")
    {
      counted.HasBonds = true;
      for (std::int64_t i = 0; i < counted.Bonds; ++i)
      {
        std::string_view bond = NextLine(lines);
        constexpr std::size_t wordsOfBond = 4; // its number, two atoms, its type
        CheckWhole(bond, wordsOfBond, lines);
        if (isWanted)
        {
          NextWord(bond); // its number
          const auto first = FindAtomIndex(NextWord(bond), place);
          AddBond(molecule, first, FindAtomIndex(NextWord(bond), place), lines, report);
        }
      }
    }
    else if (isWanted && BeginsWith(section, "@<TRIPOS>") && section != "@<TRIPOS>SUBSTRUCTURE")
    {
      notRead += (notRead.empty() ? "" : ", ") + std::string(section.substr(9));
    }
  }
  counted.Check(lines);
  if (!notRead.empty())
  {
    report.Note("Sections of the MOL2 file that were not read: " + notRead + ".");
  }
  SplitNamesOfResidues(molecule.Atoms);
  if (otherType.empty())
  {
    ReportMissingElements(molecule.Atoms, report);
  }
  else
  {
    report.Note("The types of atoms are those of a force field, not SYBYL's (first: " + otherType +
      "): elements from the names.");
    for (Atom& atom : molecule.Atoms)
    {
      atom.Element = 0;
    }
    SetElements(molecule.Atoms, report, ElementColumn::None);
  }
  report.AddTo(molecule);
  return molecule;
}

}
