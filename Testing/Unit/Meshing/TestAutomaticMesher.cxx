#include "AutomaticMesher.h"

#include "LongTests.h"
#include "PolyDataMesh.h"
#include "SharedData.h"
#include "SurfaceFiles.h"
#include "SurfaceMove.h"
#include "SurfaceTable.h"
#include "SurfaceTopology.h"
#include "TetrahedralChecks.h"
#include "WindingNumber.h"

#include <vtkNew.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

TriangleMesh Sphere(const Point3& centre, double radius, int resolution = 20)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(centre[0], centre[1], centre[2]);
  source->SetRadius(radius);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->Update();
  return MeshOf(source->GetOutput());
}

TetrahedralParameters Limited()
{
  TetrahedralParameters parameters;
  parameters.TetGen.Limits = { 240.0, std::uint64_t{ 4 } << 30 };
  return parameters;
}

double Solids(const TetrahedralMesh& mesh)
{
  double sum = 0.0;
  for (const auto& [region, volume] : VolumesOf(mesh))
  {
    sum += region > 0 ? volume : 0.0;
  }
  return sum;
}

/// The kinds of damage of TestMeshingFuzz, one at a time.
void Damage(TriangleMesh& mesh, std::mt19937& random)
{
  const auto pick = [&random](std::size_t count)
  { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random); };
  Triangle& t = mesh.Triangles[pick(mesh.Triangles.size())];
  Point3& p = mesh.Points[pick(mesh.Points.size())];
  const auto other = static_cast<std::int64_t>(pick(mesh.Points.size()));
  switch (pick(6))
  {
    case 0:
      t = mesh.Triangles.back();
      mesh.Triangles.pop_back();
      break;
    case 1:
      std::swap(t[0], t[1]);
      break;
    case 2:
      mesh.Triangles.push_back(Triangle(t));
      break;
    case 3:
      t[2] = other;
      break;
    case 4:
      p = p + 0.3 * (mesh.Points[static_cast<std::size_t>(other)] - p);
      break;
    default:
      p[0] = std::nan("");
  }
}

}

TEST(WindingNumber, IsOneInsideZeroOutsideAndInBetweenAtHoles)
{
  TriangleMesh sphere = Sphere({ 0, 0, 0 }, 1.0, 40);
  const WindingNumber closed(sphere);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  for (int i = 0; i < 500; ++i)
  {
    const Point3 x{ place(random), place(random), place(random) };
    double exact = 0.0;
    for (const Triangle& t : sphere.Triangles)
    {
      const auto at = [&](std::size_t c)
      { return sphere.Points[static_cast<std::size_t>(t[c])] - x; };
      exact += SolidAngle(at(0), at(1), at(2));
    }
    const double r = std::sqrt(Dot(x, x));
    EXPECT_NEAR(closed(x), exact / (16.0 * std::atan(1.0)), 0.02);
    if (std::abs(r - 1.0) > 0.02)
    {
      EXPECT_NEAR(closed(x), r < 1.0 ? 1.0 : 0.0, 0.02) << r;
    }
  }
  // A hemisphere is seen from its centre under half of all directions.
  TriangleMesh half = sphere;
  half.Triangles.clear();
  for (const Triangle& t : sphere.Triangles)
  {
    double z = 0.0;
    for (const std::int64_t id : t)
    {
      z += sphere.Points[static_cast<std::size_t>(id)][2];
    }
    if (z > 0.0)
    {
      half.Triangles.push_back(t);
    }
  }
  EXPECT_NEAR(WindingNumber(half)({ 0, 0, 0 }), 0.5, 0.05);
  EXPECT_EQ(WindingNumber({})({ 0, 0, 0 }), 0.0);
}

TEST(SurfaceMove, HausdorffDistanceOfConcentricSpheres)
{
  const TriangleMesh a = Sphere({ 0, 0, 0 }, 1.0, 60), b = Sphere({ 0, 0, 0 }, 1.2, 60);
  EXPECT_NEAR(HausdorffDistance(a, b), 0.2, 0.005);
  EXPECT_NEAR(HausdorffDistance(a, Sphere({ 0.5, 0, 0 }, 1.0, 60)), 0.5, 0.005);
  EXPECT_TRUE(std::isinf(HausdorffDistance(a, {})));
  TriangleMesh two = a;
  Append(two, Sphere({ 3, 0, 0 }, 1.0, 60));
  EXPECT_NEAR(OneSidedDistance(a, two), 0.0, 1e-12);
  EXPECT_NEAR(OneSidedDistance(two, a), 3.0, 0.01);
}

