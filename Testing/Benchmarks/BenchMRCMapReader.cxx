// vtkMRCMapReader beside fread, plain zlib and vtkMRCReader on the same bytes, in one run.
//
// All runs are repeated alternately and compared by medians, since the machine may be shared. Files
// are of 512^3 voxels (ISTHMUS_BENCH_SIZE), in the page cache, and every reading uses fresh memory,
// as in an application.

#include "vtkMRCMapReader.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMRCReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <benchmark/benchmark.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <unistd.h>

namespace
{

using Order = std::array<int, 3>;
using Memory = std::unique_ptr<unsigned char[]>;

int Size()
{
  const char* const chosen = std::getenv("ISTHMUS_BENCH_SIZE");
  return chosen ? std::clamp(std::atoi(chosen), 8, 1000) : 512;
}

double VoxelBytes(int mode)
{
  switch (mode)
  {
    case 0:
      return 1;
    case 1:
    case 6:
    case 12:
      return 2;
    case 16:
      return 3;
    case 4:
      return 8;
    case 101:
      return 0.5;
    default:
      return 4;
  }
}

double OutputBytes(int mode)
{
  return mode == 12 ? 4 : (mode == 101 ? 1 : VoxelBytes(mode));
}

std::size_t DataBytes(double perVoxel)
{
  const double n = Size();
  return static_cast<std::size_t>(n * n * n * perVoxel);
}

/// Reverses words for a big-endian file.
void Order32(unsigned char* bytes, std::size_t words, bool bigEndian)
{
  for (std::size_t i = 0; bigEndian && i < words; ++i)
  {
    std::reverse(bytes + 4 * i, bytes + 4 * i + 4);
  }
}

/// Content of a compressed file: noise in every voxel is the worst case for inflating; deposited
/// maps are often zero outside of a mask around the molecule.
enum class Packed
{
  No,
  Noise,
  Masked
};

/// A map file, deleted at the end; densities are smooth with noise, so that gzip has some work.
class MapFile
{
public:
  MapFile(int mode, const Order& order, bool bigEndian, Packed packed)
    : Path((std::filesystem::temp_directory_path() /
        ("isthmus-bench-" + std::to_string(::getpid()) +
          (packed == Packed::No ? ".mrc" : ".mrc.gz")))
             .string())
  {
    std::array<std::int32_t, 256> header{ Size(), Size(), Size(), mode };
    const float length = static_cast<float>(Size());
    const float right = 90.0f;
    for (std::size_t i = 0; i < 3; ++i)
    {
      header[7 + i] = Size();
      std::memcpy(&header[10 + i], &length, 4);
      std::memcpy(&header[13 + i], &right, 4);
      header[16 + i] = order[i];
    }
    auto* const bytes = reinterpret_cast<unsigned char*>(header.data());
    Order32(bytes, 256, bigEndian);
    std::memcpy(bytes + 208, "MAP ", 4);
    std::memcpy(bytes + 212, bigEndian ? "\x11\x11\0\0" : "DD\0\0", 4);
    switch (packed)
    {
      case Packed::No:
        this->WritePlain(bytes, mode);
        break;
      case Packed::Noise:
        this->WritePacked(bytes);
        break;
      case Packed::Masked:
        this->WriteMasked(bytes);
        break;
    }
  }
  ~MapFile() { std::remove(this->Path.c_str()); }
  MapFile(const MapFile&) = delete;
  MapFile& operator=(const MapFile&) = delete;

  const std::string Path;

private:
  /// One section; all sections are the same but for noise that is shifted.
  static std::vector<float> Section()
  {
    const auto n = static_cast<std::size_t>(Size());
    std::vector<float> values(n * n);
    std::uint32_t noise = 12345;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      noise = noise * 1664525u + 1013904223u;
      const double x = static_cast<double>(i % n) * 0.02;
      const double y = static_cast<double>(i / n) * 0.02;
      values[i] =
        std::round(static_cast<float>(std::sin(x) * std::cos(y) * 1e4 + (noise >> 24))) / 1024.0f;
    }
    return values;
  }

