// Tetrahedra of nested cubes by TetGen and CGAL: volumes of regions, bounds, limits, sentences.

#include "ChokingSurfaces.h"
#include "Core/NumberText.h"
#include "MesherTrial.h"
#include "SurfaceFiles.h"
#include "Tetrahedra/MeshQuality.h"
#include "Tetrahedra/TetrahedralMesher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <set>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// A cube of side 10 with a cavity of side 6, in which floats a cube of side 2; another cube
/// beside.
TriangleMesh NestedCubes()
{
  TriangleMesh mesh = Cube({ 0, 0, 0 }, 10.0);
  TriangleMesh cavity = Cube({ 2, 2, 2 }, 6.0);
  for (Triangle& t : cavity.Triangles)
  {
    std::swap(t[0], t[1]);
  }
  Append(mesh, cavity);
  Append(mesh, Cube({ 4, 4, 4 }, 2.0));
  Append(mesh, Cube({ 12, 0, 0 }, 1.0));
  return mesh;
}

/// Triangles of the mesh between a region above 0 and anything else, each sorted.
std::set<Triangle> Skin(const TetrahedralMesh& mesh)
{
  std::set<Triangle> skin;
  for (const Tetrahedron& t : mesh.Tetrahedra)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      Triangle face{ t[(c + 1) % 4], t[(c + 2) % 4], t[(c + 3) % 4] };
      std::sort(face.begin(), face.end());
      if (!skin.insert(face).second)
      {
        skin.erase(face);
      }
    }
  }
  return skin;
}

}

TEST(TetrahedralMesher, TetGenFillsNestedShellsAndNamesTheirRegions)
{
  const TriangleMesh surface = NestedCubes();
  const auto inside =
    Volumes(MeshTetrahedra(surface, With(TetrahedralLibrary::TetGen, MeshedSide::Inside)));
  ASSERT_EQ(inside.size(), 3u);
  EXPECT_NEAR(inside.at(1), 1000.0 - 216.0, 1e-9);
  EXPECT_NEAR(inside.at(2), 8.0, 1e-11);
  EXPECT_NEAR(inside.at(3), 1.0, 1e-11);

  TetrahedralParameters both = With(TetrahedralLibrary::TetGen, MeshedSide::Both);
  both.BoxMargin = 0.25;
  const auto all = Volumes(MeshTetrahedra(surface, both));
  ASSERT_EQ(all.size(), 5u);
  EXPECT_NEAR(all.at(-1), 216.0 - 8.0, 1e-9);
  const double margin = 0.5 * std::sqrt(169.0 + 100.0 + 100.0);
  const double box = (13.0 + margin) * (10.0 + margin) * (10.0 + margin);
  EXPECT_NEAR(all.at(0), box - 1001.0, 1e-8 * box);

  const auto outside =
    Volumes(MeshTetrahedra(surface, With(TetrahedralLibrary::TetGen, MeshedSide::Outside)));
  EXPECT_EQ(outside.size(), 2u);
  EXPECT_EQ(outside.count(0) + outside.count(-1), 2u);
}

TEST(TetrahedralMesher, CGALFillsNestedShellsAndNamesTheirRegions)
{
  TetrahedralParameters parameters = With(TetrahedralLibrary::CGAL, MeshedSide::Both);
  parameters.BoxMargin = 0.25;
  parameters.CGAL.FacetSize = 0.4;
  parameters.CGAL.FacetDistance = 0.04;
  parameters.CGAL.CellSize = 0.6;
  const auto all = Volumes(MeshTetrahedra(NestedCubes(), parameters));
  ASSERT_EQ(all.size(), 5u);
  EXPECT_NEAR(all.at(1), 784.0, 8.0);
  EXPECT_NEAR(all.at(-1), 208.0, 4.0);
  EXPECT_NEAR(all.at(2), 8.0, 0.5);
  EXPECT_NEAR(all.at(3), 1.0, 0.2);
  const double margin = 0.5 * std::sqrt(369.0);
  const double box = (13.0 + margin) * (10.0 + margin) * (10.0 + margin);
  EXPECT_NEAR(all.at(0), box - 1001.0, 2e-3 * box);
}

