#include "GridDistance.h"
#include "SharedData.h"
#include "SurfaceCrossings.h"
#include "SurfaceMeasures.h"
#include "SurfaceModels.h"
#include "vtkSurfaceToGrid.h"

#include <gtest/gtest.h>

#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkTestErrorObserver.h>
#include <vtkTriangle.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

using namespace isthmus::testing;
using namespace isthmus;

namespace
{

const double pi = 4.0 * std::atan(1.0);

GridShape Cube(int nodes, double side)
{
  const double h = side / (nodes - 1);
  return { { nodes, nodes, nodes }, { h, h, h } };
}

Vector PositionOf(const GridCrossing& crossing, const GridShape& grid)
{
  const std::int64_t row = crossing.Node / grid.Dimensions[0];
  Vector index{ static_cast<double>(crossing.Node % grid.Dimensions[0]),
    static_cast<double>(row % grid.Dimensions[1]), static_cast<double>(row / grid.Dimensions[1]) };
  index[static_cast<std::size_t>(crossing.Axis)] += crossing.Fraction;
  for (std::size_t a = 0; a < 3; ++a)
  {
    index[a] *= grid.Spacing[a];
  }
  return index;
}

Model Moved(Model model, double x, double y, double z)
{
  for (Vector& p : model.Points)
  {
    p = { p[0] + x, p[1] + y, p[2] + z };
  }
  return model;
}

/// The mesh moved and scaled so that its box lies in [margin, side - margin]^3, touching along one
/// axis.
Model Fitted(Model model, double side, double margin)
{
  Vector low = model.Points[0], high = model.Points[0];
  for (const Vector& p : model.Points)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  }
  const double size = std::max({ high[0] - low[0], high[1] - low[1], high[2] - low[2] });
  const double scale = (side - 2.0 * margin) / size;
  for (Vector& p : model.Points)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      p[a] = margin + scale * (p[a] - low[a]);
    }
  }
  return model;
}

/// Distance to the nearest of all triangles, by VTK's point-triangle distance.
double BruteForce(const Model& model, const Vector& x)
{
  double nearest = std::numeric_limits<double>::infinity();
  vtkNew<vtkTriangle> triangle;
  for (const auto& t : model.Triangles)
  {
    double closest[3], parameters[3], weights[3], squared = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      triangle->GetPoints()->SetPoint(
        c, model.Points[static_cast<std::size_t>(t[static_cast<std::size_t>(c)])].data());
    }
    int part = 0;
    triangle->EvaluatePosition(x.data(), closest, part, parameters, squared, weights);
    nearest = std::min(nearest, squared);
  }
  return std::sqrt(nearest);
}

/// Sum of the solid angles of all triangles seen from `x`, over 4 pi: 1 inside, 0 outside.
double WindingNumber(const Model& model, const Vector& x)
{
  double sum = 0.0;
  for (const auto& t : model.Triangles)
  {
    double r[3][3], length[3];
    for (std::size_t c = 0; c < 3; ++c)
    {
      vtkMath::Subtract(model.Points[static_cast<std::size_t>(t[c])].data(), x.data(), r[c]);
      length[c] = vtkMath::Norm(r[c]);
    }
    const double volume = vtkMath::Determinant3x3(r[0], r[1], r[2]);
    const double rest = length[0] * length[1] * length[2] + vtkMath::Dot(r[0], r[1]) * length[2] +
      vtkMath::Dot(r[1], r[2]) * length[0] + vtkMath::Dot(r[2], r[0]) * length[1];
    sum += 2.0 * std::atan2(volume, rest);
  }
  return sum / (4.0 * pi);
}

}

