/**
 * @file MeshFunctionError.h
 * @brief The errors of choking loops by a function on a tetrahedral mesh (MeshLoops.h).
 */
#ifndef isthmus_MeshFunctionError_h
#define isthmus_MeshFunctionError_h

#include "ChokingLoops/FeatureDiagram.h"

#include <string>
#include <vector>

namespace isthmus
{

/**
 * The errors of the distance to M on a mesh. The values at its points differ from the distance by
 * at most `atPoints` (empty: they are exact).
 *
 * The distance is 1-Lipschitz, so at a point with barycentric coordinates l_i it differs from the
 * linear function by at most sum l_i |x - v_i|. By Jensen's inequality that is at most the radius
 * of the smallest ball around the tetrahedron, and by Jung's theorem at most sqrt(3/8) of its
 * longest edge.
 */
std::vector<CellError> DistanceErrors(const CellFiltration& mesh, const std::vector<double>& values,
  const std::vector<double>& atPoints);

/// The errors of any other function: within a tetrahedron, the true function may take any value
/// between those at the corners.
std::vector<CellError> RangeErrors(const CellFiltration& mesh, const std::vector<double>& values);

/// Describes the features for which a mesh is too coarse; empty if there are none.
std::string MeshRemark(const FeatureDiagram& diagram);

}

#endif
