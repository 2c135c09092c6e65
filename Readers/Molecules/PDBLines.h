/**
 * @file PDBLines.h
 * @brief The records of a PDB file, and the models that they form.
 */
#ifndef isthmus_PDBLines_h
#define isthmus_PDBLines_h

#include "Core/Progress.h"
#include "Molecules/MoleculeOptions.h"
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
    Link,     ///< SSBOND, LINK, LINKR
    Cell      ///< CRYST1
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
 * With `combine` Automatic, models of MODEL or ENDMDL are one structure where no two of them
 * overlap, those with the same atoms are rigid copies of each other, and the others have other
 * chains: the copies of a biological unit lie beside each other, while the models of an ensemble
 * and the frames of a trajectory lie on each other or differ in shape. Models of fewer than four
 * residues (poses of ligands, ions) stay models.
 *
 * Atoms outside MODEL and ENDMDL belong to the preceding model, or to the first one. Groups of
 * parts may repeat as well. Decisions are noted in `report`.
 */
std::vector<PDBModel> FindModels(const PDBLines& lines, ReadingReport& report,
  const PDBAtomText& atoms = PDBColumnsOfAtoms, ModelCombination combine = ModelCombination::Never);

/// What CRYST1 gives; empty if there is none, it is a dummy, or it cannot be read.
struct PDBCell
{
  std::vector<std::array<double, 3>> Vectors;
  std::string SpaceGroup;
};

/// The last record CRYST1 before the atoms of a model, or else the first one.
PDBCell FindCell(const PDBLines& lines, const PDBModel& model);

/// Whether FindModels has combined the models of a file to one.
bool AreCombined(const PDBLines& lines, const std::vector<PDBModel>& models);

}

#endif
