// Dual contouring beside flying edges and the Delaunay isosurface, in one table: triangles,
// smallest and largest angle, distance of the points to the true surface, how much of the sharp
// edges is kept within 0.05 spacings, time. Sets: a ball (smooth) and a turned cube (sharp), each
// as the signed distance on n^3 nodes and, for dual contouring, as crossings and normals. Run by
// hand.

#include "Contouring/DualContouring.h"
#include "Core/PolyDataTriangles.h"
#include "Surfaces/HausdorffDistance.h"
#include "Tetrahedra/MeshQuality.h"
#include "vtkDelaunayIsosurface.h"
#include "vtkDualContouring.h"

#include <vtkDoubleArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <benchmark/benchmark.h>

#include <cmath>

using namespace isthmus;

namespace
{

const double Half = 0.55; // of the cube's side
const double Radius = 0.7;

Point3 Rotate(const Point3& p)
{
  const double c = std::cos(0.4), s = std::sin(0.4);
  const Point3 q{ c * p[0] - s * p[1], s * p[0] + c * p[1], p[2] };
  return { q[0], c * q[1] - s * q[2], s * q[1] + c * q[2] };
}

/// Signed distances, negative inside.
double BallDistance(const Point3& p)
{
  return std::sqrt(Dot(p, p)) - Radius;
}

double CubeDistance(const Point3& p)
{
  const Point3 q = Rotate(p);
  double outside = 0.0, inside = -1e300;
  for (const double x : q)
  {
    const double d = std::abs(x) - Half;
    outside += d > 0.0 ? d * d : 0.0;
    inside = std::max(inside, d);
  }
  return inside > 0.0 ? std::sqrt(outside) : inside;
}

using Distance = double (*)(const Point3&);

vtkSmartPointer<vtkImageData> SampleImage(int n, Distance distance)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const double h = 2.0 / (n - 1);
  image->SetDimensions(n, n, n);
  image->SetSpacing(h, h, h);
  image->SetOrigin(-1, -1, -1);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Distance");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    Point3 p;
    image->GetPoint(i, p.data());
    values->SetValue(i, -distance(p));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// Points on the edges of the cube, as triangles without size.
TriangleMesh CubeEdges()
{
  TriangleMesh edges;
  const auto back = [](const Point3& q)
  {
    const double c = std::cos(0.4), s = std::sin(0.4);
    const Point3 r{ q[0], c * q[1] + s * q[2], -s * q[1] + c * q[2] };
    return Point3{ c * r[0] + s * r[1], -s * r[0] + c * r[1], r[2] };
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const double u : { -Half, Half })
    {
      for (const double v : { -Half, Half })
      {
        for (int i = 0; i < 400; ++i)
        {
          Point3 q;
          q[axis] = Half * (2.0 * (i + 0.5) / 400.0 - 1.0);
          q[(axis + 1) % 3] = u;
          q[(axis + 2) % 3] = v;
          const auto id = static_cast<std::int64_t>(edges.Points.size());
          edges.Points.push_back(back(q));
          edges.Triangles.push_back({ id, id, id });
        }
      }
    }
  }
  return edges;
}

void ReportCounters(benchmark::State& state, const TriangleMesh& mesh, Distance distance, double h)
{
  std::vector<CellAngles> cells;
  const QualitySummary quality = MeasureQuality(mesh, 18, cells);
  double off = 0.0;
  for (const Triangle& t : mesh.Triangles)
  {
    for (const std::int64_t id : t)
    {
      off = std::max(off, std::abs(distance(mesh.Points[static_cast<std::size_t>(id)])));
    }
  }
  state.counters["triangles"] = static_cast<double>(mesh.Triangles.size());
  state.counters["smallest"] = quality.SmallestAngle;
  state.counters["largest"] = quality.LargestAngle;
  state.counters["off/h"] = off / h;
  if (distance == CubeDistance)
  {
    static const TriangleMesh edges = CubeEdges();
    const auto far = TrianglesFartherThan(edges, mesh, 0.05 * h).size();
    state.counters["edges%"] =
      100.0 - 100.0 * static_cast<double>(far) / static_cast<double>(edges.Triangles.size());
  }
}

template <typename Filter, typename Change>
void Run(benchmark::State& state, Distance distance, const Change& change)
{
  const auto n = static_cast<int>(state.range(0));
  const auto image = SampleImage(n, distance);
  vtkNew<Filter> filter;
  filter->SetInputData(image);
  change(filter.Get());
  for (auto _ : state)
  {
    filter->Modified();
    filter->Update();
  }
  ReportCounters(state, ToTriangleMesh(filter->GetOutput()), distance, 2.0 / (n - 1));
}

void FlyingEdges(benchmark::State& state, Distance distance)
{
  Run<vtkFlyingEdges3D>(state, distance,
    [](vtkFlyingEdges3D* f)
    {
      f->SetValue(0, 0.0);
      f->ComputeNormalsOff();
    });
}

