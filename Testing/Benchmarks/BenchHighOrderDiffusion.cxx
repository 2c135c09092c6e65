// Voxels a second and step of the diffusion filters, beside vtkImageAnisotropicDiffusion3D and the
// machine's memory bandwidth in the same run; super time stepping against forward Euler.
#include "HighOrderDiffusion.h"
#include "ParallelFor.h"
#include "vtkDiffusionHighPass.h"
#include "vtkHighOrderDiffusion.h"
#include "vtkPDETransform.h"

#include <vtkFieldData.h>
#include <vtkImageAnisotropicDiffusion3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include <sys/resource.h>

namespace
{

using isthmus::DiffusionParameters;

/// Balls in noise as strong as they are, n^3 floats. Only the last size asked for is kept.
vtkImageData* Map(int n)
{
  static vtkSmartPointer<vtkImageData> map;
  if (!map || map->GetDimensions()[0] != n)
  {
    map = vtkSmartPointer<vtkImageData>::New();
    map->SetDimensions(n, n, n);
    map->AllocateScalars(VTK_FLOAT, 1);
    auto* values = static_cast<float*>(map->GetScalarPointer());
    std::minstd_rand random(1);
    std::normal_distribution<float> noise(0.0f, 0.4f);
    for (int k = 0; k < n; ++k)
    {
      for (int j = 0; j < n; ++j)
      {
        for (int i = 0; i < n; ++i)
        {
          const int x = i % 32 - 16, y = j % 32 - 16, z = k % 32 - 16;
          *values++ = (x * x + y * y + z * z < 100 ? 1.0f : 0.0f) + noise(random);
        }
      }
    }
  }
  return map;
}

/// Bytes a second, read plus written, of the best of several parallel copies of 256 MB.
double CopyBandwidth()
{
  static const double bandwidth = []()
  {
    constexpr std::int64_t bytes = 256 << 20;
    const std::vector<char> from(bytes, 1);
    std::vector<char> to(bytes, 2);
    double best = 0.0;
    for (int n = 0; n < 10; ++n)
    {
      const auto start = std::chrono::steady_clock::now();
      isthmus::ParallelFor(0, bytes, 1 << 20,
        [&](std::int64_t first, std::int64_t last) {
          std::memcpy(
            to.data() + first, from.data() + first, static_cast<std::size_t>(last - first));
        });
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      best = std::max(best, 2.0 * static_cast<double>(bytes) / seconds.count());
    }
    return best;
  }();
  return bandwidth;
}

void Report(benchmark::State& state, int n, double evaluations)
{
  const double voxels = std::pow(n, 3) * evaluations * static_cast<double>(state.iterations());
  state.counters["voxels/s"] = benchmark::Counter(voxels, benchmark::Counter::kIsRate);
  state.counters["copy_GB/s"] = CopyBandwidth() * 1e-9;
  state.counters["threads"] = isthmus::ParallelThreads();
}

/// The baseline, as a ParaView user has it.
void VTKAnisotropicDiffusion(benchmark::State& state)
{
  constexpr int iterations = 5;
  const int n = static_cast<int>(state.range(0));
  vtkNew<vtkImageAnisotropicDiffusion3D> filter;
  filter->SetInputData(Map(n));
  filter->SetNumberOfIterations(iterations);
  for (auto _ : state)
  {
    filter->Modified();
    filter->Update();
  }
  Report(state, n, iterations);
}

/// Steps of one kind, on the algorithm: no allocation but that of the volumes of a run.
void Steps(benchmark::State& state, DiffusionParameters parameters)
{
  const int n = static_cast<int>(state.range(0));
  isthmus::DiffusionGrid<float> grid;
  grid.Dimensions = { n, n, n };
  const auto* input = static_cast<const float*>(Map(n)->GetScalarPointer());
  std::vector<float> values(input, input + grid.Size());
  parameters.Order = static_cast<int>(state.range(1));
  parameters.Sigma = 0.5;
  const double limit = isthmus::ExplicitStepLimit(parameters, grid.Spacing);
  const bool euler = parameters.Integrator == DiffusionParameters::IntegratorType::ForwardEuler;
  parameters.Steps = euler ? 20 : 1;
  parameters.Time = euler ? 18 * limit : 100 * limit; // 20 explicit steps, or 21 stages
  double evaluations = 0.0;
  for (auto _ : state)
  {
    const auto report = isthmus::Diffuse<float>(grid, parameters, values.data(), nullptr, nullptr);
    evaluations = static_cast<double>(report.Evaluations);
  }
  Report(state, n, evaluations);
}

void ExplicitEdgeStopping(benchmark::State& state)
{
  DiffusionParameters parameters;
  parameters.Integrator = DiffusionParameters::IntegratorType::ForwardEuler;
  Steps(state, parameters);
}

void ExplicitGeometricFlow(benchmark::State& state)
{
  DiffusionParameters parameters;
  parameters.Integrator = DiffusionParameters::IntegratorType::ForwardEuler;
  parameters.Flow = DiffusionParameters::FlowType::GeometricFlow;
  Steps(state, parameters);
}

void SuperStages(benchmark::State& state)
{
  Steps(state, DiffusionParameters());
}

/// The same end time by both integrators: range(1) is the integrator, range(2) the time.
void ReachEndTime(benchmark::State& state)
{
  const int n = static_cast<int>(state.range(0));
  vtkNew<vtkHighOrderDiffusion> filter;
  filter->SetInputData(Map(n));
  filter->AutomaticOff();
  filter->SetOrder(1);
  filter->SetSigma(0.5);
  filter->SetPreSmoothing(1.0);
  filter->SetIntegrator(static_cast<int>(state.range(1)));
  filter->SetTime(static_cast<double>(state.range(2)));
  for (auto _ : state)
  {
    filter->Modified();
    filter->Update();
  }
}

/// The whole filter with its defaults; memory is the process's peak beyond what it held before.
template <typename Filter>
void Default(benchmark::State& state)
{
  const int n = static_cast<int>(state.range(0));
  auto peak = []()
  {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024.0;
  };
  vtkImageData* const map = Map(n);
  const double before = peak();
  vtkNew<Filter> filter;
  filter->SetInputData(map);
  for (auto _ : state)
  {
    filter->GetOutputDataObject(0)->Initialize();
    filter->Modified();
    filter->Update();
  }
  // Zero where an earlier benchmark of this process held more: run alone with --benchmark_filter.
  state.counters["volumes"] = (peak() - before) / (4.0 * std::pow(n, 3));
  state.counters["threads"] = isthmus::ParallelThreads();
}

}

BENCHMARK(VTKAnisotropicDiffusion)->Arg(256)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(ExplicitEdgeStopping)
  ->ArgsProduct({ { 128, 256, 512 }, { 0, 1 } })
  ->ArgsProduct({ { 256 }, { 2, 3 } })
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK(ExplicitGeometricFlow)
  ->ArgsProduct({ { 256 }, { 0, 1 } })
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK(SuperStages)
  ->ArgsProduct({ { 256 }, { 0, 1, 2, 3 } })
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK(ReachEndTime)
  ->ArgsProduct({ { 64 }, { 0, 1 }, { 5, 20, 100 } })
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(Default, vtkHighOrderDiffusion)
  ->Arg(256)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(Default, vtkDiffusionHighPass)
  ->Arg(256)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(Default, vtkPDETransform)
  ->Arg(256)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
