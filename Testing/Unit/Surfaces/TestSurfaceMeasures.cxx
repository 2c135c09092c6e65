#include "SharedData.h"
#include "SurfaceModels.h"
#include "Surfaces/CartesianMeasures.h"
#include "Surfaces/SurfaceMeasures.h"
#include "vtkSurfaceMeasures.h"

#include <gtest/gtest.h>

#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace isthmus::testing;
using isthmus::MeasureSurface;
using isthmus::SurfaceMeasure;

namespace
{

const double pi = 4.0 * std::atan(1.0);

double Number(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, 0) : -999.0;
}

/// Signed distance 2 - r on [-5, 5]^3 with n nodes a side: the test of thesis Table 5.2.
std::vector<double> SphereDistance(int n)
{
  std::vector<double> values;
  const double h = 10.0 / (n - 1);
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        values.push_back(2.0 - std::hypot(-5.0 + i * h, -5.0 + j * h, -5.0 + k * h));
      }
    }
  }
  return values;
}

isthmus::LevelView<double> MakeLevelView(const std::vector<double>& values, int n)
{
  isthmus::LevelView<double> level;
  const double h = 10.0 / (n - 1);
  level.Grid = { values.data(), { n, n, n }, { h, h, h } };
  return level;
}

vtkSmartPointer<vtkImageData> MakeImage(const std::vector<double>& values, int n, int type)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const double h = 10.0 / (n - 1);
  image->SetDimensions(n, n, n);
  image->SetSpacing(h, h, h);
  auto scalars = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  scalars->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    scalars->SetComponent(i, 0, values[static_cast<std::size_t>(i)]);
  }
  image->GetPointData()->SetScalars(scalars);
  return image;
}

}

// Table 4.1: the icospheres whose size matches give its digits; V(1) is 4.17, printed 4.16.
TEST(SurfaceMeasures, Table41)
{
  const struct
  {
    int Frequency;
    double RadiusSquared;
    double Area;
    double Volume;
  } rows[] = { { 10, 1.0, 12.53, 4.17 }, { 14, 2.0, 25.09, 11.81 }, { 17, 3.0, 37.66, 21.72 } };
  for (const auto& row : rows)
  {
    const Model sphere = Icosphere(row.Frequency, std::sqrt(row.RadiusSquared));
    const SurfaceMeasure whole = MeasureSurface(sphere.View()).Whole;
    std::printf("r^2 = %g: area %.4f (printed %.2f), volume %.4f (printed %.2f)\n",
      row.RadiusSquared, whole.Area, row.Area, whole.Volume, row.Volume);
    EXPECT_NEAR(whole.Area, row.Area, 0.005);
    EXPECT_NEAR(whole.Volume, row.Volume, 0.005);
    EXPECT_EQ(whole.Genus, 0);
    EXPECT_EQ(whole.EulerNumber(), 2);
  }
  EXPECT_NEAR(MeasureSurface(Icosphere(10, 1.0).View()).Whole.Area, 12.5278, 1e-4);
  EXPECT_NEAR(MeasureSurface(Icosphere(10, 1.0).View()).Whole.Volume, 4.1656, 1e-4);
}

