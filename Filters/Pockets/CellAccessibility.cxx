#include "Pockets/CellAccessibility.h"

#include "Core/Index.h"
#include "Pockets/CellProgress.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace isthmus
{
namespace
{

template <std::size_t N>
double Clearance(
  const RegularFiltration& f, const std::array<SimplexId, N>& corners, double value, double probe)
{
  double largest = 0.0;
  for (const SimplexId p : corners)
  {
    largest = std::max(largest, f.Radii[At(p)]);
  }
  return std::sqrt(std::max(0.0, value + largest * largest)) - (largest - probe);
}

/// The order in which triangles enter, by (value, id), as in CellFiltration::Order().
using TriangleEntry = std::pair<double, TriangleId>;

/// A path that has reached `Cell` through `Triangle`.
struct WidestPath
{
  double Width;
  TriangleEntry Narrowest; ///< of its triangles, the one that enters first
  TetrahedronId Cell;
  TriangleId Triangle;

  /// The widest comes first, then the one whose triangles enter later, so that paths agree with the
  /// pairs of the filtration, then the lowest ids.
  bool operator<(const WidestPath& other) const
  {
    if (this->Width != other.Width)
    {
      return this->Width < other.Width;
    }
    if (this->Narrowest != other.Narrowest)
    {
      return this->Narrowest < other.Narrowest;
    }
    return this->Cell != other.Cell ? this->Cell > other.Cell : this->Triangle > other.Triangle;
  }
};

}

CellAccessibility MeasureClearance(const RegularFiltration& f, double probe)
{
  const CellFiltration& c = f.Complex;
  CellAccessibility access;
  access.CellClearance.resize(c.Tetrahedra.size());
  for (const TetrahedronId cell : c.Tetrahedra.Keys())
  {
    access.CellClearance[cell] = Clearance(f, c.Tetrahedra[cell], c.TetrahedronValue[cell], probe);
  }
  access.TriangleClearance.resize(c.TriangleCount());
  for (const TriangleId t : c.Triangles())
  {
    access.TriangleClearance[t] = Clearance(f, c.TrianglePoints(t), c.TriangleValue[t], probe);
  }
  access.Access.assign(c.Tetrahedra.size(), 0.0);
  return access;
}

CellAccessibility FindAccess(const RegularFiltration& f, const FacesByCell& faces, double probe,
  const ProgressCallback& progress)
{
  const CellFiltration& c = f.Complex;
  CellAccessibility access = MeasureClearance(f, probe);
  std::priority_queue<WidestPath> paths;
  for (const TriangleId t : c.Triangles())
  {
    // Triangles with only one side are the exits: paths start there.
    const auto sides = c.TriangleSides(t);
    if (!sides[0].Exists() || !sides[1].Exists())
    {
      paths.push({ access.TriangleClearance[t], { c.TriangleValue[t], t },
        std::max(sides[0], sides[1]), t });
    }
  }
  // A path that is not better than one that waits for the same tetrahedron need not wait.
  HandleVector<TetrahedronId, WidestPath> waiting(c.Tetrahedra.size());
  access.TowardsOutside.assign(c.Tetrahedra.size(), TriangleId::None());
  std::size_t reached = 0;
  while (!paths.empty())
  {
    const WidestPath path = paths.top();
    paths.pop();
    if (access.TowardsOutside[path.Cell].Exists())
    {
      continue;
    }
    access.TowardsOutside[path.Cell] = path.Triangle;
    ReportCells(progress, reached++, c.Tetrahedra.size());
    const double width = std::min(path.Width, access.CellClearance[path.Cell]);
    access.Access[path.Cell] = width;
    for (const TriangleId triangle : faces[path.Cell])
    {
      const TetrahedronId next = c.Across(triangle, path.Cell);
      if (next.Exists() && !access.TowardsOutside[next].Exists())
      {
        const WidestPath longer{ std::min(width, access.TriangleClearance[triangle]),
          std::min(path.Narrowest, TriangleEntry(c.TriangleValue[triangle], triangle)), next,
          triangle };
        if (!waiting[next].Cell.Exists() || waiting[next] < longer)
        {
          waiting[next] = longer;
          paths.push(longer);
        }
      }
    }
  }
  return access;
}

}
