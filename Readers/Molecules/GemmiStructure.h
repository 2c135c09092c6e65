/**
 * @file GemmiStructure.h
 * @brief Atoms from PDB and mmCIF files, the latter by gemmi.
 *
 * gemmi (M. Wojdyr, J. Open Source Softw. 7 (2022) 4200) reads PDBx/mmCIF and makes biological
 * assemblies of both. Atoms of PDB files are read by PDBFile.h: simulation programs, servers and
 * predictors write columns and separators that gemmi does not expect. Files whose values are
 * elsewhere than in PDB's columns are read by the blanks between them, with a warning.
 */
#ifndef isthmus_GemmiStructure_h
#define isthmus_GemmiStructure_h

#include "Core/Progress.h"
#include "Molecules/Macromolecule.h"
#include "vtkIsthmusReadersMoleculesModule.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace isthmus
{

/// What of a file's structure to take.
struct StructureChoice
{
  std::int64_t Model = 0; ///< from 0
  std::string Assembly; ///< a biological assembly that the file describes; empty: the file as it is
};

/**
 * The atoms of a model in gemmi's order: that of the file, except that atoms of one
 * residue come together. Bonds are those of CONECT, SSBOND and LINK within the asymmetric unit;
 * charges are formal ones, where the file gives any other than 0. Radii are not set. Lines are
 * read in pieces of `bytesOfAPiece`, several at once; their size makes no difference. Time and
 * memory O(bytes).
 * @throws std::runtime_error with file and reason.
 */
VTKISTHMUSREADERSMOLECULES_EXPORT Macromolecule ParsePDB(std::string_view text,
  const std::string& path, const StructureChoice& choice, const ProgressCallback& progress,
  std::size_t bytesOfAPiece = std::size_t{ 1 } << 20);

/// The number of models that ParsePDB finds, at least 1.
VTKISTHMUSREADERSMOLECULES_EXPORT std::int64_t CountPDBModels(std::string_view text);

/// As ParsePDB, for mmCIF; bonds are those of struct_conn, hydrogen bonds left out.
VTKISTHMUSREADERSMOLECULES_EXPORT Macromolecule ParseMMCIF(std::string_view text,
  const std::string& path, const StructureChoice& choice, const ProgressCallback& progress);

}

#endif
