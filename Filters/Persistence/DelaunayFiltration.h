/**
 * @file DelaunayFiltration.h
 * @brief The offsets of a point set, represented by the growing alpha complex of its Delaunay
 * triangulation.
 */
#ifndef isthmus_DelaunayFiltration_h
#define isthmus_DelaunayFiltration_h

#include "Persistence/CellFiltration.h"
#include "vtkIsthmusFiltersPersistenceModule.h"

#include <functional>

namespace isthmus
{

using IndistinctDistance = std::function<double(const SimplexId* corners, std::size_t count)>;

/**
 * Delaunay triangulation of `points` with the alpha value of every simplex.
 *
 * A simplex enters at the squared radius of its smallest circumscribed sphere when no other point
 * lies inside that sphere (Gabriel), otherwise together with the earliest of its cofaces. The
 * complex at value d^2 is then homotopy equivalent to the union of balls of radius d round the
 * points (H. Edelsbrunner, "The union of balls and its dual shape", Discrete Comput. Geom. 13,
 * 1995).
 *
 * Predicates are exact; radii are computed in doubles if their relative error is below 1e-9, and
 * with rational numbers otherwise (flat tetrahedra, needles).
 *
 * `indistinct`: the squared distance up to which a simplex, given by its corners, is not distinct
 * from the surface that the points were taken from. Triangles with values up to it, their edges and
 * the tetrahedra between them are marked as indistinct.
 *
 * `points` are distinct and finite. Throws std::invalid_argument for fewer than four points, or if
 * all lie in one plane. O(n log n) for samples of a surface; about 1.0 KB for each point.
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT CellFiltration DelaunayFiltration(std::vector<Point3> points,
  const ProgressCallback& progress = {}, const IndistinctDistance& indistinct = {});

}

#endif
