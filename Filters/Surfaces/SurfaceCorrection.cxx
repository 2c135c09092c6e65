#include "Surfaces/SurfaceCorrection.h"

#include "Core/DisjointSets.h"
#include "Core/Geometry.h"
#include "Core/Index.h"
#include "Core/RangeChecks.h"
#include "Surfaces/MeshEdges.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"
#include "Surfaces/TriangleTree.h"
#include "Surfaces/WindingNumber.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

namespace isthmus
{
namespace
{

std::vector<Triangle> GetCorners(const SurfaceView& surface)
{
  return { surface.Triangles.begin(), surface.Triangles.end() };
}

double ComputeArea(const SurfaceView& surface, const Triangle& t)
{
  const Point3& a = surface.Point(t[0]);
  return 0.5 * Length(Cross(surface.Point(t[1]) - a, surface.Point(t[2]) - a));
}

// ------------------------------------------------------------------------------------------
// Cracks

/// Points of edges with one triangle, ascending, and the median length of such edges.
struct OpenEdges
{
  std::vector<vtkIdType> Points;
  double MedianLength = 0.0;
};

OpenEdges FindOpenEdges(const SurfaceView& surface)
{
  OpenEdges open;
  std::vector<double> lengths;
  ForEachEdge(SortedHalfEdges(surface, {}),
    [&](auto first, auto last)
    {
      if (last - first == 1 && first->Low != first->High)
      {
        open.Points.push_back(first->Low);
        open.Points.push_back(first->High);
        lengths.push_back(Distance(surface.Point(first->Low), surface.Point(first->High)));
      }
    });
  std::sort(open.Points.begin(), open.Points.end());
  open.Points.erase(std::unique(open.Points.begin(), open.Points.end()), open.Points.end());
  if (!lengths.empty())
  {
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    open.MedianLength = *middle;
  }
  return open;
}

double BoundsDiagonal(const SurfaceView& surface)
{
  Bounds3 box{ surface.Point(surface.Corners(0)[0]), surface.Point(surface.Corners(0)[0]) };
  for (const Triangle& t : surface.Triangles)
  {
    for (const vtkIdType p : t)
    {
      box.Add(surface.Point(p));
    }
  }
  return box.Diagonal();
}

/// For each point the one that represents it: `points` nearer than `tolerance` are joined.
std::vector<vtkIdType> JoinNear(
  const SurfaceView& surface, const std::vector<vtkIdType>& points, double tolerance)
{
  using Cell = std::array<std::int64_t, 3>;
  const Point3& origin = surface.Point(points.front());
  const auto cellOf = [&](vtkIdType p)
  {
    Cell cell{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      cell[axis] =
        static_cast<std::int64_t>(std::floor((surface.Point(p)[axis] - origin[axis]) / tolerance));
    }
    return cell;
  };
  std::map<Cell, std::vector<std::size_t>> cells;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    cells[cellOf(points[i])].push_back(i);
  }
  DisjointSets<std::int64_t> sets(points.size());
  for (const auto& [cell, members] : cells)
  {
    for (int n = 0; n < 27; ++n)
    {
      const auto found =
        cells.find({ cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1 });
      for (std::size_t k = 0; found != cells.end() && k < found->second.size(); ++k)
      {
        const std::size_t j = found->second[k];
        for (const std::size_t i : members)
        {
          if (i < j && Distance(surface.Point(points[i]), surface.Point(points[j])) <= tolerance)
          {
            sets.Join(static_cast<std::int64_t>(i), static_cast<std::int64_t>(j));
          }
        }
      }
    }
  }
  std::vector<vtkIdType> stands(surface.Points.size());
  std::iota(stands.begin(), stands.end(), vtkIdType{ 0 });
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    stands[At(points[i])] = points[At(sets.Find(static_cast<std::int64_t>(i)))];
  }
  return stands;
}

std::vector<Triangle> ReplacePoints(
  const SurfaceView& surface, const std::vector<vtkIdType>& stands, std::int64_t& joined)
{
  joined = 0;
  for (std::size_t i = 0; i < stands.size(); ++i)
  {
    joined += At(stands[i]) != i ? 1 : 0;
  }
  std::vector<Triangle> triangles;
  triangles.reserve(surface.Triangles.size());
  for (const Triangle& before : surface.Triangles)
  {
    const Triangle after{ stands[At(before[0])], stands[At(before[1])], stands[At(before[2])] };
    if (HasRepeated(before) || !HasRepeated(after))
    {
      triangles.push_back(after);
    }
  }
  return triangles;
}

}

