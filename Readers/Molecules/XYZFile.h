/**
 * @file XYZFile.h
 * @brief Atoms from XYZ files.
 *
 * A frame is a line with the number of atoms, a line of comment, and a line for each atom: symbol
 * or atomic number, x, y, z in angstrom; what follows on the line is left out. Frames are models.
 */
#ifndef isthmus_XYZFile_h
#define isthmus_XYZFile_h

#include "Core/Progress.h"
#include "Molecules/Macromolecule.h"
#include "vtkIsthmusReadersMoleculesModule.h"

#include <string>
#include <string_view>

namespace isthmus
{

/**
 * The atoms of frame `model` (from 0); name and residue name are the symbol and empty. O(bytes).
 * @throws std::runtime_error with file, line and reason, also when the comment of an extended XYZ
 * file announces other columns.
 */
VTKISTHMUSREADERSMOLECULES_EXPORT Macromolecule ParseXYZ(std::string_view text,
  const std::string& path, std::int64_t model, const ProgressCallback& progress);

}

#endif
