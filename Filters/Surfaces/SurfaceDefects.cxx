#include "Surfaces/SurfaceDefects.h"

#include "Core/Handles.h"
#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <string>

namespace isthmus
{

bool SurfaceDefects::None() const
{
  return this->InvalidPoints.empty() && this->InvalidTriangles.empty() &&
    this->DegenerateTriangles.empty() && this->DuplicateTriangles.empty() &&
    this->BoundaryTriangles.empty() && this->NonManifoldTriangles.empty() &&
    this->FlippedTriangles.empty() && this->NonManifoldPoints.empty();
}

std::string FirstIds(const std::vector<std::int64_t>& ids)
{
  constexpr std::size_t shown = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, ids.size()); ++i)
  {
    text += (i ? ", " : "") + std::to_string(ids[i]);
  }
  return ids.size() > shown ? text + " and " + std::to_string(ids.size() - shown) + " more" : text;
}

std::string SurfaceDefects::Message() const
{
  std::string text;
  const auto add = [&text](const std::vector<std::int64_t>& ids, const char* what)
  {
    if (!ids.empty())
    {
      text += (text.empty() ? "" : "; ") + std::string(what) + " (" + FirstIds(ids) + ")";
    }
  };
  add(this->InvalidPoints, "points that are not finite");
  add(this->InvalidTriangles, "triangles with a repeated or missing point");
  add(this->DegenerateTriangles, "triangles without area");
  add(this->DuplicateTriangles, "duplicate triangles");
  add(this->BoundaryTriangles, "triangles at a hole");
  add(this->NonManifoldTriangles, "triangles at an edge of more than two");
  add(this->FlippedTriangles, "neighbouring triangles of opposite orientation");
  add(this->NonManifoldPoints, "points where sheets touch");
  return text.empty() ? text : "The surface has " + text + ".";
}

namespace
{

using StarTriangle = Handle<struct StarTriangleKind, std::int64_t>;

/// The triangles round each point, in ascending order.
class Stars
{
public:
  Stars(const SurfaceView& mesh, const std::vector<char>& skip)
    : First(mesh.Points.size() + 2, 0)
  {
    const auto forCorners = [&mesh, &skip](auto&& visit)
    {
      for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
      {
        if (!skip[t])
        {
          for (const std::int64_t p : mesh.Triangles[t])
          {
            visit(At(p), StarTriangle::At(t));
          }
        }
      }
    };
    // Counted two positions ahead: filling moves each start to the beginning of the next.
    forCorners([this](std::size_t p, StarTriangle) { ++this->First[p + 2]; });
    std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
    this->Around.resize(this->First.back());
    forCorners(
      [this](std::size_t p, StarTriangle t) { this->Around[this->First[p + 1]++] = t.Value; });
  }

  const std::int64_t* Begin(std::size_t p) const { return this->Around.data() + this->First[p]; }
  std::size_t Size(std::size_t p) const { return this->First[p + 1] - this->First[p]; }

private:
  std::vector<std::size_t> First;
  std::vector<std::int64_t> Around;
};

/// A side, of one triangle, that begins or ends at the point.
struct Spoke
{
  std::int64_t Other;
  std::int64_t Apex;   ///< the triangle's third corner
  std::uint32_t Place; ///< of the triangle in the star
  bool Leaves;         ///< the triangle runs from the point to Other

  bool operator<(const Spoke& o) const
  {
    return this->Other != o.Other ? this->Other < o.Other
      : this->Apex != o.Apex      ? this->Apex < o.Apex
                                  : this->Place < o.Place;
  }
};

/// Checks one star after the other; memory is reused between them.
class StarCheck
{
public:
  StarCheck(const SurfaceView& mesh, const Stars& stars)
    : Mesh(mesh)
    , TheStars(stars)
  {
  }

  void CheckPoint(std::int64_t point)
  {
    const std::size_t size = this->TheStars.Size(At(point));
    if (size == 0)
    {
      return;
    }
    this->Triangles = this->TheStars.Begin(At(point));
    this->CollectSpokes(point, size);
    this->Fan.resize(size);
    std::iota(this->Fan.begin(), this->Fan.end(), 0U);
    std::size_t fans = size;
    for (std::size_t i = 0; i < this->Spokes.size();)
    {
      std::size_t end = i + 1;
      for (; end < this->Spokes.size() && this->Spokes[end].Other == this->Spokes[i].Other; ++end)
      {
        fans -= this->Join(this->Spokes[i].Place, this->Spokes[end].Place) ? 1 : 0;
      }
      if (this->Spokes[i].Other > point) // each edge once
      {
        this->CheckEdge(this->Spokes.data() + i, this->Spokes.data() + end);
      }
      i = end;
    }
    if (fans > 1)
    {
      this->Found.NonManifoldPoints.push_back(point);
    }
  }

