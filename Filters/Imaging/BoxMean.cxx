#include "Imaging/BoxMean.h"

#include "Core/ParallelFor.h"

#include <algorithm>
#include <vector>

namespace isthmus
{
namespace
{

/// Running means along lines that lie side by side: `width` lines, `step` values from node to node.
template <typename T>
void MeanAlongLines(
  T* lines, std::int64_t width, std::int64_t length, std::int64_t step, std::int64_t window)
{
  window = std::min(window, length);
  std::vector<T> copy(static_cast<std::size_t>(width * length));
  for (std::int64_t n = 0; n < length; ++n)
  {
    std::copy_n(lines + n * step, width, copy.data() + n * width);
  }
  std::vector<double> sums(static_cast<std::size_t>(width), 0.0);
  for (std::int64_t n = 0; n < window; ++n)
  {
    const T* row = copy.data() + n * width;
    std::transform(sums.begin(), sums.end(), row, sums.begin(),
      [](double sum, T value) { return sum + static_cast<double>(value); });
  }
  const double scale = 1.0 / static_cast<double>(window);
  for (std::int64_t n = 0, begin = 0; n < length; ++n)
  {
    if (n > window / 2 && begin + window < length)
    {
      const T* leaves = copy.data() + begin * width;
      const T* enters = leaves + window * width;
      for (std::int64_t i = 0; i < width; ++i)
      {
        sums[static_cast<std::size_t>(i)] +=
          static_cast<double>(enters[i]) - static_cast<double>(leaves[i]);
      }
      ++begin;
    }
    std::transform(sums.begin(), sums.end(), lines + n * step,
      [scale](double sum) { return static_cast<T>(sum * scale); });
  }
}

}

template <typename T>
void BoxMean(const std::array<std::int64_t, 3>& dimensions, int window, T* values)
{
  const auto [nx, ny, nz] = dimensions;
  const std::int64_t plane = nx * ny, length = nz;
  const std::int64_t rowLength = nx, rows = ny;
  ParallelFor(0, length, 1,
    [=](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
      {
        for (std::int64_t j = 0; j < rows; ++j)
        {
          MeanAlongLines(values + k * plane + j * rowLength, 1, rowLength, 1, window);
        }
        MeanAlongLines(values + k * plane, rowLength, rows, rowLength, window);
      }
    });
  ParallelFor(0, rows, 1,
    [=](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t j = first; j < last; ++j)
      {
        MeanAlongLines(values + j * rowLength, rowLength, length, plane, window);
      }
    });
}

template void BoxMean(const std::array<std::int64_t, 3>&, int, float*);
template void BoxMean(const std::array<std::int64_t, 3>&, int, double*);

}
