/**
 * @file PrintableText.h
 * @brief Text of files and programs, made printable for error messages.
 */
#ifndef isthmus_PrintableText_h
#define isthmus_PrintableText_h

#include "vtkIsthmusFiltersCoreModule.h"

#include <string>

namespace isthmus
{

/// `text` with a question mark for each byte that is not part of valid UTF-8, or a control
/// character other than a line end. Python observers receive nothing for a message that is not
/// valid UTF-8.
VTKISTHMUSFILTERSCORE_EXPORT std::string Printable(const std::string& text);

}

#endif