  void WritePlain(const unsigned char* header, int mode) const
  {
    std::FILE* const file = std::fopen(this->Path.c_str(), "wb");
    std::fwrite(header, 1, 1024, file);
    const std::vector<float> section = Section();
    const std::size_t bytes = DataBytes(VoxelBytes(mode)) / static_cast<std::size_t>(Size());
    std::vector<unsigned char> content(std::max(bytes, 4 * section.size()));
    std::memcpy(content.data(), section.data(), 4 * section.size());
    for (std::size_t i = 4 * section.size(); i < bytes; ++i)
    {
      content[i] = content[i - 4 * section.size()];
    }
    for (int s = 0; s < Size(); ++s)
    {
      std::fwrite(content.data(), 1, bytes, file);
    }
    std::fclose(file);
  }

  void WritePacked(const unsigned char* header) const
  {
    gzFile file = gzopen(this->Path.c_str(), "wb1");
    gzwrite(file, header, 1024);
    std::vector<float> section = Section();
    for (int s = 0; s < Size(); ++s)
    {
      std::rotate(section.begin(), section.begin() + 97, section.end());
      gzwrite(file, section.data(), static_cast<unsigned>(4 * section.size()));
    }
    gzclose(file);
  }

  /// Waves with a hundredth of noise in a ball of 0.35 of the width (18 per cent of the voxels),
  /// zero outside, by gzip's usual level.
  void WriteMasked(const unsigned char* header) const
  {
    gzFile file = gzopen(this->Path.c_str(), "wb");
    gzwrite(file, header, 1024);
    const int n = Size();
    std::vector<float> section(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    std::uint32_t noise = 12345;
    for (int k = 0; k < n; ++k)
    {
      for (int i = 0; i < n * n; ++i)
      {
        const double x = i % n - 0.5 * n, y = i / n - 0.5 * n, z = k - 0.5 * n;
        noise = noise * 1664525u + 1013904223u;
        const double density = std::sin(0.1 * x) * std::cos(0.1 * y) * std::cos(0.08 * z) +
          0.01 * (noise >> 8) * 0x1p-24;
        const bool inside = x * x + y * y + z * z < 0.35 * 0.35 * n * n;
        section[static_cast<std::size_t>(i)] = inside ? static_cast<float>(density) : 0.0F;
      }
      gzwrite(file, section.data(), static_cast<unsigned>(4 * section.size()));
    }
    gzclose(file);
  }
};

double Seconds(const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void Fread(const std::string& path, std::size_t bytes)
{
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  const Memory memory(new unsigned char[bytes]);
  std::fseek(file, 1024, SEEK_SET);
  if (std::fread(memory.get(), 1, bytes, file) != bytes)
  {
    std::abort();
  }
  benchmark::DoNotOptimize(memory[bytes / 2]);
  std::fclose(file);
}

void WriteMemory(std::size_t bytes)
{
  const Memory memory(new unsigned char[bytes]);
  std::memset(memory.get(), 1, bytes);
  benchmark::DoNotOptimize(memory[bytes / 2]);
}

/// The whole file by zlib's inflate alone, in one call for each buffer of input.
void Inflate(const std::string& path, std::size_t bytes)
{
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  const Memory memory(new unsigned char[bytes + 1024]);
  std::vector<unsigned char> input(1 << 18);
  z_stream stream{};
  inflateInit2(&stream, 16 + MAX_WBITS);
  stream.next_out = memory.get();
  stream.avail_out = static_cast<uInt>(bytes + 1024);
  int state = Z_OK;
  while (state == Z_OK)
  {
    stream.next_in = input.data();
    stream.avail_in = static_cast<uInt>(std::fread(input.data(), 1, input.size(), file));
    state = inflate(&stream, Z_NO_FLUSH);
  }
  inflateEnd(&stream);
  std::fclose(file);
  if (state != Z_STREAM_END)
  {
    std::abort();
  }
}

template <typename Reader>
void ReadWith(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->GlobalWarningDisplayOff(); // the note on Fourier transforms
  reader->Update();
  if (reader->GetOutput()->GetNumberOfPoints() != static_cast<vtkIdType>(DataBytes(1)))
  {
    std::abort();
  }
}

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Runs ours and the others alternately, then shows the medians (seconds) and ratios to the
/// reference.
void Compare(benchmark::State& state, const std::function<void()>& ours,
  const std::function<void()>& reference, const std::function<void()>& theirs = {})
{
  std::vector<double> times[3];
  for (auto _ : state)
  {
    times[0].push_back(Seconds(ours));
    times[1].push_back(Seconds(reference));
    if (theirs)
    {
      times[2].push_back(Seconds(theirs));
    }
    state.SetIterationTime(times[0].back());
  }
  state.counters["reference_s"] = Median(times[1]);
  state.counters["ours_s"] = Median(times[0]);
  state.counters["ratio"] = Median(times[0]) / Median(times[1]);
  if (theirs)
  {
    state.counters["vtkMRCReader_ratio"] = Median(times[2]) / Median(times[1]);
  }
}

/// Bound 1.25: float of this machine's byte order, against fread of the same bytes.
void FloatAgainstFread(benchmark::State& state)
{
  const MapFile map(2, { 1, 2, 3 }, false, Packed::No);
  Compare(
    state, [&]() { ReadWith<vtkMRCMapReader>(map.Path); }, [&]() { Fread(map.Path, DataBytes(4)); },
    [&]() { ReadWith<vtkMRCReader>(map.Path); });
}

/// Bounds 2.5 in file axis order, 4 permuted: against fread plus one write of the output's bytes.
void AnyAgainstFreadAndWrite(benchmark::State& state, int mode, bool bigEndian, const Order& order)
{
  const MapFile map(mode, order, bigEndian, Packed::No);
  Compare(
    state, [&]() { ReadWith<vtkMRCMapReader>(map.Path); },
    [&]()
    {
      Fread(map.Path, DataBytes(VoxelBytes(mode)));
      WriteMemory(DataBytes(OutputBytes(mode)));
    });
}

/// Bound 1.15: gzip, against zlib's inflate alone.
void GzipAgainstZlib(benchmark::State& state, const Order& order, Packed packed)
{
  const MapFile map(2, order, false, packed);
  Compare(
    state, [&]() { ReadWith<vtkMRCMapReader>(map.Path); },
    [&]() { Inflate(map.Path, DataBytes(4)); });
}

std::string FormatName(int mode, bool bigEndian, const Order& order)
{
  return "FreadAndWrite/mode" + std::to_string(mode) + (bigEndian ? "/bigEndian" : "") + "/axes" +
    std::to_string(order[0]) + std::to_string(order[1]) + std::to_string(order[2]);
}

void Register()
{
  const auto add = [](const std::string& name, auto&& body)
  {
    benchmark::RegisterBenchmark(name.c_str(), body)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(7);
  };
  add("Fread/mode2/axes123", FloatAgainstFread);
  for (const int mode : { 0, 1, 2, 4, 6, 12, 16, 101 })
  {
    for (const Order& order : { Order{ 1, 2, 3 }, Order{ 2, 1, 3 }, Order{ 3, 2, 1 } })
    {
      const bool bigEndian = mode == 1 || mode == 2;
      add(FormatName(mode, bigEndian, order),
        [mode, bigEndian, order](benchmark::State& state)
        { AnyAgainstFreadAndWrite(state, mode, bigEndian, order); });
    }
  }
  for (const Order& order : { Order{ 1, 2, 3 }, Order{ 3, 2, 1 } })
  {
    add(order[0] == 1 ? "Zlib/mode2/axes123" : "Zlib/mode2/axes321",
      [order](benchmark::State& state) { GzipAgainstZlib(state, order, Packed::Noise); });
  }
  add("Zlib/mode2/masked",
    [](benchmark::State& state) {
      GzipAgainstZlib(state, { 1, 2, 3 }, Packed::Masked);
    });
}

}

int main(int argc, char** argv)
{
  Register();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
