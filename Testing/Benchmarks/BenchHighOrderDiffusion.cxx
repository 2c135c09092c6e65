// Voxels per second and step of the diffusion filters, beside vtkImageAnisotropicDiffusion3D, ITK
// and the machine's memory bandwidth in the same run; super time stepping against forward Euler.
#include "CopyBandwidth.h"
#include "Core/ParallelFor.h"
#include "Imaging/HighOrderDiffusion.h"
#include "vtkDenoiseMap.h"
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

#ifdef ISTHMUS_HAS_ITK
#include "ITKPeer.h"
#endif

#include <chrono>
#include <cmath>
#include <random>
#include <vector>

#include <sys/resource.h>

namespace
{

using isthmus::DiffusionParameters;

/// Balls with noise of the same amplitude, n^3 floats. Only the last requested size is cached.
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

/// Voxels per second and evaluation, and the ratio to vtkImageAnisotropicDiffusion3D, which runs
/// first. `bytes` must cross memory for each voxel of an evaluation.
void Report(benchmark::State& state, int n, double evaluations, double seconds, double bytes)
{
  static double peer = 0.0;
  const double rate =
    std::pow(n, 3) * evaluations * static_cast<double>(state.iterations()) / seconds;
  peer = peer > 0.0 ? peer : rate;
  state.counters["voxels/s"] = rate;
  state.counters["times_VTK"] = rate / peer;
  state.counters["of_bandwidth"] = rate * bytes / isthmus::testing::CopyBandwidth();
  state.counters["copy_voxels/s"] = isthmus::testing::CopyBandwidth() / 8.0;
  state.counters["copy_GB/s"] = isthmus::testing::CopyBandwidth() * 1e-9;
  state.counters["threads"] = isthmus::ParallelThreads();
}

class Clock
{
public:
  double Seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

/// The baseline with ParaView's default settings.
void VTKAnisotropicDiffusion(benchmark::State& state)
{
  constexpr int iterations = 5;
  const int n = static_cast<int>(state.range(0));
  vtkNew<vtkImageAnisotropicDiffusion3D> filter;
  filter->SetInputData(Map(n));
  filter->SetNumberOfIterations(iterations);
  const Clock clock;
  for (auto _ : state)
  {
    filter->Modified();
    filter->Update();
  }
  Report(state, n, iterations, clock.Seconds(), 8.0);
}

#ifdef ISTHMUS_HAS_ITK
/// A filter of ITK with its default number of threads, for five steps.
template <typename MakeFilter>
void ByITK(benchmark::State& state, MakeFilter makeFilter)
{
  constexpr int iterations = 5;
  const int n = static_cast<int>(state.range(0));
  const auto image = isthmus::peers::ITKView(static_cast<float*>(Map(n)->GetScalarPointer()), n);
  const auto filter = makeFilter();
  const Clock clock;
  for (auto _ : state)
  {
    isthmus::peers::RunITK(filter, image, iterations);
  }
  Report(state, n, iterations, clock.Seconds(), 8.0);
}

void ITKEdgeStopping(benchmark::State& state)
{
  ByITK(state, isthmus::peers::ITKEdgeStopping);
}

void ITKGeometricFlow(benchmark::State& state)
{
  ByITK(state, isthmus::peers::ITKGeometricFlow);
}
#else
void ITKEdgeStopping(benchmark::State& state)
{
  state.SkipWithError("missing: libinsighttoolkit5-dev");
}

void ITKGeometricFlow(benchmark::State& state)
{
  state.SkipWithError("missing: libinsighttoolkit5-dev");
}
#endif

/// Steps of one kind, on the algorithm: the only allocation is that of the volumes of a run.
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
  const Clock clock;
  for (auto _ : state)
  {
    const auto report = isthmus::Diffuse<float>(grid, parameters, values.data(), nullptr, nullptr);
    evaluations = static_cast<double>(report.Evaluations);
  }
  // Explicit: u read and written. Super: u, the stage before, the first values, the first rate and
  // the coefficient read, a stage written.
  Report(state, n, evaluations, clock.Seconds(), euler ? 8.0 : 24.0);
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

/// The whole filter with its defaults; memory is the increase of the process's peak.
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
  // Zero if an earlier benchmark of this process used more: run alone with --benchmark_filter.
  state.counters["volumes"] = (peak() - before) / (4.0 * std::pow(n, 3));
  state.counters["threads"] = isthmus::ParallelThreads();
}

}

BENCHMARK(VTKAnisotropicDiffusion)->Arg(256)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(ITKEdgeStopping)->Arg(256)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(ITKGeometricFlow)->Arg(256)->UseRealTime()->Unit(benchmark::kMillisecond);
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
  ->ArgsProduct({ { 128, 256, 512 }, { 0, 1 } })
  ->ArgsProduct({ { 256 }, { 2, 3 } })
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK(ReachEndTime)
  ->ArgsProduct({ { 64 }, { 0, 1 }, { 5, 20, 100 } })
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(Default, vtkDenoiseMap)->Arg(256)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(Default, vtkDiffusionHighPass)
  ->Arg(256)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(Default, vtkPDETransform)
  ->Arg(256)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
