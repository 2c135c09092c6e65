// Pairs of volumes against GUDHI, against complexes drawn by hand and against counting;
// invariances; every type; bad input.

#include "Persistence/CubicalPersistence.h"

#include "CubicalChecks.h"
#include "PeakMemory.h"
#include "PersistenceVolumes.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <random>
#include <string>

#include <malloc.h>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
std::int64_t BettiAt(const Bars& bars, double dimension, double level)
{
  return std::count_if(bars.begin(), bars.end(),
    [&](const Bar& bar) { return bar[0] == dimension && bar[1] <= level && level < bar[2]; });
}

}

TEST(CubicalPersistence, EqualsGudhi)
{
  ExpectEqualToGudhi(Fill<float>({ 24, 22, 26 }, ShortWave).View(), "waves");
  ExpectEqualToGudhi(AtomDistance({ 24, 25, 23 }, 200, 5).View(), "distance");
  ExpectEqualToGudhi(Noise<float>({ 20, 21, 22 }, -1e6, 1e6).View(), "noise");
  ExpectEqualToGudhi(
    Fill<float>({ 24, 24, 24 },
      [](double x, double y, double z) { return std::floor(3.0 * ShortWave(x, y, z)); })
      .View(),
    "plateaus");
  ExpectEqualToGudhi(Fill<std::uint8_t>({ 30, 24, 24 },
                       [](double x, double y, double z) { return ShortWave(x, y, z) > 0.3; })
                       .View(),
    "mask");
  ExpectEqualToGudhi(Noise<float>({ 17, 1, 19 }, -1e6, 1e6).View(), "one node thick along y");
  ExpectEqualToGudhi(Noise<float>({ 1, 17, 19 }, -1e6, 1e6).View(), "one node thick along x");
  ExpectEqualToGudhi(Noise<float>({ 17, 19, 1 }, -1e6, 1e6).View(), "one node thick along z");
  ExpectEqualToGudhi(Noise<float>({ 1, 1, 60 }, -1e6, 1e6).View(), "a row");
}

TEST(CubicalPersistence, EqualsGudhiForEveryType)
{
  const Size n{ 11, 12, 13 };
  ExpectEqualToGudhi(Noise<double>(n, -1e300, 1e300).View(), "double");
  ExpectEqualToGudhi(Noise<std::int8_t>(n, -128, 128).View(), "int8");
  ExpectEqualToGudhi(Noise<std::uint8_t>(n, 0, 256).View(), "uint8");
  ExpectEqualToGudhi(Noise<std::int16_t>(n, -32768, 32768).View(), "int16");
  ExpectEqualToGudhi(Noise<std::uint16_t>(n, 0, 65536).View(), "uint16");
  ExpectEqualToGudhi(Noise<std::int32_t>(n, -2147483648.0, 2147483647.0).View(), "int32");
  ExpectEqualToGudhi(Noise<std::uint32_t>(n, 0, 4294967295.0).View(), "uint32");
  ExpectEqualToGudhi(Noise<std::int64_t>(n, -9.0e15, 9.0e15).View(), "int64");
  ExpectEqualToGudhi(Noise<std::uint64_t>(n, 0, 1.8e19).View(), "uint64");
}

TEST(CubicalPersistence, SmallImageByHand)
{
  // A wall of ones round a pit of zero in a world of twos:
  //   2 2 2 2 2
  //   2 1 1 1 2     the ring is a loop from 1 on, and the pit fills it when its middle comes;
  //   2 1 9 1 2     the middle comes at 9, before it everything outside is one piece.
  //   2 1 1 1 2
  //   2 2 2 2 2
  const std::vector<int> ring{ 2, 2, 2, 2, 2, 2, 1, 1, 1, 2, 2, 1, 9, 1, 2, 2, 1, 1, 1, 2, 2, 2, 2,
    2, 2 };
  EXPECT_EQ(
    CollectBars(VolumeView(ring.data(), { 5, 5, 1 })), (Bars{ { 0, 1, Infinity }, { 1, 1, 9 } }));
  // Two pits and a ridge between them: the shallower one ends at the ridge.
  const std::vector<float> pits{ 0.0F, 3.0F, 1.0F };
  EXPECT_EQ(
    CollectBars(VolumeView(pits.data(), { 3, 1, 1 })), (Bars{ { 0, 0, Infinity }, { 0, 1, 3 } }));
  EXPECT_EQ(CollectBars(VolumeView(pits.data(), { 3, 1, 1 }), true), (Bars{ { 0, 3, -Infinity } }));
  // A shell: a void from 1 on, filled at 5. Its hollow lies in a cube of 3^3.
  std::vector<double> shell(27, 1.0);
  shell[13] = 5.0;
  EXPECT_EQ(
    CollectBars(VolumeView(shell.data(), { 3, 3, 3 })), (Bars{ { 0, 1, Infinity }, { 2, 1, 5 } }));
  // Nodes that meet only at a corner do not touch (6), the two nodes between them do (26).
  const std::vector<int> corner{ 0, 1, 1, 0 };
  EXPECT_EQ(
    CollectBars(VolumeView(corner.data(), { 2, 2, 1 })), (Bars{ { 0, 0, 1 }, { 0, 0, Infinity } }));
}

