#include "Tetrahedra/IsosurfaceStuffing.h"

#include "TetrahedralChecks.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

const double pi = 4.0 * std::atan(1.0);

/// Two numbers in [0, 1) for a place on a lattice of quarters, the same whenever asked.
struct Noise
{
  std::uint64_t Seed;

  std::array<double, 2> operator()(const Point3& x) const
  {
    std::uint64_t h = (this->Seed + 1) * 7919;
    for (const double coordinate : x)
    {
      h = (h ^ static_cast<std::uint64_t>(std::llround(coordinate * 4.0 + 1000.0))) *
        0x9E3779B97F4A7C15ULL;
      h ^= h >> 29;
    }
    h *= 0xBF58476D1CE4E5B9ULL;
    h ^= h >> 32;
    const double first = static_cast<double>(h >> 11) * 0x1p-53;
    h *= 0x94D049BB133111EBULL;
    h ^= h >> 31;
    return { first, static_cast<double>(h >> 11) * 0x1p-53 };
  }
};

constexpr double NoiseSide = 8.0;

/// A level set without any smoothness: every lattice point has a value of its own. One kind has
/// values whose crossings fall just before or after the alphas, where angles are worst.
double RandomValue(std::uint64_t seed, const Point3& x)
{
  for (const double coordinate : x)
  {
    if (coordinate < 0.1 || coordinate > NoiseSide - 0.1)
    {
      return -1.0;
    }
  }
  const auto [u, v] = Noise{ seed }(x);
  constexpr double l = StuffingAlphaLong / (1.0 - StuffingAlphaLong);
  constexpr double s = StuffingAlphaShort / (1.0 - StuffingAlphaShort);
  constexpr double e = 1e-6;
  constexpr double edges[] = { 1, l * (1 - e), l * (1 + e), s * (1 - e), s * (1 + e), e, 1 / l,
    (1 + e) / s, l * s, s * s };
  switch (seed % 3)
  {
    case 0:
      return u - 0.5;
    case 1:
      return (v < 0.4 ? 1.0 : -1.0) * std::exp(12.0 * (u - 0.5));
    default:
      return (v < 0.25 * static_cast<double>(1 + seed % 4) ? 1.0 : -1.0) *
        edges[static_cast<std::size_t>(10.0 * u)];
  }
}

IsosurfaceStuffingResult Random(std::uint64_t seed, StuffingParameters parameters)
{
  parameters.CellSize = 1.0;
  return IsosurfaceStuffing([seed](const Point3& x) { return RandomValue(seed, x); },
    { { 0, 0, 0 }, { NoiseSide, NoiseSide, NoiseSide } }, parameters);
}

IsosurfaceStuffingResult Ball(double h, MeshedSide side, int levels = 0)
{
  StuffingParameters parameters;
  parameters.CellSize = h;
  parameters.Side = side;
  parameters.GradingLevels = levels;
  return IsosurfaceStuffing([](const Point3& x) { return 1.0 - std::sqrt(Dot(x, x)); },
    { { -1, -1, -1 }, { 1, 1, 1 } }, parameters);
}

double BoxVolume(const TetrahedralMesh& mesh)
{
  const Bounds3 box = ComputeBounds(mesh);
  const Point3 d = box.Max - box.Min;
  return d[0] * d[1] * d[2];
}

double Total(const TetrahedralMesh& mesh)
{
  double sum = 0.0;
  for (const auto& [region, volume] : ComputeVolumes(mesh))
  {
    sum += volume;
  }
  return sum;
}

/// Do all triangles of the skin of a mesh of both sides lie in a side of its box?
bool SkinIsTheBox(const TetrahedralMesh& mesh, const std::set<Triangle>& skin)
{
  const Bounds3 box = ComputeBounds(mesh);
  for (const Triangle& t : skin)
  {
    bool inOneSide = false;
    for (std::size_t a = 0; a < 3; ++a)
    {
      for (const double at : { box.Min[a], box.Max[a] })
      {
        inOneSide = inOneSide ||
          std::all_of(t.begin(), t.end(),
            [&](std::int64_t id) { return mesh.Points[static_cast<std::size_t>(id)][a] == at; });
      }
    }
    if (!inOneSide)
    {
      return false;
    }
  }
  return true;
}

}

