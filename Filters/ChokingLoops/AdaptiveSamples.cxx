#include "ChokingLoops/AdaptiveSamples.h"

#include "Contouring/MapSurface.h"
#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Remeshing/SelfIntersections.h"
#include "Surfaces/TriangleTree.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <numeric>
#include <unordered_map>

namespace isthmus
{
namespace
{

/// How far samples may deviate from the surface, in parts of their spacing: as much as a chord of
/// that length on a sphere of 1.25 times the length.
constexpr double DeviationShare = 0.1;

/// Where edges of M are longer than this part of the wanted spacing, it has no more points to add.
constexpr double AsFine = 0.6;

/// Edges of the first samples, in radii of the largest ball that touches the surface there on
/// either side.
constexpr double SpacingOfThickness = 0.5;

/// The largest thickness that a mesh shows, in lengths of its edges.
constexpr double ThicknessInEdges = 3.0;

/// Cosine of the angle between normals on opposite sides of a ball.
constexpr double Opposite = -0.3;

/// Largest difference of the spacing over a distance, in parts of it.
constexpr double Gradient = 0.3;
constexpr int Sweeps = 2;

/// Number of consecutive points, which are usually near each other, that share a bounding box.
constexpr std::int64_t PointsOfBox = 128;

/// Squared distance between two boxes.
double SquaredGap(const Bounds3& a, const Bounds3& b)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double gap = std::max({ 0.0, a.Min[k] - b.Max[k], b.Min[k] - a.Max[k] });
    sum += gap * gap;
  }
  return sum;
}

}

FineSurface::FineSurface(TriangleMesh surface, double spacing, bool allowCrossings)
  : Surface(std::move(surface))
  , AllowCrossings(allowCrossings)
  , OwnError(SamplingErrors(this->Surface))
  , Size(this->Surface.Points.size(), spacing)
  , Tolerance(this->Surface.Points.size(), DeviationShare * spacing)
  , Making(std::async(std::launch::async,
      [this] { return std::make_unique<SurfaceAdjacency>(SurfaceView(this->Surface)); }))
{
  for (std::size_t i = 0; i < this->Surface.Points.size(); ++i)
  {
    const Point3& p = this->Surface.Points[i];
    if (i % PointsOfBox == 0)
    {
      this->Boxes.push_back({ p, p });
    }
    this->Boxes.back().Add(p);
  }
}

const SurfaceAdjacency& FineSurface::Adjacency() const
{
  if (this->Making.valid())
  {
    this->HalfEdges = this->Making.get();
  }
  return *this->HalfEdges;
}

namespace
{

/// The points in a cube, and the narrowest cone around their mean normal that contains all normals.
struct PointsOfCube
{
  std::vector<std::size_t> Points;
  Point3 Axis{ 0, 0, 0 };
  double Cosine = 1.0; ///< of the cone's angle

  void FindCone(const std::vector<Point3>& normals)
  {
    for (const std::size_t p : this->Points)
    {
      this->Axis = this->Axis + normals[p];
    }
    this->Axis = (1.0 / std::max(Length(this->Axis), 1e-300)) * this->Axis;
    for (const std::size_t p : this->Points)
    {
      this->Cosine = std::min(this->Cosine, Dot(this->Axis, normals[p]));
    }
  }

  /// False if the sum of the cone's angle and that between `normal` and its axis is too small.
  bool MayBeOpposite(const Point3& normal) const
  {
    const double c = std::clamp(Dot(this->Axis, normal), -1.0, 1.0);
    const double sines = std::sqrt((1.0 - c * c) * (1.0 - this->Cosine * this->Cosine));
    return c < -this->Cosine || c * this->Cosine - sines < Opposite + 1e-9;
  }
};

/**
 * For each point of a coarse mesh: the radius of the largest ball on either side that touches the
 * mesh there and contains no point with an opposite normal; at most `most`. The ball through
 * another point q has the radius |q - p|^2 / (2 |n . (q - p)|) (J. Ma, S. W. Bae, S. Choi, "3D
 * medial axis point approximation using nearest neighbors and the normal field", Vis. Comput. 28,
 * 2012).
 */
std::vector<double> Thickness(const TriangleMesh& mesh, double most)
{
  const std::vector<Point3> normal = PointNormals(mesh);
  Bounds3 box{ mesh.Points.front(), mesh.Points.front() };
  for (const Point3& p : mesh.Points)
  {
    box.Add(p);
  }
  // Such a point is at most a diameter away: cubes of that size, those next to each other in a row.
  const double cube = 2.0 * most;
  const auto cell = [&](const Point3& p, std::size_t k)
  { return static_cast<std::int64_t>((p[k] - box.Min[k]) / cube); };
  std::unordered_map<std::int64_t, PointsOfCube> cubes;
  constexpr std::int64_t row = 1 << 20;
  const auto key = [](std::int64_t i, std::int64_t j, std::int64_t k)
  { return (i * row + j) * row + k; };
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    const Point3& p = mesh.Points[i];
    cubes[key(cell(p, 0), cell(p, 1), cell(p, 2))].Points.push_back(i);
  }
  for (auto& [place, points] : cubes)
  {
    points.FindCone(normal);
  }
  std::vector<double> thickness(mesh.Points.size(), most);
  ParallelFor(0, static_cast<std::int64_t>(mesh.Points.size()), 256,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const Point3& p = mesh.Points[i];
        for (std::int64_t n = 0; n < 27; ++n)
        {
          const auto found = cubes.find(
            key(cell(p, 0) + n / 9 - 1, cell(p, 1) + n / 3 % 3 - 1, cell(p, 2) + n % 3 - 1));
          if (found == cubes.end() || !found->second.MayBeOpposite(normal[i]))
          {
            continue;
          }
          for (const std::size_t q : found->second.Points)
          {
            const Point3 d = mesh.Points[q] - p;
            const double square = Dot(d, d);
            if (square < 4.0 * most * most && Dot(normal[i], normal[q]) < Opposite)
            {
              const double height = std::abs(Dot(d, normal[i]));
              const double ball = 0.5 * square / std::max(height, 1e-300);
              thickness[i] = std::min(thickness[i], ball);
            }
          }
        }
      }
    });
  return thickness;
}

}

