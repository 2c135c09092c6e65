#include "Maps/MRCHeaderParser.h"

#include "Files/ReaderError.h"
#include "Maps/MRCHeaderDecoder.h"

namespace isthmus
{
namespace
{

std::string Text(const std::array<int, 3>& values)
{
  return std::to_string(values[0]) + ", " + std::to_string(values[1]) + ", " +
    std::to_string(values[2]);
}

[[noreturn]] void RefuseImpossible(const MRCHeaderWords& words, const std::string& path)
{
  if (!words.HasMapWord())
  {
    throw ReaderError(ReaderFailure::ForeignFormat,
      path + ": this is not an MRC, CCP4 or EMDB map: grid " + Text(words.Ints(1)) + " and mode " +
        std::to_string(words.Int(4)) +
        " (words 1-4) make no sense in either byte order, and the word "
        "\"MAP \" is missing. Choose another file.");
  }
  const bool badMode = !IsKnownMRCMode(words.Int(4));
  throw ReaderError(ReaderFailure::ForeignFormat,
    path + ": the header is damaged: " +
      (badMode ? "mode (word 4) is " + std::to_string(words.Int(4)) +
            ", known are 0, 1, 2, 3, 4, 6, 12, 16 and 101"
               : "the grid NX, NY, NZ (words 1-3) is " + Text(words.Ints(1)) +
            ", which must be positive") +
      ". Fetch or write the file again.");
}

void CheckSize(MRCHeader& header, const std::string& path, std::uint64_t contentBytes, bool exact)
{
  const std::uint64_t data = header.DataBytes();
  if (header.FileBytes() > contentBytes && exact && data <= contentBytes &&
    mrcHeaderBytes + data == contentBytes)
  {
    header.Repairs.push_back("The extended header of " +
      std::to_string(header.ExtendedHeaderBytes) +
      " bytes that NSYMBT (word 24) states is not there: the data begin at byte 1024.");
    header.ExtendedHeaderBytes = 0;
  }
  const std::uint64_t expected = header.FileBytes();
  if (expected > contentBytes)
  {
    throw ReaderError(ReaderFailure::Truncated,
      path + ": the file is truncated or its header lies: " + std::to_string(expected) +
        " bytes expected (header 1024, extended header " +
        std::to_string(header.ExtendedHeaderBytes) + ", " + std::to_string(header.Counts[0]) +
        " x " + std::to_string(header.Counts[1]) + " x " + std::to_string(header.Counts[2]) +
        " voxels of mode " + std::to_string(header.Voxel.Mode) + "), " +
        (exact ? "found " : "found at most ") + std::to_string(contentBytes) +
        ". Fetch the file again.");
  }
  if (exact && expected < contentBytes)
  {
    header.Repairs.push_back(std::to_string(contentBytes - expected) +
      " bytes follow the last voxel that the header describes: left out.");
  }
}

}

MRCHeader ParseMRCHeader(
  const MRCHeaderBytes& bytes, const std::string& path, std::uint64_t contentBytes, bool exact)
{
  const MRCHeaderWords words = ChooseMRCByteOrder(bytes, contentBytes);
  if (!words.Possible())
  {
    RefuseImpossible(words, path);
  }
  MRCHeader header = DecodeMRCHeader(bytes, words);
  CheckSize(header, path, contentBytes, exact);
  return header;
}

bool LooksLikeMRCHeader(const MRCHeaderBytes& bytes, std::uint64_t contentBytes)
{
  const MRCHeaderWords words = ChooseMRCByteOrder(bytes, contentBytes);
  constexpr int everything = 10;
  return words.Possible() && (words.HasMapWord() || words.Plausibility(contentBytes) == everything);
}

}
