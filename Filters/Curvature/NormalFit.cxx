#include "Curvature/NormalFit.h"

#include "Core/Index.h"
#include "Core/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using PointMap = Eigen::Map<const Vector3d>;

/// Length of the arc that has the chord 1 and turns by `angle`.
double ArcOfChord(double angle)
{
  const double half = 0.5 * angle;
  return half > 1e-4 ? half / std::sin(half) : 1.0 + half * half / 6.0;
}

}

PointNormals::PointNormals(
  const SurfaceView& mesh, const TriangleStars& stars, const std::vector<StarKind>& kinds)
  : Normals(mesh.Points.size(), Vector3d::Zero())
  , Areas(mesh.Points.size(), 0.0)
{
  ParallelFor(0, mesh.NumberOfPoints(), 4096,
    [&](std::int64_t first, std::int64_t last)
    {
      for (vtkIdType point = first; point < last; ++point)
      {
        if (kinds[At(point)] == StarKind::Irregular)
        {
          continue;
        }
        const PointMap at(mesh.Point(point).data());
        Vector3d sum = Vector3d::Zero();
        double area = 0.0;
        for (vtkIdType i = 0; i < stars.Size(point); ++i)
        {
          const auto [a, b] = stars.OppositeEdge(stars.Triangles(point)[i], point);
          const Vector3d normal =
            (PointMap(mesh.Point(a).data()) - at).cross(PointMap(mesh.Point(b).data()) - at);
          sum += normal;
          area += normal.norm() / 6.0;
        }
        if (const double length = sum.norm(); length > 0.0)
        {
          this->Normals[At(point)] = sum / length;
          this->Areas[At(point)] = area;
        }
      }
    });
}

NormalFit::NormalFit(
  const SurfaceView& mesh, const TriangleStars& stars, const PointNormals& normals, double radius)
  : Mesh(mesh)
  , Stars(stars)
  , Known(normals)
  , Radius(radius)
  , PointStamps(mesh.Points.size(), 0)
{
}

void NormalFit::Collect(vtkIdType point)
{
  ++this->Stamp;
  const PointMap center(this->Mesh.Point(point).data());
  const double squaredRadius = this->Radius * this->Radius;
  this->Collected.assign(1, point);
  this->PointStamps[At(point)] = this->Stamp;
  // Edges only: another sheet that is close does not count.
  for (std::size_t next = 0; next < this->Collected.size(); ++next)
  {
    const vtkIdType from = this->Collected[next];
    const MeshTriangle* const star = this->Stars.Triangles(from);
    for (vtkIdType i = 0; i < this->Stars.Size(from); ++i)
    {
      const auto [a, b] = this->Stars.OppositeEdge(star[i], from);
      for (const vtkIdType to : { a, b })
      {
        const bool near = from == point ||
          (PointMap(this->Mesh.Point(to).data()) - center).squaredNorm() <= squaredRadius;
        if (near && this->PointStamps[At(to)] != this->Stamp)
        {
          this->PointStamps[At(to)] = this->Stamp;
          this->Collected.push_back(to);
        }
      }
    }
  }
}

std::optional<PrincipalFrame> NormalFit::Fit(vtkIdType point)
{
  const Vector3d& normal = this->Known.Normals[At(point)];
  if (!(this->Known.Areas[At(point)] > 0.0))
  {
    return std::nullopt;
  }
  this->Collect(point);
  const PointMap center(this->Mesh.Point(point).data());
  const Vector3d x = normal.unitOrthogonal();
  const Vector3d y = normal.cross(x);
  const auto tangential = [&](const Vector3d& v) { return Vector2d(v.dot(x), v.dot(y)); };
  Matrix3d squares = Matrix3d::Zero();
  Eigen::Matrix<double, 3, 2> products = Eigen::Matrix<double, 3, 2>::Zero();
  double reach = 0.0;
  for (const vtkIdType id : this->Collected)
  {
    reach = std::max(reach, (PointMap(this->Mesh.Point(id).data()) - center).squaredNorm());
  }
  reach = std::sqrt(reach); // so that all unknowns are of the same size
  for (const vtkIdType id : this->Collected)
  {
    const Vector3d& other = this->Known.Normals[At(id)];
    const double cosine = other.dot(normal);
    if (!(cosine > 0.0)) // beyond a fold
    {
      continue;
    }
    const Vector2d lean = tangential(other);
    const double sine = lean.norm();
    const double angle = std::atan2(sine, cosine);
    const Vector2d turn = sine > 0.0 ? Vector2d(lean * (angle / sine)) : Vector2d::Zero();
    const Vector3d chord = PointMap(this->Mesh.Point(id).data()) - center;
    const Vector2d flat = tangential(chord);
    const double along = flat.norm();
    const Vector2d place = along > 0.0
      ? Vector2d(flat * (chord.norm() * ArcOfChord(angle) / (along * reach)))
      : Vector2d::Zero();
    const Vector3d row(1.0, place.x(), place.y());
    const double weight = this->Known.Areas[At(id)];
    squares += weight * row * row.transpose();
    products += weight * row * turn.transpose();
  }
  const Eigen::LDLT<Matrix3d> factors(squares);
  const auto pivots = factors.vectorD();
  if (!(pivots.minCoeff() > 1e-10 * pivots.maxCoeff()))
  {
    return std::nullopt;
  }
  const Eigen::Matrix2d slopes = factors.solve(products).bottomRows<2>() / reach;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(0.5 * (slopes + slopes.transpose()));
  const auto direction = [&](Eigen::Index column)
  {
    const Vector2d v = solver.eigenvectors().col(column);
    return Vector3d(v.x() * x + v.y() * y);
  };
  PrincipalFrame frame;
  frame.Maximum = solver.eigenvalues()[1];
  frame.Minimum = solver.eigenvalues()[0];
  frame.Direction1 = direction(1);
  frame.Direction2 = direction(0);
  return frame;
}

}
