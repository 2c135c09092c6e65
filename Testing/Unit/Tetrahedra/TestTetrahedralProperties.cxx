// The quantity that each property of the tetrahedral mesher bounds, measured on the mesh.

#include "Core/PolyDataTriangles.h"
#include "SurfaceFiles.h"
#include "Surfaces/HausdorffDistance.h"
#include "Surfaces/SurfaceTopology.h"
#include "Tetrahedra/TetrahedralMesher.h"
#include "TetrahedralChecks.h"

#include <vtkNew.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

TriangleMesh Sphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1.0);
  source->SetThetaResolution(60);
  source->SetPhiResolution(60);
  source->Update();
  return ToTriangleMesh(source->GetOutput());
}

struct Measured
{
  std::size_t Cells;
  double RadiusEdge, Volume, Circumradius, SmallestDihedral; ///< largest three, smallest one
  double FacetAngle, FacetRadius, Distance;                  ///< of the skin
};

double Circumradius(const Point3& a, const Point3& b, const Point3& c)
{
  const auto length = [](const Point3& d) { return std::sqrt(Dot(d, d)); };
  return length(b - a) * length(c - b) * length(a - c) / (2.0 * length(Cross(b - a, c - a)));
}

Measured Measure(const TetrahedralMesh& mesh, const TriangleMesh& surface)
{
  Measured m{ mesh.Tetrahedra.size(), 0, 0, 0, 180, 180, 0, 0 };
  for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
  {
    const Tetrahedron& t = mesh.Tetrahedra[i];
    const auto at = [&](std::size_t c) { return mesh.Points[static_cast<std::size_t>(t[c])]; };
    const CellAngles cell = MeasureTetrahedron(at(0), at(1), at(2), at(3));
    double shortest = 1e300;
    for (std::size_t a = 0; a < 4; ++a)
    {
      for (std::size_t b = 0; b < a; ++b)
      {
        shortest = std::min(shortest, std::sqrt(Dot(at(a) - at(b), at(a) - at(b))));
      }
    }
    m.RadiusEdge = std::max(m.RadiusEdge, cell.RadiusEdge);
    m.Circumradius = std::max(m.Circumradius, cell.RadiusEdge * shortest);
    m.SmallestDihedral = std::min(m.SmallestDihedral, cell.Smallest);
    m.Volume = std::max(m.Volume, ComputeVolume(mesh, i));
  }
  const TriangleMesh skin = BoundarySurface(mesh);
  for (const Triangle& t : skin.Triangles)
  {
    const auto at = [&](std::size_t c) { return skin.Points[static_cast<std::size_t>(t[c])]; };
    m.FacetAngle = std::min(m.FacetAngle, MeasureTriangle(at(0), at(1), at(2)).Smallest);
    m.FacetRadius = std::max(m.FacetRadius, Circumradius(at(0), at(1), at(2)));
  }
  m.Distance = HausdorffDistance(skin, surface);
  std::printf("%zu cells: radius-edge %.3f, volume %.3g, circumradius %.3f, dihedral %.2f; facets: "
              "angle %.2f, radius %.3f, distance %.4f\n",
    m.Cells, m.RadiusEdge, m.Volume, m.Circumradius, m.SmallestDihedral, m.FacetAngle,
    m.FacetRadius, m.Distance);
  return m;
}

TetrahedralParameters TetGen()
{
  TetrahedralParameters parameters;
  parameters.TetGen.PreserveSurface = false;
  parameters.TetGen.Limits = { 120.0, std::uint64_t{ 4 } << 30 };
  return parameters;
}

TetrahedralParameters CGAL()
{
  TetrahedralParameters parameters;
  parameters.Library = TetrahedralLibrary::CGAL;
  parameters.CGAL.FacetSize = 0.3;
  parameters.CGAL.FacetDistance = 0.1;
  parameters.CGAL.CellSize = 0.4;
  return parameters;
}

}

