#include "Molecules/ExchangeFormats.h"

#include "Atoms/ChemicalElement.h"
#include "Files/TextLines.h"
#include "Molecules/AtomElements.h"
#include "Molecules/PDBColumns.h"
#include "Molecules/ReadingReport.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

namespace isthmus
{
namespace
{

bool BeginsWith(std::string_view line, std::string_view with)
{
  return line.substr(0, with.size()) == with;
}

double FiniteNumber(std::string_view word, const TextLines& lines, const char* what)
{
  double value = 0.0;
  if (!IsNumber(word, value) || !std::isfinite(value))
  {
    lines.Fail(std::string(what) + " is expected where '" + std::string(word.substr(0, 30)) +
      "' is. The file may be truncated, or its name may not match its content.");
  }
  return value;
}

std::int64_t Count(std::string_view word, const TextLines& lines, const char* what)
{
  std::int64_t value = 0;
  if (!IsNumber(word, value) || value < 0)
  {
    lines.Fail(std::string(what) + " is expected where '" + std::string(word.substr(0, 30)) +
      "' is. The file may be truncated, or its name may not match its content.");
  }
  return value;
}

std::string_view NextLine(TextLines& lines)
{
  std::string_view line;
  if (!lines.Next(line))
  {
    lines.Fail("the file ends within a molecule. Fetch or write it again.");
  }
  return line;
}

/// The whole number that `word` is, 0 and counted where it is none and not empty.
int IntegerOrZero(
  std::string_view word, const char* what, const TextLines& lines, ReadingReport& report)
{
  int value = 0;
  if (!word.empty() && !IsNumber(word, value))
  {
    report.Count(what, lines.Line());
  }
  return value;
}

/// The number that `word` is, unknown and counted where it is none and not empty.
double NumberOrUnknown(
  std::string_view word, const char* what, const TextLines& lines, ReadingReport& report)
{
  double value = 0.0;
  if (IsNumber(word, value) && std::isfinite(value))
  {
    return value;
  }
  if (!word.empty())
  {
    report.Count(what, lines.Line());
  }
  return Atom::Unknown;
}

constexpr const char* OddResidueNumbers = "Residue numbers that are not integers, taken as 0";
constexpr const char* OddCharges = "Charges that are not numbers, dropped";

/// An invalid bond does not discard its atoms. `a` and `b` are indices of atoms, -1 for missing
/// ones.
void AddBond(Macromolecule& molecule, std::optional<std::int64_t> a, std::optional<std::int64_t> b,
  const TextLines& lines, ReadingReport& report)
{
  const auto atoms = static_cast<std::int64_t>(molecule.Atoms.size());
  if (!a || !b)
  {
    report.Count("Unreadable bonds, dropped", lines.Line());
  }
  else if (*a < 0 || *b < 0 || *a >= atoms || *b >= atoms || *a == *b)
  {
    report.Count("Bonds with missing atoms, dropped", lines.Line());
  }
  else
  {
    molecule.Bonds.push_back({ std::min(*a, *b), std::max(*a, *b), true });
  }
}

/// The number of an atom in `word`, from 1.
std::optional<std::int64_t> AtomNumber(std::string_view word)
{
  std::int64_t number = 0;
  return IsNumber(word, number) ? std::optional<std::int64_t>(number) : std::nullopt;
}

/// The place of the atom with a number, -1 where there is none.
template <typename Places>
std::optional<std::int64_t> FindAtomIndex(std::string_view word, const Places& places)
{
  const std::optional<std::int64_t> number = AtomNumber(word);
  if (!number)
  {
    return {};
  }
  const auto found = places.find(*number);
  return found == places.end() ? std::int64_t{ -1 } : found->second;
}

// ------------------------------------------------------------------------------------------
// PDBQT

/// AutoDock's types, version 4.2 and Vina's; 0 for pseudo atoms.
int ElementFromAutoDockType(std::string_view type, std::string_view residue)
{
  static const std::unordered_map<std::string_view, int> types{ { "HD", 1 }, { "HS", 1 },
    { "A", 6 }, { "CG", 6 }, { "CG0", 6 }, { "CG1", 6 }, { "CG2", 6 }, { "CG3", 6 }, { "NS", 7 },
    { "NX", 7 }, { "OA", 8 }, { "OS", 8 }, { "OX", 8 }, { "SA", 16 }, { "G", 0 }, { "GA", 0 },
    { "G0", 0 }, { "G1", 0 }, { "G2", 0 }, { "G3", 0 }, { "J", 0 }, { "Q", 0 }, { "W", 0 },
    { "X", 0 }, { "Z", 0 } };
  const auto found = types.find(type);
  if (found != types.end())
  {
    return found->second;
  }
  if (type == "NA" ||
    type == "Na") // a nitrogen that accepts hydrogen bonds, except in "Na" (sodium)
  {
    return residue == "NA" || residue == "NA+" || residue == "SOD" ? 11 : 7;
  }
  return ElementFromSymbol(type);
}

Atom ReadPDBQTAtom(std::string_view line, const TextLines& lines, ReadingReport& report)
{
  Atom atom;
  atom.IsHetero = BeginsWith(line, "HETATM");
  IsNumber(Columns(line, 6, 5), atom.Serial);
  atom.Name = Columns(line, 12, 4);
  atom.AltLoc = line.size() > 16 ? line[16] : ' ';
  atom.ResidueName = Columns(line, 17, 4);
  atom.Chain = Columns(line, 21, 1);
  atom.ResidueId = IntegerOrZero(Columns(line, 22, 4), OddResidueNumbers, lines, report);
  atom.InsertionCode = line.size() > 26 ? line[26] : ' ';
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    atom.Position[axis] = FiniteNumber(Columns(line, 30 + 8 * axis, 8), lines, "a coordinate");
  }
  constexpr const char* oddValues = "Occupancies and B factors that are not numbers, dropped";
  atom.Occupancy = NumberOrUnknown(Columns(line, 54, 6), oddValues, lines, report);
  atom.BFactor = NumberOrUnknown(Columns(line, 60, 6), oddValues, lines, report);
  atom.Charge = NumberOrUnknown(Columns(line, 66, 10), OddCharges, lines, report);
  const std::string_view type = Columns(line, 76, 4);
  if (type.empty())
  {
    FiniteNumber(Columns(line, 66, 10), lines, "a partial charge");
    lines.Fail(
      "the type of AutoDock (columns 78-79) is missing. Is it a PDBQT file? Name a PDB file "
      ".pdb.");
  }
  atom.Element = ElementFromAutoDockType(type, atom.ResidueName);
  return atom;
}

/// Columns as in PDB, but with charges in place of segments.
bool IsSamePDBQTAtom(std::string_view a, std::string_view b)
{
  return Columns(a, 12, 15) == Columns(b, 12, 15);
}

Macromolecule ParsePDBQT(std::string_view text, const std::string& path, std::int64_t model,
  const ProgressCallback& progress)
{
  ReadingReport report;
  const auto read = [&](const std::vector<std::string_view>& lines, const ProgressCallback& reading)
  {
    std::vector<Atom> atoms;
    atoms.reserve(lines.size());
    TextLines place(text, path, reading);
    std::size_t size = 0; // of the line before
    for (const std::string_view line : lines)
    {
      place.GoTo(line);
      if (place.IsUnfinished() && line.size() < size)
      {
        place.Fail("the file ends within this record. Fetch or write it again.");
      }
      size = line.size();
      atoms.push_back(ReadPDBQTAtom(line, place, report));
    }
    return atoms;
  };
  Macromolecule molecule = ReadModelOfRecords(
    text, model, { IsSamePDBQTAtom, PDBColumnsOfAtoms.Place }, read, report, progress);
  ReportMissingElements(molecule.Atoms, report);
  report.AddTo(molecule);
  return molecule;
}

// ------------------------------------------------------------------------------------------
// GRO

/// The width of a coordinate: the distance of decimal points, as the format's manual says.
std::size_t CoordinateWidth(std::string_view line, const TextLines& lines)
{
  constexpr std::size_t first = 20;
  const std::size_t one = line.find('.', first);
  const std::size_t two = one == std::string_view::npos ? one : line.find('.', one + 1);
  if (two == std::string_view::npos)
  {
    lines.Fail(
      "this is not an atom of a GRO file (residue, atom and their numbers in columns 1-20, then "
      "x, y, z in nm). The file may be truncated.");
  }
  return two - one;
}

constexpr double AngstromOfNanometre = 10.0;

Atom ReadGROAtom(
  std::string_view line, std::size_t width, const TextLines& lines, ReadingReport& report)
{
  Atom atom;
  atom.ResidueId = IntegerOrZero(Columns(line, 0, 5), OddResidueNumbers, lines, report);
  atom.ResidueName = Columns(line, 5, 5);
  atom.Name = Columns(line, 10, 5);
  IsNumber(Columns(line, 15, 5), atom.Serial);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    atom.Position[axis] = AngstromOfNanometre *
      FiniteNumber(Columns(line, 20 + width * axis, width), lines, "a coordinate");
    constexpr double largest = 1e9;
    if (std::abs(atom.Position[axis]) > largest)
    {
      lines.Fail("a coordinate is larger than " + std::to_string(static_cast<int>(largest)) +
        " angstrom. The file may be truncated, or its name may not match its content.");
    }
    // 1.234 nm is 12.34 angstrom, not an adjacent double.
    atom.Position[axis] = std::round(atom.Position[axis] * 1e9) / 1e9;
  }
  return atom;
}

