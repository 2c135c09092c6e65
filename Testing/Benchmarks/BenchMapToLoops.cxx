// From a density map to its choking loops with the default parameters, by stage, on one thread and
// on more: EMD-5170 and EMD-5043 on more nodes, and a phantom with noise. Run by hand.
//
// Only VTK classes of the modules are used, so that an older library can be measured beside it; one
// without the automatic level gets it as ISTHMUS_BENCH_LEVEL.

#include "PeakMemory.h"
#include "vtkChokingLoops.h"
#include "vtkDenoiseMap.h"
#include "vtkMRCMapReader.h"
#include "vtkMapSurface.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkImageResize.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <benchmark/benchmark.h>

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <stdexcept>
#include <string>

namespace
{

using isthmus::testing::PeakMemory;
using isthmus::testing::ResetPeakMemory;

enum Map
{
  EMD5170,
  EMD5043,
  Phantom
};

/// The map of a file, by trilinear interpolation on n^3 nodes.
vtkSmartPointer<vtkImageData> ResampleMap(const std::string& name, int n)
{
  const char* folder = std::getenv("ISTHMUS_DATA_DIR");
  vtkNew<vtkMRCMapReader> reader;
  reader->SetFileName(((folder ? std::string(folder) : ".") + "/maps/" + name).c_str());
  reader->Update();
  vtkImageData* const map = reader->GetOutput();
  if (map->GetNumberOfPoints() == 0)
  {
    throw std::runtime_error("ISTHMUS_DATA_DIR has no maps/" + name);
  }
  vtkNew<vtkImageResize> resize; // its bounds stay the same
  resize->SetInputConnection(reader->GetOutputPort());
  resize->SetOutputDimensions(n, n, n);
  resize->Update();
  return resize->GetOutput();
}

/// Distance to a frame of 54 rods along the edges of 8 cubes: genus 28.
double DistanceToFrame(const std::array<double, 3>& p, double first, double pitch)
{
  std::array<double, 3> toPlane{}, beyond{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double nearest = std::clamp(std::round((p[k] - first) / pitch), 0.0, 2.0);
    toPlane[k] = p[k] - (first + pitch * nearest);
    beyond[k] = std::max({ 0.0, first - p[k], p[k] - (first + 2.0 * pitch) });
  }
  double least = HUGE_VAL;
  for (std::size_t k = 0; k < 3; ++k)
  {
    least = std::min(
      least, std::hypot(beyond[k], std::hypot(toPlane[(k + 1) % 3], toPlane[(k + 2) % 3])));
  }
  return least;
}

/// About a normal deviate, of the number of a node (splitmix64).
double NoiseAt(std::uint64_t node)
{
  double sum = 0.0;
  for (std::uint64_t k = 1; k <= 4; ++k)
  {
    std::uint64_t z = 4 * node + k;
    z = (z + 0x9e3779b97f4a7c15ULL) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    sum += static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53 - 0.5;
  }
  return sum * std::sqrt(3.0); // of four variances of 1/12
}

/// Rods of radius n/42 with an edge of about three voxels, from 0 to 1, and noise of 0.05.
vtkSmartPointer<vtkImageData> NoisyFrame(int n)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  vtkNew<vtkFloatArray> values;
  values->SetName("Density");
  values->SetNumberOfValues(image->GetNumberOfPoints());
  const double radius = n / 42.0, first = 0.12 * n, pitch = 0.38 * n;
  vtkSMPTools::For(0, n,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin * n * n; i < end * n * n; ++i)
      {
        const std::array<double, 3> p{ static_cast<double>(i % n), static_cast<double>(i / n % n),
          static_cast<double>(i / n / n) };
        const double outside = DistanceToFrame(p, first, pitch) - radius;
        values->SetValue(i,
          static_cast<float>(1.0 / (1.0 + std::exp(outside / 0.75)) +
            0.05 * NoiseAt(static_cast<std::uint64_t>(i))));
      }
    });
  image->GetPointData()->SetScalars(values);
  return image;
}

vtkSmartPointer<vtkImageData> Load(std::int64_t map, int n)
{
  return map == Phantom ? NoisyFrame(n)
                        : ResampleMap(map == EMD5170 ? "emd_5170.map" : "emd_5043.map", n);
}

