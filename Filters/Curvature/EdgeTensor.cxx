#include "Curvature/EdgeTensor.h"

#include "Core/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isthmus
{
namespace
{

using Eigen::Vector2d;
using Eigen::Vector3d;
using PointMap = Eigen::Map<const Vector3d>;

Vector3d ComputeNormal(const SurfaceView& mesh, MeshTriangle triangle)
{
  const Triangle& corner = mesh.Corners(triangle.Value);
  const PointMap a(mesh.Point(corner[0]).data());
  return (PointMap(mesh.Point(corner[1]).data()) - a)
    .cross(PointMap(mesh.Point(corner[2]).data()) - a);
}

/// The only triangle around `from` that runs along the edge from `to` to `from`; None if there is
/// none.
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

/// Parameters in [0, 1] between which a + t (b - a) is within `radius` of the origin; empty if
/// equal.
template <typename Vector>
std::pair<double, double> SpanInside(const Vector& a, const Vector& b, double radius)
{
  const Vector d = b - a;
  const double dd = d.squaredNorm();
  const double middle = -a.dot(d) / dd;
  const double nearest = (a + middle * d).squaredNorm();
  const double rest = (radius * radius - nearest) / dd;
  if (!(rest > 0.0))
  {
    return { 0.0, 0.0 };
  }
  const double half = std::sqrt(rest);
  const double from = std::clamp(middle - half, 0.0, 1.0);
  return { from, std::max(from, std::clamp(middle + half, 0.0, 1.0)) };
}

double Cross(const Vector2d& a, const Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Signed area of the triangle (0, a, b) within the circle of `radius` about the origin 0.
double WedgeInCircle(const Vector2d& a, const Vector2d& b, double radius)
{
  const auto sector = [&](const Vector2d& p, const Vector2d& q)
  { return 0.5 * radius * radius * std::atan2(Cross(p, q), p.dot(q)); };
  if (!((b - a).squaredNorm() > 0.0))
  {
    return 0.0;
  }
  // Signed, so that the wedges of a triangle's edges add up to its part in the circle.
  const auto [from, to] = SpanInside(a, b, radius);
  if (from == to)
  {
    return sector(a, b);
  }
  const Vector2d p = a + from * (b - a);
  const Vector2d q = a + to * (b - a);
  return (from > 0.0 ? sector(a, p) : 0.0) + 0.5 * Cross(p, q) + (to < 1.0 ? sector(q, b) : 0.0);
}

/// Area of the triangle (a, b, c) within the ball of `radius` about the origin.
double AreaInBall(const Vector3d& a, const Vector3d& b, const Vector3d& c, double radius)
{
  const Vector3d normal = (b - a).cross(c - a);
  const double twiceArea = normal.norm();
  if (!(twiceArea > 0.0))
  {
    return 0.0;
  }
  const Vector3d n = normal / twiceArea;
  const double height = n.dot(a);
  if (std::abs(height) >= radius)
  {
    return 0.0;
  }
  const Vector3d x = n.unitOrthogonal();
  const Vector3d y = n.cross(x);
  const auto flat = [&](const Vector3d& p) { return Vector2d(x.dot(p), y.dot(p)); };
  const double circle = std::sqrt(radius * radius - height * height);
  return WedgeInCircle(flat(a), flat(b), circle) + WedgeInCircle(flat(b), flat(c), circle) +
    WedgeInCircle(flat(c), flat(a), circle);
}

}

DihedralAngles::DihedralAngles(const SurfaceView& mesh, const TriangleStars& stars)
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
        const Vector3d normal = ComputeNormal(mesh, triangle);
        this->Areas[triangle] = 0.5 * normal.norm();
        for (std::size_t edge = 0; edge < 3; ++edge)
        {
          const vtkIdType from = corner[edge];
          const vtkIdType to = corner[(edge + 1) % 3];
          const MeshTriangle other = AcrossEdge(stars, from, to);
          this->Neighbours[triangle][edge] = other;
          if (other.Exists())
          {
            const Vector3d otherNormal = ComputeNormal(mesh, other);
            const Vector3d along =
              (PointMap(mesh.Point(to).data()) - PointMap(mesh.Point(from).data())).normalized();
            this->Angles[triangle][edge] =
              // Positive where the edge is convex.
              std::atan2(normal.cross(otherNormal).dot(along), normal.dot(otherNormal));
          }
        }
      }
    });
}

