/**
 * @file PocketScore.h
 * @brief The score by which pockets are ranked.
 *
 * **Score**: sum over the tetrahedra of a pocket of empty volume x (n/100)^2, with the number n of
 * atoms within BurialRadius: volume counts the more, the more of the protein is around it.
 * **Rank**: the place by falling score. **Centre**: of the orthogonal spheres, with the weights of
 * the score.
 *
 * **Sites** are ranked by their probability. One is part of a pocket, without walls to the rest of
 * it, and the balls that the rest holds would take more of its empty volume away than there is
 * (EmptySpace.h: single figures may be negative). So a tetrahedron of a site counts with at least
 * nothing and at most its own volume, in Volume and Score, and an atom of its lining with at least
 * no area.
 */
#ifndef isthmus_PocketScore_h
#define isthmus_PocketScore_h

#include "Core/TriangleMesh.h"
#include "Pockets/Pocket.h"
#include "Pockets/PocketSurface.h"
#include "vtkIsthmusFiltersPocketsModule.h"

#include <string>
#include <tuple>
#include <vector>

namespace isthmus
{

/// The weight of empty volume in the score, with so many atoms within BurialRadius.
inline double BurialWeight(double atoms)
{
  return 1e-4 * atoms * atoms;
}

/// Fills in Score, Volume, Centre, Radius and Access of a pocket from its cells.
VTKISTHMUSFILTERSPOCKETS_EXPORT void ScorePocket(Pocket& pocket);

/// The same of a site but for its centre, which is its mode; limits the volumes of its cells.
VTKISTHMUSFILTERSPOCKETS_EXPORT void ScoreSite(Pocket& site);

/// Chain, number, insertion code and name of a residue.
using ResidueWord = std::tuple<std::string, int, std::string, std::string>;

/// The residues that line a site, those with most of its surface first.
using SiteName = std::vector<ResidueWord>;

/**
 * Of sites whose densities are the same but for 2 parts in 10,000, as those of copies of a chain
 * are, the one at the first chain comes first, then the one with the first name: their order by
 * density would depend on the molecule's orientation. Sites and `names` are in the same order.
 * Parents are numbered again.
 */
VTKISTHMUSFILTERSPOCKETS_EXPORT void OrderTiedSites(
  const std::vector<SiteName>& names, std::vector<Pocket>& sites);

/// Sorts by falling score; equal ones keep their order.
VTKISTHMUSFILTERSPOCKETS_EXPORT void RankPockets(std::vector<Pocket>& pockets);

/**
 * Multiplies each score by the square root of the pocket's mean polarized curvature over that of
 * the whole surface (1 for a pocket that no surface lines) and, with `rank`, ranks again. `means`
 * become those of the pockets, in their new order.
 */
VTKISTHMUSFILTERSPOCKETS_EXPORT void WeightScoresByCurvature(const SurfaceView& surface,
  const PocketSurfaceFields& fields, bool rank, std::vector<Pocket>& pockets,
  std::vector<PocketSurfaceMeans>& means);

}

#endif