/// EMD-5043 on n^3 nodes, with noise of half its standard deviation.
vtkSmartPointer<vtkImageData> NoisyMap(int n)
{
  auto image = ResampleMap("emd_5043.map", n);
  auto* const values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  float* const value = values->GetPointer(0);
  const vtkIdType count = values->GetNumberOfValues();
  double sum = 0.0, squares = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    sum += static_cast<double>(value[i]);
    squares += static_cast<double>(value[i]) * static_cast<double>(value[i]);
  }
  const double mean = sum / static_cast<double>(count);
  const double deviation = std::sqrt(squares / static_cast<double>(count) - mean * mean);
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        value[i] += static_cast<float>(0.5 * deviation * NoiseAt(static_cast<std::uint64_t>(i)));
      }
    });
  return image;
}

/// CPU time of this process and of finished TetGen processes.
double ProcessorSeconds()
{
  double seconds = 0.0;
  for (const int who : { RUSAGE_SELF, RUSAGE_CHILDREN })
  {
    rusage used{};
    getrusage(who, &used);
    seconds += static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
      1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
  }
  return seconds;
}

double Now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Arguments: the map, nodes along each axis, threads (0: all).
void MapToLoops(benchmark::State& state)
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_ERROR);
  vtkSMPTools::Initialize(static_cast<int>(state.range(2)));
  const auto image = Load(state.range(0), static_cast<int>(state.range(1)));
  for (auto _ : state)
  {
    vtkNew<vtkMapSurface> contour;
    contour->SetInputData(image);
    vtkNew<vtkChokingLoops> filter;
    filter->SetInputConnection(contour->GetOutputPort());
    if (const char* level = std::getenv("ISTHMUS_BENCH_LEVEL"))
    {
      contour->SetLevel(std::atof(level));
    }
    ResetPeakMemory();
    const double before = PeakMemory(), started = Now(), used = ProcessorSeconds();
    filter->Update();
    const double took = Now() - started;
    const double* const stage = filter->GetStageTimes();
    auto* const loops = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
    vtkPolyData* const surface = contour->GetOutput();
    const auto points = static_cast<double>(surface->GetNumberOfPoints());
    state.counters["1_check"] = stage[0];
    state.counters["2_sampling"] = stage[1];
    state.counters["3_filtration"] = stage[2];
    state.counters["4_pairing"] = stage[3];
    state.counters["5_features"] = stage[4];
    state.counters["6_contour_and_drawing"] = took - std::accumulate(stage, stage + 5, 0.0);
    state.counters["seconds"] = took;
    state.counters["cpu_s"] = ProcessorSeconds() - used;
    state.counters["points"] = points;
    state.counters["loops"] = static_cast<double>(loops->GetNumberOfCells());
    state.counters["peak_GB"] = PeakMemory() / 1e9;
    state.counters["bytes_a_point"] = (PeakMemory() - before) / points;
    if (loops->GetNumberOfCells() == 0)
    {
      state.SkipWithError("no loops");
    }
  }
}

/// Arguments: nodes along each axis, threads (0: all). Volumes: peak without the program and the
/// image, in floats.
void Denoise(benchmark::State& state)
{
  vtkSMPTools::Initialize(static_cast<int>(state.range(1)));
  const auto image = NoisyMap(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    vtkNew<vtkDenoiseMap> filter;
    filter->SetInputData(image);
    ResetPeakMemory();
    const double before = PeakMemory(), started = Now(), used = ProcessorSeconds();
    filter->Update();
    state.counters["seconds"] = Now() - started;
    state.counters["cpu_s"] = ProcessorSeconds() - used;
    state.counters["peak_GB"] = PeakMemory() / 1e9;
    state.counters["volumes"] =
      (PeakMemory() - before) / (4.0 * static_cast<double>(image->GetNumberOfPoints()));
  }
}
BENCHMARK(Denoise)
  ->ArgsProduct({ { 256, 512, 800 }, { 1, 0 } })
  ->Iterations(1)
  ->UseRealTime()
  ->Unit(benchmark::kSecond);

#define MAP(map, nodes, threads) Args({ map, nodes, threads })->Iterations(1)->UseRealTime()
BENCHMARK(MapToLoops)
  ->MAP(EMD5170, 200, 1)
  ->MAP(EMD5170, 200, 0)
  ->MAP(EMD5170, 400, 1)
  ->MAP(EMD5170, 400, 0)
  ->MAP(EMD5043, 100, 0)
  ->MAP(EMD5043, 512, 1)
  ->MAP(EMD5043, 512, 0)
  ->MAP(EMD5043, 800, 0)
  ->MAP(Phantom, 512, 1)
  ->MAP(Phantom, 512, 0)
  ->Unit(benchmark::kSecond);
#undef MAP

}

BENCHMARK_MAIN();