void Delaunay(benchmark::State& state, Distance distance)
{
  Run<vtkDelaunayIsosurface>(state, distance, [](vtkDelaunayIsosurface* f) { f->SetLevel(0.0); });
}

/// range(1): tolerance in thousandths of a spacing.
void DualOfVolume(benchmark::State& state, Distance distance)
{
  const double h = 2.0 / static_cast<double>(state.range(0) - 1);
  Run<vtkDualContouring>(state, distance,
    [&](vtkDualContouring* f) { f->SetTolerance(1e-3 * static_cast<double>(state.range(1)) * h); });
}

/// Exact crossings and normals of the distance.
HermiteGrid MakeHermiteGrid(std::int64_t n, Distance distance)
{
  HermiteGrid grid;
  const double h = 2.0 / static_cast<double>(n - 1);
  grid.Shape = { { n, n, n }, { h, h, h } };
  const std::array<std::int64_t, 3> stride{ 1, n, n * n };
  const auto at = [&](std::int64_t i)
  {
    return Point3{ h * static_cast<double>(i % n) - 1.0, h * static_cast<double>(i / n % n) - 1.0,
      h * static_cast<double>(i / n / n) - 1.0 };
  };
  for (std::int64_t i = 0; i < n * n * n; ++i)
  {
    grid.Inside.push_back(distance(at(i)) < 0.0 ? 1 : 0);
  }
  for (std::int64_t i = 0; i < n * n * n; ++i)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      if (i / stride[a] % n + 1 == n ||
        grid.Inside[static_cast<std::size_t>(i)] ==
          grid.Inside[static_cast<std::size_t>(i + stride[a])])
      {
        continue;
      }
      const Point3 from = at(i), along = at(i + stride[a]) - from;
      double low = 0.0, high = 1.0;
      for (int halving = 0; halving < 50; ++halving)
      {
        const double middle = 0.5 * (low + high);
        const bool isInside = distance(from + middle * along) < 0.0;
        (isInside == (grid.Inside[static_cast<std::size_t>(i)] != 0) ? low : high) = middle;
      }
      Point3 normal;
      for (std::size_t b = 0; b < 3; ++b)
      {
        Point3 up = from + low * along, down = up;
        up[b] += 1e-6;
        down[b] -= 1e-6;
        normal[b] = distance(up) - distance(down);
      }
      normal = (1.0 / std::sqrt(Dot(normal, normal))) * normal;
      grid.Crossings.push_back({ i, static_cast<int>(a), low, normal });
    }
  }
  return grid;
}

/// range(1): tolerance as above; range(2): 1 free of crossings, 2 with a reach of 1.
void DualOfCrossings(benchmark::State& state, Distance distance)
{
  const HermiteGrid grid = MakeHermiteGrid(state.range(0), distance);
  const double h = grid.Shape.Spacing[0];
  DualContouringParameters parameters;
  parameters.Tolerance = 1e-3 * static_cast<double>(state.range(1)) * h;
  parameters.FreeOfCrossings = state.range(2) == 1;
  parameters.Reach = state.range(2) == 2 ? 1.0 : 0.0;
  DualContour contour;
  for (auto _ : state)
  {
    contour = DualContouring(grid, parameters);
  }
  TriangleMesh mesh;
  for (const Point3& p : contour.Points)
  {
    mesh.Points.push_back(p - Point3{ 1.0, 1.0, 1.0 });
  }
  for (const auto& q : contour.Polygons)
  {
    mesh.Triangles.push_back({ q[0], q[1], q[2] });
  }
  ReportCounters(state, mesh, distance, h);
}

}

#define ISTHMUS_ROWS(NAME, DISTANCE)                                                               \
  BENCHMARK_CAPTURE(FlyingEdges, NAME, DISTANCE)->Arg(65)->Unit(benchmark::kMillisecond);          \
  BENCHMARK_CAPTURE(Delaunay, NAME, DISTANCE)->Arg(65)->Unit(benchmark::kMillisecond);             \
  BENCHMARK_CAPTURE(DualOfVolume, NAME, DISTANCE)                                                  \
    ->Args({ 65, 0 })                                                                              \
    ->Args({ 65, 50 })                                                                             \
    ->Unit(benchmark::kMillisecond);                                                               \
  BENCHMARK_CAPTURE(DualOfCrossings, NAME, DISTANCE)                                               \
    ->Args({ 65, 0, 0 })                                                                           \
    ->Args({ 65, 50, 0 })                                                                          \
    ->Args({ 65, 50, 1 })                                                                          \
    ->Args({ 65, 0, 2 })                                                                           \
    ->Args({ 65, 50, 2 })                                                                          \
    ->Unit(benchmark::kMillisecond)

ISTHMUS_ROWS(Ball, BallDistance);
ISTHMUS_ROWS(Cube, CubeDistance);

BENCHMARK_MAIN();
