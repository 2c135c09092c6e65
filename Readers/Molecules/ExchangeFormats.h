/**
 * @file ExchangeFormats.h
 * @brief Reads atoms from the files of docking and simulation programs: PDBQT, GRO, MOL2, SDF.
 *
 * - PDBQT (AutoDock, Vina): lines of PDB with a partial charge in columns 67-76 and a type of
 *   AutoDock in 78-79, from which the element comes. MODEL begins a pose. ROOT, BRANCH and TORSDOF
 *   are skipped. Pseudo atoms (G0, W) have no element.
 * - GRO (GROMACS): a title, the number of atoms, a line of columns for each, the box; again for
 *   each frame. Lengths are converted from nm in the file to angstrom; velocities are skipped. The
 *   number of decimals follows from the first line. Elements come from names.
 * - MOL2 (Tripos): MOLECULE, ATOM and BOND sections; elements from the types, charges unless the
 *   molecule says NO_CHARGES. Each molecule is a model.
 * - SDF and MOL (MDL): V2000 and V3000, formal charges. Each molecule ($$$$) is a model.
 *
 * Bonds of MOL2 and SDF are read from the file.
 */
#ifndef isthmus_ExchangeFormats_h
#define isthmus_ExchangeFormats_h

#include "Core/Progress.h"
#include "Molecules/Macromolecule.h"

#include <string>
#include <string_view>

namespace isthmus
{

/**
 * The atoms of one model (counted from 0) of a text in one of these four formats. O(bytes).
 * @throws std::runtime_error with file, line and reason.
 */
Macromolecule ParseExchangeFormat(std::string_view text, const std::string& path,
  MoleculeFormat format, std::int64_t model, const ProgressCallback& progress);

}

#endif
