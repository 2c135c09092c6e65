#include "Contouring/MeetingPlanes.h"

#include "Core/DisjointSets.h"
#include "Core/Index.h"

#include <cmath>

namespace isthmus
{
namespace
{

/// A face near a cell: its normal, linear in place.
struct Face
{
  TangentPlane Mean{};
  double Curvature = 0.0;

  Point3 NormalAt(const Point3& x) const
  {
    return this->Mean.Normal + this->Curvature * (x - this->Mean.Place);
  }
};

Face FaceOf(const std::vector<TangentPlane>& planes)
{
  Face face;
  const double share = 1.0 / static_cast<double>(planes.size());
  for (const TangentPlane& plane : planes)
  {
    face.Mean.Place = face.Mean.Place + share * plane.Place;
    face.Mean.Normal = face.Mean.Normal + share * plane.Normal;
  }
  double turn = 0.0, way = 0.0;
  for (const TangentPlane& plane : planes)
  {
    const Point3 d = plane.Place - face.Mean.Place;
    turn += Dot(plane.Normal - face.Mean.Normal, d);
    way += Dot(d, d);
  }
  face.Curvature = way > 0.0 ? turn / way : 0.0;
  return face;
}

/// For each plane, the face it is of.
std::vector<Face> FacesOf(const std::vector<TangentPlane>& planes)
{
  const double cosine = std::cos(std::atan(1.0) * 2.0 / 3.0); // of 30 degrees
  const auto count = static_cast<std::int64_t>(planes.size());
  DisjointSets<std::int64_t> sets(count);
  for (std::int64_t i = 0; i < count; ++i)
  {
    for (std::int64_t j = 0; j < i; ++j)
    {
      if (Dot(planes[At(i)].Normal, planes[At(j)].Normal) > cosine)
      {
        sets.Join(i, j);
      }
    }
  }
  std::vector<Face> faces;
  for (std::int64_t i = 0; i < count; ++i)
  {
    std::vector<TangentPlane> own;
    for (std::int64_t j = 0; j < count; ++j)
    {
      if (sets.Find(i) == sets.Find(j))
      {
        own.push_back(planes[At(j)]);
      }
    }
    faces.push_back(FaceOf(own));
  }
  return faces;
}

}

QuadraticErrors MeetingPlanes(
  const std::vector<TangentPlane>& planes, const Bounds3& around, double threshold)
{
  QuadraticErrors best;
  for (const TangentPlane& plane : planes)
  {
    best.Add(plane.Place, plane.Normal);
  }
  if (best.Rank(threshold) < 2)
  {
    return best;
  }
  const std::vector<Face> faces = FacesOf(planes);
  Point3 x = best.Least(around, threshold);
  constexpr int rounds = 3; // each takes off a factor of h / R
  for (int round = 0; round < rounds; ++round)
  {
    QuadraticErrors halfway;
    for (std::size_t i = 0; i < planes.size(); ++i)
    {
      const Point3 n = planes[i].Normal + faces[i].NormalAt(x);
      halfway.Add(planes[i].Place, (1.0 / Length(n)) * n);
    }
    const Point3 y = halfway.Least(around, threshold);
    if (!(halfway.At(y) < best.At(x)))
    {
      break;
    }
    best = halfway;
    x = y;
  }
  return best;
}

}