TEST(AutomaticMesher, TakesTheWayThatMovesTheSurfaceLeast)
{
  const TriangleMesh clean = Sphere({ 0, 0, 0 }, 1.0);
  const AutomaticMesh kept = AutomaticTetrahedra(clean, Limited());
  EXPECT_EQ(kept.Way, MeshingWay::TetGen);
  EXPECT_EQ(kept.Hausdorff, 0.0);
  EXPECT_NEAR(kept.VolumeAfter, SignedVolume(clean), 1e-9);

  TriangleMesh holed = clean;
  holed.Triangles.pop_back();
  const AutomaticMesh repaired = AutomaticTetrahedra(holed, Limited());
  EXPECT_EQ(repaired.Way, MeshingWay::RepairedTetGen) << repaired.Report;
  EXPECT_NEAR(repaired.VolumeAfter, SignedVolume(clean), 1e-2);
  EXPECT_NE(repaired.Report.find("filled 1 hole"), std::string::npos) << repaired.Report;

  // Without TetGen's program a clean surface goes to CGAL.
  TetrahedralParameters noTetGen = Limited();
  noTetGen.TetGen.Command = "no-such-program";
  const AutomaticMesh cgal = AutomaticTetrahedra(clean, noTetGen);
  EXPECT_EQ(cgal.Way, MeshingWay::RepairedCGAL) << cgal.Report;
  EXPECT_NEAR(cgal.VolumeAfter / SignedVolume(clean), 1.0, 0.02);
  EXPECT_GT(cgal.Hausdorff, 0.0);
  EXPECT_LT(cgal.Hausdorff, 0.05);
  EXPECT_NE(cgal.Report.find("was not found"), std::string::npos) << cgal.Report;
}

TEST(AutomaticMesher, SpheresThatCrossBecomeTheirUnion)
{
  TriangleMesh two = Sphere({ 0, 0, 0 }, 1.0, 40);
  Append(two, Sphere({ 1.0, 0.03, 0.05 }, 1.0, 40));
  const double d = std::sqrt(1.0 + 0.0034);
  const double pi = 4.0 * std::atan(1.0);
  const double both = 8.0 / 3.0 * pi - pi * (4.0 + d) * (2.0 - d) * (2.0 - d) / 12.0;
  TetrahedralParameters coarse = Limited();
  coarse.CGAL.CellSize = 0.06;
  const AutomaticMesh made = AutomaticTetrahedra(two, coarse);
  std::printf("%s\n", made.Report.c_str());
  EXPECT_EQ(made.Way, MeshingWay::Stuffing);
  EXPECT_NEAR(made.VolumeAfter / both, 1.0, 0.015); // the spheres have facets: 0.8 % less
  const QualitySummary quality = QualityOf(made.Mesh);
  EXPECT_GE(quality.SmallestAngle, 10.7);
  EXPECT_LE(quality.LargestAngle, 164.8);

  for (const MeshedSide side : { MeshedSide::Outside, MeshedSide::Both })
  {
    TetrahedralParameters parameters = Limited();
    parameters.Side = side;
    parameters.BoxMargin = 0.2;
    parameters.CGAL.CellSize = 0.1;
    const AutomaticMesh other = AutomaticTetrahedra(two, parameters);
    EXPECT_EQ(VolumesOf(other.Mesh).count(1), side == MeshedSide::Both ? 1u : 0u);
    EXPECT_NEAR(other.VolumeAfter / made.VolumeAfter, 1.0, 0.03);
    EXPECT_NEAR(other.Hausdorff, made.Hausdorff, 0.1);
  }
}

