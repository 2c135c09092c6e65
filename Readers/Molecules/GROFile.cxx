// GRO (GROMACS): a title, the number of atoms, a line of columns for each, the box; again for each
// frame. Lengths are converted from nm to angstrom; velocities are skipped. The number of decimals
// follows from the first line. Elements come from names.

#include "Molecules/AtomElements.h"
#include "Molecules/MoleculeFields.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

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

/// The next number of the box. Large ones run together, and have two decimals more than
/// coordinates.
std::string_view NextBoxNumber(std::string_view& rest, std::size_t decimals)
{
  std::string_view words = rest;
  const std::string_view word = NextWord(words);
  const auto end = word.find('.') + 1 + decimals; // 0 + decimals where there is no point
  const bool isOne = word.find('.', word.find('.') + 1) == std::string_view::npos;
  rest = isOne ? words : rest.substr(static_cast<std::size_t>(word.data() - rest.data()) + end);
  return word.substr(0, isOne ? word.size() : end);
}

/// v1x v2y v3z, and where they are not 0 v1y v1z v2x v2z v3x v3y, nm; empty: no box.
std::vector<std::array<double, 3>> ReadGROBox(std::string_view line, std::size_t decimals)
{
  std::array<double, 9> v{};
  for (double& x : v)
  {
    const std::string_view word = NextBoxNumber(line, decimals);
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

}

/// The number of atoms after the title, and an atom whose coordinates have decimal points.
bool IsGRO(std::string_view text)
{
  TextLines lines(text, {}, {});
  std::string_view title, number, atom;
  std::int64_t count = 0;
  double x = 0.0;
  return lines.Next(title) && lines.Next(number) && IsNumber(Trim(number), count) && count > 0 &&
    lines.Next(atom) && IsNumber(Columns(atom, 15, 5), count) &&
    IsNumber(Columns(atom, 20, 8), x) && Columns(atom, 20, 8).find('.') != std::string_view::npos;
}

Macromolecule ParseGRO(std::string_view text, const std::string& path,
  const StructureChoice& choice, const ProgressCallback& progress)
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
    const std::int64_t count = ReadCount(Trim(number), lines, "the number of atoms");
    const bool isWanted = molecule.NumberOfModels == choice.Model;
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
    const std::size_t decimals = std::max<std::size_t>(width, 8) - 3; // coordinates: width - 5
    std::string_view rest;
    if (!lines.Next(line) || (rest = line, !IsNumber(NextBoxNumber(rest, decimals), box)))
    {
      lines.Fail(
        "the box should follow the last atom: three numbers or nine. The file is truncated "
        "or has another number of atoms than it declares. Fetch or write it again.");
    }
    if (isWanted)
    {
      molecule.Cell = ReadGROBox(line, decimals);
    }
    ++molecule.NumberOfModels;
  }
  SetElements(molecule.Atoms, report, ElementColumn::None);
  report.AddTo(molecule);
  return molecule;
}

}
