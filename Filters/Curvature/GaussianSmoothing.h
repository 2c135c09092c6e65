/**
 * @file GaussianSmoothing.h
 * @brief Gaussian smoothing of image scalars at a length scale, before they are differentiated.
 */
#ifndef isthmus_GaussianSmoothing_h
#define isthmus_GaussianSmoothing_h

#include "Core/Progress.h"

#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>

class vtkDataArray;
class vtkImageData;

namespace isthmus
{

/// @throws std::invalid_argument, with the range, unless a kernel of standard deviation `scale` is
/// one for an image of `nodes` nodes of `spacing`: at most the image's longest side, and at most a
/// million nodes wide.
void CheckScale(double scale, const double spacing[3], const std::array<std::int64_t, 3>& nodes);

/// Nodes that the kernel of standard deviation `scale` reaches on each axis of `spacing`.
std::array<int, 3> GaussianReach(double scale, const double spacing[3]);

/**
 * `scalars` of the points of `image`, smoothed by vtkImageGaussianSmooth with standard deviation
 * `scale` (unit of the spacing), kernel cut at four of these and renormalised at the border. Float
 * and double stay, other types become float. O(nodes x scale / spacing) time on one thread; memory
 * of one copy, and of another one in float for types that are neither.
 */
vtkSmartPointer<vtkDataArray> SmoothAtScale(
  vtkImageData* image, vtkDataArray* scalars, double scale, const ProgressCallback& progress);

}

#endif
