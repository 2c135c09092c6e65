/**
 * @file MRCHeaderParser.h
 * @brief From the bytes of an MRC header and the size of its file to the header, or to a refusal.
 */
#ifndef isthmus_MRCHeaderParser_h
#define isthmus_MRCHeaderParser_h

#include "Maps/MRCHeader.h"

namespace isthmus
{

/**
 * Decodes `bytes`. The byte order is the machine stamp's unless the header makes sense only in the
 * other one. Fields that are out of bounds are replaced, each with a sentence in Repairs.
 *
 * `path` is for the sentences. `contentBytes` is what the content has at most; when it is `exact`,
 * a content that is shorter than the header describes is an error, a longer one a repair.
 * @throws ReaderError: ForeignFormat when mode or grid make no sense in either order, Truncated.
 */
MRCHeader ParseMRCHeader(const std::array<unsigned char, mrcHeaderBytes>& bytes,
  const std::string& path, std::uint64_t contentBytes, bool exact);

/**
 * True when `bytes` are surely or probably the header of a map: grid and mode make sense, and there
 * is "MAP " or everything else does, too. Never throws.
 */
bool LooksLikeMRCHeader(
  const std::array<unsigned char, mrcHeaderBytes>& bytes, std::uint64_t contentBytes);

}

#endif