/// v1x v2y v3z, and where they are not 0 v1y v1z v2x v2z v3x v3y, nm; empty: no box.
std::vector<std::array<double, 3>> ReadGROBox(std::string_view line)
{
  std::array<double, 9> v{};
  for (double& x : v)
  {
    const std::string_view word = NextWord(line);
    if (!word.empty() && !IsNumber(word, x))
    {
      return {};
    }
    x *= AngstromOfNanometre;
  }
  if (!(v[0] > 0.0 && v[1] > 0.0 && v[2] > 0.0))
  {
    return {};
  }
  return { { v[0], v[3], v[4] }, { v[5], v[1], v[6] }, { v[7], v[8], v[2] } };
}

Macromolecule ParseGRO(std::string_view text, const std::string& path, std::int64_t model,
  const ProgressCallback& progress)
{
  Macromolecule molecule;
  molecule.UnitOfFormat = AngstromOfNanometre;
  ReadingReport report;
  ReadingReport ofOthers;
  report.Note("GRO file: elements were inferred from the names; there are no chains.");
  TextLines lines(text, path, progress);
  for (std::string_view line; lines.Next(line);) // the title, which may be empty
  {
    std::string_view number;
    if (!lines.Next(number))
    {
      if (Trim(line).empty())
      {
        break; // an empty line at the end
      }
      lines.Fail("the number of atoms belongs on the line after the title. Is it a GRO file?");
    }
    if (molecule.NumberOfModels > 0 && Trim(line).empty() && Trim(number).empty())
    {
      continue;
    }
    const std::int64_t count = Count(Trim(number), lines, "the number of atoms");
    const bool isWanted = molecule.NumberOfModels == model;
    std::size_t width = 0;
    for (std::int64_t i = 0; i < count; ++i)
    {
      line = NextLine(lines);
      width = i == 0 ? CoordinateWidth(line, lines) : width;
      Atom atom = ReadGROAtom(line, width, lines, isWanted ? report : ofOthers);
      if (isWanted)
      {
        molecule.Atoms.push_back(std::move(atom));
      }
    }
    double box = 0.0;
    std::string_view rest;
    if (!lines.Next(line) || (rest = line, !IsNumber(NextWord(rest), box)))
    {
      lines.Fail(
        "the box should follow the last atom: three numbers or nine. The file is truncated "
        "or has another number of atoms than it declares. Fetch or write it again.");
    }
    if (isWanted)
    {
      molecule.Cell = ReadGROBox(line);
    }
    ++molecule.NumberOfModels;
  }
  SetElements(molecule.Atoms, report, ElementColumn::None);
  report.AddTo(molecule);
  return molecule;
}

