/**
 * @file PocketScore.h
 * @brief The score by which pockets are ranked.
 *
 * **Score**: sum over the tetrahedra of a pocket of empty volume x (n/100)^2, with the number n of
 * atoms within BurialRadius: volume counts the more, the more of the protein is around it.
 * **Rank**: the place by falling score. **Centre**: of the orthogonal spheres, with the weights of
 * the score.
 */
#ifndef isthmus_PocketScore_h
#define isthmus_PocketScore_h

#include "Core/TriangleMesh.h"
#include "Pockets/Pocket.h"
#include "Pockets/PocketSurface.h"
#include "vtkIsthmusFiltersPocketsModule.h"

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
