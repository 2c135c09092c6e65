/**
 * @file MolecularPockets.h
 * @brief Pockets, voids and their mouths from the weighted alpha filtration of atoms.
 *
 * **Pocket**: tetrahedra of the regular triangulation with space for a ball of InnerRadius that a
 * ball of OuterRadius does not reach from outside, connected through triangles that let the smaller
 * one pass, and the crevices around them: empty tetrahedra that the probe reaches from there, each
 * given to the pocket with the widest path to it. Where no triangle lets the inner ball out it is a
 * void.
 *
 * **Volume, Area**: what the probe's centre can reach of it, and the part of the accessible surface
 * that faces it, exact sums (EmptySpace.h). **Mouths**: triangles that the smaller ball passes on
 * its way out, grouped by shared edges.
 *
 * **Score, rank, centre**: PocketScore.h.
 */
#ifndef isthmus_MolecularPockets_h
#define isthmus_MolecularPockets_h

#include "Atoms/Ball.h"
#include "Core/Progress.h"
#include "Pockets/Pocket.h"
#include "vtkIsthmusFiltersPocketsModule.h"

namespace isthmus
{

/**
 * Throws std::invalid_argument for options that are no positive lengths, an OuterRadius not above
 * InnerRadius, and atoms that are not finite; Cancelled. Fewer than four atoms, or all in one
 * plane, have no pockets.
 *
 * The result does not depend on the order of the atoms (save numbers of atoms in it), nor on the
 * number of threads, bit by bit. O(n log n): 60 us and 2 KB an atom.
 */
VTKISTHMUSFILTERSPOCKETS_EXPORT PocketResult FindPockets(const std::vector<Ball>& atoms,
  const PocketOptions& options, const ProgressCallback& progress = {});

}

#endif
