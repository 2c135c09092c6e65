/**
 * @file TriangleStars.h
 * @brief The triangles around each point of a surface, and whether they form a disc.
 */
#ifndef isthmus_TriangleStars_h
#define isthmus_TriangleStars_h

#include "Core/Handles.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersSurfacesModule.h" // for the export macro

#include <utility>
#include <vector>

namespace isthmus
{

/// A triangle of a surface, seen from one of its points.
using MeshTriangle = Handle<struct MeshTriangleKind, vtkIdType>;

/// The arrangement of the triangles around a point.
enum class StarKind : unsigned char
{
  Isolated, ///< There are none: the point is not on the surface.
  Interior, ///< One closed fan of consistently oriented triangles: the surface is a disc here.
  Boundary, ///< One open fan: a half disc.
  Irregular ///< Anything else: an edge of more than two triangles, inconsistently oriented
            ///< neighbours, several fans that touch at the point, or a triangle with the same
            ///< corner twice.
};

/// The triangles around each point. Building and memory: O(triangles).
class VTKISTHMUSFILTERSSURFACES_EXPORT TriangleStars
{
public:
  /// @pre The owner of `mesh` outlives this object.
  explicit TriangleStars(const SurfaceView& mesh);
  explicit TriangleStars(TriangleMesh&& mesh) = delete;

  vtkIdType Size(vtkIdType point) const
  {
    const auto at = static_cast<std::size_t>(point);
    return this->First[at + 1] - this->First[at];
  }

  /// Ids of the Size(point) triangles around `point`, in an order that depends on the mesh only.
  const MeshTriangle* Triangles(vtkIdType point) const
  {
    return this->Around.data() + this->First[static_cast<std::size_t>(point)];
  }

  /// The corners (a, b) of `triangle` that follow its corner `point`.
  std::pair<vtkIdType, vtkIdType> OppositeEdge(MeshTriangle triangle, vtkIdType point) const;

  /// Opposite edges of all triangles around `point`, sorted. Reuses the memory of `edges`.
  void Link(vtkIdType point, std::vector<std::pair<vtkIdType, vtkIdType>>& edges) const;

  /// Kind of the star of `point`; `scratch` avoids an allocation in each call. O(n log n) for n
  /// triangles.
  StarKind Kind(vtkIdType point, std::vector<std::pair<vtkIdType, vtkIdType>>& scratch) const;

private:
  SurfaceView Mesh;
  std::vector<vtkIdType> First;     ///< of each point's triangles in Around; one more at the end
  std::vector<MeshTriangle> Around; ///< latest first
};

/// Kind of each point's star, in parallel.
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<StarKind> StarKinds(
  const SurfaceView& mesh, const TriangleStars& stars);

}

#endif
