#include "Curvature/StarCurvature.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

using Eigen::Vector3d;
using PointMap = Eigen::Map<const Vector3d>;

/// The triangle (v, v + toA, v + toB) with the cotangents of its three angles.
struct Corner
{
  Vector3d ToA;
  Vector3d ToB;
  double TwiceArea;
  double CotV;
  double CotA;
  double CotB;
};

/// Part of the triangle's area that belongs to v.
double PartOf(const Corner& corner, DualArea rule)
{
  const double area = 0.5 * corner.TwiceArea;
  if (rule == DualArea::Barycentric)
  {
    return area / 3.0;
  }
  if (rule == DualArea::Mixed && std::min({ corner.CotV, corner.CotA, corner.CotB }) < 0.0)
  {
    return corner.CotV < 0.0 ? area / 2.0 : area / 4.0;
  }
  return (corner.CotB * corner.ToA.squaredNorm() + corner.CotA * corner.ToB.squaredNorm()) / 8.0;
}

}

StarSums SumStar(
  const SurfaceView& mesh, const TriangleStars& stars, vtkIdType point, DualArea rule)
{
  StarSums sums;
  const PointMap v(mesh.Point(point).data());
  const MeshTriangle* const triangles = stars.Triangles(point);
  for (vtkIdType i = 0; i < stars.Size(point); ++i)
  {
    const auto [a, b] = stars.OppositeEdge(triangles[i], point);
    Corner corner;
    corner.ToA = PointMap(mesh.Point(a).data()) - v;
    corner.ToB = PointMap(mesh.Point(b).data()) - v;
    const Vector3d opposite = corner.ToB - corner.ToA;
    const Vector3d normal = corner.ToA.cross(corner.ToB);
    corner.TwiceArea = normal.norm();
    const double longest =
      std::max({ corner.ToA.squaredNorm(), corner.ToB.squaredNorm(), opposite.squaredNorm() });
    if (!(corner.TwiceArea > 1e-14 * longest))
    {
      sums.Degenerate = true;
      continue;
    }
    const double cosine = corner.ToA.dot(corner.ToB);
    corner.CotV = cosine / corner.TwiceArea;
    corner.CotA = -corner.ToA.dot(opposite) / corner.TwiceArea;
    corner.CotB = corner.ToB.dot(opposite) / corner.TwiceArea;
    sums.Angle += std::atan2(corner.TwiceArea, cosine);
    sums.Area += PartOf(corner, rule);
    sums.Normal += normal;
    sums.Cotangent -= corner.CotA * corner.ToB + corner.CotB * corner.ToA;
  }
  return sums;
}

}
