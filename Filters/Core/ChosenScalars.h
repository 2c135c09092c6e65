/**
 * @file ChosenScalars.h
 * @brief The point array of an image that a filter is to work on.
 */
#ifndef isthmus_ChosenScalars_h
#define isthmus_ChosenScalars_h

#include "vtkIsthmusFiltersCoreModule.h"

class vtkAlgorithm;
class vtkDataArray;
class vtkImageData;

namespace isthmus
{

/// The array that the filter's input array 0 names; the active scalars where it names none: a panel
/// that has seen no data yet sends an empty name.
/// @throws std::invalid_argument, with the arrays that there are, unless it is one number for each
/// node.
VTKISTHMUSFILTERSCORE_EXPORT vtkDataArray* ChosenScalars(vtkAlgorithm* filter, vtkImageData* image);

}

#endif
