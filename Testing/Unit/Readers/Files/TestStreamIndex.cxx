// Parts of compressed files that were decompressed before: the same bytes from any place, without
// what lies before it.

#include "Files/Codecs.h"
#include "Files/OpenByteSource.h"
#include "Files/ReaderError.h"
#include "TemporaryFile.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>

namespace
{

using isthmus::ByteSource;
using isthmus::testing::Bzip2;
using isthmus::testing::Gzip;
using isthmus::testing::TemporaryFile;

constexpr std::size_t Size = std::size_t{ 72 } << 20;

/// Runs of 64 bytes of one value, so that it is compressed in about a second.
const std::string& Content()
{
  static const std::string content = []
  {
    std::string bytes(Size, '\0');
    std::uint64_t state = 1;
    for (std::size_t n = 0; n < Size; n += 64)
    {
      state = state * 6364136223846793005u + 1442695040888963407u;
      std::fill_n(
        bytes.begin() + static_cast<std::ptrdiff_t>(n), 64, static_cast<char>(state >> 56));
    }
    return bytes;
  }();
  return content;
}

std::string Part(ByteSource& source, std::size_t offset)
{
  std::string part(1000, '\0');
  part.resize(source.Read(offset, part.data(), part.size()));
  return part;
}

/// Destroys the second hundred of bytes of a file, so that it seems not to have been changed.
void DestroyTheBeginning(const char* path)
{
  struct stat before = {};
  ASSERT_EQ(stat(path, &before), 0);
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(100);
    file << std::string(100, '\x55');
  }
  const timespec times[2] = { before.st_atim, before.st_mtim };
  ASSERT_EQ(utimensat(AT_FDCWD, path, times, 0), 0);
}

void ExpectPartsWithoutTheBeginning(const TemporaryFile& file)
{
  const std::string& content = Content();
  {
    const auto source = isthmus::OpenByteSource(file.Path());
    EXPECT_EQ(source->CountUpTo(2 * Size, {}), Size);
    for (const std::size_t offset : { Size - 1000, Size / 2, std::size_t{ 5 }, Size / 3 * 2 })
    {
      EXPECT_TRUE(Part(*source, offset) == content.substr(offset, 1000)) << offset;
    }
  }
  DestroyTheBeginning(file.Path());
  const auto later = isthmus::OpenByteSource(file.Path());
  for (const std::size_t offset : { Size / 4 * 3, Size - 500, Size / 4 * 3 + 1000 })
  {
    EXPECT_TRUE(Part(*later, offset) == content.substr(offset, 1000)) << offset;
  }
  later->CheckEnd(); // the checksum counts what was decompressed before
  EXPECT_FALSE(later->IsCut());
  EXPECT_THROW(
    { EXPECT_FALSE(Part(*later, 1000) == content.substr(1000, 1000)); }, isthmus::ReaderError);
}

}

TEST(StreamIndex, ACopyOfADecoderContinuesAlone)
{
  using Zlib = isthmus::BasicGzipCodec<isthmus::ZlibInflater>;
  const std::string content = Content().substr(0, 1 << 20);
  std::string packed = Gzip(content);
  const auto check = [&](auto decoder)
  {
    auto* in = reinterpret_cast<unsigned char*>(packed.data());
    std::size_t inSize = packed.size() / 2, outSize = content.size();
    std::string first(content.size(), '\0');
    auto* out = reinterpret_cast<unsigned char*>(first.data());
    decoder.Step(in, inSize, out, outSize);
    const auto copy = decoder.Copy();
    std::string second = first;
    for (std::string* const text : { &first, &second })
    {
      unsigned char* next = in;
      auto* to = reinterpret_cast<unsigned char*>(text->data()) + content.size() - outSize;
      std::size_t left = packed.size() - packed.size() / 2 + inSize, room = outSize;
      auto& one = text == &first ? decoder : *copy;
      EXPECT_EQ(one.Step(next, left, to, room), isthmus::CodecState::MemberEnd);
      EXPECT_TRUE(*text == content);
    }
  };
  check(isthmus::GzipCodec());
  check(Zlib());
}

TEST(StreamIndex, GzipContinuesFromKnownPlaces)
{
  ExpectPartsWithoutTheBeginning(TemporaryFile(Gzip(Content(), 1), "map.gz"));
}

TEST(StreamIndex, Bzip2ContinuesFromKnownPlaces)
{
  const TemporaryFile file(Bzip2(Content(), 1), "map.bz2");
  vtkSMPTools::LocalScope(vtkSMPTools::Config(2, std::string("STDThread"), false),
    [&] { ExpectPartsWithoutTheBeginning(file); });
}

TEST(StreamIndex, AnotherContentHasAnotherIndex)
{
  const TemporaryFile file(Gzip(Content(), 1), "map.gz");
  EXPECT_EQ(isthmus::OpenByteSource(file.Path())->CountUpTo(2 * Size, {}), Size);
  std::string other = Content();
  std::reverse(other.begin(), other.end());
  std::ofstream(file.Path(), std::ios::binary | std::ios::trunc) << Gzip(other, 1);
  const auto source = isthmus::OpenByteSource(file.Path());
  EXPECT_TRUE(Part(*source, Size / 4 * 3) == other.substr(Size / 4 * 3, 1000));
}
