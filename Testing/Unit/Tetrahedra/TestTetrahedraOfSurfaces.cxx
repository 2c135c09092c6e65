// Tetrahedra of the shared surfaces by TetGen and CGAL.

#include "Core/PolyDataTriangles.h"
#include "LongTests.h"
#include "MesherTrial.h"
#include "Remeshing/SurfaceRepair.h"
#include "SharedData.h"
#include "SurfaceFiles.h"
#include "SurfaceTable.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"
#include "Tetrahedra/TetrahedralMesher.h"
#include "vtkMSMSReader.h"

#include <vtkNew.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// Surfaces that intersect themselves, so that no mesher may touch them.
bool IsKnownToCross(const std::string& file)
{
  for (const char* name :
    { "neptune.off", "block.off", "dragon.off", "trim-star.off", "sharp_sphere.off" })
  {
    if (file == name)
    {
      return true;
    }
  }
  return false;
}

}

/// Acceptance 1: clean surfaces are filled, others end in an error message.
TEST(TetrahedralMesher, EverySharedSurfaceIsFilledOrRefused)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces");
  for (const KnownSurface& known : KnownSurfaces)
  {
    SCOPED_TRACE(known.File);
    const TriangleMesh mesh =
      ToTriangleMesh(ReadSurface(SharedDataFolder() / "surfaces" / known.File));
    auto parameters = With(TetrahedralLibrary::TetGen, MeshedSide::Inside);
    parameters.TetGen.RadiusEdgeRatio = 0.0;
    const auto start = std::chrono::steady_clock::now();
    const std::string refusal = CatchMessage(mesh, parameters);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("%-28s %6.2f s  %s\n", known.File, seconds.count(), refusal.c_str());
    if (!known.Closed)
    {
      EXPECT_EQ(refusal.rfind("The surface has ", 0), 0u) << refusal;
    }
    else if (IsKnownToCross(known.File))
    {
      EXPECT_EQ(refusal.rfind("The surface intersects itself", 0), 0u) << refusal;
    }
    else
    {
      EXPECT_EQ(refusal, "");
    }
  }
}

// MSMS's surface of lysozyme, a shell and three cavities, crosses itself in 43 triangles.
TEST(TetrahedralMesher, LysozymeIsFilledOnceRepaired)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/lysozyme_msms/Lys1.vert");
  vtkNew<vtkMSMSReader> reader;
  reader->SetFileName((SharedDataFolder() / "surfaces/lysozyme_msms/Lys1.face").c_str());
  reader->Update();
  const TriangleMesh surface = ToTriangleMesh(reader->GetOutput());
  EXPECT_NE(CatchMessage(surface, {}).find("43 triangles"), std::string::npos);
  const RepairedSurface repaired = RepairSurface(surface);
  RequireCleanSurface(repaired.Mesh);
  EXPECT_EQ(EulerCharacteristic(repaired.Mesh), 8);
  double filled = 0.0;
  const TetrahedralMesh mesh = MeshTetrahedra(repaired.Mesh, {});
  for (const auto& [region, volume] : Volumes(mesh))
  {
    filled += volume;
  }
  const double before = SignedVolume(surface), after = SignedVolume(repaired.Mesh);
  std::printf("lysozyme: volume %.3f, repaired %.3f, %zu tetrahedra %.3f; %s\n", before, after,
    mesh.Tetrahedra.size(), filled, repaired.Changes.c_str());
  EXPECT_NEAR(after / before, 1.0, 1e-3); // 0.3 % of its triangles crossed others
  EXPECT_NEAR(filled / after, 1.0, 1e-9);
}

/// Acceptance 1, second half: with quality refinement by TetGen (surface free and kept) and with
/// CGAL, surfaces whose smallest angle exceeds 1 degree. Three of them always, the others in turns
/// (all of them take three minutes).
TEST(TetrahedralMesher, GoodSurfacesAreFilledWithQuality)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces");
  const LongCases others("GoodSurfacesAreFilledWithQuality", 6);
  const std::set<std::string> some{ "eight.off", "sphere.off", "two-tori.obj" };
  std::size_t good = 0, done = 0;
  for (const KnownSurface& known : KnownSurfaces)
  {
    if (!known.Closed || known.SmallestAngle <= 1.0 || IsKnownToCross(known.File))
    {
      continue;
    }
    if (!others.Has(good++) && some.count(known.File) == 0)
    {
      continue;
    }
    ++done;
    SCOPED_TRACE(known.File);
    const TriangleMesh mesh =
      ToTriangleMesh(ReadSurface(SharedDataFolder() / "surfaces" / known.File));
    for (const char* way : { "TetGen pYq", "TetGen pq", "CGAL" })
    {
      const bool cgal = std::string(way) == "CGAL";
      auto parameters =
        With(cgal ? TetrahedralLibrary::CGAL : TetrahedralLibrary::TetGen, MeshedSide::Inside);
      parameters.TetGen.PreserveSurface = std::string(way) == "TetGen pYq";
      parameters.CGAL.MaximumPoints = 1'000'000;
      const auto start = std::chrono::steady_clock::now();
      const auto seconds = [start]
      { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
      std::string ending;
      try
      {
        const TetrahedralMesh result =
          MeshTetrahedra(mesh, parameters, [&](double) { return seconds() < 120.0; });
        double volume = 0.0;
        for (const auto& [region, part] : Volumes(result))
        {
          volume += part;
        }
        ending = std::to_string(result.Tetrahedra.size()) + " tetrahedra";
        EXPECT_NEAR(volume / std::abs(SignedVolume(mesh)), 1.0, cgal ? 0.1 : 1e-4) << way;
      }
      catch (const std::exception& error)
      {
        ending = error.what();
        ADD_FAILURE() << way << ": " << ending;
      }
      std::printf("%-28s %-11s %6.2f s  %s\n", known.File, way, seconds(), ending.c_str());
    }
  }
  others.ReportCases(done, good);
}
