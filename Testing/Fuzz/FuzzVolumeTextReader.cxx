// libFuzzer target: vtkVolumeTextReader reads the bytes as a .dat; the result is complete and,
// written by vtkVolumeTextWriter, is read back unchanged.
//
// Seeds come from LLVMFuzzerCustomMutator, which occasionally starts from a valid file.

#include "FuzzImageFile.h"
#include "vtkVolumeTextReader.h"
#include "vtkVolumeTextWriter.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t most);

using namespace isthmus::testing;

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  OneThreadAndSilence();
  return 0;
}

extern "C" size_t LLVMFuzzerCustomMutator(
  uint8_t* data, size_t size, size_t most, unsigned int seed)
{
  if (size == 0 || seed % 64 == 0)
  {
    const std::string sound = "2 3 2\n1 -2.5e-3\n+3 nan\n5 1e-400\r\n7 8\n9 1e300\n.5 -0\n";
    size = std::min(most, sound.size());
    std::memcpy(data, sound.data(), size);
  }
  return LLVMFuzzerMutate(data, size, most);
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  const auto* const bytes = reinterpret_cast<const char*>(data);
  vtkNew<vtkVolumeTextReader> reader;
  const auto image = ReadImage(reader.Get(), Folder().Write("volume.dat", bytes, bytes + size));
  if (image->GetNumberOfPoints() == 0)
  {
    return 0; // refused with a sentence
  }
  if (image->GetPointData()->GetScalars()->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    std::abort();
  }
  ExpectToComeBack<vtkVolumeTextReader, vtkVolumeTextWriter>(image, "Density", "copy.dat");
  return 0;
}
