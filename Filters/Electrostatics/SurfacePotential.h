/**
 * @file SurfacePotential.h
 * @brief Potential, field and induced charge at points of the surface, fitted from both sides.
 *
 * The fit of InterfaceJumpConditions.h at the point itself, to the 4 x 4 x 4 nodes around: nothing
 * is interpolated across the surface, where the field jumps.
 */
#ifndef isthmus_SurfacePotential_h
#define isthmus_SurfacePotential_h

#include "Electrostatics/GridPotential.h"

namespace isthmus
{

struct SurfaceValues
{
  std::vector<double> Potential;          ///< kT/e
  std::vector<double> NormalField;        ///< -d_n phi just outside, kT/(e angstrom), outwards
  std::vector<double> ChargeDensity;      ///< induced, e / angstrom^2
  std::vector<Point3> TangentialGradient; ///< of phi along the surface, kT/(e angstrom)
  std::vector<Point3> Normal;             ///< outwards
  std::int64_t Failed = 0;                ///< points without enough nodes, NaN
};

/// Evaluates at points of the surface of a solved problem (in the frame of the volume). Parallel.
SurfaceValues EvaluateAtSurface(const GridPotential& problem, const LevelFunction& level,
  const std::vector<Point3>& points, double kelvin, const ProgressCallback& progress = {});

/// Evaluates at each crossing of the surface with an edge of the grid, from the 4 x 3 x 3 nodes
/// around the edge; the problem already has the frame of the surface and the potential of the
/// charges there. Parallel.
SurfaceValues EvaluateAtCrossings(const GridPotential& problem, double kelvin);

}

#endif
