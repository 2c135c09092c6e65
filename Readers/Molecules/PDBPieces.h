/**
 * @file PDBPieces.h
 * @brief A large PDB file read by gemmi in pieces, several at once.
 *
 * gemmi's reading is most of what reading a PDB file costs, and runs on one thread. Where one atom
 * comes after the other and no record speaks of others far away, pieces of the file can be read by
 * themselves: chains and residues that go on in the next piece are joined by gemmi's own rule (a
 * residue is one where number, insertion code, segment and name agree within a chain).
 */
#ifndef isthmus_PDBPieces_h
#define isthmus_PDBPieces_h

#include "Core/Progress.h"
#include "Molecules/Macromolecule.h"
#include "vtkIsthmusReadersMoleculesModule.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isthmus
{

struct JoinedPDB
{
  Macromolecule Molecule;                 ///< its only model
  std::vector<std::array<int, 2>> Bonded; ///< serial numbers of the CONECT records
};

/**
 * The atoms of `text` in the order and with the values that the file read whole gives, by pieces
 * of about `bytesOfAPiece`; the number of threads makes no difference. Nothing where that can't be
 * promised, and the file is to be read whole: fewer than two pieces, records MODEL, ENDMDL, SSBOND,
 * LINK, CISPEP, an END before the last piece, or anything at all that is wrong.
 * @throws Cancelled.
 */
VTKISTHMUSREADERSMOLECULES_EXPORT std::optional<JoinedPDB> ReadPDBInPieces(std::string_view text,
  const std::string& path, std::size_t bytesOfAPiece, const ProgressCallback& progress);

}

#endif
