#include "Bounds3.h"
#include "LevelTriangles.h"
#include "MapSurface.h"
#include "SensibleLevel.h"
#include "SurfaceCheck.h"
#include "SurfaceTopology.h"
#include "vtkMapSurface.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkShortArray.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace isthmus;

namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr double Nan = std::numeric_limits<double>::quiet_NaN();

struct Grid
{
  std::vector<double> Values;
  GridView<const double> View;
};

/// `f(x, y, z)` at the nodes, in the grid's own frame.
template <typename Function>
Grid Sampled(std::array<std::int64_t, 3> n, std::array<double, 3> h, Function&& f)
{
  Grid grid;
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i)
      {
        grid.Values.push_back(f(static_cast<double>(i) * h[0], static_cast<double>(j) * h[1],
          static_cast<double>(k) * h[2]));
      }
    }
  }
  grid.View = { grid.Values.data(), n, h };
  return grid;
}

double Ball(double x, double y, double z, const Point3& c, double r)
{
  return r - std::hypot(x - c[0], y - c[1], z - c[2]);
}

TriangleMesh At(const Grid& grid, double level, bool close = true, bool higher = true)
{
  LevelTrianglesParameters parameters;
  parameters.Level = level;
  parameters.CloseAtBorder = close;
  parameters.InsideIsHigher = higher;
  return LevelTriangles(grid.View, parameters);
}

std::string DefectsOf(const TriangleMesh& mesh)
{
  return FindDefects(mesh).Sentence();
}

vtkSmartPointer<vtkImageData> ImageOf(const Grid& grid)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const auto& n = grid.View.Dimensions;
  image->SetDimensions(static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2]));
  image->SetSpacing(grid.View.Spacing.data());
  vtkNew<vtkDoubleArray> values;
  values->SetName("Density");
  for (const double value : grid.Values)
  {
    values->InsertNextValue(value);
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// Two balls of radius 6 and 3, 100 inside of them and -1 outside, smooth in between.
Grid TwoBalls()
{
  return Sampled({ 40, 30, 30 }, { 1, 1, 1 },
    [](double x, double y, double z)
    {
      const double depth =
        std::max(Ball(x, y, z, { 12, 15, 15 }, 6), Ball(x, y, z, { 30, 15, 15 }, 3));
      return 49.5 + 50.5 * std::tanh(depth);
    });
}

double FieldOf(vtkPolyData* surface, const char* name)
{
  return surface->GetFieldData()->GetArray(name)->GetComponent(0, 0);
}

}

// The polyhedron is inscribed up to the curvature of the sphere within a cell: second order.
TEST(LevelTriangles, AreaAndVolumeOfABallConvergeWithOrderTwo)
{
  double last[2] = { 0, 0 };
  for (const int n : { 21, 41, 81 })
  {
    const double h = 4.0 / (n - 1);
    const Grid grid = Sampled({ n, n, n }, { h, h, h },
      [](double x, double y, double z) {
        return Ball(x, y, z, { 2.03, 1.98, 2.01 }, 1.4);
      });
    const TriangleMesh mesh = At(grid, 0.0);
    EXPECT_EQ(DefectsOf(mesh), "");
    EXPECT_EQ(EulerCharacteristic(mesh), 2);
    double area = 0.0;
    for (const Triangle& t : mesh.Triangles)
    {
      const auto at = [&](std::size_t c) { return mesh.Points[static_cast<std::size_t>(t[c])]; };
      const Point3 normal = Cross(at(1) - at(0), at(2) - at(0));
      area += std::sqrt(Dot(normal, normal)) / 2.0;
    }
    const double errors[2] = { std::abs(area / (4 * Pi * 1.96) - 1),
      std::abs(SignedVolume(mesh) / (4 * Pi * 2.744 / 3) - 1) };
    for (int i = 0; i < 2; ++i)
    {
      if (last[i] > 0.0)
      {
        EXPECT_GT(std::log2(last[i] / errors[i]), 1.8) << "n = " << n;
      }
      last[i] = errors[i];
    }
  }
}

// Signs at random meet all 256 cases in all neighbourhoods.
TEST(LevelTriangles, NoiseGivesAClosedManifoldThatFacesOutwards)
{
  std::mt19937 random(7);
  const Grid grid = Sampled({ 17, 16, 15 }, { 1, 2, 3 },
    [&](double, double, double) { return static_cast<double>(random() % 5) - 2.0; });
  for (const double level : { -1.5, 0.0, 0.3, 1.0 }) // 0 and 1 are values of nodes
  {
    const TriangleMesh mesh = At(grid, level);
    EXPECT_EQ(DefectsOf(mesh), "") << level;
    EXPECT_GT(SignedVolume(mesh), 0.0);
    EXPECT_EQ(DefectsOf(At(grid, level, true, false)), "") << level;
  }
}