// Table 5.1: the error is set by the triangles, so its order shows when they are refined with h.
TEST(SurfaceCrossings, Table51)
{
  const struct
  {
    int Frequency;
    double Spacing;
    double Error;
  } rows[] = { { 22, 0.25, 7.802e-4 }, { 44, 0.125, 1.924e-4 }, { 88, 0.0625, 4.77e-5 } };
  double last = 0.0;
  for (const auto& row : rows)
  {
    // The grid begins 1 before the sphere, as for the errors expected, which a script with another
    // rule for duplicates gives (merging equal points).
    Model sphere = Icosphere(row.Frequency, 2.0);
    double low = 0.0;
    for (const Vector& p : sphere.Points)
    {
      low = std::min(low, p[0]);
    }
    const double centre = 1.0 - low;
    sphere = Moved(sphere, centre, centre, centre);
    const auto nodes = static_cast<std::int64_t>(std::lround(6.0 / row.Spacing)) + 1;
    const GridShape grid{ { nodes, nodes, nodes }, { row.Spacing, row.Spacing, row.Spacing } };
    const auto crossings = SurfaceCrossings(sphere.View(), grid, CrossingNormal::Points);
    double error = 0.0;
    for (const GridCrossing& crossing : crossings)
    {
      const Vector p = PositionOf(crossing, grid);
      const Vector r{ p[0] - centre, p[1] - centre, p[2] - centre };
      error += std::abs(2.0 - vtkMath::Norm(r.data()));
      EXPECT_NEAR(vtkMath::Dot(r.data(), crossing.Normal.data()) / 2.0, 1.0, 2e-3);
    }
    error /= static_cast<double>(crossings.size());
    std::printf("h = %-7g %6zu crossings, mean error %.4e, order %.2f\n", row.Spacing,
      crossings.size(), error, last > 0.0 ? std::log2(last / error) : 0.0);
    EXPECT_NEAR(error / row.Error, 1.0, 0.01);
    EXPECT_TRUE(last == 0.0 || std::log2(last / error) > 1.9);
    last = error;
  }
}

TEST(SurfaceCrossings, OrderedAndOnTheSurface)
{
  const Model torus = Moved(Torus(60, 40, 2.0, 0.8), 3.01, 3.02, 1.03);
  const GridShape grid{ { 40, 31, 25 }, { 0.17, 0.2, 0.1 } };
  const auto crossings = SurfaceCrossings(torus.View(), grid, CrossingNormal::Triangles);
  double area = 0.0;
  const double cell = 0.17 * 0.2 * 0.1;
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    EXPECT_TRUE(i % 50 != 0 || BruteForce(torus, PositionOf(crossings[i], grid)) < 1e-6);
    EXPECT_TRUE(crossings[i].Fraction >= 0.0 && crossings[i].Fraction <= 1.0);
    EXPECT_TRUE(i == 0 || crossings[i - 1].Node <= crossings[i].Node);
    const auto axis = static_cast<std::size_t>(crossings[i].Axis);
    area += std::abs(crossings[i].Normal[axis]) * cell / grid.Spacing[axis];
  }
  // The crossings' normals give the area, as 5.26 does for levels.
  EXPECT_NEAR(area / MeasureSurface(torus.View()).Whole.Area, 1.0, 0.01);
}

// Lines through corners and along edges and faces: a box whose faces lie on nodes, cut in every
// way.
TEST(SurfaceCrossings, ParityHoldsWhereLinesMeetCornersAndEdges)
{
  Model box;
  for (int i = 0; i < 8; ++i)
  {
    box.AddPoint(2.0 + 4.0 * (i & 1), 2.0 + 4.0 * (i >> 1 & 1), 2.0 + 4.0 * (i >> 2));
  }
  box.Triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  const GridShape grid = Cube(9, 8.0);
  const auto inside = NodesInside(box.View(), grid);
  for (std::int64_t node = 0; node < grid.Size(); ++node)
  {
    const std::int64_t index[3] = { node % 9, node / 9 % 9, node / 81 };
    const auto all = [&](std::int64_t low, std::int64_t high) {
      return std::all_of(index, index + 3, [&](std::int64_t i) { return i >= low && i <= high; });
    };
    EXPECT_TRUE(!all(3, 5) || inside[static_cast<std::size_t>(node)] == 1);
    EXPECT_TRUE(all(2, 6) || inside[static_cast<std::size_t>(node)] == 0);
  }
  // Octahedra with their corners on nodes, as silhouettes through nodes in all directions.
  Model octahedron;
  octahedron.Points = { { 1, 4, 4 }, { 7, 4, 4 }, { 4, 1, 4 }, { 4, 7, 4 }, { 4, 4, 1 },
    { 4, 4, 7 } };
  octahedron.Triangles = { { 0, 4, 3 }, { 3, 4, 1 }, { 1, 4, 2 }, { 2, 4, 0 }, { 0, 3, 5 },
    { 3, 1, 5 }, { 1, 2, 5 }, { 2, 0, 5 } };
  const auto flags = NodesInside(octahedron.View(), grid);
  for (std::int64_t node = 0; node < grid.Size(); ++node)
  {
    const std::int64_t sum =
      std::abs(node % 9 - 4) + std::abs(node / 9 % 9 - 4) + std::abs(node / 81 - 4);
    EXPECT_TRUE(sum == 3 || flags[static_cast<std::size_t>(node)] == (sum < 3));
  }
}