void DihedralAngles::AddEdge(
  MeshTriangle triangle, std::size_t edge, double part, TensorSums& sums) const
{
  const Triangle& corner = this->Mesh.Corners(triangle.Value);
  const Vector3d along = PointMap(this->Mesh.Point(corner[(edge + 1) % 3]).data()) -
    PointMap(this->Mesh.Point(corner[edge]).data());
  const double squaredLength = along.squaredNorm();
  if (squaredLength > 0.0)
  {
    const double beta = this->Angles[triangle][edge];
    // Half an edge for each of its triangles.
    sums.Tensor += (0.5 * beta * part / squaredLength) * along * along.transpose();
  }
}

PrincipalFrame ComputePrincipalFrame(const Eigen::Matrix3d& tensor, const Vector3d& normal)
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

EdgeTensorIntegrator::EdgeTensorIntegrator(const SurfaceView& mesh, const TriangleStars& stars,
  const DihedralAngles& dihedrals, double radius)
  : Mesh(mesh)
  , Stars(stars)
  , Dihedrals(dihedrals)
  , Radius(radius)
  , TriangleStamps(mesh.Triangles.size(), 0)
{
}

/// Stamps allow a new neighbourhood without clearing the marks of all triangles.
bool EdgeTensorIntegrator::Visit(MeshTriangle triangle)
{
  unsigned int& stamp = this->TriangleStamps[triangle];
  const bool isNew = stamp != this->Stamp;
  stamp = this->Stamp;
  return isNew;
}

TensorSums EdgeTensorIntegrator::IntegrateOverBall(vtkIdType point)
{
  ++this->Stamp;
  TensorSums sums;
  const PointMap center(this->Mesh.Point(point).data());
  const MeshTriangle* const star = this->Stars.Triangles(point);
  this->Pending.assign(star, star + this->Stars.Size(point));
  std::for_each(
    this->Pending.begin(), this->Pending.end(), [&](MeshTriangle t) { this->Visit(t); });
  // Only across edges that reach into the ball: another sheet that is close does not count.
  while (!this->Pending.empty())
  {
    const MeshTriangle triangle = this->Pending.back();
    this->Pending.pop_back();
    const Triangle& id = this->Mesh.Corners(triangle.Value);
    const Vector3d corner[3] = { PointMap(this->Mesh.Point(id[0]).data()) - center,
      PointMap(this->Mesh.Point(id[1]).data()) - center,
      PointMap(this->Mesh.Point(id[2]).data()) - center };
    sums.Area += AreaInBall(corner[0], corner[1], corner[2], this->Radius);
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      const Vector3d& a = corner[edge];
      const Vector3d& b = corner[(edge + 1) % 3];
      const auto [from, to] = SpanInside(a, b, this->Radius);
      const MeshTriangle neighbour = this->Dihedrals.Neighbour(triangle, edge);
      if (to > from && neighbour.Exists())
      {
        this->Dihedrals.AddEdge(triangle, edge, (to - from) * (b - a).norm(), sums);
        if (this->Visit(neighbour))
        {
          this->Pending.push_back(neighbour);
        }
      }
    }
  }
  return sums;
}

double EdgeTensorIntegrator::Distance(vtkIdType point) const
{
  const auto p = static_cast<std::size_t>(point);
  return this->PointStamps[p] == this->Stamp ? this->Distances[p]
                                             : std::numeric_limits<double>::infinity();
}

void EdgeTensorIntegrator::Reach(vtkIdType point, double distance)
{
  if (distance < this->Distance(point))
  {
    const auto p = static_cast<std::size_t>(point);
    this->PointStamps[p] = this->Stamp;
    this->Distances[p] = distance;
    this->Queue.emplace(distance, point);
  }
}

