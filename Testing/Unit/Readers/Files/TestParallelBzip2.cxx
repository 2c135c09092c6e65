// bzip2 files decompressed block by block, compared with libbz2 alone: the same bytes, the same
// ends, and the same place of damage, for any number of threads.

#include "Files/OpenByteSource.h"
#include "Files/ReaderError.h"
#include "TemporaryFile.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <optional>
#include <random>
#include <string>

#include <unistd.h>

namespace
{

using isthmus::testing::Bzip2;
using isthmus::testing::TemporaryFile;

/// The result of libbz2 for a file, member after member.
struct Truth
{
  std::string Content;
  std::optional<std::size_t> DamagedAt; ///< bytes of the file that libbz2 had used by then
  bool Cut = false;
};

Truth ByLibbz2(std::string packed)
{
  Truth truth;
  std::string room(1 << 20, '\0');
  std::size_t at = 0;
  int state = BZ_STREAM_END;
  while (state == BZ_STREAM_END && (at == 0 || packed.compare(at, 3, "BZh") == 0))
  {
    bz_stream stream{};
    BZ2_bzDecompressInit(&stream, 0, 0);
    stream.next_in = &packed[at];
    stream.avail_in = static_cast<unsigned int>(packed.size() - at);
    do
    {
      stream.next_out = &room[0];
      stream.avail_out = static_cast<unsigned int>(room.size());
      state = BZ2_bzDecompress(&stream);
      truth.Content.append(room, 0, room.size() - stream.avail_out);
    } while (state == BZ_OK && stream.avail_out == 0);
    at = packed.size() - stream.avail_in;
    BZ2_bzDecompressEnd(&stream);
  }
  truth.Cut = state == BZ_OK;
  if (state < 0)
  {
    truth.DamagedAt = at;
  }
  return truth;
}

/// The result of our source for it, read in pieces of random sizes.
struct ReadResult
{
  std::string Content;
  std::string Message; ///< empty if nothing was thrown
  bool Cut = false;
  bool Careful = false; ///< libbz2 had to read it again
};

ReadResult ByBlocks(const std::string& packed, int threads, unsigned seed)
{
  std::mt19937 random(seed);
  const TemporaryFile file(packed, "data.bz2");
  ReadResult seen;
  const auto read = [&]()
  {
    const std::unique_ptr<isthmus::ByteSource> source = isthmus::OpenByteSource(file.Path());
    EXPECT_EQ(source->Compression(), "bzip2");
    EXPECT_EQ(source->UsesThreads(), threads > 1);
    try
    {
      for (std::size_t got = 1, wanted = 1; got == wanted;)
      {
        wanted = 1 + random() % (random() % 2 ? 400000 : 2000);
        const std::size_t at = seen.Content.size();
        seen.Content.resize(at + wanted);
        got = 0;
        got = source->Read(at, &seen.Content[at], wanted);
        seen.Content.resize(at + got);
      }
      source->CheckEnd();
    }
    catch (const isthmus::ReaderError& error)
    {
      seen.Message = error.what();
    }
    seen.Cut = source->IsCut();
    seen.Careful = threads > 1 && !source->UsesThreads();
  };
  vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false), read);
  return seen;
}

/// Noise, text or runs of one value, of one to several blocks of 100 kB.
std::string Content(std::mt19937& random)
{
  std::string content(random() % (random() % 3 == 0 ? 700000 : 150000), '\0');
  const auto kind = random() % 3;
  for (std::size_t i = 0; i < content.size(); ++i)
  {
    content[i] = kind == 0 ? static_cast<char>(random())
      : kind == 1          ? "ACGT"[random() % 4]
                           : static_cast<char>(i / 5000);
  }
  return content;
}

/// Members as bzip2 (one, many blocks) and pbzip2 (one block each) write them.
std::string CompressRandomly(std::mt19937& random, std::string& content)
{
  std::string packed;
  for (auto members = 1 + random() % 3; members > 0; --members)
  {
    const std::string part = Content(random);
    packed += Bzip2(part, random() % 4 == 0 ? 9 : 1);
    content += part;
  }
  return packed;
}

void ExpectSame(const std::string& packed, int threads, unsigned seed)
{
  const Truth truth = ByLibbz2(packed);
  const ReadResult seen = ByBlocks(packed, threads, seed);
  ASSERT_EQ(seen.Message.empty(), !truth.DamagedAt) << seen.Message;
  ASSERT_EQ(seen.Cut, truth.Cut);
  if (truth.DamagedAt)
  {
    const std::string where = "before byte " + std::to_string(*truth.DamagedAt) + " of the file";
    ASSERT_NE(seen.Message.find(where), std::string::npos) << seen.Message << " " << where;
    // The piece in which it was noticed is missing.
    ASSERT_LE(seen.Content.size(), truth.Content.size() + 400000);
  }
  else
  {
    ASSERT_EQ(seen.Content, truth.Content);
  }
}

}

