// libFuzzer target: the first byte chooses OFF, MEDIT or TetGen (.ele, .face; the bytes up to the
// first zero are the .node), the others are the file; what is read is written, read again, and the
// same.
//
// Seeds come from LLVMFuzzerCustomMutator, which occasionally starts from a valid file.

#include "FuzzInput.h"
#include "Meshes/MEDITFile.h"
#include "Meshes/OFFFile.h"
#include "Meshes/TetGenMeshFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t most);

namespace
{

using isthmus::CellMesh;

struct Format
{
  const char* Extension;
  CellMesh (*Read)(const std::string&, const isthmus::ProgressCallback&);
  void (*Write)(const CellMesh&, const std::string&, const isthmus::ProgressCallback&);
};

const std::array<Format, 4> formats{ Format{ ".off", &isthmus::ReadOFF, &isthmus::WriteOFF },
  Format{ ".mesh", &isthmus::ReadMEDIT, &isthmus::WriteMEDIT },
  Format{ ".ele", &isthmus::ReadTetGenFiles, &isthmus::WriteTetGenFiles },
  Format{ ".face", &isthmus::ReadTetGenFiles, &isthmus::WriteTetGenFiles } };

const std::string nodes = "4 3 1 1\n1 0 0 0 1.5 7\n2 1 0 0 2 8\n3 0 1e0 0 3 9\n4 0 0 -1 4 10\n";
using namespace std::string_literals; // zeros within

const std::array<std::string, 4> sound{
  "\0CNOFF 4 2 0 # x\n0 0 0 0 0 1 255 0 0\n1 0 0 0 0 1 0.5 0 0\n0 1 0 0 0 1 1 1 1 1\n"
  "0 0 1 1 0 0 2 2 2\n3 0 1 2 9\n4 0 1 2 3\n"s,
  "\1MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 1\n1 0 0 2\n0 1 0 3\n0 0 1e0 4\n"
  "Corners 1\n2\nTriangles 1\n1 2 3 4\nTetrahedra 1\n1 2 3 4 5\nEnd\n"s,
  "\2"s + nodes +
    "\0"
    "1 4 1\n1 1 2 3 4 0.25\n"s,
  "\3"s + nodes +
    "\0"
    "1 1\n1 1 2 3 -1\n"s
};

void Demand(bool holds)
{
  if (!holds)
  {
    std::abort();
  }
}

void CheckMesh(const CellMesh& mesh)
{
  Demand(mesh.Offsets.size() == mesh.Shapes.size() + 1);
  for (const double x : mesh.Coordinates)
  {
    Demand(std::isfinite(x));
  }
  for (const std::int64_t id : mesh.Vertices)
  {
    Demand(id >= 0 && id < mesh.NumberOfPoints());
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
    const std::string& start = sound[(seed / 64) % sound.size()];
    size = std::min(most, start.size());
    std::memcpy(data, start.data(), size);
  }
  return LLVMFuzzerMutate(data, size, most);
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  if (size == 0)
  {
    return 0;
  }
  const Format& format = formats[data[0] % formats.size()];
  const auto* const bytes = reinterpret_cast<const char*>(data) + 1;
  const char* const end = bytes + size - 1;
  const char* const cut = data[0] % formats.size() < 2 ? bytes : std::find(bytes, end, '\0');
  const char* const rest = cut == bytes ? bytes : std::min(end, cut + 1);
  isthmus::testing::Folder().Write("x.node", bytes, cut);
  const std::string path =
    isthmus::testing::Folder().Write(std::string("x") + format.Extension, rest, end);
  isthmus::LooksLikeOFF(path);
  isthmus::LooksLikeMEDIT(path);
  isthmus::LooksLikeTetGen(path);
  CellMesh mesh;
  try
  {
    mesh = format.Read(path, {});
  }
  catch (const std::runtime_error& error)
  {
    Demand(std::strlen(error.what()) > 20); // refused with a sentence
    return 0;
  }
  CheckMesh(mesh);
  const bool cells = !mesh.Shapes.empty() || data[0] % formats.size() < 2;
  if (cells) // TetGen's writer leaves out files without rows
  {
    format.Write(mesh, path, {});
    const CellMesh again = format.Read(path, {});
    Demand(again.Coordinates == mesh.Coordinates && again.Vertices.size() == mesh.Vertices.size() &&
      again.Shapes.size() == mesh.Shapes.size());
  }
  return 0;
}