TEST(LevelTriangles, ALevelThatLeavesTheGridIsClosedHalfACellBeyondIt)
{
  const Grid grid = Sampled({ 5, 4, 6 }, { 1, 2, 0.5 }, [](double, double, double) { return 3.0; });
  const TriangleMesh box = At(grid, 1.0);
  EXPECT_EQ(DefectsOf(box), "");
  EXPECT_EQ(EulerCharacteristic(box), 2);
  Bounds3 bounds{ box.Points[0], box.Points[0] };
  for (const Point3& p : box.Points)
  {
    bounds.Add(p);
  }
  EXPECT_EQ(bounds.Min, (Point3{ -0.5, -1, -0.25 }));
  EXPECT_EQ(bounds.Max, (Point3{ 4.5, 7, 2.75 }));
  EXPECT_TRUE(At(grid, 1.0, false).Triangles.empty());

  const Grid slope =
    Sampled({ 6, 6, 6 }, { 1, 1, 1 }, [](double x, double, double) { return x - 2.25; });
  const TriangleMesh open = At(slope, 0.0, false);
  EXPECT_EQ(open.Triangles.size(), 50U); // the plane x = 2.25 through 25 cells
  EXPECT_FALSE(FindDefects(open).BoundaryTriangles.empty());
  for (const Point3& p : open.Points)
  {
    EXPECT_DOUBLE_EQ(p[0], 2.25);
  }
}

TEST(LevelTriangles, WhatIsNoNumberIsOutside)
{
  Grid grid =
    Sampled({ 8, 8, 8 }, { 1, 1, 1 }, [](double x, double, double) { return x < 3.5 ? Nan : 1.0; });
  grid.Values[511] = std::numeric_limits<double>::infinity();
  grid.Values[255] = -1e300;
  const TriangleMesh mesh = At(grid, 0.5);
  EXPECT_EQ(DefectsOf(mesh), "");
  EXPECT_EQ(FindDefects(mesh).InvalidPoints.size(), 0U);
  EXPECT_THROW(At(grid, Nan), std::invalid_argument);
}

TEST(LevelTriangles, HugeValuesInterpolate)
{
  const Grid grid = Sampled(
    { 2, 2, 2 }, { 1, 1, 1 }, [](double x, double, double) { return x < 0.5 ? -1e308 : 1e308; });
  for (const Point3& p : At(grid, 0.0, false).Points)
  {
    EXPECT_DOUBLE_EQ(p[0], 0.5);
  }
}

TEST(LevelTriangles, SameBitsOnOneAndOnThreeThreads)
{
  std::mt19937 random(3);
  const Grid grid = Sampled({ 30, 31, 67 }, { 1, 1, 1 },
    [&](double, double, double) { return static_cast<double>(random() % 1000); });
  TriangleMesh meshes[2];
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false),
      [&]() { meshes[threads / 3] = At(grid, 700.5); });
  }
  EXPECT_EQ(meshes[0].Points, meshes[1].Points);
  EXPECT_EQ(meshes[0].Triangles, meshes[1].Triangles);
  EXPECT_FALSE(meshes[0].Triangles.empty());
}

TEST(SensibleLevel, SplitsTwoClassesWhateverTheHotVoxels)
{
  std::mt19937 random(1);
  std::normal_distribution<double> background(0.0, 1.0), molecule(20.0, 3.0);
  std::vector<double> values;
  for (int i = 0; i < 100000; ++i)
  {
    values.push_back(i % 20 == 0 ? molecule(random) : background(random));
  }
  values[17] = 1e12;
  values[4711] = -1e12;
  const double level = SensibleLevel(values);
  EXPECT_GT(level, 5.0);
  EXPECT_LT(level, 15.0);
}

TEST(SensibleLevel, StaysAboveABackgroundThatFillsTheBox)
{
  std::mt19937 random(1);
  std::normal_distribution<double> noise(5.0, 2.0);
  std::vector<double> values(200000);
  std::generate(values.begin(), values.end(), [&] { return noise(random); });
  const double level = SensibleLevel(values); // Otsu's is amid it, at 5
  EXPECT_GT(level, 5.0 + 2.0 * 2.0);
  EXPECT_LT(std::count_if(values.begin(), values.end(), [=](double v) { return v > level; }), 2100);
  EXPECT_GT(values.back(), level);
}

