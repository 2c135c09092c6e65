#include "ChokingLoops/SurfacePreparation.h"

#include "Core/Geometry.h"
#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Remeshing/SelfIntersections.h"
#include "Remeshing/SurfaceRepair.h"
#include "Remeshing/ThinTriangles.h"
#include "Surfaces/SurfaceCleaning.h"
#include "Surfaces/SurfaceCorrection.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceMeasures.h"
#include "Surfaces/SurfaceTopology.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <unordered_map>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// RepairReport
namespace
{

/// The distance by which copies of a point are moved towards the mean of their neighbours.
constexpr double MovedBy = 0.01;

/// Thin triangles may hide others, and repair may create some.
constexpr int MostRounds = 3;

/// Moves points that coincide with another one into the sheet they belong to.
void DrawApart(TriangleMesh& mesh)
{
  std::map<Point3, std::int64_t> count;
  for (const Point3& p : mesh.Points)
  {
    ++count[p];
  }
  std::map<std::int64_t, std::pair<Point3, double>> around; // sum and number of neighbours
  for (const Triangle& t : mesh.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (count[mesh.Points[At(t[k])]] > 1)
      {
        auto& [sum, number] = around.try_emplace(t[k], Point3{ 0, 0, 0 }, 0.0).first->second;
        sum = sum + mesh.Points[At(t[(k + 1) % 3])] + mesh.Points[At(t[(k + 2) % 3])];
        number += 2.0;
      }
    }
  }
  std::vector<std::pair<std::int64_t, Point3>> moved;
  for (const auto& [id, neighbours] : around)
  {
    const Point3 middle = (1.0 / neighbours.second) * neighbours.first;
    moved.emplace_back(id, (1.0 - MovedBy) * mesh.Points[At(id)] + MovedBy * middle);
  }
  for (const auto& [id, place] : moved)
  {
    mesh.Points[At(id)] = place;
  }
}

/// Volume of the surface after orientation; parts that face inward count as holes.
double MakeVolumeView(const SurfaceView& mesh)
{
  double six = 0.0;
  const Point3 origin = mesh.Points.empty() ? Point3{ 0, 0, 0 } : mesh.Points.front();
  for (const Triangle& t : mesh.Triangles)
  {
    six += Dot(mesh.Points[At(t[0])] - origin,
      Cross(mesh.Points[At(t[1])] - origin, mesh.Points[At(t[2])] - origin));
  }
  return std::abs(six / 6.0);
}

/// Corners of a triangle in their cyclic order, starting with the smallest.
std::array<Point3, 3> CornerPositions(const SurfaceView& mesh, const Triangle& t)
{
  std::array<Point3, 3> p{ mesh.Points[At(t[0])], mesh.Points[At(t[1])], mesh.Points[At(t[2])] };
  std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
  return p;
}

/// Counts and locates the triangles of `before` that are not in `after`.
void ReportChanges(const SurfaceView& before, const SurfaceView& after, RepairReport& report)
{
  std::map<std::array<Point3, 3>, int> left;
  for (const Triangle& t : after.Triangles)
  {
    ++left[CornerPositions(after, t)];
  }
  for (const Triangle& t : before.Triangles)
  {
    const std::array<Point3, 3> places = CornerPositions(before, t);
    const auto found = left.find(places);
    if (found != left.end() && found->second > 0)
    {
      --found->second;
      continue;
    }
    ++report.Changed;
    report.Places.push_back((1.0 / 3.0) * (places[0] + places[1] + places[2]));
  }
}

/// One round of repair.
TriangleMesh Repaired(const SurfaceView& surface, const ProgressCallback& progress)
{
  TriangleMesh mesh = CopyMesh(surface);
  if (FindDefects(mesh).None() && !ThinTriangles(mesh).empty())
  {
    mesh = RemoveThinTriangles(mesh);
  }
  const SurfaceDefects defects = FindDefects(mesh);
  if (!defects.None() || !SelfIntersections(mesh, Between(progress, 0.0, 0.3)).empty())
  {
    mesh = RepairSurface(mesh, Between(progress, 0.3, 1.0)).Mesh;
    DrawApart(mesh);
    mesh = MergePoints(mesh);
  }
  return mesh;
}

