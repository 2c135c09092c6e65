// Offsets against closed formulas, their sides, and what happens to bad input.

#include "ChokingLoops/OffsetSurface.h"
#include "ChokingSurfaces.h"
#include "Core/PolyDataTriangles.h"
#include "Surfaces/SurfaceTopology.h"
#include "vtkOffsetSurface.h"

#include <vtkCallbackCommand.h>
#include <vtkExecutive.h>
#include <vtkPointData.h>
#include <vtkPolyDataConnectivityFilter.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// The cube [-1, 1]^3.
TriangleMesh Cube()
{
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
  {
    mesh.Points.push_back({ i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0 });
  }
  mesh.Triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  return mesh;
}

/// Distance to that cube's surface, from its formula.
double ToCube(const double* p)
{
  double outside = 0.0;
  double deepest = -HUGE_VAL;
  for (int a = 0; a < 3; ++a)
  {
    const double beyond = std::abs(p[a]) - 1.0;
    outside += std::max(beyond, 0.0) * std::max(beyond, 0.0);
    deepest = std::max(deepest, beyond);
  }
  return deepest > 0.0 ? std::sqrt(outside) : -deepest;
}

class Offset
{
public:
  explicit Offset(const TriangleMesh& mesh, double distance, int side = vtkOffsetSurface::Both,
    int resolution = 40)
  {
    vtkNew<vtkPolyData> surface;
    SetMesh(mesh, surface);
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    this->Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Pipeline);
    this->Filter->SetInputData(surface);
    this->Filter->SetDistance(distance);
    this->Filter->SetSide(side);
    this->Filter->SetResolution(resolution);
    this->Filter->Update();
  }

  vtkPolyData* Result() { return this->Filter->GetOutput(); }
  std::string Error() const { return this->Observer->GetErrorMessage(); }
  double Spacing() { return this->Result()->GetFieldData()->GetArray("GridSpacing")->GetTuple1(0); }

  /// Largest difference between `exact` at the result's points and the requested distance.
  template <typename Exact>
  double WorstError(const Exact& exact)
  {
    double worst = 0.0;
    for (vtkIdType i = 0; i < this->Result()->GetNumberOfPoints(); ++i)
    {
      double p[3];
      this->Result()->GetPoint(i, p);
      worst = std::max(worst, std::abs(exact(p) - this->Filter->GetDistance()));
    }
    return worst;
  }

private:
  vtkNew<vtkOffsetSurface> Filter;
  vtkNew<vtkTest::ErrorObserver> Observer, Pipeline;
};

// Linear interpolation of a distance d with curvature 1 / d is wrong by h^2 / (8 d) along an axis,
// times three for a diagonal of a cell.
TEST(OffsetSurface, OfACubeIsExactToTheOrderOfTheGrid)
{
  double before = HUGE_VAL;
  for (const int resolution : { 30, 60, 120 })
  {
    Offset offset(Cube(), 0.5, vtkOffsetSurface::Outside, resolution);
    const double h = offset.Spacing();
    const double error = offset.WorstError(ToCube);
    EXPECT_GT(offset.Result()->GetNumberOfCells(), 1000);
    EXPECT_LE(error, 3.0 * h * h / (8.0 * 0.5)) << resolution;
    EXPECT_LT(error, before / 3.0) << "not of second order at " << resolution;
    before = error;
  }
}

TEST(OffsetSurface, OfASphereIsASphere)
{
  const TriangleMesh sphere =
    Revolution([](double z) { return std::sqrt(std::max(0.0, 1.0 - z * z)); }, -1.0, 1.0, 200, 100);
  for (const auto& [side, radius] : { std::make_pair(vtkOffsetSurface::Inside, 0.7),
         std::make_pair(vtkOffsetSurface::Outside, 1.3) })
  {
    Offset offset(sphere, 0.3, side, 50);
    const double h = offset.Spacing();
    const double flat = 1.0 - std::cos(M_PI / 100.0); // the mesh is inside the sphere by this
    ASSERT_GT(offset.Result()->GetNumberOfPoints(), 1000);
    const double error = offset.WorstError(
      [radius = radius](const double* p) { return 0.3 + std::hypot(p[0], p[1], p[2]) - radius; });
    EXPECT_LE(error, 3.0 * h * h / (8.0 * 0.7) + flat);
  }
}

