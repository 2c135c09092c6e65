/**
 * @file NormalFit.h
 * @brief Principal curvatures of a triangle surface from a least-squares fit of its normals.
 *
 * See SurfaceCurvature.h for the formula and its sources.
 */
#ifndef isthmus_NormalFit_h
#define isthmus_NormalFit_h

#include "Core/TriangleMesh.h"
#include "Curvature/EdgeTensor.h"
#include "Surfaces/TriangleStars.h"

#include <Eigen/Dense>

#include <optional>
#include <vector>

namespace isthmus
{

/// Unit normals, means over the triangles around each point weighted by area, and a third of the
/// area of these triangles. Both are 0 where the triangles have no area or the star is irregular.
struct PointNormals
{
  PointNormals(
    const SurfaceView& mesh, const TriangleStars& stars, const std::vector<StarKind>& kinds);

  std::vector<Eigen::Vector3d> Normals;
  std::vector<double> Areas;
};

/// Fits over balls about points of one surface. It keeps scratch memory of 4 bytes per point, so
/// use one object for many points, and one per thread.
class NormalFit
{
public:
  NormalFit(const SurfaceView& mesh, const TriangleStars& stars, const PointNormals& normals,
    double radius);

  /// From the points around `point`, and those within `radius` that are connected with it by edges
  /// within the ball. Nothing if they lie on a line or have no normals.
  std::optional<PrincipalFrame> Fit(vtkIdType point);

private:
  void Collect(vtkIdType point);

  SurfaceView Mesh;
  const TriangleStars& Stars;
  const PointNormals& Known;
  double Radius;

  unsigned int Stamp = 0; ///< a point was collected for this centre if its stamp is this
  std::vector<unsigned int> PointStamps;
  std::vector<vtkIdType> Collected;
};

}

#endif
