/**
 * @file XYZFile.h
 * @brief Atoms from XYZ files.
 *
 * A frame is a line with the number of atoms, a line of comment, and a line for each atom: symbol
 * or atomic number, x, y, z in angstrom; the rest of the line is ignored. Frames are models.
 *
 * Extended XYZ names its columns in the comment (Properties=species:S:1:pos:R:3:...), in any order:
 * species (or Z), pos, charge (or charges, initial_charges, q) and radius are read.
 *
 * TINKER's XYZ has no comment: number of atoms and title, perhaps a line with the box, and for each
 * atom its number, name, x, y, z, type and the numbers of the bonded atoms.
 */
#ifndef isthmus_XYZFile_h
#define isthmus_XYZFile_h

#include "Core/Progress.h"
#include "Molecules/Macromolecule.h"

#include <string>
#include <string_view>

namespace isthmus
{

/**
 * The atoms of frame `model` (from 0); the atom name is the symbol, and the residue name is empty.
 * O(bytes).
 * @throws std::runtime_error with file, line and reason, also if the comment of an extended XYZ
 * file lacks species or positions.
 */
Macromolecule ParseXYZ(std::string_view text, const std::string& path, std::int64_t model,
  const ProgressCallback& progress);

}

#endif
