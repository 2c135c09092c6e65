/**
 * @file PocketScore.h
 * @brief The score by which pockets are ranked.
 *
 * **Score**: sum over the tetrahedra of a pocket of empty volume x (n/100)^2, with the number n of
 * atoms within BurialRadius. Volume counts more the more of the protein surrounds it. **Rank**:
 * position in descending order of score. **Center**: mean of the centers of the orthogonal spheres,
 * with the weights of the score.
 *
 * **Sites** are ranked by their probability. In their Volume and Score, the contribution of a
 * tetrahedron is limited to between 0 and its own volume, and the area of a lining atom to at least
 * 0.
 */
#ifndef isthmus_PocketScore_h
#define isthmus_PocketScore_h

#include "Core/TriangleMesh.h"
#include "Pockets/Pocket.h"
#include "Pockets/PocketSurface.h"

#include <string>
#include <tuple>
#include <vector>

namespace isthmus
{

/// The weight of empty volume in the score, given the number of atoms within BurialRadius.
inline double BurialWeight(double atoms)
{
  return 1e-4 * atoms * atoms;
}

/// Fills in Score, Volume, Center, Radius and Access of a pocket from its cells.
void ScorePocket(Pocket& pocket);

/// The same for a site, except for its center, which is its mode; limits the volumes of its cells.
void ScoreSite(Pocket& site);

/// Chain, number, insertion code and name of a residue.
using ResidueWord = std::tuple<std::string, int, std::string, std::string>;

/// The residues that line a site, those with the largest share of its surface first.
using SiteName = std::vector<ResidueWord>;

/**
 * Reorders sites whose densities agree within 2 parts in 10,000 by chain, then by name, since their
 * order by density would depend on the molecule's orientation. Copies of a site stay together, in
 * their order. Sites and `names` are in the same order. Parents are renumbered.
 */
void OrderTiedSites(const std::vector<SiteName>& names, std::vector<Pocket>& sites);

/// Sorts by descending score; equal ones keep their order.
void RankPockets(std::vector<Pocket>& pockets);

/**
 * Multiplies each score by the square root of the pocket's mean polarized curvature over that of
 * the whole surface (1 for a pocket without lining surface) and, with `rank`, ranks the pockets
 * again. `means` are then in the new order of the pockets.
 */
void WeightScoresByCurvature(const SurfaceView& surface, const PocketSurfaceFields& fields,
  bool rank, std::vector<Pocket>& pockets, std::vector<PocketSurfaceMeans>& means);

}

#endif
