/**
 * @file PDBColumns.h
 * @brief Columns of PDB files written by various programs: residues, chains, numbers, coordinates.
 *
 * wwPDB's format 3.3 has the residue name in columns 18-20, the chain in 22, the number in 23-26
 * and an insertion code in 27. Programs with larger systems write:
 *
 * - residue names of four letters in 18-21 (CHARMM, VMD, NAMD, GROMOS: TIP3, POPC, LYSH), where
 *   others (gemmi, phenix) have chains of two letters in 21-22;
 * - numbers of five digits in 23-27 or 22-26, hexadecimal (VMD), hybrid-36 (cctbx), starting again
 *   at 0, or asterisks where they no longer fit;
 * - the chain as a segment in 73-76, with 22 blank;
 * - coordinates wider than their eight columns, with all that follows shifted to the right.
 *
 * The same text can have two meanings, so the decision is made for the file as a whole.
 */
#ifndef isthmus_PDBColumns_h
#define isthmus_PDBColumns_h

#include "Core/Progress.h"
#include "Files/TextLines.h"
#include "Molecules/Macromolecule.h"
#include "Molecules/PDBLines.h"
#include "Molecules/ReadingReport.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace isthmus
{

constexpr bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

/**
 * The columns (from 0) where x, y and z begin and z ends: 30, 38, 46 and 54, unless the numbers
 * have three decimals, are adjacent, and one of them is wider than eight columns.
 */
std::array<std::size_t, 4> CoordinateColumns(std::string_view atom);

/// Number of columns by which everything after the coordinates is shifted.
inline std::size_t CoordinateShift(std::string_view atom)
{
  return CoordinateColumns(atom)[3] - 54;
}

/**
 * Whether the last line of `text` has no line end and ends within an atom or a CONECT record:
 * within a field of the columns of PDB, or before the end of the atom before it.
 */
bool EndsWithinRecord(std::string_view text, const PDBLines& lines);

/// Consecutive lines with the same residue in columns 18-27 and the same segment.
struct PDBRun
{
  std::size_t First; ///< of PDBLines::Atoms
  std::size_t Last;
  std::size_t Part; ///< of the model
  std::size_t Copy; ///< of its chain, 0: the first; see FindCopies
  std::string Name;
  std::string Chain;
  std::string FileChain; ///< as the file has it, before chains of several parts are renamed
  std::string Segment;
  std::optional<int> Number;
  char InsertionCode = ' ';
};

/// The meaning of four letters in columns 18-21 in a file.
class PDBResidueNames
{
public:
  PDBResidueNames() = default;
  explicit PDBResidueNames(const std::vector<PDBRun>& runs, const PDBLines& lines);

  /// Whether columns 18-22 are a residue name of four letters and a chain name of one.
  bool IsLong(std::string_view fiveColumns) const;

private:
  std::unordered_set<std::string> Long;
};

/**
 * The decoded runs of a model. `withSegments`: columns 73-76 are segments, and are used as chain
 * names if column 22 is blank. Chains of later parts get unused names if their names occur in
 * earlier parts, and so do copies of chains. O(atoms).
 */
std::vector<PDBRun> ReadRuns(const PDBLines& lines, const PDBModel& model, bool withSegments,
  PDBResidueNames& names, ReadingReport& report);

/**
 * Sets Copy of runs: amino acids and nucleotides that come again after other residues, with the
 * same name, number and chain and at least half of their atoms, begin a copy of the chain if larger
 * numbers came before (some programs number all residues 1). TER
 * between copies may be missing. Water and ligands that follow belong to the last copy.
 */
void FindCopies(const PDBLines& lines, std::vector<PDBRun>& runs);

/// Renames chains of later parts, and copies of chains, whose names occur before.
void RenameChains(std::vector<PDBRun>& runs, ReadingReport& report);

/// The atoms of lines of a file, each read independently, in their order.
using AtomLinesReader =
  std::function<std::vector<Atom>(const std::vector<std::string_view>&, const ProgressCallback&)>;

/**
 * The atoms of one model of a file with records like PDB (PQR, PDBQT), read from their lines by
 * `read`, and the number of models. Empty if there is no such model.
 */
Macromolecule ReadModelOfRecords(std::string_view text, std::int64_t model,
  const PDBAtomText& atoms, const AtomLinesReader& read, ReadingReport& report,
  const ProgressCallback& progress);

/// The number in `text` in base 10, 16 (hexadecimal) or 36 (hybrid-36 of four or five columns, as
/// cctbx writes it), if it is one.
std::optional<int> PDBNumber(std::string_view text, int base);

/**
 * Numbers that can be interpreted only from the preceding ones: hexadecimal digits without letters,
 * and asterisks.
 */
class PDBSerials
{
public:
  /// The number in `field`, which may have blanks around it; if it is not a number, one more than
  /// the previous number.
  int Next(std::string_view field);

  bool AnyHexadecimal() const { return this->IsHexadecimal; }

private:
  int Last = 0;
  bool IsHexadecimal = false;
};

}

#endif