double EdgeTensorIntegrator::AcrossTriangle(
  vtkIdType known1, vtkIdType known2, vtkIdType target) const
{
  const PointMap a(this->Mesh.Point(known1).data());
  const PointMap b(this->Mesh.Point(known2).data());
  const PointMap c(this->Mesh.Point(target).data());
  const double da = this->Distance(known1);
  const double db = this->Distance(known2);
  const double alongEdges = std::min(da + (c - a).norm(), db + (c - b).norm());
  const double ab = (b - a).norm();
  if (!std::isfinite(da) || !std::isfinite(db) || !(ab > 0.0))
  {
    return alongEdges;
  }
  // In the triangle's plane, a = (0, 0), b = (ab, 0), c above; the source lies below, unfolded.
  const double sx = (da * da - db * db + ab * ab) / (2.0 * ab);
  const double sy = -std::sqrt(std::max(0.0, da * da - sx * sx));
  const double cx = (c - a).dot(b - a) / ab;
  const double cy = std::sqrt(std::max(0.0, (c - a).squaredNorm() - cx * cx));
  const double crossing = cy > sy ? sx + (cx - sx) * (-sy) / (cy - sy) : -1.0;
  const bool passes = crossing >= 0.0 && crossing <= ab && sx * sx <= da * da;
  return passes ? std::min(alongEdges, std::hypot(cx - sx, cy - sy)) : alongEdges;
}

void EdgeTensorIntegrator::SpreadDistances(vtkIdType point)
{
  this->PointStamps.resize(this->Mesh.Points.size(), 0);
  this->Distances.resize(this->Mesh.Points.size());
  this->Reach(point, 0.0);
  while (!this->Queue.empty())
  {
    const auto [distance, nearest] = this->Queue.top();
    this->Queue.pop();
    if (distance > this->Distance(nearest) || distance >= this->Radius)
    {
      continue;
    }
    const MeshTriangle* const star = this->Stars.Triangles(nearest);
    for (vtkIdType i = 0; i < this->Stars.Size(nearest); ++i)
    {
      const auto [a, b] = this->Stars.OppositeEdge(star[i], nearest);
      this->Reach(a, this->AcrossTriangle(nearest, b, a));
      this->Reach(b, this->AcrossTriangle(nearest, a, b));
      if (this->Visit(star[i]))
      {
        this->Pending.push_back(star[i]);
      }
    }
  }
}

TensorSums EdgeTensorIntegrator::IntegrateOverDisc(vtkIdType point)
{
  ++this->Stamp;
  this->Pending.clear();
  this->SpreadDistances(point);
  TensorSums sums;
  for (const MeshTriangle triangle : this->Pending)
  {
    this->AddDiscTriangle(triangle, sums);
  }
  return sums;
}

void EdgeTensorIntegrator::AddDiscTriangle(MeshTriangle triangle, TensorSums& sums) const
{
  const Triangle& id = this->Mesh.Corners(triangle.Value);
  double beyond[3]; // distance to the rim, negative inside
  int inside = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    beyond[i] = this->Distance(id[i]) - this->Radius;
    inside += beyond[i] < 0.0;
  }
  // The single corner on one side of the rim cuts off the fraction s t of the area (Fig. 4.1).
  double fraction = inside == 3 ? 1.0 : 0.0;
  for (std::size_t i = 0; i < 3 && (inside == 1 || inside == 2); ++i)
  {
    if ((beyond[i] < 0.0) == (inside == 1))
    {
      const double s = beyond[i] / (beyond[i] - beyond[(i + 1) % 3]);
      const double t = beyond[i] / (beyond[i] - beyond[(i + 2) % 3]);
      fraction = inside == 1 ? s * t : 1.0 - s * t;
    }
  }
  sums.Area += fraction * this->Dihedrals.Area(triangle);
  for (std::size_t edge = 0; edge < 3; ++edge)
  {
    const double a = beyond[edge];
    const double b = beyond[(edge + 1) % 3];
    const double part = a < 0.0 && b < 0.0 ? 1.0
      : a < 0.0                            ? a / (a - b)
      : b < 0.0                            ? b / (b - a)
                                           : 0.0;
    const double length = (PointMap(this->Mesh.Point(id[(edge + 1) % 3]).data()) -
      PointMap(this->Mesh.Point(id[edge]).data()))
                            .norm();
    this->Dihedrals.AddEdge(triangle, edge, part * length, sums);
  }
}

}