// On a pyramid of meshes, each with edges twice as long as those of the one before: thin parts are
// measured where the mesh still shows them.
void FineSurface::AdaptToThickness(const ProgressCallback& progress)
{
  TriangleMesh level = this->Surface;
  std::vector<std::size_t> place(level.Points.size());
  std::iota(place.begin(), place.end(), std::size_t{ 0 });
  const double most = this->Size.front() / SpacingOfThickness;
  double edge = EdgeLengthFor(level, static_cast<double>(level.Points.size()));
  while (true)
  {
    const double limit = std::min(most, ThicknessInEdges * edge);
    const std::vector<double> thickness = Thickness(level, limit);
    for (std::size_t p = 0; p < this->Size.size(); ++p)
    {
      const double ball = thickness[place[p]];
      this->Size[p] =
        ball < limit ? std::min(this->Size[p], SpacingOfThickness * ball) : this->Size[p];
    }
    if (limit >= most)
    {
      break;
    }
    Report(progress, edge / most);
    edge *= 2.0;
    const std::vector<double> size(level.Points.size(), 1.5 * edge);
    const std::vector<double> tolerance(level.Points.size(), DeviationShare * edge);
    CoarseSurface coarse = CoarsenSurface(level, size, tolerance, Between(progress, 0.0, 0.0));
    for (std::size_t& p : place)
    {
      p = At(coarse.Mesh.Triangles[At(coarse.Nearest[p])][0]);
    }
    level = std::move(coarse.Mesh);
  }
  this->Grade();
}

// The error at a sample includes those of its neighbours, so that dense samples need dense ones
// around them. Sweeps over the triangles in both directions reach most points at once.
void FineSurface::Grade()
{
  const auto limit = [this](const Triangle& t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t a = At(t[k]), b = At(t[(k + 1) % 3]);
      const double step = Gradient * Distance(this->Surface.Points[a], this->Surface.Points[b]);
      this->Size[a] = std::min(this->Size[a], this->Size[b] + step);
      this->Size[b] = std::min(this->Size[b], this->Size[a] + step);
    }
  };
  for (int sweep = 0; sweep < Sweeps; ++sweep)
  {
    std::for_each(this->Surface.Triangles.begin(), this->Surface.Triangles.end(), limit);
    std::for_each(this->Surface.Triangles.rbegin(), this->Surface.Triangles.rend(), limit);
  }
  for (std::size_t p = 0; p < this->Size.size(); ++p)
  {
    this->Tolerance[p] = std::min(this->Tolerance[p], DeviationShare * this->Size[p]);
  }
}

// Where sheets are so close that coarse ones cross, the samples become denser; in the last round
// all points near such places are samples, and the surface itself does not cross.
CoarseSurface FineSurface::Coarse(const ProgressCallback& progress)
{
  for (const double finer : { 0.5, 0.25, 1e-9 })
  {
    CoarseSurface coarse = CoarsenSurface(this->Surface, this->Size, this->Tolerance, progress);
    if (this->AllowCrossings)
    {
      return coarse;
    }
    const std::vector<std::int64_t> crossing = SelfIntersections(coarse.Mesh, progress);
    if (crossing.empty())
    {
      return coarse;
    }
    std::vector<char> isNear(coarse.Mesh.Points.size(), 0);
    for (const std::int64_t t : crossing)
    {
      for (const vtkIdType p : coarse.Mesh.Triangles[At(t)])
      {
        isNear[At(p)] = 1;
      }
    }
    for (std::size_t p = 0; p < this->Size.size(); ++p)
    {
      const Triangle& t = coarse.Mesh.Triangles[At(coarse.Nearest[p])];
      if (isNear[At(t[0])] || isNear[At(t[1])] || isNear[At(t[2])])
      {
        this->Size[p] *= finer;
        this->Tolerance[p] *= finer;
      }
    }
  }
  return CoarsenSurface(this->Surface, this->Size, this->Tolerance, progress);
}

