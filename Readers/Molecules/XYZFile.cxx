#include "Molecules/XYZFile.h"

#include "Atoms/ChemicalElement.h"
#include "Files/TextLines.h"

#include <cmath>

namespace isthmus
{
namespace
{

Atom ReadAtom(std::string_view line, const TextLines& lines)
{
  Atom atom;
  const std::string_view symbol = NextWord(line);
  atom.Name = symbol;
  if (IsNumber(symbol, atom.Element))
  {
    atom.Name = ElementSymbol(atom.Element);
  }
  else
  {
    atom.Element = ElementOfAtomName(symbol, symbol); // "C", "Fe", and "C1" of some programs
  }
  for (double& x : atom.Position)
  {
    if (!IsNumber(NextWord(line), x) || !std::isfinite(x))
    {
      lines.Fail("this is no atom of an XYZ file (symbol, x, y, z, finite numbers). Is the file "
                 "whole?");
    }
  }
  if (atom.Element < 0 || atom.Element >= NumberOfElements)
  {
    lines.Fail("there is no element " + std::to_string(atom.Element) + ".");
  }
  return atom;
}

/// Extended XYZ says in its comment which columns there are: the first must be those of plain XYZ.
void CheckComment(std::string_view comment, const TextLines& lines)
{
  const auto at = comment.find("Properties=");
  if (at != std::string_view::npos && comment.substr(at + 11, 19) != "species:S:1:pos:R:3")
  {
    lines.Fail("the columns are others than symbol, x, y, z. Write them in this order first.");
  }
}

}

Macromolecule ParseXYZ(std::string_view text, const std::string& path, std::int64_t model,
  const ProgressCallback& progress)
{
  Macromolecule molecule;
  TextLines lines(text, path, progress);
  for (std::string_view line; lines.Next(line);)
  {
    if (Trimmed(line).empty())
    {
      continue;
    }
    std::int64_t count = 0;
    if (!IsNumber(Trimmed(line), count) || count < 0)
    {
      lines.Fail("the number of atoms belongs here. Is it an XYZ file?");
    }
    if (lines.Next(line))
    {
      CheckComment(line, lines);
    }
    for (std::int64_t i = 0; i < count; ++i)
    {
      if (!lines.Next(line))
      {
        lines.Fail("the file ends after " + std::to_string(i) + " of " + std::to_string(count) +
          " atoms. Fetch or write it again.");
      }
      const Atom atom = ReadAtom(line, lines);
      if (molecule.NumberOfModels == model)
      {
        molecule.Atoms.push_back(atom);
      }
    }
    ++molecule.NumberOfModels;
  }
  return molecule;
}

}
