// Pairs of volumes against GUDHI, against complexes drawn by hand and against counting;
// invariances; every type; bad input.

#include "CubicalPersistence.h"

#include "CubicalPeer.h"
#include "SharedData.h"
#include "StarMatching.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <fstream>
#include <numeric>
#include <random>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
using Size = std::array<std::int64_t, 3>;

template <typename T>
struct Volume
{
  Size Dimensions;
  std::vector<T> Values;

  VolumeView View() const { return VolumeView(this->Values.data(), this->Dimensions); }
};

template <typename T, typename Function>
Volume<T> Fill(const Size& n, Function&& f)
{
  Volume<T> volume{ n, {} };
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i)
      {
        volume.Values.push_back(static_cast<T>(
          f(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k))));
      }
    }
  }
  return volume;
}

double Wave(double x, double y, double z)
{
  return std::sin(0.61 * x) * std::cos(0.43 * y) + std::sin(0.37 * y + 1.0) * std::cos(0.59 * z) +
    std::sin(0.47 * z) * std::cos(0.39 * x + 0.5);
}

template <typename T>
Volume<T> Noise(const Size& n, double low, double high, unsigned seed = 7)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(low, high);
  return Fill<T>(n, [&](double, double, double) { return std::floor(value(random)); });
}

Volume<float> AtomDistance(const Size& n, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  std::vector<std::array<double, 3>> atoms;
  for (int i = 0; i < 200; ++i)
  {
    const double x = place(random) * static_cast<double>(n[0]);
    const double y = place(random) * static_cast<double>(n[1]);
    const double z = place(random) * static_cast<double>(n[2]);
    atoms.push_back({ x, y, z });
  }
  return Fill<float>(n,
    [&](double x, double y, double z)
    {
      double nearest = Infinity;
      for (const auto& a : atoms)
      {
        nearest = std::min(nearest, std::hypot(x - a[0], y - a[1], z - a[2]));
      }
      return nearest;
    });
}

std::int64_t BettiAt(const Bars& bars, double dimension, double level)
{
  return std::count_if(bars.begin(), bars.end(),
    [&](const Bar& bar) { return bar[0] == dimension && bar[1] <= level && level < bar[2]; });
}

void ExpectEqualToGudhi(const VolumeView& volume, const std::string& what)
{
#if ISTHMUS_HAS_GUDHI_CUBICAL
  for (const bool superlevel : { false, true })
  {
    const Bars ours = BarsOf(volume, superlevel);
    EXPECT_EQ(ours, BarsOfGudhi(volume, superlevel)) << what << ", superlevel " << superlevel;
    EXPECT_GE(ours.size(), 1u) << what;
  }
#else
  static_cast<void>(volume);
  static_cast<void>(what);
  ASSERT_FALSE(isthmus::testing::SharedDataRequired()) << "CI needs GUDHI (libgudhi-dev)";
  GTEST_SKIP() << "GUDHI is not installed (libgudhi-dev)";
#endif
}

/// The floats of an MRC file of mode 2 that is stored plainly; empty where it is something else.
Volume<float> PlainMap(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  std::int32_t header[256] = {};
  file.read(reinterpret_cast<char*>(header), sizeof(header));
  Volume<float> map{ { header[0], header[1], header[2] }, {} };
  const bool sound = file && header[3] == 2 && header[0] > 0 && header[1] > 0 && header[2] > 0 &&
    header[0] < 128 && header[1] < 128 && header[2] < 128;
  if (!sound)
  {
    return { { 0, 0, 0 }, {} };
  }
  file.seekg(1024 + header[23]);
  map.Values.resize(
    static_cast<std::size_t>(map.Dimensions[0] * map.Dimensions[1] * map.Dimensions[2]));
  file.read(reinterpret_cast<char*>(map.Values.data()),
    static_cast<std::streamsize>(map.Values.size() * sizeof(float)));
  return file ? map : Volume<float>{ { 0, 0, 0 }, {} };
}

}

