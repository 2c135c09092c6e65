/**
 * @file GemmiStructure.h
 * @brief Atoms from PDB and mmCIF files, by gemmi.
 *
 * gemmi (M. Wojdyr, J. Open Source Softw. 7 (2022) 4200) reads wwPDB's format 3.3, hybrid-36
 * numbers and PDBx/mmCIF. Around it, what it leaves out: coordinates that are no numbers are
 * refused, occupancies and B factors that are blank are unknown (not 1 and 20), CONECT records are
 * bonds, old files with text in columns 73-80 are read without those columns, and files whose
 * values stand elsewhere than in PDB's columns are read by the blanks between them; both with a
 * warning.
 */
#ifndef isthmus_GemmiStructure_h
#define isthmus_GemmiStructure_h

#include "Core/Progress.h"
#include "Molecules/Macromolecule.h"
#include "vtkIsthmusReadersMoleculesModule.h"

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
 * charges are formal ones, where the file gives any other than 0. Radii are not set. Time and
 * memory O(bytes).
 * @throws std::runtime_error with file and reason.
 */
VTKISTHMUSREADERSMOLECULES_EXPORT Macromolecule ParsePDB(std::string_view text,
  const std::string& path, const StructureChoice& choice, const ProgressCallback& progress);

/// The same for mmCIF; bonds are those of struct_conn, hydrogen bonds left out.
VTKISTHMUSREADERSMOLECULES_EXPORT Macromolecule ParseMMCIF(std::string_view text,
  const std::string& path, const StructureChoice& choice, const ProgressCallback& progress);

}

#endif
