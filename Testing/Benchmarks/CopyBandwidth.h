/**
 * @file CopyBandwidth.h
 * @brief Memory bandwidth of this machine, the limit with which benchmarks of volume filters are
 * compared.
 */
#ifndef isthmus_CopyBandwidth_h
#define isthmus_CopyBandwidth_h

#include "Core/ParallelFor.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <vector>

namespace isthmus::testing
{

/// Bytes per second, read plus written, of the best of several parallel copies of 256 MB.
inline double CopyBandwidth()
{
  static const double bandwidth = []()
  {
    constexpr std::int64_t bytes = 256 << 20;
    const std::vector<char> from(bytes, 1);
    std::vector<char> to(bytes, 2);
    double best = 0.0;
    for (int n = 0; n < 10; ++n)
    {
      const auto start = std::chrono::steady_clock::now();
      ParallelFor(0, bytes, 1 << 20,
        [&](std::int64_t first, std::int64_t last) {
          std::memcpy(
            to.data() + first, from.data() + first, static_cast<std::size_t>(last - first));
        });
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      best = std::max(best, 2.0 * static_cast<double>(bytes) / seconds.count());
    }
    return best;
  }();
  return bandwidth;
}

}

#endif
