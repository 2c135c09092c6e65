// A table of values by id, compared with std::map.

#include "ChokingLoops/SurfacePaths.h"
#include "Core/Handles.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

using namespace isthmus;

namespace
{

using Id = Handle<struct Tried, std::int32_t>;

TEST(IdMap, StoresTheSameAsStdMap)
{
  std::mt19937 random(5);
  // Neighbouring ids, as in paths, and arbitrary ids.
  for (const std::int32_t largest : { 40, 100000, std::numeric_limits<std::int32_t>::max() })
  {
    std::uniform_int_distribution<std::int32_t> any(0, largest);
    IdMap<Id, std::int32_t> table(-7);
    std::map<std::int32_t, std::int32_t> known;
    for (std::int32_t i = 0; i < 20000; ++i)
    {
      const std::int32_t id = any(random);
      table[Id(id)] = i;
      known[id] = i;
    }
    const auto& read = table;
    for (std::int32_t i = 0; i < 20000; ++i)
    {
      const std::int32_t id = any(random);
      const auto found = known.find(id);
      ASSERT_EQ(read[Id(id)], found == known.end() ? -7 : found->second);
    }
    for (const auto& [id, value] : known)
    {
      ASSERT_EQ(read[Id(id)], value);
    }
  }
}

TEST(IdMap, NoneIsASeparateId)
{
  IdMap<Id, int> table(0);
  table[Id::None()] = 3;
  table[Id(0)] = 4;
  EXPECT_EQ(table[Id::None()], 3);
  EXPECT_EQ(table[Id(0)], 4);
  EXPECT_EQ(table[Id(1)], 0);
}

}