bool IsClean(const SurfaceView& mesh, bool allowCrossings, const ProgressCallback& progress)
{
  return !mesh.Triangles.empty() && FindDefects(mesh).None() && ThinTriangles(mesh).empty() &&
    (allowCrossings || SelfIntersections(mesh, progress).empty());
}

}

TriangleMesh RepairedForAnalysis(const SurfaceView& surface, const std::string& what,
  bool allowCrossings, RepairReport& report, const ProgressCallback& progress)
{
  TriangleMesh mesh = CopyMesh(surface);
  bool clean = false;
  try
  {
    for (int round = 0; round < MostRounds && !clean; ++round)
    {
      mesh = Repaired(mesh, Between(progress, 0.0, 0.0));
      clean = IsClean(mesh, allowCrossings, Between(progress, 0.0, 0.0));
    }
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const std::exception&)
  {
    clean = false; // the message below says the same
  }
  const std::string advice = " Recreate the surface (Contour, Surface Remesh), or allow "
                             "self-intersections to continue anyway.";
  if (!clean)
  {
    throw std::invalid_argument(what + " It could not be repaired." + advice);
  }
  const double before = MakeVolumeView(surface);
  const double share = before > 0.0 ? std::abs(MakeVolumeView(mesh) - before) / before : HUGE_VAL;
  if (!(share <= RepairableShare))
  {
    throw std::invalid_argument(what + " Its repair would change the volume by " +
      FormatNumber(100.0 * share) + " %, but at most " + FormatNumber(100.0 * RepairableShare) +
      " % is allowed." + advice);
  }
  ReportChanges(surface, mesh, report);
  report.Message = what + " It was repaired: " + std::to_string(report.Changed) +
    " triangles changed, and the volume changed by " + FormatNumber(100.0 * share) + " %.";
  const std::string topology = DescribeTopologyChange(surface, mesh);
  report.Message += (topology.empty() ? "" : " ") + topology;
  return mesh;
}

// ------------------------------------------------------------------------------------------
// ChokingSurface
namespace
{

constexpr double Flat = 1e-10; ///< thickness over width: a plane after rounding

/// The point where `measure` is largest.
template <typename Measure>
const Point3& Farthest(const View<Point3>& points, Measure&& measure)
{
  return *std::max_element(points.begin(), points.end(),
    [&measure](const Point3& a, const Point3& b) { return measure(a) < measure(b); });
}

/// Largest distance of the points from the plane of three distant ones.
double Thickness(const View<Point3>& points)
{
  const Point3& origin = points.front();
  const auto square = [](const Point3& v) { return Dot(v, v); };
  const Point3 along =
    Farthest(points, [&](const Point3& p) { return square(p - origin); }) - origin;
  const Point3 normal = Cross(along,
    Farthest(points, [&](const Point3& p) { return square(Cross(along, p - origin)); }) - origin);
  const auto height = [&](const Point3& p) { return std::abs(Dot(normal, p - origin)); };
  const double length = std::sqrt(square(normal));
  return length > 0.0 ? height(Farthest(points, height)) / length : 0.0;
}

void RequireUsableSize(const SurfaceView& surface)
{
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    const Point3& p = surface.Points[i];
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      throw std::invalid_argument("Point " + std::to_string(i) +
        " of the surface is not finite: remove it or repair the surface.");
    }
  }
  Bounds3 box{ surface.Points.front(), surface.Points.front() };
  for (const Point3& p : surface.Points)
  {
    box.Add(p);
  }
  const double size =
    std::max({ box.Max[0] - box.Min[0], box.Max[1] - box.Min[1], box.Max[2] - box.Min[2] });
  // Squared circumradii are quotients of eighth powers of the spacing, a ten-thousandth of this.
  if (!(size > 1e-32 && size < 1e32))
  {
    throw std::invalid_argument("The surface is " + FormatNumber(size) +
      " wide, which is out of range (1e-32 to 1e32): scale it.");
  }
}

