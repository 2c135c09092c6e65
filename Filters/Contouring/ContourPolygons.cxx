#include "Contouring/ContourPolygons.h"

namespace isthmus
{
namespace
{

using Pair = std::array<std::int64_t, 2>;

Pair Sorted(std::int64_t a, std::int64_t b)
{
  return { std::min(a, b), std::max(a, b) };
}

class Maker
{
public:
  Maker(const UniformContour& contour, const ContourClusters& clusters, bool triangles)
    : Contour(contour)
    , Clusters(clusters)
    , Triangles(triangles)
  {
  }

  /// Points on the faces around what is cut.
  void AddFacePoints(const ContourCuts& cuts)
  {
    for (std::size_t e = 0; e < this->Contour.Edges.size(); ++e)
    {
      if (!cuts.Has(static_cast<std::int64_t>(e)))
      {
        continue;
      }
      const UniformContour::Edge& edge = this->Contour.Edges[e];
      for (std::size_t i = 0; i < 4; ++i)
      {
        const std::int64_t a = edge.Around[i], b = edge.Around[(i + 1) % 4];
        const std::int64_t other = cuts.Beyond(static_cast<std::int64_t>(e), a, b);
        if (other >= 0 && this->FacePoints.count(Sorted(a, b)) == 0)
        {
          const Point3& there = this->Contour.Edges[static_cast<std::size_t>(other)].Crossing;
          this->FacePoints[Sorted(a, b)] = this->AddPoint(0.5 * (edge.Crossing + there));
        }
      }
    }
  }

  void AddPolygon(std::int64_t e)
  {
    const UniformContour::Edge& edge = this->Contour.Edges[static_cast<std::size_t>(e)];
    std::array<std::int64_t, 4> corners{ -1, -1, -1, -1 };
    std::size_t count = 0;
    for (const std::int64_t point : edge.Around)
    {
      const std::int64_t top = this->Clusters.Tops()[static_cast<std::size_t>(point)];
      if (count == 0 || corners[count - 1] != top)
      {
        corners[count++] = top;
      }
    }
    if (count > 1 && corners[0] == corners[count - 1])
    {
      corners[--count] = -1;
    }
    if (count < 3)
    {
      return;
    }
    if (count == 4 && (corners[0] == corners[2] || corners[1] == corners[3]))
    {
      this->Result.Folded.push_back(e);
      return;
    }
    if (!this->FacePoints.empty() && this->AddFan(e, corners, count))
    {
      return;
    }
    if (count == 3 || !this->Triangles)
    {
      this->Add(e, corners);
      return;
    }
    this->AddHalves(e, corners, edge.Normal);
  }

  ContourPolygons Result;

private:
  std::int64_t AddPoint(const Point3& x)
  {
    this->Result.More.push_back(x);
    return this->Clusters.Size() + static_cast<std::int64_t>(this->Result.More.size()) - 1;
  }

  void Add(std::int64_t e, const std::array<std::int64_t, 4>& corners)
  {
    this->Result.Corners.push_back(corners);
    this->Result.Edge.push_back(e);
  }

  /// Triangles around the crossing, if any side has a point of its own.
  bool AddFan(std::int64_t e, const std::array<std::int64_t, 4>& corners, std::size_t count)
  {
    std::vector<std::int64_t> border;
    for (std::size_t i = 0; i < count; ++i)
    {
      border.push_back(corners[i]);
      const auto found = this->FacePoints.find(Sorted(corners[i], corners[(i + 1) % count]));
      if (found != this->FacePoints.end())
      {
        border.push_back(found->second);
      }
    }
    if (border.size() == count)
    {
      return false;
    }
    const std::int64_t middle =
      this->AddPoint(this->Contour.Edges[static_cast<std::size_t>(e)].Crossing);
    for (std::size_t i = 0; i < border.size(); ++i)
    {
      this->Add(e, { middle, border[i], border[(i + 1) % border.size()], -1 });
    }
    return true;
  }

