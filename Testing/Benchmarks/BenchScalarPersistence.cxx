// Persistence of volumes beside GUDHI in the same run: time, ratio, peak memory per node, and
// whether the pairs are equal; two threads beside one; 512^3 waves; every shared map under 128^3.
//
// Times are CPU seconds of one thread (ours) and of the process (GUDHI), so that a busy machine
// shows in them as little as possible. Run with --benchmark_filter=Gudhi for the table alone.

#include "CubicalPersistence.h"

#include "CubicalPeer.h"
#include "PeakMemory.h"
#include "SharedData.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMRCMapReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <benchmark/benchmark.h>

#include <malloc.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace isthmus;
using namespace isthmus::testing;

struct Volume
{
  std::array<std::int64_t, 3> Dimensions{ 0, 0, 0 };
  std::vector<float> Values;

  VolumeView View() const { return VolumeView(this->Values.data(), this->Dimensions); }
};

template <typename Function>
Volume Fill(std::int64_t n, Function&& f)
{
  Volume volume{ { n, n, n }, {} };
  volume.Values.reserve(static_cast<std::size_t>(n * n * n));
  for (std::int64_t k = 0; k < n; ++k)
  {
    for (std::int64_t j = 0; j < n; ++j)
    {
      for (std::int64_t i = 0; i < n; ++i)
      {
        volume.Values.push_back(static_cast<float>(
          f(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k))));
      }
    }
  }
  return volume;
}

double Wave(double x, double y, double z)
{
  return std::sin(0.31 * x) * std::cos(0.23 * y) + std::sin(0.17 * y + 1.0) * std::cos(0.29 * z) +
    std::sin(0.27 * z) * std::cos(0.19 * x + 0.5);
}

Volume AtomDistance(std::int64_t n)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0.0, static_cast<double>(n));
  std::vector<std::array<double, 3>> atoms(2000);
  for (auto& atom : atoms)
  {
    for (double& x : atom)
    {
      x = place(random);
    }
  }
  Volume volume = Fill(n, [n](double, double, double) { return 2.0 * static_cast<double>(n); });
  constexpr std::int64_t reach = 24;
  for (const auto& atom : atoms)
  {
    const auto low = [&](std::size_t a)
    { return std::max<std::int64_t>(0, static_cast<std::int64_t>(atom[a]) - reach); };
    const auto high = [&](std::size_t a)
    { return std::min<std::int64_t>(n - 1, static_cast<std::int64_t>(atom[a]) + reach); };
    for (std::int64_t k = low(2); k <= high(2); ++k)
    {
      for (std::int64_t j = low(1); j <= high(1); ++j)
      {
        for (std::int64_t i = low(0); i <= high(0); ++i)
        {
          const double d = std::hypot(static_cast<double>(i) - atom[0],
            static_cast<double>(j) - atom[1], static_cast<double>(k) - atom[2]);
          float& value = volume.Values[static_cast<std::size_t>(i + n * (j + n * k))];
          value = std::min(value, static_cast<float>(d));
        }
      }
    }
  }
  return volume;
}

Volume MapOf(const std::filesystem::path& path)
{
  vtkNew<vtkMRCMapReader> reader;
  reader->SetFileName(path.string().c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const int* n = image->GetDimensions();
  Volume map{ { n[0], n[1], n[2] }, {} };
  for (vtkIdType i = 0; scalars && i < scalars->GetNumberOfTuples(); ++i)
  {
    map.Values.push_back(static_cast<float>(scalars->GetComponent(i, 0)));
  }
  return map;
}

Volume Make(const std::string& name)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  if (name == "waves")
  {
    return Fill(128, Wave);
  }
  if (name == "distance")
  {
    return AtomDistance(128);
  }
  if (name == "plateaus")
  {
    return Fill(128, [](double x, double y, double z) { return std::floor(4.0 * Wave(x, y, z)); });
  }
  if (name == "mask")
  {
    return Fill(128, [](double x, double y, double z) { return Wave(x, y, z) > 0.3 ? 1.0 : 0.0; });
  }
  if (name == "noise")
  {
    return Fill(96, [&](double, double, double) { return value(random); });
  }
  return MapOf(SharedDataFolder() / "maps/emd_5043.map");
}

