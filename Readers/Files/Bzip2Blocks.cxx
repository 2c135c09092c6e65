#include "Files/Bzip2Blocks.h"

#include "Core/ParallelFor.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace isthmus
{
namespace
{

constexpr std::size_t roomBytes = std::size_t{ 1 } << 20;
constexpr std::size_t blocksAThread = 2; // some take longer than others
constexpr std::size_t headerBytes = 4;

}

/// A block, its first MiB, and libbz2 where there is more of it.
class Bzip2Blocks::Unpacked
{
public:
  explicit Unpacked(Bzip2Block block)
    : Block(std::move(block))
  {
  }

  /// All that takes long: codes and sorting are undone before the first byte comes out.
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
    // With room left it wants more input; and codes that end elsewhere than the block was cut are
    // another's.
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
  bool HandOut(unsigned char*& out, std::size_t& outSize)
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

Bzip2Blocks::Bzip2Blocks() = default;
Bzip2Blocks::~Bzip2Blocks() = default;

CodecState Bzip2Blocks::Step(
  unsigned char*& in, std::size_t& inSize, unsigned char*& out, std::size_t& outSize)
{
  const bool last = inSize == 0;
  for (;;)
  {
    if (!this->HandOut(out, outSize))
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
void Bzip2Blocks::Gather(unsigned char*& in, std::size_t& inSize)
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
    // With fewer bytes than tell a member, whoever has the file looks.
    this->Ended = found == Found::MemberEnd && (inSize < headerBytes || !StartsMember(in, inSize));
  }
}

void Bzip2Blocks::UnpackAll()
{
  for (Bzip2Block& block : this->Waiting)
  {
    this->Ready.push_back(std::make_unique<Unpacked>(std::move(block)));
  }
  this->Waiting.clear();
  this->WaitingBlocks = 0;
  ParallelFor(0, static_cast<std::int64_t>(this->Ready.size()), 1,
    [this](std::int64_t first, std::int64_t end)
    {
      for (std::int64_t i = first; i < end; ++i)
      {
        Unpacked& block = *this->Ready[static_cast<std::size_t>(i)];
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
bool Bzip2Blocks::HandOut(unsigned char*& out, std::size_t& outSize)
{
  while (!this->Ready.empty())
  {
    Unpacked& front = *this->Ready.front();
    if (!front.HandOut(out, outSize))
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
