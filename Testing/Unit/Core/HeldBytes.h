/**
 * @file HeldBytes.h
 * @brief Counts the heap memory of a program and its peak (glibc).
 *
 * Replaces malloc and related functions for the whole program (glibc's manual, "Replacing malloc"),
 * so that operator new and calloc of every library in it are counted as well. Requested bytes
 * count, touched or not: the same on every kernel, at any load. Include it in one source of a
 * program.
 */
#ifndef isthmus_HeldBytes_h
#define isthmus_HeldBytes_h

#include <malloc.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>

#ifdef __has_feature
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ISTHMUS_COUNTS_BYTES 0 // sanitizers have a malloc of their own
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
#define ISTHMUS_COUNTS_BYTES 0
#endif
#ifndef ISTHMUS_COUNTS_BYTES
#define ISTHMUS_COUNTS_BYTES 1
#endif

namespace isthmus::testing
{

inline std::atomic<std::int64_t> BytesNow{ 0 };
inline std::atomic<std::int64_t> BytesAtMost{ 0 };

/// Bytes held now; MostHeldBytes() is reset to this value.
inline std::int64_t StartOfHeldBytes()
{
  const std::int64_t now = BytesNow.load();
  BytesAtMost.store(now);
  return now;
}

/// The most that was held since StartOfHeldBytes().
inline std::int64_t MostHeldBytes()
{
  return BytesAtMost.load();
}

#if ISTHMUS_COUNTS_BYTES

/// Records a new block and returns it.
inline void* CountBlock(void* block)
{
  if (block)
  {
    const auto size = static_cast<std::int64_t>(malloc_usable_size(block));
    const std::int64_t now = BytesNow.fetch_add(size, std::memory_order_relaxed) + size;
    std::int64_t most = BytesAtMost.load(std::memory_order_relaxed);
    while (now > most && !BytesAtMost.compare_exchange_weak(most, now, std::memory_order_relaxed))
    {
    }
  }
  return block;
}

/// Records that a block is freed and returns it.
inline void* UncountBlock(void* block)
{
  if (block)
  {
    BytesNow.fetch_sub(
      static_cast<std::int64_t>(malloc_usable_size(block)), std::memory_order_relaxed);
  }
  return block;
}

#endif

}

#if ISTHMUS_COUNTS_BYTES

extern "C"
{
  void* __libc_malloc(std::size_t size);
  void* __libc_calloc(std::size_t count, std::size_t size);
  void* __libc_realloc(void* block, std::size_t size);
  void* __libc_memalign(std::size_t alignment, std::size_t size);
  void __libc_free(void* block);

  void* malloc(std::size_t size) noexcept
  {
    return isthmus::testing::CountBlock(__libc_malloc(size));
  }

  void* calloc(std::size_t count, std::size_t size) noexcept
  {
    return isthmus::testing::CountBlock(__libc_calloc(count, size));
  }

  void free(void* block) noexcept
  {
    __libc_free(isthmus::testing::UncountBlock(block));
  }

  void* realloc(void* block, std::size_t size) noexcept
  {
    void* moved = __libc_realloc(isthmus::testing::UncountBlock(block), size);
    if (!moved && size != 0)
    {
      isthmus::testing::CountBlock(block); // stays as it was
    }
    return isthmus::testing::CountBlock(moved);
  }

  void* memalign(std::size_t alignment, std::size_t size) noexcept
  {
    return isthmus::testing::CountBlock(__libc_memalign(alignment, size));
  }

  void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept
  {
    return memalign(alignment, size);
  }

  int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept
  {
    *block = memalign(alignment, size);
    return *block ? 0 : ENOMEM;
  }
}

#endif

#endif
