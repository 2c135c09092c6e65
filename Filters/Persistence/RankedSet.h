/**
 * @file RankedSet.h
 * @brief A set of numbers that threads fill together, and the rank of each in it.
 */
#ifndef isthmus_RankedSet_h
#define isthmus_RankedSet_h

#include <array>
#include <atomic>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace isthmus
{

/**
 * One bit for each number below a bound, in pages that are allocated when first needed. Maps have
 * about a thousand kinds of stars, for which one table of all 2^26 bits would be most of the memory
 * of persistence. Memory: 8 bytes for each 4096 numbers, and 768 bytes for each page (of 4096
 * numbers).
 */
class RankedSet
{
public:
  /// @param bound  is above all numbers
  explicit RankedSet(std::int64_t bound)
    : PageCount(static_cast<std::size_t>((bound + numbersOfPage - 1) / numbersOfPage))
    , Pages(new std::atomic<Page*>[this->PageCount])
  {
    for (std::size_t i = 0; i < this->PageCount; ++i)
    {
      this->Pages[i].store(nullptr, std::memory_order_relaxed);
    }
  }
  ~RankedSet()
  {
    for (std::size_t i = 0; i < this->PageCount; ++i)
    {
      delete this->Pages[i].load();
    }
  }
  RankedSet(const RankedSet&) = delete;
  RankedSet& operator=(const RankedSet&) = delete;

  /// May be called by any number of threads. Threads write only new numbers, of which there are
  /// soon none.
  void Add(std::int64_t number)
  {
    auto& word = this->GetPage(number).Words[WordIndex(number)];
    if ((word.load(std::memory_order_relaxed) & BitMask(number)) == 0)
    {
      word.fetch_or(BitMask(number), std::memory_order_relaxed);
    }
  }

  /// Calls visit(number) for each number in ascending order, and sets the ranks. To be called by
  /// one thread after all numbers are added.
  template <typename Visit>
  void Rank(Visit&& visit)
  {
    std::uint32_t total = 0;
    for (std::size_t p = 0; p < this->PageCount; ++p)
    {
      Page* page = this->Pages[p].load();
      for (std::size_t w = 0; page && w < wordsOfPage; ++w)
      {
        page->Before[w] = total;
        for (std::uint64_t bits = page->Words[w].load(); bits != 0; bits &= bits - 1)
        {
          visit(static_cast<std::int64_t>(
            (p * wordsOfPage + w) * 64 + CountBits((bits & (~bits + 1)) - 1)));
          ++total;
        }
      }
    }
  }

  /// The count of smaller numbers in the set.
  /// @pre `number` is in the set, Rank() was called, and the set has fewer than 2^32 numbers.
  std::uint32_t FindRank(std::int64_t number) const
  {
    const Page& page = *this->Pages[number / numbersOfPage].load(std::memory_order_relaxed);
    const std::uint64_t word = page.Words[WordIndex(number)].load(std::memory_order_relaxed);
    return page.Before[WordIndex(number)] +
      static_cast<std::uint32_t>(CountBits(word & (BitMask(number) - 1)));
  }

private:
  static constexpr std::size_t wordsOfPage = 64;
  static constexpr std::int64_t numbersOfPage = 4096;

  struct Page
  {
    std::array<std::atomic<std::uint64_t>, wordsOfPage> Words{};
    std::array<std::uint32_t, wordsOfPage> Before{}; ///< numbers before each word
  };

  static std::size_t WordIndex(std::int64_t number)
  {
    return static_cast<std::size_t>(number) / 64 % wordsOfPage;
  }
  static std::uint64_t BitMask(std::int64_t number)
  {
    return std::uint64_t{ 1 } << (static_cast<std::uint64_t>(number) & 63U);
  }
  static std::size_t CountBits(std::uint64_t bits) { return std::bitset<64>(bits).count(); }

  Page& GetPage(std::int64_t number)
  {
    std::atomic<Page*>& place = this->Pages[number / numbersOfPage];
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

  std::size_t PageCount;
  std::unique_ptr<std::atomic<Page*>[]> Pages;
};

}

#endif
