/**
 * @file PocketSurface.h
 * @brief The part of a molecular surface that lines a pocket: mean potential and polarized
 * curvature.
 */
#ifndef isthmus_PocketSurface_h
#define isthmus_PocketSurface_h

#include "Core/TriangleMesh.h"
#include "Pockets/Pocket.h"

#include <vector>

namespace isthmus
{

/// Area-weighted means over the surface that lines a pocket; NaN if there is none.
struct PocketSurfaceMeans
{
  double Potential;
  double Polarized; ///< of the absolute value
  double Area;
};

/// One value for each point of a surface; NaN values are ignored. Potential may be empty.
struct PocketSurfaceFields
{
  std::vector<double> Polarized;
  std::vector<double> Potential;
};

/**
 * Surface within `reach` of a pocket's alpha balls (centers and clearances of its cells) counts as
 * lining the pocket. One entry for each pocket. O(n log n + cells x points nearby).
 */
std::vector<PocketSurfaceMeans> MeasurePocketSurfaces(const SurfaceView& surface,
  const PocketSurfaceFields& fields, const std::vector<Pocket>& pockets, double reach = 0.5);

/// The same means over the whole surface.
PocketSurfaceMeans MeasureWholeSurface(
  const SurfaceView& surface, const PocketSurfaceFields& fields);

/// For each point of the surface, the mean probability of the places within 5 angstrom, with the
/// weight (1 - d/5)^2; 0 if there are none.
std::vector<double> SiteProbabilities(
  const SurfaceView& surface, const std::vector<SitePlace>& places);

/// For each point of the surface 0, or 1 + the index of the first pocket that it lines.
std::vector<int> LabelPocketSurfaces(
  const SurfaceView& surface, const std::vector<Pocket>& pockets, double reach = 0.5);

}

#endif