TEST(OffsetSurface, BothSidesAreInsideAndOutside)
{
  const auto pieces = [](vtkPolyData* surface)
  {
    vtkNew<vtkPolyDataConnectivityFilter> filter;
    filter->SetInputData(surface);
    filter->SetExtractionModeToAllRegions();
    filter->Update();
    return filter->GetNumberOfExtractedRegions();
  };
  const TriangleMesh torus = Torus(1.0, 0.4, 60, 30);
  Offset inside(torus, 0.2, vtkOffsetSurface::Inside);
  Offset outside(torus, 0.2, vtkOffsetSurface::Outside);
  Offset both(torus, 0.2);
  EXPECT_EQ(pieces(inside.Result()), 1);
  EXPECT_EQ(pieces(outside.Result()), 1);
  EXPECT_EQ(pieces(both.Result()), 2);

  // Two sides that are less than the grid apart, at any scale; one side needs no room.
  for (const double scale : { 1.0, 1e-9, 1e9 })
  {
    TriangleMesh scaled = torus;
    for (Point3& p : scaled.Points)
    {
      p = scale * p;
    }
    Offset close(scaled, 0.01 * scale);
    EXPECT_EQ(close.Result()->GetNumberOfPoints(), 0);
    EXPECT_NE(close.Error().find("times the grid spacing"), std::string::npos) << close.Error();
    EXPECT_EQ(pieces(Offset(scaled, 0.01 * scale, vtkOffsetSurface::Inside).Result()), 1);
    EXPECT_EQ(pieces(Offset(scaled, 1.1 * both.Spacing() * scale).Result()), 2);
  }
  EXPECT_EQ(both.Result()->GetNumberOfCells(),
    inside.Result()->GetNumberOfCells() + outside.Result()->GetNumberOfCells());
  // Nothing is left inside when the tube is choked, which is not an error.
  Offset choked(torus, 0.45, vtkOffsetSurface::Inside);
  EXPECT_EQ(choked.Result()->GetNumberOfCells(), 0);
  EXPECT_EQ(choked.Error(), "");
}

// Outward from the enclosed region, so that its volume is positive, and normals likewise.
TEST(OffsetSurface, FacesOutward)
{
  const TriangleMesh sphere =
    Revolution([](double z) { return std::sqrt(std::max(0.0, 1.0 - z * z)); }, -1.0, 1.0, 100, 50);
  const auto ball = [](double radius) { return 4.0 / 3.0 * M_PI * radius * radius * radius; };
  for (const auto& [side, volume] : { std::make_pair(vtkOffsetSurface::Inside, ball(0.7)),
         std::make_pair(vtkOffsetSurface::Outside, ball(1.3)),
         std::make_pair(vtkOffsetSurface::Both, ball(1.3) - ball(0.7)) })
  {
    Offset offset(sphere, 0.3, side, 50);
    vtkPolyData* surface = offset.Result();
    const PolyDataTriangles triangles(surface);
    EXPECT_NEAR(SignedVolume(triangles.View()), volume, 0.02 * volume) << side;
    vtkDataArray* normals = surface->GetPointData()->GetNormals();
    ASSERT_NE(normals, nullptr);
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const double* p = surface->GetPoint(i);
      const double* n = normals->GetTuple3(i);
      const double outward = p[0] * n[0] + p[1] * n[1] + p[2] * n[2];
      const bool isInner = side == vtkOffsetSurface::Both && std::hypot(p[0], p[1], p[2]) < 1.0;
      ASSERT_EQ(outward > 0.0, !isInner);
    }
  }
}

// The same number computed independently, by a tree search for the nearest point.
TEST(OffsetSurface, DistancesToPointsAgreeWithTheFormula)
{
  std::vector<Point3> points;
  for (int i = 0; i < 2000; ++i)
  {
    points.push_back({ 2.0 * std::sin(1.0 * i), 2.0 * std::sin(1.7 * i), 2.0 * std::sin(2.9 * i) });
  }
  const std::vector<double> distance = SurfaceDistances(Cube(), points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_NEAR(distance[i], ToCube(points[i].data()), 1e-14);
  }
}