TEST(ParallelBzip2, UnpackAsLibbz2Does)
{
  std::mt19937 random(20261123);
  for (unsigned i = 0; i < 40; ++i)
  {
    std::string content;
    const std::string packed =
      CompressRandomly(random, content) + std::string(random() % 3 ? 0 : random() % 50, '\x1f');
    const ReadResult seen = ByBlocks(packed, 1 + static_cast<int>(i % 4), i);
    ASSERT_EQ(seen.Message, "") << i;
    ASSERT_FALSE(seen.Cut) << i;
    ASSERT_FALSE(seen.Careful) << i;
    ASSERT_TRUE(seen.Content == content) << i;
  }
}

TEST(ParallelBzip2, ReportDamageAsLibbz2Does)
{
  std::mt19937 random(7);
  const std::string magic = "\x31\x41\x59\x26\x53\x59";
  const std::string end = "\x17\x72\x45\x38\x50\x90";
  int damaged = 0, cut = 0;
  for (unsigned i = 0; i < 80; ++i)
  {
    SCOPED_TRACE(i);
    std::string content;
    std::string packed = CompressRandomly(random, content);
    const auto at = 4 + random() % (packed.size() - 10);
    switch (i % 4)
    {
      case 0:
        packed.resize(at);
        break;
      case 1:
        packed[at] = static_cast<char>(packed[at] ^ (1 << random() % 8));
        break;
      case 2: // bytes that look like the begin or the end of a block
        packed.replace(at, 6, random() % 2 ? magic : end);
        break;
      default: // the following bytes begin like a member
        packed += "BZh" + std::string(random() % 30, random() % 2 ? '9' : 'x');
    }
    ExpectSame(packed, 1 + static_cast<int>(random() % 4), i);
    const Truth truth = ByLibbz2(packed);
    damaged += truth.DamagedAt ? 1 : 0;
    cut += truth.Cut ? 1 : 0;
  }
  EXPECT_GT(damaged, 30);
  EXPECT_GT(cut, 15);
}

TEST(ParallelBzip2, ChecksumOfAMemberIsCompared)
{
  std::mt19937 random(3);
  const std::string content = Content(random);
  std::string packed = Bzip2(content, 1);
  const auto last = packed.size() - 2; // within the member's checksum, wherever it ends
  packed[last] = static_cast<char>(packed[last] ^ 0x10);
  ASSERT_TRUE(ByLibbz2(packed).DamagedAt);
  for (const int threads : { 1, 2, 4 })
  {
    ExpectSame(packed, threads, 1);
  }
}

TEST(ParallelBzip2, EmptyMembersAndOffsetsBefore)
{
  const std::string text = "a few words";
  const TemporaryFile file(Bzip2("") + Bzip2(text) + Bzip2("") + Bzip2(text), "data.bz2");
  const auto read = [&]()
  {
    const auto source = isthmus::OpenByteSource(file.Path());
    EXPECT_EQ(isthmus::ReadAll(*source), text + text);
    std::string word(5, ' ');
    for (const std::size_t at : { text.size() + 6, std::size_t{ 6 } })
    {
      EXPECT_EQ(source->Read(at, &word[0], 5), 5u);
      EXPECT_EQ(word, "words");
    }
    EXPECT_EQ(source->CountUpTo(1000, {}), 2 * text.size());
    EXPECT_TRUE(source->UsesThreads()); // libbz2 alone was not needed
  };
  vtkSMPTools::LocalScope(vtkSMPTools::Config(2, "STDThread", false), read);
}

TEST(ParallelBzip2, RunsOfOneValueTakeNoMemory)
{
  const auto resident = []()
  {
    std::size_t all = 0, held = 0;
    std::ifstream("/proc/self/statm") >> all >> held;
    return static_cast<double>(held) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  };
  constexpr std::size_t size = 200'000'000; // five blocks of 46 MB
  const TemporaryFile file(Bzip2(std::string(size, '\7')), "data.bz2");
  const double before = resident();
  double most = 0.0;
  std::size_t sum = 0;
  const auto read = [&]()
  {
    const auto source = isthmus::OpenByteSource(file.Path());
    std::string piece(1 << 20, '\0');
    for (std::size_t at = 0, got = piece.size(); got == piece.size(); at += got)
    {
      got = source->Read(at, &piece[0], piece.size());
      sum += static_cast<std::size_t>(std::count(&piece[0], &piece[0] + got, '\7'));
      most = std::max(most, resident() - before);
    }
  };
  vtkSMPTools::LocalScope(vtkSMPTools::Config(4, "STDThread", false), read);
  EXPECT_EQ(sum, size);
  EXPECT_LT(most, 4 * 13e6 + 5e6);
  EXPECT_GT(most, 4e6); // it was measured while blocks existed
}

TEST(ParallelBzip2, BlocksThatEndAtAnyBit)
{
  const auto read = []()
  {
    for (std::size_t size = 1; size < 60; ++size)
    {
      const std::string text(size, 'x');
      const TemporaryFile file(Bzip2(text + "y" + text), "data.bz2");
      const auto source = isthmus::OpenByteSource(file.Path());
      EXPECT_EQ(isthmus::ReadAll(*source), text + "y" + text) << size;
      EXPECT_TRUE(source->UsesThreads()) << size; // libbz2 alone was not needed
    }
  };
  vtkSMPTools::LocalScope(vtkSMPTools::Config(2, "STDThread", false), read);
}
