// vtkOpenDXReader on a potential of 129^3 nodes, beside strtod and fread of the same file, and
// vtkOpenDXWriter beside fprintf. Bound: under 1 s for the plain file.
//
// All runs are repeated alternately and compared by medians, since the machine may be shared.

#include "vtkOpenDXReader.h"
#include "vtkOpenDXWriter.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <unistd.h>

namespace
{

constexpr int nodes = 129;
constexpr vtkIdType count = vtkIdType{ nodes } * nodes * nodes;

std::string TemporaryPath(const char* ending)
{
  return (std::filesystem::temp_directory_path() /
    ("isthmus-bench-" + std::to_string(::getpid()) + ending))
    .string();
}

double PotentialAt(vtkIdType i)
{
  return 5.0 * std::sin(0.37 * static_cast<double>(i % 9973)) * std::exp(-1e-7 * double(i));
}

/// The file as APBS writes it, deleted at the end.
struct PotentialFile
{
  PotentialFile()
  {
    std::FILE* const file = std::fopen(this->Path.c_str(), "w");
    std::fprintf(file,
      "object 1 class gridpositions counts %d %d %d\norigin -32 -32 -32\ndelta 0.5 0 0\n"
      "delta 0 0.5 0\ndelta 0 0 0.5\nobject 3 class array type double rank 0 items %lld data "
      "follows\n",
      nodes, nodes, nodes, static_cast<long long>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      std::fprintf(file, "%e%s", PotentialAt(i), i % 3 == 2 ? "\n" : " ");
    }
    std::fclose(file);
  }
  ~PotentialFile() { std::remove(this->Path.c_str()); }
  PotentialFile(const PotentialFile&) = delete;
  PotentialFile& operator=(const PotentialFile&) = delete;

  const std::string Path = TemporaryPath(".dx");
};

std::string Content(const std::string& path)
{
  std::string text(std::filesystem::file_size(path), '\0');
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  const std::size_t got = std::fread(text.data(), 1, text.size(), file);
  std::fclose(file);
  text.resize(got);
  return text;
}

void ReadByStrtod(const std::string& path)
{
  const std::string text = Content(path);
  const char* at = text.c_str() + text.find("follows") + 7;
  std::vector<double> values(static_cast<std::size_t>(count));
  for (double& value : values)
  {
    char* end;
    value = std::strtod(at, &end);
    at = end;
  }
  benchmark::DoNotOptimize(values.data());
}

void ReadByOurs(const std::string& path)
{
  vtkNew<vtkOpenDXReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (reader->GetOutput()->GetNumberOfPoints() != count)
  {
    std::abort();
  }
}

void WriteByPrintf(const std::string& path)
{
  std::FILE* const file = std::fopen(path.c_str(), "w");
  for (vtkIdType i = 0; i < count; ++i)
  {
    std::fprintf(file, "%.17g%s", PotentialAt(i), i % 3 == 2 ? "\n" : " ");
  }
  std::fclose(file);
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

void Compare(benchmark::State& state, const std::function<void()>& ours,
  const std::function<void()>& peer, const std::function<void()>& limit)
{
  std::vector<double> times[3];
  for (auto _ : state)
  {
    times[0].push_back(Seconds(ours));
    times[1].push_back(Seconds(peer));
    times[2].push_back(Seconds(limit));
    state.SetIterationTime(times[0].back());
  }
  state.counters["ours_s"] = Median(times[0]);
  state.counters["peer_s"] = Median(times[1]);
  state.counters["ratio_to_peer"] = Median(times[0]) / Median(times[1]);
  state.counters["fread_s"] = Median(times[2]);
}

void ReadAgainstStrtod(benchmark::State& state)
{
  const PotentialFile file;
  Compare(
    state, [&]() { ReadByOurs(file.Path); }, [&]() { ReadByStrtod(file.Path); },
    [&]() { benchmark::DoNotOptimize(Content(file.Path)); });
}

void WriteAgainstPrintf(benchmark::State& state)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(nodes, nodes, nodes);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Potential");
  values->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    values->SetValue(i, PotentialAt(i));
  }
  image->GetPointData()->SetScalars(values);
  const std::string path = TemporaryPath("-out.dx");
  vtkNew<vtkOpenDXWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  Compare(
    state, [&]() { writer->Write(); }, [&]() { WriteByPrintf(path); },
    [&]() { benchmark::DoNotOptimize(Content(path)); });
  std::remove(path.c_str());
}

}

BENCHMARK(ReadAgainstStrtod)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(5);
BENCHMARK(WriteAgainstPrintf)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(5);
BENCHMARK_MAIN();
