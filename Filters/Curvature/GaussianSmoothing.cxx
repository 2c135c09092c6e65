#include "Curvature/GaussianSmoothing.h"

#include "Core/InnerAlgorithm.h"
#include "Core/RangeChecks.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isthmus
{
namespace
{

constexpr double cutOff = 4.0;

/// Standard deviation in nodes.
double Deviation(double scale, double spacing)
{
  return scale / std::abs(spacing);
}

}

void CheckScale(double scale, const double spacing[3], const std::array<std::int64_t, 3>& nodes)
{
  constexpr double mostNodes =
    1e6; // of the kernel, which vtkImageGaussianSmooth rounds to an integer
  double longest = 0.0;
  double most = LargestLength;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double step = std::abs(spacing[axis]);
    longest = std::max(longest, step * static_cast<double>(nodes[axis]));
    most = std::min(most, step * mostNodes / cutOff);
  }
  RequireRange("Scale", scale, 0.0, std::min(longest, most),
    "It is the standard deviation of a Gaussian, in the unit of the spacing: at most the longest "
    "side of the image, with a kernel of at most a million nodes.");
}

std::array<int, 3> GaussianReach(double scale, const double spacing[3])
{
  std::array<int, 3> reach{};
  for (int axis = 0; axis < 3; ++axis)
  {
    // Half of the range leaves room for the sums of extents that follow; NaN gives 0.
    constexpr double most = std::numeric_limits<int>::max() / 2.0;
    const double nodes = cutOff * Deviation(scale, spacing[axis]);
    reach[axis] = nodes > 0.0 ? static_cast<int>(std::min(nodes, most)) : 0;
  }
  return reach;
}

vtkSmartPointer<vtkDataArray> SmoothAtScale(
  vtkImageData* image, vtkDataArray* scalars, double scale, const ProgressCallback& progress)
{
  vtkSmartPointer<vtkDataArray> values = scalars;
  if (scalars->GetDataType() != VTK_FLOAT && scalars->GetDataType() != VTK_DOUBLE)
  {
    values = vtkSmartPointer<vtkFloatArray>::New();
    values->DeepCopy(scalars);
  }
  vtkNew<vtkImageData> field;
  field->CopyStructure(image);
  field->GetPointData()->SetScalars(values);

  vtkNew<vtkImageGaussianSmooth> smoother;
  smoother->SetInputData(field);
  smoother->SetDimensionality(3);
  const double* spacing = image->GetSpacing();
  smoother->SetStandardDeviations(
    Deviation(scale, spacing[0]), Deviation(scale, spacing[1]), Deviation(scale, spacing[2]));
  smoother->SetRadiusFactors(cutOff, cutOff, cutOff);
  UpdateInner(smoother, progress);
  return smoother->GetOutput()->GetPointData()->GetScalars();
}

}
