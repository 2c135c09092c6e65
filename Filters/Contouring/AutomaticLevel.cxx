#include "Contouring/AutomaticLevel.h"

#include "Contouring/LevelEstimate.h"
#include "Core/ImageScalars.h"
#include "Core/NamedColumns.h"
#include "Core/RangeChecks.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace isthmus
{
namespace
{

/// Of flags and of the fraction of a node that is inside, by the names under which the filters of
/// Isthmus write them, and of signed distances under any name.
std::optional<double> NaturalLevel(vtkImageData* image, vtkDataArray* scalars)
{
  double range[2];
  scalars->GetFiniteRange(range, 0);
  const std::string name = scalars->GetName() ? scalars->GetName() : "";
  constexpr double rounding = 1e-3;
  if ((name == "S" || name == "Inside" || name == "Side") && range[0] >= -rounding &&
    range[1] <= 1.0 + rounding)
  {
    return 0.5;
  }
  bool isDistance = name == "SignedDistance" && range[0] < 0.0 && range[1] > 0.0;
  UseScalars(image, scalars,
    [&](const auto& grid)
    { isDistance = isDistance || IsSignedDistance(grid, NoDataMask(image)); });
  return isDistance ? std::optional(0.0) : std::nullopt;
}

const char* SourceText(const ChosenLevel& chosen)
{
  switch (chosen.Source)
  {
    case LevelSource::Given:
      return "given";
    case LevelSource::Natural:
      return chosen.Level == 0.0 ? "zero of a signed distance" : "natural level of the quantity";
    case LevelSource::Recommended:
      return "recommended by the depositors";
    default:
      return "estimated from the values";
  }
}

double Estimate(vtkImageData* image, vtkDataArray* scalars, bool insideIsHigher)
{
  std::vector<double> values;
  UseScalars(
    image, scalars, [&](const auto& grid) { values = SampleValues(grid, NoDataMask(image)); });
  const double sign = insideIsHigher ? 1.0 : -1.0;
  std::transform(
    values.begin(), values.end(), values.begin(), [sign](double value) { return sign * value; });
  return sign * EstimateLevel(values);
}

}

const unsigned char* NoDataMask(vtkImageData* image)
{
  auto* mask = vtkArrayDownCast<vtkUnsignedCharArray>(image->GetPointData()->GetArray("NoData"));
  return mask && mask->GetNumberOfValues() == image->GetNumberOfPoints() ? mask->GetPointer(0)
                                                                         : nullptr;
}

std::optional<double> RecommendedLevel(vtkImageData* image)
{
  vtkDataArray* level = image->GetFieldData()->GetArray("RecommendedLevel");
  return level && level->GetNumberOfValues() == 1 ? std::optional<double>(level->GetComponent(0, 0))
                                                  : std::nullopt;
}

ChosenLevel ChooseLevel(
  bool isAutomatic, double level, vtkImageData* image, vtkDataArray* scalars, bool insideIsHigher)
{
  ChosenLevel chosen{ level, LevelSource::Given };
  if (isAutomatic)
  {
    if (const auto natural = NaturalLevel(image, scalars))
    {
      chosen = { *natural, LevelSource::Natural };
    }
    else if (const auto recommended = RecommendedLevel(image))
    {
      chosen = { *recommended, LevelSource::Recommended };
    }
    else
    {
      chosen = { Estimate(image, scalars, insideIsHigher), LevelSource::Estimated };
    }
  }
  RequireThat(std::isfinite(chosen.Level), "Level", chosen.Level, "it must be a finite number");
  return chosen;
}

void AddAutomaticLevel(const ChosenLevel& used, vtkImageData* image, vtkDataArray* scalars,
  bool insideIsHigher, vtkDataObject* output)
{
  double range[2];
  scalars->GetFiniteRange(range, 0);
  if (range[0] > range[1])
  {
    return;
  }
  const ChosenLevel automatic = used.Source == LevelSource::Given
    ? ChooseLevel(true, used.Level, image, scalars, insideIsHigher)
    : used;
  vtkFieldData* fields = output->GetFieldData();
  AddColumn<vtkDoubleArray>(fields, "AutomaticLevel", { automatic.Level });
  AddColumn<vtkStringArray>(fields, "AutomaticLevelSource", { SourceText(automatic) });
}

void AddLevel(const ChosenLevel& level, vtkDataObject* output)
{
  vtkFieldData* fields = output->GetFieldData();
  AddColumn<vtkDoubleArray>(fields, "Level", { level.Level });
  AddColumn<vtkStringArray>(fields, "LevelSource", { SourceText(level) });
}

}