  SurfaceDefects Found;

private:
  void CollectSpokes(std::int64_t point, std::size_t size)
  {
    this->Spokes.clear();
    for (std::uint32_t place = 0; place < size; ++place)
    {
      const Triangle& t = this->Mesh.Triangles[At(this->Triangles[place])];
      const std::size_t corner = t[0] == point ? 0 : t[1] == point ? 1 : 2;
      const std::int64_t next = t[(corner + 1) % 3];
      const std::int64_t last = t[(corner + 2) % 3];
      this->Spokes.push_back({ next, last, place, true });
      this->Spokes.push_back({ last, next, place, false });
    }
    std::sort(this->Spokes.begin(), this->Spokes.end());
  }

  std::uint32_t Root(std::uint32_t place)
  {
    while (this->Fan[place] != place)
    {
      this->Fan[place] = this->Fan[this->Fan[place]];
      place = this->Fan[place];
    }
    return place;
  }

  /// True if they were separate.
  bool Join(std::uint32_t a, std::uint32_t b)
  {
    const std::uint32_t rootA = this->Root(a);
    const std::uint32_t rootB = this->Root(b);
    this->Fan[std::max(rootA, rootB)] = std::min(rootA, rootB);
    return rootA != rootB;
  }

  void CheckEdge(const Spoke* first, const Spoke* end)
  {
    const auto triangle = [this](const Spoke& spoke) { return this->Triangles[spoke.Place]; };
    const auto count = end - first;
    if (count == 1)
    {
      this->Found.BoundaryTriangles.push_back(triangle(*first));
    }
    else if (count > 2)
    {
      for (const Spoke* spoke = first; spoke != end; ++spoke)
      {
        this->Found.NonManifoldTriangles.push_back(triangle(*spoke));
      }
    }
    else if (first[0].Leaves == first[1].Leaves)
    {
      this->Found.FlippedTriangles.insert(
        this->Found.FlippedTriangles.end(), { triangle(first[0]), triangle(first[1]) });
    }
    for (const Spoke* spoke = first + 1; spoke < end; ++spoke)
    {
      // Reported once, at the edge between the triangle's two lowest points.
      if (spoke->Apex == spoke[-1].Apex && spoke->Apex > spoke->Other)
      {
        this->Found.DuplicateTriangles.push_back(triangle(*spoke));
      }
    }
  }

  SurfaceView Mesh;
  const Stars& TheStars;
  const std::int64_t* Triangles = nullptr; ///< of the star
  std::vector<Spoke> Spokes;
  std::vector<std::uint32_t> Fan; ///< union-find over the star's triangles
};

constexpr std::vector<std::int64_t> SurfaceDefects::*ListsOfStars[] = {
  &SurfaceDefects::DuplicateTriangles, &SurfaceDefects::BoundaryTriangles,
  &SurfaceDefects::NonManifoldTriangles, &SurfaceDefects::FlippedTriangles,
  &SurfaceDefects::NonManifoldPoints
};

}

/**
 * Adds to `found` duplicate triangles, those at edges that do not have two of opposite direction,
 * and points whose triangles form more than one fan; each list in ascending order, without
 * repetition.
 *
 * All of these are visible in the star of one point, the lowest one involved, whose triangles are
 * sorted by their other corners: O(n) for stars of bounded size, in parallel over points, 32 bytes
 * per triangle. The same on any number of threads.
 *
 * @param skip Triangles to leave out, one flag each.
 * @pre The corners of all others are points, and differ.
 */
static void FindStarDefects(
  const SurfaceView& mesh, const std::vector<char>& skip, SurfaceDefects& found)
{
  const Stars stars(mesh, skip);
  std::mutex mutex;
  ParallelFor(0, static_cast<std::int64_t>(mesh.Points.size()), 1 << 14,
    [&](std::int64_t begin, std::int64_t end)
    {
      StarCheck check(mesh, stars);
      for (std::int64_t point = begin; point < end; ++point)
      {
        check.CheckPoint(point);
      }
      const std::lock_guard<std::mutex> lock(mutex);
      for (const auto kind : ListsOfStars)
      {
        const std::vector<std::int64_t>& mine = check.Found.*kind;
        (found.*kind).insert((found.*kind).end(), mine.begin(), mine.end());
      }
    });
  for (const auto kind : ListsOfStars)
  {
    std::vector<std::int64_t>& ids = found.*kind;
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  }
}

