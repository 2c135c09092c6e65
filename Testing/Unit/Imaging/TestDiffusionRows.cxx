// The vector kernels that can be wrong in their own right.

#include "Imaging/DiffusionRows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

template <typename T>
double WorstExponential(double largest)
{
  constexpr int count = 100000;
  std::vector<T> values(isthmus::PaddedLength(count));
  for (int n = 0; n < count; ++n)
  {
    values[static_cast<std::size_t>(n)] = static_cast<T>(largest * n / count);
  }
  const std::vector<T> arguments = values;
  isthmus::ExponentialRow(count, values.data());
  double worst = 0.0;
  for (std::size_t n = 0; n < count; ++n)
  {
    const long double exact = std::exp(-static_cast<long double>(arguments[n]));
    worst = std::max(worst, static_cast<double>(std::abs(values[n] / exact - 1.0L)));
  }
  return worst;
}

}

TEST(DiffusionRows, ExponentialIsAccurate)
{
  EXPECT_LT(WorstExponential<float>(1.0), 3e-7);
  EXPECT_LT(WorstExponential<float>(86.0), 3e-7);
  EXPECT_LT(WorstExponential<double>(1.0), 1e-15);
  EXPECT_LT(WorstExponential<double>(700.0), 1e-15);
}

TEST(DiffusionRows, ExponentialOfTheHugeIsTinyAndOfZeroOne)
{
  std::vector<float> values(16, 0.0f);
  values[1] = 1e30f;
  values[2] = INFINITY;
  isthmus::ExponentialRow(16, values.data());
  EXPECT_EQ(values[0], 1.0f);
  EXPECT_LT(values[1], 1e-37f);
  EXPECT_LT(values[2], 1e-37f);
}
