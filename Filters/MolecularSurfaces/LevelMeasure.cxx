#include "MolecularSurfaces/LevelMeasure.h"

#include "Core/Geometry.h"
#include "Core/ParallelFor.h"

#include <array>
#include <cmath>

namespace isthmus
{
namespace
{

/// Adds a triangle, oriented along `outward`.
void Add(
  LevelMeasure& sum, const Point3& a, const Point3& b, const Point3& c, const Point3& outward)
{
  const Point3 normal = Cross(b - a, c - a);
  const double volume = Dot(a, normal) / 6.0;
  sum.Area += 0.5 * Length(normal);
  sum.Volume += Dot(normal, outward) >= 0.0 ? volume : -volume;
}

struct Corner
{
  Point3 Place;
  double Value;
};

Point3 Crossing(const Corner& a, const Corner& b)
{
  const double t = a.Value / (a.Value - b.Value);
  Point3 at;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    at[axis] = a.Place[axis] + t * (b.Place[axis] - a.Place[axis]);
  }
  return at;
}

void AddTetrahedron(LevelMeasure& sum, const std::array<const Corner*, 4>& corners)
{
  std::array<const Corner*, 4> sorted{}; // inside ones first
  std::size_t inside = 0;
  std::size_t outside = 4;
  for (const Corner* corner : corners)
  {
    sorted[corner->Value <= 0.0 ? inside++ : --outside] = corner;
  }
  if (inside == 0 || inside == 4)
  {
    return;
  }
  const Point3 outward = sorted[3]->Place - sorted[0]->Place;
  if (inside == 2)
  {
    const Point3 a = Crossing(*sorted[0], *sorted[2]);
    const Point3 b = Crossing(*sorted[0], *sorted[3]);
    const Point3 c = Crossing(*sorted[1], *sorted[3]);
    const Point3 d = Crossing(*sorted[1], *sorted[2]);
    Add(sum, a, b, c, outward);
    Add(sum, a, c, d, outward);
    return;
  }
  const std::size_t lone = inside == 1 ? 0 : 3;
  std::array<Point3, 3> at;
  for (std::size_t i = 0; i < 3; ++i)
  {
    at[i] = Crossing(*sorted[lone], *sorted[(lone + 1 + i) % 4]);
  }
  Add(sum, at[0], at[1], at[2], outward);
}

/// The cell between `node`, at `place`, and the next nodes along all axes.
void AddCell(LevelMeasure& sum, const FlowField& field, std::int64_t node, const Point3& place)
{
  const float* at = field.Distance.data() + node;
  const std::int64_t row = field.Grid.Row();
  const std::int64_t plane = field.Grid.Plane();
  std::array<Corner, 8> corners;
  bool inside = false;
  bool outside = false;
  for (std::size_t c = 0; c < 8; ++c)
  {
    const std::int64_t x = c & 1;
    const std::int64_t y = c >> 1 & 1;
    const std::int64_t z = c >> 2;
    const float value = at[x + row * y + plane * z];
    corners[c] = { { place[0] + static_cast<double>(x), place[1] + static_cast<double>(y),
                     place[2] + static_cast<double>(z) },
      static_cast<double>(value) };
    (value <= 0.0F ? inside : outside) = true;
  }
  if (!inside || !outside)
  {
    return;
  }
  // Paths from corner 0 to 7, one axis after the other.
  constexpr std::size_t steps[6][2] = { { 1, 3 }, { 1, 5 }, { 2, 3 }, { 2, 6 }, { 4, 5 },
    { 4, 6 } };
  for (const auto& step : steps)
  {
    AddTetrahedron(sum, { &corners[0], &corners[step[0]], &corners[step[1]], &corners[7] });
  }
}

void AddRun(LevelMeasure& sum, const FlowField& field, const ChunkRun& run)
{
  const auto& n = field.Grid.Dimensions();
  const std::int64_t i = run.First % n[0];
  const std::int64_t j = run.First / n[0] % n[1];
  const std::int64_t k = run.First / field.Grid.Plane();
  const std::array<std::int64_t, 3> middle{ n[0] / 2, n[1] / 2, n[2] / 2 };
  Point3 place{ static_cast<double>(i - middle[0]), static_cast<double>(j - middle[1]),
    static_cast<double>(k - middle[2]) };
  for (std::int64_t node = run.First; node < run.First + run.Nodes; ++node)
  {
    // Distances change by about one from node to node.
    if (std::abs(field.Distance[static_cast<std::size_t>(node)]) < 3.0F)
    {
      AddCell(sum, field, node, place);
    }
    place[0] += 1.0;
  }
}

}

LevelMeasure MeasureLevel(const FlowField& field)
{
  LevelMeasure sum =
    ParallelReduce(static_cast<std::int64_t>(field.Runs.size()), 1024, LevelMeasure(),
      [&](LevelMeasure& partial, std::int64_t first, std::int64_t last)
      {
        for (std::int64_t r = first; r < last; ++r)
        {
          AddRun(partial, field, field.Runs[static_cast<std::size_t>(r)]);
        }
      });
  const double h = field.Grid.Spacing();
  sum.Area *= h * h;
  sum.Volume *= h * h * h;
  return sum;
}

}
