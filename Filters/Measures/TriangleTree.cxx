#include "TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace isthmus
{
namespace
{

constexpr std::int64_t TrianglesOfLeaf = 4;
constexpr std::size_t DeepestStack = 128; // more than 2 log2 of any count of triangles

double SquaredDistanceToSegment(const Point3& x, const Point3& a, const Point3& b)
{
  const Point3 d = b - a;
  const double dd = Dot(d, d);
  const double t = dd > 0.0 ? std::clamp(Dot(x - a, d) / dd, 0.0, 1.0) : 0.0;
  const Point3 rest = x - a - t * d;
  return Dot(rest, rest);
}

}

double SquaredDistanceToTriangle(const Point3& x, const std::array<Point3, 3>& corners)
{
  const auto& [a, b, c] = corners;
  const Point3 normal = Cross(b - a, c - a);
  const double nn = Dot(normal, normal);
  const bool flat = !(nn > 0.0);
  const bool ab = flat || Dot(Cross(b - a, x - a), normal) < 0.0;
  const bool bc = flat || Dot(Cross(c - b, x - b), normal) < 0.0;
  const bool ca = flat || Dot(Cross(a - c, x - c), normal) < 0.0;
  if (!ab && !bc && !ca)
  {
    const double height = Dot(normal, x - a);
    return height * height / nn;
  }
  // The nearest border point is on an edge that x is beyond.
  double nearest = std::numeric_limits<double>::infinity();
  nearest = ab ? std::min(nearest, SquaredDistanceToSegment(x, a, b)) : nearest;
  nearest = bc ? std::min(nearest, SquaredDistanceToSegment(x, b, c)) : nearest;
  return ca ? std::min(nearest, SquaredDistanceToSegment(x, c, a)) : nearest;
}

/// Sorts the triangles into leaves and makes the cylinders.
class TriangleTree::Builder
{
public:
  Builder(const SurfaceView& mesh, std::vector<Cylinder>& cylinders)
    : Mesh(mesh)
    , Cylinders(cylinders)
    , Order(static_cast<std::size_t>(mesh.NumberOfTriangles))
    , Centres(this->Order.size())
  {
    std::iota(this->Order.begin(), this->Order.end(), vtkIdType(0));
    for (const vtkIdType triangle : this->Order)
    {
      const auto corners = this->CornersOf(triangle);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        this->Centres[static_cast<std::size_t>(triangle)][axis] =
          static_cast<float>((corners[0][axis] + corners[1][axis] + corners[2][axis]) / 3.0);
      }
    }
  }

  std::array<Point3, 3> CornersOf(vtkIdType triangle) const
  {
    std::array<Point3, 3> corners;
    for (std::size_t c = 0; c < 3; ++c)
    {
      std::copy_n(this->Mesh.Point(this->Mesh.Triangle(triangle)[c]), 3, corners[c].begin());
    }
    return corners;
  }

  void Build()
  {
    struct Part
    {
      std::size_t Cylinder;
      std::int64_t First, Last;
    };
    this->Cylinders.resize(1);
    std::vector<Part> parts{ { 0, 0, this->Mesh.NumberOfTriangles } };
    while (!parts.empty())
    {
      const Part part = parts.back();
      parts.pop_back();
      TriangleTree::Cylinder cylinder = this->CylinderAround(part.First, part.Last);
      if (part.Last - part.First > TrianglesOfLeaf)
      {
        const std::int64_t middle = this->Halve(part.First, part.Last);
        const std::size_t left = this->Cylinders.size();
        cylinder.First = static_cast<std::int64_t>(left);
        cylinder.Count = 0;
        this->Cylinders.resize(left + 2);
        parts.push_back({ left, part.First, middle });
        parts.push_back({ left + 1, middle, part.Last });
      }
      this->Cylinders[part.Cylinder] = cylinder;
    }
  }

  const std::vector<vtkIdType>& Leaves() const { return this->Order; }

private:
  /// Calls body(corner) for the corners of the triangles [first, last) of the order.
  template <typename Body>
  void ForCorners(std::int64_t first, std::int64_t last, Body&& body) const
  {
    for (std::int64_t n = first; n < last; ++n)
    {
      const vtkIdType* const id = this->Mesh.Triangle(this->Order[static_cast<std::size_t>(n)]);
      for (int c = 0; c < 3; ++c)
      {
        body(Point3{
          this->Mesh.Point(id[c])[0], this->Mesh.Point(id[c])[1], this->Mesh.Point(id[c])[2] });
      }
    }
  }

  Point3 MeanNormal(std::int64_t first, std::int64_t last) const
  {
    Point3 sum{ 0.0, 0.0, 0.0 };
    for (std::int64_t n = first; n < last; ++n)
    {
      const auto [a, b, c] = this->CornersOf(this->Order[static_cast<std::size_t>(n)]);
      const Point3 normal = Cross(b - a, c - a);
      sum = { sum[0] + normal[0], sum[1] + normal[1], sum[2] + normal[2] };
    }
    const double length = Length(sum);
    return length > 0.0 ? Point3{ sum[0] / length, sum[1] / length, sum[2] / length }
                        : Point3{ 0.0, 0.0, 1.0 };
  }

  /// As a leaf.
  Cylinder CylinderAround(std::int64_t first, std::int64_t last) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Point3 low{ infinity, infinity, infinity }, high{ -infinity, -infinity, -infinity };
    this->ForCorners(first, last,
      [&](const Point3& corner)
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          low[axis] = std::min(low[axis], corner[axis]);
          high[axis] = std::max(high[axis], corner[axis]);
        }
      });
    Cylinder cylinder{ { (low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2 },
      this->MeanNormal(first, last), 0.0, 0.0, first, last - first };
    double bottom = infinity, top = -infinity, squaredRadius = 0.0;
    this->ForCorners(first, last,
      [&](const Point3& corner)
      {
        const Point3 r = corner - cylinder.Centre;
        const double height = Dot(r, cylinder.Axis);
        bottom = std::min(bottom, height);
        top = std::max(top, height);
        squaredRadius = std::max(squaredRadius, Dot(r, r) - height * height);
      });
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      cylinder.Centre[axis] += (bottom + top) / 2 * cylinder.Axis[axis];
    }
    // A little larger than measured, for the rounding of all this.
    const double slack = 1e-12 * (top - bottom + std::sqrt(squaredRadius));
    cylinder.HalfHeight = (top - bottom) / 2 + slack;
    cylinder.Radius = std::sqrt(squaredRadius) + slack;
    return cylinder;
  }

  std::int64_t Halve(std::int64_t first, std::int64_t last)
  {
    std::array<float, 3> low =
      this->Centres[static_cast<std::size_t>(this->Order[std::size_t(first)])];
    std::array<float, 3> high = low;
    for (std::int64_t n = first; n < last; ++n)
    {
      const auto& centre = this->Centres[static_cast<std::size_t>(this->Order[std::size_t(n)])];
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], centre[axis]);
        high[axis] = std::max(high[axis], centre[axis]);
      }
    }
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
    {
      longest = high[axis] - low[axis] > high[longest] - low[longest] ? axis : longest;
    }
    const std::int64_t middle = first + (last - first) / 2;
    std::nth_element(this->Order.begin() + first, this->Order.begin() + middle,
      this->Order.begin() + last,
      [this, longest](vtkIdType a, vtkIdType b)
      {
        return this->Centres[static_cast<std::size_t>(a)][longest] <
          this->Centres[static_cast<std::size_t>(b)][longest];
      });
    return middle;
  }

  const SurfaceView& Mesh;
  std::vector<Cylinder>& Cylinders;
  std::vector<vtkIdType> Order;
  std::vector<std::array<float, 3>> Centres;
};