// Estimates of the errors of a sphere: between the error and five times as much, of second order.
TEST(SurfaceMeasures, ErrorsOfSmoothSurfacesAreCovered)
{
  const double area = 4.0 * pi * 4.0, volume = 4.0 / 3.0 * pi * 8.0;
  double before = 0.0;
  for (const int n : { 17, 33, 65 }) // 3.2 to 12.8 nodes for each radius
  {
    vtkNew<vtkFlyingEdges3D> contour;
    contour->SetInputData(MakeImage(SphereDistance(n), n, VTK_DOUBLE));
    contour->SetValue(0, 0.0);
    vtkNew<vtkSurfaceMeasures> filter;
    filter->SetInputConnection(contour->GetOutputPort());
    filter->Update();
    vtkDataObject* output = filter->GetOutputDataObject(0);
    const double areaError = area - Number(output, "Area");
    const double volumeError = volume - Number(output, "Volume");
    EXPECT_GT(areaError, 0.0);
    EXPECT_GE(Number(output, "AreaError"), areaError) << n;
    EXPECT_LE(Number(output, "AreaError"), 5.0 * areaError) << n;
    EXPECT_GE(Number(output, "VolumeError"), volumeError) << n;
    EXPECT_LE(Number(output, "VolumeError"), 5.0 * volumeError) << n;
    EXPECT_NEAR(filter->GetTable()->GetValueByName(0, "VolumeError").ToDouble(),
      Number(output, "VolumeError"), 1e-14);
    if (before > 0.0)
    {
      EXPECT_NEAR(std::log2(before / Number(output, "VolumeError")), 2.0, 0.2);
    }
    before = Number(output, "VolumeError");
  }
  // The same with points on the sphere.
  const SurfaceMeasure sphere = MeasureSurface(Icosphere(10, 1.0).View()).Whole;
  EXPECT_GE(sphere.AreaError, 4.0 * pi - sphere.Area);
  EXPECT_LE(sphere.AreaError, 8.0 * (4.0 * pi - sphere.Area));
  EXPECT_GE(sphere.VolumeError, 4.0 / 3.0 * pi - sphere.Volume);
  EXPECT_LE(sphere.VolumeError, 5.0 * (4.0 / 3.0 * pi - sphere.Volume));
}

// The same for levels of volumes: distances, and the edge of a mask, whose area is a tenth too
// large.
TEST(CartesianMeasures, ErrorsOfLevelsAreCovered)
{
  const double area = 4.0 * pi * 4.0, volume = 4.0 / 3.0 * pi * 8.0;
  for (const int n : { 20, 33, 64 })
  {
    const std::vector<double> distance = SphereDistance(n);
    std::vector<double> mask(distance.size());
    std::transform(
      distance.begin(), distance.end(), mask.begin(), [](double d) { return d > 0.0 ? 1.0 : 0.0; });
    for (const bool isMask : { false, true })
    {
      vtkNew<vtkSurfaceMeasures> filter;
      filter->SetInputData(MakeImage(isMask ? mask : distance, n, VTK_DOUBLE));
      filter->SetLevel(isMask ? 0.5 : 0.0);
      filter->Update();
      vtkDataObject* output = filter->GetOutputDataObject(0);
      const double areaError = std::abs(area - Number(output, "Area"));
      const double volumeError = std::abs(volume - Number(output, "Volume"));
      EXPECT_GE(Number(output, "AreaError"), areaError) << n;
      EXPECT_LE(Number(output, "AreaError"), 10.0 * areaError) << n;
      EXPECT_GE(Number(output, "VolumeError"), volumeError) << n;
      EXPECT_LE(Number(output, "VolumeError"), 5.0 / n * volume) << n;
      EXPECT_EQ(
        filter->GetTable()->GetValueByName(0, "AreaError").ToDouble(), Number(output, "AreaError"));
    }
  }
  // The sides of a box along the axes, between the nodes.
  std::vector<double> box;
  for (int i = 0; i < 20 * 20 * 20; ++i)
  {
    const double x = std::abs(i % 20 - 9.3), y = std::abs(i / 20 % 20 - 9.3);
    box.push_back(4.2 - std::max({ x, y, std::abs(i / 400 - 9.3) }));
  }
  vtkNew<vtkSurfaceMeasures> filter;
  filter->SetInputData(MakeImage(box, 20, VTK_DOUBLE));
  filter->SetLevel(0.0);
  filter->Update();
  const double side = 8.4 * 10.0 / 19.0;
  const double off = std::abs(Number(filter->GetOutputDataObject(0), "Volume") - std::pow(side, 3));
  EXPECT_GE(Number(filter->GetOutputDataObject(0), "VolumeError"), 0.9 * off);
}

