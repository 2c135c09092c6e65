// libFuzzer target: the bytes up to the first zero as a .vert, the others as its .face; the result
// refers to existing points, is finite, and has as many rows as the first lines state.
//
// Seeds come from LLVMFuzzerCustomMutator, which occasionally starts from a valid pair.

#include "FuzzInput.h"
#include "Meshes/MSMSReader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t most);

namespace
{

const std::string Vertices = "# MSMS solvent excluded surface vertices for x\n"
                             "#vertex #sphere density probe_r\n4 2 1.00 1.50\n"
                             "0 0 0 0 0 1 0 1 2 N_ALA_1\n1 0 0 0 0 1 3 2 1\n"
                             "0 1e0 0 0 0 1 0 1 3\n0 -0.5 1 0 0 1 0 1 3\n";
const std::string Faces = "#faces\n2 2 1.00 1.50\n1 2 3 1 12\n2 4 3 3 1\n";

void Demand(bool holds)
{
  if (!holds)
  {
    std::abort();
  }
}

}

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  isthmus::testing::OneThreadAndSilence();
  return 0;
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
  const std::string path = isthmus::testing::Folder().Write("x.vert", bytes, bytes + cut);
  isthmus::testing::Folder().Write("x.face", bytes + std::min(size, cut + 1), bytes + size);
  isthmus::LooksLikeMSMS(path);
  isthmus::MSMSSurface surface;
  try
  {
    isthmus::ReadMSMS(path, 0, surface);
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
