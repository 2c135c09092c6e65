// libFuzzer target: vtkMRCMapReader reads the bytes as a file, plain, gzip or bzip2.
//
// The first 8 bytes choose what is done with the rest, so that the fuzzer need not invent
// compressed streams: the compression, the file's ending, and the reader's properties. Built by
// -DISTHMUS_FUZZ=ON, or alone by clang++ -fsanitize=fuzzer,address,undefined with the sources of
// Readers and Filters/Core. Seeds come from LLVMFuzzerCustomMutator, which occasionally starts from
// a valid map.

#include "FuzzInput.h"
#include "TemporaryFile.h"
#include "vtkMRCMapReader.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t most);

namespace
{

constexpr std::size_t choices = 8;

using isthmus::testing::Bzip2;
using isthmus::testing::Gzip;

/// Reads every value of the output under the sanitizers.
void Touch(vtkImageData* image)
{
  double sum = 0.0;
  for (int a = 0; a < image->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* const array = image->GetPointData()->GetArray(a);
    if (array->GetNumberOfTuples() != image->GetNumberOfPoints())
    {
      std::abort();
    }
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      sum += array->GetComponent(i, 0);
    }
  }
  double bounds[6];
  image->GetBounds(bounds);
  for (int i = 0; i < 6; ++i)
  {
    if (!std::isfinite(bounds[i]))
    {
      std::abort();
    }
  }
  volatile double kept = sum; // so that it is not optimised away
  static_cast<void>(kept);
}

void ReadAsChosen(const uint8_t* choice, const char* path)
{
  vtkNew<vtkMRCMapReader> reader;
  reader->SetFileName(path);
  reader->CanReadFile(path);
  reader->SetStrict(choice[2] & 1);
  reader->SetNonOrthogonalCell((choice[2] >> 1) & 1);
  reader->SetVolumeIndex(choice[3] % 8 - 1);
  if (choice[2] & 4)
  {
    reader->SetSampleRate(1 + choice[4] % 3, 1 + choice[4] / 3 % 3, 1 + choice[4] / 9 % 3);
  }
  if (choice[2] & 8)
  {
    reader->SetCropExtent(
      choice[5] % 4, -1, choice[6] % 4, choice[6] / 4 % 8, choice[7] % 4, choice[7] / 4 % 8 - 1);
  }
  reader->Update();
  Touch(reader->GetOutput());
}

/// A valid map of a few voxels to start from.
size_t WriteSeed(uint8_t* data, size_t most, unsigned seed)
{
  const int modes[] = { 0, 1, 2, 3, 4, 6, 12, 16, 101 };
  const int orders[][3] = { { 1, 2, 3 }, { 2, 1, 3 }, { 3, 2, 1 }, { 3, 1, 2 } };
  const bool bigEndian = seed % 2 > 0;
  std::int32_t header[256] = { 5, 4, 3, modes[seed % 9] };
  const float length = 10.0f;
  const float angle = seed % 5 > 0 ? 90.0f : 105.0f;
  for (int i = 0; i < 3; ++i)
  {
    header[7 + i] = 5 - i;
    std::memcpy(header + 10 + i, &length, 4);
    std::memcpy(header + 13 + i, &angle, 4);
    header[16 + i] = orders[seed % 4][i];
  }
  header[22] = seed % 7 > 0 ? 1 : 401;
  auto* const bytes = reinterpret_cast<uint8_t*>(header);
  for (int i = 0; bigEndian && i < 256; ++i)
  {
    std::reverse(bytes + 4 * i, bytes + 4 * i + 4);
  }
  std::memcpy(bytes + 208, "MAP ", 4);
  std::memcpy(bytes + 212, bigEndian ? "\x11\x11\0\0" : "DD\0\0", 4);
  const size_t size = std::min<size_t>(most, choices + 1024 + 60 * 8);
  std::memset(data, static_cast<int>(seed % 256), size);
  data[0] = static_cast<uint8_t>(seed / 9);
  std::memcpy(data + choices, bytes, std::min<size_t>(1024, size - choices));
  return size;
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
  if (most > choices + 1024 && (size < choices + 1024 || seed % 64 == 0))
  {
    size = WriteSeed(data, most, seed / 64);
  }
  return LLVMFuzzerMutate(data, size, most);
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  if (size < choices)
  {
    return 0;
  }
  const char* const endings[] = { ".mrc", ".mrcs", ".st", ".map.gz" };
  std::string content(reinterpret_cast<const char*>(data) + choices, size - choices);
  switch (data[0] % 4)
  {
    case 1:
      content = Gzip(content, 1);
      break;
    case 2:
      content = Bzip2(content, 1);
      break;
    default:
      break; // unchanged: plain, or a compressed stream created by the fuzzer
  }
  if (data[0] & 64) // truncated or damaged after compression
  {
    content.resize(content.size() - content.size() * (data[1] % 16) / 32);
  }
  const std::string path =
    isthmus::testing::Folder().Write(std::string("map") + endings[data[1] / 16 % 4], content.data(),
      content.data() + content.size());
  ReadAsChosen(data, path.c_str());
  return 0;
}
