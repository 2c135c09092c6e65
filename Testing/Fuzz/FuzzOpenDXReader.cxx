// libFuzzer target: vtkOpenDXReader reads the bytes as a file (the first byte chooses the array);
// the result is complete and, written by vtkOpenDXWriter, is read back unchanged.
//
// Seeds come from LLVMFuzzerCustomMutator, which occasionally starts from a valid file.

#include "FuzzImageFile.h"
#include "vtkOpenDXReader.h"
#include "vtkOpenDXWriter.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t most);

using namespace isthmus::testing;

namespace
{

const std::string Head = R"(# POTENTIAL (kT/e)
object 1 class gridpositions counts 2 3 2
origin -1.5 2e-3 +3
)";
const std::string Straight = "delta 0.5 0 0\ndelta 0 0.25 0\ndelta 0 0 2\n";
const std::string Skewed = "delta 0.5 0 0\ndelta 0.1 0.25 0\ndelta 0 -0.3 2\n";
const std::string Values = R"(object 2 class gridconnections counts 2 3 2
object 3 class array type "double" rank 0 items 12 data follows
0 1 -2.5e-3
nan 4 5, 6 7 # comment
8 9 10 1e-400
attribute "dep" string "positions"
object 4 class array type float rank 1 shape 2 items 12 data follows
1 2 3 4 5 6 7 8 9 10 11 12 1 2 3 4 5 6 7 8 9 10 11 12
object "regular positions" class field
component "positions" value 1
component "data" value 3
)";
const std::string Raw = "object 3 class array type float items 12 lsb ieee data follows\n";

}

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  OneThreadAndSilence();
  return 0;
}

extern "C" size_t LLVMFuzzerCustomMutator(
  uint8_t* data, size_t size, size_t most, unsigned int seed)
{
  if (size < 2 || seed % 64 == 0)
  {
    const std::string bodies[] = { Straight + Values, Skewed + Values,
      Straight + Raw + std::string(48, '\x3f') + "\nend\n" };
    const std::string sound = '\0' + Head + bodies[seed / 64 % 3];
    size = std::min(most, sound.size());
    std::memcpy(data, sound.data(), size);
  }
  return LLVMFuzzerMutate(data, size, most);
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  if (size < 2)
  {
    return 0;
  }
  const auto* const bytes = reinterpret_cast<const char*>(data);
  vtkNew<vtkOpenDXReader> reader;
  reader->SetFieldIndex(data[0] % 3);
  const auto image = ReadImage(reader.Get(), Folder().Write("grid.dx", bytes + 1, bytes + size));
  if (image->GetNumberOfPoints() > 0) // otherwise refused with a message
  {
    ExpectToComeBack<vtkOpenDXReader, vtkOpenDXWriter>(image, "Potential", "copy.dx");
  }
  return 0;
}
