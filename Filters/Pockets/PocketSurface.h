/**
 * @file PocketSurface.h
 * @brief What a surface with polarized curvature says of the pockets it lines.
 */
#ifndef isthmus_PocketSurface_h
#define isthmus_PocketSurface_h

#include "Core/SurfaceView.h"
#include "Pockets/PocketParameters.h"
#include "vtkIsthmusFiltersPocketsModule.h"

#include <vector>

namespace isthmus
{

/// Means over the surface that lines a pocket, by area; NaN where there is none.
struct PocketSurfaceMeans
{
  double Potential;
  double Polarized; ///< of the absolute value
  double Area;
};

/// One value for each point of a surface; NaN: does not count. Potential may be empty.
struct PocketSurfaceFields
{
  std::vector<double> Polarized;
  std::vector<double> Potential;
};

/**
 * The surface within `reach` of a pocket's alpha balls (centres and clearances of its cells) lines
 * it. One entry for each pocket. O(n log n + cells x points near).
 */
VTKISTHMUSFILTERSPOCKETS_EXPORT std::vector<PocketSurfaceMeans> MeasureSurface(
  const SurfaceView& surface, const PocketSurfaceFields& fields, const std::vector<Pocket>& pockets,
  double reach = 0.5);

/**
 * Multiplies each score by the square root of the pocket's mean polarized curvature over that of
 * the whole surface (1 for a pocket that no surface lines) and ranks anew.
 */
VTKISTHMUSFILTERSPOCKETS_EXPORT void WeighPockets(const SurfaceView& surface,
  const PocketSurfaceFields& fields, std::vector<Pocket>& pockets,
  std::vector<PocketSurfaceMeans>& means);

/// For each point of the surface 0, or 1 + the place of the first pocket that it lines.
VTKISTHMUSFILTERSPOCKETS_EXPORT std::vector<int> LabelSurface(
  const SurfaceView& surface, const std::vector<Pocket>& pockets, double reach = 0.5);

}

#endif
