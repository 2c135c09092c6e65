/**
 * @file RegularFiltration.h
 * @brief The union of growing balls, represented by the weighted alpha complex of their regular
 * triangulation.
 */
#ifndef isthmus_RegularFiltration_h
#define isthmus_RegularFiltration_h

#include "Persistence/CellFiltration.h"
#include "vtkIsthmusFiltersPersistenceModule.h"

#include <functional>

namespace isthmus
{

/**
 * A regular triangulation with the value of every simplex.
 *
 * A ball of radius R has the weight R^2; at the value a all balls have radius sqrt(R_i^2 + a), so a
 * = 0 corresponds to the original balls. A simplex enters at the squared radius (power) of the
 * smallest sphere orthogonal to its balls if no other ball is nearer than orthogonal to that
 * sphere; otherwise it is attached and enters with the earliest of its cofaces. The complex of
 * values up to a is the dual complex of the union at a. It has the same homotopy type, and volumes
 * and areas are summed over it (H. Edelsbrunner, Discrete Comput. Geom. 13 (1995) 415).
 */
struct RegularFiltration
{
  CellFiltration Complex;                      ///< not yet ordered: call Order() for persistence
  std::vector<double> Radii;                   ///< of the balls, by point
  std::vector<double> VertexValue;             ///< -R^2, or more where attached; HUGE_VAL: hidden
  HandleVector<TetrahedronId, Point3> Centers; ///< of each tetrahedron's orthogonal sphere

  /// False for balls whose power cell is empty: they touch no simplex.
  bool IsUsed(std::size_t ball) const { return this->VertexValue[ball] < HUGE_VAL; }
};

/**
 * Triangulates balls (centers and radii, all finite, radii not negative).
 *
 * Predicates are exact. Values have a relative accuracy of 1e-9, and are computed with rational
 * numbers where doubles are not accurate enough. Any number and position of balls is allowed; fewer
 * than four, or balls in one plane, give no tetrahedron and no simplex at all. Throws
 * std::invalid_argument for numbers that are not finite.
 *
 * O(n log n) for atoms, with 1.3 KB for each ball; more for balls in convex position, e.g. on a
 * cylinder, where each has many neighbours. `predicted` is called with the predicted time of the
 * triangulation in seconds when a quarter of the balls has been inserted; these are a random
 * sample, so the time continues to grow by the same power. The result is bitwise the same on any
 * number of threads.
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT RegularFiltration MakeRegularFiltration(
  std::vector<Point3> centers, std::vector<double> radii, const ProgressCallback& progress = {},
  const std::function<void(double seconds)>& predicted = {});

}

#endif
