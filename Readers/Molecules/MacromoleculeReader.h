/**
 * @file MacromoleculeReader.h
 * @brief Reads molecules from files of the formats in MoleculeFormats.h, plain or compressed.
 */
#ifndef isthmus_MacromoleculeReader_h
#define isthmus_MacromoleculeReader_h

#include "Core/Progress.h"
#include "Molecules/Macromolecule.h"

#include <cstdint>
#include <string>

namespace isthmus
{

/**
 * Reads one model. Radii are those of the file (PQR) or of the table; atoms without a radius have
 * NaN and are listed in a warning. Bonds are those of the file and, if BondsByDistance, those by
 * distance (CovalentBonds.h).
 * @throws std::runtime_error with a message if the file is missing, damaged, of another format,
 * without atoms, or without the requested model or chain; Cancelled.
 *
 * Time: O(bytes + n log n); memory: the text and about 250 bytes for each atom.
 */
Macromolecule ReadMacromolecule(
  const std::string& path, const MoleculeOptions& options, const ProgressCallback& progress = {});

/// The same from a text in memory; `path` is for the messages, and for the format if it is not
/// given.
Macromolecule ParseMacromolecule(std::string_view text, const std::string& path,
  const MoleculeOptions& options, const ProgressCallback& progress = {});

/**
 * The number of models in a file, which is parsed; `parsed` is set to the first one, for
 * CompleteMacromolecule. Throws as ReadMacromolecule.
 */
std::int64_t CountModels(const std::string& path, MoleculeFormat format,
  Macromolecule* parsed = nullptr, ModelCombination combine = ModelCombination::Automatic);

/// The result of ReadMacromolecule for model 0 without an assembly, from the data parsed by
/// CountModels.
Macromolecule CompleteMacromolecule(Macromolecule parsed, const std::string& path,
  const MoleculeOptions& options, const ProgressCallback& progress = {});

/// Whether the file exists, has the name of one of the formats, and begins with text.
bool LooksLikeMolecule(const std::string& path);

}

#endif