TEST(vtkSurfaceMeasures, LevelsAtTheBorderAreWarnedAbout)
{
  for (const bool reaches : { false, true })
  {
    vtkNew<vtkTest::ErrorObserver> observer;
    vtkNew<vtkSurfaceMeasures> filter;
    filter->AddObserver(vtkCommand::WarningEvent, observer);
    filter->SetInputData(MakeImage(SphereDistance(21), 21, VTK_FLOAT));
    filter->SetLevel(reaches ? -3.1 : 0.0); // a sphere of 5.1 in a box of 10
    filter->Update();
    EXPECT_EQ(
      observer->GetWarningMessage().find("reaches the border") != std::string::npos, reaches);
  }
}

// A tube with the section of a figure eight; spindle tori, whose meridians all meet in two points
// of the axis; and surfaces that do neither.
TEST(vtkSurfaceMeasures, SurfacesThatPassThroughOrTouchThemselvesAreWarnedAbout)
{
  Model eight = Torus(60, 42, 3.0, 1.0); // no points where it crosses itself
  for (isthmus::Point3& p : eight.Points)
  {
    const double ring = std::hypot(p[0], p[1]);
    p[2] *= ring - 3.0;
  }
  Model pyramids = Torus(12, 12, 3.0, 1.0); // a slim horn to the opposite side of the tube
  pyramids.Points[6] = { -1.99, 0.0, 0.0 };
  const struct
  {
    Model Surface;
    const char* Words;
  } rows[] = { { eight, "passes through itself" }, { Torus(60, 41, 0.5, 1.0), "touches itself" },
    { Torus(31, 40, 0.8, 1.0), "touches itself" }, { Torus(60, 42, 0.5, 1.0), "touches itself" },
    { Torus(60, 40, 3.0, 1.0), "" }, { Torus(60, 42, 1.001, 1.0), "" }, { Icosphere(6, 1.0), "" },
    { Icosphere(20, 1.0), "" }, { pyramids, "" } };
  for (const auto& row : rows)
  {
    for (const double scale : { 1e-9, 1.0, 1e12 })
    {
      Model model = row.Surface;
      for (isthmus::Point3& p : model.Points)
      {
        p = { scale * p[0], scale * p[1], scale * p[2] };
      }
      vtkNew<vtkTest::ErrorObserver> observer;
      vtkNew<vtkSurfaceMeasures> filter;
      filter->AddObserver(vtkCommand::WarningEvent, observer);
      filter->SetInputData(ToPolyData(model));
      filter->Update();
      const std::string words = row.Words;
      EXPECT_EQ(observer->GetWarning(), !words.empty())
        << &row - rows << " " << scale << observer->GetWarningMessage();
      EXPECT_NE(observer->GetWarningMessage().find(words), std::string::npos)
        << &row - rows << " " << scale << observer->GetWarningMessage();
      EXPECT_TRUE(std::isfinite(Number(filter->GetOutputDataObject(0), "Volume")));
    }
  }
}

TEST(SurfaceMeasures, BoxFarFromTheOrigin)
{
  Model box;
  for (int i = 0; i < 8; ++i)
  {
    box.AddPoint(1e6 + (i & 1) * 2.0, -1e6 + (i >> 1 & 1) * 3.0, 1e6 + (i >> 2) * 4.0);
  }
  box.Triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  const SurfaceMeasure whole = MeasureSurface(box.View()).Whole;
  EXPECT_NEAR(whole.Area, 52.0, 1e-12);
  EXPECT_EQ(whole.AreaError, 0.0) << "edges are sharp, sides are flat";
  EXPECT_EQ(whole.VolumeError, 0.0);
  EXPECT_NEAR(whole.Volume, 24.0, 1e-12);
  TurnInsideOut(box);
  EXPECT_NEAR(MeasureSurface(box.View()).Whole.Volume, -24.0, 1e-12);
}