SurfaceSamples FineSurface::Sample(const ProgressCallback& progress)
{
  if (!this->IsAdapted)
  {
    this->AdaptToThickness(Between(progress, 0.0, 0.5));
    this->IsAdapted = true;
  }
  CoarseSurface coarse = this->Coarse(Between(progress, 0.5, 1.0));
  SurfaceSamples samples;
  samples.Mesh = std::move(coarse.Mesh);
  samples.Errors.Deviation = std::move(coarse.Deviation);
  samples.Origin.assign(coarse.Origin.begin(), coarse.Origin.end());
  samples.Errors.Point = SamplingErrors(samples.Mesh);
  std::vector<double> own(samples.Mesh.Points.size(), 0.0);
  for (std::size_t p = 0; p < this->OwnError.size(); ++p)
  {
    // The points that are samples have their errors already.
    const Triangle& t = samples.Mesh.Triangles[At(coarse.Nearest[p])];
    const bool isSample = std::any_of(t.begin(), t.end(),
      [&](vtkIdType corner) { return coarse.Origin[At(corner)] == static_cast<std::int64_t>(p); });
    for (const vtkIdType corner : t)
    {
      if (isSample)
      {
        break;
      }
      own[At(corner)] = std::max(own[At(corner)], this->OwnError[p]);
    }
  }
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    samples.Errors.Point[i] = std::hypot(samples.Errors.Point[i], own[i]);
  }
  return samples;
}

bool FineSurface::Refine(const std::vector<Refinement>& wanted)
{
  std::atomic<bool> isFiner{ false };
  const auto work = [&](std::size_t box)
  {
    std::vector<Refinement> near;
    std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(near),
      [&](const Refinement& r) {
        return SquaredGap(this->Boxes[box], { r.Center, r.Center }) < r.Radius * r.Radius;
      });
    const std::size_t end = std::min((box + 1) * PointsOfBox, this->Size.size());
    for (std::size_t i = box * PointsOfBox; i < end && !near.empty(); ++i)
    {
      const bool hasMore = this->OwnError[i] * std::sqrt(3.0) < AsFine * this->Size[i];
      for (const Refinement& r : near)
      {
        const Point3 d = this->Surface.Points[i] - r.Center;
        if (Dot(d, d) < r.Radius * r.Radius)
        {
          isFiner = isFiner ||
            (hasMore && (r.EdgeLength < this->Size[i] || r.Deviation < this->Tolerance[i]));
          this->Size[i] = std::min(this->Size[i], r.EdgeLength);
          this->Tolerance[i] =
            std::min({ this->Tolerance[i], r.Deviation, DeviationShare * r.EdgeLength });
        }
      }
    }
  };
  ParallelFor(0, static_cast<std::int64_t>(this->Boxes.size()), 4,
    [&work](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t box = begin; box < end; ++box)
      {
        work(At(box));
      }
    });
  this->Grade();
  return isFiner;
}

std::vector<std::pair<double, SimplexId>> FineSurface::PointsNear(
  const std::vector<Point3>& path, double radius) const
{
  Bounds3 box{ path.front(), path.front() };
  for (const Point3& p : path)
  {
    box.Add(p);
  }
  const double most = radius * radius;
  std::vector<std::pair<double, SimplexId>> near;
  std::vector<std::pair<Point3, Point3>> segments; // near the points of a box
  for (std::size_t k = 0; k < this->Boxes.size(); ++k)
  {
    if (!(SquaredGap(this->Boxes[k], box) < most))
    {
      continue;
    }
    segments.clear();
    for (std::size_t j = 0; j < path.size(); ++j)
    {
      const Point3& from = path[j > 0 ? j - 1 : 0];
      Bounds3 segment{ from, from };
      segment.Add(path[j]);
      if (SquaredGap(this->Boxes[k], segment) < most)
      {
        segments.emplace_back(from, path[j]);
      }
    }
    const std::size_t end = std::min((k + 1) * PointsOfBox, this->Surface.Points.size());
    for (std::size_t i = k * PointsOfBox; i < end && !segments.empty(); ++i)
    {
      const Point3& p = this->Surface.Points[i];
      double square = HUGE_VAL;
      for (const auto& [from, to] : segments)
      {
        square = std::min(square, SquaredDistanceToSegment(p, from, to));
      }
      if (square < most)
      {
        near.emplace_back(std::sqrt(square), static_cast<SimplexId>(i));
      }
    }
  }
  std::sort(near.begin(), near.end());
  return near;
}

}
