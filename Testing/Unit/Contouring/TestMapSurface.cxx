// Automatic levels of a map, hiding of dust, and the vtk class.

#include "Contouring/LevelEstimate.h"
#include "Contouring/MapSurface.h"
#include "Core/Geometry.h"
#include "SampledGrid.h"
#include "SharedData.h"
#include "Surfaces/SurfaceTopology.h"
#include "vtkDelaunayIsosurface.h"
#include "vtkDualContouring.h"
#include "vtkMRCMapReader.h"
#include "vtkMapSurface.h"

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkShortArray.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVariant.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr double Nan = std::numeric_limits<double>::quiet_NaN();

vtkSmartPointer<vtkImageData> MakeImage(const Grid& grid)
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

double SampleField(vtkDataObject* surface, const char* name)
{
  return surface->GetFieldData()->GetArray(name)->GetComponent(0, 0);
}

std::string MakeSource(vtkDataObject* output, const char* name = "LevelSource")
{
  return output->GetFieldData()->GetAbstractArray(name)->GetVariantValue(0).ToString();
}

}

TEST(EstimateLevel, SplitsTwoClassesDespiteOutliers)
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
  const double level = EstimateLevel(values);
  EXPECT_GT(level, 5.0);
  EXPECT_LT(level, 15.0);
}

TEST(EstimateLevel, StaysAboveABackgroundThatFillsTheBox)
{
  std::mt19937 random(1);
  std::normal_distribution<double> noise(5.0, 2.0);
  std::vector<double> values(200000);
  std::generate(values.begin(), values.end(), [&] { return noise(random); });
  const double level = EstimateLevel(values); // Otsu's level is inside it, at 5
  EXPECT_GT(level, 5.0 + 2.0 * 2.0);
  EXPECT_LT(std::count_if(values.begin(), values.end(), [=](double v) { return v > level; }), 2100);
  EXPECT_GT(values.back(), level);
}

TEST(EstimateLevel, FewOrEqualValues)
{
  std::vector<double> none, same(10, 4.0), two{ 0.0, 9.0, 0.0, 9.0, 9.0 };
  EXPECT_THROW(EstimateLevel(none), std::invalid_argument);
  EXPECT_EQ(EstimateLevel(same), 4.0);
  EXPECT_EQ(EstimateLevel(two), 4.5);
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
    EXPECT_EQ(DescribeDefects(one.Surface), "");
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
  const auto image = MakeImage(TwoBalls());
  vtkNew<vtkMapSurface> filter;
  filter->SetInputData(image);
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  EXPECT_GT(SampleField(surface, "Level"), 10.0);
  EXPECT_LT(SampleField(surface, "Level"), 90.0);
  EXPECT_EQ(SampleField(surface, "Level"), SampleField(surface, "Level"));
  EXPECT_EQ(SampleField(surface, "ComponentsFound"), 2.0);
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
  EXPECT_EQ(SampleField(surface, "Level"), 70.0);
  EXPECT_EQ(surface->GetFieldData()->GetArray("ComponentArea")->GetNumberOfTuples(), 1);
}

TEST(VTKMapSurface, TakesTheRecommendedLevel)
{
  const auto image = MakeImage(TwoBalls());
  vtkNew<vtkDoubleArray> level;
  level->SetName("RecommendedLevel");
  level->InsertNextValue(33.25);
  image->GetFieldData()->AddArray(level);
  vtkNew<vtkMapSurface> filter;
  filter->SetInputData(image);
  filter->Update();
  EXPECT_EQ(SampleField(filter->GetOutput(), "Level"), 33.25);
  EXPECT_EQ(MakeSource(filter->GetOutput()), "recommended by the depositors");
  filter->SetLevel(44.0);
  filter->Update();
  EXPECT_EQ(SampleField(filter->GetOutput(), "Level"), 44.0);
  EXPECT_EQ(MakeSource(filter->GetOutput()), "given");
}