std::vector<Triangle> JoinCracks(const SurfaceView& surface, SurfaceCorrection& done)
{
  std::vector<Triangle> best = GetCorners(surface);
  if (best.empty())
  {
    return best;
  }
  const OpenEdges open = FindOpenEdges(surface);
  const double diagonal = open.Points.empty() ? 0.0 : BoundsDiagonal(surface);
  if (!(diagonal > 0.0))
  {
    return best;
  }
  const SurfaceDefects before = FindDefects(surface);
  std::size_t fewest = before.BoundaryTriangles.size();
  std::int64_t last = 0;
  for (const double share : { 1e-7, 1e-6, 1e-5, 1e-4 })
  {
    const double tolerance = share * diagonal;
    if (fewest == 0 || tolerance > 0.1 * open.MedianLength)
    {
      break;
    }
    std::int64_t joined = 0;
    std::vector<Triangle> tried =
      ReplacePoints(surface, JoinNear(surface, open.Points, tolerance), joined);
    if (joined == last)
    {
      continue;
    }
    last = joined;
    const SurfaceDefects after = FindDefects({ surface.Points, tried });
    if (after.BoundaryTriangles.size() < fewest &&
      after.NonManifoldTriangles.size() <= before.NonManifoldTriangles.size())
    {
      fewest = after.BoundaryTriangles.size();
      best = std::move(tried);
      done.Joined = joined;
      done.Tolerance = tolerance;
      done.Share = share;
    }
  }
  return best;
}

// ------------------------------------------------------------------------------------------
// Patches
namespace
{

/// A neighbour across an edge of two triangles, and whether it runs along the edge the same way.
struct Neighbour
{
  vtkIdType Triangle;
  bool SameWay;
};

std::vector<std::vector<Neighbour>> FindNeighbours(const SurfaceView& surface)
{
  std::vector<std::vector<Neighbour>> neighbours(surface.Triangles.size());
  ForEachEdge(SortedHalfEdges(surface, {}),
    [&](auto first, auto last)
    {
      if (last - first == 2 && first->Triangle != (first + 1)->Triangle)
      {
        const bool same = first->Ascending == (first + 1)->Ascending;
        neighbours[At(first->Triangle)].push_back({ (first + 1)->Triangle, same });
        neighbours[At((first + 1)->Triangle)].push_back({ first->Triangle, same });
      }
    });
  return neighbours;
}

}

std::vector<Triangle> OrientAlike(const SurfaceView& surface, SurfaceCorrection& done)
{
  std::vector<Triangle> triangles = GetCorners(surface);
  const auto neighbours = FindNeighbours(surface);
  std::vector<int> way(triangles.size(), 0); // 1 unchanged, -1 flipped, 0 not visited
  std::vector<vtkIdType> component;
  for (std::size_t start = 0; start < triangles.size(); ++start)
  {
    if (way[start] != 0)
    {
      continue;
    }
    component.assign(1, static_cast<vtkIdType>(start));
    way[start] = 1;
    bool consistent = true;
    double area[2] = { 0.0, 0.0 }; // flipped, unchanged
    for (std::size_t next = 0; next < component.size(); ++next)
    {
      const vtkIdType t = component[next];
      area[way[At(t)] > 0 ? 1 : 0] += ComputeArea(surface, triangles[At(t)]);
      for (const Neighbour& other : neighbours[At(t)])
      {
        const int right = other.SameWay ? -way[At(t)] : way[At(t)];
        consistent = consistent && way[At(other.Triangle)] != -right;
        if (way[At(other.Triangle)] == 0)
        {
          way[At(other.Triangle)] = right;
          component.push_back(other.Triangle);
        }
      }
    }
    const int turned = area[0] > area[1] ? 1 : -1;
    for (const vtkIdType t : component)
    {
      if (consistent && way[At(t)] == turned)
      {
        std::swap(triangles[At(t)][1], triangles[At(t)][2]);
        ++done.Turned;
      }
    }
  }
  return triangles;
}