// Coordinates are whole, so that moving the cubes rounds nothing.
TEST(TetrahedralMesher, FillsSurfacesFarFromTheOrigin)
{
  for (const Point3& shift : { Point3{ 1e7, 1e7, 1e7 }, Point3{ 0.0, -3e9, 0.0 } })
  {
    TriangleMesh surface = NestedCubes();
    for (Point3& p : surface.Points)
    {
      p = p + shift;
    }
    for (const auto library : { TetrahedralLibrary::TetGen, TetrahedralLibrary::CGAL })
    {
      for (const auto side : { MeshedSide::Inside, MeshedSide::Both })
      {
        TetrahedralParameters parameters = With(library, side);
        parameters.CGAL.FacetSize = 0.4;
        parameters.CGAL.FacetDistance = 0.04;
        parameters.CGAL.CellSize = 0.6;
        parameters.CGAL.MaximumPoints = 200000;
        const TetrahedralMesh mesh = MeshTetrahedra(surface, parameters);
        std::map<int, double> volumes = Volumes(mesh);
        EXPECT_NEAR(volumes[1], 784.0, 8.0);
        EXPECT_NEAR(volumes[2], 8.0, 0.5);
        EXPECT_NEAR(volumes[3], 1.0, 0.2);
        if (side == MeshedSide::Inside)
        {
          Bounds3 box{ mesh.Points[0], mesh.Points[0] };
          std::for_each(
            mesh.Points.begin(), mesh.Points.end(), [&box](const Point3& p) { box.Add(p); });
          EXPECT_LT(Length(box.Min - shift), 0.1);
          EXPECT_LT(Length(box.Max - shift - Point3{ 13.0, 10.0, 10.0 }), 0.1);
        }
      }
    }
  }
}

TEST(TetrahedralMesher, TheSameInputGivesTheSameMesh)
{
  for (const auto library : { TetrahedralLibrary::TetGen, TetrahedralLibrary::CGAL })
  {
    const auto parameters = With(library, MeshedSide::Inside);
    const TetrahedralMesh first = MeshTetrahedra(NestedCubes(), parameters);
    const TetrahedralMesh second = MeshTetrahedra(NestedCubes(), parameters);
    EXPECT_EQ(first.Points, second.Points);
    EXPECT_EQ(first.Tetrahedra, second.Tetrahedra);
    EXPECT_EQ(first.Regions, second.Regions);
  }
}

TEST(TetrahedralMesher, KeptSurfaceIsUnchanged)
{
  const TriangleMesh surface = NestedCubes();
  const TetrahedralMesh mesh =
    MeshTetrahedra(surface, With(TetrahedralLibrary::TetGen, MeshedSide::Inside));
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    EXPECT_EQ(mesh.Points[i], surface.Points[i]);
    EXPECT_EQ(mesh.OriginalPoints[i], static_cast<std::int64_t>(i));
  }
  std::set<Triangle> triangles;
  for (Triangle t : surface.Triangles)
  {
    std::sort(t.begin(), t.end());
    triangles.insert(t);
  }
  EXPECT_EQ(Skin(mesh), triangles);
}

