#include "Surfaces/ShellCrossings.h"

#include "Core/DisjointSets.h"
#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Surfaces/MeshEdges.h"
#include "Surfaces/ShellNesting.h"
#include "Surfaces/SurfaceCleaning.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"
#include "Surfaces/TriangleBoxTree.h"
#include "Surfaces/TriangleTree.h"
#include "Surfaces/WindingNumber.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace isthmus
{
namespace
{

/// An overlap below this fraction of the surface's diagonal is a contact, not a crossing.
constexpr double TouchingPart = 1e-10;
/// The same for a component with itself: single precision moves points by less.
constexpr double SelfTouchingPart = 1e-6;
/// How many points of a shell are tested, apart from those where it touches another.
constexpr std::size_t SpreadSamples = 200;

using Corners3 = std::array<Point3, 3>;

/// Signed distance of a point from the plane of a triangle; nothing for one without area.
std::optional<std::array<double, 3>> HeightsAbove(const Corners3& plane, const Corners3& points)
{
  const Point3 n = Cross(plane[1] - plane[0], plane[2] - plane[0]);
  const double length = Length(n);
  if (!(length > 0.0))
  {
    return {};
  }
  std::array<double, 3> heights;
  for (std::size_t c = 0; c < 3; ++c)
  {
    heights[c] = Dot(n, points[c] - plane[0]) / length;
  }
  return heights;
}

bool IsClear(const std::array<double, 3>& heights, double touch)
{
  return std::all_of(heights.begin(), heights.end(), [=](double h) { return h > touch; }) ||
    std::all_of(heights.begin(), heights.end(), [=](double h) { return h < -touch; });
}

/// Whether a point in the plane of a triangle is inside it by more than `touch`.
bool IsWellInside(const Corners3& t, const Point3& x, double touch)
{
  const Point3 n = Cross(t[1] - t[0], t[2] - t[0]);
  const double length = Length(n);
  for (std::size_t c = 0; c < 3; ++c)
  {
    const Point3 side = t[(c + 1) % 3] - t[c];
    const double scale = length * Length(side);
    if (!(Dot(n, Cross(side, x - t[c])) > touch * scale))
    {
      return false;
    }
  }
  return true;
}

struct TrianglePair
{
  bool Touch = false;
  std::optional<Point3> Place; ///< where an edge of one passes the other
};

TrianglePair Compare(const Corners3& a, const Corners3& b, double touch)
{
  TrianglePair pair;
  const std::array<Corners3, 2> both{ a, b };
  for (std::size_t i = 0; i < 2; ++i)
  {
    const Corners3& plane = both[i];
    const Corners3& other = both[1 - i];
    const auto heights = HeightsAbove(plane, other);
    if (!heights)
    {
      continue;
    }
    if (IsClear(*heights, touch))
    {
      return {};
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double from = (*heights)[c], to = (*heights)[(c + 1) % 3];
      if (std::min(from, to) < -touch && std::max(from, to) > touch)
      {
        const Point3 x = other[c] + (from / (from - to)) * (other[(c + 1) % 3] - other[c]);
        if (IsWellInside(plane, x, touch))
        {
          pair.Place = x;
          return pair;
        }
      }
    }
  }
  pair.Touch = true;
  return pair;
}

/// The closed shells of a surface, and the search for two that cross.
class ShellPairs
{
public:
  explicit ShellPairs(const SurfaceView& mesh)
    : Corners(MergedCorners(mesh))
  {
    this->Corners.erase(
      std::remove_if(this->Corners.begin(), this->Corners.end(), HasRepeated), this->Corners.end());
    this->Mesh = SurfaceView(mesh.Points, this->Corners);
    if (!this->Corners.empty())
    {
      this->SplitShells();
    }
  }

  std::optional<ShellCrossing> Find(const ProgressCallback& progress)
  {
    if (const auto twice = this->FindDoubledTriangle())
    {
      return twice;
    }
    if (this->Shells.size() < 2)
    {
      return {};
    }
    this->Touch = TouchingPart * ComputeBounds(this->Mesh).Diagonal();
    if (const auto crossing = this->FindCrossingTriangles(progress))
    {
      return crossing;
    }
    for (const auto& [shells, triangles] : this->Touching)
    {
      Report(progress, 0.9);
      if (const auto crossing = this->FindByWinding(shells.first, shells.second, triangles))
      {
        return crossing;
      }
    }
    return {};
  }

private:
  struct Shell
  {
    std::vector<Triangle> Triangles;
    std::unique_ptr<WindingNumber> Winding; ///< these two are created on first use
    std::unique_ptr<TriangleTree> Tree;
  };

  /// On which side of another shell the samples of a shell lie.
  struct Sides
  {
    bool In = false, Out = false, On = false;
  };

  using ShellIds = std::pair<int, int>;
  using TriangleIds = std::pair<std::int64_t, std::int64_t>;

  void SplitShells()
  {
    std::vector<int> component = Components(this->Mesh);
    const int count = *std::max_element(component.begin(), component.end()) + 1;
    std::vector<bool> closed(static_cast<std::size_t>(count), true);
    ForEachEdge(SortedHalfEdges(this->Mesh, {}),
      [&](auto first, auto last)
      {
        if ((last - first) % 2 != 0)
        {
          closed[static_cast<std::size_t>(component[At(first->Triangle)])] = false;
        }
      });
    std::vector<int> number(closed.size(), -1);
    this->ShellOf.resize(component.size());
    for (std::size_t t = 0; t < component.size(); ++t)
    {
      const auto c = static_cast<std::size_t>(component[t]);
      if (closed[c])
      {
        if (number[c] < 0)
        {
          number[c] = static_cast<int>(this->Shells.size());
          this->Shells.emplace_back();
        }
        this->Shells[static_cast<std::size_t>(number[c])].Triangles.push_back(this->Corners[t]);
      }
      this->ShellOf[t] = number[c];
    }
  }

  /// Coinciding shells have the same points once these are merged, so they are one component.
  std::optional<ShellCrossing> FindDoubledTriangle() const
  {
    std::vector<Triangle> sorted;
    for (const Shell& shell : this->Shells)
    {
      sorted.insert(sorted.end(), shell.Triangles.begin(), shell.Triangles.end());
    }
    for (Triangle& t : sorted) // the least first, in the same sense
    {
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    }
    std::sort(sorted.begin(), sorted.end());
    const auto same = std::adjacent_find(sorted.begin(), sorted.end());
    if (same != sorted.end())
    {
      return ShellCrossing{ Middle(this->Place(*same)), true };
    }
    return this->FindReversedDouble();
  }

  /// A shell and the same one inside out. Single triangles that face each other are those of bodies
  /// that touch, and sheets with two sides have no inside: neither is one.
  std::optional<ShellCrossing> FindReversedDouble() const
  {
    for (const Shell& shell : this->Shells)
    {
      std::vector<Triangle> once = shell.Triangles;
      for (Triangle& t : once)
      {
        std::sort(t.begin(), t.end());
      }
      std::sort(once.begin(), once.end());
      once.erase(std::unique(once.begin(), once.end()), once.end());
      if (2 * once.size() != shell.Triangles.size())
      {
        continue;
      }
      bool closed = true;
      ForEachEdge(SortedHalfEdges(SurfaceView(this->Mesh.Points, once), {}),
        [&](auto first, auto last) { closed = closed && (last - first) % 2 == 0; });
      if (closed)
      {
        return ShellCrossing{ Middle(this->Place(once.front())), true };
      }
    }
    return {};
  }

  Corners3 Place(const Triangle& t) const
  {
    return { this->Mesh.Point(t[0]), this->Mesh.Point(t[1]), this->Mesh.Point(t[2]) };
  }

  static Point3 Middle(const Corners3& t) { return (1.0 / 3.0) * (t[0] + t[1] + t[2]); }

  std::optional<ShellCrossing> FindCrossingTriangles(const ProgressCallback& progress)
  {
    struct Found
    {
      std::vector<std::pair<TriangleIds, Point3>> Crossings; ///< the first of the group
      std::vector<TriangleIds> Touches;
    };
    const TriangleBoxTree tree(this->Mesh);
    std::vector<Found> groups(static_cast<std::size_t>(tree.Groups()));
    ParallelFor(
      0, tree.Groups(), 4,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t g = first; g < last; ++g)
        {
          Found& found = groups[static_cast<std::size_t>(g)];
          tree.ForEachPair(g,
            [&](std::int64_t i, std::int64_t j)
            {
              const TriangleIds ids = std::minmax(i, j);
              const int shell = this->ShellOf[At(ids.first)];
              const int other = this->ShellOf[At(ids.second)];
              if (shell == other || shell < 0 || other < 0)
              {
                return;
              }
              const TrianglePair pair = Compare(this->Place(this->Corners[At(ids.first)]),
                this->Place(this->Corners[At(ids.second)]), this->Touch);
              if (pair.Touch)
              {
                found.Touches.push_back(ids);
              }
              if (pair.Place && (found.Crossings.empty() || ids < found.Crossings[0].first))
              {
                found.Crossings.assign(1, { ids, *pair.Place });
              }
            });
        }
      },
      Between(progress, 0.0, 0.9));
    std::vector<std::pair<TriangleIds, Point3>> crossings;
    for (const Found& found : groups)
    {
      crossings.insert(crossings.end(), found.Crossings.begin(), found.Crossings.end());
      for (const TriangleIds& ids : found.Touches)
      {
        const ShellIds shells =
          std::minmax(this->ShellOf[At(ids.first)], this->ShellOf[At(ids.second)]);
        auto& all = this->Touching[shells];
        all.push_back(ids.first);
        all.push_back(ids.second);
      }
    }
    if (crossings.empty())
    {
      return {};
    }
    return ShellCrossing{ std::min_element(crossings.begin(), crossings.end())->second, false };
  }

  /// Points and middles of the triangles where two shells touch, and of some more of each.
  std::optional<ShellCrossing> FindByWinding(
    int first, int second, const std::vector<std::int64_t>& triangles)
  {
    const auto samplesOf = [&](int shell)
    {
      std::vector<Triangle> asked;
      for (const std::int64_t t : triangles)
      {
        if (this->ShellOf[At(t)] == shell)
        {
          asked.push_back(this->Corners[At(t)]);
        }
      }
      const std::vector<Triangle>& all = this->Shells[static_cast<std::size_t>(shell)].Triangles;
      const std::size_t step = std::max<std::size_t>(all.size() / SpreadSamples, 1);
      for (std::size_t t = 0; t < all.size(); t += step)
      {
        asked.push_back(all[t]);
      }
      return asked;
    };
    const Sides ofFirst = this->FindSides(samplesOf(first), second);
    const Sides ofSecond = this->FindSides(samplesOf(second), first);
    const bool coincide = !ofFirst.In && !ofFirst.Out && !ofSecond.In && !ofSecond.Out;
    if (coincide || (ofFirst.In && ofFirst.Out) || (ofSecond.In && ofSecond.Out))
    {
      return ShellCrossing{ this->FindTouch(triangles), coincide };
    }
    return {};
  }

  /// The center of the smallest overlap between the boxes of two paired triangles.
  Point3 FindTouch(const std::vector<std::int64_t>& pairs) const
  {
    Point3 place = this->Mesh.Point(this->Corners[At(pairs[0])][0]);
    double least = HUGE_VAL;
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2)
    {
      const Bounds3 a = ComputeBox(this->Place(this->Corners[At(pairs[i])]));
      const Bounds3 b = ComputeBox(this->Place(this->Corners[At(pairs[i + 1])]));
      Bounds3 shared;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        shared.Min[axis] = std::max(a.Min[axis], b.Min[axis]);
        shared.Max[axis] = std::min(a.Max[axis], b.Max[axis]);
      }
      if (shared.Diagonal() < least)
      {
        least = shared.Diagonal();
        place = 0.5 * (shared.Min + shared.Max);
      }
    }
    return place;
  }

  static Bounds3 ComputeBox(const Corners3& t)
  {
    Bounds3 box{ t[0], t[0] };
    box.Add(t[1]);
    box.Add(t[2]);
    return box;
  }

  Sides FindSides(const std::vector<Triangle>& samples, int shell)
  {
    Shell& of = this->Shells[static_cast<std::size_t>(shell)];
    if (!of.Winding)
    {
      const SurfaceView view(this->Mesh.Points, of.Triangles);
      of.Winding = std::make_unique<WindingNumber>(view);
      of.Tree = std::make_unique<TriangleTree>(view);
    }
    // Rounding leaves more of a winding number than of a height above a plane.
    const double off = std::max(1e3 * this->Touch, 1e-300);
    Sides sides;
    for (const Triangle& t : samples)
    {
      const Corners3 place = this->Place(t);
      for (const Point3& x : { place[0], place[1], place[2], Middle(place) })
      {
        const bool on = of.Tree->Find(x, -1).Squared <= off * off;
        const bool in = !on && std::abs((*of.Winding)(x)) > 0.5;
        sides.On = sides.On || on;
        sides.In = sides.In || in;
        sides.Out = sides.Out || (!on && !in);
      }
    }
    return sides;
  }

  std::vector<Triangle> Corners; ///< coinciding points merged
  SurfaceView Mesh;
  std::vector<Shell> Shells; ///< closed ones
  std::vector<int> ShellOf;  ///< of each triangle, -1 for open ones
  double Touch = 0.0;
  std::map<ShellIds, std::vector<std::int64_t>> Touching; ///< pairs of triangles
};

}