TEST(StarMatching, HasAsManyCriticalCellsAsClassesComeOrGo)
{
  // Every closed star of 2000 drawn at random: the Euler number is that of the critical cells, and
  // no star can do with fewer (components of the link less one, holes of the link).
  std::mt19937 random(3);
  for (int round = 0; round < 2000; ++round)
  {
    std::uint32_t mask =
      static_cast<std::uint32_t>(random()) | static_cast<std::uint32_t>(random());
    mask &= (1U << 26) - 1;
    mask &= Star::FacesOfEdges[mask & 63U] | ~(4095U << 6);
    mask &= Star::CubesOfFaces[mask >> 6 & 4095U] | ~(255U << 18);
    const StarMatching star = MatchStar(mask);
    int euler = 0;
    int critical[4] = { 0, 0, 0, 0 };
    for (int cell = 0; cell <= Star::Node; ++cell)
    {
      const bool present = cell == Star::Node || (mask >> cell & 1U) != 0;
      const auto partner = star.Partner[static_cast<std::size_t>(cell)];
      ASSERT_EQ(partner != Star::Absent, present);
      if (present && partner == cell)
      {
        ++critical[Star::Dimension(cell)];
        euler += Star::Dimension(cell) % 2 == 0 ? 1 : -1;
      }
      ASSERT_TRUE(!present || star.Partner[partner] == cell);
    }
    ASSERT_EQ(euler, star.EulerNumber);
    // Betti numbers of the link: components by flooding its vertices (edges) along its edges
    // (faces); the rest by the Euler number, since only a whole sphere has a void.
    const std::uint32_t edges = mask & 63U;
    if (edges == 0)
    {
      ASSERT_EQ(critical[0], 1);
      continue;
    }
    std::array<int, 6> label{};
    std::iota(label.begin(), label.end(), 0);
    for (int pass = 0; pass < 6; ++pass)
    {
      for (std::size_t face = 0; face < 12; ++face)
      {
        if ((mask >> (face + 6) & 1U) != 0)
        {
          const auto& both = Star::FaceEdges[face];
          label[both[0]] = label[both[1]] = std::min(label[both[0]], label[both[1]]);
        }
      }
    }
    int components = 0;
    for (int edge = 0; edge < 6; ++edge)
    {
      components += (edges >> edge & 1U) != 0 && label[static_cast<std::size_t>(edge)] == edge;
    }
    const int voids = mask == (1U << 26) - 1 ? 1 : 0;
    ASSERT_EQ(critical[1], components - 1);
    ASSERT_EQ(critical[3], voids);
    // Critical faces are the holes of the link: by the Euler number of the link, which is 1 less
    // that of the star.
    const int holes = components + voids - (1 - star.EulerNumber);
    ASSERT_EQ(critical[2], holes) << mask;
  }
}

TEST(CubicalPersistence, EqualsGudhi)
{
  ExpectEqualToGudhi(Fill<float>({ 24, 22, 26 }, Wave).View(), "waves");
  ExpectEqualToGudhi(AtomDistance({ 24, 25, 23 }, 5).View(), "distance");
  ExpectEqualToGudhi(Noise<float>({ 20, 21, 22 }, -1e6, 1e6).View(), "noise");
  ExpectEqualToGudhi(Fill<float>({ 24, 24, 24 },
                       [](double x, double y, double z) { return std::floor(3.0 * Wave(x, y, z)); })
                       .View(),
    "plateaus");
  ExpectEqualToGudhi(Fill<std::uint8_t>({ 30, 24, 24 },
                       [](double x, double y, double z) { return Wave(x, y, z) > 0.3; })
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

TEST(CubicalPersistence, EqualsGudhiOnEMD5043)
{
  ISTHMUS_NEEDS_SHARED_DATA("maps/emd_5043.map");
  const Volume<float> map = PlainMap(SharedDataFolder() / "maps/emd_5043.map");
  ASSERT_EQ(map.Values.size(), 1000000u);
#if ISTHMUS_HAS_GUDHI_CUBICAL
  const Bars ours = BarsOf(map.View(), true);
  EXPECT_EQ(ours, BarsOfGudhi(map.View(), true));
  // Tunnels at the level of the authors' surface.
  EXPECT_EQ(std::count_if(ours.begin(), ours.end(),
              [](const Bar& bar) { return bar[0] == 1.0 && bar[1] >= 1.5 && bar[2] < 1.5; }),
    36);
#endif
}

TEST(CubicalPersistence, EqualsGudhiOnSmallMaps)
{
  ISTHMUS_NEEDS_SHARED_DATA("maps");
  int seen = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SharedDataFolder() / "maps"))
  {
    const Volume<float> map = entry.is_regular_file() ? PlainMap(entry.path()) : Volume<float>{};
    // The larger ones: BenchScalarPersistence, since GUDHI takes ten seconds for a million nodes.
    if (!map.Values.empty() && map.Values.size() < 150000)
    {
      ExpectEqualToGudhi(map.View(), entry.path().filename().string());
      ++seen;
    }
  }
  EXPECT_GE(seen, 5);
}

