/**
 * @file CubicalPeer.h
 * @brief The persistence of a volume by GUDHI, for tests and benchmarks; and multisets of pairs.
 */
#ifndef isthmus_CubicalPeer_h
#define isthmus_CubicalPeer_h

#include "Persistence/CubicalPersistence.h"

#if __has_include(<gudhi/Bitmap_cubical_complex.h>)
#define ISTHMUS_HAS_GUDHI_CUBICAL 1
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wextra"
#include <gudhi/Bitmap_cubical_complex.h>
#include <gudhi/Persistent_cohomology.h>
#pragma GCC diagnostic pop
#else
#define ISTHMUS_HAS_GUDHI_CUBICAL 0
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace isthmus::testing
{

/// Dimension, birth, death of a class.
using Bar = std::array<double, 3>;
using Bars = std::vector<Bar>;

/// Our pairs as a sorted multiset of values.
inline Bars CollectBars(const VolumeView& volume, bool superlevel = false)
{
  CubicalParameters parameters;
  parameters.Superlevel = superlevel;
  Bars bars;
  const double never = (superlevel ? -1.0 : 1.0) * std::numeric_limits<double>::infinity();
  for (const CubicalPair& pair : CubicalPersistence(volume, parameters).Pairs)
  {
    bars.push_back({ static_cast<double>(pair.Dimension), volume.Value(pair.Birth.Node()),
      pair.Death.Node() < 0 ? never : volume.Value(pair.Death.Node()) });
  }
  std::sort(bars.begin(), bars.end());
  return bars;
}

#if ISTHMUS_HAS_GUDHI_CUBICAL

/// Sorts the cells of a complex by their values. GUDHI 3.11 sorts them on first use and has no such
/// function; GUDHI 3.7 needs this call.
template <typename Complex>
auto SortCells(Complex& complex, int) -> decltype(complex.initialize_simplex_associated_to_key())
{
  complex.initialize_simplex_associated_to_key();
}

template <typename Complex>
void SortCells(Complex& complex, long)
{
  complex.initialize_filtration();
}

/**
 * GUDHI 3.7 takes values for cubes only (T-construction); so its complex is made with any, and each
 * cell is then given the greatest value of its corners. Axes of one node are left out.
 */
inline Bars BarsOfGudhi(const VolumeView& volume, bool superlevel = false)
{
  using Base = Gudhi::cubical_complex::Bitmap_cubical_complex_base<double>;
  using Complex = Gudhi::cubical_complex::Bitmap_cubical_complex<Base>;
  using Cohomology = Gudhi::persistent_cohomology::Persistent_cohomology<Complex,
    Gudhi::persistent_cohomology::Field_Zp>;
  std::vector<unsigned> sizes;
  std::size_t cubes = 1;
  for (const std::int64_t n : volume.Dimensions)
  {
    if (n > 1)
    {
      sizes.push_back(static_cast<unsigned>(n - 1));
      cubes *= static_cast<std::size_t>(n - 1);
    }
  }
  Complex complex(sizes, std::vector<double>(cubes, 0.0));
  const auto& n = volume.Dimensions;
  const double sign = superlevel ? -1.0 : 1.0;
  std::size_t cell = 0;
  for (std::int64_t k = 0; k <= 2 * (n[2] - 1); ++k)
  {
    for (std::int64_t j = 0; j <= 2 * (n[1] - 1); ++j)
    {
      for (std::int64_t i = 0; i <= 2 * (n[0] - 1); ++i)
      {
        double value = -std::numeric_limits<double>::infinity();
        for (std::int64_t z = k / 2; z <= (k + 1) / 2; ++z)
        {
          for (std::int64_t y = j / 2; y <= (j + 1) / 2; ++y)
          {
            for (std::int64_t x = i / 2; x <= (i + 1) / 2; ++x)
            {
              value = std::max(value, sign * volume.Value(x + n[0] * (y + n[1] * z)));
            }
          }
        }
        complex.get_cell_data(cell++) = value;
      }
    }
  }
  SortCells(complex, 0);
  Cohomology cohomology(complex);
  cohomology.init_coefficients(2);
  cohomology.compute_persistent_cohomology(-1.0);
  Bars bars;
  for (const auto& pair : cohomology.get_persistent_pairs())
  {
    const auto birth = std::get<0>(pair);
    const auto death = std::get<1>(pair);
    const double from = complex.filtration(birth);
    const double to = death == Complex::null_simplex() ? std::numeric_limits<double>::infinity()
                                                       : complex.filtration(death);
    if (from != to)
    {
      bars.push_back(
        { static_cast<double>(complex.get_dimension_of_a_cell(birth)), sign * from, sign * to });
    }
  }
  std::sort(bars.begin(), bars.end());
  return bars;
}

#endif

}

#endif
