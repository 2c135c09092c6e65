// ISA-L compared with zlib on whole, truncated and damaged gzip data, in pieces of any size: the
// same bytes, the same ends of members, the same refusals.

#include "Files/Codecs.h"
#include "Files/OpenByteSource.h"
#include "SharedData.h"
#include "TemporaryFile.h"

#include <gtest/gtest.h>

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>

namespace
{

using isthmus::CodecState;
using Zlib = isthmus::BasicGzipCodec<isthmus::ZlibInflater>;

/// Random, mostly zero, of four letters, or one value: stored, skewed and flat blocks.
std::string Content(std::mt19937& random)
{
  std::string content(random() % (random() % 3 == 0 ? 300000 : 3000), '\0');
  const auto kind = random() % 4;
  for (char& c : content)
  {
    c = kind == 0 ? static_cast<char>(random())
      : kind == 1 ? static_cast<char>(random() % 16 == 0 ? random() : 0)
      : kind == 2 ? "ACGT"[random() % 4]
                  : '\0';
  }
  return content;
}

/// Compressed as by gzip, at any level and by any strategy, with or without the optional header
/// fields.
std::string CompressRandomly(std::string content, std::mt19937& random)
{
  z_stream stream{};
  deflateInit2(&stream, static_cast<int>(random() % 10), Z_DEFLATED, 16 + MAX_WBITS, 8,
    static_cast<int>(random() % 5));
  std::string name = "a map", comment = "words", extra = "more";
  gz_header header{};
  if (random() % 2 == 0)
  {
    header.name = reinterpret_cast<Bytef*>(&name[0]);
    header.comment = reinterpret_cast<Bytef*>(&comment[0]);
    header.extra = reinterpret_cast<Bytef*>(&extra[0]);
    header.extra_len = static_cast<uInt>(extra.size());
    header.hcrc = 1;
    deflateSetHeader(&stream, &header);
  }
  std::string packed(deflateBound(&stream, content.size()) + 100, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(&content[0]);
  stream.avail_in = static_cast<uInt>(content.size());
  stream.next_out = reinterpret_cast<Bytef*>(&packed[0]);
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

struct Unpacked
{
  std::string Content;
  CodecState State = CodecState::Running; ///< at the end: MemberEnd, or Running for truncated data
  std::size_t Left = 0;                   ///< of the input, behind the member
};

template <typename Codec>
Unpacked Unpack(std::string packed, std::mt19937 random)
{
  Codec codec;
  Unpacked result;
  auto* in = reinterpret_cast<unsigned char*>(&packed[0]);
  std::size_t left = packed.size();
  std::string room(100000, '\0');
  constexpr std::size_t header = 200; // comes in one piece
  for (bool moved = true; moved && result.State == CodecState::Running;)
  {
    const std::size_t most = random() % 2 == 0 ? 100 : room.size();
    const std::size_t least = left == packed.size() ? header : 1;
    const std::size_t piece = std::min(left, least + random() % most);
    const std::size_t space = 1 + random() % most;
    std::size_t inSize = piece, outSize = space;
    auto* out = reinterpret_cast<unsigned char*>(&room[0]);
    result.State = codec.Step(in, inSize, out, outSize);
    result.Content.append(room, 0, space - outSize);
    left -= piece - inSize;
    moved = inSize < piece || outSize < space;
  }
  result.Left = left;
  return result;
}

#ifdef ISTHMUS_HAS_ISAL
constexpr bool HasIsal = true;
#else
constexpr bool HasIsal = false;
#endif

}

TEST(GzipCodec, UnpacksAsZlibDoes)
{
  if (!HasIsal)
  {
    // In CI, where it is installed, its absence is a failure.
    ASSERT_FALSE(isthmus::testing::SharedDataRequired()) << "built without ISA-L (libisal-dev)";
    GTEST_SKIP() << "built without ISA-L (libisal-dev)";
  }
  std::mt19937 random(20261122);
  int whole = 0, damaged = 0;
  for (int i = 0; i < 400; ++i)
  {
    const std::string content = Content(random);
    std::string packed = CompressRandomly(content, random);
    const std::size_t size = packed.size();
    const auto fate = random() % 4;
    if (fate == 0)
    {
      packed.resize(1 + random() % (size - 1)); // breaks off
    }
    else if (fate == 1)
    {
      packed[random() % size] ^= static_cast<char>(1 << random() % 8);
    }
    packed +=
      std::string(fate == 0 ? 0 : random() % 100, '\x1f'); // the rest belongs to the next member
    const auto seed = static_cast<std::mt19937::result_type>(i);
    const Unpacked theirs = Unpack<Zlib>(packed, std::mt19937(seed));
    const Unpacked ours = Unpack<isthmus::GzipCodec>(packed, std::mt19937(seed));
    if (theirs.State == CodecState::MemberEnd)
    {
      ++whole;
      ASSERT_EQ(ours.State, CodecState::MemberEnd) << i;
      ASSERT_EQ(ours.Content, theirs.Content) << i;
      ASSERT_EQ(ours.Left, theirs.Left) << i;
    }
    else if (ours.State == CodecState::MemberEnd)
    {
      ASSERT_EQ(ours.Content, content) << i; // the header had an undefined flag
    }
    else if (fate == 0)
    {
      ASSERT_EQ(ours.State, theirs.State) << i;
      ASSERT_EQ(content.compare(0, ours.Content.size(), ours.Content), 0) << i;
      ASSERT_LE(theirs.Content.size(), ours.Content.size() + 3) << i;
    }
    damaged += theirs.State == CodecState::Damaged ? 1 : 0;
  }
  EXPECT_GT(whole, 150);
  EXPECT_GT(damaged, 50);
}

/// A member that ends within the bytes read ahead: the next one begins with the remaining ones.
TEST(GzipCodec, ConsecutiveLargeMembers)
{
  std::mt19937 random(4);
  std::string content, packed;
  for (int member = 0; member < 4; ++member)
  {
    std::string part(700001, '\0');
    std::generate(part.begin(), part.end(), [&random]() { return static_cast<char>(random()); });
    content += part;
    packed += isthmus::testing::Gzip(part, 1);
  }
  const isthmus::testing::TemporaryFile file(packed, "members.gz");
  const auto source = isthmus::OpenByteSource(file.Path());
  EXPECT_TRUE(isthmus::ReadAll(*source) == content);
}