TEST(VTKMapSurface, StatesTheAutomaticLevelBesideAGivenOne)
{
  const auto image = MakeImage(TwoBalls());
  vtkNew<vtkMapSurface> filter;
  filter->SetInputData(image);
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  const double estimated = SampleField(surface, "Level");
  EXPECT_EQ(SampleField(surface, "AutomaticLevel"), estimated);
  EXPECT_EQ(MakeSource(surface, "AutomaticLevelSource"), "estimated from the values");
  filter->SetLevel(70.0);
  filter->Update();
  EXPECT_EQ(SampleField(surface, "Level"), 70.0);
  EXPECT_EQ(SampleField(surface, "AutomaticLevel"), estimated);
  EXPECT_EQ(MakeSource(surface, "AutomaticLevelSource"), "estimated from the values");

  vtkNew<vtkDoubleArray> level;
  level->SetName("RecommendedLevel");
  level->InsertNextValue(33.25);
  image->GetFieldData()->AddArray(level);
  image->Modified();
  filter->Update();
  EXPECT_EQ(SampleField(surface, "Level"), 70.0);
  EXPECT_EQ(SampleField(surface, "AutomaticLevel"), 33.25);
  EXPECT_EQ(MakeSource(surface, "AutomaticLevelSource"), "recommended by the depositors");
}

/// Each filter that contours a volume has the level of Map Surface (of Isosurface Stuffing:
/// TestStuffedMaps.cxx).
template <typename Filter>
void ExpectLevel(vtkImageData* image, double level, const std::string& source)
{
  vtkNew<Filter> filter;
  filter->SetInputData(image);
  filter->InsideIsHigherOff();
  filter->Update();
  EXPECT_EQ(SampleField(filter->GetOutput(), "Level"), level);
  EXPECT_EQ(MakeSource(filter->GetOutput()), source);
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(AutomaticLevel, OfASignedDistanceIsZeroInAllFilters)
{
  const auto image = MakeImage(TwoBalls());
  vtkDataArray* values = image->GetPointData()->GetScalars();
  vtkNew<vtkMapSurface> estimate;
  estimate->SetInputData(image);
  estimate->InsideIsHigherOff();
  estimate->Update();
  const double estimated = SampleField(estimate->GetOutput(), "Level");
  EXPECT_NE(estimated, 0.0);
  ExpectLevel<vtkDualContouring>(image, estimated, "estimated from the values");
  ExpectLevel<vtkDelaunayIsosurface>(image, estimated, "estimated from the values");
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetComponent(i, 0, 20.0 - values->GetComponent(i, 0));
  }
  values->SetName("SignedDistance");
  const std::string natural = "zero of a signed distance";
  ExpectLevel<vtkMapSurface>(image, 0.0, natural);
  ExpectLevel<vtkDualContouring>(image, 0.0, natural);
  ExpectLevel<vtkDelaunayIsosurface>(image, 0.0, natural);
}

namespace
{

/// The level that is chosen for `value` at the nodes of [-3, 3]^3, under a name that says nothing.
std::pair<double, std::string> LevelOf(const std::function<double(const Point3&)>& value,
  const Point3& spacing, const char* name = "Values")
{
  vtkNew<vtkImageData> image;
  image->SetOrigin(-3.0, -3.0, -3.0);
  image->SetSpacing(spacing.data());
  image->SetDimensions(static_cast<int>(6.0 / spacing[0]) + 1,
    static_cast<int>(6.0 / spacing[1]) + 1, static_cast<int>(6.0 / spacing[2]) + 1);
  vtkNew<vtkFloatArray> values;
  values->SetName(name);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    Point3 x;
    image->GetPoint(i, x.data());
    values->InsertNextValue(static_cast<float>(value(x)));
  }
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkMapSurface> filter;
  filter->SetInputData(image);
  filter->Update();
  return { SampleField(filter->GetOutput(), "Level"), MakeSource(filter->GetOutput()) };
}

}

TEST(AutomaticLevel, SignedDistancesAreKnownByTheirValues)
{
  const std::pair<double, std::string> zero{ 0.0, "zero of a signed distance" };
  const Point3 even{ 0.2, 0.2, 0.2 }, uneven{ 0.15, 0.2, 0.3 };
  const auto sphere = [](const Point3& x) { return Length(x - Point3{ 0.1, 0.2, 0.3 }) - 1.7; };
  const auto torus = [](const Point3& x)
  { return std::hypot(std::hypot(x[0], x[1]) - 1.6, x[2]) - 0.7; };
  const auto pair = [](const Point3& x) {
    return std::min(Length(x - Point3{ 1, 0, 0 }), Length(x + Point3{ 1.2, 0, 0 })) - 0.9;
  };
  for (const std::function<double(const Point3&)>& distance :
    std::vector<std::function<double(const Point3&)>>{ sphere, torus, pair })
  {
    for (const Point3& spacing : { even, uneven })
    {
      EXPECT_EQ(LevelOf(distance, spacing), zero);
      EXPECT_EQ(LevelOf([&](const Point3& x) { return -distance(x); }, spacing), zero);
      EXPECT_EQ(
        LevelOf([&](const Point3& x) { return std::clamp(distance(x), -0.7, 0.7); }, spacing),
        zero);
    }
    EXPECT_EQ(LevelOf([&](const Point3& x) { return distance(x) / 0.2; }, even), zero)
      << "in spacings";
  }
}

