/**
 * @file PDBFile.h
 * @brief Atoms and bonds of PDB files, in the columns of the format and of simulation programs.
 *
 * The format is wwPDB's 3.3 with the extensions of PDBColumns.h. Lines are read independently: a
 * record that cannot be read is dropped without affecting others, and is counted in the report.
 * Coordinates wider than their eight columns are also read, if everything after them is shifted.
 */
#ifndef isthmus_PDBFile_h
#define isthmus_PDBFile_h

#include "Core/Progress.h"
#include "Molecules/PDBLines.h"
#include "Molecules/ReadingReport.h"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace isthmus
{

/// Thrown for a line whose coordinates are not in the columns of PDB.
struct NonstandardColumnsError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

struct PDBMolecule
{
  std::vector<Atom> Atoms;           ///< in the order of the file, but those of a residue together
  std::vector<std::size_t> Residues; ///< the first atom of each
  std::vector<Bond> Bonds;           ///< of CONECT, each as often as the file names it
  std::vector<Bond> Links;           ///< of SSBOND and LINK, within the asymmetric unit
};

/**
 * Reads one model. Lines of a chain with the same residue (number, insertion code, segment and
 * name) are one residue, even if other residues are between them. `isOfCopies`: the parts of the
 * model are copies, to each of which CONECT, SSBOND and LINK apply. Time and memory O(bytes).
 * @throws NonstandardColumnsError if the coordinates of an atom are not finite numbers,
 * std::runtime_error if a line ends within them, both with the first such line; Cancelled.
 */
PDBMolecule ReadPDBModel(std::string_view text, const std::string& path, const PDBLines& lines,
  const PDBModel& model, bool isOfCopies, ReadingReport& report, const ProgressCallback& progress);

}

#endif
