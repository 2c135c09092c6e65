/**
 * @file ExtremeInputs.h
 * @brief Volumes and surfaces of any scale, and the outcome of a filter that receives them.
 */
#ifndef isthmus_ExtremeInputs_h
#define isthmus_ExtremeInputs_h

#include "SurfaceModels.h"
#include "TopologyFilterRun.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <cmath>
#include <limits>
#include <string>

namespace isthmus::testing
{

inline constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// A ball of density, 12 nodes each way.
inline vtkSmartPointer<vtkImageData> Ball(double hx, double hy, double hz, double origin = 0.0)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(12, 12, 12);
  image->SetSpacing(hx, hy, hz);
  image->SetOrigin(origin, 0.0, 0.0);
  vtkNew<vtkFloatArray> values;
  values->SetName("Density");
  for (int node = 0; node < 12 * 12 * 12; ++node)
  {
    const double x = node % 12 - 5.5, y = node / 12 % 12 - 5.5, z = node / 144 - 5.5;
    values->InsertNextValue(static_cast<float>(std::exp(-(x * x + y * y + z * z) / 12.0)));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

inline vtkSmartPointer<vtkPolyData> Scale(Model model, double factor)
{
  for (Vector& p : model.Points)
  {
    for (double& x : p)
    {
      x *= factor;
    }
  }
  return ToPolyData(model);
}

inline vtkSmartPointer<vtkPolyData> OnePointAt(double place)
{
  Model model = Icosphere(3, 1.0);
  model.Points[5] = { place, 0.0, 0.0 };
  return ToPolyData(model);
}

inline bool AllFinite(vtkDataArray* array)
{
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      if (!std::isfinite(array->GetComponent(i, c)))
      {
        return false;
      }
    }
  }
  return true;
}

/// An error message and an empty output, or a result whose points are finite.
template <typename Filter>
std::string Outcome(TopologyFilterRun<Filter>& run, vtkPointSet* output)
{
  if (!run.Messages().empty() && output->GetNumberOfPoints() == 0)
  {
    return "refused";
  }
  return !output->GetPoints() || AllFinite(output->GetPoints()->GetData()) ? "result"
                                                                           : "not finite";
}

}

#endif