TEST(AutomaticLevel, DensitiesAreNotTakenForSignedDistances)
{
  const std::string estimated = "estimated from the values";
  const Point3 even{ 0.2, 0.2, 0.2 };
  const auto blob = [](const Point3& x) { return std::exp(-Dot(x, x)); };
  for (const double height : { 1.0, 2.33, 10.0, 50.0 }) // 2.33: a slope of 1 at most
  {
    EXPECT_EQ(
      LevelOf([&](const Point3& x) { return height * (blob(x) - 0.2); }, even).second, estimated);
  }
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, 0.14); // slopes of about 1 at a spacing of 0.2
  EXPECT_EQ(LevelOf([&](const Point3& x) { return 2.0 * blob(x) + normal(random); }, even).second,
    estimated);
  const auto potential = [](const Point3& x) {
    return 1.0 / (0.3 + Length(x - Point3{ 1, 0, 0 })) - 1.0 / (0.3 + Length(x));
  };
  EXPECT_EQ(LevelOf(potential, even).second, estimated);
  const auto unsignedDistance = [](const Point3& x) { return Length(x); };
  EXPECT_EQ(LevelOf(unsignedDistance, even).second, estimated);
  for (const char* name : { "S", "Inside", "Side" })
  {
    EXPECT_EQ(LevelOf([&](const Point3& x) { return 9.0 * blob(x); }, even, name).second, estimated)
      << name << " with values above 1";
    EXPECT_EQ(LevelOf(blob, even, name).first, 0.5);
  }
  EXPECT_EQ(LevelOf(blob, even, "SignedDistance").second, estimated) << "without values below 0";
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
  double center[3], node[3];
  filter->GetOutput()->GetCenter(center);
  image->TransformIndexToPhysicalPoint(9, 2, 8, node);
  for (int a = 0; a < 3; ++a)
  {
    EXPECT_NEAR(center[a], node[a], 1e-12);
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
  const double before = SampleField(filter->GetOutput(), "Level");
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    values->SetValue(i, static_cast<short>(i % 2 == 0 ? 1000 : 2000));
  }
  values->Modified();
  image->Modified();
  filter->Update();
  EXPECT_LT(before, 1000.0);
  EXPECT_EQ(SampleField(filter->GetOutput(), "Level"), 1500.0);
}

TEST(VTKMapSurface, DelaunayQualityIsClosed)
{
  const auto image = MakeImage(TwoBalls());
  vtkNew<vtkMapSurface> filter;
  filter->SetInputData(image);
  filter->SetQuality(vtkMapSurface::Delaunay);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("ComponentArea")->GetNumberOfTuples(), 2);
}

TEST(VTKMapSurface, ReportsErrorsWithAnEmptyOutput)
{
  const auto image = MakeImage(TwoBalls());
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
  refused([](auto* f) { f->SetLevel(Nan); }, "Level is not a number");
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

// A distance that grows outwards is lower inside; a volume may also lie inside its level as a
// whole.
TEST(VTKMapSurface, SpaceAroundAnObjectIsWarnedAbout)
{
  const int n = 17;
  vtkNew<vtkImageData> image;
  image->SetDimensions(n, n, n);
  vtkNew<vtkDoubleArray> distance;
  distance->SetName("SignedDistance");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    distance->InsertNextValue(std::hypot(p[0] - 8.0, p[1] - 8.0, p[2] - 8.0) - 5.0);
  }
  image->GetPointData()->SetScalars(distance);
  for (const auto& [level, higher, isWarned] :
    { std::tuple(0.0, true, true), std::tuple(0.0, false, false), std::tuple(-99.0, true, true),
      std::tuple(6.0, true, false) }) // the corners of the volume
  {
    vtkNew<vtkTest::ErrorObserver> observer;
    vtkNew<vtkMapSurface> filter;
    filter->AddObserver(vtkCommand::WarningEvent, observer);
    filter->SetInputData(image);
    filter->SetLevel(level);
    filter->SetInsideIsHigher(higher);
    filter->Update();
    EXPECT_EQ(observer->GetWarningMessage().find("whole border") != std::string::npos, isWarned)
      << level << higher;
  }
}

