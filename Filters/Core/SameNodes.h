/**
 * @file SameNodes.h
 * @brief Whether two images, two half maps for example, have the same nodes.
 */
#ifndef isthmus_SameNodes_h
#define isthmus_SameNodes_h

#include "vtkIsthmusFiltersCoreModule.h"

class vtkImageData;

namespace isthmus
{

/// @throws std::invalid_argument unless both half maps have the same dimensions, spacing, origin
/// and direction, to 1e-4 of a spacing.
VTKISTHMUSFILTERSCORE_EXPORT void RequireSameNodes(vtkImageData* one, vtkImageData* other);

}

#endif
