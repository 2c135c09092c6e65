/**
 * @file MaskSet.h
 * @brief A set of 26-bit masks that threads fill together, and the rank of each in it.
 */
#ifndef isthmus_MaskSet_h
#define isthmus_MaskSet_h

#include <array>
#include <atomic>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace isthmus
{

/**
 * One bit for each of the 2^26 masks, in pages that are made when first needed: maps have some
 * thousand masks, for which one table of all bits would be most of what persistence takes. 128 KiB,
 * and 768 bytes a page (of 4096 masks).
 */
class MaskSet
{
public:
  MaskSet()
    : Pages(new std::atomic<Page*>[pageCount])
  {
    for (std::size_t i = 0; i < pageCount; ++i)
    {
      this->Pages[i].store(nullptr, std::memory_order_relaxed);
    }
  }
  ~MaskSet()
  {
    for (std::size_t i = 0; i < pageCount; ++i)
    {
      delete this->Pages[i].load();
    }
  }
  MaskSet(const MaskSet&) = delete;
  MaskSet& operator=(const MaskSet&) = delete;

  /// By any number of threads. They write only what is new, which is soon nothing.
  void Add(std::uint32_t mask)
  {
    auto& word = this->PageOf(mask).Words[WordOf(mask)];
    if ((word.load(std::memory_order_relaxed) & BitOf(mask)) == 0)
    {
      word.fetch_or(BitOf(mask), std::memory_order_relaxed);
    }
  }

  /// Calls visit(mask) for each, in ascending order, and makes their ranks known. By one thread,
  /// when all are added.
  template <typename Visit>
  void Rank(Visit&& visit)
  {
    std::uint32_t total = 0;
    for (std::size_t p = 0; p < pageCount; ++p)
    {
      Page* page = this->Pages[p].load();
      for (std::size_t w = 0; page && w < wordsOfPage; ++w)
      {
        page->Before[w] = total;
        for (std::uint64_t bits = page->Words[w].load(); bits != 0; bits &= bits - 1)
        {
          const auto low = CountOf((bits & (~bits + 1)) - 1);
          visit(static_cast<std::uint32_t>((p * wordsOfPage + w) * 64 + low));
          ++total;
        }
      }
    }
  }

  /// How many masks of the set are smaller. @pre `mask` is in it, and Rank() was called.
  std::uint32_t RankOf(std::uint32_t mask) const
  {
    const Page& page = *this->Pages[mask >> 12].load(std::memory_order_relaxed);
    const std::uint64_t word = page.Words[WordOf(mask)].load(std::memory_order_relaxed);
    return page.Before[WordOf(mask)] +
      static_cast<std::uint32_t>(CountOf(word & (BitOf(mask) - 1)));
  }

private:
  static constexpr std::size_t wordsOfPage = 64;
  static constexpr std::size_t pageCount = std::size_t{ 1 } << 14;

  struct Page
  {
    std::array<std::atomic<std::uint64_t>, wordsOfPage> Words{};
    std::array<std::uint32_t, wordsOfPage> Before{}; ///< masks before each word
  };

  static std::size_t WordOf(std::uint32_t mask) { return mask >> 6 & (wordsOfPage - 1); }
  static std::uint64_t BitOf(std::uint32_t mask) { return std::uint64_t{ 1 } << (mask & 63U); }
  static std::size_t CountOf(std::uint64_t bits) { return std::bitset<64>(bits).count(); }

  Page& PageOf(std::uint32_t mask)
  {
    std::atomic<Page*>& place = this->Pages[mask >> 12];
    Page* page = place.load(std::memory_order_acquire);
    if (!page)
    {
      auto made = std::make_unique<Page>();
      if (place.compare_exchange_strong(page, made.get(), std::memory_order_acq_rel))
      {
        page = made.release();
      }
    }
    return *page;
  }

  std::unique_ptr<std::atomic<Page*>[]> Pages;
};

}

#endif