TEST(SurfaceMeasures, ComponentsHandlesAndCavities)
{
  Model model = Icosphere(4, 3.0);
  Model cavity = Icosphere(2, 1.0);
  TurnInsideOut(cavity);
  Append(model, cavity, { 0, 0, 0 });
  Append(model, Torus(40, 20, 2.0, 0.5), { 10, 0, 0 });
  const isthmus::SurfaceMeasures measures = MeasureSurface(model.View());
  ASSERT_EQ(measures.Components.size(), 3u);
  EXPECT_EQ(measures.Components[0].Genus, 0);
  EXPECT_EQ(measures.Components[2].Genus, 1);
  EXPECT_LT(measures.Components[1].Volume, 0.0);
  EXPECT_EQ(measures.Whole.Genus, 1);
  EXPECT_EQ(measures.Whole.EulerNumber(), 4);
  EXPECT_NEAR(measures.Components[2].Volume, 2.0 * pi * pi * 2.0 * 0.25, 0.3);
  EXPECT_DOUBLE_EQ(measures.Whole.Volume,
    measures.Components[0].Volume + measures.Components[1].Volume + measures.Components[2].Volume);
}

TEST(SurfaceMeasures, HolesAreCountedAndVolumeIsRefused)
{
  Model sphere = Icosphere(5, 1.0);
  sphere.Triangles.erase(sphere.Triangles.begin() + 40);
  sphere.Triangles.erase(sphere.Triangles.begin() + 400);
  const SurfaceMeasure whole = MeasureSurface(sphere.View()).Whole;
  EXPECT_EQ(whole.OpenEdges, 6);
  EXPECT_EQ(whole.BoundaryLoops, 2);
  EXPECT_EQ(whole.Genus, 0);
  EXPECT_EQ(whole.IrregularPoints, 0);
  EXPECT_TRUE(std::isnan(whole.Volume));
  EXPECT_TRUE(std::isnan(whole.VolumeError));
  EXPECT_GT(whole.AreaError, 0.0);
  EXPECT_LT(whole.AreaError, 0.2 * whole.Area);
}

TEST(SurfaceMeasures, NonManifoldAndFlippedAreReported)
{
  // Two tetrahedra that share an edge: closed, but four triangles meet along it.
  Model pair;
  pair.Points = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 1, 1, 0 }, { -1, 0, 0 }, { -1, -1, 0 } };
  const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
  {
    pair.Triangles.insert(
      pair.Triangles.end(), { { a, c, b }, { a, b, d }, { a, d, c }, { b, c, d } });
  };
  add(0, 2, 3, 1);
  add(0, 4, 5, 1);
  SurfaceMeasure whole = MeasureSurface(pair.View()).Whole;
  EXPECT_EQ(whole.IrregularPoints, 2);
  EXPECT_EQ(whole.Genus, -1);
  EXPECT_EQ(whole.OpenEdges, 0);
  EXPECT_NEAR(whole.Volume, 2.0 / 6.0, 1e-15);

  Model flipped = Icosphere(3, 1.0);
  std::swap(flipped.Triangles[7][0], flipped.Triangles[7][1]);
  whole = MeasureSurface(flipped.View()).Whole;
  EXPECT_EQ(whole.OpenEdges, 3);
  EXPECT_EQ(whole.IrregularPoints, 3);
  EXPECT_TRUE(std::isnan(whole.Volume));
}

TEST(SurfaceMeasures, RealSurfaces)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/fertility.off");
  const struct
  {
    const char* Name;
    vtkIdType Components;
    vtkIdType Genus;
    double Volume;
  } rows[] = { { "fertility", 1, 4, 4.322e5 }, { "3holes", 1, 3, 0.09947 },
    { "casting", 1, 9, 0.03391 }, { "casting_inverted", 1, 9, -0.03391 } };
  for (const auto& row : rows)
  {
    const auto path = SharedDataFolder() / "surfaces" / (std::string(row.Name) + ".off");
    const auto measures = MeasureSurface(ReadOFF(path.string()).View());
    EXPECT_EQ(measures.Components.size(), static_cast<std::size_t>(row.Components)) << row.Name;
    EXPECT_EQ(measures.Whole.Genus, row.Genus) << row.Name;
    EXPECT_NEAR(measures.Whole.Volume, row.Volume, 6e-4 * std::abs(row.Volume)) << row.Name;
  }
}

