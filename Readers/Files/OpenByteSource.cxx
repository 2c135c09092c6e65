#include "Files/OpenByteSource.h"

#include "Core/LargePages.h"
#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Files/Codecs.h"
#include "Files/ParallelBzip2.h"
#include "Files/PlainFile.h"
#include "Files/ReaderError.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace isthmus
{
namespace
{

class PlainSource : public ByteSource
{
public:
  explicit PlainSource(PlainFile file)
    : File(std::move(file))
  {
  }

  std::size_t Read(std::uint64_t offset, void* to, std::size_t size) override
  {
    return this->File.Read(offset, to, size);
  }
  bool RandomAccess() const override { return true; }
  std::uint64_t MaximumBytes() const override { return this->File.Size(); }
  std::uint64_t CountUpTo(std::uint64_t limit, const ProgressCallback&) override
  {
    return std::min(limit, this->File.Size());
  }
  void SkipTo(std::uint64_t, const ProgressCallback&) override {}
  void CheckEnd() override {}
  bool IsCut() const override { return false; }
  std::string Compression() const override { return "none"; }
  std::uint64_t FileSize() const override { return this->File.Size(); }
  const std::string& Path() const override { return this->File.Path(); }

private:
  PlainFile File;
};

constexpr std::size_t skipBytes = std::size_t{ 1 } << 18;

/// Places of a compressed file from which decompressing can continue: the decoder as it was there.
/// They are collected while a file is decompressed, so that its parts can be read later without
/// what lies before them.
template <typename Codec>
class StreamIndex
{
public:
  struct Place
  {
    std::uint64_t Position = 0;     ///< in the content
    std::uint64_t FilePosition = 0; ///< of the next byte of the file
    std::shared_ptr<const Codec> Decoder;
  };

  /// The index of a file that has this stamp. Those of the last few files are kept.
  static std::shared_ptr<StreamIndex> Of(const std::string& stamp)
  {
    constexpr std::size_t most = 4;
    static std::mutex mutex;
    static std::deque<std::pair<std::string, std::shared_ptr<StreamIndex>>> all;
    const std::lock_guard<std::mutex> lock(mutex);
    const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first == stamp; });
    if (found != all.end())
    {
      return found->second;
    }
    all.emplace_back(stamp, std::make_shared<StreamIndex>());
    if (all.size() > most)
    {
      all.pop_front();
    }
    return all.back().second;
  }

  /// Whether a place at this position would be new and far enough from others.
  bool Wants(std::uint64_t position) const
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const std::uint64_t before = this->Places.empty() ? 0 : this->Places.back().Position;
    return position >= before + this->Distance;
  }

  void Add(Place place)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (!this->Places.empty() && place.Position <= this->Places.back().Position)
    {
      return; // another source was faster
    }
    this->Places.push_back(std::move(place));
    if (this->Places.size() > Codec::MostCopies)
    {
      this->Distance *= 2;
      std::size_t kept = 0;
      for (std::size_t n = 1; n < this->Places.size(); n += 2)
      {
        this->Places[kept++] = this->Places[n];
      }
      this->Places.resize(kept);
    }
  }

  /// The last place up to `position`; without a decoder: the beginning.
  Place Before(std::uint64_t position) const
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto after = std::upper_bound(this->Places.begin(), this->Places.end(), position,
      [](std::uint64_t value, const Place& place) { return value < place.Position; });
    return after == this->Places.begin() ? Place() : *(after - 1);
  }

private:
  mutable std::mutex Mutex;
  std::uint64_t Distance = std::uint64_t{ 1 } << 25; ///< decompressed in a tenth of a second
  std::vector<Place> Places;                         ///< ascending
};

template <typename Codec>
class CompressedSource : public ByteSource
{
public:
  explicit CompressedSource(PlainFile file)
    : File(std::move(file))
    , Index(StreamIndex<Codec>::Of(this->File.Stamp()))
    , Input(skipBytes)
    , Decoder(std::make_unique<Codec>())
  {
  }

  std::size_t Read(std::uint64_t offset, void* to, std::size_t size) override
  {
    this->SkipTo(offset, {});
    return this->Position == offset ? this->Decompress(static_cast<unsigned char*>(to), size) : 0;
  }