TEST(SurfaceCrossings, InsideAgreesWithSolidAngles)
{
  Model model = Moved(Torus(24, 14, 2.0, 0.8), 3.0, 3.0, 1.5);
  Model cavity = Moved(Icosphere(2, 0.4), 5.0, 3.0, 1.5);
  TurnInsideOut(cavity);
  Append(model, cavity, { 0, 0, 0 });
  const GridShape grid{ { 30, 25, 15 }, { 0.2, 0.25, 0.2 } };
  const auto inside = NodesInside(model.View(), grid);
  const auto irregular = IrregularNodes(inside, grid);
  for (std::int64_t node = 0; node < grid.Size(); node += 3)
  {
    const Vector x{ static_cast<double>(node % 30) * 0.2,
      static_cast<double>(node / 30 % 25) * 0.25, static_cast<double>(node / 750) * 0.2 };
    EXPECT_NEAR(WindingNumber(model, x), inside[static_cast<std::size_t>(node)], 1e-6) << node;
  }
  EXPECT_GT(std::count(irregular.begin(), irregular.end(), 1), 100);

  model.Triangles.erase(model.Triangles.begin(), model.Triangles.begin() + 28);
  EXPECT_THROW(NodesInside(model.View(), grid), std::invalid_argument);
  EXPECT_THROW(SurfaceCrossings(Moved(model, 1e9, 0, 0).View(), grid, CrossingNormal::Triangles),
    std::invalid_argument);
}

TEST(GridDistance, Sphere)
{
  const Model sphere = Moved(Icosphere(30, 2.0), 3.0, 3.0, 3.0);
  const GridShape grid = Cube(49, 6.0);
  const auto distance = DistanceToSurface(sphere.View(), grid, 2.0 * grid.Spacing[0]);
  double worstNear = 0.0, worstFar = 0.0;
  for (std::int64_t node = 0; node < grid.Size(); ++node)
  {
    const double h = grid.Spacing[0];
    const double r = std::hypot(static_cast<double>(node % 49) * h - 3.0,
      static_cast<double>(node / 49 % 49) * h - 3.0, static_cast<double>(node / 2401) * h - 3.0);
    const double error = std::abs(distance[static_cast<std::size_t>(node)] - std::abs(r - 2.0));
    double& worst = std::abs(r - 2.0) < 2.0 * h ? worstNear : worstFar;
    worst = std::max(worst, error);
  }
  const auto exact = ExactDistanceToSurface(sphere.View(), grid);
  for (std::size_t node = 0; node < exact.size(); ++node)
  {
    ASSERT_LE(exact[node], distance[node] + 1e-12);
    ASSERT_GT(exact[node], distance[node] - 0.25 * grid.Spacing[0]);
  }
  std::printf("sphere: largest error in the band %.2e, beyond %.2e\n", worstNear, worstFar);
  EXPECT_LT(worstNear, 2e-3) << "the sag of the triangles is 1.4e-3 to 1.6e-3";
  EXPECT_LT(worstFar, 0.25 * grid.Spacing[0]);
}