// Table 5.2: a strict test for crossings misses the six nodes that lie exactly on the sphere.
TEST(CartesianMeasures, Table52)
{
  const struct
  {
    int Nodes;
    double Strict;
    double HalfOpen;
  } rows[] = { { 21, 3.391, 1.8908 }, { 41, 0.9390, 0.56398 }, { 81, 0.2026, 0.10887 },
    { 161, 0.05498, 0.031546 } };
  for (const auto& row : rows)
  {
    const std::vector<double> values = SphereDistance(row.Nodes);
    const auto level = MakeLevelView(values, row.Nodes);
    const double h = level.Grid.Spacing[0];
    const std::int64_t step[3] = { 1, row.Nodes, row.Nodes * row.Nodes };
    double strict = 0.0;
    std::vector<isthmus::GridCrossing> crossings;
    for (int k = 0; k < row.Nodes; ++k)
    {
      isthmus::AppendLevelCrossings(level, k, crossings);
    }
    for (const auto& crossing : crossings)
    {
      if (level.Grid.Data[crossing.Node] * level.Grid.Data[crossing.Node + step[crossing.Axis]] < 0)
      {
        strict += std::abs(crossing.Normal[static_cast<std::size_t>(crossing.Axis)]) * h * h;
      }
    }
    const double area = isthmus::MeasureOnGrid(level, 1.0, 0.0).Area;
    const double strictError = std::abs(strict - 16.0 * pi);
    const double error = std::abs(area - 16.0 * pi);
    std::printf("h = %-7g error %.5g (expected %.5g), strict %.5g (printed %.4g)\n", h, error,
      row.HalfOpen, strictError, row.Strict);
    EXPECT_NEAR(strictError / row.Strict, 1.0, 1.5e-4);
    EXPECT_NEAR(error / row.HalfOpen, 1.0, 5e-5);
  }
}

TEST(CartesianMeasures, SharpAndSmearedOnAnyTypeAndSide)
{
  const int n = 81;
  const std::vector<double> distance = SphereDistance(n);
  std::vector<double> profile(distance.size());
  for (std::size_t i = 0; i < profile.size(); ++i)
  {
    profile[i] = 0.5 + 0.5 * std::tanh(distance[i] / 0.25);
  }
  const auto plain = isthmus::MeasureOnGrid(MakeLevelView(distance, n), 1.0, 0.0);
  EXPECT_NEAR(plain.Volume, 32.0 / 3.0 * pi, 0.5);

  vtkNew<vtkSurfaceMeasures> filter;
  filter->SetInputData(MakeImage(profile, n, VTK_FLOAT));
  filter->Update();
  const double area = Number(filter->GetOutputDataObject(0), "Area");
  EXPECT_NEAR(area, 16.0 * pi, 0.15);
  // The levels of this profile are spheres whose radii follow the logistic distribution.
  const double variance = pi * pi / 3.0 * 0.125 * 0.125;
  const double meanArea = 4.0 * pi * (4.0 + variance);
  const double meanVolume = 4.0 / 3.0 * pi * (8.0 + 6.0 * variance);
  EXPECT_NEAR(Number(filter->GetOutputDataObject(0), "SmearedArea"), meanArea, 0.03 * meanArea);
  EXPECT_NEAR(Number(filter->GetOutputDataObject(0), "SmearedVolume"), meanVolume, 1e-3);
  EXPECT_EQ(filter->GetTable()->GetNumberOfColumns(), 6);
  EXPECT_DOUBLE_EQ(filter->GetTable()->GetValueByName(0, "Area").ToDouble(), area);

  // The same as a field that is lower inside, in another unit, and as integers.
  std::vector<double> other(profile.size());
  for (std::size_t i = 0; i < other.size(); ++i)
  {
    other[i] = std::round(1e6 * (3.0 - profile[i]));
  }
  filter->SetInputData(MakeImage(other, n, VTK_INT));
  filter->SetLevel(2.5e6);
  filter->InsideIsHigherOff();
  filter->SetInsideValue(2e6);
  filter->SetOutsideValue(3e6);
  filter->Update();
  EXPECT_NEAR(Number(filter->GetOutputDataObject(0), "Area"), area, 1e-4);
  EXPECT_NEAR(Number(filter->GetOutputDataObject(0), "SmearedVolume"), meanVolume, 1e-3);
}

