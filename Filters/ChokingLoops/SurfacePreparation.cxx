#include "ChokingLoops/SurfacePreparation.h"

#include "Core/Index.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace isthmus
{
namespace
{

using Limit = std::function<double(const Point3&, const Point3&)>;

/// Largest distance from a point of the triangle to its nearest corner: the circumradius where all
/// angles are acute, else where a bisector of a leg meets the longest side. No triangle has more
/// than the equilateral one on its longest side, however rounding spoils the formula for needles.
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
  // Turn so that edge 0 is the one split (of one), or edge 2 the one whole (of two).
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
  const std::vector<double> own = error;
  for (const Triangle& t : mesh.Triangles)
  {
    const double e = std::max({ own[At(t[0])], own[At(t[1])], own[At(t[2])] });
    for (const std::int64_t p : t)
    {
      error[At(p)] = std::max(error[At(p)], e);
    }
  }
  return error;
}

double EdgeLengthFor(const SurfaceView& mesh, double points)
{
  double area = 0.0;
  const auto count = static_cast<std::int64_t>(mesh.Points.size());
  for (const Triangle& t : mesh.Triangles)
  {
    // Corners that are no points are told by what checks the mesh, later.
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
  double left = 1.0; // nobody knows how many rounds there will be: each takes half of the bar
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
        return {}; // at once: a round may make four times as many
      }
    }
    mesh.Triangles = std::move(pieces);
    again = mesh.Points.size() > before;
    left *= 0.5;
  }
  return mesh;
}

}
