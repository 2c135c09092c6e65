/**
 * @file MRCHeaderDecoder.h
 * @brief From the words of an MRC header to a header that can be used: what is out of bounds is
 * replaced, with a sentence.
 */
#ifndef isthmus_MRCHeaderDecoder_h
#define isthmus_MRCHeaderDecoder_h

#include "Maps/MRCHeader.h"
#include "Maps/MRCHeaderWords.h"

namespace isthmus
{

/// The header of `bytes`, whose words are `words`; what was replaced is told in its Repairs. Sizes
/// are not compared with those of the file.
/// @pre words.Possible()
MRCHeader DecodeMRCHeader(const MRCHeaderBytes& bytes, const MRCHeaderWords& words);

}

#endif