TEST(AutomaticMesher, NothingEnclosedAndWrongParametersAreRefused)
{
  TriangleMesh sheet;
  sheet.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  sheet.Triangles = { { 0, 1, 2 } };
  EXPECT_THROW(AutomaticTetrahedra(sheet, Limited()), std::invalid_argument);
  TetrahedralParameters wrong = Limited();
  wrong.CGAL.FacetAngle = 50.0;
  EXPECT_THROW(AutomaticTetrahedra(Sphere({ 0, 0, 0 }, 1.0), wrong), std::invalid_argument);
  EXPECT_TRUE(AutomaticTetrahedra({}, Limited()).Mesh.Tetrahedra.empty());
  EXPECT_THROW(AutomaticTetrahedra(Sphere({ 0, 0, 0 }, 1.0), Limited(),
                 [](double fraction) { return fraction < 0.02; }),
    Cancelled);
}

/// Acceptance 3 on 20 cases and ten others at each turn; on as many as ISTHMUS_FUZZ_CASES says.
TEST(AutomaticMesher, DamagedSurfacesAreFilled)
{
  const char* const wanted = std::getenv("ISTHMUS_FUZZ_CASES");
  const int usual = 20;
  const std::uint64_t more = 10;
  const LongCases others("DamagedSurfacesAreFilled", 100);
  std::vector<std::uint64_t> seeds;
  for (int seed = 0; seed < (wanted ? std::atoi(wanted) : usual); ++seed)
  {
    seeds.push_back(static_cast<std::uint64_t>(seed));
  }
  for (std::uint64_t i = 0, first = others.FirstSeed(more); first != 0 && i < more; ++i)
  {
    seeds.push_back(first + i);
  }
  const int cases = static_cast<int>(seeds.size());
  const TriangleMesh sphere = Sphere({ 0, 0, 0 }, 1.0, 12);
  int filled = 0, near = 0;
  std::array<int, 4> ways{};
  for (const std::uint64_t seed : seeds)
  {
    std::mt19937 random(static_cast<unsigned>(seed));
    TriangleMesh mesh = sphere;
    for (std::uint64_t i = 0; i < 1 + seed % 4; ++i)
    {
      Damage(mesh, random);
    }
    try
    {
      const AutomaticMesh made = AutomaticTetrahedra(mesh, Limited());
      ++filled;
      ++ways[static_cast<std::size_t>(made.Way)];
      near += std::abs(made.VolumeAfter / SignedVolume(sphere) - 1.0) < 0.1 ? 1 : 0;
      EXPECT_NEAR(Solids(made.Mesh), made.VolumeAfter, 1e-6) << seed;
      EXPECT_TRUE(std::isfinite(made.Hausdorff)) << seed;
    }
    catch (const std::exception& error)
    {
      std::printf("seed %d: %s\n", static_cast<int>(seed), error.what());
    }
  }
  std::printf("%d damaged: %d filled (TetGen %d, after repair %d, CGAL %d, stuffing %d), %d within "
              "10 %% of the sphere\n",
    cases, filled, ways[0], ways[1], ways[2], ways[3], near);
  EXPECT_GE(filled, cases * 99 / 100);
}

/// Those of the shared surfaces that no other engine fills; the others in turns.
TEST(AutomaticMesher, SharedSurfacesAreFilled)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces");
  const LongCases others("SharedSurfacesAreFilled", 17);
  std::size_t index = 0, done = 0;
  const std::set<std::string> some{ "sharp_sphere.off", "trim-star.off" };
  for (const KnownSurface& known : KnownSurfaces)
  {
    if (!others.Has(index++) && some.count(known.File) == 0)
    {
      continue;
    }
    ++done;
    SCOPED_TRACE(known.File);
    const TriangleMesh mesh = MeshOf(ReadSurface(SharedDataFolder() / "surfaces" / known.File));
    TetrahedralParameters parameters = Limited();
    parameters.TetGen.RadiusEdgeRatio = 0.0;
    const auto start = std::chrono::steady_clock::now();
    try
    {
      const AutomaticMesh made = AutomaticTetrahedra(mesh, parameters);
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      std::printf("%-26s %8zu tetrahedra %6.1f s, volume %.5g (known %.5g): %s\n", known.File,
        made.Mesh.Tetrahedra.size(), seconds.count(), made.VolumeAfter, known.Volume,
        made.Report.c_str());
      EXPECT_GT(made.VolumeAfter, 0.0);
      if (known.Closed)
      {
        EXPECT_NEAR(made.VolumeAfter / std::abs(known.Volume), 1.0, 0.03);
      }
    }
    catch (const std::exception& error)
    {
      ADD_FAILURE() << error.what();
    }
  }
  others.Tell(done, index);
}