/// Repair would be slow and find no inside.
void RequireThickness(const SurfaceView& surface)
{
  Bounds3 box{ surface.Points.front(), surface.Points.front() };
  for (const Point3& p : surface.Points)
  {
    box.Add(p);
  }
  if (Thickness(surface.Points) < Flat * box.Diagonal())
  {
    throw std::invalid_argument("All points of the surface lie in a plane, so that it has no "
                                "inside: give it a thickness.");
  }
}

/// Holes, missing points and inconsistently oriented triangles are not repaired here.
bool CanBeRepaired(const SurfaceDefects& defects)
{
  return defects.InvalidPoints.empty() && defects.InvalidTriangles.empty() &&
    defects.BoundaryTriangles.empty() && defects.FlippedTriangles.empty();
}

/// True if holes are the only defect.
bool IsMerelyOpen(const SurfaceDefects& defects)
{
  return defects.InvalidPoints.empty() && defects.InvalidTriangles.empty() &&
    !defects.BoundaryTriangles.empty();
}

/// The surface without its thin triangles; empty if it has none, or if removing them would cause a
/// defect, since they are not a defect by themselves.
std::optional<TriangleMesh> WithoutNeedles(const SurfaceView& surface, bool allowCrossings,
  RepairReport& report, const ProgressCallback& progress)
{
  const std::vector<std::int64_t> thin = ThinTriangles(surface);
  if (thin.empty())
  {
    return std::nullopt;
  }
  try
  {
    return RepairedForAnalysis(surface,
      "The surface has " + std::to_string(thin.size()) + " triangles with almost no area (" +
        FirstIds(thin) + ").",
      allowCrossings, report, progress);
  }
  catch (const std::invalid_argument&)
  {
    report = {};
    return std::nullopt;
  }
}

}

namespace
{

/// The rest of CheckedSurface(), after coinciding points are merged and cracks closed.
TriangleMesh CheckedMergedSurface(TriangleMesh surface, const SurfaceDefects& defects,
  bool allowCrossings, const ProgressCallback& progress, RepairReport* report)
{
  const auto rest = Between(progress, 0.6, 1.0);
  if (!defects.None() && !(report && CanBeRepaired(defects)))
  {
    throw std::invalid_argument(defects.Message() + DescribeOpenBoundary(surface, defects) +
      " Choking loops need a closed, manifold, consistently oriented surface: repair it first "
      "(CapHoles of Choking Loops closes holes and orients triangles consistently; Fill Holes "
      "closes holes).");
  }
  RequireThickness(surface);
  if (!defects.None())
  {
    return RepairedForAnalysis(surface, defects.Message(), allowCrossings, *report, rest);
  }
  if (report)
  {
    std::optional<TriangleMesh> repairs = WithoutNeedles(surface, allowCrossings, *report, rest);
    if (repairs)
    {
      return std::move(*repairs);
    }
  }
  const std::vector<std::int64_t> crossing = allowCrossings
    ? std::vector<std::int64_t>{}
    : SelfIntersections(surface, Between(progress, 0.2, 0.6));
  if (crossing.empty())
  {
    return surface;
  }
  const std::string what = "The surface crosses itself in " + std::to_string(crossing.size()) +
    " triangles (" + FirstIds(crossing) + ").";
  if (!report)
  {
    throw std::invalid_argument(
      what + " Repair it, or allow self-intersections to continue anyway.");
  }
  return RepairedForAnalysis(surface, what, allowCrossings, *report, rest);
}

}

