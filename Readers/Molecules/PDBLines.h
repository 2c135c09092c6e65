/**
 * @file PDBLines.h
 * @brief The records of a PDB file, and the models that they form.
 */
#ifndef isthmus_PDBLines_h
#define isthmus_PDBLines_h

#include "Core/Progress.h"
#include "Molecules/ReadingReport.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace isthmus
{

/// A record other than an atom, and the number of atoms before it.
struct PDBRecord
{
  enum class Kind
  {
    Model,    ///< MODEL
    EndModel, ///< ENDMDL
    End,      ///< END
    Conect,   ///< CONECT
    Link      ///< SSBOND, LINK, LINKR
  };

  Kind Is;
  std::size_t Atom;
  std::string_view Line;
};

/// The used lines of a file in order; they point into its text.
struct PDBLines
{
  std::vector<std::string_view> Atoms; ///< ATOM and HETATM, in capitals or not
  std::vector<PDBRecord> Records;
};

/// Atoms [First, Last) of PDBLines::Atoms.
struct PDBPart
{
  std::size_t First;
  std::size_t Last;
};

/// The parts of the file that a model consists of.
using PDBModel = std::vector<PDBPart>;

/**
 * Finds the records of `text`, in pieces of about `bytesOfAPiece`, several in parallel; the size
 * does not affect the result. Lines end at a zero byte. All other records are ignored, whatever
 * they contain.
 * @throws Cancelled.
 */
PDBLines SplitPDB(
  std::string_view text, std::size_t bytesOfAPiece, const ProgressCallback& progress);

/// "line 7" of `text`, for messages. O(bytes before it).
std::string FormatLineNumber(std::string_view text, std::string_view line);

/// The parts of the lines of atoms that FindModels reads; by default the columns of PDB.
struct PDBAtomText
{
  /// Whether two lines describe the same atom: name, location, residue and chain.
  bool (*IsSame)(std::string_view a, std::string_view b);
  /// False: there are no coordinates.
  bool (*Place)(std::string_view atom, std::array<double, 3>& place);
};
extern const PDBAtomText PDBColumnsOfAtoms;

/**
 * The models of a file.
 *
 * - With MODEL: it begins a model, whatever its number. ENDMDL may be missing, or single MODEL
 *   records may be missing if ENDMDL is present.
 * - Without MODEL, but with ENDMDL: each part that ENDMDL or END ends is a model.
 * - With END alone: parts that repeat the same atoms at overlapping places are models.
 * - All other parts that END separates are one structure.
 *
 * Atoms outside MODEL and ENDMDL belong to the preceding model, or to the first one. Groups of
 * parts may repeat as well. Decisions are noted in `report`.
 */
std::vector<PDBModel> FindModels(
  const PDBLines& lines, ReadingReport& report, const PDBAtomText& atoms = PDBColumnsOfAtoms);

}

#endif
