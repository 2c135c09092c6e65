/**
 * @file PoreChannels.h
 * @brief Channels that run through a molecule, and the widest paths between places.
 */
#ifndef isthmus_PoreChannels_h
#define isthmus_PoreChannels_h

#include "Pockets/CellAccessibility.h"
#include "Pockets/Pore.h"
#include "vtkIsthmusFiltersPocketsModule.h"

namespace isthmus
{

/// A path through the tetrahedra: centres of orthogonal spheres, from one end to the other.
struct Channel
{
  std::vector<Point3> Path;
  double Radius = 0.0;       ///< at the triangle where it closes
  double Span = 0.0;         ///< distance of the ends
  bool IsWide = false;       ///< wider than EndRadius everywhere
  std::size_t Narrowest = 0; ///< the centre of that triangle, or of the narrowest place
  std::size_t From = 0;      ///< where planes begin: there, or at the first of two given points
};

/**
 * Channels from one side to another: as balls around the atoms grow, a channel is a loop around it,
 * which one triangle fills at last (an H1 death). Kept are those that close at MinimumRadius or
 * wider, after having lasted 0.3 angstrom at least (else the loop is a ring of atoms), whose
 * widest paths out on both sides are as wide, have no tetrahedron in common and end MinimumSpan
 * apart. A path ends where a ball of EndRadius gets from outside; a channel that is wider than that
 * itself, where it leaves the convex hull. The longest span comes first. `f` gets ordered. O(n log
 * n), and the reduction of FiltrationPairs.
 */
VTKISTHMUSFILTERSPOCKETS_EXPORT std::vector<Channel> FindChannels(RegularFiltration& f,
  const CellAccessibility& access, double probe, const PoreOptions& options,
  const ProgressCallback& progress = {});

/**
 * The path from `first` to `last` with the least integral of 1 / clearance^2 among those no farther
 * than MaximumOffset from the straight line. Throws std::runtime_error where there is none.
 */
VTKISTHMUSFILTERSPOCKETS_EXPORT Channel PathBetween(const RegularFiltration& f,
  const FacesByCell& faces, const CellAccessibility& access, const Point3& first,
  const Point3& last, const PoreOptions& options);

}

#endif
