#include "Tetrahedra/AutomaticMesher.h"

#include "MeshedSpheres.h"
#include "SurfaceFiles.h"
#include "Surfaces/HausdorffDistance.h"
#include "Surfaces/SurfaceTopology.h"
#include "TetrahedralChecks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

TEST(HausdorffDistance, HausdorffDistanceOfConcentricSpheres)
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

TEST(AutomaticMesher, ChoosesTheMethodThatMovesTheSurfaceLeast)
{
  const TriangleMesh clean = Sphere({ 0, 0, 0 }, 1.0);
  const AutomaticMesh kept = AutomaticTetrahedra(clean, LimitedParameters());
  EXPECT_EQ(kept.Backend, MeshingBackend::TetGen);
  EXPECT_EQ(kept.Hausdorff, 0.0);
  EXPECT_NEAR(kept.VolumeAfter, SignedVolume(clean), 1e-9);

  TriangleMesh holed = clean;
  holed.Triangles.pop_back();
  const AutomaticMesh repaired = AutomaticTetrahedra(holed, LimitedParameters());
  EXPECT_EQ(repaired.Backend, MeshingBackend::RepairedTetGen) << repaired.Report;
  EXPECT_NEAR(repaired.VolumeAfter, SignedVolume(clean), 1e-2);
  EXPECT_NE(repaired.Report.find("filled 1 hole"), std::string::npos) << repaired.Report;

  // Without TetGen's program a clean surface is meshed by CGAL.
  TetrahedralParameters noTetGen = LimitedParameters();
  noTetGen.TetGen.TetGenCommand = "no-such-program";
  const AutomaticMesh cgal = AutomaticTetrahedra(clean, noTetGen);
  EXPECT_EQ(cgal.Backend, MeshingBackend::RepairedCGAL) << cgal.Report;
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
  TetrahedralParameters coarse = LimitedParameters();
  coarse.CGAL.CellSize = 0.06;
  const AutomaticMesh made = AutomaticTetrahedra(two, coarse);
  std::printf("%s\n", made.Report.c_str());
  EXPECT_EQ(made.Backend, MeshingBackend::Stuffing);
  EXPECT_NEAR(made.VolumeAfter / both, 1.0, 0.015); // the spheres have facets: 0.8 % less
  const QualitySummary quality = MeasureQualityRange(made.Mesh);
  EXPECT_GE(quality.SmallestAngle, 10.7);
  EXPECT_LE(quality.LargestAngle, 164.8);

  for (const MeshedSide side : { MeshedSide::Outside, MeshedSide::Both })
  {
    TetrahedralParameters parameters = LimitedParameters();
    parameters.Side = side;
    parameters.BoxMargin = 0.2;
    parameters.CGAL.CellSize = 0.1;
    const AutomaticMesh other = AutomaticTetrahedra(two, parameters);
    EXPECT_EQ(ComputeVolumes(other.Mesh).count(1), side == MeshedSide::Both ? 1u : 0u);
    EXPECT_NEAR(other.VolumeAfter / made.VolumeAfter, 1.0, 0.03);
    EXPECT_NEAR(other.Hausdorff, made.Hausdorff, 0.1);
  }
}

TEST(AutomaticMesher, NothingEnclosedAndWrongParametersAreRefused)
{
  TriangleMesh sheet;
  sheet.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  sheet.Triangles = { { 0, 1, 2 } };
  EXPECT_THROW(AutomaticTetrahedra(sheet, LimitedParameters()), std::invalid_argument);
  TetrahedralParameters wrong = LimitedParameters();
  wrong.CGAL.FacetAngle = 50.0;
  EXPECT_THROW(AutomaticTetrahedra(Sphere({ 0, 0, 0 }, 1.0), wrong), std::invalid_argument);
  EXPECT_TRUE(AutomaticTetrahedra({}, LimitedParameters()).Mesh.Tetrahedra.empty());
  EXPECT_THROW(AutomaticTetrahedra(Sphere({ 0, 0, 0 }, 1.0), LimitedParameters(),
                 [](double fraction) { return fraction < 0.02; }),
    Cancelled);
}

TEST(AutomaticMesher, AnInfiniteVolumeIsRefused)
{
  for (const double side : { 0.0, 1e120 })
  {
    try
    {
      StuffSolid(Cube({ 0, 0, 0 }, side), {});
      FAIL() << side;
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(
        std::string(error.what()).find("single point, or its coordinates"), std::string::npos)
        << error.what();
    }
  }
}