  bool RandomAccess() const override { return false; }
  std::uint64_t MaximumBytes() const override { return Codec::MaximumBytes(this->File.Size()); }
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
    const auto place = this->Index->Before(offset);
    if (offset < this->Position || place.Position > this->Position)
    {
      this->Restart(place);
    }
    const std::uint64_t first = this->Position;
    std::vector<unsigned char> thrownAway(offset > first ? skipBytes : 0);
    while (this->Position < offset)
    {
      const std::size_t size =
        static_cast<std::size_t>(std::min<std::uint64_t>(offset - this->Position, skipBytes));
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
    // The checksum follows the content; the rest after a map is not needed, so only a little of it
    // is read.
    this->SkipTo(this->Position + 4 * skipBytes, {});
  }

  bool IsCut() const override { return this->Cut; }

private:
  void Restart(const typename StreamIndex<Codec>::Place& place)
  {
    this->Decoder = place.Decoder ? place.Decoder->Copy() : std::make_unique<Codec>();
    this->Position = place.Position;
    this->FilePosition = place.FilePosition;
    this->Left = 0;
    this->Ended = this->Cut = false;
  }

  std::size_t Decompress(unsigned char* to, std::size_t size)
  {
    std::size_t wanted = size;
    while (wanted > 0 && !this->Ended)
    {
      // Even without more input, the codec may still hold output that did not fit before.
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
      else
      {
        this->Remember(this->Position + size - wanted);
      }
    }
    this->Position += size - wanted;
    return size - wanted;
  }

  /// Adds the decoder's state to the index, from time to time.
  void Remember(std::uint64_t position)
  {
    if (this->Index->Wants(position))
    {
      if (std::shared_ptr<const Codec> decoder = this->Decoder->Copy())
      {
        this->Index->Add({ position, this->FilePosition - this->Left, std::move(decoder) });
      }
    }
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
  std::shared_ptr<StreamIndex<Codec>> Index;
  std::vector<unsigned char> Input;
  std::unique_ptr<Codec> Decoder;
  std::uint64_t Position = 0;     ///< in the content
  std::uint64_t FilePosition = 0; ///< of the end of Input in the file
  unsigned char* Next = nullptr;
  std::size_t Left = 0;
  bool Ended = false;
  bool Cut = false;
};

/// A fast source of bytes, and a robust one for files that the fast one finds damaged or truncated:
/// these are read again from the beginning by the robust one, whose bytes and messages count. Valid
/// files are read once.
class FallbackSource : public ByteSource
{
public:
  using Opener = std::function<std::unique_ptr<ByteSource>()>;

  /// @pre `quick` returns no byte that the source opened by `careful` would not return.
  FallbackSource(std::unique_ptr<ByteSource> quick, Opener careful)
    : Source(std::move(quick))
    , Careful(std::move(careful))
  {
  }

  std::size_t Read(std::uint64_t offset, void* to, std::size_t size) override
  {
    return this->Try([&]() { return this->Source->Read(offset, to, size); });
  }
  std::uint64_t CountUpTo(std::uint64_t limit, const ProgressCallback& progress) override
  {
    return this->Try([&]() { return this->Source->CountUpTo(limit, progress); });
  }
  void SkipTo(std::uint64_t offset, const ProgressCallback& progress) override
  {
    this->Try([&]() { return this->Source->SkipTo(offset, progress), 0; });
  }
  void CheckEnd() override
  {
    this->Try([&]() { return this->Source->CheckEnd(), 0; });
  }
  bool IsCut() const override { return this->Source->IsCut(); }
  bool RandomAccess() const override { return false; }
  /// Null once the robust source is in use.
  bool UsesThreads() const override { return this->Careful != nullptr; }
  std::uint64_t MaximumBytes() const override { return this->Source->MaximumBytes(); }
  std::string Compression() const override { return this->Source->Compression(); }
  std::uint64_t FileSize() const override { return this->Source->FileSize(); }
  const std::string& Path() const override { return this->Source->Path(); }

private:
  template <typename Work>
  auto Try(Work&& work) -> decltype(work())
  {
    if (this->Careful)
    {
      try
      {
        const auto result = work();
        if (!this->Source->IsCut())
        {
          return result;
        }
      }
      catch (const ReaderError&)
      {
        // Reported by the robust source.
      }
      this->Source = std::exchange(this->Careful, nullptr)();
    }
    return work();
  }

  std::unique_ptr<ByteSource> Source;
  Opener Careful; ///< empty once the robust source is in use
};

/// @throws std::bad_alloc; what it returns throws ReaderError as ByteSource says.
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
  return std::make_unique<FallbackSource>(
    std::make_unique<CompressedSource<ParallelBzip2>>(std::move(file)),
    [path]() { return std::make_unique<CompressedSource<Bzip2Codec>>(PlainFile(path)); });
}

