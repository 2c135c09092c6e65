// Persistence of real maps: every shared one of at most 128^3 against GUDHI; EMD-5043 turned,
// mirrored and moved; memory per node.

#include "Persistence/CubicalPersistence.h"

#include "CubicalChecks.h"
#include "HeldBytes.h"
#include "PersistenceVolumes.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

const std::string EMD5043 = "maps/emd_5043.map";

/// The same nodes with axis a of the result running along axis `from[a]`, mirrored on request.
Volume<float> Rotate(
  const Volume<float>& map, const std::array<std::size_t, 3>& from, const std::array<bool, 3>& back)
{
  const Size& n = map.Dimensions;
  const Size stride{ 1, n[0], n[0] * n[1] };
  Volume<float> turned{ { n[from[0]], n[from[1]], n[from[2]] }, {} };
  Size at{};
  for (at[2] = 0; at[2] < turned.Dimensions[2]; ++at[2])
  {
    for (at[1] = 0; at[1] < turned.Dimensions[1]; ++at[1])
    {
      for (at[0] = 0; at[0] < turned.Dimensions[0]; ++at[0])
      {
        std::int64_t node = 0;
        for (std::size_t a = 0; a < 3; ++a)
        {
          node += stride[from[a]] * (back[a] ? turned.Dimensions[a] - 1 - at[a] : at[a]);
        }
        turned.Values.push_back(map.Values[static_cast<std::size_t>(node)]);
      }
    }
  }
  return turned;
}

/// The map with its first node at `place` in a box that is 8 nodes longer along each axis,
/// surrounded by its least value.
Volume<float> Moved(const Volume<float>& map, const Size& place)
{
  const Size& n = map.Dimensions;
  const float least = *std::min_element(map.Values.begin(), map.Values.end());
  Volume<float> moved = Fill<float>(
    { n[0] + 8, n[1] + 8, n[2] + 8 }, [least](double, double, double) { return least; });
  for (std::int64_t row = 0; row < n[1] * n[2]; ++row)
  {
    const std::int64_t y = row % n[1] + place[1];
    const std::int64_t z = row / n[1] + place[2];
    std::copy_n(map.Values.begin() + row * n[0], n[0],
      moved.Values.begin() + place[0] + (n[0] + 8) * (y + (n[1] + 8) * z));
  }
  return moved;
}

/// Bytes that the pairs of a volume take at most on four threads (on one it is less), above the
/// memory in use before, per node.
double BytesPerNode(const VolumeView& volume, bool superlevel)
{
  CubicalParameters parameters;
  parameters.Superlevel = superlevel;
  std::int64_t bytes = 0;
  vtkSMPTools::LocalScope(vtkSMPTools::Config(4, std::string("STDThread"), false),
    [&]()
    {
      const std::int64_t before = StartOfHeldBytes();
      EXPECT_FALSE(CubicalPersistence(volume, parameters).Pairs.empty());
      bytes = MostHeldBytes() - before;
    });
  const double each = static_cast<double>(bytes) / static_cast<double>(volume.NodeCount());
  // The number of each node's kind of star is kept to the end.
  EXPECT_GT(each, 4.0);
  return each;
}

/// One of eight parts of the shared maps, so that they can run concurrently.
class SharedMaps : public ::testing::TestWithParam<int>
{
};

}

TEST_P(SharedMaps, EqualGudhi)
{
  ISTHMUS_NEEDS_SHARED_DATA(EMD5043);
  const auto files = SharedMapFiles();
  ASSERT_GE(files.size(), 30u);
  int seen = 0;
  for (std::size_t i = static_cast<std::size_t>(GetParam()); i < files.size(); i += 8)
  {
    const Volume<float> map = ReadMap(files[i]);
    if (IsSmall(map))
    {
      ++seen;
      ExpectEqualToGudhi(map.View(), files[i].filename().string(), true);
      // The other sign of the larger ones: BenchScalarPersistence, since GUDHI takes ten seconds
      // for a million nodes.
      if (map.Values.size() < 150000)
      {
        ExpectEqualToGudhi(map.View(), files[i].filename().string(), false);
      }
    }
  }
  EXPECT_GE(seen, 2);
}