TEST(TetrahedralProperties, TetGenKeepsRatioVolumeAndDihedral)
{
  const TriangleMesh cube = Cube({ 0, 0, 0 }, 1.0);
  for (const double ratio : { 2.0, 1.4, 1.2 })
  {
    TetrahedralParameters parameters = TetGen();
    parameters.TetGen.RadiusEdgeRatio = ratio;
    parameters.TetGen.MaximumVolume = 0.002;
    const Measured m = Measure(MeshTetrahedra(cube, parameters), cube);
    EXPECT_LE(m.RadiusEdge, ratio + 1e-6);
    EXPECT_LE(m.Volume, 0.002 * (1.0 + 1e-9));
  }
  TetrahedralParameters parameters = TetGen();
  parameters.TetGen.MaximumVolume = 0.002;
  parameters.TetGen.MinimumDihedralAngle = 18.0;
  EXPECT_GE(Measure(MeshTetrahedra(cube, parameters), cube).SmallestDihedral, 18.0);
  parameters.TetGen.RadiusEdgeRatio = 0.0;
  parameters.TetGen.MaximumVolume = 0.0;
  EXPECT_LT(Measure(MeshTetrahedra(cube, parameters), cube).Cells, 20u);
}

TEST(TetrahedralProperties, CGALKeepsItsFiveCriteria)
{
  const TriangleMesh sphere = Sphere();
  const Measured base = Measure(MeshTetrahedra(sphere, CGAL()), sphere);
  EXPECT_GE(base.FacetAngle, 25.0);
  EXPECT_LE(base.FacetRadius, 0.3);
  EXPECT_LE(base.Distance, 0.1 * 1.05);

  TetrahedralParameters parameters = CGAL();
  parameters.CGAL.FacetAngle = 30.0;
  EXPECT_GE(Measure(MeshTetrahedra(sphere, parameters), sphere).FacetAngle, 30.0);

  parameters = CGAL();
  parameters.CGAL.FacetSize = 0.15;
  const Measured small = Measure(MeshTetrahedra(sphere, parameters), sphere);
  EXPECT_LE(small.FacetRadius, 0.15);

  parameters = CGAL();
  parameters.CGAL.FacetDistance = 0.01;
  const Measured near = Measure(MeshTetrahedra(sphere, parameters), sphere);
  EXPECT_LE(near.Distance, 0.015);
  EXPECT_LT(near.Distance, base.Distance);

  parameters = CGAL();
  parameters.CGAL.CellSize = 0.2;
  const Measured fine = Measure(MeshTetrahedra(sphere, parameters), sphere);
  EXPECT_LE(fine.Circumradius, 0.2 * 1.05); // exudation gives up some of it
  EXPECT_GT(fine.Cells, base.Cells);

  // Slivers apart, refinement ends at the requested ratio.
  for (const double ratio : { 2.0, 3.0 })
  {
    parameters = CGAL();
    parameters.CGAL.CellRadiusEdgeRatio = ratio;
    EXPECT_LE(Measure(MeshTetrahedra(sphere, parameters), sphere).RadiusEdge, ratio * 1.05);
  }
}

TEST(TetrahedralProperties, OptimisationRaisesTheSmallestAngles)
{
  const TriangleMesh sphere = Sphere();
  TetrahedralParameters parameters = CGAL();
  parameters.CGAL.CellSize = 0.25;
  parameters.CGAL.Exude = false;
  const double plain = Measure(MeshTetrahedra(sphere, parameters), sphere).SmallestDihedral;
  const auto with = [&](auto&& change)
  {
    TetrahedralParameters changed = parameters;
    change(changed.CGAL);
    const TetrahedralMesh mesh = MeshTetrahedra(sphere, changed);
    EXPECT_NEAR(ComputeVolumes(mesh).at(1) / SignedVolume(sphere), 1.0, 0.05);
    return Measure(mesh, sphere).SmallestDihedral;
  };
  EXPECT_GT(with([](CGALCriteria& c) { c.Exude = true; }), plain);
  EXPECT_GT(with([](CGALCriteria& c) { c.PerturbTimeLimit = 20.0; }), plain);
  EXPECT_GT(with(
              [](CGALCriteria& c)
              {
                c.LloydIterations = 5;
                c.PerturbTimeLimit = 20.0;
                c.Exude = true;
              }),
    plain);
  EXPECT_GT(with(
              [](CGALCriteria& c)
              {
                c.ODTIterations = 5;
                c.PerturbTimeLimit = 20.0;
                c.Exude = true;
              }),
    plain);
  parameters.CGAL.LloydIterations = -1;
  EXPECT_THROW(MeshTetrahedra(sphere, parameters), std::invalid_argument);
  parameters.CGAL.LloydIterations = 0;
  parameters.CGAL.PerturbTimeLimit = std::nan("");
  EXPECT_THROW(MeshTetrahedra(sphere, parameters), std::invalid_argument);
}
