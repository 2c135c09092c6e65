/**
 * @file CellAccessibility.h
 * @brief Clearance of each tetrahedron between atoms, and the widest path to it from outside.
 */
#ifndef isthmus_CellAccessibility_h
#define isthmus_CellAccessibility_h

#include "Pockets/EmptySpace.h"
#include "vtkIsthmusFiltersPocketsModule.h"

namespace isthmus
{

/**
 * *Clearance*: the radius of the largest ball that touches no atom, centred at the orthogonal
 * sphere's centre of a tetrahedron, or of a triangle (where its latest coface is, if attached):
 * sqrt(a + R^2) - r for the value a and the largest of the simplex' atoms, R = r + probe.
 *
 * *Access*: the radius of the largest ball that gets from outside to there, the maximum over all
 * paths through triangles of the least clearance met (the dual, over H2, of where voids are born).
 */
struct CellAccessibility
{
  HandleVector<TetrahedronId, double> CellClearance;
  HandleVector<TriangleId, double> TriangleClearance;
  HandleVector<TetrahedronId, double> Access;
  HandleVector<TetrahedronId, TriangleId>
    TowardsOutside; ///< the triangle that the widest path takes
};

/// `probe` is what the radii of `f` have been enlarged by. O(n log n): one pass of Dijkstra's
/// algorithm, 1 us a tetrahedron. Of paths that are equally wide, as symmetric molecules have them,
/// the one whose first triangle to enter the filtration enters last is the widest, so that paths
/// agree with the pairs of the filtration; then the lower id.
VTKISTHMUSFILTERSPOCKETS_EXPORT CellAccessibility FindAccess(
  const RegularFiltration& f, const FacesByCell& faces, double probe);

}

#endif
