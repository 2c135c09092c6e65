#include "Surfaces/TriangleTreeNodes.h"

#include "Core/Geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace isthmus
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

using Node = TriangleTreeNodes::Node;
using Leaf = TriangleTreeNodes::Leaf;
constexpr std::size_t Width = TriangleTreeNodes::Width;

class Builder
{
public:
  explicit Builder(const SurfaceView& mesh);

  TriangleTreeNodes Build();

private:
  struct Part
  {
    std::int64_t First, Last; ///< of the order, without the last
    std::int64_t Count() const { return this->Last - this->First; }
  };

  struct Waiting
  {
    std::size_t Node;
    Part Triangles;
  };

  /// A bound of many triangles.
  struct Cylinder
  {
    Point3 Center, Axis;
    double HalfHeight, Radius;
  };

  struct Box
  {
    Point3 Low, High;
  };

  void Place();

  /// An empty node that is to be filled, or a leaf with all of the part.
  std::int32_t BuildChild(const Part& part);

  void FillNode(const Waiting& task, std::vector<Waiting>& waiting);

  /// Up to eight parts of one, each halved up to three times.
  std::size_t Divide(const Part& whole, std::array<Part, Width>& parts);

  /// The middle, with a whole number of leaves before it, so that only the last leaf is not full.
  std::int64_t Halve(std::int64_t first, std::int64_t last);

  std::array<Point3, 3> GetCorners(vtkIdType triangle) const;

  /// Calls body(corner) for the corners of the triangles [first, last) of the order.
  template <typename Body>
  void ForEachCorner(std::int64_t first, std::int64_t last, Body&& body) const;

  Point3 MeanNormal(std::int64_t first, std::int64_t last) const;
  Box BoxAround(std::int64_t first, std::int64_t last) const;
  Cylinder CylinderAround(std::int64_t first, std::int64_t last) const;

  SurfaceView Mesh;
  TriangleTreeNodes Tree;
  std::vector<vtkIdType> Order;
  std::vector<std::array<float, 3>> Centers;
};

Builder::Builder(const SurfaceView& mesh)
  : Mesh(mesh)
  , Order(mesh.Triangles.size())
  , Centers(this->Order.size())
{
  std::iota(this->Order.begin(), this->Order.end(), vtkIdType(0));
  for (const vtkIdType triangle : this->Order)
  {
    const auto corners = this->GetCorners(triangle);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Centers[static_cast<std::size_t>(triangle)][axis] =
        static_cast<float>((corners[0][axis] + corners[1][axis] + corners[2][axis]) / 3.0);
    }
  }
}

TriangleTreeNodes Builder::Build()
{
  this->Place();
  this->Tree.Leaves.reserve(this->Order.size() / Width + 1);
  this->BuildChild({ 0, this->Mesh.NumberOfTriangles() });
  std::vector<Waiting> waiting{ { 0, { 0, this->Mesh.NumberOfTriangles() } } };
  while (!this->Tree.Nodes.empty() && !waiting.empty())
  {
    const Waiting next = waiting.back();
    waiting.pop_back();
    this->FillNode(next, waiting);
  }
  return std::move(this->Tree);
}

/// Centers of cylinders come from boxes of corners, pushed along an axis by less than their size.
void Builder::Place()
{
  const Box box = this->BoxAround(0, this->Mesh.NumberOfTriangles());
  double size = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Tree.Origin[axis] = (box.Low[axis] + box.High[axis]) / 2;
    size += box.High[axis] - box.Low[axis];
  }
  this->Tree.Scale = size > 0.0 ? size : 1.0;
}

std::int32_t Builder::BuildChild(const Part& part)
{
  if (part.Count() > static_cast<std::int64_t>(Width))
  {
    this->Tree.Nodes.emplace_back();
    return static_cast<std::int32_t>(this->Tree.Nodes.size() - 1);
  }
  Leaf leaf;
  for (std::size_t lane = 0; lane < Width; ++lane)
  {
    const auto at = std::min(part.First + static_cast<std::int64_t>(lane), part.Last - 1);
    const auto corners = this->GetCorners(this->Order[static_cast<std::size_t>(at)]);
    for (std::size_t c = 0; c < 3; ++c)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        leaf.Corner[c][axis][lane] = corners[c][axis];
      }
    }
  }
  this->Tree.Leaves.push_back(leaf);
  return ~static_cast<std::int32_t>(this->Tree.Leaves.size() - 1);
}

std::size_t Builder::Divide(const Part& whole, std::array<Part, Width>& parts)
{
  parts[0] = whole;
  std::size_t count = 1;
  for (int level = 0; level < 3; ++level)
  {
    for (std::size_t p = count; p-- > 0;)
    {
      if (parts[p].Count() > static_cast<std::int64_t>(Width))
      {
        const std::int64_t middle = this->Halve(parts[p].First, parts[p].Last);
        parts[count++] = { middle, parts[p].Last };
        parts[p].Last = middle;
      }
    }
  }
  return count;
}

