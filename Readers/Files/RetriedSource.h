/**
 * @file RetriedSource.h
 * @brief A quick source of bytes, and a careful one for files that the quick one has doubts about.
 *
 * Whatever the quick one finds damaged or broken off is read again from the beginning by the
 * careful one, whose bytes and sentences count. Sound files are read once.
 */
#ifndef isthmus_RetriedSource_h
#define isthmus_RetriedSource_h

#include "Files/ByteSource.h"
#include "Files/ReaderError.h"

#include <functional>
#include <memory>
#include <utility>

namespace isthmus
{

class RetriedSource : public ByteSource
{
public:
  using Opener = std::function<std::unique_ptr<ByteSource>()>;

  /// @pre `quick` gives no byte that what `careful` opens would not give.
  RetriedSource(std::unique_ptr<ByteSource> quick, Opener careful)
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
  /// As long as the quick one will do.
  bool UsesThreads() const override { return this->Careful != nullptr; }
  std::uint64_t MostBytes() const override { return this->Source->MostBytes(); }
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
        // Told by the careful one, in its words.
      }
      this->Source = std::exchange(this->Careful, nullptr)();
    }
    return work();
  }

  std::unique_ptr<ByteSource> Source;
  Opener Careful; ///< empty once it was needed
};

}

#endif