TEST(TetrahedralMesher, TetGenKeepsItsBounds)
{
  TetrahedralParameters parameters = With(TetrahedralLibrary::TetGen, MeshedSide::Inside);
  parameters.TetGen.PreserveSurface = false;
  parameters.TetGen.MaximumVolume = 0.5;
  parameters.TetGen.RadiusEdgeRatio = 1.4;
  const TetrahedralMesh mesh = MeshTetrahedra(NestedCubes(), parameters);
  ASSERT_GT(mesh.Tetrahedra.size(), 2u * 793u); // fewer cannot fill the volume of 793
  double largest = 0.0, worst = 0.0;
  std::size_t above = 0;
  for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
  {
    const Tetrahedron& t = mesh.Tetrahedra[i];
    const auto at = [&](std::size_t c) { return mesh.Points[static_cast<std::size_t>(t[c])]; };
    largest = std::max(largest, Volume(mesh, i));
    const double ratio = MeasureTetrahedron(at(0), at(1), at(2), at(3)).RadiusEdge;
    worst = std::max(worst, ratio);
    above += ratio > 1.4 + 1e-6;
  }
  std::printf("%zu tetrahedra, %zu with a ratio above 1.4, the largest %.3f\n",
    mesh.Tetrahedra.size(), above, worst);
  EXPECT_LE(largest, 0.5 * (1.0 + 1e-9));
  // TetGen 1.5 leaves single tetrahedra above the bound where shells are near each other.
  EXPECT_LE(above, mesh.Tetrahedra.size() / 500);
  EXPECT_LE(worst, 2.0);
  // Without bounds, tetrahedra are larger.
  parameters.TetGen.MaximumVolume = parameters.TetGen.RadiusEdgeRatio = 0.0;
  const TetrahedralMesh free = MeshTetrahedra(NestedCubes(), parameters);
  double without = 0.0;
  for (std::size_t i = 0; i < free.Tetrahedra.size(); ++i)
  {
    without = std::max(without, Volume(free, i));
  }
  EXPECT_GT(without, 5.0);
}

// With a preserved surface and a box around it: tetrahedra that exceed the bounds are nearer to the
// surface than its triangles are long or, by little, on the box; the warning gives their number and
// the excess.
TEST(TetrahedralMesher, TetGenKeepsItsBoundsNextToAPreservedSurface)
{
  TetrahedralParameters parameters = With(TetrahedralLibrary::TetGen, MeshedSide::Both);
  parameters.BoxMargin = 0.1;
  for (const double volumeBound : { 2e-4, 1e-3 })
  {
    parameters.TetGen.MaximumVolume = volumeBound;
    const TriangleMesh torus = Torus(1.0, 0.3, 48, 24);
    const TetrahedralMesh mesh = MeshTetrahedra(torus, parameters);
    double largest = 0.0, worst = 0.0;
    std::size_t large = 0, bad = 0, largeAway = 0, badAway = 0;
    for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
    {
      const Tetrahedron& t = mesh.Tetrahedra[i];
      const auto at = [&](std::size_t c) { return mesh.Points[static_cast<std::size_t>(t[c])]; };
      const double volume = std::abs(Volume(mesh, i));
      const double ratio = MeasureTetrahedron(at(0), at(1), at(2), at(3)).RadiusEdge;
      const Point3 middle = 0.25 * (at(0) + at(1) + at(2) + at(3));
      const bool isAway =
        std::abs(std::hypot(std::hypot(middle[0], middle[1]) - 1.0, middle[2]) - 0.3) > 0.2;
      large += volume > volumeBound * 1.001;
      bad += ratio > 2.0 * 1.001;
      largeAway += volume > volumeBound * 1.25 && isAway;
      badAway += ratio > 2.0 * 1.001 && isAway;
      largest = std::max(largest, volume);
      worst = std::max(worst, ratio);
    }
    std::printf("%zu tetrahedra: volume up to %g, above the bound %zu; ratio up to %.3f, %zu\n",
      mesh.Tetrahedra.size(), largest, large, worst, bad);
    EXPECT_EQ(largeAway, 0U);
    EXPECT_EQ(badAway, 0U);
    const std::string unmet = UnmetBounds(mesh, parameters);
    const auto says = [&](const std::string& what, double most, double bound, std::size_t count)
    {
      return unmet.find(what + " up to " + FormatNumber(most, 3) + " (bound " +
               FormatNumber(bound, 3) + ") in " + std::to_string(count)) != std::string::npos;
    };
    EXPECT_EQ(unmet.empty(), large + bad == 0) << unmet;
    EXPECT_EQ(bad > 0, says("radius-edge ratio", worst, 2.0, bad)) << unmet;
    EXPECT_EQ(large > 0, says("volume", largest, volumeBound, large)) << unmet;
  }
}

