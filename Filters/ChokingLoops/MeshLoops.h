/**
 * @file MeshLoops.h
 * @brief Choking loops by a function on a tetrahedral mesh, instead of samples of the surface.
 *
 * The filtration of X. Feng, PhD thesis, 6.3.1, with five functions. For comparison with the
 * thesis; the Delaunay filtration (ChokingLoops.h) is exact, and needs no mesh.
 */
#ifndef isthmus_MeshLoops_h
#define isthmus_MeshLoops_h

#include "ChokingLoops/ChokingLoops.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace isthmus
{

/**
 * Analyses a surface on the mesh `given`, or on one of about 200,000 tetrahedra on both sides of
 * the surface, which TetGen creates. Needles and the like are cleaned first; `warn` is called with
 * what was changed.
 * @throws std::invalid_argument for a mesh without tetrahedra or with other cells, and a missing
 * point array; what MeshTetrahedra() and ChokingLoops::ChokingLoops() throw.
 */
std::unique_ptr<ChokingLoops> AnalyseOnTetrahedra(TriangleMesh surface, vtkUnstructuredGrid* given,
  const MeshFunctionParameters& parameters, const std::function<void(const std::string&)>& warn,
  const ProgressCallback& progress);

}

#endif