namespace
{

bool HaveCommonPoint(const Triangle& a, const Triangle& b)
{
  return std::any_of(
    a.begin(), a.end(), [&](vtkIdType p) { return std::find(b.begin(), b.end(), p) != b.end(); });
}

/// Where two edges come nearest to each other, if within both and nearer than `touch`.
std::optional<Point3> EdgeContact(
  const std::array<Point3, 2>& a, const std::array<Point3, 2>& b, double touch)
{
  const Point3 u = a[1] - a[0], v = b[1] - b[0], w = b[0] - a[0];
  const Point3 n = Cross(u, v);
  const double square = Dot(n, n);
  if (!(square > 0.0) || std::pow(Dot(w, n), 2) > touch * touch * square)
  {
    return {};
  }
  const double s = Dot(Cross(w, v), n) / square, t = Dot(Cross(w, u), n) / square;
  return s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0 ? std::optional(a[0] + s * u) : std::nullopt;
}

/// Where two triangles are nearer to each other than `touch`.
std::optional<Point3> Contact(const Corners3& a, const Corners3& b, double touch)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (SquaredDistanceToTriangle(a[i], b) <= touch * touch)
    {
      return a[i];
    }
    if (SquaredDistanceToTriangle(b[i], a) <= touch * touch)
    {
      return b[i];
    }
    for (std::size_t j = 0; j < 3; ++j)
    {
      if (const auto place = EdgeContact({ a[i], a[(i + 1) % 3] }, { b[j], b[(j + 1) % 3] }, touch))
      {
        return place;
      }
    }
  }
  return {};
}

