#include "Files/ParallelBzip2.h"

#include "Core/ParallelFor.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace isthmus
{
namespace
{

constexpr std::uint64_t magicBits = 48;
constexpr std::uint64_t checksumBits = 32;
constexpr std::uint64_t blockMagic = 0x314159265359;
constexpr std::uint64_t endMagic = 0x177245385090;
constexpr std::uint64_t magicMask = (std::uint64_t{ 1 } << magicBits) - 1;
constexpr std::size_t headerBytes = 4;
// 900,000 symbols of at most 20 bits, and the tables of their codes, are 2.3 MB.
constexpr std::size_t longestBlock = std::size_t{ 1 } << 22;

/// For each value of the last byte but one: the distances in bits from the end of the last byte at
/// which a magic may end.
/// Only where such a byte occurs are the 48 bits compared, at each bit.
std::array<unsigned char, 256> PossibleEnds()
{
  std::array<unsigned char, 256> ends{};
  for (unsigned shift = 0; shift < 8; ++shift)
  {
    for (const std::uint64_t magic : { blockMagic, endMagic })
    {
      auto& shifts = ends[((magic << shift) >> 8) & 0xff];
      shifts = static_cast<unsigned char>(shifts | 1u << shift);
    }
  }
  return ends;
}

constexpr std::size_t roomBytes = std::size_t{ 1 } << 20;
constexpr std::size_t blocksAThread = 2; // some take longer than others

}

Bzip2BlockFinder::Found Bzip2BlockFinder::Take(
  unsigned char*& in, std::size_t& inSize, Bzip2Block& block)
{
  static const std::array<unsigned char, 256> possible = PossibleEnds();
  Found found = Found::Nothing;
  for (; inSize > 0 && found == Found::Nothing; ++in, --inSize)
  {
    this->Bytes.push_back(*in);
    this->Window = this->Window << 8 | *in;
    if (this->Now == Stage::Block)
    {
      if (possible[this->Window >> 8 & 0xff])
      {
        found = this->TakeBlockByte(block);
      }
      if (this->Bytes.size() > longestBlock)
      {
        found = Found::Foreign;
      }
    }
    else
    {
      found = this->Now == Stage::Header ? this->TakeHeader() : this->TakeChecksum(block);
    }
  }
  return found;
}

/// "BZh", the level, and the first magic, all at whole bytes.
Bzip2BlockFinder::Found Bzip2BlockFinder::TakeHeader()
{
  if (this->Bytes.size() < headerBytes + magicBits / 8)
  {
    return Found::Nothing;
  }
  const std::uint64_t magic = this->Window & magicMask;
  this->Level = this->Bytes[3];
  const bool known = this->Bytes[0] == 'B' && this->Bytes[1] == 'Z' && this->Bytes[2] == 'h' &&
    this->Level >= '1' && this->Level <= '9' && (magic == blockMagic || magic == endMagic);
  this->Bytes.erase(this->Bytes.begin(), this->Bytes.begin() + headerBytes);
  this->FirstBit = 0;
  this->Now = magic == blockMagic ? Stage::Block : Stage::Checksum;
  return known ? Found::Nothing : Found::Foreign;
}

Bzip2BlockFinder::Found Bzip2BlockFinder::TakeBlockByte(Bzip2Block& block)
{
  for (std::uint64_t shift = 0; shift < 8; ++shift)
  {
    const std::uint64_t magic = this->Window >> shift & magicMask;
    const std::uint64_t end = 8 * this->Bytes.size() - shift;
    const std::uint64_t shortest = this->FirstBit + 2 * magicBits + checksumBits;
    if ((magic == blockMagic || magic == endMagic) && end > shortest)
    {
      this->Cut(end - magicBits, block);
      const auto first = static_cast<std::ptrdiff_t>((end - magicBits) / 8);
      this->Bytes.erase(this->Bytes.begin(), this->Bytes.begin() + first);
      this->FirstBit = (end - magicBits) % 8;
      this->Now = magic == blockMagic ? Stage::Block : Stage::Checksum;
      return Found::Block;
    }
  }
  return Found::Nothing;
}

Bzip2BlockFinder::Found Bzip2BlockFinder::TakeChecksum(Bzip2Block& block)
{
  if (8 * this->Bytes.size() < this->FirstBit + magicBits + checksumBits)
  {
    return Found::Nothing;
  }
  block = Bzip2Block{ {}, 0, this->WordAt(this->FirstBit + magicBits) };
  this->Bytes.clear();
  this->Now = Stage::Header;
  return Found::MemberEnd;
}

/// The block up to the bit `end` after a new header and followed by a new end marker.
void Bzip2BlockFinder::Cut(std::uint64_t end, Bzip2Block& block) const
{
  block.Checksum = this->WordAt(this->FirstBit + magicBits);
  const std::uint64_t bits = end - this->FirstBit;
  block.DataBits = 8 * headerBytes + bits;
  block.Stream = { 'B', 'Z', 'h', this->Level };
  block.Stream.resize(headerBytes + (bits + 7) / 8 + (magicBits + checksumBits) / 8 + 1);
  // Two bytes at a time: there is another one, since the magic follows the block.
  unsigned char* to = block.Stream.data() + headerBytes;
  const unsigned char* const from = this->Bytes.data();
  const auto left = static_cast<unsigned>(this->FirstBit);
  const std::size_t bytes = (bits + 7) / 8;
  for (std::size_t i = 0; i < bytes; ++i)
  {
    to[i] = static_cast<unsigned char>((from[i] << 8 | from[i + 1]) >> (8 - left));
  }
  const auto used = static_cast<unsigned>(bits % 8); // of the last byte
  to += used ? bytes - 1 : bytes;
  *to = static_cast<unsigned char>(used ? *to & 0xff00 >> used : 0);
  const auto append = [&to, used](std::uint64_t value, std::uint64_t valueBits)
  {
    for (std::uint64_t at = valueBits; at > 0; at -= 8)
    {
      const auto byte = static_cast<unsigned>(value >> (at - 8) & 0xff);
      *to = static_cast<unsigned char>(*to | byte >> used);
      *++to = static_cast<unsigned char>(byte << (8 - used));
    }
  };
  append(endMagic, magicBits);
  append(block.Checksum, checksumBits);
  block.Stream.resize((block.DataBits + magicBits + checksumBits + 7) / 8);
}

std::uint32_t Bzip2BlockFinder::WordAt(std::uint64_t bit) const
{
  std::uint64_t word = 0;
  const unsigned char* const from = this->Bytes.data() + bit / 8;
  // A fifth byte exists if the word does not end with the fourth.
  const std::size_t bytes = bit % 8 ? 5 : 4;
  for (std::size_t i = 0; i < bytes; ++i)
  {
    word = word << 8 | from[i];
  }
  return static_cast<std::uint32_t>(bit % 8 ? word >> (8 - bit % 8) : word);
}

/// A block, its first MiB, and libbz2 for the rest.
class ParallelBzip2::DecodedBlock
{
public:
  explicit DecodedBlock(Bzip2Block block)
    : Block(std::move(block))
  {
  }

  /// The slow part: codes and sorting are undone before the first byte is output.
  void Start()
  {
    this->Codec = std::make_unique<Bzip2Codec>();
    this->Room.reset(new unsigned char[roomBytes]);
    this->In = this->Block.Stream.data();
    this->Left = this->Block.Stream.size();
    unsigned char* out = this->Room.get();
    std::size_t room = roomBytes;
    this->State = this->Codec->Step(this->In, this->Left, out, room);
    this->Held = roomBytes - room;
    // If output space remains, the decoder needs more input; codes that do not end with the block
    // belong to another one.
    const std::uint64_t used = this->Block.Stream.size() - this->Left;
    if (this->State == CodecState::Running && (room > 0 || used != (this->Block.DataBits + 7) / 8))
    {
      this->State = CodecState::Damaged;
    }
    if (this->State != CodecState::Running)
    {
      this->Codec.reset();
    }
  }

  /// False where the block is damaged.
  bool CopyOutput(unsigned char*& out, std::size_t& outSize)
  {
    if (this->State == CodecState::Damaged)
    {
      return false;
    }
    const std::size_t size = std::min(outSize, this->Held - this->Given);
    if (size > 0)
    {
      std::memcpy(out, this->Room.get() + this->Given, size);
      this->Given += size;
      out += size;
      outSize -= size;
    }
    if (outSize > 0 && this->State == CodecState::Running)
    {
      this->State = this->Codec->Step(this->In, this->Left, out, outSize);
      return this->State == CodecState::MemberEnd ||
        (this->State == CodecState::Running && outSize == 0);
    }
    return true;
  }

  bool IsEmpty() const { return this->State == CodecState::MemberEnd && this->Given == this->Held; }

  bool IsMemberEnd() const { return this->Block.Stream.empty(); }

  Bzip2Block Block;

private:
  std::unique_ptr<Bzip2Codec> Codec;
  std::unique_ptr<unsigned char[]> Room;
  unsigned char* In = nullptr;
  std::size_t Left = 0;
  std::size_t Held = 0;
  std::size_t Given = 0;
  CodecState State = CodecState::MemberEnd;
};

ParallelBzip2::ParallelBzip2() = default;
ParallelBzip2::~ParallelBzip2() = default;

std::unique_ptr<ParallelBzip2> ParallelBzip2::Copy() const
{
  if (!this->Ready.empty() || this->Waiting.size() > 1)
  {
    return nullptr;
  }
  auto copy = std::make_unique<ParallelBzip2>();
  copy->Finder = this->Finder;
  copy->Waiting = this->Waiting;
  copy->WaitingBlocks = this->WaitingBlocks;
  copy->AtOnce = this->AtOnce;
  copy->Checksum = this->Checksum;
  copy->Ended = this->Ended;
  copy->Foreign = this->Foreign;
  return copy;
}

CodecState ParallelBzip2::Step(
  unsigned char*& in, std::size_t& inSize, unsigned char*& out, std::size_t& outSize)
{
  const bool last = inSize == 0;
  for (;;)
  {
    if (!this->CopyOutput(out, outSize))
    {
      return CodecState::Damaged;
    }
    if (!this->Ready.empty())
    {
      return CodecState::Running;
    }
    this->Gather(in, inSize);
    if (this->Waiting.empty() && (this->Foreign || this->Ended))
    {
      return this->Foreign ? CodecState::Damaged : CodecState::MemberEnd;
    }
    const bool enough = this->WaitingBlocks == this->AtOnce || this->Foreign || this->Ended || last;
    if (outSize == 0 || this->Waiting.empty() || !enough)
    {
      return CodecState::Running;
    }
    this->UnpackAll();
  }
}

/// Cuts the input until there are as many blocks as are unpacked at once.
/// The first block comes alone, then two together, and so on: reading a header takes the time of
/// one block.
void ParallelBzip2::Gather(unsigned char*& in, std::size_t& inSize)
{
  using Found = Bzip2BlockFinder::Found;
  while (inSize > 0 && !this->Ended && !this->Foreign && this->WaitingBlocks < this->AtOnce)
  {
    Bzip2Block block;
    const Found found = this->Finder.Take(in, inSize, block);
    this->Foreign = found == Found::Foreign;
    if (found == Found::Block || found == Found::MemberEnd)
    {
      this->WaitingBlocks += found == Found::Block ? 1 : 0;
      this->Waiting.push_back(std::move(block));
    }
    // With too few bytes to recognise a member, the caller checks the file.
    this->Ended = found == Found::MemberEnd && (inSize < headerBytes || !StartsMember(in, inSize));
  }
}

void ParallelBzip2::UnpackAll()
{
  for (Bzip2Block& block : this->Waiting)
  {
    this->Ready.push_back(std::make_unique<DecodedBlock>(std::move(block)));
  }
  this->Waiting.clear();
  this->WaitingBlocks = 0;
  ParallelFor(0, static_cast<std::int64_t>(this->Ready.size()), 1,
    [this](std::int64_t first, std::int64_t end)
    {
      for (std::int64_t i = first; i < end; ++i)
      {
        DecodedBlock& block = *this->Ready[static_cast<std::size_t>(i)];
        if (!block.IsMemberEnd())
        {
          block.Start();
        }
      }
    });
  this->AtOnce =
    std::min(2 * this->AtOnce, blocksAThread * static_cast<std::size_t>(ParallelThreads()));
}

/// False where a block or a member is damaged.
bool ParallelBzip2::CopyOutput(unsigned char*& out, std::size_t& outSize)
{
  while (!this->Ready.empty())
  {
    DecodedBlock& front = *this->Ready.front();
    if (!front.CopyOutput(out, outSize))
    {
      return false;
    }
    if (!front.IsEmpty())
    {
      return true;
    }
    const std::uint32_t checksum = front.Block.Checksum;
    if (!front.IsMemberEnd())
    {
      this->Checksum = (this->Checksum << 1 | this->Checksum >> 31) ^ checksum;
    }
    else if (std::exchange(this->Checksum, 0) != checksum)
    {
      return false;
    }
    this->Ready.pop_front();
  }
  return true;
}

}
