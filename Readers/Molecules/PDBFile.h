/**
 * @file PDBFile.h
 * @brief Atoms and bonds of PDB files, in the columns of the format and of simulation programs.
 *
 * The format is wwPDB's 3.3 with the extensions of PDBColumns.h. Lines are read independently: a
 * record that cannot be read is dropped without affecting others, and is counted in the report.
 * Coordinates wider than their eight columns are also read, if everything after them is shifted.
 * If values are not in the columns of PDB, they are separated at blanks, with a warning.
 */
#ifndef isthmus_PDBFile_h
#define isthmus_PDBFile_h

#include "Molecules/MoleculeParsers.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace isthmus
{

/**
 * Atoms in the order of the file, except that the atoms of a residue are consecutive. Bonds are
 * those of CONECT, SSBOND and LINK within the asymmetric unit; charges are formal charges, if the
 * file has any that are not 0. Lines are read in pieces of `bytesOfAPiece`, several in parallel;
 * the size does not affect the result.
 */
Macromolecule ParsePDB(std::string_view text, const std::string& path,
  const StructureChoice& choice, const ProgressCallback& progress, std::size_t bytesOfAPiece);

}

#endif
