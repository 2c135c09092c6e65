// Numbers are written and read with a '.', also where the host has set a locale with a comma.
#include "Core/MemoryBudget.h"
#include "Core/NumberText.h"
#include "GermanNumbers.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <string_view>

using namespace isthmus;

namespace
{

void ExpectPoints()
{
  EXPECT_EQ(FormatNumber(-1.5), "-1.5");
  EXPECT_EQ(FormatNumber(1234567.0), "1.23457e+06");
  EXPECT_EQ(FormatNumber(0.123456789, 8), "0.12345679");
  EXPECT_EQ(FormatNumber(std::strtod("nan", nullptr)), "not a number");
  EXPECT_EQ(FixedNumber(2.5, 17), "2.50000000000000000");
  EXPECT_EQ(FixedNumber(-1.7e308, 17).size(), 328u);
  EXPECT_EQ(JoinText("(", -1.5, ", ", 12345, ")"), "(-1.5, 12345)");
  EXPECT_EQ(MemoryText(1.5 * 1024.0 * 1024.0), "1.5 MiB");
  std::string_view text = " +1.5\t-2 x";
  double a = 0.0;
  int b = 0;
  EXPECT_TRUE(ExtractNumber(text, a) && ExtractNumber(text, b));
  EXPECT_EQ(a, 1.5);
  EXPECT_EQ(b, -2);
  EXPECT_FALSE(ExtractNumber(text, a));
  EXPECT_EQ(ExtractWord(text), "x");
  EXPECT_TRUE(ExtractWord(text).empty());
  EXPECT_EQ(RightAligned(FixedNumber(27.34, 3), 8) + LeftAligned("x", 3) + '.', "  27.340x  .");
}

TEST(NumberText, ValuesHaveTheDecimalsOfTheirError)
{
  EXPECT_EQ(FormatWithError(-80.9412, 0.0712, "kcal/mol"), "-80.94 kcal/mol, to within about 0.07");
  EXPECT_EQ(FormatWithError(-80.9412, 0.1234, "kcal/mol"), "-80.94 kcal/mol, to within about 0.12");
  EXPECT_EQ(FormatWithError(-893.61, 4.2, "kcal/mol"), "-894 kcal/mol, to within about 4");
  EXPECT_EQ(FormatWithError(12345.6, 321.0, "pA"), "12346 pA, to within about 300");
  EXPECT_EQ(FormatWithError(1.0, 0.0, "pA"), "1.000000000000 pA, to within about 0");
}

TEST(NumberText, OfTheDefaultLocale)
{
  ExpectPoints();
}

TEST(NumberText, OfALocaleWithCommas)
{
  const isthmus::testing::GermanNumbers german;
  ISTHMUS_NEEDS_GERMAN(german);
  ExpectPoints();
}

}