/// @throws ReaderError if a file begins like one of an unsupported compression.
void RejectOtherCompressions(const unsigned char (&magic)[4], const std::string& path)
{
  const struct
  {
    unsigned char Magic[4];
    const char* Name;
    const char* Command;
  } others[] = { { { 0x28, 0xb5, 0x2f, 0xfd }, "zstd", "zstd -d" },
    { { 0xfd, '7', 'z', 'X' }, "xz", "xz -dk" }, { { 'P', 'K', 3, 4 }, "zip", "unzip" },
    { { '7', 'z', 0xbc, 0xaf }, "7z", "7z x" }, { { 4, 0x22, 0x4d, 0x18 }, "lz4", "lz4 -d" } };
  const auto refuse = [&path](const std::string& name, const std::string& command)
  {
    throw ReaderError(ReaderFailure::ForeignFormat,
      path + ": the file is compressed with " + name +
        ", which is not read (gzip and bzip2 are). Unpack it first: " + command + " FILE");
  };
  for (const auto& other : others)
  {
    if (std::equal(std::begin(magic), std::end(magic), std::begin(other.Magic)))
    {
      refuse(other.Name, other.Command);
    }
  }
  if (magic[0] == 0x1f && magic[1] == 0x9d) // of two bytes only
  {
    refuse("compress (.Z)", "gzip -d");
  }
}

/// Forwards to another source whatever a derived class does not override.
class ForwardingSource : public ByteSource
{
public:
  explicit ForwardingSource(std::unique_ptr<ByteSource> source)
    : Source(std::move(source))
  {
  }

  std::uint64_t MaximumBytes() const override { return this->Source->MaximumBytes(); }
  std::uint64_t CountUpTo(std::uint64_t limit, const ProgressCallback& progress) override
  {
    return this->Source->CountUpTo(limit, progress);
  }
  void SkipTo(std::uint64_t offset, const ProgressCallback& progress) override
  {
    this->Source->SkipTo(offset, progress);
  }
  void CheckEnd() override { this->Source->CheckEnd(); }
  bool IsCut() const override { return this->Source->IsCut(); }
  bool RandomAccess() const override { return this->Source->RandomAccess(); }
  bool UsesThreads() const override { return this->Source->UsesThreads(); }
  std::string Compression() const override { return this->Source->Compression(); }
  std::uint64_t FileSize() const override { return this->Source->FileSize(); }
  const std::string& Path() const override { return this->Source->Path(); }

protected:
  std::unique_ptr<ByteSource> Source;
};

/// A source that begins after a few bytes. Bytes already read to find its beginning are kept, so
/// that compressed content is not decompressed twice.
class SourceBehind : public ForwardingSource
{
public:
  /// `head` follows the first `bytes`, and has been read.
  SourceBehind(std::unique_ptr<ByteSource> source, std::size_t bytes, std::string head)
    : ForwardingSource(std::move(source))
    , Bytes(bytes)
    , Head(std::move(head))
  {
  }

  std::size_t Read(std::uint64_t offset, void* to, std::size_t size) override
  {
    std::size_t kept = 0;
    if (offset < this->Head.size())
    {
      kept = this->Head.copy(static_cast<char*>(to), size, static_cast<std::size_t>(offset));
    }
    return kept == size ? kept
                        : kept +
        this->Source->Read(offset + kept + this->Bytes, static_cast<char*>(to) + kept, size - kept);
  }
  std::uint64_t MaximumBytes() const override { return this->Source->MaximumBytes() - this->Bytes; }
  std::uint64_t CountUpTo(std::uint64_t limit, const ProgressCallback& progress) override
  {
    const std::uint64_t counted = this->Source->CountUpTo(
      std::max<std::uint64_t>(limit, this->Head.size()) + this->Bytes, progress);
    return std::min(limit, counted - this->Bytes);
  }
  void SkipTo(std::uint64_t offset, const ProgressCallback& progress) override
  {
    if (offset >= this->Head.size())
    {
      this->Source->SkipTo(offset + this->Bytes, progress);
    }
  }

private:
  std::size_t Bytes;
  std::string Head;
};

/// A text whose lines end in carriage returns, with newlines in their places.
class LineEndSource : public ForwardingSource
{
public:
  explicit LineEndSource(std::unique_ptr<ByteSource> source)
    : ForwardingSource(std::move(source))
  {
  }