TriangleMesh CheckedSurface(
  TriangleMesh surface, bool allowCrossings, const ProgressCallback& progress, RepairReport* report)
{
  if (surface.Triangles.empty() || surface.Points.empty())
  {
    throw std::invalid_argument("The surface has no triangles: choking loops need a closed one.");
  }
  RequireUsableSize(surface);
  Report(progress, 0.0);
  surface = MergePoints(surface);
  Report(progress, 0.1);
  SurfaceDefects defects = FindDefects(surface, Between(progress, 0.1, 0.2));
  SurfaceCorrection correction;
  if (report && IsMerelyOpen(defects))
  {
    const std::vector<Triangle> joined = JoinCracks(surface, correction);
    surface = MergePoints(SurfaceView(surface.Points, joined));
    defects = FindDefects(surface);
  }
  TriangleMesh checked =
    CheckedMergedSurface(std::move(surface), defects, allowCrossings, progress, report);
  const std::string message = correction.Message();
  if (!message.empty())
  {
    report->Message = message + (report->Message.empty() ? "" : " ") + report->Message;
  }
  return checked;
}

// ------------------------------------------------------------------------------------------
// SurfacePreparation
namespace
{

using Limit = std::function<double(const Point3&, const Point3&)>;

/// Largest distance from a point of the triangle to its nearest corner: the circumradius where all
/// angles are acute, else where a bisector of a leg meets the longest side. No triangle has more
/// than the equilateral one on its longest side, even where rounding falsifies the formula for
/// needles.
double CornerDistance(const Point3& p, const Point3& q, const Point3& r)
{
  std::array<double, 3> s{ Distance(p, q), Distance(q, r), Distance(r, p) };
  std::sort(s.begin(), s.end());
  const auto [a, b, c] = s;
  if (c <= 0.0)
  {
    return 0.0;
  }
  const double most = c / std::sqrt(3.0);
  const Point3 n = Cross(q - p, r - p);
  if (c * c < a * a + b * b)
  {
    return std::min(most, a * b * c / (2.0 * Length(n)));
  }
  // On the longest side, equally far from the obtuse corner and from the end of a leg of length x:
  // x / (2 cos(angle at that end)).
  const double cosA = (a * a + c * c - b * b) / (2.0 * a * c);
  const double cosB = (b * b + c * c - a * a) / (2.0 * b * c);
  return std::min(most, std::max(a / (2.0 * cosA), b / (2.0 * cosB)));
}

/// Midpoints of the split edges, by their ends.
class Midpoints
{
public:
  explicit Midpoints(std::vector<Point3>& points)
    : Points(points)
  {
  }