// ------------------------------------------------------------------------------------------
// MOL2

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

Macromolecule ParseMOL2(std::string_view text, const std::string& path, std::int64_t model,
  const ProgressCallback& progress)
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
    const bool isWanted = molecule.NumberOfModels - 1 == model;
    if (section == "@<TRIPOS>MOLECULE")
    {
      counted.Check(lines);
      counted = {};
      ++molecule.NumberOfModels;
      NextLine(lines); // the name
      std::string_view counts = NextLine(lines);
      counted.Atoms = Count(NextWord(counts), lines, "the number of atoms");
      const std::string_view second = NextWord(counts);
      counted.Bonds = second.empty() ? 0 : Count(second, lines, "the number of bonds");
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

// ------------------------------------------------------------------------------------------
// SDF

void AddSDFAtom(Macromolecule& molecule, std::string_view symbol, const double* position)
{
  Atom atom;
  atom.Name = symbol;
  atom.Element = ElementFromSymbol(symbol);
  atom.Serial = static_cast<int>(molecule.Atoms.size()) + 1;
  std::copy(position, position + 3, atom.Position.begin());
  molecule.Atoms.push_back(std::move(atom));
}

/// "M  CHG  2   3  -1   7   1": formal charges of atoms 3 and 7.
void ReadCharges(
  Macromolecule& molecule, std::string_view line, const TextLines& lines, ReadingReport& report)
{
  std::string_view rest = line.substr(6);
  std::int64_t count = 0;
  if (!IsNumber(NextWord(rest), count))
  {
    report.Count("Unreadable charges (M  CHG), dropped", lines.Line());
    return;
  }
  for (std::int64_t i = 0; i < count; ++i)
  {
    const std::optional<std::int64_t> atom = AtomNumber(NextWord(rest));
    double charge = 0.0;
    if (!atom || !IsNumber(NextWord(rest), charge) || !std::isfinite(charge))
    {
      report.Count("Unreadable charges (M  CHG), dropped", lines.Line());
      return;
    }
    if (*atom < 1 || *atom > static_cast<std::int64_t>(molecule.Atoms.size()))
    {
      report.Count("Charges of missing atoms, dropped", lines.Line());
      continue;
    }
    molecule.Atoms[static_cast<std::size_t>(*atom - 1)].Charge = charge;
  }
}

/// The formal charge by the code in columns 37-39, which M  CHG replaces: 1 is +3, 7 is -3.
double ChargeFromCode(std::string_view line, const TextLines& lines, ReadingReport& report)
{
  constexpr const char* odd = "Codes of charges (columns 37-39) that are not 0 to 7, dropped";
  const int code = IntegerOrZero(Columns(line, 36, 3), odd, lines, report);
  constexpr int radical = 4;
  if (code < 0 || code > 7)
  {
    report.Count(odd, lines.Line());
    return Atom::Unknown;
  }
  return code == 0 || code == radical ? Atom::Unknown : double{ radical } - code;
}

void ReadV2000(
  std::string_view counts, TextLines& lines, Macromolecule& molecule, ReadingReport& report)
{
  const std::int64_t atoms = Count(Columns(counts, 0, 3), lines, "the number of atoms");
  const std::int64_t bonds = Count(Columns(counts, 3, 3), lines, "the number of bonds");
  for (std::int64_t i = 0; i < atoms; ++i)
  {
    const std::string_view line = NextLine(lines);
    double position[3];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      position[axis] = FiniteNumber(Columns(line, 10 * axis, 10), lines, "a coordinate");
    }
    AddSDFAtom(molecule, Columns(line, 31, 3), position);
    molecule.Atoms.back().Charge = ChargeFromCode(line, lines, report);
  }
  for (std::int64_t i = 0; i < bonds; ++i)
  {
    const std::string_view line = NextLine(lines);
    const auto place = [&line](std::size_t from)
    {
      const auto number = AtomNumber(Columns(line, from, 3));
      return number ? std::optional<std::int64_t>(*number - 1) : std::nullopt;
    };
    AddBond(molecule, place(0), place(3), lines, report);
  }
}