TEST(GridDistance, IsFiniteWhereNoLineOfTheGridIsCrossed)
{
  // A needle along y between the lines of the grid, and a ball within one cell.
  for (const double length : { 0.3, 8.0 })
  {
    Model needle = Icosphere(1, 0.1);
    for (auto& point : needle.Points)
    {
      point = { point[0] + 5.5, point[1] * 5.0 * length + 5.5, point[2] + 5.5 };
    }
    const GridShape grid{ { 12, length > 1.0 ? 4 : 12, 12 },
      { 1.0, length > 1.0 ? 11.0 : 1.0, 1.0 } };
    ASSERT_TRUE(SurfaceCrossings(needle.View(), grid, CrossingNormal::Triangles).empty());
    EXPECT_EQ(
      DistanceToSurface(needle.View(), grid, 2.0), ExactDistanceToSurface(needle.View(), grid));
  }
}

TEST(GridDistance, FertilityAgainstBruteForce)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/fertility.off");
  const GridShape grid{ { 81, 65, 101 }, { 1.0 / 64, 1.0 / 64, 1.0 / 64 } };
  const Model mesh =
    Fitted(ReadOFF((SharedDataFolder() / "surfaces/fertility.off").string()), 1.0, 0.05);
  const double h = grid.Spacing[0];
  const double band = 2.0 * h;
  const auto distance = DistanceToSurface(mesh.View(), grid, band);
  const auto everywhere = ExactDistanceToSurface(mesh.View(), grid);
  const auto inside = NodesInside(mesh.View(), grid);
  std::mt19937 random(3);
  std::uniform_int_distribution<std::int64_t> any(0, grid.Size() - 1);
  double worstNear = 0.0, worstFar = 0.0;
  int near = 0, far = 0, wrong = 0;
  for (int sample = 0; sample < 120; ++sample)
  {
    const std::int64_t node = any(random);
    const auto n = static_cast<std::size_t>(node);
    const Vector x{ static_cast<double>(node % 81) * h, static_cast<double>(node / 81 % 65) * h,
      static_cast<double>(node / (81 * 65)) * h };
    const double exact = BruteForce(mesh, x);
    EXPECT_NEAR(everywhere[n], exact, 1e-12);
    EXPECT_GE(distance[n], exact - 1e-9) << "never too small";
    (exact <= band ? near : far) += 1;
    double& worst = exact <= band ? worstNear : worstFar;
    worst = std::max(worst, distance[n] - exact);
    wrong += distance[n] > exact + 1e-9;
    EXPECT_NEAR(WindingNumber(mesh, x), inside[n], 1e-5);
  }
  std::printf("%d nodes in the band: largest error %.1e h; %d beyond: %d not exact, largest error "
              "%.1e h\n",
    near, worstNear / h, far, wrong, worstFar / h);
  EXPECT_LT(worstNear, 1e-12);
  EXPECT_LT(worstFar, 0.25 * h);
}

namespace
{

vtkDataArray* Nodes(vtkSurfaceToGrid* filter, const char* name)
{
  vtkDataArray* array = filter->GetOutput()->GetPointData()->GetArray(name);
  EXPECT_TRUE(array) << name;
  return array;
}

}

TEST(vtkSurfaceToGrid, SurfaceOnItsOwnGrid)
{
  vtkNew<vtkSurfaceToGrid> filter;
  filter->SetInputData(ToPolyData(Moved(Icosphere(20, 2.0), 10.0, -20.0, 30.0)));
  filter->SetSpacing(0.1);
  filter->Update();
  vtkImageData* image = filter->GetOutput();
  EXPECT_EQ(image->GetDimensions()[0], 45);
  ASSERT_GT(image->GetNumberOfPoints(), 0);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* x = image->GetPoint(i);
    const double exact = std::hypot(x[0] - 10.0, x[1] + 20.0, x[2] - 30.0) - 2.0;
    const double tolerance = std::abs(exact) > 0.19 ? 0.025 : 4e-3; // exact in the band
    EXPECT_NEAR(Nodes(filter, "SignedDistance")->GetComponent(i, 0), exact, tolerance);
    EXPECT_TRUE(
      std::abs(exact) < 4e-3 || Nodes(filter, "Inside")->GetComponent(i, 0) == (exact < 0));
  }
  vtkPolyData* crossings = filter->GetCrossings();
  EXPECT_EQ(crossings->GetNumberOfVerts(), crossings->GetNumberOfPoints());
  for (vtkIdType i = 0; i < crossings->GetNumberOfPoints(); ++i)
  {
    const double* x = crossings->GetPoint(i);
    EXPECT_NEAR(std::hypot(x[0] - 10.0, x[1] + 20.0, x[2] - 30.0), 2.0, 4e-3);
  }
}

