// Closed shells that cross are refused with the place, by every filter that needs an inside; nested
// and touching ones are not.

#include "Core/PolyDataTriangles.h"
#include "MeshedSpheres.h"
#include "SurfaceFiles.h"
#include "Surfaces/HausdorffDistance.h"
#include "Surfaces/ShellCrossings.h"
#include "Surfaces/SurfaceCrossings.h"
#include "Surfaces/SurfaceMeasures.h"
#include "vtkSurfaceMeasures.h"
#include "vtkSurfaceToGrid.h"
#include "vtkTetrahedralMesher.h"

#include <vtkCommand.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// The place where two shells cross, or nothing.
std::optional<ShellCrossing> FindCrossing(const TriangleMesh& a, const TriangleMesh& b)
{
  TriangleMesh both = a;
  Append(both, b);
  return FindShellCrossing(both);
}

TriangleMesh Translate(TriangleMesh mesh, const Point3& by)
{
  for (Point3& p : mesh.Points)
  {
    p = p + by;
  }
  return mesh;
}

TriangleMesh InsideOut(TriangleMesh mesh)
{
  for (Triangle& t : mesh.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  return mesh;
}

/// Rotated about an axis that is not a grid direction.
TriangleMesh TurnedByOneRadian(TriangleMesh mesh)
{
  for (Point3& p : mesh.Points)
  {
    const double c = std::cos(1.0), s = std::sin(1.0);
    p = { c * p[0] - s * p[1], s * p[0] + c * p[1], p[2] };
    p = { p[0], c * p[1] - s * p[2], s * p[1] + c * p[2] };
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> ToPolyData(const SurfaceView& mesh)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  SetMesh(mesh, data);
  return data;
}

/// Two spheres of radius 7 whose centers are 10 apart.
vtkSmartPointer<vtkPolyData> CrossingSpheres()
{
  TriangleMesh both = Sphere({ 0.3, 0.2, 0.1 }, 7.0, 40);
  Append(both, Sphere({ 10.3, 0.2, 0.1 }, 7.0, 40));
  return ToPolyData(both);
}

}

TEST(ShellCrossings, RandomSpheresCrossAsTheirRadiiImply)
{
  std::mt19937 random(39);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  int crossings = 0;
  for (int trial = 0; trial < 150; ++trial)
  {
    const double r = 1.0 + part(random), s = 0.3 + part(random);
    const double distance = 1.3 * (r + s) * part(random);
    // Polyhedra in the spheres: 0.6 % of the radius is the largest deviation of their faces.
    const double gap = std::min(std::abs(distance - r - s), std::abs(distance - std::abs(r - s)));
    if (gap < 0.02)
    {
      continue;
    }
    const TriangleMesh a = Sphere({ 0.0, 0.0, 0.0 }, r, 32);
    TriangleMesh b = TurnedByOneRadian(Sphere({ 0.0, 0.0, 0.0 }, s, 32));
    b = Translate(trial % 2 ? b : InsideOut(b), { 0.6 * distance, 0.0, 0.8 * distance });
    const auto crossing = FindCrossing(a, b);
    const bool expected = distance < r + s && distance > std::abs(r - s);
    ASSERT_EQ(crossing.has_value(), expected) << trial << ": " << r << " " << s << " " << distance;
    if (crossing)
    {
      ++crossings;
      const Point3 center{ 0.6 * distance, 0.0, 0.8 * distance };
      EXPECT_NEAR(Length(crossing->Place), r, 0.02 * r);
      EXPECT_NEAR(Distance(crossing->Place, center), s, 0.02 * s);
      EXPECT_FALSE(crossing->Coincide);
    }
  }
  EXPECT_GT(crossings, 50);
}

TEST(ShellCrossings, BoxesWithCoplanarFacesAreDecidedByContainment)
{
  const TriangleMesh cube = Cube({ 0.0, 0.0, 0.0 }, 1.0);
  struct Case
  {
    const char* Name;
    Point3 Low;
    double Side;
    bool Crosses;
  };
  const Case cases[] = {
    { "beside, sharing a part of a face", { 1.0, 0.25, 0.3 }, 1.0, false },
    { "beside, touching along an edge", { 1.0, 1.0, 0.3 }, 1.0, false },
    { "beside, a corner on a face", { 1.0, 0.2, 0.2 }, 0.25, false },
    { "moved along x, four faces in planes of faces", { 0.5, 0.0, 0.0 }, 1.0, true },
    { "moved along x and y", { 0.5, 0.5, 0.0 }, 1.0, true },
    { "moved along all axes", { 0.5, 0.5, 0.5 }, 1.0, true },
    { "within, on the bottom", { 0.25, 0.25, 0.0 }, 0.5, false },
    { "within, touching nothing", { 0.25, 0.25, 0.25 }, 0.5, false },
    { "around", { -1.0, -1.0, -1.0 }, 3.0, false },
    { "through the bottom", { 0.25, 0.25, -0.25 }, 0.5, true },
    { "apart", { 3.0, 0.0, 0.0 }, 1.0, false },
  };
  for (const Case& c : cases)
  {
    const TriangleMesh other = Cube(c.Low, c.Side);
    EXPECT_EQ(FindCrossing(cube, other).has_value(), c.Crosses) << c.Name;
    EXPECT_EQ(FindCrossing(InsideOut(other), cube).has_value(), c.Crosses) << c.Name;
    EXPECT_EQ(
      FindCrossing(TurnedByOneRadian(cube), TurnedByOneRadian(other)).has_value(), c.Crosses)
      << c.Name << ", turned";
  }
}

TEST(ShellCrossings, TheSameShellTwiceIsFound)
{
  const TriangleMesh sphere = Sphere({ 0.1, 0.2, 0.3 }, 2.0);
  const auto twice = FindCrossing(sphere, sphere);
  ASSERT_TRUE(twice.has_value());
  EXPECT_TRUE(twice->Coincide);
  EXPECT_NE(twice->Message().find("coincide"), std::string::npos);
  const auto turned = FindCrossing(InsideOut(sphere), sphere);
  ASSERT_TRUE(turned.has_value());
  EXPECT_TRUE(turned->Coincide);
  // Cubes that share a face, and a two-sided sheet, are not crossing shells.
  EXPECT_FALSE(FindCrossing(Cube({ 0, 0, 0 }, 1.0), Cube({ 1.0, 0.0, 0.0 }, 1.0)).has_value());
  TriangleMesh sheet = sphere;
  sheet.Triangles.resize(sheet.Triangles.size() / 3);
  EXPECT_FALSE(FindCrossing(sheet, InsideOut(sheet)).has_value());
}

TEST(ShellCrossings, NestedAndOpenShellsAreSkipped)
{
  TriangleMesh nested = Sphere({ 0.0, 0.0, 0.0 }, 5.0);
  for (const double radius : { 4.0, 3.0, 2.0, 1.0 })
  {
    Append(nested,
      radius == 3.0 ? InsideOut(Sphere({ 0.0, 0.0, 0.0 }, radius))
                    : Sphere({ 0.0, 0.0, 0.0 }, radius));
  }
  EXPECT_FALSE(FindShellCrossing(nested).has_value());
  TriangleMesh open = Sphere({ 4.0, 0.0, 0.0 }, 5.0);
  open.Triangles.pop_back();
  EXPECT_FALSE(FindCrossing(Sphere({ 0.0, 0.0, 0.0 }, 5.0), open).has_value());
  EXPECT_FALSE(FindShellCrossing(TriangleMesh{}).has_value());
}

/// A cavity that touches the wall around it in a face, an edge, a corner or a point was added to
/// the volume by Surface Measures, and left out by Surface To Grid.
TEST(ShellCrossings, CavitiesThatTouchTheirWallCountAlike)
{
  struct Case
  {
    TriangleMesh Outer, Inner;
  };
  const TriangleMesh cube = Cube({ 0.0, 0.0, 0.0 }, 2.0);
  const TriangleMesh ball = Sphere({ 0.0, 0.0, 0.0 }, 2.0);
  TriangleMesh half = ball; // within the ball, and with one point of it
  for (Point3& p : half.Points)
  {
    p = 0.5 * (p + ball.Points[3]);
  }
  const Case cases[] = { { cube, Cube({ 0.0, 0.5, 0.5 }, 1.0) },
    { cube, Cube({ 0.0, 0.0, 0.5 }, 1.0) }, { cube, Cube({ 0.0, 0.0, 0.0 }, 1.0) },
    { cube, Sphere({ 1.0, 1.0, 0.5 }, 0.5) }, { ball, half } };
  for (const Case& c : cases)
  {
    const double expected = std::abs(MeasureSurface(c.Outer).Whole.Volume) -
      std::abs(MeasureSurface(c.Inner).Whole.Volume);
    for (const bool turned : { false, true })
    {
      TriangleMesh mesh = TurnedByOneRadian(c.Outer);
      Append(mesh, TurnedByOneRadian(turned ? InsideOut(c.Inner) : c.Inner));
      vtkNew<vtkSurfaceMeasures> measures;
      measures->SetInputData(ToPolyData(mesh));
      measures->Update();
      const double volume =
        measures->GetOutputDataObject(0)->GetFieldData()->GetArray("Volume")->GetComponent(0, 0);
      EXPECT_NEAR(volume, expected, 1e-9 * expected) << &c - cases << turned;
      const GridShape shape{ { 64, 64, 64 }, { 0.1, 0.1, 0.1 } };
      const auto inside = NodesInside(Translate(mesh, { 3.03, 3.01, 3.07 }), shape);
      const auto count = std::count(inside.begin(), inside.end(), 1);
      EXPECT_NEAR(0.001 * static_cast<double>(count), expected, 0.03 * expected) << &c - cases;
    }
  }
}

TEST(ShellCrossings, NestedShellsCountAlikeWhicheverWayTheyFace)
{
  // A solid with a cavity with a solid in it: each of them inverted once.
  const double radii[] = { 5.0, 3.5, 2.0 };
  double volumes[3];
  for (int k = 0; k < 3; ++k)
  {
    volumes[k] = std::abs(MeasureSurface(Sphere({ 0, 0, 0 }, radii[k])).Whole.Volume);
  }
  const double expected = volumes[0] - volumes[1] + volumes[2];
  for (int turned = 0; turned < 8; ++turned)
  {
    TriangleMesh mesh;
    for (int k = 0; k < 3; ++k)
    {
      const TriangleMesh sphere = Sphere({ 0.0, 0.0, 0.0 }, radii[k]);
      Append(mesh, turned >> k & 1 ? InsideOut(sphere) : sphere);
    }
    vtkNew<vtkSurfaceMeasures> measures;
    measures->SetInputData(ToPolyData(mesh));
    measures->Update();
    const double volume =
      measures->GetOutputDataObject(0)->GetFieldData()->GetArray("Volume")->GetComponent(0, 0);
    EXPECT_NEAR(std::abs(volume), expected, 1e-9 * expected) << turned;
    const GridShape shape{ { 60, 60, 60 }, { 0.2, 0.2, 0.2 } };
    const TriangleMesh placed = Translate(mesh, { 5.93, 5.91, 5.87 });
    const auto inside = NodesInside(placed, shape);
    const auto count = std::count(inside.begin(), inside.end(), 1);
    EXPECT_NEAR(0.008 * static_cast<double>(count), expected, 0.02 * expected) << turned;
  }
}

TEST(ShellCrossings, FiltersNameThePlaceInWorldCoordinates)
{
  // On the circle in which they cross, x is 5.3, the distance from the axis 4.9.
  const auto spheres = CrossingSpheres();
  const auto isThere = [](const std::string& said)
  {
    const std::size_t start = said.find("cross at (");
    if (start == std::string::npos)
    {
      return false;
    }
    double x = 0.0, y = 0.0, z = 0.0;
    std::sscanf(said.c_str() + start, "cross at (%lf, %lf, %lf)", &x, &y, &z);
    return std::abs(x - 5.3) < 0.1 && std::abs(std::hypot(y - 0.2, z - 0.1) - 4.9) < 0.15;
  };
  const auto errorOf = [](vtkAlgorithm* filter)
  {
    vtkNew<vtkTest::ErrorObserver> said;
    filter->AddObserver(vtkCommand::ErrorEvent, said);
    filter->Update();
    EXPECT_EQ(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), 0);
    return said->GetErrorMessage();
  };
  vtkNew<vtkSurfaceToGrid> grid;
  grid->SetInputData(spheres);
  grid->SetSpacing(1.0);
  const std::string ofGrid = errorOf(grid);
  EXPECT_TRUE(isThere(ofGrid)) << ofGrid;
  for (const int library : { 0, 1 })
  {
    vtkNew<vtkTetrahedralMesher> mesher;
    mesher->SetInputData(spheres);
    mesher->SetLibrary(library);
    const std::string ofMesher = errorOf(mesher);
    EXPECT_TRUE(isThere(ofMesher)) << library << ": " << ofMesher;
  }
  // Measures that do not depend on an inside are still computed.
  vtkNew<vtkSurfaceMeasures> measures;
  vtkNew<vtkTest::ErrorObserver> warned;
  measures->AddObserver(vtkCommand::WarningEvent, warned);
  measures->SetInputData(spheres);
  measures->Update();
  EXPECT_TRUE(isThere(warned->GetWarningMessage())) << warned->GetWarningMessage();
  vtkFieldData* fields = measures->GetOutputDataObject(0)->GetFieldData();
  EXPECT_TRUE(std::isnan(fields->GetArray("Volume")->GetComponent(0, 0)));
  EXPECT_NEAR(fields->GetArray("Area")->GetComponent(0, 0), 2.0 * 4.0 * Pi * 49.0, 12.0);
}

TEST(ShellCrossings, TheAdviceOfTheMessageWorks)
{
  const double r = 7.0, d = 10.0; // the lens that two balls share
  const double lens = Pi * (4.0 * r + d) * std::pow(2.0 * r - d, 2) / 12.0;
  TetrahedralParameters parameters = LimitedParameters();
  parameters.CGAL.CellSize = 0.7;
  const TriangleMesh united =
    BoundarySurface(AutomaticTetrahedra(ToTriangleMesh(CrossingSpheres()), parameters).Mesh);
  EXPECT_FALSE(FindShellCrossing(united).has_value());
  const double expected = 2.0 * 4.0 / 3.0 * Pi * r * r * r - lens;
  std::cout << "united " << MeasureSurface(united).Whole.Volume << ", two balls " << expected
            << "\n";
  EXPECT_NEAR(MeasureSurface(united).Whole.Volume / expected, 1.0, 0.02);
}
