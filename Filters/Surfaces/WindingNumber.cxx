#include "Surfaces/WindingNumber.h"

#include "Core/Geometry.h"

#include <complex>
#include <numeric>

namespace isthmus
{
namespace
{

constexpr double FourPi = 4.0 * Pi;
constexpr std::int64_t LeafSize = 8;

std::array<Point3, 3> GetCorners(const SurfaceView& mesh, std::int64_t triangle)
{
  const Triangle& t = mesh.Triangles[static_cast<std::size_t>(triangle)];
  const auto at = [&](std::size_t c) { return mesh.Points[static_cast<std::size_t>(t[c])]; };
  return { at(0), at(1), at(2) };
}

Point3 Centroid(const std::array<Point3, 3>& t)
{
  return (1.0 / 3.0) * (t[0] + t[1] + t[2]);
}

}

namespace
{

/// Along its direction from 0 lies half the solid angle of a triangle.
std::complex<double> HalfAngle(const Point3& a, const Point3& b, const Point3& c)
{
  const double la = Length(a);
  const double lb = Length(b);
  const double lc = Length(c);
  const double below = la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb;
  return { below, Dot(a, Cross(b, c)) };
}

/// Sum of the angles of complex numbers: that of their product, plus the number of full turns. For
/// a few tens of numbers, so that the product does not underflow.
class AngleSum
{
public:
  void Add(const std::complex<double>& z)
  {
    const double size = std::abs(z.real()) + std::abs(z.imag());
    if (!(size > 0.0))
    {
      return; // seen from a corner: no angle
    }
    const double x = z.real() / size;
    const double y = z.imag() / size;
    const double re = this->Re * x - this->Im * y;
    const double im = this->Re * y + this->Im * x;
    const bool isUp = this->Im >= 0.0;
    if (isUp == (y >= 0.0) && isUp != (im >= 0.0))
    {
      this->Rounds += isUp ? 1.0 : -1.0;
    }
    this->Re = re;
    this->Im = im;
  }

  double Sum() const
  {
    return std::atan2(this->Im + 0.0, this->Re) + 2.0 * Pi * this->Rounds; // -0 is treated as 0
  }

private:
  double Re = 1.0;
  double Im = 0.0;
  double Rounds = 0.0;
};

}

double SolidAngle(const Point3& a, const Point3& b, const Point3& c)
{
  return 2.0 * std::arg(HalfAngle(a, b, c));
}

WindingNumber::WindingNumber(const SurfaceView& mesh)
{
  const auto count = static_cast<std::int64_t>(mesh.Triangles.size());
  if (count == 0)
  {
    return;
  }
  std::vector<std::int64_t> order(mesh.Triangles.size());
  std::iota(order.begin(), order.end(), 0);
  this->Corners.reserve(order.size());
  this->Parts.resize(1);
  this->Build(0, 0, count, order, mesh);
}

void WindingNumber::Summarise(Part& part, std::int64_t first, std::int64_t last,
  const std::vector<std::int64_t>& order, const SurfaceView& mesh) const
{
  double area = 0.0;
  Point3 weighted{ 0, 0, 0 }, plain{ 0, 0, 0 };
  part.AreaNormal = { 0, 0, 0 };
  for (std::int64_t i = first; i < last; ++i)
  {
    const auto t = GetCorners(mesh, order[static_cast<std::size_t>(i)]);
    const Point3 normal = 0.5 * Cross(t[1] - t[0], t[2] - t[0]);
    const double size = Length(normal);
    area += size;
    weighted = weighted + size * Centroid(t);
    plain = plain + Centroid(t);
    part.AreaNormal = part.AreaNormal + normal;
  }
  part.Center =
    area > 0.0 ? (1.0 / area) * weighted : (1.0 / static_cast<double>(last - first)) * plain;
  part.Radius = 0.0;
  for (std::int64_t i = first; i < last; ++i)
  {
    for (const Point3& p : GetCorners(mesh, order[static_cast<std::size_t>(i)]))
    {
      const Point3 d = p - part.Center;
      part.Radius = std::max(part.Radius, Length(d));
    }
  }
}

void WindingNumber::Build(std::size_t at, std::int64_t first, std::int64_t last,
  std::vector<std::int64_t>& order, const SurfaceView& mesh)
{
  this->Summarise(this->Parts[at], first, last, order, mesh);
  if (last - first <= LeafSize)
  {
    this->Parts[at].First = static_cast<std::int64_t>(this->Corners.size());
    this->Parts[at].Count = last - first;
    for (std::int64_t i = first; i < last; ++i)
    {
      this->Corners.push_back(GetCorners(mesh, order[static_cast<std::size_t>(i)]));
    }
    return;
  }
  Bounds3 box{ this->Parts[at].Center, this->Parts[at].Center };
  for (std::int64_t i = first; i < last; ++i)
  {
    box.Add(Centroid(GetCorners(mesh, order[static_cast<std::size_t>(i)])));
  }
  const Point3 sides = box.Max - box.Min;
  const auto axis =
    static_cast<std::size_t>(std::max_element(sides.begin(), sides.end()) - sides.begin());
  const std::int64_t middle = (first + last) / 2;
  std::nth_element(order.begin() + first, order.begin() + middle, order.begin() + last,
    [&](std::int64_t a, std::int64_t b)
    {
      const double x = Centroid(GetCorners(mesh, a))[axis], y = Centroid(GetCorners(mesh, b))[axis];
      return x != y ? x < y : a < b;
    });
  const std::size_t child = this->Parts.size();
  this->Parts.resize(child + 2);
  this->Parts[at].First = static_cast<std::int64_t>(child);
  this->Parts[at].Count = 0;
  this->Build(child, first, middle, order, mesh);
  this->Build(child + 1, middle, last, order, mesh);
}

double WindingNumber::operator()(const Point3& x) const
{
  constexpr double farAway = 3.0;
  double sum = 0.0;
  std::array<std::int64_t, 64> stack; // levels of halving: no tree is deeper
  std::size_t depth = 0;
  if (!this->Parts.empty())
  {
    stack[depth++] = 0;
  }
  while (depth > 0)
  {
    const Part& part = this->Parts[static_cast<std::size_t>(stack[--depth])];
    const Point3 d = part.Center - x;
    const double distance = Length(d);
    if (distance > farAway * part.Radius)
    {
      sum += Dot(d, part.AreaNormal) / (distance * distance * distance);
    }
    else if (part.Count == 0)
    {
      stack[depth++] = part.First;
      stack[depth++] = part.First + 1;
    }
    else
    {
      AngleSum half;
      for (std::int64_t i = part.First; i < part.First + part.Count; ++i)
      {
        const auto& t = this->Corners[static_cast<std::size_t>(i)];
        half.Add(HalfAngle(t[0] - x, t[1] - x, t[2] - x));
      }
      sum += 2.0 * half.Sum();
    }
  }
  return sum / FourPi;
}

}