TEST(CubicalPersistence, DrawnByHand)
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
    BarsOf(VolumeView(ring.data(), { 5, 5, 1 })), (Bars{ { 0, 1, Infinity }, { 1, 1, 9 } }));
  // Two pits and a ridge between them: the shallower one ends at the ridge.
  const std::vector<float> pits{ 0.0F, 3.0F, 1.0F };
  EXPECT_EQ(
    BarsOf(VolumeView(pits.data(), { 3, 1, 1 })), (Bars{ { 0, 0, Infinity }, { 0, 1, 3 } }));
  EXPECT_EQ(BarsOf(VolumeView(pits.data(), { 3, 1, 1 }), true), (Bars{ { 0, 3, -Infinity } }));
  // A shell: a void from 1 on, filled at 5. Its hollow lies in a cube of 3^3.
  std::vector<double> shell(27, 1.0);
  shell[13] = 5.0;
  EXPECT_EQ(
    BarsOf(VolumeView(shell.data(), { 3, 3, 3 })), (Bars{ { 0, 1, Infinity }, { 2, 1, 5 } }));
  // Nodes that meet at a corner only do not touch (6), the two nodes between them do (26).
  const std::vector<int> corner{ 0, 1, 1, 0 };
  EXPECT_EQ(
    BarsOf(VolumeView(corner.data(), { 2, 2, 1 })), (Bars{ { 0, 0, 1 }, { 0, 0, Infinity } }));
}

TEST(CubicalPersistence, ConstantAndTinyImages)
{
  const std::vector<float> zeros(60, 0.0F);
  EXPECT_EQ(BarsOf(VolumeView(zeros.data(), { 3, 4, 5 })), (Bars{ { 0, 0, Infinity } }));
  std::vector<float> signs(zeros);
  for (std::size_t i = 0; i < signs.size(); i += 2)
  {
    signs[i] = -0.0F;
  }
  EXPECT_EQ(BarsOf(VolumeView(signs.data(), { 3, 4, 5 })), (Bars{ { 0, 0, Infinity } }));
  const std::int16_t one = -7;
  EXPECT_EQ(BarsOf(VolumeView(&one, { 1, 1, 1 })), (Bars{ { 0, -7, Infinity } }));
  EXPECT_TRUE(CubicalPersistence(VolumeView(&one, { 0, 1, 1 })).Pairs.empty());
  // Infinities are values.
  const std::vector<float> ends{ -std::numeric_limits<float>::infinity(), 3.0F, 1.0F,
    std::numeric_limits<float>::infinity(), 2.0F };
  EXPECT_EQ(BarsOf(VolumeView(ends.data(), { 5, 1, 1 })),
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
      [&](double x, double y, double z) { return (superlevel ? -1.0 : 1.0) * Wave(x, y, z); });
    CubicalParameters parameters;
    parameters.Superlevel = superlevel;
    for (int i = -20; i <= 20; ++i)
    {
      parameters.Levels.push_back(0.1 * i);
    }
    const auto numbers = CubicalPersistence(volume.View(), parameters).EulerNumbers;
    Bars bars = BarsOf(volume.View(), superlevel);
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

TEST(CubicalPersistence, AxesSignsAndThreadsLeaveNoTrace)
{
  const Volume<float> volume = Noise<float>({ 15, 18, 21 }, -20, 20);
  const Bars bars = BarsOf(volume.View());
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
  EXPECT_EQ(BarsOf(turned.View()), bars);
  Bars mirrored = BarsOf(negative.View(), true);
  for (Bar& bar : mirrored)
  {
    bar[1] = -bar[1];
    bar[2] = -bar[2];
  }
  std::sort(mirrored.begin(), mirrored.end());
  EXPECT_EQ(mirrored, bars);
  const Volume<float> large = Fill<float>({ 70, 71, 72 }, Wave);
  const auto pairs = CubicalPersistence(large.View()).Pairs;
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, std::string("STDThread"), false),
      [&] { EXPECT_EQ(CubicalPersistence(large.View()).Pairs, pairs); });
  }
}

TEST(CubicalPersistence, WideKeysGiveTheSamePairs)
{
  // Doubles take keys of 128 bits; the same values as floats those of 64.
  const Volume<float> narrow = Fill<float>({ 33, 34, 35 }, Wave);
  Volume<double> wide{ narrow.Dimensions, { narrow.Values.begin(), narrow.Values.end() } };
  EXPECT_EQ(CubicalPersistence(narrow.View()).Pairs, CubicalPersistence(wide.View()).Pairs);
}

TEST(CubicalPersistence, NaNIsRefusedWithItsPlace)
{
  Volume<float> volume = Fill<float>({ 9, 8, 7 }, Wave);
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

TEST(CubicalPersistence, StopsWhenAsked)
{
  const Volume<float> volume = Fill<float>({ 40, 40, 40 }, Wave);
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
