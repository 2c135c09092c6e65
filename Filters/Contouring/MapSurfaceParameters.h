/**
 * @file MapSurfaceParameters.h
 * @brief What Map Surface is told, and what it tells.
 */
#ifndef isthmus_MapSurfaceParameters_h
#define isthmus_MapSurfaceParameters_h

#include "Core/TriangleMesh.h"

#include <cstdint>

namespace isthmus
{

/// Which components of a surface stay. A component that is smaller than any of the three asks for
/// is left out.
struct DustParameters
{
  double MinimumArea = 0.0;  ///< length^2
  double MinimumShare = 0.0; ///< of the area of the largest component, from 0 to 1
  int Largest = 0;           ///< keep that many of the largest; 0: all
};

struct DustResult
{
  TriangleMesh Surface;                 ///< what stays, in its order
  std::vector<std::int64_t> Components; ///< of each triangle, 0 for the largest
  std::vector<double> Areas;            ///< of each component that stays, largest first
  std::int64_t Found = 0;               ///< components before
};

}

#endif