INSTANTIATE_TEST_SUITE_P(Eighths, SharedMaps, ::testing::Range(0, 8));

TEST(PersistenceOfMaps, EMD5043DoesNotDependOnRotationsMirrorsOrShifts)
{
  ISTHMUS_NEEDS_SHARED_DATA(EMD5043);
  const Volume<float> map = ReadMap(SharedDataFolder() / EMD5043);
  ASSERT_EQ(map.Values.size(), 1000000u);
  const Bars bars = CollectBars(map.View(), true);
  // Tunnels at the level of the authors' surface.
  EXPECT_EQ(std::count_if(bars.begin(), bars.end(),
              [](const Bar& bar) { return bar[0] == 1.0 && bar[1] >= 1.5 && bar[2] < 1.5; }),
    36);
  std::array<std::size_t, 3> from{ 0, 1, 2 };
  for (int order = 0; std::next_permutation(from.begin(), from.end()); ++order)
  {
    const Volume<float> turned = Rotate(map, from, { order % 2 == 0, order % 3 == 0, order > 2 });
    EXPECT_TRUE(CollectBars(turned.View(), true) == bars) << from[0] << from[1] << from[2];
  }
  const Bars inBox = CollectBars(Moved(map, { 4, 4, 4 }).View(), true);
  EXPECT_GT(inBox.size(), 1000u);
  EXPECT_TRUE(CollectBars(Moved(map, { 1, 7, 3 }).View(), true) == inBox);
  // Whole numbers added to the values: exact in double, so that births and deaths move by as much.
  Volume<double> raised{ map.Dimensions, { map.Values.begin(), map.Values.end() } };
  for (double& value : raised.Values)
  {
    value += 8.0;
  }
  Bars lowered = CollectBars(raised.View(), true);
  for (Bar& bar : lowered)
  {
    bar[1] -= 8.0;
    bar[2] -= 8.0;
  }
  EXPECT_TRUE(lowered == bars);
}

TEST(HeldBytes, CountEveryAllocationFunction)
{
#if !ISTHMUS_COUNTS_BYTES
  GTEST_SKIP() << "bytes are not counted here: HeldBytes.h";
#endif
  constexpr std::size_t size = 1 << 20;
  struct alignas(256) Wide
  {
    std::array<char, size> Bytes;
  };
  const std::int64_t before = StartOfHeldBytes();
  // An allocator may add a page to a block.
  const auto isSome = [before](std::int64_t bytes, std::int64_t count)
  { return std::abs(bytes - before - count * (1 << 20)) <= count * 4096; };
  {
    const std::vector<char> plain(size);
    const auto wide = std::make_unique<Wide>();
    const std::unique_ptr<void, void (*)(void*)> zeroed(std::calloc(size, 2), &std::free);
    void* grown = std::malloc(16);
    grown = std::realloc(grown, size);
    EXPECT_TRUE(isSome(MostHeldBytes(), 5));
    std::free(grown);
    EXPECT_TRUE(isSome(StartOfHeldBytes(), 4));
  }
  EXPECT_TRUE(isSome(MostHeldBytes(), 4));
  EXPECT_EQ(StartOfHeldBytes(), before);
}

TEST(PersistenceOfMaps, MemoryStaysWithinBounds)
{
#if !ISTHMUS_COUNTS_BYTES
  GTEST_SKIP() << "bytes are not counted here: HeldBytes.h";
#endif
  EXPECT_LT(BytesPerNode(Fill<float>({ 128, 128, 128 }, Wave).View(), false), 20.0);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  const auto draw = [&](double, double, double) { return value(random); };
  EXPECT_LT(BytesPerNode(Fill<float>({ 96, 96, 96 }, draw).View(), false), 120.0);
  ISTHMUS_NEEDS_SHARED_DATA(EMD5043);
  const Volume<float> map = ReadMap(SharedDataFolder() / EMD5043);
  for (const bool superlevel : { true, false })
  {
    EXPECT_LT(BytesPerNode(map.View(), superlevel), 20.0);
  }
}
