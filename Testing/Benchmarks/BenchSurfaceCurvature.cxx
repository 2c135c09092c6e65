// Curvature of a million triangles beside vtkCurvatures, and the areas between thresholds.

#include "Curvature/ScalarRegions.h"
#include "Curvature/SurfaceCurvature.h"
#include "SurfaceModels.h"
#include "Surfaces/SurfaceMeasures.h"

#include <benchmark/benchmark.h>

#include <vtkCurvatures.h>
#include <vtkNew.h>

namespace
{

using namespace isthmus;

const isthmus::testing::Model& Mesh()
{
  static const isthmus::testing::Model made = isthmus::testing::Torus(1000, 500, 2.0, 0.7);
  return made;
}

void Count(benchmark::State& state)
{
  const auto points = static_cast<std::int64_t>(Mesh().Points.size());
  state.SetItemsProcessed(state.iterations() * points);
}

void Curvature(benchmark::State& state, CurvatureEstimate estimate, CurvatureNeighbourhood where)
{
  SurfaceCurvatureOptions options;
  options.Method = estimate;
  options.Neighbourhood = where;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(ComputeSurfaceCurvature(Mesh().View(), options));
  }
  Count(state);
}

void VTKCurvatures(benchmark::State& state, int type)
{
  const auto surface = isthmus::testing::ToPolyData(Mesh());
  for (auto _ : state)
  {
    vtkNew<vtkCurvatures> filter;
    filter->SetInputData(surface);
    filter->SetCurvatureType(type);
    filter->Update();
  }
  Count(state);
}

void Measures(benchmark::State& state)
{
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(MeasureSurface(Mesh().View()));
  }
  Count(state);
}

void Regions(benchmark::State& state, AreaRule rule)
{
  ThresholdedScalar x, y;
  x.Thresholds = y.Thresholds = { -0.5, 0.0, 0.5 };
  for (const auto& p : Mesh().Points)
  {
    x.Values.push_back(p[0]);
    y.Values.push_back(p[1]);
  }
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(RegionAreas(Mesh().View(), x, y, rule));
  }
  Count(state);
}

}

BENCHMARK_CAPTURE(
  Curvature, angle_defect, CurvatureEstimate::AngleDefect, CurvatureNeighbourhood::OneRing)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(
  Curvature, tensor_one_ring, CurvatureEstimate::EdgeTensor, CurvatureNeighbourhood::OneRing)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(
  Curvature, tensor_ball, CurvatureEstimate::EdgeTensor, CurvatureNeighbourhood::Ball)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(
  Curvature, tensor_disc, CurvatureEstimate::EdgeTensor, CurvatureNeighbourhood::GeodesicDisc)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(
  Curvature, normal_fit, CurvatureEstimate::NormalFit, CurvatureNeighbourhood::OneRing)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(VTKCurvatures, gauss, VTK_CURVATURE_GAUSS)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(VTKCurvatures, mean, VTK_CURVATURE_MEAN)->Unit(benchmark::kMillisecond);
BENCHMARK(Measures)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(Regions, fractional, AreaRule::Fractional)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(Regions, whole_triangles, AreaRule::WholeTriangles)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->MeasureProcessCPUTime();

BENCHMARK_MAIN();
