/**
 * @file PocketSites.h
 * @brief Sites of the size of a ligand in pockets: modes of the density of likely places.
 *
 * Pockets are as large as the surface makes them; a groove may hold several sites, and a site may
 * spread over pockets that a narrow place separates. **Density** at a place: the sum over the
 * pockets' tetrahedra within 6 angstrom of probability x (1 - (d/6)^2)^2. A **site** is a mode of
 * it, which mean shift (K. Fukunaga and L. Hostetler, IEEE Trans. Inf. Theory 21 (1975) 32) reaches
 * from the densest tetrahedron that is left; those within 8 angstrom of the mode are then taken
 * away. It ends at a hundredth of the largest density. A tetrahedron belongs to the nearest mode
 * within 8 angstrom.
 */
#ifndef isthmus_PocketSites_h
#define isthmus_PocketSites_h

#include "Core/Geometry.h"
#include "vtkIsthmusFiltersPocketsModule.h"

#include <vector>

namespace isthmus
{

struct PocketSite
{
  Point3 Centre{ 0.0, 0.0, 0.0 }; ///< the mode
  double Density = 0.0;
  std::vector<std::size_t> Places; ///< ascending
};

constexpr double SiteInnerRadius =
  1.5; ///< angstrom: of the tetrahedra that the model is for, smaller
constexpr double SiteOuterRadius =
  4.5; ///< and larger than a pocket's, so that shallow places are among them
constexpr double DensityReach = 6.0;  ///< angstrom, of the density's kernel
constexpr double SiteSpacing = 8.0;   ///< angstrom around a site in which no other begins
constexpr double LeastDensity = 0.01; ///< of the largest

/// The densest first. A place belongs to one site or none. O(places x places near).
VTKISTHMUSFILTERSPOCKETS_EXPORT std::vector<PocketSite> FindSites(
  const std::vector<Point3>& places, const std::vector<double>& probabilities);

}

#endif