/// A line of V3000, whose continuations ("-" at the end) are appended.
std::string V3000Line(std::string_view line, TextLines& lines)
{
  constexpr std::string_view head = "M  V30 ";
  std::string whole(line.substr(std::min(head.size(), line.size())));
  while (!whole.empty() && whole.back() == '-')
  {
    whole.pop_back();
    const std::string_view next = NextLine(lines);
    whole += next.substr(std::min(head.size(), next.size()));
  }
  return whole;
}

void ReadV3000Atom(std::string_view rest, std::unordered_map<std::int64_t, std::int64_t>& place,
  Macromolecule& molecule, const TextLines& lines, ReadingReport& report)
{
  const std::int64_t number = Count(NextWord(rest), lines, "the number of an atom");
  const std::string_view symbol = NextWord(rest);
  double position[3];
  for (double& x : position)
  {
    x = FiniteNumber(NextWord(rest), lines, "a coordinate");
  }
  place.emplace(number, static_cast<std::int64_t>(molecule.Atoms.size()));
  AddSDFAtom(molecule, symbol, position);
  for (auto word = NextWord(rest); !word.empty(); word = NextWord(rest))
  {
    if (BeginsWith(word, "CHG="))
    {
      molecule.Atoms.back().Charge = NumberOrUnknown(word.substr(4), OddCharges, lines, report);
    }
  }
}

