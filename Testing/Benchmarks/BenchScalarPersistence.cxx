// Persistence of volumes beside its peers in the same run: GUDHI, Cubical Ripser, TTK: time, ratio,
// peak memory per node, and whether the pairs are equal; two threads beside one; 512^3 waves; every
// shared map of at most 128^3.
//
// Times are CPU seconds on one thread each, which depend least on other load. GUDHI is found as in
// the tests; ISTHMUS_PEERS names the folder of the other two (PeerPrograms.h), and each row says
// which of them is missing. TTK's grid is split into six tetrahedra per cell (Freudenthal), where
// nodes are also adjacent along diagonals: its pairs are those of another complex, close to ours on
// a smooth field, so they are counted instead of compared individually.
//
// --benchmark_filter=Peers: the table alone.

#include "Persistence/CubicalPersistence.h"

#include "CubicalPeer.h"
#include "PeakMemory.h"
#include "PeerPrograms.h"
#include "PersistenceVolumes.h"

#include <vtkSMPTools.h>

#include <benchmark/benchmark.h>

#include <malloc.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace isthmus;
using namespace isthmus::testing;

Volume<float> Make(const std::string& name)
{
  const Size n{ 128, 128, 128 };
  if (name == "waves")
  {
    return Fill<float>(n, Wave);
  }
  if (name == "waves256")
  {
    return Fill<float>({ 256, 256, 256 }, Wave);
  }
  if (name == "fine")
  {
    return Fill<float>(
      n, [](double x, double y, double z) { return Wave(0.5 * x, 0.5 * y, 0.5 * z); });
  }
  if (name == "distance")
  {
    return AtomDistance(n, 2000, 5);
  }
  if (name == "plateaus")
  {
    return Fill<float>(
      n, [](double x, double y, double z) { return std::floor(4.0 * Wave(x, y, z)); });
  }
  if (name == "mask")
  {
    return Fill<float>(
      n, [](double x, double y, double z) { return Wave(x, y, z) > 0.3 ? 1.0 : 0.0; });
  }
  if (name == "noise")
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    return Fill<float>({ 96, 96, 96 }, [&](double, double, double) { return value(random); });
  }
  return ReadMap(SharedDataFolder() / "maps/emd_5043.map");
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

/// Memory resident now, measured as the peak just after its reset. Freed memory is returned to the
/// system first, since reuse of it would not be measured.
double MemoryNow()
{
  malloc_trim(0);
  ResetPeakMemory();
  return PeakMemory();
}

template <typename Work>
void OnThreads(int threads, Work&& work)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, std::string("STDThread"), false), work);
}

/// Runs ours and fills its columns; returns the CPU seconds.
double RunOurs(benchmark::State& state, const Volume<float>& volume, bool superlevel)
{
  CubicalParameters parameters;
  parameters.Superlevel = superlevel;
  const double before = MemoryNow();
  std::size_t pairs = 0;
  double seconds = 0.0;
  OnThreads(1,
    [&]
    {
      seconds =
        CPUSeconds([&] { pairs = CubicalPersistence(volume.View(), parameters).Pairs.size(); });
    });
  state.counters["bytes/node"] = PeakOver(before) / static_cast<double>(volume.Values.size());
  state.counters["ours s"] = seconds;
  state.counters["pairs"] = static_cast<double>(pairs);
  return seconds;
}

/// Fills the columns of a peer that is a program; false if it is missing.
bool RunBeside(benchmark::State& state, PeerProgram peer, const Volume<float>& volume,
  bool superlevel, double ours, const Bars& expected)
{
  MemoryNow();
  const auto run = RunPeer(peer, volume.View(), superlevel);
  if (!run)
  {
    return false;
  }
  const std::string name = peer == PeerProgram::TTK ? "TTK " : "Ripser ";
  state.counters[name + "s"] = run->Seconds;
  state.counters[name + "ratio"] = ours / run->Seconds;
  state.counters[name + "bytes/node"] = run->Peak / static_cast<double>(volume.Values.size());
  if (peer == PeerProgram::TTK)
  {
    state.counters["TTK pairs"] = static_cast<double>(run->Pairs.size());
  }
  else
  {
    state.counters["Ripser equal"] = run->Pairs == expected ? 1.0 : 0.0;
  }
  return true;
}

void BesidePeers(benchmark::State& state, const std::string& name, bool superlevel)
{
  const Volume<float> volume = Make(name);
  for (auto _ : state)
  {
    const double ours = RunOurs(state, volume, superlevel);
    const Bars expected = CollectBars(volume.View(), superlevel);
    std::string missing;
#if ISTHMUS_HAS_GUDHI_CUBICAL
    const double before = MemoryNow();
    Bars theirs;
    const double peer = CPUSeconds([&] { theirs = BarsOfGudhi(volume.View(), superlevel); });
    state.counters["GUDHI bytes/node"] =
      PeakOver(before) / static_cast<double>(volume.Values.size());
    state.counters["GUDHI s"] = peer;
    state.counters["GUDHI ratio"] = ours / peer;
    state.counters["GUDHI equal"] = expected == theirs ? 1.0 : 0.0;
#else
    missing += "no GUDHI (libgudhi-dev) ";
#endif
    for (const PeerProgram peerProgram : { PeerProgram::CubicalRipser, PeerProgram::TTK })
    {
      if (!RunBeside(state, peerProgram, volume, superlevel, ours, expected))
      {
        missing += "no " + FindPeerProgram(peerProgram).filename().string() + " in $ISTHMUS_PEERS ";
      }
    }
    state.SetLabel(missing);
  }
}