/// Acceptance 1: the bounds hold on level sets of pure noise, both sides, uniform and graded; every
/// face inside the box belongs to two tetrahedra; they fill the box, so that none is turned over.
TEST(IsosurfaceStuffing, AnglesStayWithinTheBoundsOnRandomLevelSets)
{
  double smallest = 180.0, largest = 0.0;
  std::size_t tetrahedra = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    StuffingParameters parameters;
    parameters.Side = MeshedSide::Both;
    parameters.GradingLevels = static_cast<int>(seed % 3);
    const TetrahedralMesh mesh = Random(seed, parameters).Mesh;
    const QualitySummary quality = MeasureQualityRange(mesh);
    smallest = std::min(smallest, quality.SmallestAngle);
    largest = std::max(largest, quality.LargestAngle);
    tetrahedra += mesh.Tetrahedra.size();
    ASSERT_GE(quality.SmallestAngle, 10.7) << "seed " << seed;
    ASSERT_LE(quality.LargestAngle, 164.8) << "seed " << seed;
    ASSERT_NEAR(Total(mesh) / BoxVolume(mesh), 1.0, 1e-11) << "seed " << seed;
    if (seed % 10 == 0)
    {
      const FaceCounts faces = CountFaces(mesh);
      ASSERT_EQ(faces.Crowded, 0);
      ASSERT_TRUE(SkinIsTheBox(mesh, faces.Skin)) << "seed " << seed;
    }
  }
  std::printf("%zu tetrahedra of 200 random level sets: dihedral angles %.4f to %.4f\n", tetrahedra,
    smallest, largest);
}

TEST(IsosurfaceStuffing, SingleSidesMatchBoth)
{
  for (const std::uint64_t seed : { 0u, 1u, 2u, 3u })
  {
    StuffingParameters parameters;
    parameters.Side = MeshedSide::Both;
    const auto both = Random(seed, parameters).Mesh;
    parameters.Side = MeshedSide::Inside;
    const auto inside = Random(seed, parameters).Mesh;
    parameters.Side = MeshedSide::Outside;
    const auto outside = Random(seed, parameters).Mesh;
    EXPECT_EQ(inside.Tetrahedra.size() + outside.Tetrahedra.size(), both.Tetrahedra.size());
    EXPECT_NEAR(Total(inside), ComputeVolumes(both).at(1), 1e-9);
    EXPECT_NEAR(Total(outside), ComputeVolumes(both).at(0), 1e-9);
    EXPECT_EQ(CountFaces(both).Interface.size(), CountFaces(inside).Skin.size());
  }
}

TEST(IsosurfaceStuffing, PointsOnTheSurfaceAreOnIt)
{
  const double h = 0.1;
  const auto result = Ball(h, MeshedSide::Both);
  const FaceCounts faces = CountFaces(result.Mesh);
  EXPECT_EQ(result.KeptPoints, 0);
  for (const Triangle& t : faces.Interface)
  {
    for (const std::int64_t id : t)
    {
      ASSERT_TRUE(result.OnSurface[static_cast<std::size_t>(id)]);
    }
  }
  for (std::size_t i = 0; i < result.Mesh.Points.size(); ++i)
  {
    const Point3& p = result.Mesh.Points[i];
    if (result.OnSurface[i])
    {
      // A distance is bent by 1/r; linear interpolation over h is off by h^2 / 8r.
      ASSERT_NEAR(std::sqrt(Dot(p, p)), 1.0, h * h / 8.0 * 1.1);
    }
  }
}

