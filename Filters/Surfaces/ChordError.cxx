#include "Surfaces/ChordError.h"

#include "Core/ParallelFor.h"

#include <array>
#include <cmath>

namespace isthmus
{
namespace
{

constexpr double CosineOfSharpEdge = 0.5; // 60 degrees
constexpr double ShiftOfPoints = 0.6;     // of the mean height above the triangles
constexpr double ShareOfSums = 2.5;       // for functions with more shift, and sharp edges
constexpr double ShareOfVolumes = 0.3;    // of the sum without signs
constexpr double ShareOfAreas = 0.5;      // of the area beyond the triangles
constexpr vtkIdType largestStar = 200;    // beyond, all triangles count alike

/// Normals times twice the areas.
std::vector<Point3> ComputeNormals(const SurfaceView& mesh)
{
  std::vector<Point3> normals(mesh.Triangles.size());
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const Triangle& c = mesh.Corners(t);
    normals[static_cast<std::size_t>(t)] =
      Cross(mesh.Point(c[1]) - mesh.Point(c[0]), mesh.Point(c[2]) - mesh.Point(c[0]));
  }
  return normals;
}

Point3 Unit(const Point3& v)
{
  const double length = Length(v);
  return length > 0.0 ? (1.0 / length) * v : v;
}

/// The normal of the surface at `point` as seen from triangle `t`.
Point3 CornerNormal(
  const std::vector<Point3>& normals, const TriangleStars& stars, vtkIdType point, vtkIdType t)
{
  const Point3& own = normals[static_cast<std::size_t>(t)];
  const bool areMany = stars.Size(point) > largestStar;
  Point3 sum{ 0, 0, 0 };
  for (vtkIdType i = 0; i < stars.Size(point); ++i)
  {
    const Point3& normal = normals[stars.Triangles(point)[i].Index()];
    if (areMany || Dot(normal, own) > CosineOfSharpEdge * Length(normal) * Length(own))
    {
      sum = sum + normal;
    }
  }
  return Unit(sum);
}

/// The space between a triangle and the surface.
struct Gap
{
  double Volume = 0.0; ///< positive where the surface lies on the side of the normal
  double Area = 0.0;
};

Gap MeasureGap(const SurfaceView& mesh, const std::vector<Point3>& normals,
  const TriangleStars& stars, vtkIdType t)
{
  const Triangle& corner = mesh.Corners(t);
  const Point3& normal = normals[static_cast<std::size_t>(t)];
  const double twiceArea = Length(normal);
  if (!(twiceArea > 0.0))
  {
    return {};
  }
  std::array<Point3, 3> at, slope; // corners; gradients of the barycentric coordinates
  std::array<double, 3> bend{};    // of the edge opposite to a corner
  std::array<Point3, 3> up;
  for (std::size_t k = 0; k < 3; ++k)
  {
    at[k] = mesh.Point(corner[k]);
    up[k] = CornerNormal(normals, stars, corner[k], t);
  }
  Gap gap;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    bend[k] = Dot(up[j] - up[i], at[j] - at[i]);
    slope[k] = (1.0 / (twiceArea * twiceArea)) * Cross(normal, at[j] - at[i]);
    gap.Volume += twiceArea / 48.0 * bend[k];
  }
  for (std::size_t m = 0; m < 3; ++m) // the midpoints of the edges: exact for squares
  {
    Point3 gradient{ 0, 0, 0 };
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const double weightOfI = i == m ? 0.0 : 0.5, weightOfJ = j == m ? 0.0 : 0.5;
      gradient = gradient + 0.5 * bend[k] * (weightOfI * slope[j] + weightOfJ * slope[i]);
    }
    gap.Area += 0.5 * Dot(gradient, gradient) * twiceArea / 6.0;
  }
  return gap;
}

/// The points moved along their normals by the share ShiftOfPoints of the mean height around them.
std::vector<Point3> MovePoints(const SurfaceView& mesh, const std::vector<Point3>& normals,
  const TriangleStars& stars, const std::vector<Gap>& gaps)
{
  std::vector<Point3> points(mesh.Points.begin(), mesh.Points.end());
  ParallelFor(0, mesh.NumberOfPoints(), 4096,
    [&](std::int64_t first, std::int64_t last)
    {
      for (vtkIdType p = first; p < last; ++p)
      {
        Point3 sum{ 0, 0, 0 };
        double volume = 0.0, area = 0.0;
        for (vtkIdType i = 0; i < stars.Size(p); ++i)
        {
          const std::size_t t = stars.Triangles(p)[i].Index();
          sum = sum + normals[t];
          volume += gaps[t].Volume;
          area += 0.5 * Length(normals[t]);
        }
        Point3& point = points[static_cast<std::size_t>(p)];
        point = area > 0.0 ? point + (ShiftOfPoints * volume / area) * Unit(sum) : point;
      }
    });
  return points;
}

}

std::vector<ChordError> EstimateChordErrors(const SurfaceView& mesh, const TriangleStars& stars,
  const std::vector<vtkIdType>& componentOf, vtkIdType count)
{
  const std::vector<Point3> normals = ComputeNormals(mesh);
  std::vector<Gap> gaps(mesh.Triangles.size());
  ParallelFor(0, mesh.NumberOfTriangles(), 4096,
    [&](std::int64_t first, std::int64_t last)
    {
      for (vtkIdType t = first; t < last; ++t)
      {
        gaps[static_cast<std::size_t>(t)] = MeasureGap(mesh, normals, stars, t);
      }
    });
  const std::vector<Point3> moved = MovePoints(mesh, normals, stars, gaps);
  const std::vector<Point3> after = ComputeNormals({ moved, mesh.Triangles });
  struct Sums
  {
    double Volume = 0.0, AbsoluteVolume = 0.0, Area = 0.0, MovedArea = 0.0;
  };
  std::vector<Sums> sums(static_cast<std::size_t>(count));
  for (std::size_t t = 0; t < gaps.size(); ++t)
  {
    const auto point = static_cast<std::size_t>(mesh.Triangles[t][0]);
    Sums& sum = sums[static_cast<std::size_t>(componentOf[point])];
    sum.Volume += gaps[t].Volume;
    sum.AbsoluteVolume += std::abs(gaps[t].Volume);
    sum.Area += gaps[t].Area;
    sum.MovedArea += 0.5 * (Length(after[t]) - Length(normals[t]));
  }
  std::vector<ChordError> errors;
  errors.reserve(sums.size());
  for (const Sums& sum : sums)
  {
    errors.push_back({ ShareOfSums * std::abs(sum.Area + sum.MovedArea) + ShareOfAreas * sum.Area,
      ShareOfSums * std::abs(sum.Volume) + ShareOfVolumes * sum.AbsoluteVolume });
  }
  return errors;
}

}
