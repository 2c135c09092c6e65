/**
 * @file PrintableText.h
 * @brief What files and programs say, made fit for a sentence.
 */
#ifndef isthmus_PrintableText_h
#define isthmus_PrintableText_h

#include "vtkIsthmusFiltersCoreModule.h"

#include <string>

namespace isthmus
{

/// `text` with a question mark for each byte that is not part of valid UTF-8, or a control
/// character other than a line end. Python's observers get nothing at all for a sentence that is
/// not UTF-8.
VTKISTHMUSFILTERSCORE_EXPORT std::string Printable(const std::string& text);

}

#endif
