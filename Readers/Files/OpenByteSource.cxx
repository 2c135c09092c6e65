#include "Files/OpenByteSource.h"

#include "Core/LargePages.h"
#include "Files/CompressedSource.h"
#include "Files/PlainFile.h"
#include "Files/ReaderError.h"

#include <algorithm>
#include <cmath>

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
  std::uint64_t MostBytes() const override { return this->File.Size(); }
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

}

std::unique_ptr<ByteSource> OpenByteSource(const std::string& path)
{
  PlainFile file(path);
  unsigned char magic[4] = {};
  file.Read(0, magic, sizeof(magic));
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
  // Of a small file no more than it has, and one to see its end; compressed ones usually grow less
  // than 32-fold.
  constexpr std::uint64_t largest = std::uint64_t{ 1 } << 23;
  const auto piece = static_cast<std::size_t>(std::min(
    largest, source.RandomAccess() ? source.MostBytes() + 1 : 4096 + 32 * source.FileSize()));
  constexpr std::uint64_t harmless = std::uint64_t{ 1 } << 26;
  constexpr std::uint64_t usual = 16;
  const std::uint64_t most =
    source.RandomAccess() ? source.MostBytes() : std::max(harmless, usual * source.FileSize());
  std::string text;
  // Pages that are not written cost nothing, copies of a text that grows do.
  constexpr std::uint64_t sure = std::uint64_t{ 1 } << 30;
  text.reserve(source.RandomAccess() ? std::min(sure, source.MostBytes() + piece) : 0);
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
        source.Path() + ": the " + source.Compression() + " data unpack to more than " +
          std::to_string(most >> 20) + " MiB, " + std::to_string(usual) +
          " times their size and more: no text of numbers does. If it is sound, unpack it first.");
    }
    Report(progress, 1.0 - std::exp2(-static_cast<double>(text.size()) / double{ 1 << 26 }));
  }
  source.CheckEnd();
  if (source.IsCut())
  {
    throw ReaderError(ReaderFailure::Truncated,
      source.Path() + ": the " + source.Compression() +
        " data break off before their end. Fetch the file again.");
  }
  return text;
}

}