  /// The midpoint's id, or -1 for an edge that stays whole.
  std::int64_t Of(std::int64_t a, std::int64_t b, const Limit& limit)
  {
    const auto key = (static_cast<std::uint64_t>(std::min(a, b)) << 32) |
      static_cast<std::uint64_t>(std::max(a, b));
    const auto found = this->Ids.find(key);
    if (found != this->Ids.end())
    {
      return found->second;
    }
    const Point3& p = this->Points[At(std::min(a, b))];
    const Point3& q = this->Points[At(std::max(a, b))];
    std::int64_t id = -1;
    if (Distance(p, q) > limit(p, q))
    {
      id = static_cast<std::int64_t>(this->Points.size());
      const Point3 middle = 0.5 * (p + q);
      this->Points.push_back(middle);
      this->Ids.emplace(key, id);
    }
    return id;
  }

private:
  std::vector<Point3>& Points;
  std::unordered_map<std::uint64_t, std::int64_t> Ids;
};

/// The pieces of triangle t whose edge k -> k + 1 has midpoint m[k] (or -1).
void AddPieces(const std::vector<Point3>& points, Triangle t, std::array<std::int64_t, 3> m,
  std::vector<Triangle>& pieces)
{
  const auto split = std::count_if(m.begin(), m.end(), [](std::int64_t i) { return i >= 0; });
  if (split == 0)
  {
    pieces.push_back(t);
    return;
  }
  if (split == 3)
  {
    pieces.insert(pieces.end(),
      { { t[0], m[0], m[2] }, { m[0], t[1], m[1] }, { m[2], m[1], t[2] }, { m[0], m[1], m[2] } });
    return;
  }
  // Rotates the numbering so that edge 0 is the only split edge, or edge 2 the only unsplit one.
  while (split == 1 ? m[0] < 0 : m[2] >= 0)
  {
    std::rotate(t.begin(), t.begin() + 1, t.end());
    std::rotate(m.begin(), m.begin() + 1, m.end());
  }
  if (split == 1)
  {
    pieces.insert(pieces.end(), { { t[0], m[0], t[2] }, { m[0], t[1], t[2] } });
    return;
  }
  pieces.push_back({ m[0], t[1], m[1] });
  const double across = Distance(points[At(t[0])], points[At(m[1])]);
  const double other = Distance(points[At(m[0])], points[At(t[2])]);
  if (across < other)
  {
    pieces.insert(pieces.end(), { { t[0], m[0], m[1] }, { t[0], m[1], t[2] } });
  }
  else
  {
    pieces.insert(pieces.end(), { { t[0], m[0], t[2] }, { m[0], m[1], t[2] } });
  }
}

}

namespace
{

/// Points with errors of about the same size, in cubes whose edges are twice as long or longer; in
/// each, the largest errors first.
struct ErrorCubes
{
  double Edge = 0.0;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> Points{};

  /// Of the cube at an offset from that of `p`. Cubes that share a key by chance do no harm.
  std::uint64_t GetKey(const Point3& p, const std::array<int, 3>& offset) const
  {
    constexpr std::array<std::uint64_t, 3> factors{ 0x9e3779b97f4a7c15U, 0xc2b2ae3d27d4eb4fU,
      0x165667b19e3779f9U };
    std::uint64_t key = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double place = std::floor(p[k] / this->Edge) + offset[k];
      key += factors[k] * static_cast<std::uint64_t>(static_cast<std::int64_t>(place));
    }
    return key;
  }
};

/// For each point: the largest error of a point q that is no farther away than twice that error.
std::vector<double> LargestWithinReach(
  const View<Point3>& points, const std::vector<double>& errors)
{
  std::map<int, ErrorCubes> sizes;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    if (errors[p] > 0.0)
    {
      const int size = std::ilogb(errors[p]) + 2;
      ErrorCubes& cubes =
        sizes.try_emplace(size, ErrorCubes{ std::ldexp(1.0, size) }).first->second;
      cubes.Points[cubes.GetKey(points[p], {})].push_back(p);
    }
  }
  for (auto& [size, cubes] : sizes)
  {
    for (auto& [key, cube] : cubes.Points)
    {
      std::sort(cube.begin(), cube.end(),
        [&errors](std::size_t a, std::size_t b) { return errors[a] > errors[b]; });
    }
  }
  std::vector<double> largest = errors;
  const auto search = [&](std::size_t p, const std::vector<std::size_t>& cube)
  {
    for (const std::size_t q : cube)
    {
      const double e = errors[q];
      if (e <= largest[p])
      {
        return;
      }
      if (Distance(points[p], points[q]) <= 2.0 * e)
      {
        largest[p] = e;
        return;
      }
    }
  };
  ParallelFor(0, static_cast<std::int64_t>(points.size()), 1024,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
      {
        for (auto size = sizes.rbegin(); size != sizes.rend() && largest[p] < size->second.Edge / 2;
             ++size)
        {
          for (int n = 0; n < 27; ++n)
          {
            const auto cube = size->second.Points.find(
              size->second.GetKey(points[p], { n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1 }));
            if (cube != size->second.Points.end())
            {
              search(p, cube->second);
            }
          }
        }
      }
    });
  return largest;
}

}