  std::size_t Read(std::uint64_t offset, void* to, std::size_t size) override
  {
    const std::size_t got = this->Source->Read(offset, to, size);
    std::replace(static_cast<char*>(to), static_cast<char*>(to) + got, '\r', '\n');
    return got;
  }
  bool ChangesLineEnds() const override { return true; }
};

}

bool BeginsAsUTF16(std::string_view begin)
{
  if (begin.substr(0, 2) == "\xff\xfe" || begin.substr(0, 2) == "\xfe\xff")
  {
    return true;
  }
  const auto isText = [](char c) { return (c >= ' ' && c < 127) || (c >= '\t' && c <= '\r'); };
  const auto isUTF16 = [&](std::size_t text)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      if (i % 2 == text ? !isText(begin[i]) : begin[i] != 0)
      {
        return false;
      }
    }
    return true;
  };
  return begin.size() >= 4 && (isUTF16(0) || isUTF16(1));
}

std::unique_ptr<ByteSource> OpenTextSource(const std::string& path)
{
  std::unique_ptr<ByteSource> source = OpenByteSource(path);
  std::string head(std::size_t{ 1 } << 16, ' ');
  head.resize(source->Read(0, head.data(), head.size()));
  if (BeginsAsUTF16(head))
  {
    throw ReaderError(ReaderFailure::ForeignFormat,
      path +
        ": the text is in UTF-16 (or UTF-32), which is not read. Save it as UTF-8 or ASCII, or "
        "convert it: iconv -f UTF-16 -t UTF-8 FILE > OTHER");
  }
  const std::size_t mark = head.substr(0, 3) == "\xef\xbb\xbf" ? 3 : 0;
  const bool returns = head.find('\r') != std::string::npos && head.find('\n') == std::string::npos;
  if (mark > 0 || !source->RandomAccess())
  {
    source = std::make_unique<SourceBehind>(std::move(source), mark, head.substr(mark));
  }
  return returns ? std::make_unique<LineEndSource>(std::move(source)) : std::move(source);
}

std::unique_ptr<ByteSource> OpenByteSource(const std::string& path)
{
  PlainFile file(path);
  unsigned char magic[4] = {};
  file.Read(0, magic, sizeof(magic));
  RejectOtherCompressions(magic, path);
  if (magic[0] == 0x1f && magic[1] == 0x8b)
  {
    return OpenGzip(std::move(file));
  }
  if (magic[0] == 'B' && magic[1] == 'Z' && magic[2] == 'h' && magic[3] >= '1' && magic[3] <= '9')
  {
    return OpenBzip2(std::move(file));
  }
  return std::make_unique<PlainSource>(std::move(file));
}

std::string ReadAll(ByteSource& source, const ProgressCallback& progress)
{
  // For a small file, its size plus one byte to detect the end; compressed files usually grow less
  // than 32-fold.
  constexpr std::uint64_t largest = std::uint64_t{ 1 } << 23;
  const auto piece = static_cast<std::size_t>(std::min(
    largest, source.RandomAccess() ? source.MaximumBytes() + 1 : 4096 + 32 * source.FileSize()));
  constexpr std::uint64_t harmless = std::uint64_t{ 1 } << 26;
  constexpr std::uint64_t usual = 16;
  const std::uint64_t most =
    source.RandomAccess() ? source.MaximumBytes() : std::max(harmless, usual * source.FileSize());
  std::string text;
  // Unwritten pages cost nothing, whereas copying a growing text does.
  constexpr std::uint64_t sure = std::uint64_t{ 1 } << 30;
  text.reserve(source.RandomAccess() ? std::min(sure, source.MaximumBytes() + piece) : 0);
  AdviseLargePages(&text[0], text.capacity());
  for (std::size_t got = piece; got == piece;)
  {
    const std::size_t at = text.size();
    text.resize(at + piece);
    got = source.Read(at, &text[at], piece);
    text.resize(at + got);
    if (text.size() > most)
    {
      throw ReaderError(ReaderFailure::Damaged,
        source.Path() + ": the " + source.Compression() + " data decompress to more than " +
          std::to_string(most >> 20) + " MiB, " + std::to_string(usual) +
          " times their size and more, which is implausible for a text of numbers. If the file is "
          "intact, "
          "unpack it first.");
    }
    Report(progress, 1.0 - std::exp2(-static_cast<double>(text.size()) / double{ 1 << 26 }));
  }
  source.CheckEnd();
  if (source.IsCut())
  {
    throw ReaderError(ReaderFailure::Truncated,
      source.Path() + ": the " + source.Compression() +
        " data end prematurely. Fetch the file again.");
  }
  return text;
}

}
