// Ids of two kinds are distinct types, with the size and speed of plain integers.

#include "Core/DisjointSets.h"
#include "Core/Handles.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <type_traits>
#include <unordered_map>

using namespace isthmus;

namespace
{

using Door = Handle<struct DoorKind, std::int32_t>;
using Window = Handle<struct WindowKind, std::int32_t>;
using WideDoor = Handle<struct DoorKind, std::int64_t>;
using Wall = Handle<struct WallKind, std::uint32_t>;

template <typename From, typename To>
constexpr bool Converts = std::is_convertible_v<From, To> || std::is_constructible_v<To, From> ||
  std::is_assignable_v<To&, From>;

static_assert(!Converts<Door, Window> && !Converts<Window, Door>, "kinds don't mix");
static_assert(!Converts<Door, WideDoor> && !Converts<WideDoor, Door>, "nor do widths");
static_assert(!std::is_convertible_v<int, Door> && !std::is_convertible_v<std::size_t, Door>);
static_assert(!std::is_convertible_v<Door, int> && !std::is_constructible_v<std::int32_t, Door>);

template <typename A, typename B, typename = void>
struct AreCompared : std::false_type
{
};
template <typename A, typename B>
struct AreCompared<A, B,
  std::void_t<decltype(std::declval<A>() == std::declval<B>()),
    decltype(std::declval<A>() < std::declval<B>())>> : std::true_type
{
};
static_assert(AreCompared<Door, Door>::value);
static_assert(!AreCompared<Door, Window>::value && !AreCompared<Door, std::int32_t>::value);

template <typename Table, typename Key, typename = void>
struct LooksUp : std::false_type
{
};
template <typename Table, typename Key>
struct LooksUp<Table, Key, std::void_t<decltype(std::declval<Table>()[std::declval<Key>()])>>
  : std::true_type
{
};
using Widths = HandleVector<Door, double>;
static_assert(LooksUp<Widths, Door>::value && LooksUp<const Widths, Door>::value);
static_assert(!LooksUp<Widths, Window>::value && !LooksUp<const Widths, Window>::value);
static_assert(!LooksUp<Widths, std::size_t>::value && !LooksUp<Widths, int>::value);

static_assert(sizeof(Door) == 4 && sizeof(WideDoor) == 8 && sizeof(std::array<Door, 3>) == 12);
static_assert(alignof(Door) == alignof(std::int32_t));
static_assert(std::is_trivially_copyable_v<Door> && std::is_standard_layout_v<Door>);

TEST(Handles, AreOrderedAsTheirNumbers)
{
  for (const int a : { -1, 0, 1, 7, 2147483647 })
  {
    for (const int b : { -1, 0, 1, 7, 2147483647 })
    {
      EXPECT_EQ(Door(a) == Door(b), a == b);
      EXPECT_EQ(Door(a) != Door(b), a != b);
      EXPECT_EQ(Door(a) < Door(b), a < b);
      EXPECT_EQ(Door(a) > Door(b), a > b);
      EXPECT_EQ(Door(a) <= Door(b), a <= b);
      EXPECT_EQ(Door(a) >= Door(b), a >= b);
    }
  }
}

TEST(Handles, NoneIsBelowAllOthersAndDoesNotExist)
{
  EXPECT_FALSE(Door::None().Exists());
  EXPECT_TRUE(Door().Exists());
  EXPECT_EQ(Door(), Door(0));
  EXPECT_LT(Door::None(), Door(0));
  EXPECT_EQ(Door::None().Value, -1);
}

TEST(Handles, TurnIntoPlacesAndBack)
{
  EXPECT_EQ(Door(5).Index(), 5u);
  EXPECT_EQ(Door::At(5), Door(5));
  EXPECT_EQ(WideDoor::At(std::size_t{ 1 } << 40).Index(), std::size_t{ 1 } << 40);
  EXPECT_EQ(Wall::At(4294967295u).Value, 4294967295u);
}

TEST(Handles, AreKeysOfMaps)
{
  std::map<Door, int> ordered{ { Door(2), 20 }, { Door(1), 10 } };
  EXPECT_EQ(ordered.begin()->second, 10);
  std::unordered_map<Door, int> hashed{ { Door(2), 20 }, { Door::None(), 10 } };
  EXPECT_EQ(hashed.at(Door::None()), 10);
  EXPECT_EQ(std::hash<Door>()(Door(42)), std::hash<std::int32_t>()(42));
}

TEST(Handles, AreWalkedInOrder)
{
  const auto walked = [](const auto& range)
  {
    std::vector<int> numbers;
    for (const Door door : range)
    {
      numbers.push_back(door.Value);
    }
    return numbers;
  };
  EXPECT_EQ(walked(HandleRange<Door>(3)), (std::vector<int>{ 0, 1, 2 }));
  EXPECT_EQ(
    walked(HandleRange<Door>(std::int64_t{ 4 }, std::int64_t{ 6 })), (std::vector<int>{ 4, 5 }));
  EXPECT_TRUE(walked(HandleRange<Door>(0)).empty());
}

TEST(Handles, LookIntoTheirOwnVectors)
{
  Widths widths(3, 1.5);
  widths[Door(1)] = 2.5;
  const Widths copy = widths;
  EXPECT_EQ(copy[Door(1)], 2.5);
  EXPECT_EQ(copy.Keys().end() != copy.Keys().begin(), true);
  double sum = 0.0;
  for (const Door door : copy.Keys())
  {
    sum += copy[door];
  }
  EXPECT_EQ(sum, 5.5);
}

/// Handles are stored contiguously as plain integers, as files and GPUs require.
TEST(Handles, LieInMemoryAsTheirNumbers)
{
  const HandleVector<Wall, Door> doors{ Door(3), Door(1), Door::None() };
  std::int32_t numbers[3] = {};
  std::memcpy(numbers, doors.data(), sizeof(numbers));
  EXPECT_EQ(numbers[0], 3);
  EXPECT_EQ(numbers[1], 1);
  EXPECT_EQ(numbers[2], -1);
}

TEST(Handles, AreMembersOfDisjointSets)
{
  DisjointSets<Door> sets(5);
  EXPECT_EQ(sets.Join(Door(4), Door(2)), Door(2));
  sets.JoinUnder(sets.Find(Door(4)), Door(3));
  EXPECT_EQ(sets.Find(Door(4)), Door(3));
  EXPECT_EQ(sets.Find(Door(2)), Door(3));
  EXPECT_EQ(sets.Find(Door(1)), Door(1));
}

}
