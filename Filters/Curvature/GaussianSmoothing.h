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

/// @throws std::invalid_argument, with the valid range, if a kernel with standard deviation `scale`
/// is too large for an image of `nodes` nodes with `spacing`: it may be at most as long as the
/// image's longest side, and at most a million nodes wide.
void CheckScale(double scale, const double spacing[3], const std::array<std::int64_t, 3>& nodes);

/// Number of nodes that a kernel of standard deviation `scale` reaches on each axis.
std::array<int, 3> GaussianReach(double scale, const double spacing[3]);

/**
 * `scalars` of the points of `image`, smoothed by vtkImageGaussianSmooth with standard deviation
 * `scale` (unit of the spacing), with the kernel cut at four standard deviations and renormalised
 * at the border. Float and double scalars keep their type, others become float. O(nodes x scale /
 * spacing) time on one thread; memory for one copy, and for a second one in float if the type is
 * neither.
 */
vtkSmartPointer<vtkDataArray> SmoothAtScale(
  vtkImageData* image, vtkDataArray* scalars, double scale, const ProgressCallback& progress);

}

#endif
