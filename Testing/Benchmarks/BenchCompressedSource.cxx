// A bzip2 file of 32 MB of floats, decompressed by our source on all threads and by libbz2 alone,
// alternately.

#include "Core/ParallelFor.h"
#include "Core/Stopwatch.h"
#include "Files/OpenByteSource.h"
#include "TemporaryFile.h"

#include <benchmark/benchmark.h>

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using isthmus::testing::Bzip2;
using isthmus::testing::TemporaryFile;

constexpr std::size_t contentBytes = std::size_t{ 1 } << 25;

/// Smooth densities with noise, in steps of 1/1024 as a map of integers would have them.
std::string Densities()
{
  std::string content(contentBytes, '\0');
  auto* const values = reinterpret_cast<float*>(&content[0]);
  std::uint32_t noise = 12345;
  for (std::size_t i = 0; i < contentBytes / sizeof(float); ++i)
  {
    noise = noise * 1664525u + 1013904223u;
    const double x = static_cast<double>(i % 200) * 0.02;
    const double y = static_cast<double>(i / 200) * 0.02;
    values[i] = static_cast<float>(
      std::round(std::sin(x) * std::cos(y) * 1e4 + static_cast<double>(noise >> 24)) / 1024.0);
  }
  return content;
}

void ByLibbz2(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::stringstream bytes;
  bytes << file.rdbuf();
  std::string packed = bytes.str();
  std::string content(contentBytes, '\0');
  auto size = static_cast<unsigned int>(contentBytes);
  if (BZ2_bzBuffToBuffDecompress(
        &content[0], &size, &packed[0], static_cast<unsigned int>(packed.size()), 0, 0) != BZ_OK)
  {
    std::abort();
  }
}

void ByOurSource(const std::string& path)
{
  const auto source = isthmus::OpenByteSource(path);
  std::string content(contentBytes, '\0');
  if (source->Read(0, &content[0], contentBytes) != contentBytes)
  {
    std::abort();
  }
  source->CheckEnd();
}

struct Times
{
  std::vector<double> Wall, CPU;

  void Add(const std::function<void()>& work)
  {
    const auto used = []()
    {
      rusage usage{};
      getrusage(RUSAGE_SELF, &usage);
      const auto seconds = [](const timeval& t)
      { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
      return seconds(usage.ru_utime) + seconds(usage.ru_stime);
    };
    const double before = used();
    isthmus::Stopwatch clock;
    work();
    this->Wall.push_back(clock.Lap());
    this->CPU.push_back(used() - before);
  }
};

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void Bzip2File(benchmark::State& state)
{
  const TemporaryFile file(Bzip2(Densities()), "densities.bz2");
  Times ours, theirs;
  for (auto _ : state)
  {
    ours.Add([&]() { ByOurSource(file.Path()); });
    theirs.Add([&]() { ByLibbz2(file.Path()); });
    state.SetIterationTime(ours.Wall.back());
  }
  state.counters["ours_s"] = Median(ours.Wall);
  state.counters["libbz2_s"] = Median(theirs.Wall);
  state.counters["ours_cpu_s"] = Median(ours.CPU);
  state.counters["libbz2_cpu_s"] = Median(theirs.CPU);
  state.counters["threads"] = isthmus::ParallelThreads();
}
BENCHMARK(Bzip2File)->UseManualTime()->Iterations(3)->Unit(benchmark::kMillisecond);

}

BENCHMARK_MAIN();
