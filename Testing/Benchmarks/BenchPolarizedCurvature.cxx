// vtkPolarizedCurvature beside vtkProbeFilter, which only samples, and vtkBindingSites, on a sphere
// of a million points in a potential of 129^3 nodes.

#include "vtkBindingSites.h"
#include "vtkPolarizedCurvature.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProbeFilter.h>
#include <vtkSphereSource.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <vector>

namespace
{

void AddArray(vtkDataSet* data, const char* name, const std::function<double(const double*)>& f)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfValues(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    array->SetValue(i, f(data->GetPoint(i)));
  }
  data->GetPointData()->AddArray(array);
}

/// A sphere with curvatures that vary and about `points` points.
vtkSmartPointer<vtkPolyData> Surface(int points)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(20.0);
  const int side = static_cast<int>(std::sqrt(points / 2.0));
  source->SetThetaResolution(2 * side);
  source->SetPhiResolution(side);
  source->Update();
  vtkSmartPointer<vtkPolyData> surface = source->GetOutput();
  AddArray(surface, "MaximumCurvature", [](const double* p) { return 0.05 + 0.01 * p[0]; });
  AddArray(surface, "MinimumCurvature",
    [](const double* p) { return std::sin(p[0]) * std::sin(p[1]) - 0.4; });
  return surface;
}

vtkSmartPointer<vtkImageData> Potential()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(129, 129, 129);
  image->SetSpacing(0.5, 0.5, 0.5);
  image->SetOrigin(-32.0, -32.0, -32.0);
  AddArray(image, "Potential", [](const double* p) { return 0.2 * p[0] + std::cos(p[2]); });
  image->GetPointData()->SetActiveScalars("Potential");
  return image;
}

double Seconds(const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void PolarizedAgainstProbe(benchmark::State& state)
{
  const auto surface = Surface(1000000);
  const auto image = Potential();
  vtkNew<vtkPolarizedCurvature> ours;
  ours->SetInputData(surface);
  ours->SetPotentialData(image);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(surface);
  probe->SetSourceData(image);
  std::vector<double> times[2];
  const auto run = [](vtkAlgorithm* filter)
  {
    filter->Modified();
    filter->Update();
  };
  for (auto _ : state)
  {
    times[0].push_back(Seconds([&]() { run(ours); }));
    times[1].push_back(Seconds([&]() { run(probe); }));
    state.SetIterationTime(times[0].back());
  }
  state.counters["ours_s"] = Median(times[0]);
  state.counters["vtkProbeFilter_s"] = Median(times[1]);
  state.counters["ratio"] = Median(times[0]) / Median(times[1]);
}

void Sites(benchmark::State& state)
{
  const auto surface = Surface(static_cast<int>(state.range(0)));
  vtkNew<vtkPolarizedCurvature> products;
  products->SetInputData(surface);
  products->SetPotentialData(Potential());
  products->Update();
  vtkNew<vtkBindingSites> sites;
  sites->SetInputData(products->GetOutput());
  for (auto _ : state)
  {
    sites->Modified();
    sites->Update();
  }
  state.counters["us_per_point"] = benchmark::Counter(static_cast<double>(state.range(0)) * 1e-6,
    benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}

BENCHMARK(PolarizedAgainstProbe)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(5);
BENCHMARK(Sites)
  ->Arg(50000)
  ->Arg(200000)
  ->Unit(benchmark::kMillisecond)
  ->Iterations(3)
  ->UseRealTime();
BENCHMARK_MAIN();