// A grid with an extent that does not start at 0, an unequal spacing and turned axes.
TEST(vtkSurfaceToGrid, SurfaceOnAGivenGrid)
{
  vtkNew<vtkImageData> grid;
  grid->SetExtent(-3, 30, 5, 40, 2, 30);
  grid->SetSpacing(0.2, 0.16, 0.25);
  grid->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
  grid->SetOrigin(4.0, -3.0, -4.0);
  vtkNew<vtkSurfaceToGrid> filter;
  double centre[3];
  double index[3] = { 13.0, 22.0, 16.0 };
  grid->TransformContinuousIndexToPhysicalPoint(index, centre);
  filter->SetInputData(0, ToPolyData(Moved(Icosphere(20, 1.5), centre[0], centre[1], centre[2])));
  filter->SetInputData(1, grid);
  filter->SetNormalMode(vtkSurfaceToGrid::PointNormals);
  filter->ExactEverywhereOn();
  filter->Update();
  vtkImageData* image = filter->GetOutput();
  EXPECT_EQ(image->GetExtent()[0], -3);
  ASSERT_EQ(image->GetNumberOfPoints(), grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    const double exact = std::sqrt(vtkMath::Distance2BetweenPoints(x, centre)) - 1.5;
    EXPECT_NEAR(Nodes(filter, "SignedDistance")->GetComponent(i, 0), exact, 6e-3);
  }
  vtkPolyData* crossings = filter->GetCrossings();
  ASSERT_GT(crossings->GetNumberOfPoints(), 100);
  for (vtkIdType i = 0; i < crossings->GetNumberOfPoints(); ++i)
  {
    double outward[3];
    vtkMath::Subtract(crossings->GetPoint(i), centre, outward);
    EXPECT_NEAR(vtkMath::Norm(outward), 1.5, 6e-3);
    vtkMath::Normalize(outward);
    EXPECT_GT(vtkMath::Dot(outward, crossings->GetPointData()->GetNormals()->GetTuple3(i)), 0.999);
  }
}

TEST(vtkSurfaceToGrid, LevelOfAnImage)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(41, 41, 41);
  image->SetOrigin(-2, -2, -2);
  image->SetSpacing(0.1, 0.1, 0.1);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->SetName("Density");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* x = image->GetPoint(i);
    image->GetPointData()->GetScalars()->SetComponent(i, 0, 3.0 - std::hypot(x[0], x[1], x[2]));
  }
  vtkNew<vtkSurfaceToGrid> filter;
  filter->SetInputData(image);
  filter->SetIsoValue(1.73);
  filter->Update();
  EXPECT_TRUE(filter->GetOutput()->GetPointData()->HasArray("Density"));
  std::set<vtkIdType> below;
  vtkPolyData* crossings = filter->GetCrossings();
  for (vtkIdType i = 0; i < crossings->GetNumberOfPoints(); ++i)
  {
    const double* x = crossings->GetPoint(i);
    EXPECT_NEAR(vtkMath::Norm(x), 1.27, 2e-3);
    EXPECT_NEAR(vtkMath::Dot(x, crossings->GetPointData()->GetNormals()->GetTuple3(i)), 1.27, 3e-3);
    below.insert(static_cast<vtkIdType>(crossings->GetPointData()->GetArray("Node")->GetTuple1(i)));
  }
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double exact = vtkMath::Norm(image->GetPoint(i)) - 1.27;
    const double tolerance = std::abs(exact) > 0.19 ? 0.025 : 3e-3; // exact in the band
    EXPECT_NEAR(Nodes(filter, "SignedDistance")->GetComponent(i, 0), exact, tolerance);
    EXPECT_EQ(Nodes(filter, "Inside")->GetComponent(i, 0), exact < 0.0);
    EXPECT_TRUE(!below.count(i) || Nodes(filter, "Irregular")->GetComponent(i, 0) == 1.0);
  }
  // Irregular, as documented: one of the six neighbours is on the other side of the sphere.
  vtkIdType irregular = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* x = image->GetPoint(i);
    const bool inside = vtkMath::Norm(x) < 1.27;
    bool other = false;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const double step : { -image->GetSpacing()[axis], image->GetSpacing()[axis] })
      {
        double y[3] = { x[0], x[1], x[2] };
        y[axis] += step;
        other = other || (image->FindPoint(y) >= 0 && (vtkMath::Norm(y) < 1.27) != inside);
      }
    }
    irregular += other;
    ASSERT_EQ(Nodes(filter, "Irregular")->GetComponent(i, 0), other ? 1.0 : 0.0) << "node " << i;
  }
  EXPECT_GT(irregular, 100);
  EXPECT_LT(irregular, image->GetNumberOfPoints() / 2);
}

