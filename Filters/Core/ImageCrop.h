/**
 * @file ImageCrop.h
 * @brief A part of an image, by whole rows.
 */
#ifndef isthmus_ImageCrop_h
#define isthmus_ImageCrop_h

#include "Core/ImageExtent.h"

namespace isthmus
{

/**
 * Makes `image` its own part in `extent`: nodes, cells and all arrays as vtkImageData::Crop leaves
 * them, and none where `extent` has none of it. Linear in the values kept; VTK's goes value by
 * value, which took ten times the curvature of a volume in two pieces.
 */
void CropTo(vtkImageData* image, const Extent& extent);

}

#endif
