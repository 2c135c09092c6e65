/**
 * @file StuffingParameters.h
 * @brief What isosurface stuffing is asked for, and its constants.
 */
#ifndef isthmus_StuffingParameters_h
#define isthmus_StuffingParameters_h

#include "Tetrahedra/MeshedSide.h"

#include <cstdint>

namespace isthmus
{

struct StuffingParameters
{
  double CellSize = 1.0; ///< side of the cubes of the lattice, a length
  int GradingLevels = 0; ///< away from the surface cubes may be up to 2^levels as large; 0: uniform
  MeshedSide Side = MeshedSide::Inside;
  double Margin = 0.0; ///< length by which the box exceeds the bounds; three cells at least
  std::uint64_t MaximumBytes = 0; ///< of the lattice; 0: no limit
};

/// A lattice point is moved onto the surface when it is nearer than this part of an edge of the
/// lattice. Over all positions of the surface (searched at random and at the ends of each case), no
/// other pair tried has a larger smallest angle: 10.3 degrees; see TestIsosurfaceStuffing.
constexpr double StuffingAlphaLong = 0.28;
constexpr double StuffingAlphaShort = 0.392;

/// Bounds on all dihedral angles in degrees: the published ones.
constexpr double StuffingSmallestAngle = 10.78;
constexpr double StuffingLargestAngle = 164.74;

}

#endif
