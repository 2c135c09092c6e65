/**
 * @file GemmiStructure.h
 * @brief Atoms from PDB and mmCIF files, the latter by gemmi.
 *
 * gemmi (M. Wojdyr, J. Open Source Softw. 7 (2022) 4200) reads PDBx/mmCIF, and generates biological
 * assemblies for both formats. Atoms of PDB files are read by PDBFile.h: simulation programs,
 * servers and predictors write columns and separators that gemmi does not expect. If values are not
 * in the columns of PDB, they are separated at blanks, with a warning.
 */
#ifndef isthmus_GemmiStructure_h
#define isthmus_GemmiStructure_h

#include "Core/Progress.h"
#include "Molecules/Macromolecule.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace isthmus
{

/// The part of the structure of a file to read.
struct StructureChoice
{
  std::int64_t Model = 0; ///< from 0
  std::string Assembly; ///< a biological assembly that the file describes; empty: the file as it is
  ModelCombination Combine = ModelCombination::Automatic; ///< of models of a PDB file
};

/**
 * The atoms of a model in gemmi's order: that of the file, except that the atoms of a residue are
 * consecutive. Bonds are those of CONECT, SSBOND and LINK within the asymmetric unit; charges are
 * formal charges, if the file has any that are not 0. Radii are not set. Lines are read in pieces
 * of `bytesOfAPiece`, several in parallel; the size does not affect the result. Time and memory:
 * O(bytes).
 * @throws std::runtime_error with file and reason.
 */
Macromolecule ParsePDB(std::string_view text, const std::string& path,
  const StructureChoice& choice, const ProgressCallback& progress,
  std::size_t bytesOfAPiece = std::size_t{ 1 } << 20);

/// The number of models that ParsePDB finds, at least 1.
std::int64_t CountPDBModels(std::string_view text, ModelCombination combine);

/// Like ParsePDB, for mmCIF; bonds are those of struct_conn, without hydrogen bonds.
Macromolecule ParseMMCIF(std::string_view text, const std::string& path,
  const StructureChoice& choice, const ProgressCallback& progress);

}

#endif
