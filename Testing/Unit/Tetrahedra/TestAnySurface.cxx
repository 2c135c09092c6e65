// The Automatic engine on damaged spheres and on all shared surfaces: tetrahedra for each, with a
// volume or a report that agree with an independent measurement.

#include "LongTests.h"
#include "MeshedSpheres.h"
#include "SharedData.h"
#include "SurfaceFiles.h"
#include "SurfaceTable.h"
#include "Surfaces/HausdorffDistance.h"
#include "Surfaces/SurfaceTopology.h"
#include "Surfaces/TriangleTree.h"
#include "TetrahedralChecks.h"

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

/// The largest distance of the surface's undamaged corners from the skin, by a search of all
/// triangles.
double FarthestCorner(const TriangleMesh& surface, const TetrahedralMesh& mesh)
{
  const TriangleMesh skin = BoundarySurface(mesh);
  const auto count = static_cast<std::int64_t>(surface.Points.size());
  double farthest = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    const bool isSound = t[0] != t[1] && t[1] != t[2] && t[2] != t[0] &&
      std::all_of(t.begin(), t.end(),
        [&](std::int64_t id)
        {
          return id >= 0 && id < count &&
            std::isfinite(Dot(surface.Points[static_cast<std::size_t>(id)], { 1, 1, 1 }));
        });
    double least = isSound ? 1e300 : 0.0;
    for (std::size_t s = 0; isSound && s < skin.Triangles.size(); ++s)
    {
      const auto at = [&](std::size_t c)
      { return skin.Points[static_cast<std::size_t>(skin.Triangles[s][c])]; };
      least = std::min(least,
        SquaredDistanceToTriangle(
          surface.Points[static_cast<std::size_t>(t[0])], { at(0), at(1), at(2) }));
    }
    farthest = std::max(farthest, std::sqrt(least));
  }
  return farthest;
}

struct Ends
{
  int Filled = 0, Within = 0, Doubtful = 0, Moved = 0;
  std::array<int, 4> Backends{};
};

void Fill(const TriangleMesh& mesh, double volume, std::uint64_t seed, Ends& ends)
{
  SCOPED_TRACE(seed);
  TetrahedralParameters parameters = LimitedParameters();
  parameters.CGAL.CellSize = 0.06;
  const AutomaticMesh made = AutomaticTetrahedra(mesh, parameters);
  ++ends.Filled;
  ++ends.Backends[static_cast<std::size_t>(made.Backend)];
  EXPECT_NEAR(Solids(made.Mesh), made.VolumeAfter, 1e-6);
  EXPECT_GE(1.0001 * made.Hausdorff + 1e-9, FarthestCorner(mesh, made.Mesh));
  EXPECT_EQ(made.IsDoubtful, made.Report.find("doubtful") != std::string::npos);
  if (made.Backend == MeshingBackend::Stuffing)
  {
    const QualitySummary quality = MeasureQualityRange(made.Mesh);
    EXPECT_GE(quality.SmallestAngle, 10.7);
    EXPECT_LE(quality.LargestAngle, 164.8);
  }
  // Moved points define another solid where the surface is still valid.
  const double truth =
    made.Backend == MeshingBackend::TetGen ? std::abs(SignedVolume(mesh)) : volume;
  const double off = std::abs(made.VolumeAfter / truth - 1.0);
  if (off <= 0.01)
  {
    ++ends.Within;
    return;
  }
  ends.Doubtful += made.IsDoubtful ? 1 : 0;
  ends.Moved += !made.IsDoubtful && made.Hausdorff > 0.0 ? 1 : 0;
  EXPECT_LT(off, 0.1) << made.Report;
  EXPECT_TRUE(made.IsDoubtful || made.Hausdorff > 0.0) << off << " " << made.Report;
}

}

/// Acceptance 3 on 20 cases and ten other ones in each run; on as many as ISTHMUS_FUZZ_CASES gives.
/// The volume is that of the undamaged sphere to 1 %, or the report says that the surface moved.
/// The angles of what stuffing makes are acceptance 1.
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
  Ends ends;
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
      Fill(mesh, SignedVolume(sphere), seed, ends);
    }
    catch (const std::exception& error)
    {
      std::printf("seed %d: %s\n", static_cast<int>(seed), error.what());
    }
  }
  std::printf(
    "%d damaged: %d filled (TetGen %d, after repair %d, CGAL %d, stuffing %d); %d within 1 "
    "%% of the sphere, the volume of %d others said to be doubtful, %d moved as said\n",
    cases, ends.Filled, ends.Backends[0], ends.Backends[1], ends.Backends[2], ends.Backends[3],
    ends.Within, ends.Doubtful, ends.Moved);
  EXPECT_GE(ends.Filled, cases * 99 / 100);
}

/// The shared surfaces that no other engine fills; of the others, a share in each run.
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
    const TriangleMesh mesh =
      ToTriangleMesh(ReadSurface(SharedDataFolder() / "surfaces" / known.File));
    TetrahedralParameters parameters = LimitedParameters();
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
      if (made.Backend == MeshingBackend::Stuffing)
      {
        EXPECT_GE(MeasureQualityRange(made.Mesh).SmallestAngle, 10.7);
        EXPECT_LE(MeasureQualityRange(made.Mesh).LargestAngle, 164.8);
      }
      if (known.Closed)
      {
        EXPECT_NEAR(made.VolumeAfter / std::abs(known.Volume), 1.0, 0.01);
        EXPECT_FALSE(made.IsDoubtful) << made.Report;
      }
    }
    catch (const std::exception& error)
    {
      ADD_FAILURE() << error.what();
    }
  }
  others.ReportCases(done, index);
}
