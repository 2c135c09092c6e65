#include "TriangleTree.h"

#include "TriangleDistance.h"

#include <numeric>

namespace isthmus
{
namespace
{

constexpr std::size_t LeafSize = 4;

std::size_t At(std::int64_t i)
{
  return static_cast<std::size_t>(i);
}

double SquaredDistanceToBox(const Point3& p, const Bounds3& box)
{
  double squared = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double d = std::max({ box.Min[a] - p[a], p[a] - box.Max[a], 0.0 });
    squared += d * d;
  }
  return squared;
}

}

TriangleTree::TriangleTree(const TriangleMesh& mesh)
  : Mesh(mesh)
  , Order(mesh.Triangles.size())
{
  std::iota(this->Order.begin(), this->Order.end(), std::uint32_t{ 0 });
  std::vector<Point3> centres;
  centres.reserve(mesh.Triangles.size());
  for (const Triangle& t : mesh.Triangles)
  {
    const Point3 centre = mesh.Points[At(t[0])] + mesh.Points[At(t[1])] + mesh.Points[At(t[2])];
    const bool finite = std::isfinite(centre[0] + centre[1] + centre[2]);
    centres.push_back(finite ? centre : Point3{ 0, 0, 0 }); // what is sorted must have an order
  }
  this->Nodes.reserve(mesh.Triangles.size());
  this->Split(0, this->Order.size(), centres);
}

void TriangleTree::Split(std::size_t first, std::size_t last, const std::vector<Point3>& centres)
{
  Node node;
  node.First = static_cast<std::uint32_t>(first);
  for (std::size_t i = first; i < last; ++i)
  {
    for (const std::int64_t id : this->Mesh.Triangles[this->Order[i]])
    {
      const Point3& p = this->Mesh.Points[At(id)];
      if (i == first && id == this->Mesh.Triangles[this->Order[i]][0])
      {
        node.Box = { p, p };
      }
      node.Box.Add(p);
    }
  }
  const std::size_t own = this->Nodes.size();
  this->Nodes.push_back(node);
  if (last - first <= LeafSize)
  {
    this->Nodes[own].Count = static_cast<std::uint32_t>(last - first);
    return;
  }
  const Point3 size = node.Box.Max - node.Box.Min;
  const auto axis =
    static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  const std::size_t middle = first + (last - first) / 2;
  const auto at = [this](std::size_t i)
  { return this->Order.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last),
    [&centres, axis](std::uint32_t a, std::uint32_t b)
    { return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b; });
  this->Split(first, middle, centres);
  this->Nodes[own].Second = static_cast<std::uint32_t>(this->Nodes.size());
  this->Split(middle, last, centres);
}

double TriangleTree::ToTriangle(const Point3& p, std::uint32_t triangle) const
{
  const auto map = [](const Point3& q) { return Eigen::Map<const Eigen::Vector3d>(q.data()); };
  const Triangle& t = this->Mesh.Triangles[triangle];
  return SquaredDistanceToTriangle(map(p), map(this->Mesh.Points[At(t[0])]),
    map(this->Mesh.Points[At(t[1])]), map(this->Mesh.Points[At(t[2])]));
}

double TriangleTree::SquaredDistance(const Point3& p, double bound) const
{
  struct Entry
  {
    std::uint32_t Node;
    double Squared; ///< to its box
  };
  std::array<Entry, 128> stack; // the halves of 2^32 triangles are 30 levels deep
  std::size_t size = 0;
  if (!this->Order.empty())
  {
    stack[size++] = { 0, SquaredDistanceToBox(p, this->Nodes[0].Box) };
  }
  while (size > 0)
  {
    const Entry entry = stack[--size];
    if (entry.Squared >= bound)
    {
      continue;
    }
    const Node& node = this->Nodes[entry.Node];
    for (std::uint32_t i = node.First; i < node.First + node.Count; ++i)
    {
      bound = std::min(bound, this->ToTriangle(p, this->Order[i]));
    }
    if (node.Count == 0)
    {
      Entry near{ entry.Node + 1, SquaredDistanceToBox(p, this->Nodes[entry.Node + 1].Box) };
      Entry far{ node.Second, SquaredDistanceToBox(p, this->Nodes[node.Second].Box) };
      if (far.Squared < near.Squared)
      {
        std::swap(near, far);
      }
      stack[size++] = far;
      stack[size++] = near;
    }
  }
  return bound;
}

}