void Builder::FillNode(const Waiting& task, std::vector<Waiting>& waiting)
{
  std::array<Part, Width> parts;
  const std::size_t count = this->Divide(task.Triangles, parts);
  Node node;
  for (std::size_t lane = 0; lane < Width; ++lane)
  {
    const bool there = lane < count;
    const Cylinder cylinder = there
      ? this->CylinderAround(parts[lane].First, parts[lane].Last)
      : Cylinder{ { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, -Infinity, 0.0 };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      node.Center[axis][lane] = static_cast<float>(
        there ? (cylinder.Center[axis] - this->Tree.Origin[axis]) / this->Tree.Scale : 0.0);
      node.Axis[axis][lane] = static_cast<float>(cylinder.Axis[axis]);
    }
    constexpr double up = 1.0 + 0x1p-22;
    node.HalfHeight[lane] = static_cast<float>(cylinder.HalfHeight / this->Tree.Scale * up);
    node.Radius[lane] = static_cast<float>(cylinder.Radius / this->Tree.Scale * up);
    node.Child[lane] = there ? this->BuildChild(parts[lane]) : 0;
    if (there && node.Child[lane] >= 0)
    {
      waiting.push_back({ static_cast<std::size_t>(node.Child[lane]), parts[lane] });
    }
  }
  this->Tree.Nodes[task.Node] = node;
}

std::array<Point3, 3> Builder::GetCorners(vtkIdType triangle) const
{
  const Triangle& id = this->Mesh.Corners(triangle);
  return { this->Mesh.Point(id[0]), this->Mesh.Point(id[1]), this->Mesh.Point(id[2]) };
}

template <typename Body>
void Builder::ForEachCorner(std::int64_t first, std::int64_t last, Body&& body) const
{
  for (std::int64_t n = first; n < last; ++n)
  {
    const Triangle& id = this->Mesh.Corners(this->Order[static_cast<std::size_t>(n)]);
    for (const vtkIdType point : id)
    {
      body(this->Mesh.Point(point));
    }
  }
}

Point3 Builder::MeanNormal(std::int64_t first, std::int64_t last) const
{
  Point3 sum{ 0.0, 0.0, 0.0 };
  for (std::int64_t n = first; n < last; ++n)
  {
    const auto [a, b, c] = this->GetCorners(this->Order[static_cast<std::size_t>(n)]);
    const Point3 normal = Cross(b - a, c - a);
    sum = { sum[0] + normal[0], sum[1] + normal[1], sum[2] + normal[2] };
  }
  const double length = Length(sum);
  return length > 0.0 ? Point3{ sum[0] / length, sum[1] / length, sum[2] / length }
                      : Point3{ 0.0, 0.0, 1.0 };
}

Builder::Box Builder::BoxAround(std::int64_t first, std::int64_t last) const
{
  Box box{ { Infinity, Infinity, Infinity }, { -Infinity, -Infinity, -Infinity } };
  this->ForEachCorner(first, last,
    [&](const Point3& corner)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        box.Low[axis] = std::min(box.Low[axis], corner[axis]);
        box.High[axis] = std::max(box.High[axis], corner[axis]);
      }
    });
  return box;
}

Builder::Cylinder Builder::CylinderAround(std::int64_t first, std::int64_t last) const
{
  const auto [low, high] = this->BoxAround(first, last);
  Cylinder cylinder{ { (low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2 },
    this->MeanNormal(first, last), 0.0, 0.0 };
  double bottom = Infinity, top = -Infinity, squaredRadius = 0.0;
  this->ForEachCorner(first, last,
    [&](const Point3& corner)
    {
      const Point3 r = corner - cylinder.Center;
      const double height = Dot(r, cylinder.Axis);
      bottom = std::min(bottom, height);
      top = std::max(top, height);
      squaredRadius = std::max(squaredRadius, Dot(r, r) - height * height);
    });
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    cylinder.Center[axis] += (bottom + top) / 2 * cylinder.Axis[axis];
  }
  // A little larger than measured, for the rounding of all this.
  const double slack = 1e-12 * (top - bottom + std::sqrt(squaredRadius));
  cylinder.HalfHeight = (top - bottom) / 2 + slack;
  cylinder.Radius = std::sqrt(squaredRadius) + slack;
  return cylinder;
}

std::int64_t Builder::Halve(std::int64_t first, std::int64_t last)
{
  std::array<float, 3> low =
    this->Centers[static_cast<std::size_t>(this->Order[std::size_t(first)])];
  std::array<float, 3> high = low;
  for (std::int64_t n = first; n < last; ++n)
  {
    const auto& center = this->Centers[static_cast<std::size_t>(this->Order[std::size_t(n)])];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], center[axis]);
      high[axis] = std::max(high[axis], center[axis]);
    }
  }
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
  {
    longest = high[axis] - low[axis] > high[longest] - low[longest] ? axis : longest;
  }
  constexpr auto width = static_cast<std::int64_t>(Width);
  const std::int64_t middle = first + ((last - first) / 2 + width - 1) / width * width;
  std::nth_element(this->Order.begin() + first, this->Order.begin() + middle,
    this->Order.begin() + last,
    [this, longest](vtkIdType a, vtkIdType b)
    {
      return this->Centers[static_cast<std::size_t>(a)][longest] <
        this->Centers[static_cast<std::size_t>(b)][longest];
    });
  return middle;
}

}

TriangleTreeNodes MakeTriangleNodes(const SurfaceView& mesh)
{
  return mesh.NumberOfTriangles() > 0 ? Builder(mesh).Build() : TriangleTreeNodes{};
}

}
