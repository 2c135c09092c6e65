// Nodes and points per second of the curvature filter, beside the machine's memory bandwidth and
// vtkCurvatures on the same isosurface. Each is the whole filter, allocation of its output
// included. The CPU column counts all threads, so that it is meaningful even on a busy machine.
#include "CopyBandwidth.h"
#include "Core/ParallelFor.h"
#include "FieldImage.h"
#include "vtkHessianCurvature.h"

#include <vtkCurvatures.h>
#include <vtkFlyingEdges3D.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace
{

using isthmus::testing::CenteredCube;
using isthmus::testing::SampledImage;

/// 256^3 floats whose level set 0 has about a million points.
vtkImageData* Map()
{
  static const vtkSmartPointer<vtkImageData> map = SampledImage(
    CenteredCube(256, 1.0),
    [](double x, double y, double z)
    {
      constexpr double w = 10.0; // a gyroid: as folded as a protein
      return std::sin(w * x) * std::cos(w * y) + std::sin(w * y) * std::cos(w * z) +
        std::sin(w * z) * std::cos(w * x);
    },
    VTK_FLOAT);
  return map;
}

vtkPolyData* Isosurface()
{
  static const vtkSmartPointer<vtkPolyData> surface = []()
  {
    vtkNew<vtkFlyingEdges3D> contour;
    contour->SetInputData(Map());
    contour->SetValue(0, 0.0);
    contour->ComputeNormalsOff();
    contour->Update();
    return vtkSmartPointer<vtkPolyData>(contour->GetOutput());
  }();
  return surface;
}

/// Times `filter` alone, without freeing the last output, and counts `places` with
/// `bytes` moved for each. Rates are those of the best run, since others may be disturbed on a
/// shared machine.
void Time(benchmark::State& state, vtkAlgorithm* filter, vtkIdType places, double bytes)
{
  double best = std::numeric_limits<double>::infinity();
  filter->Update(); // first access to memory is slow in a virtual machine
  for (auto _ : state)
  {
    filter->GetOutputDataObject(0)->Initialize();
    filter->Modified();
    const auto start = std::chrono::steady_clock::now();
    filter->Update();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    state.SetIterationTime(seconds.count());
    best = std::min(best, seconds.count());
  }
  const double rate = static_cast<double>(places) / best;
  state.counters["places"] = static_cast<double>(places);
  state.counters["places/s"] = rate;
  state.counters["memory_places/s"] = isthmus::testing::CopyBandwidth() / bytes;
  state.counters["of_bandwidth"] = rate * bytes / isthmus::testing::CopyBandwidth();
  state.counters["threads"] = isthmus::ParallelThreads();
}

/// Six arrays at every node: 4 bytes read, 6 x 4 + 1 written.
void AtNodes(benchmark::State& state)
{
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(Map());
  filter->SetAccuracy(static_cast<int>(state.range(0)));
  filter->AutomaticScaleOff();
  Time(state, filter, Map()->GetNumberOfPoints(), 29.0);
}

/// Six arrays at the isosurface's points: 12 bytes of position read, 25 written.
void AtPoints(benchmark::State& state)
{
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(0, Map());
  filter->SetInputData(1, Isosurface());
  filter->SetAccuracy(static_cast<int>(state.range(0)));
  filter->AutomaticScaleOff();
  Time(state, filter, Isosurface()->GetNumberOfPoints(), 37.0);
}

/// Gaussian (0) or mean (1) curvature of the triangle mesh; the other types warn of every point.
void VtkCurvatures(benchmark::State& state)
{
  vtkNew<vtkCurvatures> filter;
  filter->SetInputData(Isosurface());
  filter->SetCurvatureType(static_cast<int>(state.range(0)));
  Time(state, filter, Isosurface()->GetNumberOfPoints(), 16.0);
}

void Copy(benchmark::State& state)
{
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(isthmus::testing::CopyBandwidth());
  }
  state.counters["bytes/s"] = isthmus::testing::CopyBandwidth();
}

BENCHMARK(Copy)->Iterations(1);
BENCHMARK(AtNodes)
  ->ArgName("accuracy")
  ->Arg(2)
  ->Arg(4)
  ->Unit(benchmark::kMillisecond)
  ->UseManualTime()
  ->MeasureProcessCPUTime();
BENCHMARK(AtPoints)
  ->ArgName("accuracy")
  ->Arg(2)
  ->Arg(4)
  ->Unit(benchmark::kMillisecond)
  ->UseManualTime()
  ->MeasureProcessCPUTime();
BENCHMARK(VtkCurvatures)
  ->ArgName("type")
  ->DenseRange(0, 1)
  ->Unit(benchmark::kMillisecond)
  ->UseManualTime()
  ->MeasureProcessCPUTime();

}

BENCHMARK_MAIN();