TEST(vtkSurfaceMeasures, QuadsStripsFieldDataAndTable)
{
  // A cube of quads, one of them written as a strip.
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(i & 1, i >> 1 & 1, i >> 2);
  }
  vtkNew<vtkCellArray> quads;
  for (const auto& quad : { std::array<vtkIdType, 4>{ 0, 2, 3, 1 }, { 0, 1, 5, 4 }, { 1, 3, 7, 5 },
         { 3, 2, 6, 7 }, { 2, 0, 4, 6 } })
  {
    quads->InsertNextCell(4, quad.data());
  }
  vtkNew<vtkCellArray> strips;
  const vtkIdType strip[4] = { 4, 5, 6, 7 };
  strips->InsertNextCell(4, strip);
  vtkNew<vtkPolyData> cube;
  cube->SetPoints(points);
  cube->SetPolys(quads);
  cube->SetStrips(strips);

  vtkNew<vtkSurfaceMeasures> filter;
  filter->SetInputData(cube);
  filter->Update();
  vtkDataObject* output = filter->GetOutputDataObject(0);
  EXPECT_NEAR(Number(output, "Area"), 6.0, 1e-14);
  EXPECT_NEAR(Number(output, "Volume"), 1.0, 1e-14);
  EXPECT_EQ(Number(output, "Genus"), 0);
  EXPECT_EQ(Number(output, "Components"), 1);
  EXPECT_EQ(vtkPolyData::SafeDownCast(output)->GetNumberOfCells(), 6);
  EXPECT_FALSE(cube->GetFieldData()->HasArray("Area")) << "the input was changed";
  vtkTable* table = filter->GetTable();
  EXPECT_EQ(table->GetNumberOfRows(), 2);
  EXPECT_EQ(table->GetValueByName(0, "Component").ToInt(), -1);
  EXPECT_EQ(table->GetValueByName(1, "Triangles").ToInt(), 12);
}

TEST(vtkSurfaceMeasures, ReportsBadInput)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkSurfaceMeasures> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);

  Model broken = Icosphere(2, 1.0);
  broken.Points[5][1] = std::numeric_limits<double>::quiet_NaN();
  filter->SetInputData(ToPolyData(broken));
  filter->Update();
  EXPECT_NE(observer->GetErrorMessage().find("Point 5 of the surface"), std::string::npos);
  EXPECT_EQ(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), 0);
  observer->Clear();

  broken = Icosphere(2, 1.0);
  broken.Triangles[3][2] = 1000;
  filter->SetInputData(ToPolyData(broken));
  filter->Update();
  EXPECT_NE(observer->GetErrorMessage().find("has the corner 1000"), std::string::npos);
  observer->Clear();

  vtkNew<vtkImageData> noScalars;
  noScalars->SetDimensions(4, 4, 4);
  filter->SetInputData(noScalars);
  filter->Update();
  EXPECT_NE(observer->GetErrorMessage().find("no active scalars"), std::string::npos);
  observer->Clear();

  Model open = Icosphere(2, 1.0);
  open.Triangles.pop_back();
  filter->SetInputData(ToPolyData(open));
  filter->Update();
  EXPECT_FALSE(observer->GetError());
  EXPECT_NE(observer->GetWarningMessage().find("3 edges"), std::string::npos);
  observer->Clear();

  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->Update();
  EXPECT_FALSE(observer->GetError());
  EXPECT_EQ(Number(filter->GetOutputDataObject(0), "Area"), 0.0);
}