TEST(vtkSurfaceToGrid, SameBitsOnAnyNumberOfThreads)
{
  const auto surface = ToPolyData(Torus(120, 60, 2.0, 0.7));
  std::vector<double> first;
  for (const int threads : { 1, 2, 3 })
  {
    vtkNew<vtkSurfaceToGrid> filter;
    filter->SetInputData(surface);
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config(threads, "STDThread", false), [&]() { filter->Update(); });
    auto* distance = vtkDoubleArray::SafeDownCast(Nodes(filter, "SignedDistance"));
    const std::vector<double> now(distance->Begin(), distance->End());
    EXPECT_TRUE(first.empty() || now == first);
    first = now;
  }
}

TEST(vtkSurfaceToGrid, BadInputIsToldInASentence)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkSurfaceToGrid> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  const auto messageFor = [&](vtkDataObject* input)
  {
    observer->Clear();
    filter->SetInputDataObject(0, input);
    filter->Update();
    return observer->GetErrorMessage();
  };
  const auto sphere = ToPolyData(Icosphere(4, 1.0));
  Model open = Icosphere(4, 1.0);
  open.Triangles.resize(open.Triangles.size() / 2);
  EXPECT_NE(messageFor(ToPolyData(open)).find("not closed"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetCrossings()->GetNumberOfPoints(), 0);
  filter->GenerateInsideOff();
  filter->GenerateSignedDistanceOff();
  EXPECT_EQ(messageFor(ToPolyData(open)), "");
  EXPECT_GT(filter->GetCrossings()->GetNumberOfPoints(), 0);
  filter->GenerateInsideOn();
  filter->SetSpacing(-1.0);
  EXPECT_NE(messageFor(sphere).find("Spacing is -1"), std::string::npos);
  filter->SetSpacing(1e-12);
  EXPECT_NE(messageFor(sphere).find("more than 2^31 nodes"), std::string::npos);
  filter->SetSpacing(0.0);
  EXPECT_EQ(messageFor(sphere), "");
  vtkNew<vtkImageData> flat;
  flat->SetDimensions(5, 5, 1);
  flat->AllocateScalars(VTK_FLOAT, 1);
  EXPECT_NE(messageFor(flat).find("single layer"), std::string::npos);
  vtkNew<vtkImageData> broken;
  broken->SetDimensions(5, 5, 5);
  broken->AllocateScalars(VTK_FLOAT, 1);
  broken->GetPointData()->GetScalars()->Fill(0.0);
  broken->GetPointData()->GetScalars()->SetComponent(31, 0, std::nan(""));
  EXPECT_NE(messageFor(broken).find("node (1, 1, 1)"), std::string::npos);
  EXPECT_EQ(messageFor(vtkNew<vtkPolyData>()), "");
}
