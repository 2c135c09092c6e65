#include "Curvature/EdgeBends.h"

#include "Core/ParallelFor.h"

#include <cmath>

namespace isthmus
{
namespace
{

using Eigen::Vector3d;
using PointMap = Eigen::Map<const Vector3d>;

Vector3d NormalOf(const SurfaceView& mesh, MeshTriangle triangle)
{
  const Triangle& corner = mesh.Corners(triangle.Value);
  const PointMap a(mesh.Point(corner[0]).data());
  return (PointMap(mesh.Point(corner[1]).data()) - a)
    .cross(PointMap(mesh.Point(corner[2]).data()) - a);
}

/// The only triangle around `from` that runs along the edge from `to` to `from`; None without one.
MeshTriangle AcrossEdge(const TriangleStars& stars, vtkIdType from, vtkIdType to)
{
  MeshTriangle found = MeshTriangle::None();
  const MeshTriangle* const triangles = stars.Triangles(from);
  for (vtkIdType i = 0; i < stars.Size(from); ++i)
  {
    if (stars.OppositeEdge(triangles[i], from).second == to)
    {
      if (found.Exists())
      {
        return MeshTriangle::None();
      }
      found = triangles[i];
    }
  }
  return found;
}

}

EdgeBends::EdgeBends(const SurfaceView& mesh, const TriangleStars& stars)
  : Mesh(mesh)
  , Neighbours(mesh.Triangles.size())
  , Angles(mesh.Triangles.size())
  , Areas(mesh.Triangles.size())
{
  ParallelFor(0, mesh.NumberOfTriangles(), 4096,
    [&](std::int64_t first, std::int64_t last)
    {
      for (const MeshTriangle triangle : HandleRange<MeshTriangle>(first, last))
      {
        const Triangle& corner = mesh.Corners(triangle.Value);
        const Vector3d normal = NormalOf(mesh, triangle);
        this->Areas[triangle] = 0.5 * normal.norm();
        for (std::size_t edge = 0; edge < 3; ++edge)
        {
          const vtkIdType from = corner[edge];
          const vtkIdType to = corner[(edge + 1) % 3];
          const MeshTriangle other = AcrossEdge(stars, from, to);
          this->Neighbours[triangle][edge] = other;
          if (other.Exists())
          {
            const Vector3d otherNormal = NormalOf(mesh, other);
            const Vector3d along =
              (PointMap(mesh.Point(to).data()) - PointMap(mesh.Point(from).data())).normalized();
            this->Angles[triangle][edge] =
              std::atan2(normal.cross(otherNormal).dot(along), normal.dot(otherNormal));
          }
        }
      }
    });
}

void EdgeBends::AddEdge(
  MeshTriangle triangle, std::size_t edge, double part, TensorSums& sums) const
{
  const Triangle& corner = this->Mesh.Corners(triangle.Value);
  const Vector3d along = PointMap(this->Mesh.Point(corner[(edge + 1) % 3]).data()) -
    PointMap(this->Mesh.Point(corner[edge]).data());
  const double squaredLength = along.squaredNorm();
  if (squaredLength > 0.0)
  {
    const double beta = this->Angles[triangle][edge];
    sums.Tensor += (0.5 * beta * part / squaredLength) * along * along.transpose();
  }
}

PrincipalFrame PrincipalFrameOf(const Eigen::Matrix3d& tensor, const Vector3d& normal)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor);
  const Eigen::Matrix3d& vectors = solver.eigenvectors(); // eigenvalues ascend
  Eigen::Index dropped = 0;
  (vectors.transpose() * normal).cwiseAbs().maxCoeff(&dropped);
  const Eigen::Index low = dropped == 0 ? 1 : 0;
  const Eigen::Index high = dropped == 2 ? 1 : 2;
  PrincipalFrame frame;
  frame.Maximum = solver.eigenvalues()[high];
  frame.Minimum = solver.eigenvalues()[low];
  frame.Direction1 = vectors.col(low); // exchanged: see SurfaceCurvature.h
  frame.Direction2 = vectors.col(high);
  return frame;
}

}