void ReadV3000(TextLines& lines, Macromolecule& molecule, ReadingReport& report)
{
  std::unordered_map<std::int64_t, std::int64_t> place;
  std::string block;
  while (true)
  {
    const std::string line = V3000Line(NextLine(lines), lines);
    std::string_view rest = line;
    if (BeginsWith(line, "END CTAB"))
    {
      return;
    }
    if (BeginsWith(line, "BEGIN ") || BeginsWith(line, "END "))
    {
      block = line[0] == 'B' ? std::string(Trim(std::string_view(line).substr(6))) : "";
    }
    else if (block == "ATOM")
    {
      ReadV3000Atom(rest, place, molecule, lines, report);
    }
    else if (block == "BOND")
    {
      NextWord(rest);
      NextWord(rest);
      const auto first = FindAtomIndex(NextWord(rest), place);
      AddBond(molecule, first, FindAtomIndex(NextWord(rest), place), lines, report);
    }
  }
}

Macromolecule ParseSDF(std::string_view text, const std::string& path, std::int64_t model,
  const ProgressCallback& progress)
{
  Macromolecule molecule;
  ReadingReport report;
  TextLines lines(text, path, progress);
  std::string_view line;
  while (lines.Next(line)) // the title
  {
    std::string_view program, comment, counts;
    if (!lines.Next(program) || !lines.Next(comment) || !lines.Next(counts))
    {
      if (Trim(line).empty() && Trim(program).empty() && Trim(comment).empty())
      {
        break; // empty lines at the end
      }
      lines.Fail("the file ends before the counts of a molecule. Fetch or write it again.");
    }
    Macromolecule one;
    ReadingReport ofOne;
    std::size_t fields = 0;
    const bool isWanted = molecule.NumberOfModels == model;
    if (counts.find("V3000") != std::string_view::npos)
    {
      ReadV3000(lines, one, ofOne);
    }
    else
    {
      ReadV2000(counts, lines, one, ofOne);
    }
    bool areCodesReplaced = false;
    bool isWhole = counts.find("V3000") != std::string_view::npos; // which has its own end marker
    while (lines.Next(line))
    {
      const bool isLast = Trim(line) == "$$$$";
      isWhole = isWhole || isLast || BeginsWith(line, "M  END");
      if (isLast)
      {
        break;
      }
      const bool isCharge = BeginsWith(line, "M  CHG");
      if ((isCharge || BeginsWith(line, "M  RAD")) && !std::exchange(areCodesReplaced, true))
      {
        for (Atom& atom : one.Atoms)
        {
          atom.Charge = Atom::Unknown;
        }
      }
      if (isCharge)
      {
        ReadCharges(one, line, lines, ofOne);
      }
      fields += BeginsWith(line, ">") ? 1 : 0;
    }
    if (!isWhole && lines.IsUnfinished())
    {
      lines.Fail("the file ends within this line. Fetch or write it again.");
    }
    if (!isWhole)
    {
      ofOne.Warn("The file ends without M  END: it may be truncated, so that formal charges are "
                 "missing. Compare it with its source.");
    }
    if (isWanted)
    {
      molecule.Atoms = std::move(one.Atoms);
      molecule.Bonds = std::move(one.Bonds);
      if (Columns(program, 20, 2) == "2D")
      {
        ofOne.Warn("The file states that its coordinates are those of a drawing (2D): distances "
                   "and surfaces are meaningless. Generate a conformer first.");
      }
      if (fields > 0)
      {
        ofOne.Note(
          "Data fields of the SDF file that were not read: " + std::to_string(fields) + ".");
      }
      ReportMissingElements(molecule.Atoms, ofOne);
      report = std::move(ofOne);
    }
    ++molecule.NumberOfModels;
  }
  report.AddTo(molecule);
  return molecule;
}

}

Macromolecule ParseExchangeFormat(std::string_view text, const std::string& path,
  MoleculeFormat format, std::int64_t model, const ProgressCallback& progress)
{
  switch (format)
  {
    case MoleculeFormat::PDBQT:
      return ParsePDBQT(text, path, model, progress);
    case MoleculeFormat::GRO:
      return ParseGRO(text, path, model, progress);
    case MoleculeFormat::MOL2:
      return ParseMOL2(text, path, model, progress);
    default:
      return ParseSDF(text, path, model, progress);
  }
}

}
