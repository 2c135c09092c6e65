/**
 * @file RegularFiltration.h
 * @brief The union of balls that grow, as the weighted alpha complex of their regular
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
 * A ball of radius R has the weight R^2; at the value a all balls have radius sqrt(R_i^2 + a), so
 * that 0 stands for the balls as given. A simplex enters at the squared radius (power) of the
 * smallest sphere orthogonal to its balls when no other ball is nearer than orthogonal to that
 * sphere, else (it is *attached*) with the earliest of its cofaces. The complex of values up to a
 * is the dual complex of the union at a: of the same homotopy type, and the one over which volumes
 * and areas are summed (H. Edelsbrunner, Discrete Comput. Geom. 13 (1995) 415).
 */
struct RegularFiltration
{
  CellFiltration Complex;                      ///< not yet ordered: call Order() for persistence
  std::vector<double> Radii;                   ///< of the balls, by point
  std::vector<double> VertexValue;             ///< -R^2, or more where attached; HUGE_VAL: hidden
  HandleVector<TetrahedronId, Point3> Centres; ///< of each tetrahedron's orthogonal sphere

  /// False for balls whose power cell is empty: they touch no simplex.
  bool IsUsed(std::size_t ball) const { return this->VertexValue[ball] < HUGE_VAL; }
};

/**
 * Triangulates balls (centres and radii, all finite, radii not negative).
 *
 * Predicates are exact, values accurate to 1e-9 relative, by rational numbers where doubles are
 * not. Balls in any number and place are welcome: fewer than four, or all in one plane, give no
 * tetrahedron and no simplex at all. Throws std::invalid_argument for what is not finite.
 *
 * O(n log n) for atoms: 10 us and 1.3 KB a ball; more for balls in convex position, as on a
 * cylinder, where each has many neighbours. `predicted` is called with the seconds that the
 * triangulation is going to take, once a quarter of the balls is in: these are a random sample, so
 * that the time grows by the same power from there on. Bitwise the same on any number of threads.
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT RegularFiltration MakeRegularFiltration(
  std::vector<Point3> centres, std::vector<double> radii, const ProgressCallback& progress = {},
  const std::function<void(double seconds)>& predicted = {});

}

#endif