// Density darker than the background: in synthetic maps with noise of each size, and in real ones
// turned over; the unchanged maps cause no warning.
TEST(VTKMapSurface, InvertedContrastIsSuspected)
{
  const auto warning = [](vtkImageData* image, double sign, bool higher)
  {
    auto turned = vtkSmartPointer<vtkImageData>::New();
    turned->CopyStructure(image);
    vtkNew<vtkDoubleArray> values;
    vtkDataArray* from = image->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < from->GetNumberOfTuples(); ++i)
    {
      values->InsertNextValue(sign * from->GetComponent(i, 0));
    }
    turned->GetPointData()->SetScalars(values);
    vtkNew<vtkTest::ErrorObserver> observer;
    vtkNew<vtkMapSurface> filter;
    filter->AddObserver(vtkCommand::WarningEvent, observer);
    filter->SetInputData(turned);
    filter->SetInsideIsHigher(higher);
    filter->Update();
    return observer->GetWarning() ? observer->GetWarningMessage() : std::string();
  };
  const auto expect = [&warning](vtkImageData* image, const std::string& what)
  {
    EXPECT_EQ(warning(image, 1.0, true).find("inverted"), std::string::npos) << what;
    EXPECT_NE(warning(image, -1.0, true).find("Switch InsideIsHigher off"), std::string::npos)
      << what;
    EXPECT_EQ(warning(image, -1.0, false).find("inverted"), std::string::npos) << what;
  };
  std::mt19937 random(5);
  for (const double noise : { 0.0, 0.05, 0.15 })
  {
    std::normal_distribution<double> deviation(0.0, noise > 0.0 ? noise : 1.0);
    vtkNew<vtkImageData> image;
    image->SetDimensions(40, 40, 40);
    vtkNew<vtkDoubleArray> values;
    for (int n = 0; n < 40 * 40 * 40; ++n)
    {
      const double x = n % 40 - 18.0, y = n / 40 % 40 - 20.0, z = n / 1600 - 22.0;
      values->InsertNextValue(
        std::exp(-(x * x + y * y + z * z) / 60.0) + (noise > 0.0 ? deviation(random) : 0.0));
    }
    image->GetPointData()->SetScalars(values);
    expect(image, "noise " + std::to_string(noise));
  }
  // Noise alone, and a masked map whose outside is far lower, cause no warning.
  std::normal_distribution<double> deviation(0.0, 1.0);
  vtkNew<vtkImageData> masked, nothing;
  vtkNew<vtkDoubleArray> within, alone;
  for (int n = 0; n < 40 * 40 * 40; ++n)
  {
    const double x = n % 40 - 19.5, y = n / 40 % 40 - 19.5, z = n / 1600 - 19.5;
    const double r = std::sqrt(x * x + y * y + z * z);
    const double noise = deviation(random);
    alone->InsertNextValue(noise);
    within->InsertNextValue(r > 27.0 ? -20.0 : noise + (r < 6.0 ? 4.0 : 0.0));
  }
  masked->SetDimensions(40, 40, 40);
  masked->GetPointData()->SetScalars(within);
  nothing->SetDimensions(40, 40, 40);
  nothing->GetPointData()->SetScalars(alone);
  EXPECT_EQ(warning(masked, 1.0, true).find("inverted"), std::string::npos);
  EXPECT_EQ(warning(nothing, 1.0, true).find("inverted"), std::string::npos);
  EXPECT_EQ(warning(nothing, -1.0, true).find("inverted"), std::string::npos);

  ISTHMUS_NEEDS_SHARED_DATA("maps/emd_5043.map");
  for (const char* name :
    { "emd_5043.map", "emd_1832.map", "1oel_10.mrc", "emd_5170.map", "D7.ccp4" })
  {
    vtkNew<vtkMRCMapReader> reader;
    reader->SetFileName((SharedDataFolder() / "maps" / name).c_str());
    reader->Update();
    expect(reader->GetOutput(), name);
  }
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
  filter->SetInputData(MakeImage(TwoBalls()));
  filter->SetLevel(1e30);
  filter->Update();
  EXPECT_NE(observer->GetWarningMessage().find("Nothing is inside"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(MeasureContrast, SkewnessMatchesTheValues)
{
  // One node in ten is 3, the others are 1: (1 - 2 p) / sqrt(p (1 - p)), of any unit.
  const Grid grid = SampleGrid(
    { 10, 10, 10 }, { 1, 1, 1 }, [](double x, double, double) { return x == 4.0 ? 3.0 : 1.0; });
  EXPECT_NEAR(MeasureContrast(grid.View).Skewness, 0.8 / 0.3, 1e-9);
}
