/**
 * @file CellAccessibility.h
 * @brief Clearance of each tetrahedron between atoms, and the widest path to it from outside.
 */
#ifndef isthmus_CellAccessibility_h
#define isthmus_CellAccessibility_h

#include "Pockets/EmptySpace.h"

namespace isthmus
{

/**
 * *Clearance*: the radius of the largest ball that touches no atom, centered at the center of the
 * orthogonal sphere of a tetrahedron or triangle (for an attached triangle, that of its latest
 * coface). It is sqrt(a + R^2) - r for the value a of the simplex and the radius r of its largest
 * atom, with R = r + probe.
 *
 * *Access*: the radius of the largest ball that gets there from outside: the maximum over all paths
 * through triangles of the least clearance on the path (the dual, over H2, of where voids are
 * born).
 */
struct CellAccessibility
{
  HandleVector<TetrahedronId, double> CellClearance;
  HandleVector<TriangleId, double> TriangleClearance;
  HandleVector<TetrahedronId, double> Access;
  HandleVector<TetrahedronId, TriangleId>
    TowardsOutside; ///< the triangle through which the widest path leaves
};

/// The clearances, with an access of 0 everywhere. O(n).
CellAccessibility MeasureClearance(const RegularFiltration& f, double probe);

/// `probe` is the length by which the radii of `f` have been enlarged. O(n log n): one pass of
/// Dijkstra's algorithm. Of equally wide paths (symmetric molecules), the one whose earliest
/// triangle enters the filtration last is chosen; then the lower id decides. @throws Cancelled
CellAccessibility FindAccess(const RegularFiltration& f, const FacesByCell& faces, double probe,
  const ProgressCallback& progress = {});

}

#endif
