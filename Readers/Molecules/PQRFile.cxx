#include "Molecules/PQRFile.h"

#include "Atoms/ChemicalElement.h"
#include "Atoms/NameLetters.h"
#include "Files/TextLines.h"
#include "Molecules/AtomElements.h"
#include "Molecules/PDBColumns.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isthmus
{
namespace
{

using Words = std::array<std::string_view, 12>;

/// "1003" or "1003A".
bool ReadResidueId(std::string_view word, Atom& atom)
{
  if (!word.empty() && IsLetter(word.back()))
  {
    atom.InsertionCode = word.back();
    word.remove_suffix(1);
  }
  return IsNumber(word, atom.ResidueId);
}

/// [chain] number [insertion code], in one to three words.
bool ReadResidue(const std::string_view* words, std::size_t count, Atom& atom)
{
  atom.InsertionCode = ' ';
  if (count == 1)
  {
    std::size_t letters = 0;
    while (letters < words[0].size() && IsLetter(words[0][letters]))
    {
      ++letters;
    }
    atom.Chain = words[0].substr(0, letters);
    return ReadResidueId(words[0].substr(letters), atom);
  }
  if (count == 2 && words[1].size() == 1 && IsLetter(words[1][0]))
  {
    atom.Chain.clear();
    atom.InsertionCode = words[1][0];
    return IsNumber(words[0], atom.ResidueId);
  }
  atom.Chain = words[0];
  if (count == 3)
  {
    atom.InsertionCode = words[2][0];
    return words[2].size() == 1 && IsNumber(words[1], atom.ResidueId);
  }
  return ReadResidueId(words[1], atom);
}

bool ReadNumbers(const std::string_view* words, Atom& atom)
{
  return IsNumber(words[0], atom.Position[0]) && IsNumber(words[1], atom.Position[1]) &&
    IsNumber(words[2], atom.Position[2]) && IsNumber(words[3], atom.Charge) &&
    IsNumber(words[4], atom.Radius);
}

/// Line behind its first word, as words.
bool ReadWords(std::string_view rest, Atom& atom)
{
  Words words;
  std::size_t count = 0;
  for (auto word = NextWord(rest); !word.empty(); word = NextWord(rest))
  {
    if (count == words.size())
    {
      return false;
    }
    words[count++] = word;
  }
  atom.Element = 0;
  if (count > 9 && ElementOfSymbol(words[count - 1]) > 0)
  {
    atom.Element = ElementOfSymbol(words[--count]);
  }
  constexpr std::size_t fewest = 9; // serial name residue number x y z charge radius
  if (count < fewest || count > fewest + 2 || !ReadNumbers(words.data() + count - 5, atom) ||
    !ReadResidue(words.data() + 3, count - 8, atom))
  {
    return false;
  }
  IsNumber(words[0], atom.Serial);
  atom.Name = words[1];
  atom.ResidueName = words[2];
  return true;
}

bool ReadColumns(std::string_view line, Atom& atom)
{
  Words numbers{ Columns(line, 30, 8), Columns(line, 38, 8), Columns(line, 46, 8) };
  std::string_view rest = line.substr(std::min<std::size_t>(54, line.size()));
  numbers[3] = NextWord(rest);
  numbers[4] = NextWord(rest);
  if (numbers[4].empty())
  {
    numbers[3] = Columns(line, 54, 8);
    numbers[4] = Columns(line, 62, 8);
  }
  const std::string_view residue = Columns(line, 22, 4);
  if (!ReadNumbers(numbers.data(), atom) || !IsNumber(residue, atom.ResidueId))
  {
    return false;
  }
  IsNumber(Columns(line, 6, 5), atom.Serial);
  atom.Name = Columns(line, 12, 4);
  atom.ResidueName = Columns(line, 16, 5);
  atom.Chain = Columns(line, 21, 1);
  atom.InsertionCode = line[26];
  atom.Element = ElementOfSymbol(NextWord(rest));
  return !atom.Name.empty();
}

/// Atoms of amino acids, nucleotides and so on are none, whatever their names.
bool IsDummy(const Atom& atom)
{
  const ResidueFamily family = FamilyOfResidue(atom.ResidueName);
  return (family == ResidueFamily::Unknown || family == ResidueFamily::Water) &&
    IsDummyName(atom.Name);
}

void CheckValues(const Atom& atom, const TextLines& lines)
{
  for (const double value :
    { atom.Position[0], atom.Position[1], atom.Position[2], atom.Charge, atom.Radius })
  {
    if (!std::isfinite(value))
    {
      lines.Fail("a number of " + Describe(atom) + " is not finite. Correct the file.");
    }
  }
  if (atom.Radius < 0.0)
  {
    lines.Fail("the radius of " + Describe(atom) + " is negative: are charge and radius swapped?");
  }
}

bool ReadLine(std::string_view line, Atom& atom)
{
  constexpr std::string_view hetero = "HETATM";
  atom.IsHetero = (line[0] & ~0x20) == hetero[0];
  return ReadWords(line.substr(std::min(line.size(), atom.IsHetero ? hetero.size() : 4)), atom) ||
    ReadColumns(line, atom);
}

bool IsSameAtom(std::string_view a, std::string_view b)
{
  Atom x, y;
  return ReadLine(a, x) && ReadLine(b, y) && x.Name == y.Name && x.ResidueName == y.ResidueName &&
    x.ResidueId == y.ResidueId && x.InsertionCode == y.InsertionCode && x.Chain == y.Chain;
}

bool PlaceOfAtom(std::string_view line, std::array<double, 3>& place)
{
  Atom atom;
  const bool isAtom = ReadLine(line, atom);
  place = { atom.Position[0], atom.Position[1], atom.Position[2] };
  return isAtom;
}

constexpr PDBAtomText textOfAtoms{ IsSameAtom, PlaceOfAtom };

}

Macromolecule ParsePQR(std::string_view text, const std::string& path, std::int64_t model,
  const ProgressCallback& progress)
{
  ReadingReport report;
  std::size_t dummies = 0;
  const auto read = [&dummies](std::string_view line, const TextLines& lines)
  {
    Atom atom;
    if (!ReadLine(line, atom))
    {
      lines.Fail("this is no atom of a PQR file (serial, name, residue, number, x, y, z, charge, "
                 "radius, as words or in columns). The file may be truncated, or not PQR.");
    }
    CheckValues(atom, lines);
    if (atom.Element == 0 && IsDummy(atom))
    {
      ++dummies;
    }
    else if (atom.Element == 0)
    {
      atom.Element = ElementOfAtomName(atom.Name, atom.ResidueName);
    }
    return atom;
  };
  Macromolecule molecule =
    ReadModelOfRecords(text, path, model, textOfAtoms, read, report, progress);
  if (dummies > 0)
  {
    report.Note("Ghost or dummy atoms and virtual sites, with the radii of the file and without "
                "element (0): " +
      std::to_string(dummies) + ".");
  }
  report.AddTo(molecule);
  return molecule;
}

std::int64_t CountPQRModels(std::string_view text)
{
  ReadingReport report;
  constexpr std::size_t bytesOfAPiece = std::size_t{ 1 } << 20;
  const PDBLines lines = SplitPDB(text, bytesOfAPiece, {});
  return std::max<std::int64_t>(
    static_cast<std::int64_t>(FindModels(lines, report, textOfAtoms).size()), 1);
}

}