TEST(CubicalPersistence, ConstantAndTinyImages)
{
  const std::vector<float> zeros(60, 0.0F);
  EXPECT_EQ(CollectBars(VolumeView(zeros.data(), { 3, 4, 5 })), (Bars{ { 0, 0, Infinity } }));
  std::vector<float> signs(zeros);
  for (std::size_t i = 0; i < signs.size(); i += 2)
  {
    signs[i] = -0.0F;
  }
  EXPECT_EQ(CollectBars(VolumeView(signs.data(), { 3, 4, 5 })), (Bars{ { 0, 0, Infinity } }));
  const std::int16_t one = -7;
  EXPECT_EQ(CollectBars(VolumeView(&one, { 1, 1, 1 })), (Bars{ { 0, -7, Infinity } }));
  EXPECT_TRUE(CubicalPersistence(VolumeView(&one, { 0, 1, 1 })).Pairs.empty());
  // Infinities are values.
  const std::vector<float> ends{ -std::numeric_limits<float>::infinity(), 3.0F, 1.0F,
    std::numeric_limits<float>::infinity(), 2.0F };
  EXPECT_EQ(CollectBars(VolumeView(ends.data(), { 5, 1, 1 })),
    (Bars{ { 0, -Infinity, Infinity }, { 0, 1, 3 }, { 0, 2, Infinity } }));
}

TEST(CubicalPersistence, IntegersBeyondDoubleAreKeptApart)
{
  // 2^60 + 1 and 2^60 are one double, but two levels.
  const std::int64_t big = std::int64_t{ 1 } << 60;
  const std::vector<std::int64_t> pits{ big, big + 1, big - 5, big + 1 };
  EXPECT_EQ(CubicalPersistence(VolumeView(pits.data(), { 4, 1, 1 })).Pairs.size(), 2u);
}

TEST(CubicalPersistence, EulerNumbersAgreeWithBetti)
{
  for (const bool superlevel : { false, true })
  {
    const Volume<float> volume = Fill<float>({ 24, 22, 26 },
      [&](double x, double y, double z) { return (superlevel ? -1.0 : 1.0) * ShortWave(x, y, z); });
    CubicalParameters parameters;
    parameters.Superlevel = superlevel;
    for (int i = -20; i <= 20; ++i)
    {
      parameters.Levels.push_back(0.1 * i);
    }
    const auto numbers = CubicalPersistence(volume.View(), parameters).EulerNumbers;
    Bars bars = CollectBars(volume.View(), superlevel);
    ASSERT_EQ(numbers.size(), parameters.Levels.size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      const double level = (superlevel ? -1.0 : 1.0) * parameters.Levels[i];
      Bars ascending = bars;
      for (Bar& bar : ascending)
      {
        bar[1] *= superlevel ? -1.0 : 1.0;
        bar[2] *= superlevel ? -1.0 : 1.0;
      }
      EXPECT_EQ(numbers[i],
        BettiAt(ascending, 0, level) - BettiAt(ascending, 1, level) + BettiAt(ascending, 2, level));
    }
  }
}

