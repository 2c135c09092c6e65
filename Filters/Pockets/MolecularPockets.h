/**
 * @file MolecularPockets.h
 * @brief Pockets, voids and their mouths from the weighted alpha filtration of atoms.
 *
 * **Pocket**: tetrahedra of the regular triangulation with space for a ball of InnerRadius that a
 * ball of OuterRadius does not reach from outside, connected through triangles that let the smaller
 * ball pass. A pocket includes the crevices around it: empty tetrahedra that the probe reaches from
 * there, each assigned to the pocket with the widest path to it. If the inner ball cannot leave
 * through any triangle, the pocket is a void.
 *
 * **Volume, Area**: the part of it that the probe's center can reach, and the part of the
 * accessible surface that faces it, as exact sums (EmptySpace.h). **Mouths**: triangles through
 * which the smaller ball can leave, grouped by shared edges.
 *
 * **Score, rank, center**: PocketScore.h.
 */
#ifndef isthmus_MolecularPockets_h
#define isthmus_MolecularPockets_h

#include "Atoms/Ball.h"
#include "Core/Progress.h"
#include "Pockets/Pocket.h"

namespace isthmus
{

/**
 * Throws std::invalid_argument for options that are not positive lengths, an OuterRadius not above
 * InnerRadius, and atoms that are not finite; Cancelled. Fewer than four atoms, or atoms in one
 * plane, have no pockets.
 *
 * The result is bitwise independent of the order of the atoms (except for atom numbers in it) and
 * of the number of threads. O(n log n); 2 KB per atom.
 */
PocketResult FindPockets(const std::vector<Ball>& atoms, const PocketOptions& options,
  const ProgressCallback& progress = {});

}

#endif
