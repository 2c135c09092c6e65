// SDF and MOL (MDL): V2000 and V3000, formal charges and bonds of the file. Each molecule ($$$$) is
// a model.

#include "Atoms/ChemicalElement.h"
#include "Molecules/AtomElements.h"
#include "Molecules/MoleculeFields.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace isthmus
{
namespace
{

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
  const std::int64_t atoms = ReadCount(Columns(counts, 0, 3), lines, "the number of atoms");
  const std::int64_t bonds = ReadCount(Columns(counts, 3, 3), lines, "the number of bonds");
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
  const std::int64_t number = ReadCount(NextWord(rest), lines, "the number of an atom");
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

}

/// The version in the fourth line.
bool IsSDF(std::string_view text)
{
  TextLines lines(text, {}, {});
  std::string_view line;
  for (int i = 0; i < 4; ++i)
  {
    if (!lines.Next(line))
    {
      return false;
    }
  }
  return line.find("V2000") != std::string_view::npos ||
    line.find("V3000") != std::string_view::npos;
}

Macromolecule ParseSDF(std::string_view text, const std::string& path,
  const StructureChoice& choice, const ProgressCallback& progress)
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
    const bool isWanted = molecule.NumberOfModels == choice.Model;
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
