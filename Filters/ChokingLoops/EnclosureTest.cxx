#include "ChokingLoops/EnclosureTest.h"

#include "Core/Index.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

/// A fixed rotation by no nice angle, so that rays along x meet no axis-parallel edge.
Point3 Turned(const Point3& p)
{
  const Point3 a{ 0.8127, 0.3391, -0.4738 };
  const Point3 b{ -0.5129, 0.7793, -0.3600 };
  return { Dot(p, a), Dot(p, b), Dot(p, Cross(a, b)) };
}

/// Twice the area of (a, b, p) seen along x.
double Area(const Point3& a, const Point3& b, const Point3& p)
{
  return (b[1] - a[1]) * (p[2] - a[2]) - (b[2] - a[2]) * (p[1] - a[1]);
}

}

EnclosureTest::EnclosureTest(const SurfaceView& mesh, const SurfaceHomology& homology)
  : Mesh(mesh)
  , Homology(homology)
{
  this->Points.reserve(mesh.Points.size());
  this->Box.Min = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
  this->Box.Max = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
  for (const Point3& p : mesh.Points)
  {
    this->Points.push_back(Turned(p));
    this->Box.Add(this->Points.back());
  }
  this->Bins = std::clamp<std::size_t>(
    static_cast<std::size_t>(0.5 * std::sqrt(static_cast<double>(mesh.Triangles.size()))), 1, 2048);
  const auto forEachBin = [this](const Triangle& t, auto&& visit)
  {
    Bounds3 box{ this->Points[At(t[0])], this->Points[At(t[0])] };
    box.Add(this->Points[At(t[1])]);
    box.Add(this->Points[At(t[2])]);
    for (std::size_t j = this->Bin(box.Min[1], 1); j <= this->Bin(box.Max[1], 1); ++j)
    {
      for (std::size_t k = this->Bin(box.Min[2], 2); k <= this->Bin(box.Max[2], 2); ++k)
      {
        visit(j * this->Bins + k);
      }
    }
  };
  this->First.assign(this->Bins * this->Bins + 1, 0);
  for (const Triangle& t : mesh.Triangles)
  {
    forEachBin(t, [this](std::size_t bin) { ++this->First[bin + 1]; });
  }
  for (std::size_t i = 1; i < this->First.size(); ++i)
  {
    this->First[i] += this->First[i - 1];
  }
  this->Inside.resize(At(this->First.back()));
  std::vector<SimplexId> next(this->First.begin(), this->First.end() - 1);
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    forEachBin(mesh.Triangles[i],
      [&](std::size_t bin) { this->Inside[At(next[bin]++)] = static_cast<SimplexId>(i); });
  }
}

std::size_t EnclosureTest::Bin(double v, std::size_t axis) const
{
  const double width = this->Box.Max[axis] - this->Box.Min[axis];
  const double scaled =
    width > 0.0 ? (v - this->Box.Min[axis]) / width * static_cast<double>(this->Bins) : 0.0;
  // Written so that a NaN goes to the first bin: std::clamp would pass it on to the cast.
  return scaled > 0.0
    ? static_cast<std::size_t>(std::min(scaled, static_cast<double>(this->Bins - 1)))
    : 0;
}

std::vector<int> EnclosureTest::Enclosing(const Point3& point) const
{
  const Point3 p = Turned(point);
  std::vector<int> crossed;
  for (std::size_t axis = 1; axis < 3; ++axis)
  {
    if (p[axis] < this->Box.Min[axis] || p[axis] > this->Box.Max[axis])
    {
      return crossed;
    }
  }
  const std::size_t bin = this->Bin(p[1], 1) * this->Bins + this->Bin(p[2], 2);
  for (SimplexId i = this->First[bin]; i < this->First[bin + 1]; ++i)
  {
    const Triangle& t = this->Mesh.Triangles[At(this->Inside[At(i)])];
    std::array<double, 3> area; // of p with the edge opposite to corner k
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int64_t a = t[(k + 1) % 3];
      const std::int64_t b = t[(k + 2) % 3];
      area[k] = a < b ? Area(this->Points[At(a)], this->Points[At(b)], p)
                      : -Area(this->Points[At(b)], this->Points[At(a)], p);
    }
    // "Positive" for an edge run one way must be "not positive" run the other way.
    const auto left = [&](std::size_t k)
    { return t[(k + 1) % 3] < t[(k + 2) % 3] ? area[k] > 0.0 : area[k] >= 0.0; };
    if (left(0) != left(1) || left(1) != left(2))
    {
      continue;
    }
    const double sum = area[0] + area[1] + area[2];
    const double x = (area[0] * this->Points[At(t[0])][0] + area[1] * this->Points[At(t[1])][0] +
                       area[2] * this->Points[At(t[2])][0]) /
      sum;
    if (x > p[0])
    {
      crossed.push_back(this->Homology.ComponentOf(static_cast<SimplexId>(t[0])));
    }
  }
  std::sort(crossed.begin(), crossed.end());
  std::vector<int> odd;
  for (std::size_t i = 0; i < crossed.size(); ++i)
  {
    if (i + 1 < crossed.size() && crossed[i] == crossed[i + 1])
    {
      ++i;
      continue;
    }
    odd.push_back(crossed[i]);
  }
  return odd;
}

}