TEST(TetrahedralMesher, WrongParametersAreReported)
{
  const TriangleMesh cube = Cube({ 0, 0, 0 }, 1.0);
  auto parameters = With(TetrahedralLibrary::TetGen, MeshedSide::Inside);
  parameters.TetGen.TetGenCommand = "no-such-program";
  EXPECT_NE(CatchMessage(cube, parameters).find("was not found"), std::string::npos);
  parameters = With(TetrahedralLibrary::TetGen, MeshedSide::Inside);
  parameters.TetGen.RadiusEdgeRatio = 0.3;
  EXPECT_NE(CatchMessage(cube, parameters).find("from 1 to"), std::string::npos);
  parameters = With(TetrahedralLibrary::CGAL, MeshedSide::Inside);
  parameters.CGAL.FacetAngle = 45.0;
  EXPECT_NE(CatchMessage(cube, parameters).find("0 to 30"), std::string::npos);
  parameters = With(TetrahedralLibrary::CGAL, MeshedSide::Inside);
  parameters.CGAL.FacetSize = 0.01;
  parameters.CGAL.MaximumPoints = 500;
  EXPECT_NE(CatchMessage(cube, parameters).find("passed 500 points"), std::string::npos);
}

// More than 1e12 points are refused by area or volume, before anything is meshed.
TEST(TetrahedralMesher, SizesThatNeedTooManyPointsAreRefusedImmediately)
{
  const TriangleMesh cube = Cube({ 0, 0, 0 }, 1.0);
  for (double CGALCriteria::*size : { &CGALCriteria::FacetSize, &CGALCriteria::CellSize })
  {
    auto parameters = With(TetrahedralLibrary::CGAL, MeshedSide::Inside);
    parameters.CGAL.MaximumPoints = 500;
    parameters.CGAL.*size = 1e-6;
    EXPECT_NE(CatchMessage(cube, parameters).find("need at least"), std::string::npos)
      << CatchMessage(cube, parameters);
  }
}

TEST(TetrahedralMesher, TimeAndMemoryLimitsAreReported)
{
  const TriangleMesh cube = Cube({ 0, 0, 0 }, 1.0);
  auto parameters = With(TetrahedralLibrary::TetGen, MeshedSide::Inside);
  parameters.TetGen.PreserveSurface = false;
  parameters.TetGen.MaximumVolume = 1e-9;
  parameters.TetGen.Limits = { 0.3, std::uint64_t{ 4 } << 30 };
  EXPECT_NE(CatchMessage(cube, parameters).find("stopped after 0 s"), std::string::npos);
  parameters.TetGen.Limits = { 60.0, std::uint64_t{ 40 } << 20 };
  EXPECT_NE(CatchMessage(cube, parameters).find("memory"), std::string::npos)
    << CatchMessage(cube, parameters);
}

TEST(TetrahedralMesher, StopsOnRequest)
{
  const TriangleMesh cube = Cube({ 0, 0, 0 }, 1.0);
  for (const auto library : { TetrahedralLibrary::TetGen, TetrahedralLibrary::CGAL })
  {
    auto parameters = With(library, MeshedSide::Inside);
    parameters.TetGen.PreserveSurface = false;
    parameters.TetGen.MaximumVolume = 1e-9;
    parameters.CGAL.CellSize = 0.001;
    const auto start = std::chrono::steady_clock::now();
    double last = 0.0;
    const auto stopSoon = [&](double fraction)
    {
      EXPECT_GE(fraction, last);
      last = fraction;
      return std::chrono::steady_clock::now() - start < std::chrono::milliseconds(300);
    };
    EXPECT_THROW(MeshTetrahedra(cube, parameters, stopSoon), Cancelled);
  }
}