TEST(SensibleLevel, FewOrEqualValues)
{
  std::vector<double> none, same(10, 4.0), two{ 0.0, 9.0, 0.0, 9.0, 9.0 };
  EXPECT_THROW(SensibleLevel(none), std::invalid_argument);
  EXPECT_EQ(SensibleLevel(same), 4.0);
  EXPECT_EQ(SensibleLevel(two), 4.5);
}

TEST(HideDust, ByAreaShareAndNumber)
{
  const Grid grid = TwoBalls();
  const TriangleMesh mesh = At(grid, 50.0);
  const DustResult all = HideDust(mesh, {});
  ASSERT_EQ(all.Areas.size(), 2U);
  EXPECT_NEAR(all.Areas[0], 4 * Pi * 36, 10);
  EXPECT_NEAR(all.Areas[1], 4 * Pi * 9, 8); // its facets are a third of its radius
  EXPECT_EQ(all.Surface.Triangles, mesh.Triangles);
  for (const DustParameters& parameters :
    { DustParameters{ 200, 0, 0 }, DustParameters{ 0, 0.5, 0 }, DustParameters{ 0, 0, 1 } })
  {
    const DustResult one = HideDust(mesh, parameters);
    EXPECT_EQ(one.Found, 2);
    ASSERT_EQ(one.Areas.size(), 1U);
    EXPECT_EQ(one.Areas[0], all.Areas[0]);
    EXPECT_EQ(DefectsOf(one.Surface), "");
    EXPECT_EQ(EulerCharacteristic(one.Surface), 2);
    EXPECT_EQ(one.Components.size(), one.Surface.Triangles.size());
  }
  EXPECT_TRUE(HideDust(mesh, { 1e6, 0, 0 }).Surface.Triangles.empty());
  EXPECT_THROW(HideDust(mesh, { -1, 0, 0 }), std::invalid_argument);
  EXPECT_THROW(HideDust(mesh, { Nan, 0, 0 }), std::invalid_argument);
  EXPECT_THROW(HideDust(mesh, { 0, 1.5, 0 }), std::invalid_argument);
  EXPECT_THROW(HideDust(mesh, { 0, 0, -1 }), std::invalid_argument);
}

TEST(VTKMapSurface, AutomaticLevelNormalsComponentsAndFieldData)
{
  const auto image = ImageOf(TwoBalls());
  vtkNew<vtkMapSurface> filter;
  filter->SetInputData(image);
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  EXPECT_GT(filter->GetUsedLevel(), 10.0);
  EXPECT_LT(filter->GetUsedLevel(), 90.0);
  EXPECT_EQ(FieldOf(surface, "Level"), filter->GetUsedLevel());
  EXPECT_EQ(FieldOf(surface, "ComponentsFound"), 2.0);
  auto* component = vtkIdTypeArray::SafeDownCast(surface->GetCellData()->GetArray("Component"));
  ASSERT_NE(component, nullptr);
  EXPECT_EQ(component->GetRange()[1], 1.0);
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    double point[3], normal[3];
    surface->GetPoint(p, point);
    normals->GetTuple(p, normal);
    const double c = point[0] < 22 ? 12.0 : 30.0;
    const double length = std::hypot(point[0] - c, point[1] - 15, point[2] - 15);
    const double along =
      (normal[0] * (point[0] - c) + normal[1] * (point[1] - 15) + normal[2] * (point[2] - 15)) /
      length;
    EXPECT_GT(along, 0.9); // outwards
  }

  filter->SetLevel(70.0);
  EXPECT_FALSE(filter->GetAutomaticLevel());
  filter->SetLargestComponents(1);
  filter->Update();
  EXPECT_EQ(FieldOf(surface, "Level"), 70.0);
  EXPECT_EQ(surface->GetFieldData()->GetArray("ComponentArea")->GetNumberOfTuples(), 1);
}

TEST(VTKMapSurface, TakesTheRecommendedLevel)
{
  const auto image = ImageOf(TwoBalls());
  vtkNew<vtkDoubleArray> level;
  level->SetName("RecommendedLevel");
  level->InsertNextValue(33.25);
  image->GetFieldData()->AddArray(level);
  vtkNew<vtkMapSurface> filter;
  filter->SetInputData(image);
  filter->Update();
  EXPECT_EQ(filter->GetUsedLevel(), 33.25);
  filter->SetLevel(44.0);
  filter->Update();
  EXPECT_EQ(filter->GetUsedLevel(), 44.0);
}