using TrianglePlaces = std::vector<std::pair<std::pair<std::int64_t, std::int64_t>, Point3>>;

/// The triangles that remain where edges shorter than `touch` become points: those beside slivers
/// are neighbours then.
std::vector<Triangle> WithoutShortEdges(const SurfaceView& mesh, double touch)
{
  DisjointSets<vtkIdType> points(mesh.Points.size());
  for (const Triangle& t : mesh.Triangles)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      if (Distance(mesh.Point(t[c]), mesh.Point(t[(c + 1) % 3])) <= touch)
      {
        points.Join(t[c], t[(c + 1) % 3]);
      }
    }
  }
  std::vector<Triangle> corners(mesh.Triangles.begin(), mesh.Triangles.end());
  for (Triangle& t : corners)
  {
    std::transform(t.begin(), t.end(), t.begin(), [&](vtkIdType p) { return points.Find(p); });
  }
  return corners;
}

/// A point where the sheets of `corners` touch though those of `mesh` are no cones there.
std::optional<Point3> FindPinch(const SurfaceView& mesh, std::vector<Triangle> corners)
{
  corners.erase(std::remove_if(corners.begin(), corners.end(), HasRepeated), corners.end());
  if (corners.size() == mesh.Triangles.size())
  {
    return {};
  }
  const std::vector<std::int64_t> pinched = FindDefects({ mesh.Points, corners }).NonManifoldPoints;
  const std::vector<std::int64_t> known =
    pinched.empty() ? pinched : FindDefects(mesh).NonManifoldPoints;
  for (const std::int64_t p : pinched)
  {
    if (!std::binary_search(known.begin(), known.end(), p))
    {
      return mesh.Point(p);
    }
  }
  return {};
}

