#include "Surfaces/TriangleBoxTree.h"

#include "Core/Geometry.h"
#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Core/RadixSort.h"

#include <limits>
#include <utility>

namespace isthmus
{
namespace
{

constexpr std::int64_t TrianglesPerTask = 4096;

/// Triangles are sorted by the 33 leading bits of their places: 2048 cells per side distinguish
/// neighbours well enough.
constexpr unsigned int FirstPlaceBit = 30;

/// The lowest 21 bits of `x`, two zeros after each.
std::uint64_t Spread(std::uint64_t x)
{
  x = (x | x << 32) & 0x1F00000000FFFFULL;
  x = (x | x << 16) & 0x1F0000FF0000FFULL;
  x = (x | x << 8) & 0x100F00F00F00F00FULL;
  x = (x | x << 4) & 0x10C30C30C30C30C3ULL;
  return (x | x << 2) & 0x1249249249249249ULL;
}

/// Place of a point of `box` on the Morton curve through 2^21 cells per side.
std::uint64_t PlaceOnCurve(const Point3& p, const Bounds3& box, double width)
{
  std::uint64_t place = 0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double scaled = width > 0.0 ? (p[a] - box.Min[a]) / width * 2097151.0 : 0.0;
    place |= Spread(static_cast<std::uint64_t>(std::clamp(scaled, 0.0, 2097151.0))) << a;
  }
  return place;
}

Bounds3 ComputeBounds(const SurfaceView& mesh, const Triangle& t)
{
  Bounds3 box{ mesh.Points[At(t[0])], mesh.Points[At(t[0])] };
  box.Add(mesh.Points[At(t[1])]);
  box.Add(mesh.Points[At(t[2])]);
  return box;
}

}

TriangleBoxTree::TriangleBoxTree(const SurfaceView& mesh)
  : Order(mesh.Triangles.size())
{
  if (mesh.Triangles.empty())
  {
    return;
  }
  this->MakeBoxes(mesh);
  this->MakeNodes();
}

void TriangleBoxTree::MakeBoxes(const SurfaceView& mesh)
{
  Bounds3 all = ComputeBounds(mesh, mesh.Triangles.front());
  for (const Triangle& t : mesh.Triangles)
  {
    for (const std::int64_t p : t)
    {
      all.Add(mesh.Points[At(p)]);
    }
  }
  const Point3 extent = all.Max - all.Min;
  const double width = std::max({ extent[0], extent[1], extent[2] });
  const auto count = static_cast<std::int64_t>(mesh.Triangles.size());
  std::vector<std::pair<std::uint64_t, std::int64_t>> places(mesh.Triangles.size());
  ParallelFor(0, count, TrianglesPerTask,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t t = begin; t < end; ++t)
      {
        const Bounds3 box = ComputeBounds(mesh, mesh.Triangles[At(t)]);
        places[At(t)] = { PlaceOnCurve(0.5 * (box.Min + box.Max), all, width), t };
      }
    });
  RadixSort(places, FirstPlaceBit, 63, [](const auto& place) { return place.first; });
  this->Boxes.resize(places.size());
  const Point3 middle = 0.5 * (all.Min + all.Max);
  ParallelFor(0, count, TrianglesPerTask,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        this->Order[At(i)] = places[At(i)].second;
        const Bounds3 box = ComputeBounds(mesh, mesh.Triangles[At(places[At(i)].second)]);
        for (std::size_t a = 0; a < 3; ++a)
        {
          // Both roundings keep the order of coordinates: boxes that overlap still do.
          this->Boxes[At(i)].Min[a] = static_cast<float>(box.Min[a] - middle[a]);
          this->Boxes[At(i)].Max[a] = static_cast<float>(box.Max[a] - middle[a]);
        }
      }
    });
}

void TriangleBoxTree::MakeNodes()
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const Box none{ { infinity, infinity, infinity }, { -infinity, -infinity, -infinity } };
  const auto grow = [](Box& box, const Box& other)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      box.Min[a] = std::min(box.Min[a], other.Min[a]);
      box.Max[a] = std::max(box.Max[a], other.Max[a]);
    }
  };
  const std::size_t leaves = (this->Boxes.size() + TrianglesOfLeaf - 1) / TrianglesOfLeaf;
  while (this->FirstLeaf < leaves)
  {
    this->FirstLeaf *= 2;
    ++this->Height;
  }
  this->HeightAboveGroups = this->Height - std::min(this->Height, HeightOfGroup);
  const unsigned int height = this->Height - this->HeightAboveGroups;
  this->NumberOfGroups = static_cast<std::int64_t>((leaves - 1) >> height) + 1;
  this->Nodes.assign(2 * this->FirstLeaf, none);
  for (std::size_t i = 0; i < this->Boxes.size(); ++i)
  {
    grow(this->Nodes[this->FirstLeaf + i / TrianglesOfLeaf], this->Boxes[i]);
  }
  for (std::size_t k = this->FirstLeaf; k-- > 1;)
  {
    grow(this->Nodes[k], this->Nodes[2 * k]);
    grow(this->Nodes[k], this->Nodes[2 * k + 1]);
  }
}

}
