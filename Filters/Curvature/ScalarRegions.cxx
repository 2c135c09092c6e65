#include "Curvature/ScalarRegions.h"

#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

/// A point of a cut triangle: barycentric coordinates without the first, and both scalars.
struct ClippedCorner
{
  double U, V;
  double Value[2];
};

using Polygon = std::vector<ClippedCorner>;

ClippedCorner Between(const ClippedCorner& a, const ClippedCorner& b, double t)
{
  return { a.U + t * (b.U - a.U), a.V + t * (b.V - a.V),
    { a.Value[0] + t * (b.Value[0] - a.Value[0]), a.Value[1] + t * (b.Value[1] - a.Value[1]) } };
}

/// Cuts `polygon` where `scalar` passes `threshold`; the part at or above it goes to `above`.
void Cut(const Polygon& polygon, int scalar, double threshold, Polygon& below, Polygon& above)
{
  below.clear();
  above.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const ClippedCorner& a = polygon[i];
    const ClippedCorner& b = polygon[(i + 1) % polygon.size()];
    const double fa = a.Value[scalar] - threshold;
    const double fb = b.Value[scalar] - threshold;
    (fa < 0.0 ? below : above).push_back(a);
    if ((fa < 0.0) != (fb < 0.0))
    {
      ClippedCorner cut = Between(a, b, fa / (fa - fb));
      cut.Value[scalar] = threshold;
      below.push_back(cut);
      above.push_back(cut);
    }
  }
}

/// Area as a fraction of the triangle's.
double TriangleFraction(const Polygon& polygon)
{
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
  {
    const double u = polygon[i].U - polygon[0].U;
    const double v = polygon[i].V - polygon[0].V;
    twice += u * (polygon[i + 1].V - polygon[0].V) - v * (polygon[i + 1].U - polygon[0].U);
  }
  return twice;
}

struct Table
{
  std::vector<double> Areas;

  Table& operator+=(const Table& other)
  {
    for (std::size_t i = 0; i < this->Areas.size(); ++i)
    {
      this->Areas[i] += other.Areas[i];
    }
    return *this;
  }
};

/// Cuts triangles; its polygons keep their memory from one triangle to the next.
class TriangleCutter
{
public:
  TriangleCutter(const ThresholdedScalar& first, const ThresholdedScalar& second)
    : Scalars{ &first, &second }
  {
  }

  void Add(const Triangle& id, double area, Table& table)
  {
    std::array<std::pair<std::size_t, std::size_t>, 2> range;
    this->Whole.clear();
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const auto point = static_cast<std::size_t>(id[corner]);
      this->Whole.push_back({ corner == 1 ? 1.0 : 0.0, corner == 2 ? 1.0 : 0.0,
        { this->Scalars[0]->Values[point], this->Scalars[1]->Values[point] } });
      for (std::size_t s = 0; s < 2; ++s)
      {
        const std::size_t region = this->Scalars[s]->GetRegion(this->Whole.back().Value[s]);
        range[s] = corner == 0
          ? std::make_pair(region, region)
          : std::make_pair(std::min(range[s].first, region), std::max(range[s].second, region));
      }
    }
    const std::size_t columns = this->Scalars[1]->Regions();
    Peel(this->Whole, 0, range[0],
      [&](const Polygon& strip, std::size_t row)
      {
        Peel(strip, 1, range[1],
          [&](const Polygon& piece, std::size_t column)
          { table.Areas[row * columns + column] += area * TriangleFraction(piece); });
      });
  }

private:
  /// Calls `use(part, region)` for the parts of `polygon` in the regions of a scalar, which are
  /// known to lie in `range`.
  template <typename Use>
  void Peel(
    const Polygon& polygon, int scalar, std::pair<std::size_t, std::size_t> range, Use&& use)
  {
    Polygon& rest = this->Rest[scalar];
    Polygon& below = this->Below[scalar];
    Polygon& above = this->Above[scalar];
    rest = polygon;
    for (std::size_t region = range.first; region < range.second; ++region)
    {
      const double threshold = this->Scalars[static_cast<std::size_t>(scalar)]->Thresholds[region];
      Cut(rest, scalar, threshold, below, above);
      use(below, region);
      std::swap(rest, above);
    }
    use(rest, range.second);
  }

  std::array<const ThresholdedScalar*, 2> Scalars;
  Polygon Whole;
  Polygon Rest[2];
  Polygon Below[2];
  Polygon Above[2];
};

void CheckThresholds(const ThresholdedScalar& scalar)
{
  const auto& t = scalar.Thresholds;
  for (std::size_t i = 0; i < t.size(); ++i)
  {
    RequireThat(std::isfinite(t[i]) && (i == 0 || t[i - 1] < t[i]),
      ("Threshold " + std::to_string(i)).c_str(), t[i],
      "thresholds must be finite and ascending: sort them and remove repeated ones");
  }
}

void CheckValues(const SurfaceView& mesh, const ThresholdedScalar& scalar)
{
  for (const Triangle& corners : mesh.Triangles)
  {
    for (const vtkIdType point : corners)
    {
      if (!std::isfinite(scalar.Values[At(point)]))
      {
        throw std::invalid_argument("The scalar at point " + std::to_string(point) +
          " is not finite: remove the cells around the point first, for example with Threshold.");
      }
    }
  }
}

double ComputeArea(const SurfaceView& mesh, const Triangle& id)
{
  using Position = Eigen::Map<const Eigen::Vector3d>;
  const Position a(mesh.Point(id[0]).data());
  return 0.5 *
    (Position(mesh.Point(id[1]).data()) - a).cross(Position(mesh.Point(id[2]).data()) - a).norm();
}

}

std::size_t ThresholdedScalar::GetRegion(double value) const
{
  const auto above = std::upper_bound(this->Thresholds.begin(), this->Thresholds.end(), value);
  return static_cast<std::size_t>(above - this->Thresholds.begin());
}

std::size_t MiddleRegion(std::size_t a, std::size_t b, std::size_t c)
{
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

std::vector<double> RegionAreas(const SurfaceView& mesh, const ThresholdedScalar& first,
  const ThresholdedScalar& second, AreaRule rule, const ProgressCallback& progress)
{
  RequireChoice("AreaRule", rule, AreaRule::WholeTriangles);
  for (const ThresholdedScalar* scalar : { &first, &second })
  {
    CheckThresholds(*scalar);
    CheckValues(mesh, *scalar);
  }
  const auto regionOf = [](const ThresholdedScalar& scalar, const Triangle& id)
  {
    const auto at = [&](int corner)
    { return scalar.GetRegion(scalar.Values[static_cast<std::size_t>(id[corner])]); };
    return MiddleRegion(at(0), at(1), at(2));
  };
  const Table zero{ std::vector<double>(first.Regions() * second.Regions(), 0.0) };
  const auto work = [&](Table& table, std::int64_t from, std::int64_t to)
  {
    TriangleCutter cutter(first, second);
    for (vtkIdType t = from; t < to; ++t)
    {
      const Triangle& id = mesh.Corners(t);
      const double area = ComputeArea(mesh, id);
      if (rule == AreaRule::Fractional)
      {
        cutter.Add(id, area, table);
      }
      else
      {
        table.Areas[regionOf(first, id) * second.Regions() + regionOf(second, id)] += area;
      }
    }
  };
  return ParallelReduce(mesh.NumberOfTriangles(), 4096, zero, work, progress).Areas;
}

}