TEST(CubicalPersistence, DoesNotDependOnAxesSignsOrThreads)
{
  const Volume<float> volume = Noise<float>({ 15, 18, 21 }, -20, 20);
  const Bars bars = CollectBars(volume.View());
  const auto& n = volume.Dimensions;
  Volume<float> turned{ { n[2], n[0], n[1] }, std::vector<float>(volume.Values.size()) };
  Volume<double> negative{ n, {} };
  for (std::int64_t i = 0; i < n[0] * n[1] * n[2]; ++i)
  {
    const float value = volume.Values[static_cast<std::size_t>(i)];
    const std::int64_t x = i % n[0];
    const std::int64_t y = i / n[0] % n[1];
    const std::int64_t z = n[2] - 1 - i / (n[0] * n[1]);
    turned.Values[static_cast<std::size_t>(z + n[2] * (x + n[0] * y))] = value;
    negative.Values.push_back(-static_cast<double>(value));
  }
  EXPECT_EQ(CollectBars(turned.View()), bars);
  Bars mirrored = CollectBars(negative.View(), true);
  for (Bar& bar : mirrored)
  {
    bar[1] = -bar[1];
    bar[2] = -bar[2];
  }
  std::sort(mirrored.begin(), mirrored.end());
  EXPECT_EQ(mirrored, bars);
  const Volume<float> large = Fill<float>({ 70, 71, 72 }, ShortWave);
  const auto pairs = CubicalPersistence(large.View()).Pairs;
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, std::string("STDThread"), false),
      [&] { EXPECT_EQ(CubicalPersistence(large.View()).Pairs, pairs); });
  }
}

TEST(CubicalPersistence, WideKeysGiveTheSamePairs)
{
  // Doubles need keys of 128 bits; the same values as floats need 64.
  const Volume<float> narrow = Fill<float>({ 33, 34, 35 }, ShortWave);
  Volume<double> wide{ narrow.Dimensions, { narrow.Values.begin(), narrow.Values.end() } };
  EXPECT_EQ(CubicalPersistence(narrow.View()).Pairs, CubicalPersistence(wide.View()).Pairs);
}

TEST(CubicalPersistence, NaNIsRefusedWithItsPlace)
{
  Volume<float> volume = Fill<float>({ 9, 8, 7 }, ShortWave);
  volume.Values[static_cast<std::size_t>(4 + 9 * (2 + 8 * 5))] = std::nanf("");
  try
  {
    CubicalPersistence(volume.View());
    FAIL() << "accepted";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("node (4, 2, 5) is not a number"), std::string::npos);
  }
}

TEST(CubicalPersistence, StopsOnRequest)
{
  const Volume<float> volume = Fill<float>({ 40, 40, 40 }, ShortWave);
  std::vector<double> told;
  CubicalPersistence(volume.View(), {},
    [&](double fraction)
    {
      told.push_back(fraction);
      return true;
    });
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GE(told.size(), 3u);
  EXPECT_THROW(
    CubicalPersistence(volume.View(), {}, [](double fraction) { return fraction < 0.4; }),
    Cancelled);
}

TEST(CubicalPersistence, BytesAreWithinAFactorOfTwo)
{
  const Size n{ 120, 128, 120 };
  std::mt19937 random(7);
  std::normal_distribution<double> noise;
  double before = 0.0;
  for (const double deviation : { 0.0, 0.1, 0.3, 3.0 })
  {
    const auto volume = Fill<float>(
      n, [&](double x, double y, double z) { return Wave(x, y, z) + deviation * noise(random); });
    const double predicted = CubicalBytes(volume.View(), false);
    malloc_trim(0); // else memory that was freed and is used again would not be measured
    ResetPeakMemory();
    before = PeakMemory();
    if (before <= 0.0)
    {
      GTEST_SKIP() << "The kernel does not report the peak of a process.";
    }
    const CubicalDiagram diagram = CubicalPersistence(volume.View());
    const double bytes = PeakMemory() - before;
    EXPECT_GT(predicted, 0.5 * bytes) << deviation;
    EXPECT_LT(predicted, 2.0 * bytes) << deviation;
  }
}

TEST(CubicalPersistence, BytesOfSmallVolumes)
{
  EXPECT_EQ(CubicalBytes(VolumeView(), false), 0.0);
  const auto row = Noise<std::uint8_t>({ 1, 1, 100 }, 0, 256);
  EXPECT_GT(CubicalBytes(row.View(), false), 500.0);
  EXPECT_LT(CubicalBytes(row.View(), true), 20500.0);
}
