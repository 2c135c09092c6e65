// Ranges with and without their ends; what the refusals say.

#include "Core/RangeChecks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

using namespace isthmus;

namespace
{

template <typename Call>
std::string RefusalOf(Call&& call)
{
  try
  {
    call();
  }
  catch (const std::invalid_argument& refusal)
  {
    return refusal.what();
  }
  return {};
}

}

TEST(RangeChecks, BothEndsBelongToARange)
{
  EXPECT_NO_THROW(RequireRange("Length", 1.0, 1.0, 2.0));
  EXPECT_NO_THROW(RequireRange("Length", 2.0, 1.0, 2.0));
  EXPECT_EQ(RefusalOf([] { RequireRange("Length", 0.5, 1.0, 2.0, "It is a length."); }),
    "Length is 0.5, but it must be from 1 to 2. It is a length.");
  EXPECT_EQ(RefusalOf([] { RequireRange("Length", 2.5, 1.0, 2.0); }),
    "Length is 2.5, but it must be from 1 to 2.");
  EXPECT_THROW(RequireRange("Length", std::nan(""), 1.0, 2.0), std::invalid_argument);
}

TEST(RangeChecks, OnlyTheUpperEndBelongsToWhatIsAbove)
{
  EXPECT_NO_THROW(RequireAbove("Length", 2.0, 1.0, 2.0));
  EXPECT_EQ(RefusalOf([] { RequireAbove("Length", 1.0, 1.0, 2.0, "It is a length."); }),
    "Length is 1, but it must be above 1 and at most 2. It is a length.");
  EXPECT_THROW(RequireAbove("Length", 2.5, 1.0, 2.0), std::invalid_argument);
  EXPECT_THROW(RequireAbove("Length", std::nan(""), 1.0, 2.0), std::invalid_argument);
}

TEST(RangeChecks, AConditionThatHoldsIsNoRefusal)
{
  EXPECT_NO_THROW(RequireThat(true, "Length", 3.0, "it must be even"));
  EXPECT_EQ(RefusalOf([] { RequireThat(false, "Length", 3.0, "it must be even"); }),
    "Length is 3, but it must be even.");
}
