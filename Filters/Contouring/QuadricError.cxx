#include "Contouring/QuadricError.h"

#include "Core/DisjointSets.h"
#include "Core/Index.h"

#include <Eigen/Dense>

#include <cmath>
#include <limits>

namespace isthmus
{

namespace
{

/// Where each coordinate of the minimum is sought: anywhere, or on a side of the box.
enum class Place
{
  Free,
  LowerSide,
  UpperSide
};

/// All 27 combinations, with all free first.
std::array<Place, 3> DecodePlaces(int combination)
{
  return { static_cast<Place>(combination % 3), static_cast<Place>(combination / 3 % 3),
    static_cast<Place>(combination / 9) };
}

/**
 * The x with the least |a^(1/2) x|^2 - 2 b.x whose coordinates at sides are fixed; along directions
 * whose eigenvalue is not over `negligible`, 0. Box and x are relative to the mean.
 */
Eigen::Vector3d MinimizeOnSides(const Eigen::Matrix3d& a, const Eigen::Vector3d& b,
  const Bounds3& box, const std::array<Place, 3>& places, double negligible)
{
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  Eigen::Matrix3d free = Eigen::Matrix3d::Identity();
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (places[i] != Place::Free)
    {
      const auto axis = static_cast<Eigen::Index>(i);
      x[axis] = places[i] == Place::LowerSide ? box.Min[i] : box.Max[i];
      free(axis, axis) = 0.0;
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(free * a * free);
  const Eigen::Vector3d rest = free * (b - a * x);
  for (int k = 0; k < 3; ++k)
  {
    const double value = solver.eigenvalues()[k];
    if (value > negligible && value > 0.0)
    {
      const Eigen::Vector3d v = solver.eigenvectors().col(k);
      x += (v.dot(rest) / value) * v;
    }
  }
  return x;
}

Eigen::Matrix3d AsEigen(const std::array<Point3, 3>& rows)
{
  Eigen::Matrix3d a;
  for (int r = 0; r < 3; ++r)
  {
    a.row(r) = Eigen::Map<const Eigen::Vector3d>(rows[static_cast<std::size_t>(r)].data());
  }
  return a;
}

}

void QuadricError::Add(const Point3& p, const Point3& n)
{
  this->Origin = this->Count == 0 ? p : this->Origin;
  const Point3 d = p - this->Origin;
  const double along = Dot(n, d);
  for (std::size_t r = 0; r < 3; ++r)
  {
    this->Matrix[r] = this->Matrix[r] + n[r] * n;
  }
  this->Vector = this->Vector + along * n;
  this->Constant += along * along;
  this->Sum = this->Sum + d;
  ++this->Count;
}

void QuadricError::Add(const QuadricError& other)
{
  if (this->Count == 0)
  {
    *this = other;
    return;
  }
  const Point3 d = other.Origin - this->Origin;
  const Point3 moved = other.Times(d);
  for (std::size_t r = 0; r < 3; ++r)
  {
    this->Matrix[r] = this->Matrix[r] + other.Matrix[r];
  }
  this->Vector = this->Vector + other.Vector + moved;
  this->Constant += other.Constant + 2.0 * Dot(other.Vector, d) + Dot(d, moved);
  this->Sum = this->Sum + other.Sum + static_cast<double>(other.Count) * d;
  this->Count += other.Count;
}

Point3 QuadricError::Times(const Point3& d) const
{
  return { Dot(this->Matrix[0], d), Dot(this->Matrix[1], d), Dot(this->Matrix[2], d) };
}

Point3 QuadricError::Mean() const
{
  return this->Origin + (1.0 / static_cast<double>(this->Count)) * this->Sum;
}

double QuadricError::At(const Point3& x) const
{
  const Point3 d = x - this->Origin;
  return std::max(0.0, Dot(d, this->Times(d)) - 2.0 * Dot(this->Vector, d) + this->Constant);
}

int QuadricError::Rank(double threshold) const
{
  const Eigen::Vector3d values =
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(AsEigen(this->Matrix), Eigen::EigenvaluesOnly)
      .eigenvalues();
  return static_cast<int>((values.array() > threshold * values[2]).count());
}

Point3 QuadricError::Least(const Bounds3& box, double threshold) const
{
  const Point3 mean = this->Mean();
  const Point3 right = this->Vector - this->Times(mean - this->Origin);
  const Eigen::Matrix3d a = AsEigen(this->Matrix);
  const Eigen::Vector3d b = Eigen::Map<const Eigen::Vector3d>(right.data());
  const double largest =
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(a, Eigen::EigenvaluesOnly).eigenvalues()[2];

  Point3 best = mean;
  double least = std::numeric_limits<double>::infinity();
  const Bounds3 around{ box.Min - mean, box.Max - mean };
  for (int combination = 0; combination < 27; ++combination)
  {
    const Eigen::Vector3d x =
      MinimizeOnSides(a, b, around, DecodePlaces(combination), threshold * largest);
    Point3 candidate;
    bool fits = true;
    for (std::size_t i = 0; i < 3; ++i)
    {
      candidate[i] = mean[i] + x[static_cast<Eigen::Index>(i)];
      const double slack = 1e-9 * (box.Max[i] - box.Min[i]);
      fits = fits && candidate[i] >= box.Min[i] - slack && candidate[i] <= box.Max[i] + slack;
      candidate[i] = std::min(box.Max[i], std::max(box.Min[i], candidate[i]));
    }
    const double value = this->At(candidate);
    if (fits && value < least)
    {
      best = candidate;
      least = value;
    }
    if (fits && combination == 0)
    {
      break;
    }
  }
  return best;
}

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

Face FitFace(const std::vector<TangentPlane>& planes)
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

/// The face to which each plane belongs.
std::vector<Face> FitFaces(const std::vector<TangentPlane>& planes)
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
    faces.push_back(FitFace(own));
  }
  return faces;
}

}

QuadricError FitQuadricError(
  const std::vector<TangentPlane>& planes, const Bounds3& around, double threshold)
{
  QuadricError best;
  for (const TangentPlane& plane : planes)
  {
    best.Add(plane.Place, plane.Normal);
  }
  if (best.Rank(threshold) < 2)
  {
    return best;
  }
  const std::vector<Face> faces = FitFaces(planes);
  Point3 x = best.Least(around, threshold);
  constexpr int rounds = 3; // each reduces the error by a factor of h / R
  for (int round = 0; round < rounds; ++round)
  {
    QuadricError halfway;
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
