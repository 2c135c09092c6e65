#include "Core/Cached.h"

#include <gtest/gtest.h>

#include <vtkNew.h>
#include <vtkObject.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace
{

using isthmus::Cached;
using isthmus::GetState;

TEST(Cached, EqualKeysComputeOnce)
{
  Cached<std::pair<int, std::string>, double> cache;
  int calls = 0;
  const auto get = [&](int a, const char* b) {
    return cache.Get({ a, b }, [&] { return 10.0 * a + ++calls; });
  };
  EXPECT_EQ(get(1, "a"), 11.0);
  EXPECT_EQ(get(1, "a"), 11.0);
  EXPECT_EQ(get(1, "b"), 12.0);
  EXPECT_EQ(get(1, "a"), 13.0); // only the last one is cached
  EXPECT_EQ(calls, 3);
}

TEST(Cached, TheValueCanBeExtended)
{
  Cached<int, std::string> cache;
  cache.Get(1, [] { return std::string("a"); }) += "b";
  EXPECT_EQ(*cache.Find(1), "ab");
  EXPECT_EQ(cache.Find(2), nullptr);
  EXPECT_EQ(cache.Last(), cache.Find(1));
  cache.Clear();
  EXPECT_EQ(cache.Find(1), nullptr);
  EXPECT_EQ(cache.Last(), nullptr);
}

TEST(Cached, NothingIsCachedAfterAnException)
{
  Cached<int, int> cache;
  cache.Get(1, [] { return 5; });
  EXPECT_THROW(
    cache.Get(2, []() -> int { throw std::runtime_error("aborted"); }), std::runtime_error);
  EXPECT_EQ(cache.Find(1), nullptr);
  EXPECT_EQ(cache.Find(2), nullptr);
  EXPECT_EQ(cache.Get(2, [] { return 6; }), 6);
}

TEST(Cached, TheOldValueIsFreedFirst)
{
  Cached<int, std::shared_ptr<int>> cache;
  const std::weak_ptr<int> old = cache.Get(1, [] { return std::make_shared<int>(1); });
  cache.Get(2,
    [&]
    {
      EXPECT_TRUE(old.expired());
      return std::make_shared<int>(2);
    });
}

TEST(Cached, StatesOfObjectsDifferByTime)
{
  const vtkNew<vtkObject> object;
  const auto before = GetState(object);
  EXPECT_EQ(GetState(object), before);
  object->Modified();
  EXPECT_NE(GetState(object), before);
  EXPECT_EQ(GetState(nullptr), isthmus::ObjectState(nullptr, 0));
}

}