// ------------------------------------------------------------------------------------------
// Shells
namespace
{

/// Only the largest shells are tested as containers of others; testing all pairs of small ones
/// would take too long.
constexpr std::size_t MostParents = 1000;

struct Shell
{
  std::vector<Triangle> Triangles;
  std::vector<std::size_t> Ids;
  Bounds3 Box{ { 0, 0, 0 }, { 0, 0, 0 } };
  double Volume = 0.0;
  bool IsClosed = true;
  int Parent = -1;
  std::unique_ptr<WindingNumber> Winding; ///< these two are created on first use
  std::unique_ptr<TriangleTree> Tree;
};

std::vector<Shell> FindShells(const SurfaceView& surface)
{
  const std::vector<int> component = Components(surface);
  std::vector<Shell> shells(component.empty()
      ? 0
      : static_cast<std::size_t>(*std::max_element(component.begin(), component.end())) + 1);
  for (std::size_t t = 0; t < component.size(); ++t)
  {
    Shell& shell = shells[static_cast<std::size_t>(component[t])];
    const Triangle& corners = surface.Triangles[t];
    if (shell.Triangles.empty())
    {
      shell.Box = { surface.Point(corners[0]), surface.Point(corners[0]) };
    }
    for (const vtkIdType p : corners)
    {
      shell.Box.Add(surface.Point(p));
    }
    shell.Triangles.push_back(corners);
    shell.Ids.push_back(t);
  }
  ForEachEdge(SortedHalfEdges(surface, {}),
    [&](auto first, auto last)
    {
      const bool closed = last - first == 2 && first->Ascending != (first + 1)->Ascending;
      Shell& shell = shells[static_cast<std::size_t>(component[At(first->Triangle)])];
      shell.IsClosed = shell.IsClosed && closed;
    });
  for (Shell& shell : shells)
  {
    shell.Volume = SignedVolume({ surface.Points, shell.Triangles });
  }
  return shells;
}

/// Whether several points of `inner`, from all over it, are all inside `outer`. Points on `outer`,
/// where two shells touch, are left out.
bool IsInside(const SurfaceView& surface, const Shell& inner, Shell& outer)
{
  if (!outer.Box.Contains(inner.Box))
  {
    return false;
  }
  if (!outer.Winding)
  {
    const SurfaceView view(surface.Points, outer.Triangles);
    outer.Winding = std::make_unique<WindingNumber>(view);
    outer.Tree = std::make_unique<TriangleTree>(view);
  }
  constexpr double touchingPart = 1e-7; // of the diagonal, as in ShellCrossings.cxx
  const double touch = touchingPart * outer.Box.Diagonal();
  constexpr std::size_t mostAsked = 16;
  std::size_t step = std::max<std::size_t>(inner.Triangles.size() / mostAsked, 1);
  bool known = false;
  while (true)
  {
    for (std::size_t t = 0; t < inner.Triangles.size(); t += step)
    {
      const Triangle& corners = inner.Triangles[t];
      const Point3& corner = surface.Point(corners[0]);
      const Point3 middle =
        (1.0 / 3.0) * (corner + surface.Point(corners[1]) + surface.Point(corners[2]));
      for (const Point3& x : { corner, middle })
      {
        if (outer.Tree->Find(x, -1).Squared <= touch * touch)
        {
          continue;
        }
        if (std::abs((*outer.Winding)(x)) < 0.5)
        {
          return false;
        }
        known = true;
      }
    }
    if (known || step == 1)
    {
      return known;
    }
    step = 1;
  }
}

/// `outward`: whether to orient the outermost shells outward even if all of them face inward.
std::vector<Triangle> OrientNested(
  const SurfaceView& surface, bool outward, SurfaceCorrection& done)
{
  std::vector<Triangle> triangles = GetCorners(surface);
  std::vector<Shell> shells = FindShells(surface);
  if (shells.size() < 2 && !outward)
  {
    return triangles;
  }
  // Large ones first: a shell comes after those that it is in, and the last of them is its parent.
  std::vector<std::size_t> order(shells.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&shells](std::size_t a, std::size_t b)
    { return std::abs(shells[a].Volume) > std::abs(shells[b].Volume); });
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    Shell& shell = shells[order[i]];
    for (std::size_t j = std::min(i, MostParents); shell.IsClosed && shell.Parent < 0 && j-- > 0;)
    {
      Shell& outer = shells[order[j]];
      if (outer.IsClosed && IsInside(surface, shell, outer))
      {
        shell.Parent = static_cast<int>(order[j]);
      }
    }
    outward = outward || (shell.IsClosed && shell.Parent < 0 && shell.Volume > 0.0);
  }
  std::vector<bool> faces(shells.size(), false); // outward, finally
  for (const std::size_t s : order)
  {
    const Shell& shell = shells[s];
    if (!shell.IsClosed || shell.Volume == 0.0)
    {
      continue;
    }
    faces[s] = shell.Parent < 0 ? outward : !faces[static_cast<std::size_t>(shell.Parent)];
    if (faces[s] == (shell.Volume > 0.0))
    {
      continue;
    }
    ++done.Shells;
    for (const std::size_t t : shell.Ids)
    {
      std::swap(triangles[t][1], triangles[t][2]);
    }
  }
  return triangles;
}

}

std::vector<Triangle> OrientShells(const SurfaceView& surface, SurfaceCorrection& done)
{
  return OrientNested(surface, false, done);
}

std::vector<Triangle> OrientOutward(const SurfaceView& surface)
{
  SurfaceCorrection done;
  return OrientNested(surface, true, done);
}

std::string SurfaceCorrection::Message() const
{
  std::string text;
  const auto add = [&text](const std::string& sentence)
  { text += (text.empty() ? "" : " ") + sentence; };
  if (this->Joined > 0)
  {
    add(std::to_string(this->Joined) + " points at open edges were merged with others within " +
      FormatNumber(this->Tolerance) + " (" + FormatNumber(this->Share) +
      " of the diagonal of the surface): the facets had cracks between them.");
  }
  if (this->Turned > 0)
  {
    add(std::to_string(this->Turned) + " triangles were flipped to match their neighbours.");
  }
  if (this->Shells > 0)
  {
    add(std::to_string(this->Shells) +
      (this->Shells == 1 ? " closed shell was" : " closed shells were") +
      " turned inside out, so that cavities count against the volume around them.");
  }
  return text;
}

}
