/**
 * @file PQRFile.h
 * @brief Reads atoms with charges and radii from PQR files.
 *
 * PQR (T. J. Dolinsky et al., Nucleic Acids Res. 32 (2004) W665; apbs.readthedocs.io, PQR) has a
 * line for each atom. Two dialects are in use, and each line is read in its own:
 *  - words: ATOM serial name residue [chain] number[insertion code] x y z charge radius [element];
 *    chain and number may run together (A1003), as may the first word and the serial (ATOM100000);
 *  - columns as in PDB files, where numbers may run together: name 13-16, residue 17-21, chain 22,
 *    number 23-26, insertion code 27, x 31-38, y 39-46, z 47-54, then charge and radius as two
 *    words or in columns 55-62 and 63-70.
 *
 * Lines that begin with HETATM are hetero atoms; MODEL, ENDMDL and END separate models or parts as
 * in PDB files (PDBLines.h); other lines are ignored.
 */
#ifndef isthmus_PQRFile_h
#define isthmus_PQRFile_h

#include "Core/Progress.h"
#include "Molecules/Macromolecule.h"

#include <string>
#include <string_view>

namespace isthmus
{

/**
 * The atoms of one model (counted from 0). Charges and radii are the doubles nearest to the text;
 * elements are inferred from names. O(bytes).
 * @throws std::runtime_error with file, line and reason.
 */
Macromolecule ParsePQR(std::string_view text, const std::string& path, std::int64_t model,
  const ProgressCallback& progress);

/// The number of models that ParsePQR finds, at least one.
std::int64_t CountPQRModels(std::string_view text);

}

#endif
