// PQR (T. J. Dolinsky et al., Nucleic Acids Res. 32 (2004) W665; apbs.readthedocs.io, PQR) has a
// line for each atom. Two dialects are in use, and each line is read in its own:
//  - words: ATOM serial name residue [chain] number[insertion code] x y z charge radius [element];
//    chain and number may run together (A1003), as may the first word and the serial (ATOM100000);
//  - columns as in PDB files, where numbers may run together: name 13-16, residue 17-21, chain 22,
//    number 23-26, insertion code 27, x 31-38, y 39-46, z 47-54, then charge and radius as two
//    words or in columns 55-62 and 63-70.
//
// Lines that begin with HETATM are hetero atoms; MODEL, ENDMDL and END separate models or parts as
// in PDB files (PDBLines.h); other lines are ignored.

#include "Atoms/ChemicalElement.h"
#include "Atoms/NameLetters.h"
#include "Core/ParallelFor.h"
#include "Files/TextLines.h"
#include "Molecules/AtomElements.h"
#include "Molecules/MoleculeParsers.h"
#include "Molecules/PDBColumns.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <stdexcept>

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

/// The line after its first word, as words.
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
  if (count > 9 && ElementFromSymbol(words[count - 1]) > 0)
  {
    atom.Element = ElementFromSymbol(words[--count]);
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
  atom.Element = ElementFromSymbol(NextWord(rest));
  return !atom.Name.empty();
}

/// Atoms of amino acids, nucleotides etc. are not dummies, whatever their names.
bool IsDummy(const Atom& atom)
{
  const ResidueFamily family = FindResidueFamily(atom.ResidueName);
  return (family == ResidueFamily::Unknown || family == ResidueFamily::Water) &&
    IsDummyName(atom.Name);
}

/// The error in the numbers of an atom; empty if there is none.
std::string FindFault(const Atom& atom)
{
  for (const double value :
    { atom.Position[0], atom.Position[1], atom.Position[2], atom.Charge, atom.Radius })
  {
    if (!std::isfinite(value))
    {
      return "a number of " + Describe(atom) + " is not finite. Correct the file.";
    }
  }
  if (atom.Radius < 0.0)
  {
    return "the radius of " + Describe(atom) + " is negative: are charge and radius swapped?";
  }
  return {};
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

bool ParsePosition(std::string_view line, std::array<double, 3>& place)
{
  Atom atom;
  const bool isAtom = ReadLine(line, atom);
  place = { atom.Position[0], atom.Position[1], atom.Position[2] };
  return isAtom;
}

constexpr PDBAtomText textOfAtoms{ IsSameAtom, ParsePosition };

/// Reads an atom with its element. Returns what is wrong with the line; empty: nothing.
std::string ReadAtom(std::string_view line, Atom& atom, bool& isDummy)
{
  if (!ReadLine(line, atom))
  {
    return "this is not an atom of a PQR file (serial, name, residue, number, x, y, z, charge, "
           "radius, as words or in columns). The file may be truncated, or not PQR.";
  }
  isDummy = atom.Element == 0 && IsDummy(atom);
  if (atom.Element == 0 && !isDummy)
  {
    atom.Element = ElementFromAtomName(atom.Name, atom.ResidueName);
  }
  return FindFault(atom);
}

/// The atoms of lines of `text`, and the number of dummies among them.
/// @throws std::runtime_error with the number of the first line that is not an atom.
std::vector<Atom> ReadAtoms(std::string_view text, const std::string& path,
  const std::vector<std::string_view>& lines, std::size_t& dummies,
  const ProgressCallback& progress)
{
  std::vector<Atom> atoms(lines.size());
  std::atomic<std::size_t> firstFault{ lines.size() };
  std::atomic<std::size_t> dummiesFound{ 0 };
  constexpr std::int64_t linesAtOnce = 1 << 12;
  ParallelFor(
    0, static_cast<std::int64_t>(lines.size()), linesAtOnce,
    [&](std::int64_t first, std::int64_t last)
    {
      std::size_t dummiesHere = 0;
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
      {
        bool isDummy = false;
        if (!ReadAtom(lines[i], atoms[i], isDummy).empty())
        {
          std::size_t before = firstFault;
          while (i < before && !firstFault.compare_exchange_weak(before, i))
          {
          }
          break;
        }
        dummiesHere += isDummy ? 1 : 0;
      }
      dummiesFound += dummiesHere;
    },
    progress);
  if (firstFault < lines.size())
  {
    Atom atom;
    bool isDummy = false;
    throw std::runtime_error(path + ", " + FormatLineNumber(text, lines[firstFault]) + ": " +
      ReadAtom(lines[firstFault], atom, isDummy));
  }
  if (lines.size() > 1 && lines.back().data() == UnfinishedLine(text).data() &&
    !UnfinishedLine(text).empty())
  {
    const std::string_view last = lines.back();
    const std::string_view before = lines[lines.size() - 2];
    if (last.size() < before.size() && CountWords(last) < CountWords(before))
    {
      throw std::runtime_error(path + ", " + FormatLineNumber(text, last) +
        ": the file ends within this record. Fetch or write it again.");
    }
  }
  dummies = dummiesFound;
  return atoms;
}

}

/// Its lines are like those of PDB.
bool IsPQR(std::string_view)
{
  return false;
}

Macromolecule ParsePQR(std::string_view text, const std::string& path,
  const StructureChoice& choice, const ProgressCallback& progress)
{
  ReadingReport report;
  std::size_t dummies = 0;
  const auto read = [&](const std::vector<std::string_view>& lines, const ProgressCallback& reading)
  { return ReadAtoms(text, path, lines, dummies, reading); };
  Macromolecule molecule =
    ReadModelOfRecords(text, choice.Model, textOfAtoms, read, report, progress);
  if (dummies > 0)
  {
    report.Note("Ghost or dummy atoms and virtual sites, with the radii of the file and without "
                "element (0): " +
      std::to_string(dummies) + ".");
  }
  report.AddTo(molecule);
  return molecule;
}

}