/// The first of the pairs whose triangles have no points that an edge joins; `corners` are
/// WithoutShortEdges().
std::optional<Point3> FindApart(const std::vector<Triangle>& corners, TrianglePlaces pairs)
{
  std::map<vtkIdType, std::set<vtkIdType>> around;
  for (const auto& pair : pairs)
  {
    for (const vtkIdType p : corners[At(pair.first.first)])
    {
      around[p];
    }
  }
  for (const Triangle& t : corners)
  {
    for (const vtkIdType p : t)
    {
      const auto found = around.find(p);
      if (found != around.end())
      {
        found->second.insert(t.begin(), t.end());
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  const auto apart = std::find_if(pairs.begin(), pairs.end(),
    [&](const auto& pair)
    {
      const Triangle& a = corners[At(pair.first.first)];
      const Triangle& b = corners[At(pair.first.second)];
      return std::none_of(a.begin(), a.end(),
        [&](vtkIdType p)
        {
          const std::set<vtkIdType>& near = around[p];
          return std::any_of(b.begin(), b.end(), [&](vtkIdType q) { return near.count(q) > 0; });
        });
    });
  return apart != pairs.end() ? std::optional(apart->second) : std::nullopt;
}

std::optional<SelfCrossing> FindCrossingPairs(
  const SurfaceView& mesh, const ProgressCallback& progress)
{
  std::vector<Triangle> corners = MergedCorners(mesh);
  corners.erase(std::remove_if(corners.begin(), corners.end(), HasRepeated), corners.end());
  const SurfaceView merged(mesh.Points, corners);
  if (corners.empty())
  {
    return {};
  }
  using Ids = std::pair<std::int64_t, std::int64_t>;
  struct Found
  {
    std::int64_t Pairs = 0;
    std::optional<std::pair<Ids, Point3>> First;
    TrianglePlaces Touching;

    Found& operator+=(const Found& other)
    {
      this->Pairs += other.Pairs;
      this->Touching.insert(this->Touching.end(), other.Touching.begin(), other.Touching.end());
      if (other.First && (!this->First || other.First->first < this->First->first))
      {
        this->First = other.First;
      }
      return *this;
    }
  };
  const std::vector<int> component = Components(merged);
  const double touch = SelfTouchingPart * ComputeBounds(merged).Diagonal();
  const TriangleBoxTree tree(merged);
  const auto place = [&](std::int64_t t)
  {
    const Triangle& c = corners[At(t)];
    return Corners3{ merged.Point(c[0]), merged.Point(c[1]), merged.Point(c[2]) };
  };
  const Found all = ParallelReduce(
    tree.Groups(), 4, Found{},
    [&](Found& found, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t g = first; g < last; ++g)
      {
        tree.ForEachPair(g,
          [&](std::int64_t i, std::int64_t j)
          {
            const Ids ids = std::minmax(i, j);
            if (component[At(i)] != component[At(j)] ||
              HaveCommonPoint(corners[At(i)], corners[At(j)]))
            {
              return;
            }
            const TrianglePair pair = Compare(place(ids.first), place(ids.second), touch);
            if (pair.Place)
            {
              found += Found{ 1, std::pair{ ids, *pair.Place }, {} };
            }
            const auto contact =
              pair.Touch ? Contact(place(ids.first), place(ids.second), touch) : std::nullopt;
            if (contact)
            {
              found.Touching.emplace_back(ids, *contact);
            }
          });
      }
    },
    progress);
  if (all.First)
  {
    return SelfCrossing{ all.First->second, all.Pairs };
  }
  const std::vector<Triangle> kept = WithoutShortEdges(merged, touch);
  std::optional<Point3> touching = FindPinch(merged, kept);
  if (!touching && !all.Touching.empty())
  {
    touching = FindApart(kept, all.Touching);
  }
  return touching ? std::optional(SelfCrossing{ *touching, 0 }) : std::nullopt;
}

/// Calls find(mesh) where products of three lengths are finite: scaling by a power of two is exact.
template <typename Find>
auto FindAtUsualScale(const SurfaceView& mesh, Find&& find)
{
  double largest = 0.0;
  for (const Triangle& t : mesh.Triangles)
  {
    for (const vtkIdType p : t)
    {
      for (const double x : mesh.Point(p))
      {
        largest = std::max(largest, std::abs(x));
      }
    }
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  constexpr int usual = 20;
  if (std::abs(exponent) <= usual)
  {
    return find(mesh);
  }
  const auto times = [](const Point3& p, int power) {
    return Point3{ std::ldexp(p[0], power), std::ldexp(p[1], power), std::ldexp(p[2], power) };
  };
  std::vector<Point3> points(mesh.Points.begin(), mesh.Points.end());
  for (Point3& p : points)
  {
    p = times(p, -exponent);
  }
  auto found = find(SurfaceView(points, mesh.Triangles));
  if (found)
  {
    found->Place = times(found->Place, exponent);
  }
  return found;
}

}

std::string ShellCrossing::Message(const PlaceInWorld& inWorld) const
{
  const Point3 at = inWorld ? inWorld(this->Place) : this->Place;
  const std::string place =
    "(" + FormatNumber(at[0]) + ", " + FormatNumber(at[1]) + ", " + FormatNumber(at[2]) + ")";
  return this->Coincide ? "Two closed parts of the surface coincide, for instance at " + place +
      ", so it is not defined what is inside: remove one of them."
                        : "Two closed parts of the surface cross at " + place +
      ", so it is not defined what is inside: unite them (Tetrahedral Mesher with Library "
      "Automatic, then Extract Surface) or remove one of them.";
}

std::optional<ShellCrossing> FindShellCrossing(
  const SurfaceView& mesh, const ProgressCallback& progress)
{
  return FindAtUsualScale(
    mesh, [&](const SurfaceView& scaled) { return ShellPairs(scaled).Find(progress); });
}

std::optional<SelfCrossing> FindSelfCrossing(
  const SurfaceView& mesh, const ProgressCallback& progress)
{
  return FindAtUsualScale(
    mesh, [&](const SurfaceView& scaled) { return FindCrossingPairs(scaled, progress); });
}

void RequireShellsApart(
  const SurfaceView& mesh, const PlaceInWorld& inWorld, const ProgressCallback& progress)
{
  if (const auto crossing = FindShellCrossing(mesh, progress))
  {
    throw std::invalid_argument(crossing->Message(inWorld));
  }
}

}
