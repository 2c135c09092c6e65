#include "Tetrahedra/MeshQuality.h"

#include "Core/Geometry.h"
#include "Core/Index.h"
#include "Core/InvertedCells.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Core/UnitScale.h"

#include <algorithm>
#include <mutex>
#include <stdexcept>

namespace isthmus
{
namespace
{

constexpr int MostBins = 1'000'000;
constexpr double Degrees = 180.0 / Pi;

/// Angle of two vectors in degrees, exact near 0 and 180 too.
double Angle(const Point3& u, const Point3& v)
{
  return Degrees * std::atan2(Length(Cross(u, v)), Dot(u, v));
}

/// The power of two that brings the longest of these edges to between 1/2 and 1; 1 for none.
/// Fourth powers of lengths are computed below: those of 1e100 overflow, those of 1e-100 are 0.
double PowerOfTwoFor(std::initializer_list<Point3> edges)
{
  double largest = 0.0;
  for (const Point3& edge : edges)
  {
    for (const double x : edge)
    {
      largest = std::max(largest, std::abs(x));
    }
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1.0, -exponent);
}

/// A cell's angles, three or six of them, beside its measures.
template <std::size_t N>
struct Measured
{
  CellAngles Cell;
  std::array<double, N> Angles{};

  void TakeExtremes()
  {
    this->Cell.Smallest = *std::min_element(this->Angles.begin(), this->Angles.end());
    this->Cell.Largest = *std::max_element(this->Angles.begin(), this->Angles.end());
  }
};

Measured<3> Measure(const std::array<Point3, 3>& p)
{
  Measured<3> result;
  const double scale = PowerOfTwoFor({ p[1] - p[0], p[2] - p[0], p[2] - p[1] });
  const Point3 u = scale * (p[1] - p[0]), v = scale * (p[2] - p[0]), w = scale * (p[2] - p[1]);
  const double area = 0.5 * Length(Cross(u, v));
  const double a = Length(u), b = Length(v), c = Length(w);
  result.Cell.Size = area / scale / scale;
  if (area > 0.0)
  {
    result.Angles = { Angle(u, v), Angle(-1.0 * u, w), Angle(-1.0 * v, -1.0 * w) };
    result.TakeExtremes();
    result.Cell.RadiusEdge = a * b * c / (4.0 * area) / std::min({ a, b, c });
  }
  return result;
}

Measured<6> Measure(std::array<Point3, 4> p)
{
  Measured<6> result;
  const double scale = PowerOfTwoFor({ p[1] - p[0], p[2] - p[0], p[3] - p[0] });
  p = { Point3{}, scale * (p[1] - p[0]), scale * (p[2] - p[0]), scale * (p[3] - p[0]) };
  const Point3 u = p[1] - p[0], v = p[2] - p[0], w = p[3] - p[0];
  const double six = Dot(Cross(u, v), w);
  result.Cell.Size = six / 6.0 / scale / scale / scale;
  if (six == 0.0)
  {
    return result;
  }
  constexpr std::size_t edges[6][4] = { { 0, 1, 2, 3 }, { 0, 2, 3, 1 }, { 0, 3, 1, 2 },
    { 1, 2, 0, 3 }, { 1, 3, 2, 0 }, { 2, 3, 0, 1 } };
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < 6; ++e)
  {
    const Point3& from = p[edges[e][0]];
    const Point3 edge = p[edges[e][1]] - from;
    shortest = std::min(shortest, Length(edge));
    // Both faces' normals, square to the edge, have the dihedral angle between them.
    result.Angles[e] =
      Angle(Cross(edge, p[edges[e][2]] - from), Cross(edge, p[edges[e][3]] - from));
  }
  result.TakeExtremes();
  const Point3 center = Dot(w, w) * Cross(u, v) + Dot(v, v) * Cross(w, u) + Dot(u, u) * Cross(v, w);
  result.Cell.RadiusEdge = Length(center) / (2.0 * std::abs(six)) / shortest;
  return result;
}

template <std::size_t Corners>
QualitySummary MeasureAll(const View<Point3>& points,
  const View<std::array<vtkIdType, Corners>>& cells, int bins, std::vector<CellAngles>& measures,
  const ProgressCallback& progress, const View<unsigned char>& ghosts)
{
  RequireRange("NumberOfBins", bins, 1, MostBins, "It is the number of columns of the histogram.");
  const UnitScale range(points); // refuses values whose products overflow
  measures.resize(cells.size());
  QualitySummary summary;
  summary.Bins.assign(static_cast<std::size_t>(bins), 0);
  std::mutex mutex;
  const auto counted = [&ghosts](std::size_t cell) { return ghosts.empty() || ghosts[cell] == 0; };
  ParallelFor(
    0, static_cast<std::int64_t>(cells.size()), 8192,
    [&](std::int64_t first, std::int64_t last)
    {
      std::vector<std::int64_t> counts(summary.Bins.size());
      for (std::int64_t i = first; i < last; ++i)
      {
        std::array<Point3, Corners> p;
        for (std::size_t c = 0; c < Corners; ++c)
        {
          p[c] = points[static_cast<std::size_t>(cells[static_cast<std::size_t>(i)][c])];
        }
        const auto measured = Measure(p);
        measures[static_cast<std::size_t>(i)] = measured.Cell;
        for (const double angle : measured.Angles)
        {
          counts[static_cast<std::size_t>(std::clamp(
            static_cast<int>(angle / 180.0 * bins), 0, bins - 1))] += counted(At(i)) ? 1 : 0;
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      for (std::size_t b = 0; b < counts.size(); ++b)
      {
        summary.Bins[b] += counts[b];
      }
    },
    progress);
  InvertedCells orientation;
  // In order, so that the sum is the same on any number of threads.
  for (std::size_t i = 0; i < measures.size(); ++i)
  {
    if (!counted(i))
    {
      continue;
    }
    const CellAngles& cell = measures[i];
    summary.SmallestAngle = std::min(summary.SmallestAngle, cell.Smallest);
    summary.LargestAngle = std::max(summary.LargestAngle, cell.Largest);
    summary.LargestRadiusEdge = std::max(summary.LargestRadiusEdge, cell.RadiusEdge);
    orientation.Add(static_cast<vtkIdType>(i), cell.Size);
    summary.Slivers += Corners == 4 && cell.Smallest < 5.0 ? 1 : 0;
    ++summary.Cells;
  }
  summary.TotalSize = orientation.Volume();
  summary.Inverted = orientation.Count();
  summary.InvertedCellsMessage = orientation.Message();
  return summary;
}

}

CellAngles MeasureTriangle(const Point3& a, const Point3& b, const Point3& c)
{
  return Measure(std::array<Point3, 3>{ a, b, c }).Cell;
}

CellAngles MeasureTetrahedron(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
{
  return Measure(std::array<Point3, 4>{ a, b, c, d }).Cell;
}

QualitySummary MeasureQuality(const SurfaceView& surface, int bins, std::vector<CellAngles>& cells,
  const ProgressCallback& progress, const View<unsigned char>& ghosts)
{
  return MeasureAll<3>(surface.Points, surface.Triangles, bins, cells, progress, ghosts);
}

QualitySummary MeasureQuality(const std::vector<Point3>& points,
  const std::vector<Tetrahedron>& tetrahedra, int bins, std::vector<CellAngles>& cells,
  const ProgressCallback& progress, const View<unsigned char>& ghosts)
{
  return MeasureAll<4>(points, tetrahedra, bins, cells, progress, ghosts);
}

}