TEST(OffsetSurface, ReportsInvalidInput)
{
  TriangleMesh open = Cube();
  open.Triangles.pop_back();
  EXPECT_NE(Offset(open, 0.3, vtkOffsetSurface::Inside).Error(), "");
  EXPECT_EQ(Offset(open, 0.3).Error(), "");
  EXPECT_NE(Offset(Cube(), 0.0).Error().find("above 0"), std::string::npos);
  EXPECT_NE(Offset(Cube(), NAN).Error().find("above 0"), std::string::npos);
  TriangleMesh invalid = Cube();
  invalid.Points[5][1] = NAN;
  EXPECT_NE(Offset(invalid, 0.3).Error().find("not a finite"), std::string::npos);
  TriangleMesh bare = Cube();
  bare.Triangles.clear();
  EXPECT_NE(Offset(bare, 0.3).Error().find("no triangles"), std::string::npos);
  EXPECT_EQ(Offset(bare, 0.3).Result()->GetNumberOfCells(), 0);
  EXPECT_EQ(Offset({}, 0.3).Error(), "");
}

TEST(OffsetSurface, ValuesOutOfRangeAreKeptAndRefusedWhenItRuns)
{
  vtkNew<vtkOffsetSurface> filter;
  filter->SetResolution(4);
  EXPECT_EQ(filter->GetResolution(), 4);
  EXPECT_NE(Offset(Cube(), 0.3, vtkOffsetSurface::Both, 4)
              .Error()
              .find("Resolution is 4, but it must be from 8 to 1024."),
    std::string::npos);
  EXPECT_NE(Offset(Cube(), 0.3, 3).Error().find("Side is 3, but it must be from 0 to 2."),
    std::string::npos);
}

TEST(OffsetSurface, SidesOfShellsThatCrossAreRefusedWithThePlace)
{
  for (const double unit : { 1.0, 1e9 })
  {
    TriangleMesh both = Cube();
    for (const Point3& p : Cube().Points)
    {
      both.Points.push_back({ p[0] + 1.5, p[1] + 0.2, p[2] + 0.3 });
    }
    for (const Triangle& t : Cube().Triangles)
    {
      both.Triangles.push_back({ t[0] + 8, t[1] + 8, t[2] + 8 });
    }
    for (Point3& p : both.Points)
    {
      p = unit * p;
    }
    for (const int side : { vtkOffsetSurface::Inside, vtkOffsetSurface::Outside })
    {
      Offset offset(both, 0.2 * unit, side);
      const std::string said = offset.Error();
      double p[3] = { 0.0, 0.0, 0.0 };
      const std::size_t start = std::min(said.find("cross at ("), said.size());
      ASSERT_EQ(std::sscanf(said.c_str() + start, "cross at (%lf, %lf, %lf)", p, p + 1, p + 2), 3)
        << said;
      const double scaled[] = { p[0] / unit, p[1] / unit, p[2] / unit };
      EXPECT_NEAR(ToCube(scaled), 0.0, 1e-3) << said;
      EXPECT_EQ(offset.Result()->GetNumberOfCells(), 0);
    }
    EXPECT_EQ(Offset(both, 0.2 * unit).Error(), ""); // the distance from both has no inside
  }
}

TEST(OffsetSurface, StopsOnRequestAtAnyTime)
{
  const TriangleMesh torus = Torus(1.0, 0.4, 60, 30);
  double last = 0.0;
  int calls = 0;
  OffsetDistances(torus, { 0.2, SideSelection::Inside, 60 },
    [&](double fraction)
    {
      EXPECT_GE(fraction, last);
      last = fraction;
      ++calls;
      return true;
    });
  EXPECT_EQ(last, 1.0);
  ASSERT_GT(calls, 5);
  // By the fraction, since the number of reports depends on the time.
  for (int stop = 0; stop <= 20; ++stop)
  {
    EXPECT_THROW(OffsetDistances(torus, { 0.2, SideSelection::Inside, 60 },
                   [stop](double fraction) { return fraction < 0.05 * stop; }),
      Cancelled);
  }
}

}
