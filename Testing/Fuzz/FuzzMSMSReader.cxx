// libFuzzer target: the bytes up to the first zero as a .vert, the others as its .face; what is
// read names points that there are, in finite numbers, and as many rows as the first lines promise.
//
// Seeds come from LLVMFuzzerCustomMutator, which now and then starts from a sound pair.

#include "MSMSReader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <unistd.h>

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t most);

namespace
{

const std::string Vertices = "# MSMS solvent excluded surface vertices for x\n"
                             "#vertex #sphere density probe_r\n4 2 1.00 1.50\n"
                             "0 0 0 0 0 1 0 1 2 N_ALA_1\n1 0 0 0 0 1 3 2 1\n"
                             "0 1e0 0 0 0 1 0 1 3\n0 -0.5 1 0 0 1 0 1 3\n";
const std::string Faces = "#faces\n2 2 1.00 1.50\n1 2 3 1 12\n2 4 3 3 1\n";

/// A folder of this process' own, and the pair in it.
std::filesystem::path Stem()
{
  static const std::filesystem::path folder = []
  {
    std::string name = (std::filesystem::temp_directory_path() / "fuzz-msms-XXXXXX").string();
    return std::filesystem::path(mkdtemp(name.data()) ? name : std::string("."));
  }();
  return folder / "x";
}

void Demand(bool holds)
{
  if (!holds)
  {
    std::abort();
  }
}

}

extern "C" size_t LLVMFuzzerCustomMutator(
  uint8_t* data, size_t size, size_t most, unsigned int seed)
{
  if (size < 20 || seed % 64 == 0)
  {
    const std::string sound = Vertices + '\0' + Faces;
    size = std::min(most, sound.size());
    std::memcpy(data, sound.data(), size);
  }
  return LLVMFuzzerMutate(data, size, most);
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  const auto* const bytes = reinterpret_cast<const char*>(data);
  const auto cut = static_cast<size_t>(std::find(bytes, bytes + size, '\0') - bytes);
  const std::string stem = Stem().string();
  std::ofstream(stem + ".vert", std::ios::binary).write(bytes, static_cast<std::streamsize>(cut));
  const size_t rest = std::min(size, cut + 1);
  std::ofstream(stem + ".face", std::ios::binary)
    .write(bytes + rest, static_cast<std::streamsize>(size - rest));
  isthmus::LooksLikeMSMS(stem + ".vert");
  isthmus::MSMSSurface surface;
  try
  {
    isthmus::ReadMSMS(stem + ".vert", 0, surface);
  }
  catch (const std::runtime_error& error)
  {
    Demand(std::strlen(error.what()) > 20); // refused with a sentence
    return 0;
  }
  const std::size_t points = surface.Points.size();
  Demand(surface.Normals.size() == points && surface.TypeOfPoint.size() == points &&
    surface.SphereOfPoint.size() == points && surface.AnalyticFaceOfPoint.size() == points &&
    surface.TypeOfTriangle.size() == surface.Triangles.size());
  for (std::size_t i = 0; i < points; ++i)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      Demand(std::isfinite(surface.Points[i][a]) && std::isfinite(surface.Normals[i][a]));
    }
  }
  for (const auto& triangle : surface.Triangles)
  {
    for (const std::int64_t id : triangle)
    {
      Demand(id >= 0 && static_cast<std::size_t>(id) < points);
    }
  }
  return 0;
}