  /// Cosine of the angle between triangle and `normal`; -1 for triangles without area, or so thin
  /// that rounding decides where they face, as of three points on a sharp edge.
  double Agreement(std::int64_t a, std::int64_t b, std::int64_t c, const Point3& normal) const
  {
    const Point3 u = this->Clusters.PointOf(b) - this->Clusters.PointOf(a);
    const Point3 v = this->Clusters.PointOf(c) - this->Clusters.PointOf(a);
    const Point3 n = Cross(u, v);
    const double length = Length(n);
    constexpr double thin = 1e-6;
    return length > thin * (Dot(u, u) + Dot(v, v)) ? Dot(n, normal) / length : -1.0;
  }

  /// How far the middle between two corners is from the planes that the four points are made for.
  double OffPlanes(std::int64_t e, std::int64_t a, std::int64_t b) const
  {
    const Point3 middle = 0.5 * (this->Clusters.PointOf(a) + this->Clusters.PointOf(b));
    double sum = 0.0;
    for (const std::int64_t point : this->Contour.Edges[static_cast<std::size_t>(e)].Around)
    {
      sum += this->Contour.Errors[static_cast<std::size_t>(point)].At(middle);
    }
    return sum;
  }

  /// Are both points of the uniform contour, and on sharp edges?
  bool AreSharp(std::int64_t a, std::int64_t b) const
  {
    const auto isSharp = [this](std::int64_t id)
    { return !this->Clusters.IsCluster(id) && this->Contour.IsSharp[At(id)] != 0; };
    return isSharp(a) && isSharp(b);
  }

  /// Cut along the diagonal that keeps a sharp edge, unless a triangle would then face backwards.
  void AddHalves(std::int64_t e, const std::array<std::int64_t, 4>& q, const Point3& normal)
  {
    const double first = std::min(
      this->Agreement(q[0], q[1], q[2], normal), this->Agreement(q[0], q[2], q[3], normal));
    const double second = std::min(
      this->Agreement(q[1], q[2], q[3], normal), this->Agreement(q[1], q[3], q[0], normal));
    const bool firstIsSharp = this->AreSharp(q[0], q[2]);
    const bool isFirst = !(first > 0.0 && second > 0.0) ? first >= second
      : firstIsSharp != this->AreSharp(q[1], q[3])
      ? firstIsSharp
      : this->OffPlanes(e, q[0], q[2]) <= this->OffPlanes(e, q[1], q[3]);
    const std::size_t turn = isFirst ? 0 : 1;
    this->Add(e, { q[turn], q[turn + 1], q[turn + 2], -1 });
    this->Add(e, { q[turn], q[turn + 2], q[(turn + 3) % 4], -1 });
  }

  const UniformContour& Contour;
  const ContourClusters& Clusters;
  bool Triangles;
  std::map<Pair, std::int64_t> FacePoints;
};

}

ContourCuts::ContourCuts(const UniformContour& contour)
  : IsCut(contour.Edges.size(), 0)
{
  for (std::size_t e = 0; e < contour.Edges.size(); ++e)
  {
    const auto& around = contour.Edges[e].Around;
    for (std::size_t i = 0; i < 4; ++i)
    {
      this->Sides.push_back(
        { Sorted(around[i], around[(i + 1) % 4]), static_cast<std::int64_t>(e) });
    }
  }
  std::sort(this->Sides.begin(), this->Sides.end(),
    [](const Side& a, const Side& b)
    { return a.Points != b.Points ? a.Points < b.Points : a.Edge < b.Edge; });
}

std::int64_t ContourCuts::Beyond(std::int64_t edge, std::int64_t a, std::int64_t b) const
{
  const Pair wanted = Sorted(a, b);
  auto side = std::lower_bound(this->Sides.begin(), this->Sides.end(), wanted,
    [](const Side& s, const Pair& points) { return s.Points < points; });
  for (; side != this->Sides.end() && side->Points == wanted; ++side)
  {
    if (side->Edge != edge)
    {
      return side->Edge;
    }
  }
  return -1;
}

ContourPolygons PolygonsOf(const UniformContour& contour, const ContourClusters& clusters,
  bool triangles, const ContourCuts* cuts)
{
  Maker maker(contour, clusters, triangles);
  if (cuts)
  {
    maker.AddFacePoints(*cuts);
  }
  for (std::size_t e = 0; e < contour.Edges.size(); ++e)
  {
    maker.AddPolygon(static_cast<std::int64_t>(e));
  }
  return std::move(maker.Result);
}

}