namespace
{

constexpr std::int64_t Grain = 1 << 14;

/// Edges are brought to about 1 first, by a power of two: the square of an area of 1e-100 is 0.
bool HasNoArea(const Point3& p, const Point3& q, const Point3& r)
{
  Point3 u = q - p, v = r - p;
  double largest = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    largest = std::max({ largest, std::abs(u[a]), std::abs(v[a]) });
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double scale = std::ldexp(1.0, -exponent);
  const Point3 normal = Cross(scale * u, scale * v);
  return Dot(normal, normal) == 0.0;
}

enum class TriangleKind : char
{
  Sound,
  Degenerate,
  Invalid
};

TriangleKind ClassifyTriangle(const SurfaceView& mesh, const Triangle& ids)
{
  const auto points = static_cast<std::int64_t>(mesh.Points.size());
  const bool inRange =
    std::all_of(ids.begin(), ids.end(), [points](std::int64_t p) { return p >= 0 && p < points; });
  if (!inRange || ids[0] == ids[1] || ids[1] == ids[2] || ids[2] == ids[0])
  {
    return TriangleKind::Invalid;
  }
  return HasNoArea(mesh.Points[At(ids[0])], mesh.Points[At(ids[1])], mesh.Points[At(ids[2])])
    ? TriangleKind::Degenerate
    : TriangleKind::Sound;
}

/// Invalid and degenerate triangles; a flag each for those that have no usable point ids.
std::vector<char> CheckTriangles(const SurfaceView& mesh, SurfaceDefects& found)
{
  std::vector<TriangleKind> kinds(mesh.Triangles.size());
  ParallelFor(0, static_cast<std::int64_t>(kinds.size()), Grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t t = begin; t < end; ++t)
      {
        kinds[At(t)] = ClassifyTriangle(mesh, mesh.Triangles[At(t)]);
      }
    });
  std::vector<char> skip(kinds.size());
  for (std::size_t t = 0; t < kinds.size(); ++t)
  {
    if (kinds[t] == TriangleKind::Degenerate)
    {
      found.DegenerateTriangles.push_back(static_cast<std::int64_t>(t));
    }
    else if (kinds[t] == TriangleKind::Invalid)
    {
      found.InvalidTriangles.push_back(static_cast<std::int64_t>(t));
      skip[t] = 1;
    }
  }
  return skip;
}

}

SurfaceDefects FindDefects(const SurfaceView& mesh, const ProgressCallback& progress)
{
  SurfaceDefects found;
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    const Point3& p = mesh.Points[i];
    if (!std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); }))
    {
      found.InvalidPoints.push_back(static_cast<std::int64_t>(i));
    }
  }
  const std::vector<char> skip = CheckTriangles(mesh, found);
  Report(progress, 0.3);
  FindStarDefects(mesh, skip, found);
  Report(progress, 1.0);
  return found;
}

void RequireResolved(const SurfaceView& mesh)
{
  constexpr double resolution = 0x1p-50; // the rounding error of a few sums of coordinates
  double reach = 0.0;
  std::vector<double> longest(mesh.Points.size(), -1.0); // edge of each point; < 0: none
  for (const Triangle& t : mesh.Triangles)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const auto a = static_cast<std::size_t>(t[c]);
      const auto b = static_cast<std::size_t>(t[(c + 1) % 3]);
      const double edge = Distance(mesh.Points[a], mesh.Points[b]);
      longest[a] = std::max(longest[a], edge);
      longest[b] = std::max(longest[b], edge);
      reach = std::max({ reach, std::abs(mesh.Points[a][0]), std::abs(mesh.Points[a][1]),
        std::abs(mesh.Points[a][2]) });
    }
  }
  for (std::size_t i = 0; i < longest.size(); ++i)
  {
    if (longest[i] >= 0.0 && longest[i] < resolution * reach)
    {
      throw std::invalid_argument("The edges at point " + std::to_string(i) + " are " +
        FormatNumber(longest[i]) + " long at most, and coordinates of " + FormatNumber(reach) +
        " have no finer resolution: remove the points that are far away, or the tiny part.");
    }
  }
}

}
