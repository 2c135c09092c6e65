/**
 * @file SurfaceCrossings.h
 * @brief Crossings of a triangle surface with the lines of a grid, and the nodes inside it.
 *
 * For each triangle with normal n and each axis with n_axis != 0, the lines of the grid along the
 * axis that pass the triangle cross its plane at o with n . (q - v) = 0, q on the line. Source: X.
 * Feng's thesis, 5.2 to 5.9 (index ranges there without the grid's origin).
 *
 * For the decision whether a line passes through a triangle, corners are rounded to a lattice of
 * 2^-20 spacings or slightly more. Every line crosses a closed surface an even number of times.
 */
#ifndef isthmus_SurfaceCrossings_h
#define isthmus_SurfaceCrossings_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "Surfaces/LevelCrossings.h"
#include "Surfaces/ShellCrossings.h"
#include "vtkIsthmusFiltersSurfacesModule.h" // for the export macro

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// A grid with its first node at the origin; x runs fastest.
struct GridShape
{
  std::array<std::int64_t, 3> Dimensions{ 0, 0, 0 }; ///< nodes
  std::array<double, 3> Spacing{ 1.0, 1.0, 1.0 };    ///< positive

  std::int64_t Size() const
  {
    return this->Dimensions[0] * this->Dimensions[1] * this->Dimensions[2];
  }
};

enum class CrossingNormal
{
  Triangles = 0, ///< unit normal of the triangle
  Points = 1 ///< interpolated from the points' normals (area-weighted means of their triangles')
};

/**
 * Crossings of `mesh` with the lines of `grid` between its first and last nodes, ordered by node,
 * axis and position. Normals point to the side from which triangles are counter-clockwise.
 *
 * Time O(triangles + crossings log crossings), in parallel, bitwise the same on any number of
 * threads.
 * @throws std::invalid_argument if the surface spans more than 2^22 spacings, and Cancelled.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<GridCrossing> SurfaceCrossings(const SurfaceView& mesh,
  const GridShape& grid, CrossingNormal normal, const ProgressCallback& progress = {});

/**
 * 1 for each node of `grid` inside `mesh`, otherwise 0, by the even-odd rule along x. The
 * orientation of the triangles has no effect, and cavities are outside. Nodes exactly on the
 * surface may count as either.
 *
 * Throws as SurfaceCrossings does, and also if a line crosses the surface an odd number of times
 * (it is not closed) or closed shells cross each other (ShellCrossings.h). `inWorld` transforms the
 * place of the crossing to the coordinates shown to users.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<unsigned char> NodesInside(
  const SurfaceView& mesh, const GridShape& grid, const PlaceInWorld& inWorld = {});

/// 1 for each node with at least one of its six neighbours on the other side (irregular nodes),
/// otherwise 0.
std::vector<unsigned char> IrregularNodes(
  const std::vector<unsigned char>& inside, const GridShape& grid);

}

#endif
