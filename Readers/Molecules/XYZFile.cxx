// XYZ: a frame is a line with the number of atoms, a line of comment, and a line for each atom:
// symbol or atomic number, x, y, z in angstrom; the rest of the line is ignored. Frames are models.
// The name of an atom is its symbol.
//
// Extended XYZ names its columns in the comment (Properties=species:S:1:pos:R:3:...), in any order:
// species (or Z), pos, charge (or charges, initial_charges, q) and radius are read.
//
// TINKER's XYZ has no comment: number of atoms and title, perhaps a line with the box, and for each
// atom its number, name, x, y, z, type and the numbers of the bonded atoms.

#include "Atoms/ChemicalElement.h"
#include "Files/TextLines.h"
#include "Molecules/AtomElements.h"
#include "Molecules/MoleculeParsers.h"
#include "Molecules/ReadingReport.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

namespace isthmus
{
namespace
{

/// The most columns of an extended XYZ file; more are ignored.
constexpr std::size_t MostColumns = 64;

/// Columns of a frame, from 0. -1: there is none.
struct XYZColumns
{
  int Species = 0;
  int Position = 1; ///< the first of three
  int Charge = -1;
  int Radius = -1;
  std::string Others; ///< properties that are not read
  bool IsExtended = false;
};

bool IsInList(std::string_view word, std::initializer_list<std::string_view> words)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The value after `key` ("Properties=") in the comment, in quotes or not; empty: there is none.
std::string_view FindValue(std::string_view comment, std::string_view key)
{
  const auto at = comment.find(key);
  if (at == std::string_view::npos)
  {
    return {};
  }
  std::string_view value = comment.substr(at + key.size());
  const bool quoted = !value.empty() && (value[0] == '"' || value[0] == '\'');
  const auto end = quoted ? value.find(value[0], 1) : value.find_first_of(" \t");
  value = value.substr(0, end);
  return quoted ? value.substr(1) : value;
}

/// Three vectors, one after the other; empty: there are none.
std::vector<std::array<double, 3>> ReadLattice(std::string_view comment)
{
  std::string_view rest = FindValue(comment, "Lattice=");
  std::vector<std::array<double, 3>> vectors(3);
  for (std::array<double, 3>& vector : vectors)
  {
    for (double& x : vector)
    {
      if (!IsNumber(NextWord(rest), x))
      {
        return {};
      }
    }
  }
  return vectors;
}

/// Extended XYZ says in its comment which columns there are: name:type:count, repeated.
XYZColumns ParseColumns(std::string_view comment, const TextLines& lines)
{
  XYZColumns columns;
  std::string_view rest = FindValue(comment, "Properties=");
  if (rest.empty())
  {
    return columns;
  }
  columns.IsExtended = true;
  columns.Species = columns.Position = -1;
  const auto next = [&rest]
  {
    const auto end = std::min(rest.find(':'), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return word;
  };
  int column = 0;
  while (!rest.empty())
  {
    const std::string_view name = next();
    const std::string_view type = next();
    int count = 0;
    if (!IsInList(type, { "S", "R", "I", "L" }) || !IsNumber(next(), count) || count < 1 ||
      count > static_cast<int>(MostColumns))
    {
      lines.Fail(
        "Properties of extended XYZ are name:type:count, of the types S, R, I and L, and '" +
        std::string(name.substr(0, 30)) + "' is none. Correct the line.");
    }
    if (name == "pos" && type == "R" && count == 3)
    {
      columns.Position = column;
    }
    else if (count == 1 && columns.Species < 0 &&
      IsInList(name, { "species", "element", "elements", "symbol", "symbols", "Z", "numbers" }))
    {
      columns.Species = column;
    }
    else if (count == 1 && type == "R" &&
      IsInList(name, { "charge", "charges", "initial_charges", "initial_charge", "q" }))
    {
      columns.Charge = column;
    }
    else if (count == 1 && type == "R" && IsInList(name, { "radius", "radii" }))
    {
      columns.Radius = column;
    }
    else
    {
      columns.Others += (columns.Others.empty() ? "" : ", ") + std::string(name);
    }
    column += count;
  }
  if (columns.Species < 0 || columns.Position < 0 || column > static_cast<int>(MostColumns))
  {
    lines.Fail("an extended XYZ file needs the properties species (S:1) and pos (R:3), and has at "
               "most " +
      std::to_string(MostColumns) + " columns. Write them.");
  }
  return columns;
}

double NumberAt(const std::vector<std::string_view>& words, int column, const TextLines& lines)
{
  double value = 0.0;
  if (static_cast<std::size_t>(column) >= words.size() ||
    !IsNumber(words[static_cast<std::size_t>(column)], value) || !std::isfinite(value))
  {
    lines.Fail(
      "this is not an atom of an XYZ file (symbol, x, y, z, finite numbers, or the columns that "
      "Properties= names). The file may be truncated.");
  }
  return value;
}

Atom ReadAtom(std::string_view line, const XYZColumns& columns,
  std::vector<std::string_view>& words, const TextLines& lines)
{
  words.clear();
  for (std::string_view word = NextWord(line); !word.empty() && words.size() < MostColumns;
       word = NextWord(line))
  {
    words.push_back(word);
  }
  Atom atom;
  const auto place = static_cast<std::size_t>(columns.Species);
  const std::string_view symbol = place < words.size() ? words[place] : std::string_view();
  atom.Name = symbol;
  if (IsNumber(symbol, atom.Element))
  {
    atom.Name = ElementSymbol(atom.Element);
  }
  else if (!IsDummyName(symbol))
  {
    atom.Element = ElementFromAtomName(symbol, symbol); // "C", "Fe", and "C1" of some programs
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    atom.Position[static_cast<std::size_t>(axis)] = NumberAt(words, columns.Position + axis, lines);
  }
  atom.Charge = columns.Charge >= 0 ? NumberAt(words, columns.Charge, lines) : Atom::Unknown;
  atom.Radius = columns.Radius >= 0 ? NumberAt(words, columns.Radius, lines) : Atom::Unknown;
  if (atom.Element < 0 || atom.Element >= NumberOfElements)
  {
    lines.Fail("there is no element " + std::to_string(atom.Element) + ".");
  }
  return atom;
}

/// Number, name, x, y, z, type and the numbers of bonded atoms: a row of TINKER.
bool IsTinkerRow(std::string_view line)
{
  std::int64_t whole = 0;
  double number = 0.0;
  if (!IsNumber(NextWord(line), whole) || whole < 1)
  {
    return false;
  }
  const std::string_view name = NextWord(line);
  bool good = !name.empty() && !IsNumber(name, number);
  for (int axis = 0; axis < 3; ++axis)
  {
    good = good && IsNumber(NextWord(line), number);
  }
  return good && IsNumber(NextWord(line), whole);
}

/// The box of a periodic system: six numbers.
bool IsTinkerBox(std::string_view line)
{
  double number = 0.0;
  int count = 0;
  for (std::string_view word = NextWord(line); !word.empty(); word = NextWord(line))
  {
    if (!IsNumber(word, number))
    {
      return false;
    }
    ++count;
  }
  return count == 6;
}

bool IsTinker(std::string_view text)
{
  TextLines lines(text, {}, {});
  std::string_view line;
  while (lines.Next(line) && Trim(line).empty())
  {
  }
  std::int64_t count = 0;
  if (!IsNumber(NextWord(line), count) || count < 1 || !lines.Next(line))
  {
    return false;
  }
  return IsTinkerRow(line) || (IsTinkerBox(line) && lines.Next(line) && IsTinkerRow(line));
}

/// TINKER's names are those of atom types: "CA", "HN", "OW", "Na+".
int ElementFromTinkerName(std::string_view name)
{
  const auto end = name.find_first_of("+-0123456789");
  const bool isIon = name.find_first_of("+-") != std::string_view::npos;
  const int ion = isIon ? ElementFromSymbol(name.substr(0, end)) : 0;
  return ion > 0 ? ion : ElementFromAtomName(name, {});
}

Atom ReadTinkerRow(std::string_view line, std::vector<std::int64_t>& bonded, const TextLines& lines)
{
  Atom atom;
  if (!IsTinkerRow(line))
  {
    lines.Fail(
      "this is not an atom of a TINKER file (number, name, x, y, z, type, bonded atoms). Is the "
      "file complete?");
  }
  IsNumber(NextWord(line), atom.Serial);
  atom.Name = NextWord(line);
  atom.Element = ElementFromTinkerName(atom.Name);
  for (double& x : atom.Position)
  {
    IsNumber(NextWord(line), x);
    if (!std::isfinite(x))
    {
      lines.Fail("a coordinate is not finite. Correct the file.");
    }
  }
  NextWord(line); // the type
  bonded.clear();
  std::int64_t other = 0;
  while (IsNumber(NextWord(line), other))
  {
    bonded.push_back(other - 1);
  }
  return atom;
}

Macromolecule ParseTinker(std::string_view text, const std::string& path, std::int64_t model,
  const ProgressCallback& progress)
{
  Macromolecule molecule;
  ReadingReport report;
  report.Note("TINKER file: elements were inferred from the names of the atom types.");
  TextLines lines(text, path, progress);
  std::vector<std::int64_t> bonded;
  for (std::string_view line; lines.Next(line);)
  {
    if (Trim(line).empty())
    {
      continue;
    }
    std::int64_t count = 0;
    if (!IsNumber(NextWord(line), count) || count < 0)
    {
      lines.Fail("the number of atoms belongs here. Is it a TINKER file?");
    }
    const bool isWanted = molecule.NumberOfModels == model;
    for (std::int64_t i = 0; i < count; ++i)
    {
      if (!lines.Next(line) || (i == 0 && IsTinkerBox(line) && !lines.Next(line)))
      {
        lines.Fail("the file ends after " + std::to_string(i) + " of " + std::to_string(count) +
          " atoms. Fetch or write it again.");
      }
      Atom atom = ReadTinkerRow(line, bonded, lines);
      if (!isWanted)
      {
        continue;
      }
      molecule.Atoms.push_back(std::move(atom));
      for (const std::int64_t other : bonded)
      {
        if (other < 0 || other >= count)
        {
          lines.Fail("atom " + std::to_string(other + 1) + " is bonded, and there are " +
            std::to_string(count) + ". Correct the file.");
        }
        if (other > i) // each bond stands at both atoms
        {
          molecule.Bonds.push_back({ i, other, true });
        }
      }
    }
    ++molecule.NumberOfModels;
  }
  ReportMissingElements(molecule.Atoms, report);
  report.AddTo(molecule);
  return molecule;
}

}

/// The number of atoms, and an atom after the comment.
bool IsXYZ(std::string_view text)
{
  TextLines lines(text, {}, {});
  std::string_view line;
  std::int64_t count = 0;
  double x = 0.0;
  if (!lines.Next(line) || !IsNumber(Trim(line), count) || count < 1 || !lines.Next(line) ||
    !lines.Next(line))
  {
    return IsTinker(text);
  }
  const std::string_view symbol = NextWord(line);
  return !symbol.empty() && symbol.size() <= 3 && IsNumber(NextWord(line), x) &&
    IsNumber(NextWord(line), x) && IsNumber(NextWord(line), x);
}

Macromolecule ParseXYZ(std::string_view text, const std::string& path,
  const StructureChoice& choice, const ProgressCallback& progress)
{
  if (IsTinker(text))
  {
    return ParseTinker(text, path, choice.Model, progress);
  }
  Macromolecule molecule;
  ReadingReport report;
  TextLines lines(text, path, progress);
  std::vector<std::string_view> words;
  for (std::string_view line; lines.Next(line);)
  {
    if (Trim(line).empty())
    {
      continue;
    }
    std::int64_t count = 0;
    if (!IsNumber(Trim(line), count) || count < 0)
    {
      lines.Fail("the number of atoms belongs here. Is it an XYZ file?");
    }
    XYZColumns columns;
    if (lines.Next(line))
    {
      columns = ParseColumns(line, lines);
    }
    const bool isWanted = molecule.NumberOfModels == choice.Model;
    if (isWanted)
    {
      molecule.Cell = ReadLattice(line);
    }
    if (isWanted && !columns.Others.empty())
    {
      report.Note(
        "Properties of the extended XYZ file that were not read: " + columns.Others + ".");
    }
    for (std::int64_t i = 0; i < count; ++i)
    {
      if (!lines.Next(line))
      {
        lines.Fail("the file ends after " + std::to_string(i) + " of " + std::to_string(count) +
          " atoms. Fetch or write it again.");
      }
      const Atom atom = ReadAtom(line, columns, words, lines);
      if (isWanted)
      {
        molecule.Atoms.push_back(atom);
      }
      constexpr std::size_t usual = 4;
      if (isWanted && i == 0 && !columns.IsExtended && words.size() > usual)
      {
        report.Note("Columns after symbol, x, y and z that were not read: " +
          std::to_string(words.size() - usual) + ".");
      }
    }
    ++molecule.NumberOfModels;
  }
  ReportMissingElements(molecule.Atoms, report);
  report.AddTo(molecule);
  return molecule;
}

}
