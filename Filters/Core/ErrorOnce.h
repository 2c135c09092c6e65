/**
 * @file ErrorOnce.h
 * @brief An error is told in one sentence, once.
 */
#ifndef isthmus_ErrorOnce_h
#define isthmus_ErrorOnce_h

#include "vtkIsthmusFiltersCoreModule.h"

#include <string>

class vtkAlgorithm;

namespace isthmus
{

/**
 * Tells `sentence` through vtkErrorMacro, unless it is what `self` said last and nothing has
 * changed since: neither `self` nor what it stands on.
 *
 * A pipeline asks for information and for data, the window does so for each of its parts, and
 * composite data bring a block at a time; all of them meet the same obstacle.
 */
VTKISTHMUSFILTERSCORE_EXPORT void TellError(vtkAlgorithm* self, const std::string& sentence);

}

#endif