TEST(IsosurfaceStuffing, VolumeConvergesWithOrderTwo)
{
  double last = 0.0;
  for (const double h : { 0.2, 0.1, 0.05 })
  {
    const auto result = Ball(h, MeshedSide::Inside);
    const double error = std::abs(Total(result.Mesh) - 4.0 / 3.0 * pi);
    const double order = std::log2(last / error);
    std::printf("h %.3f: volume off by %.3e, order %.2f, angles %.2f to %.2f\n", h, error,
      last > 0.0 ? order : 0.0, MeasureQualityRange(result.Mesh).SmallestAngle,
      MeasureQualityRange(result.Mesh).LargestAngle);
    if (last > 0.0)
    {
      EXPECT_NEAR(order, 2.0, 0.2);
    }
    last = error;
  }
}

TEST(IsosurfaceStuffing, GradingKeepsTheSurfaceAndSavesTetrahedra)
{
  const auto uniform = Ball(0.06, MeshedSide::Both);
  for (const int levels : { 1, 2 })
  {
    const auto graded = Ball(0.06, MeshedSide::Both, levels);
    const FaceCounts faces = CountFaces(graded.Mesh);
    EXPECT_EQ(faces.Crowded, 0);
    EXPECT_TRUE(SkinIsTheBox(graded.Mesh, faces.Skin));
    EXPECT_LT(graded.Mesh.Tetrahedra.size(), uniform.Mesh.Tetrahedra.size());
    EXPECT_NEAR(Total(graded.Mesh) / BoxVolume(graded.Mesh), 1.0, 1e-11);
    EXPECT_NEAR(ComputeVolumes(graded.Mesh).at(1) / ComputeVolumes(uniform.Mesh).at(1), 1.0, 2e-3);
    EXPECT_GE(MeasureQualityRange(graded.Mesh).SmallestAngle, 10.7);
    EXPECT_LE(MeasureQualityRange(graded.Mesh).LargestAngle, 164.8);
  }
  // The more cells, the larger the part that the surface does not hold to the finest.
  EXPECT_LT(4 * Ball(0.04, MeshedSide::Both, 2).Mesh.Tetrahedra.size(),
    3 * Ball(0.04, MeshedSide::Both).Mesh.Tetrahedra.size());
}

