#include "Curvature/CurvatureDescriptors.h"

#include <array>

namespace isthmus
{

const char* SurfaceTypeName(SurfaceType type)
{
  static constexpr std::array<const char*, NumberOfSurfaceTypes> names{ "None", "Pit", "Valley",
    "Saddle ridge", "Flat", "Minimal surface", "Saddle valley", "Ridge", "Peak" };
  return names[static_cast<unsigned char>(type)];
}

SurfaceType ClassifySurface(
  double mean, double halfDifference, double spacing, const SurfaceTypeTolerance& tolerance)
{
  const double curvedness = Curvedness(mean, halfDifference);
  if (curvedness * spacing <= tolerance.Flat)
  {
    return SurfaceType::Flat;
  }
  const double gaussian = (mean - halfDifference) * (mean + halfDifference);
  const double gaussianZero = tolerance.Gaussian * curvedness * curvedness;
  const int gaussianSign = (gaussian > gaussianZero) - (gaussian < -gaussianZero);
  const double meanZero = tolerance.Mean * curvedness;
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
