#include "Core/MemoryBudget.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace
{

using isthmus::AvailableMemory;
using isthmus::MemoryBudget;
using isthmus::MemoryText;

constexpr double MiB = 1048576.0;

std::string CatchMessage(const MemoryBudget& budget, double bytes)
{
  try
  {
    budget.Require(bytes, "A grid of 9 x 9 x 9 nodes", "choose a larger Spacing");
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return {};
}

TEST(MemoryBudget, LimitsAreInMiB)
{
  const MemoryBudget budget(3.0);
  EXPECT_EQ(budget.Bytes(), 3.0 * MiB);
  EXPECT_EQ(budget.WholeBytes(), 3145728u);
  EXPECT_TRUE(budget.Allows(3.0 * MiB));
  EXPECT_FALSE(budget.Allows(3.0 * MiB + 1.0));
  EXPECT_EQ(CatchMessage(budget, 3.0 * MiB), "");
  EXPECT_EQ(CatchMessage(budget, 6.0 * MiB),
    "A grid of 9 x 9 x 9 nodes needs about 6 MiB of memory, but MemoryLimit is 3 MiB: choose a "
    "larger Spacing, or raise MemoryLimit.");
}

TEST(MemoryBudget, WithoutALimitAvailableMemoryIsUsed)
{
  const double before = AvailableMemory();
  const MemoryBudget budget;
  EXPECT_GT(budget.Bytes(), MiB);
  EXPECT_NEAR(budget.Bytes() / before, 1.0, 0.5); // other programs run beside this one
  EXPECT_TRUE(budget.Allows(MiB));
  const std::string why = CatchMessage(budget, 1e17);
  EXPECT_NE(why.find("needs about 88.8 PiB of memory, but only "), std::string::npos) << why;
  EXPECT_NE(why.find(" are available: choose a larger Spacing."), std::string::npos) << why;
  EXPECT_EQ(why.find("MemoryLimit"), std::string::npos) << why;
}

TEST(MemoryBudget, NegativeLimitsAreRefused)
{
  EXPECT_THROW(MemoryBudget(-1.0), std::invalid_argument);
  EXPECT_THROW(MemoryBudget::ForMachine(-1.0), std::invalid_argument);
}

TEST(MemoryBudget, GridsStateTheirDimensions)
{
  MemoryBudget(1.0).RequireGrid({ 10, 10, 10 }, 8.0, "");
  try
  {
    MemoryBudget(1.0).RequireGrid({ 1024, 1024, 2 }, 8.0, "choose a larger Spacing");
    ADD_FAILURE() << "no error";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_STREQ(error.what(),
      "A grid of 1024 x 1024 x 2 nodes needs about 16 MiB of memory, but MemoryLimit is 1 MiB: "
      "choose a larger Spacing, or raise MemoryLimit.");
  }
}

TEST(MemoryBudget, RefusesNaN)
{
  const MemoryBudget unlimited = MemoryBudget::ForBytes(0);
  EXPECT_EQ(unlimited.WholeBytes(), 0u);
  EXPECT_TRUE(unlimited.Allows(1e17));
  for (const double bytes : { 1e18, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    EXPECT_FALSE(unlimited.Allows(bytes)) << bytes;
    EXPECT_FALSE(MemoryBudget(1e15).Allows(bytes)) << bytes;
  }
}

TEST(MemoryBudget, TheSmallerOfTwoLimitsCounts)
{
  EXPECT_EQ(MemoryBudget(4.0).AtMost(MiB).Bytes(), MiB);
  EXPECT_EQ(MemoryBudget(4.0).AtMost(9.0 * MiB).Bytes(), 4.0 * MiB);
  EXPECT_NE(CatchMessage(MemoryBudget().AtMost(MiB), 2.0 * MiB).find("MemoryLimit is 1 MiB"),
    std::string::npos);
  EXPECT_EQ(MemoryBudget::ForBytes(77).WholeBytes(), 77u);
}

TEST(MemoryBudget, SizesAreReadable)
{
  EXPECT_EQ(MemoryText(512.0), "0.5 KiB");
  EXPECT_EQ(MemoryText(320.0 * MiB), "320 MiB");
  EXPECT_EQ(MemoryText(1.5 * 1024.0 * MiB), "1.5 GiB");
  EXPECT_EQ(MemoryText(1023.0 * MiB), "0.999 GiB");
}

}
