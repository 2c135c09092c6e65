#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"

#include "Core/PolyDataTriangles.h"
#include "Remeshing/SurfaceRepair.h"
#include "SharedData.h"
#include "SurfaceFiles.h"
#include "SurfaceTable.h"

#include <gtest/gtest.h>

#include <random>

using namespace isthmus;
using isthmus::testing::Cube;

namespace
{

double Area(const TriangleMesh& mesh)
{
  double sum = 0.0;
  for (const Triangle& t : mesh.Triangles)
  {
    const auto at = [&](std::size_t c) { return mesh.Points[static_cast<std::size_t>(t[c])]; };
    const Point3 n = Cross(at(1) - at(0), at(2) - at(0));
    sum += 0.5 * std::sqrt(Dot(n, n));
  }
  return sum;
}

std::string CatchMessage(const TriangleMesh& mesh)
{
  try
  {
    RequireCleanSurface(mesh);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return {};
}

void ExpectMentions(const std::string& sentence, const std::string& words)
{
  EXPECT_NE(sentence.find(words), std::string::npos) << "'" << sentence << "' lacks: " << words;
}

}

TEST(SurfaceDefects, ACubeIsCleanAndHasVolumeOne)
{
  const TriangleMesh cube = Cube({ 5, -3, 1 }, 1.0);
  EXPECT_EQ(FindDefects(cube).Message(), "");
  EXPECT_DOUBLE_EQ(SignedVolume(cube), 1.0);
  EXPECT_EQ(EulerCharacteristic(cube), 2);
  EXPECT_EQ(CatchMessage(cube), "");
}

TEST(SurfaceDefects, EachDefectIsNamedWithItsPlace)
{
  TriangleMesh hole = Cube({ 0, 0, 0 }, 1.0);
  hole.Triangles.pop_back();
  ExpectMentions(CatchMessage(hole), "triangles at a hole (");

  TriangleMesh flipped = Cube({ 0, 0, 0 }, 1.0);
  std::swap(flipped.Triangles[4][0], flipped.Triangles[4][1]);
  ExpectMentions(CatchMessage(flipped), "opposite orientation");

  TriangleMesh twice = Cube({ 0, 0, 0 }, 1.0);
  twice.Triangles.push_back(twice.Triangles[7]);
  ExpectMentions(CatchMessage(twice), "duplicate triangles (12)");
  ExpectMentions(CatchMessage(twice), "edge of more than two");

  TriangleMesh lost = Cube({ 0, 0, 0 }, 1.0);
  lost.Points[3][1] = std::numeric_limits<double>::quiet_NaN();
  ExpectMentions(CatchMessage(lost), "points that are not finite (3)");

  TriangleMesh wrong = Cube({ 0, 0, 0 }, 1.0);
  wrong.Triangles[2] = { 4, 5, 99 };
  ExpectMentions(CatchMessage(wrong), "repeated or missing point (2)");

  TriangleMesh flat = Cube({ 0, 0, 0 }, 1.0);
  flat.Points[7] = flat.Points[6];
  ExpectMentions(CatchMessage(flat), "triangles without area (");
}

TEST(SurfaceDefects, CubesThatShareAPointOrCrossAreRefused)
{
  TriangleMesh touching = Cube({ 0, 0, 0 }, 1.0);
  isthmus::testing::Append(touching, Cube({ 1, 1, 1 }, 1.0));
  for (Triangle& t : touching.Triangles)
  {
    std::replace(t.begin(), t.end(), std::int64_t{ 8 }, std::int64_t{ 7 });
  }
  ExpectMentions(CatchMessage(touching), "points where sheets touch (7)");

  TriangleMesh crossing = Cube({ 0, 0, 0 }, 1.0);
  isthmus::testing::Append(crossing, Cube({ 0.5, 0.4, 0.3 }, 1.0));
  ExpectMentions(CatchMessage(crossing), "intersects itself in");
  ExpectMentions(CatchMessage(crossing), "cross at (");
}

TEST(SurfaceRepair, RepairsACubeWithAHoleAndAFlippedTriangle)
{
  TriangleMesh broken = Cube({ 0, 0, 0 }, 1.0);
  std::swap(broken.Triangles[4][0], broken.Triangles[4][1]);
  broken.Triangles.pop_back();
  broken.Points.push_back({ std::numeric_limits<double>::infinity(), 0, 0 });
  broken.Triangles.push_back({ 0, 1, 8 });
  const RepairedSurface repaired = RepairSurface(broken);
  EXPECT_EQ(CatchMessage(repaired.Mesh), "");
  EXPECT_NEAR(std::abs(SignedVolume(repaired.Mesh)), 1.0, 1e-12);
  ExpectMentions(repaired.Changes, "filled 1 hole");
  for (std::size_t i = 0; i < repaired.Mesh.Points.size(); ++i)
  {
    ASSERT_GE(repaired.OriginalPoints[i], 0);
    EXPECT_EQ(
      repaired.Mesh.Points[i], broken.Points[static_cast<std::size_t>(repaired.OriginalPoints[i])]);
  }
}

TEST(SurfaceDefects, EverySharedSurfaceHasItsKnownDefects)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces");
  for (const isthmus::testing::KnownSurface& known : isthmus::testing::KnownSurfaces)
  {
    SCOPED_TRACE(known.File);
    const auto path = isthmus::testing::SharedDataFolder() / "surfaces" / known.File;
    const auto surface = isthmus::testing::ReadSurface(path);
    const TriangleMesh mesh = ToTriangleMesh(surface);
    const bool polygons = surface->GetPolys()->IsHomogeneous() != 3;
    const SurfaceDefects defects = FindDefects(mesh);
    EXPECT_EQ(defects.None(), known.Closed) << defects.Message();
    // Diagonals of bent quads may be drawn either way.
    const double tolerance = polygons ? 2e-3 : 2e-6;
    EXPECT_NEAR(Area(mesh) / known.Area, 1.0, tolerance);
    if (known.Closed)
    {
      const std::vector<int> components = Components(mesh);
      EXPECT_EQ(*std::max_element(components.begin(), components.end()) + 1, known.Components);
      EXPECT_EQ((2 * known.Components - EulerCharacteristic(mesh)) / 2, known.Genus);
      EXPECT_NEAR(SignedVolume(mesh) / known.Volume, 1.0, tolerance);
    }
  }
}