TriangleTree::TriangleTree(const SurfaceView& mesh)
{
  if (mesh.NumberOfTriangles > 0)
  {
    Builder builder(mesh, this->Cylinders);
    builder.Build();
    for (const vtkIdType triangle : builder.Leaves())
    {
      this->Corners.push_back(builder.CornersOf(triangle));
    }
  }
}

double TriangleTree::SquaredDistance(const Cylinder& cylinder, const Point3& x)
{
  const Point3 r = x - cylinder.Centre;
  const double height = Dot(r, cylinder.Axis);
  const double across = std::sqrt(std::max(Dot(r, r) - height * height, 0.0));
  const double above = std::max(std::abs(height) - cylinder.HalfHeight, 0.0);
  const double beside = std::max(across - cylinder.Radius, 0.0);
  return above * above + beside * beside;
}

TriangleTree::Nearest TriangleTree::Find(const Point3& x, std::int64_t guess) const
{
  Nearest nearest{ std::numeric_limits<double>::infinity(), -1 };
  auto visit = [&](std::int64_t triangle)
  {
    const double squared =
      SquaredDistanceToTriangle(x, this->Corners[static_cast<std::size_t>(triangle)]);
    if (squared < nearest.Squared)
    {
      nearest = { squared, triangle };
    }
  };
  if (guess >= 0)
  {
    visit(guess);
  }
  struct Waiting
  {
    std::int64_t Cylinder;
    double Squared;
  };
  std::array<Waiting, DeepestStack> stack;
  std::size_t waiting = 0;
  if (!this->Cylinders.empty())
  {
    stack[waiting++] = { 0, 0.0 };
  }
  while (waiting > 0)
  {
    const Waiting next = stack[--waiting];
    if (next.Squared >= nearest.Squared)
    {
      continue;
    }
    const Cylinder& cylinder = this->Cylinders[static_cast<std::size_t>(next.Cylinder)];
    for (std::int64_t n = 0; n < cylinder.Count; ++n)
    {
      visit(cylinder.First + n);
    }
    if (cylinder.Count == 0)
    {
      Waiting children[2];
      for (std::int64_t side = 0; side < 2; ++side)
      {
        const auto child = static_cast<std::size_t>(cylinder.First + side);
        children[side] = { cylinder.First + side, SquaredDistance(this->Cylinders[child], x) };
      }
      const bool leftIsNear = children[0].Squared < children[1].Squared;
      stack[waiting++] = children[leftIsNear ? 1 : 0]; // the nearer one is taken first
      stack[waiting++] = children[leftIsNear ? 0 : 1];
    }
  }
  return nearest;
}

}
