/**
 * @file PoreChannels.h
 * @brief Channels through a molecule, and the widest paths between points.
 */
#ifndef isthmus_PoreChannels_h
#define isthmus_PoreChannels_h

#include "Pockets/PeriodicSpace.h"
#include "Pockets/Pore.h"

namespace isthmus
{

/// A path through the tetrahedra, as the centers of orthogonal spheres from one end to the other.
struct Channel
{
  std::vector<Point3> Path;
  double Radius = 0.0;       ///< radius at the triangle where it closes
  double Span = 0.0;         ///< distance between the ends
  bool IsWide = false;       ///< wider than EndRadius everywhere
  std::size_t Narrowest = 0; ///< index of the center of that triangle, or of the narrowest place
  std::size_t From =
    0; ///< index at which the planes begin: the same, or the first of two given points
};

/**
 * Channels from one side of the molecule to another. As balls around the atoms grow, a channel
 * corresponds to a loop around it, which is finally filled by one triangle (an H1 death). A channel
 * is kept if it closes at MinimumRadius or wider, if the loop has existed for at least 0.3 angstrom
 * (otherwise it is a ring of atoms), and if the widest paths out on both sides are as wide, have no
 * tetrahedron in common and end at least MinimumSpan apart. A path ends where a ball of EndRadius
 * can come from outside, or, for a channel that is wider than that, where it leaves the convex
 * hull. The channel with the longest span comes first. Sorts `f`. O(n log n), plus the reduction of
 * FiltrationPairs.
 */
std::vector<Channel> FindChannels(RegularFiltration& f, const CellAccessibility& access,
  double probe, const PoreOptions& options, const ProgressCallback& progress = {});

/**
 * The path through a crystal from the narrowest place of the widest way along vector `axis` of the
 * cell to a copy of this place: of the paths as wide as this, the one with the least integral of 1
 * / clearance^2. Empty if atoms block the way. Between the centers of two tetrahedra there is that
 * of their triangle, where it is narrower than both.
 */
std::vector<Point3> PathAlongCell(
  const PeriodicSpace& space, std::size_t axis, const ProgressCallback& progress = {});

/**
 * The path from `first` to `last` with the least integral of 1 / clearance^2 among paths no farther
 * than MaximumOffset from the straight line. Throws std::runtime_error if there is none.
 */
Channel PathBetween(const RegularFiltration& f, const FacesByCell& faces,
  const CellAccessibility& access, const Point3& first, const Point3& last,
  const PoreOptions& options, const ProgressCallback& progress = {});

}

#endif