TEST(VTKMapSurface, IntegersExtentDirectionAndNewValues)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(5, 14, -3, 6, 2, 11);
  image->SetSpacing(2, 2, 2);
  image->SetOrigin(100, 0, 0);
  const double mirrored[9] = { 0, 1, 0, 1, 0, 0, 0, 0, 1 }; // x and y swapped: a mirror
  image->SetDirectionMatrix(mirrored);
  vtkNew<vtkShortArray> values;
  values->SetName("Labels");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    int at[3] = { static_cast<int>(i % 10), static_cast<int>(i / 10 % 10),
      static_cast<int>(i / 100) };
    values->InsertNextValue(at[0] == 4 && at[1] == 5 && at[2] == 6 ? 100 : 0);
  }
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkMapSurface> filter;
  filter->SetInputData(image);
  filter->SetLevel(50.0);
  filter->Update();
  double centre[3], node[3];
  filter->GetOutput()->GetCenter(centre);
  image->TransformIndexToPhysicalPoint(9, 2, 8, node);
  for (int a = 0; a < 3; ++a)
  {
    EXPECT_NEAR(centre[a], node[a], 1e-12);
  }
  // An octahedron of half diagonal 1 has volume 4/3, positive where it faces outwards.
  TriangleMesh mesh;
  for (vtkIdType p = 0; p < filter->GetOutput()->GetNumberOfPoints(); ++p)
  {
    Point3 point;
    filter->GetOutput()->GetPoint(p, point.data());
    mesh.Points.push_back(point);
  }
  for (vtkIdType c = 0; c < filter->GetOutput()->GetNumberOfCells(); ++c)
  {
    vtkIdType count;
    const vtkIdType* ids;
    filter->GetOutput()->GetCellPoints(c, count, ids);
    mesh.Triangles.push_back({ ids[0], ids[1], ids[2] });
  }
  EXPECT_NEAR(SignedVolume(mesh), 4.0 / 3.0, 1e-9);

  filter->SetAutomaticLevel(true);
  filter->Update();
  const double before = filter->GetUsedLevel();
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    values->SetValue(i, static_cast<short>(i % 2 == 0 ? 1000 : 2000));
  }
  values->Modified();
  image->Modified();
  filter->Update();
  EXPECT_LT(before, 1000.0);
  EXPECT_EQ(filter->GetUsedLevel(), 1500.0); // the level that was kept is not that of other values
}

TEST(VTKMapSurface, DelaunayQualityIsClosedToo)
{
  const auto image = ImageOf(TwoBalls());
  vtkNew<vtkMapSurface> filter;
  filter->SetInputData(image);
  filter->SetQuality(vtkMapSurface::Delaunay);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("ComponentArea")->GetNumberOfTuples(), 2);
}

TEST(VTKMapSurface, RefusesWithASentenceAndAnEmptyOutput)
{
  const auto image = ImageOf(TwoBalls());
  const auto refused = [&](auto&& set, const char* sentence)
  {
    vtkNew<vtkMapSurface> filter;
    vtkNew<vtkTest::ErrorObserver> observer;
    filter->AddObserver(vtkCommand::ErrorEvent, observer);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
    filter->SetInputData(image);
    set(filter.Get());
    filter->Update();
    EXPECT_TRUE(observer->GetError());
    EXPECT_NE(observer->GetErrorMessage().find(sentence), std::string::npos)
      << observer->GetErrorMessage();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  };
  refused([](auto* f) { f->SetLevel(Nan); }, "Level must be");
  refused([](auto* f) { f->SetMinimumComponentArea(-1); }, "MinimumComponentArea");
  refused([](auto* f) { f->SetMinimumComponentShare(Nan); }, "MinimumComponentShare");
  refused([](auto* f) { f->SetLargestComponents(-2); }, "LargestComponents");
  refused([](auto* f) { f->SetQuality(2); }, "Quality");
  refused(
    [](auto* f)
    {
      f->SetQuality(vtkMapSurface::Delaunay);
      f->SetCloseAtBorder(false);
    },
    "CloseAtBorder");
}

TEST(VTKMapSurface, EmptyInputAndNothingInside)
{
  vtkNew<vtkMapSurface> filter;
  vtkNew<vtkImageData> nothing;
  filter->SetInputData(nothing);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);

  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->SetInputData(ImageOf(TwoBalls()));
  filter->SetLevel(1e30);
  filter->Update();
  EXPECT_NE(observer->GetWarningMessage().find("Nothing is inside"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}
