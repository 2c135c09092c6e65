// libFuzzer target: the bytes as a combinatorial mesh file; the result must be a grid, be writable
// and be read back unchanged, and the map must accept or refuse it without a crash.
//
// Seeds come from LLVMFuzzerCustomMutator, which occasionally starts from a valid file.

#include "CellComplex/CompactCombinatorialMap.h"
#include "CellComplex/EdgeTable.h"
#include "CellComplex/FaceTable.h"
#include "FuzzInput.h"
#include "Meshes/CombinatorialMeshFile.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t most);

namespace
{

const char* const Sample = R"(isthmus-combinatorial-mesh 1 text
types 2
type 4 4 tetrahedron
3 0 2 1
3 0 1 3
3 1 2 3
3 2 0 3
type 6 5 prism
3 0 2 1
4 0 1 4 3
4 1 2 5 4
4 2 0 3 5
3 3 4 5
vertices 8 float32
0 0 0 1 0 0 0 1 0 0 0 1 1 0 1 0 1 1 0.3 0.3 -1 0.3 0.3 2
blocks 2
block 0 2
1 0 2 6
3 4 5 7
block 1 1
0 1 2 3 4 5
attributes 2
attribute cells uint8 1 Material
1 2 3
attribute vertices float64 1 Height
0 -0 inf nan 1e-300 5 6 7
end
)";

std::string Written(const isthmus::CombinatorialMesh& mesh, bool binary)
{
  std::ostringstream stream;
  isthmus::WriteCombinatorialMesh(mesh, binary, stream);
  return stream.str();
}

/// Visits everything in the map of the mesh, if the mesh is valid for a map.
void Walk(const isthmus::CombinatorialMesh& mesh)
{
  isthmus::CellList list{ mesh.NumberOfVertices, mesh.Types, mesh.Runs,
    { mesh.CellVertices.data(), mesh.CellVertices.size() } };
  try
  {
    const isthmus::CompactCombinatorialMap<> map(list);
    for (std::uint32_t e = 0; e < map.Edges().Size(); ++e)
    {
      for (const auto dart : map.Edges().Fan(isthmus::EdgeHandle<std::uint32_t>(e)))
      {
        if (map.Edges().Find(dart).Value != e)
        {
          std::abort();
        }
      }
    }
    for (std::uint32_t f = 0; f < map.Faces().Size(); ++f)
    {
      if (map.Faces().Find(map.Faces().GetDart(isthmus::FaceHandle<std::uint32_t>(f))).Value != f)
      {
        std::abort();
      }
    }
  }
  catch (const isthmus::MeshError&)
  {
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
  if (size < 40 || seed % 64 == 0)
  {
    const std::string sound = Written(isthmus::ParseCombinatorialMesh(Sample), seed / 64 % 2 == 0);
    size = std::min(most, sound.size());
    std::memcpy(data, sound.data(), size);
  }
  return LLVMFuzzerMutate(data, size, most);
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  isthmus::CombinatorialMesh mesh;
  try
  {
    mesh = isthmus::ParseCombinatorialMesh({ reinterpret_cast<const char*>(data), size });
  }
  catch (const std::runtime_error&)
  {
    return 0; // refused with a sentence
  }
  Walk(mesh);
  const std::string binary = Written(mesh, true);
  if (Written(isthmus::ParseCombinatorialMesh(binary), true) != binary)
  {
    std::abort();
  }
  const std::string text = Written(mesh, false);
  if (Written(isthmus::ParseCombinatorialMesh(text), false) != text)
  {
    std::abort();
  }
  return 0;
}
