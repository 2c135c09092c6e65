// PDBQT (AutoDock, Vina): lines of PDB with a partial charge in columns 67-76 and a type of
// AutoDock in 78-79, from which the element comes. MODEL begins a pose. ROOT, BRANCH and TORSDOF
// are skipped. Pseudo atoms (G0, W) have no element.

#include "Atoms/ChemicalElement.h"
#include "Molecules/AtomElements.h"
#include "Molecules/MoleculeFields.h"
#include "Molecules/PDBColumns.h"

#include <unordered_map>

namespace isthmus
{
namespace
{

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

}

/// Its lines are those of PDB.
bool IsPDBQT(std::string_view)
{
  return false;
}

Macromolecule ParsePDBQT(std::string_view text, const std::string& path,
  const StructureChoice& choice, const ProgressCallback& progress)
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
    text, choice.Model, { IsSamePDBQTAtom, PDBColumnsOfAtoms.Place }, read, report, progress);
  ReportMissingElements(molecule.Atoms, report);
  report.AddTo(molecule);
  return molecule;
}

}