TEST(IsosurfaceStuffing, MovedAndTurnedAroundItStaysAsGood)
{
  // A torus in a general place, seen from inside and from outside.
  for (const double sign : { 1.0, -1.0 })
  {
    StuffingParameters parameters;
    parameters.CellSize = 0.07;
    const auto result = IsosurfaceStuffing(
      [sign](const Point3& x)
      {
        const Point3 n{ 0.48, 0.6, 0.64 };
        const Point3 y = x - Point3{ 0.011, 0.023, 0.037 };
        const double z = Dot(y, n);
        const double rho = std::sqrt(std::max(0.0, Dot(y, y) - z * z)) - 0.7;
        const double torus = 0.25 - std::sqrt(rho * rho + z * z);
        const double box = 1.2 - std::max({ std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
        return sign > 0.0 ? torus : std::min(box, -torus);
      },
      { { -1.2, -1.2, -1.2 }, { 1.2, 1.2, 1.2 } }, parameters);
    const double torus = 2.0 * pi * pi * 0.7 * 0.25 * 0.25;
    EXPECT_NEAR(Total(result.Mesh), sign > 0.0 ? torus : 2.4 * 2.4 * 2.4 - torus, 0.03);
    EXPECT_GE(MeasureQualityRange(result.Mesh).SmallestAngle, 10.7);
  }
}

TEST(IsosurfaceStuffing, IdenticalOnAnyNumberOfThreads)
{
  StuffingParameters parameters;
  parameters.Side = MeshedSide::Both;
  parameters.GradingLevels = 1;
  const auto first = Random(5, parameters);
  for (const int threads : { 1, 2, 3 })
  {
    vtkSMPTools::LocalScope({ threads, threads == 1 ? "Sequential" : "STDThread", false },
      [&]
      {
        const auto other = Random(5, parameters);
        EXPECT_EQ(other.Mesh.Points, first.Mesh.Points);
        EXPECT_EQ(other.Mesh.Tetrahedra, first.Mesh.Tetrahedra);
        EXPECT_EQ(other.Mesh.Regions, first.Mesh.Regions);
      });
  }
}

TEST(IsosurfaceStuffing, ExtremeValuesAndExactLevelsAreFine)
{
  StuffingParameters parameters;
  parameters.CellSize = 1.0;
  parameters.Side = MeshedSide::Both;
  for (const double scale : { 1e-310, 1e300 })
  {
    const auto result = IsosurfaceStuffing(
      [scale](const Point3& x) {
        return scale * (x[0] < 3.0 ? -1.0 : x[0] > 5.0 || x[1] > 6.0 ? -1.0 : 1.0);
      },
      { { 0, 0, 0 }, { 8, 8, 8 } }, parameters);
    EXPECT_GE(MeasureQualityRange(result.Mesh).SmallestAngle, 10.7) << scale;
  }
  // The level right at lattice points: flat sides come out flat.
  const auto slab = IsosurfaceStuffing(
    [](const Point3& x) {
      return std::min({ x[0], 4.0 - x[0], x[1], 4.0 - x[1], x[2], 4.0 - x[2] });
    },
    { { 0, 0, 0 }, { 4, 4, 4 } }, parameters);
  EXPECT_GE(MeasureQualityRange(slab.Mesh).SmallestAngle, 10.7);
  EXPECT_NEAR(ComputeVolumes(slab.Mesh).at(1), 64.0, 1.0);
}

TEST(IsosurfaceStuffing, UnreachableBoundsAreRefused)
{
  const auto fails = [](double size, int levels, std::uint64_t bytes)
  {
    StuffingParameters parameters;
    parameters.CellSize = size;
    parameters.GradingLevels = levels;
    parameters.Memory = MemoryBudget::ForBytes(bytes);
    try
    {
      IsosurfaceStuffing(
        [](const Point3&) { return -1.0; }, { { 0, 0, 0 }, { 1, 1, 1 } }, parameters);
    }
    catch (const std::exception& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(fails(0.0, 0, 0).find("CellSize is 0, but"), std::string::npos);
  EXPECT_NE(fails(std::nan(""), 0, 0).find("CellSize is not a number"), std::string::npos);
  EXPECT_NE(fails(1e-9, 0, 0).find("262144 cells"), std::string::npos);
  EXPECT_NE(
    fails(0.1, 9, 0).find("GradingLevels is 9, but it must be from 0 to 8"), std::string::npos);
  EXPECT_NE(fails(0.01, 0, 1 << 20).find("MemoryLimit is 1 MiB"), std::string::npos);
  EXPECT_EQ(fails(0.5, 0, 0), "");
  EXPECT_THROW(IsosurfaceStuffing([](const Point3&) { return -1.0; }, { { 0, 0, 0 }, { 1, 1, 1 } },
                 StuffingParameters{ 1.0 }, [](double) { return false; }),
    Cancelled);
}

/// A few of the level sets of AnglesStayWithinTheBoundsOnRandomLevelSets.
TEST(IsosurfaceStuffing, AnglesAndFacesOfSomeRandomLevelSets)
{
  for (std::uint64_t seed = 0; seed < 6; ++seed)
  {
    StuffingParameters parameters;
    parameters.Side = MeshedSide::Both;
    parameters.GradingLevels = static_cast<int>(seed % 3);
    const TetrahedralMesh mesh = Random(seed, parameters).Mesh;
    EXPECT_GE(MeasureQualityRange(mesh).SmallestAngle, 10.7) << "seed " << seed;
    EXPECT_LE(MeasureQualityRange(mesh).LargestAngle, 164.8) << "seed " << seed;
    EXPECT_NEAR(Total(mesh) / BoxVolume(mesh), 1.0, 1e-11) << "seed " << seed;
  }
}

TEST(IsosurfaceStuffing, AGradedBallIsComplete)
{
  const auto graded = Ball(0.15, MeshedSide::Both, 2).Mesh;
  const FaceCounts faces = CountFaces(graded);
  EXPECT_EQ(faces.Crowded, 0);
  EXPECT_TRUE(SkinIsTheBox(graded, faces.Skin));
  EXPECT_NEAR(Total(graded) / BoxVolume(graded), 1.0, 1e-11);
}
