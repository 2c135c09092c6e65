/**
 * @file PocketSites.h
 * @brief Ligand-sized sites in pockets: modes of the density of likely places.
 *
 * The size of pockets is given by the surface: a groove may contain several sites, and a site may
 * extend over pockets that are separated by a narrow place. **Density** at a place: the sum over
 * the pockets' tetrahedra within 10 angstrom of w (1 - (d/10)^2)^2, with w = probability / sqrt(n).
 * The crowding n is the sum over the tetrahedra within 2.5 angstrom, itself included, of
 * (1 - (d/2.5)^2)^2: how many tetrahedra fill a place changes with small displacements of atoms,
 * and their density should not. A **site** is a mode
 * of the density, found by mean shift (K. Fukunaga and L. Hostetler, IEEE Trans. Inf. Theory 21
 * (1975) 32) from the densest remaining tetrahedron; tetrahedra within 8 angstrom of the mode are
 * then removed. The search ends at a hundredth of the largest density. A tetrahedron belongs to the
 * nearest mode within 8 angstrom.
 */
#ifndef isthmus_PocketSites_h
#define isthmus_PocketSites_h

#include "Core/Geometry.h"

#include <vector>

namespace isthmus
{

struct PocketSite
{
  Point3 Center{ 0.0, 0.0, 0.0 }; ///< the mode
  double Density = 0.0;
  std::vector<std::size_t> Places; ///< ascending
};

constexpr double SiteInnerRadius =
  1.5; ///< angstrom: inner radius of the tetrahedra for which the model is used; smaller
constexpr double SiteOuterRadius =
  4.5; ///< outer radius; larger than a pocket's, so that shallow places are included
constexpr double DensityReach = 10.0; ///< angstrom, of the density's kernel
constexpr double CrowdingReach = 2.5; ///< angstrom, of the crowding's
constexpr double SiteSpacing =
  8.0; ///< angstrom around a site within which no other site is started
constexpr double LeastDensity = 0.01; ///< fraction of the largest density

/// Sites by descending density. A place belongs to at most one site. O(places x places nearby).
std::vector<PocketSite> FindSites(
  const std::vector<Point3>& places, const std::vector<double>& probabilities);

}

#endif