/// Lengths of the bars of a dimension that are at least `least`, ascending.
std::vector<double> Lengths(const Bars& bars, double dimension, double least)
{
  std::vector<double> lengths;
  for (const Bar& bar : bars)
  {
    const double length = std::abs(bar[2] - bar[1]);
    if (bar[0] == dimension && std::isfinite(length) && length >= least)
    {
      lengths.push_back(length);
    }
  }
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

/// On a field that the grid resolves, cubes and tetrahedra have the same features: the number with
/// a persistence of at least a twentieth of the range, and the differences of their lengths.
void FeaturesBesidePeers(benchmark::State& state)
{
  const Volume<float> volume = Make("fine");
  const auto [low, high] = std::minmax_element(volume.Values.begin(), volume.Values.end());
  const double range = *high - *low;
  for (auto _ : state)
  {
    const auto run = RunPeer(PeerProgram::TTK, volume.View());
    if (!run)
    {
      state.SkipWithError("no ttk_grid_persistence in $ISTHMUS_PEERS");
      return;
    }
    const Bars ours = CollectBars(volume.View());
    for (const int d : { 0, 1, 2 })
    {
      const std::vector<double> mine = Lengths(ours, d, 0.05 * range);
      const std::vector<double> theirs = Lengths(run->Pairs, d, 0.05 * range);
      const std::string name = "dim " + std::to_string(d) + " ";
      state.counters[name + "ours"] = static_cast<double>(mine.size());
      state.counters[name + "TTK"] = static_cast<double>(theirs.size());
      double apart = 0.0;
      for (std::size_t i = 0; i < std::min(mine.size(), theirs.size()); ++i)
      {
        apart = std::max(
          apart, std::abs(mine[mine.size() - 1 - i] - theirs[theirs.size() - 1 - i]) / range);
      }
      state.counters[name + "apart"] = apart;
    }
  }
}

/// All shared maps of at most 128^3, both signs: the number with equal pairs, and the total.
void SharedMapsBesideGudhi(benchmark::State& state)
{
  for (auto _ : state)
  {
    int equal = 0;
    int all = 0;
#if ISTHMUS_HAS_GUDHI_CUBICAL
    for (const std::filesystem::path& file : SharedMapFiles())
    {
      const Volume<float> map = ReadMap(file);
      for (const bool superlevel : { false, true })
      {
        if (!IsSmall(map))
        {
          continue;
        }
        ++all;
        const bool same =
          CollectBars(map.View(), superlevel) == BarsOfGudhi(map.View(), superlevel);
        equal += same ? 1 : 0;
        if (!same)
        {
          state.SkipWithError(("pairs differ: " + file.filename().string()).c_str());
        }
      }
    }
#else
    state.SkipWithError("no GUDHI (libgudhi-dev)");
#endif
    state.counters["equal"] = equal;
    state.counters["volumes"] = all;
  }
}

/// CPU seconds of the calling thread.
double OwnSeconds()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Wall seconds on one and on two threads, meaningful on an idle machine only; and, on any machine,
/// the share of the work that the calling thread does alone.
void Threads(benchmark::State& state, const std::string& name)
{
  const Volume<float> volume = Make(name);
  const auto wall = [&](int threads)
  {
    const auto start = std::chrono::steady_clock::now();
    OnThreads(
      threads, [&] { benchmark::DoNotOptimize(CubicalPersistence(volume.View()).Pairs.size()); });
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  for (auto _ : state)
  {
    const double one = wall(1);
    const double own = OwnSeconds();
    const std::clock_t start = std::clock();
    const double two = wall(2);
    const double cpu = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    state.counters["CPU s"] = cpu;
    state.counters["alone"] = (OwnSeconds() - own) / cpu;
    state.counters["one s"] = one;
    state.counters["two s"] = two;
    state.counters["speed-up"] = one / two;
  }
}

void Waves512(benchmark::State& state)
{
  const Volume<float> volume = Fill<float>({ 512, 512, 512 }, Wave);
  for (auto _ : state)
  {
    const double before = MemoryNow();
    const auto start = std::chrono::steady_clock::now();
    const double seconds = CPUSeconds(
      [&] {
        state.counters["pairs"] =
          static_cast<double>(CubicalPersistence(volume.View()).Pairs.size());
      });
    state.counters["CPU s"] = seconds;
    state.counters["wall s"] =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    state.counters["GB in all"] = PeakMemory() / 1e9;
    state.counters["bytes/node"] = PeakOver(before) / static_cast<double>(volume.Values.size());
  }
}

void Register()
{
  const auto once = [](auto* bench) { bench->Unit(benchmark::kSecond)->Iterations(1); };
  for (const char* name : { "waves", "distance", "plateaus", "mask", "emd5043", "noise" })
  {
    const std::string volume = name;
    once(benchmark::RegisterBenchmark(("BesidePeers/" + volume).c_str(),
      [volume](benchmark::State& state) { BesidePeers(state, volume, volume == "emd5043"); }));
  }
  once(benchmark::RegisterBenchmark("FeaturesBesidePeers", FeaturesBesidePeers));
  once(benchmark::RegisterBenchmark("SharedMapsBesideGudhi", SharedMapsBesideGudhi));
  for (const char* name : { "waves256", "emd5043", "noise" })
  {
    const std::string volume = name;
    benchmark::RegisterBenchmark(
      ("Threads/" + volume).c_str(), [volume](benchmark::State& state) { Threads(state, volume); })
      ->Unit(benchmark::kSecond)
      ->UseRealTime()
      ->Iterations(3);
  }
  once(benchmark::RegisterBenchmark("Waves512", Waves512));
}

}

int main(int count, char** words)
{
  benchmark::Initialize(&count, words);
  Register();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
