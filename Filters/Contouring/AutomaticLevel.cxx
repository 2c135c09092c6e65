#include "Contouring/AutomaticLevel.h"

#include "Contouring/LevelEstimate.h"
#include "Core/ImageScalars.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>

#include <algorithm>
#include <vector>

namespace isthmus
{

double AutomaticLevel::Of(vtkImageData* image, vtkDataArray* scalars, bool insideIsHigher)
{
  vtkDataArray* recommended = image->GetFieldData()->GetArray("RecommendedLevel");
  if (recommended && recommended->GetNumberOfValues() == 1)
  {
    return recommended->GetComponent(0, 0);
  }
  const vtkMTimeType time = std::max(scalars->GetMTime(), image->GetMTime());
  if (this->Scalars != scalars || this->Time != time || this->InsideIsHigher != insideIsHigher)
  {
    std::vector<double> values;
    UseScalars(image, scalars, [&](const auto& grid) { values = SampleValues(grid); });
    const double sign = insideIsHigher ? 1.0 : -1.0;
    std::transform(
      values.begin(), values.end(), values.begin(), [sign](double value) { return sign * value; });
    this->Cached = sign * EstimateLevel(values);
    this->Scalars = scalars;
    this->Time = time;
    this->InsideIsHigher = insideIsHigher;
  }
  return this->Cached;
}

}
