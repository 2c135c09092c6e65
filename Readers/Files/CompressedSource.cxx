#include "Files/CompressedSource.h"

#include "Core/ParallelFor.h"
#include "Files/Bzip2Blocks.h"
#include "Files/Bzip2Codec.h"
#include "Files/CodecState.h"
#include "Files/GzipCodec.h"
#include "Files/ReaderError.h"
#include "Files/RetriedSource.h"

#include <algorithm>
#include <vector>

namespace isthmus
{
namespace
{

constexpr std::size_t bufferBytes = std::size_t{ 1 } << 18;

template <typename Codec>
class CompressedSource : public ByteSource
{
public:
  explicit CompressedSource(PlainFile file)
    : File(std::move(file))
    , Input(bufferBytes)
    , Decoder(std::make_unique<Codec>())
  {
  }

  std::size_t Read(std::uint64_t offset, void* to, std::size_t size) override
  {
    this->SkipTo(offset, {});
    return this->Position == offset ? this->Decompress(static_cast<unsigned char*>(to), size) : 0;
  }

  bool RandomAccess() const override { return false; }
  std::uint64_t MostBytes() const override { return Codec::MostBytes(this->File.Size()); }
  std::string Compression() const override { return Codec::Name; }
  std::uint64_t FileSize() const override { return this->File.Size(); }
  const std::string& Path() const override { return this->File.Path(); }

  std::uint64_t CountUpTo(std::uint64_t limit, const ProgressCallback& progress) override
  {
    this->SkipTo(limit, progress);
    return this->Position;
  }

  void SkipTo(std::uint64_t offset, const ProgressCallback& progress) override
  {
    if (offset < this->Position)
    {
      this->Restart();
    }
    const std::uint64_t first = this->Position;
    std::vector<unsigned char> thrownAway(offset > first ? bufferBytes : 0);
    while (this->Position < offset)
    {
      const std::size_t size =
        static_cast<std::size_t>(std::min<std::uint64_t>(offset - this->Position, bufferBytes));
      if (this->Decompress(thrownAway.data(), size) < size)
      {
        return;
      }
      Report(progress,
        static_cast<double>(this->Position - first) / static_cast<double>(offset - first));
    }
  }

  void CheckEnd() override
  {
    // The checksum follows the content; what follows a map is of no use, so don't go far for it.
    this->SkipTo(this->Position + 4 * bufferBytes, {});
  }

  bool IsCut() const override { return this->Cut; }

private:
  void Restart()
  {
    this->Decoder = std::make_unique<Codec>();
    this->Position = this->FilePosition = 0;
    this->Left = 0;
    this->Ended = this->Cut = false;
  }

  std::size_t Decompress(unsigned char* to, std::size_t size)
  {
    std::size_t wanted = size;
    while (wanted > 0 && !this->Ended)
    {
      // Without input left the codec may still hold output that had no room before.
      this->Refill();
      const std::size_t before = wanted + this->Left;
      const CodecState state = this->Decoder->Step(this->Next, this->Left, to, wanted);
      if (state == CodecState::MemberEnd)
      {
        this->Ended = !this->NextMember();
      }
      else if (state == CodecState::Damaged)
      {
        throw ReaderError(ReaderFailure::Damaged,
          this->Path() + ": the " + Codec::Name + " data are damaged before byte " +
            std::to_string(this->FilePosition - this->Left) + " of the file. Test it with '" +
            Codec::Name + " -t', or fetch it again.");
      }
      else if (wanted + this->Left == before)
      {
        this->Ended = this->Cut = true; // the file ends within the stream
      }
    }
    this->Position += size - wanted;
    return size - wanted;
  }

  void Refill()
  {
    if (this->Left == 0)
    {
      this->Left = this->File.Read(this->FilePosition, this->Input.data(), this->Input.size());
      this->FilePosition += this->Left;
      this->Next = this->Input.data();
    }
  }

  /// Looks for a further member; anything else after the end (padding, say) is not content.
  bool NextMember()
  {
    std::copy(this->Next, this->Next + this->Left, this->Input.data());
    const std::size_t got = this->File.Read(
      this->FilePosition, this->Input.data() + this->Left, this->Input.size() - this->Left);
    this->FilePosition += got;
    this->Left += got;
    this->Next = this->Input.data();
    if (!Codec::StartsMember(this->Next, this->Left))
    {
      return false;
    }
    this->Decoder = std::make_unique<Codec>();
    return true;
  }

  PlainFile File;
  std::vector<unsigned char> Input;
  std::unique_ptr<Codec> Decoder;
  std::uint64_t Position = 0;     ///< in the content
  std::uint64_t FilePosition = 0; ///< of the end of Input in the file
  unsigned char* Next = nullptr;
  std::size_t Left = 0;
  bool Ended = false;
  bool Cut = false;
};

}

std::unique_ptr<ByteSource> OpenGzip(PlainFile file)
{
  return std::make_unique<CompressedSource<GzipCodec>>(std::move(file));
}

std::unique_ptr<ByteSource> OpenBzip2(PlainFile file)
{
  if (ParallelThreads() < 2)
  {
    return std::make_unique<CompressedSource<Bzip2Codec>>(std::move(file));
  }
  const std::string path = file.Path();
  return std::make_unique<RetriedSource>(
    std::make_unique<CompressedSource<Bzip2Blocks>>(std::move(file)),
    [path]() { return std::make_unique<CompressedSource<Bzip2Codec>>(PlainFile(path)); });
}

}
