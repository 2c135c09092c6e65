/**
 * @file MoleculeParsers.h
 * @brief What the source of each format of MoleculeFormats.h defines, and how a format is chosen.
 */
#ifndef isthmus_MoleculeParsers_h
#define isthmus_MoleculeParsers_h

#include "Core/Progress.h"
#include "Molecules/Macromolecule.h"

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
 * ParseNAME: one model of a text, without radii and bonds by distance; no atoms if there is no such
 * model; NumberOfModels is that of the file. `path` is for messages. Time and memory O(bytes).
 * @throws std::runtime_error with file, line and reason; Cancelled.
 *
 * IsNAME: whether a text has the format, where its content says so.
 */
#define ISTHMUS_DECLARE_PARSER(Name, Label, Endings)                                               \
  Macromolecule Parse##Name(std::string_view text, const std::string& path,                        \
    const StructureChoice& choice, const ProgressCallback& progress);                              \
  bool Is##Name(std::string_view text);
ISTHMUS_MOLECULE_FORMATS(ISTHMUS_DECLARE_PARSER)

/// A row of MoleculeFormats.h.
struct MoleculeFormatRow
{
  MoleculeFormat Format;
  const char* Label;
  std::string_view Endings;
  Macromolecule (*Parse)(std::string_view text, const std::string& path,
    const StructureChoice& choice, const ProgressCallback& progress);
  bool (*IsFormat)(std::string_view text);
};

const MoleculeFormatRow& FindFormat(MoleculeFormat format);

/// Each with a full stop before it and a blank after it.
const std::string& MoleculeEndings();

/// ByName if the name has none of the endings.
MoleculeFormat FormatFromName(const std::string& path);

/// For names without a known ending. @throws std::runtime_error with advice.
MoleculeFormat FormatFromText(std::string_view text, const std::string& path);

/// The actual content of a file if it does not match its name, with advice; empty if unknown.
std::string DescribeForeignContent(std::string_view text, MoleculeFormat format);

}

#endif