std::vector<double> SamplingErrors(const SurfaceView& mesh)
{
  std::vector<double> error(mesh.Points.size(), 0.0);
  for (const Triangle& t : mesh.Triangles)
  {
    const double e =
      CornerDistance(mesh.Points[At(t[0])], mesh.Points[At(t[1])], mesh.Points[At(t[2])]);
    for (const std::int64_t p : t)
    {
      error[At(p)] = std::max(error[At(p)], e);
    }
  }
  return LargestWithinReach(mesh.Points, error);
}

double EdgeLengthFor(const SurfaceView& mesh, double points)
{
  double area = 0.0;
  const auto count = static_cast<std::int64_t>(mesh.Points.size());
  for (const Triangle& t : mesh.Triangles)
  {
    // Invalid corners are reported later, by the check of the mesh.
    if (std::any_of(t.begin(), t.end(), [count](auto id) { return id < 0 || id >= count; }))
    {
      continue;
    }
    area += TriangleArea(mesh.Points[At(t[0])], mesh.Points[At(t[1])], mesh.Points[At(t[2])]);
  }
  // A point of a triangular lattice of edge l owns l^2 sqrt(3) / 2.
  return std::sqrt(2.0 * area / (std::sqrt(3.0) * std::max(points, 1.0)));
}

TriangleMesh SplitLongEdges(TriangleMesh mesh, const Limit& limit, std::size_t maximumPoints,
  const ProgressCallback& progress)
{
  double left = 1.0; // the number of rounds is unknown: each takes half of the remaining progress
  for (bool again = true; again;)
  {
    const std::size_t before = mesh.Points.size();
    Midpoints midpoints(mesh.Points);
    std::vector<Triangle> pieces;
    pieces.reserve(mesh.Triangles.size());
    for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
    {
      if (i % (1U << 16) == 0)
      {
        const double done = static_cast<double>(i) / static_cast<double>(mesh.Triangles.size());
        Report(progress, 1.0 - left * (1.0 - 0.5 * done));
      }
      const Triangle& t = mesh.Triangles[i];
      const std::array<std::int64_t, 3> m{ midpoints.Of(t[0], t[1], limit),
        midpoints.Of(t[1], t[2], limit), midpoints.Of(t[2], t[0], limit) };
      AddPieces(mesh.Points, t, m, pieces);
      if (mesh.Points.size() > maximumPoints)
      {
        return {}; // at once, since a round may quadruple the number
      }
    }
    mesh.Triangles = std::move(pieces);
    again = mesh.Points.size() > before;
    left *= 0.5;
  }
  mesh.Points.shrink_to_fit();
  return mesh;
}

// ------------------------------------------------------------------------------------------
// ChokingSamples
namespace
{

/// Number of samples that automatic spacing spreads over a surface, however few points it has.
constexpr double UsualSamples = 20000.0;

/// More would take about 30 GB.
constexpr std::size_t MostSamples = 20'000'000;

/// Fraction of the spacing that three rounds, each finer by 0.6, would still resolve, and half of
/// it.
constexpr double Telling = 0.1;

/// Number of points that refinement may add, besides doubling the existing ones.
constexpr std::size_t MorePoints = 100000;

/// Twice the volume divided by the area of a closed surface: the thickness of a plate, or the
/// radius of a rod.
double ComputeThickness(const SurfaceView& surface)
{
  return 2.0 * std::abs(SignedVolume(surface)) / SurfaceArea(surface);
}

/// Sum of the lengths of all edges of a closed surface.
double LengthOfEdges(const SurfaceView& surface)
{
  double edges = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      edges += 0.5 * Distance(surface.Points[At(t[c])], surface.Points[At(t[(c + 1) % 3])]);
    }
  }
  return edges;
}

}