template <typename Work>
double CPUSeconds(Work&& work)
{
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double PeakOver(double before)
{
  return PeakMemory() - before;
}

/// Resident now, as the peak just after it was reset. What was freed goes back first, or the next
/// one would use it unseen.
double MemoryNow()
{
  malloc_trim(0);
  ResetPeakMemory();
  return PeakMemory();
}

void BesideGudhi(benchmark::State& state, const std::string& name, bool superlevel)
{
  const Volume volume = Make(name);
  const auto nodes = static_cast<double>(volume.Values.size());
  for (auto _ : state)
  {
    CubicalParameters parameters;
    parameters.Superlevel = superlevel;
    double before = MemoryNow();
    std::size_t pairs = 0;
    double ours = 0.0;
    vtkSMPTools::LocalScope(vtkSMPTools::Config(1, std::string("STDThread"), false),
      [&]
      {
        ours =
          CPUSeconds([&] { pairs = CubicalPersistence(volume.View(), parameters).Pairs.size(); });
      });
    state.counters["bytes/node"] = PeakOver(before) / nodes;
    state.counters["ours s"] = ours;
    state.counters["pairs"] = static_cast<double>(pairs);
#if ISTHMUS_HAS_GUDHI_CUBICAL
    before = MemoryNow();
    Bars theirs;
    const double peer = CPUSeconds([&] { theirs = BarsOfGudhi(volume.View(), superlevel); });
    state.counters["GUDHI bytes/node"] = PeakOver(before) / nodes;
    state.counters["GUDHI s"] = peer;
    state.counters["ratio"] = ours / peer;
    state.counters["equal"] = BarsOf(volume.View(), superlevel) == theirs ? 1.0 : 0.0;
#endif
  }
}

/// All shared maps under 128^3, both signs: how many have equal pairs, of how many.
void SharedMapsBesideGudhi(benchmark::State& state)
{
  for (auto _ : state)
  {
    int equal = 0;
    int all = 0;
#if ISTHMUS_HAS_GUDHI_CUBICAL
    for (const auto& entry : std::filesystem::directory_iterator(SharedDataFolder() / "maps"))
    {
      const Volume map = entry.is_regular_file() && entry.path().extension() != ".cube"
        ? MapOf(entry.path())
        : Volume();
      const auto& n = map.Dimensions;
      if (map.Values.empty() || n[0] > 128 || n[1] > 128 || n[2] > 128)
      {
        continue;
      }
      for (const bool superlevel : { false, true })
      {
        ++all;
        const bool same = BarsOf(map.View(), superlevel) == BarsOfGudhi(map.View(), superlevel);
        equal += same ? 1 : 0;
        if (!same)
        {
          state.SkipWithError(("pairs differ: " + entry.path().filename().string()).c_str());
        }
      }
    }
#endif
    state.counters["equal"] = equal;
    state.counters["volumes"] = all;
  }
}

void Threads(benchmark::State& state, const std::string& name)
{
  const Volume volume = name == "waves256" ? Fill(256, Wave) : Make(name);
  const auto wall = [&](int threads)
  {
    const auto start = std::chrono::steady_clock::now();
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, std::string("STDThread"), false),
      [&] { benchmark::DoNotOptimize(CubicalPersistence(volume.View()).Pairs.size()); });
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  for (auto _ : state)
  {
    const double one = wall(1);
    const double two = wall(2);
    state.counters["one s"] = one;
    state.counters["two s"] = two;
    state.counters["speed-up"] = one / two;
  }
}

void Waves512(benchmark::State& state)
{
  const Volume volume = Fill(512, Wave);
  for (auto _ : state)
  {
    const double before = MemoryNow();
    const double seconds = CPUSeconds(
      [&] {
        state.counters["pairs"] =
          static_cast<double>(CubicalPersistence(volume.View()).Pairs.size());
      });
    state.counters["CPU s"] = seconds;
    state.counters["GB in all"] = PeakMemory() / 1e9;
    state.counters["bytes/node"] = PeakOver(before) / static_cast<double>(volume.Values.size());
  }
}

}

BENCHMARK_CAPTURE(BesideGudhi, waves, "waves", false)->Unit(benchmark::kSecond)->Iterations(1);
BENCHMARK_CAPTURE(BesideGudhi, distance, "distance", false)
  ->Unit(benchmark::kSecond)
  ->Iterations(1);
BENCHMARK_CAPTURE(BesideGudhi, plateaus, "plateaus", false)
  ->Unit(benchmark::kSecond)
  ->Iterations(1);
BENCHMARK_CAPTURE(BesideGudhi, mask, "mask", false)->Unit(benchmark::kSecond)->Iterations(1);
BENCHMARK_CAPTURE(BesideGudhi, emd5043, "emd5043", true)->Unit(benchmark::kSecond)->Iterations(1);
BENCHMARK_CAPTURE(BesideGudhi, noise, "noise", false)->Unit(benchmark::kSecond)->Iterations(1);
BENCHMARK(SharedMapsBesideGudhi)->Unit(benchmark::kSecond)->Iterations(1);
BENCHMARK_CAPTURE(Threads, waves256, "waves256")
  ->Unit(benchmark::kSecond)
  ->UseRealTime()
  ->Iterations(3);
BENCHMARK_CAPTURE(Threads, emd5043, "emd5043")
  ->Unit(benchmark::kSecond)
  ->UseRealTime()
  ->Iterations(3);
BENCHMARK(Waves512)->Unit(benchmark::kSecond)->Iterations(1);

BENCHMARK_MAIN();
