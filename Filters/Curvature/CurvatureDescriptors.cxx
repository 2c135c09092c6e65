#include "Curvature/CurvatureDescriptors.h"

#include "Core/RangeChecks.h"

#include <array>

namespace isthmus
{

const char* SurfaceTypeName(SurfaceType type)
{
  static constexpr std::array<const char*, NumberOfSurfaceTypes> names{ "None", "Pit", "Valley",
    "Saddle ridge", "Flat", "Minimal surface", "Saddle valley", "Ridge", "Peak" };
  return names[static_cast<unsigned char>(type)];
}

void Check(const CurvatureDescriptorOptions& options)
{
  RequireChoice(
    "ShapeIndexConvention", options.ShapeIndexConvention, ShapeIndexConvention::Koenderink);
  RequireRange("FlatTolerance", options.FlatTolerance, 0.0, Unlimited);
  RequireRange("GaussianTolerance", options.GaussianTolerance, 0.0, Unlimited);
  RequireRange("MeanTolerance", options.MeanTolerance, 0.0, Unlimited);
}

SurfaceType ClassifySurface(
  double mean, double halfDifference, double spacing, const SurfaceTypeTolerance& tolerance)
{
  const double curvedness = Curvedness(mean, halfDifference);
  if (curvedness * spacing <= tolerance.FlatTolerance)
  {
    return SurfaceType::Flat;
  }
  const double gaussian = (mean - halfDifference) * (mean + halfDifference);
  const double gaussianZero = tolerance.GaussianTolerance * curvedness * curvedness;
  const int gaussianSign = (gaussian > gaussianZero) - (gaussian < -gaussianZero);
  const double meanZero = tolerance.MeanTolerance * curvedness;
  const int meanSign = (mean > meanZero) - (mean < -meanZero);

  // Rows: K < 0, K = 0, K > 0. Columns: H < 0, H = 0, H > 0.
  static constexpr SurfaceType table[3][3] = {
    { SurfaceType::SaddleValley, SurfaceType::MinimalSurface, SurfaceType::SaddleRidge },
    { SurfaceType::Valley, SurfaceType::Flat, SurfaceType::Ridge },
    { SurfaceType::Pit, SurfaceType::None, SurfaceType::Peak }
  };
  return table[gaussianSign + 1][meanSign + 1];
}

}