TriangleMesh Refined(const SurfaceView& mesh, const std::vector<Refinement>& wanted, double spacing,
  double finest, const ProgressCallback& progress)
{
  const bool isMany = wanted.size() > ManyPlaces;
  const auto settled = static_cast<std::size_t>(std::count_if(wanted.begin(), wanted.end(),
    [finest](const Refinement& r) { return r.EdgeLength >= finest; }));
  if (isMany && 2 * settled < wanted.size())
  {
    return {};
  }
  const double everywhere = isMany ? 0.6 * spacing : HUGE_VAL;
  return SplitLongEdges(
    CopyMesh(mesh),
    [&wanted, everywhere](const Point3& a, const Point3& b)
    {
      double limit = everywhere;
      if (std::isfinite(everywhere))
      {
        return limit;
      }
      const Point3 middle = 0.5 * (a + b);
      const double half2 = 0.25 * Dot(b - a, b - a);
      for (const Refinement& r : wanted)
      {
        const Point3 d = middle - r.Center;
        const double reach = r.Radius + std::sqrt(half2);
        limit = Dot(d, d) < reach * reach ? std::min(limit, r.EdgeLength) : limit;
      }
      return limit;
    },
    MorePoints + 2 * mesh.Points.size(), progress);
}

TriangleMesh FirstSamples(
  const SurfaceView& surface, double& spacing, const ProgressCallback& progress)
{
  const auto split = [&surface, &spacing](std::size_t most, const ProgressCallback& part)
  {
    return SplitLongEdges(
      CopyMesh(surface), [&spacing](const Point3&, const Point3&) { return spacing; }, most, part);
  };
  const double edges = LengthOfEdges(surface);
  RequireRange("SampleSpacing", spacing, 0.0, LargestLength,
    "It is a length, or 0 to choose it automatically.");
  if (spacing > 0.0 && edges / spacing > 2.0 * static_cast<double>(MostSamples))
  {
    throw std::invalid_argument("A SampleSpacing of " + FormatNumber(spacing) + " needs about " +
      FormatNumber(edges / spacing) + " points along the edges alone, but the limit is " +
      FormatNumber(static_cast<double>(MostSamples)) + ": raise it.");
  }
  // Triangles with edges of that length, equilateral ones at the most, and half as many points.
  const double fewest =
    spacing > 0.0 ? SurfaceArea(surface) / (0.5 * std::sqrt(3.0) * spacing * spacing) : 0.0;
  if (fewest > static_cast<double>(MostSamples))
  {
    throw std::invalid_argument("A SampleSpacing of " + FormatNumber(spacing) + " needs at least " +
      FormatNumber(fewest) + " points, but the limit is " +
      FormatNumber(static_cast<double>(MostSamples)) + ": raise it.");
  }
  if (spacing > 0.0)
  {
    TriangleMesh samples = split(MostSamples, progress);
    if (samples.Points.empty())
    {
      throw std::runtime_error("Sampling the surface this finely needs more than " +
        std::to_string(MostSamples) + " points: raise the sample spacing.");
    }
    return samples;
  }
  // Edges of a good mesh vary around their mean: those up to 1.7 times the mean are not split.
  spacing = 1.7 * EdgeLengthFor(surface, UsualSamples);
  // Needles require far more points than their area suggests. If everything is thinner than refined
  // samples could resolve, refinement is useless.
  const double share = ComputeThickness(surface) < Telling * spacing ? 1.0 : 5.0;
  const std::size_t most =
    4 * surface.Points.size() + static_cast<std::size_t>(share * UsualSamples);
  // Edges are split to this length for triangles of any area: needles have almost none.
  spacing = std::max(spacing, edges / (4.0 * static_cast<double>(most)));
  const auto still = Between(progress, 0.0, 0.0); // quick, but may have to be repeated
  TriangleMesh samples = split(most, still);
  for (; samples.Points.empty(); samples = split(most, still))
  {
    spacing *= 1.5;
  }
  return samples;
}

}
