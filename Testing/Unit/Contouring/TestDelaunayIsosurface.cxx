#include "Contouring/DelaunayIsosurface.h"

#include "Contouring/ClosedLevelSet.h"
#include "SharedData.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"
#include "TriangleAngles.h"
#include "vtkDelaunayIsosurface.h"
#include "vtkMRCMapReader.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <chrono>

using namespace isthmus;
using isthmus::testing::TriangleAngles;

namespace
{

/// Samples `f(x, y, z)` on a grid of n^3 nodes over [-1, 1]^3.
template <typename Array = vtkFloatArray, typename Function>
vtkSmartPointer<vtkImageData> SampleImage(int n, Function&& f)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  const double h = 2.0 / (n - 1);
  image->SetSpacing(h, h, h);
  image->SetOrigin(-1, -1, -1);
  vtkNew<Array> values;
  values->SetName("Density");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    values->InsertNextValue(static_cast<typename Array::ValueType>(f(p[0], p[1], p[2])));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

double Ball(double x, double y, double z, double cx, double cy, double cz, double r)
{
  return r - std::sqrt((x - cx) * (x - cx) + (y - cy) * (y - cy) + (z - cz) * (z - cz));
}

struct Topology
{
  int Components = 0;
  std::int64_t Genus = 0;
};

Topology DescribeTopology(const TriangleMesh& mesh)
{
  const std::vector<int> labels = Components(mesh);
  Topology result;
  result.Components = labels.empty() ? 0 : *std::max_element(labels.begin(), labels.end()) + 1;
  result.Genus = result.Components - EulerCharacteristic(mesh) / 2;
  return result;
}

/// Distance of `p` to the level set, to a thousandth of `step`: the nearest change of side along
/// the gradient and along `normal`, within three steps.
double DistanceToLevel(
  const ScalarField& field, double level, const Point3& p, const Point3& normal, double step)
{
  Point3 gradient{};
  for (std::size_t a = 0; a < 3; ++a)
  {
    Point3 e{};
    e[a] = 0.05 * step;
    gradient[a] = field(p + e) - field(p - e);
  }
  double best = 3.0 * step;
  for (const Point3& direction :
    { gradient, normal, Point3{ 1, 0, 0 }, Point3{ 0, 1, 0 }, Point3{ 0, 0, 1 } })
  {
    const double length = std::sqrt(Dot(direction, direction));
    const bool inside = field(p) > level;
    for (const double sign : { -1.0, 1.0 })
    {
      const Point3 d = (sign / length) * direction;
      for (double s = 0.0; length > 0.0 && s < best; s += 0.002 * step)
      {
        if ((field(p + s * d) > level) != inside)
        {
          best = s;
          break;
        }
      }
    }
  }
  return best;
}

struct Deviation
{
  double Percentile95 = 0.0;
  double Maximum = 0.0;
};

/// The deviation of the centers and edge midpoints of (at most 3000 of) the triangles.
Deviation DeviationFrom(const ClosedLevelSet& set, double level, const TriangleMesh& mesh, double h)
{
  std::vector<double> distances;
  const std::size_t step = std::max<std::size_t>(1, mesh.Triangles.size() / 3000);
  for (std::size_t i = 0; i < mesh.Triangles.size(); i += step)
  {
    const auto at = [&](std::size_t c)
    { return mesh.Points[static_cast<std::size_t>(mesh.Triangles[i][c])]; };
    const Point3 n = Cross(at(1) - at(0), at(2) - at(0));
    for (const Point3& p : { (1.0 / 3.0) * (at(0) + at(1) + at(2)), 0.5 * (at(0) + at(1)),
           0.5 * (at(1) + at(2)), 0.5 * (at(2) + at(0)) })
    {
      distances.push_back(DistanceToLevel(set.Field, level, p, n, h));
    }
  }
  std::sort(distances.begin(), distances.end());
  return { distances[distances.size() * 95 / 100], distances.back() };
}

DelaunayIsosurfaceResult Isosurface(const ClosedLevelSet& set, double level, double h)
{
  DelaunayIsosurfaceParameters parameters;
  parameters.Level = level;
  parameters.Radius = 1.5 * h;
  parameters.Distance = 0.25 * h;
  return DelaunayIsosurface(set.Field, set.Bounds, set.Guide, parameters);
}

}

TEST(DelaunayIsosurface, SphereHasItsAnglesItsTopologyAndItsVolume)
{
  const auto image =
    SampleImage(41, [](double x, double y, double z) { return Ball(x, y, z, 0, 0, 0, 0.7); });
  vtkNew<vtkDelaunayIsosurface> filter;
  filter->SetInputData(image);
  filter->SetLevel(0.0);
  filter->Update();
  const auto set = CloseLevelSet(image, image->GetPointData()->GetScalars(), 0.0, true);
  const auto result = Isosurface(set, 0.0, 0.05);
  EXPECT_EQ(result.Warning, "");
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(),
    static_cast<vtkIdType>(result.Surface.Triangles.size()));
  EXPECT_TRUE(FindDefects(result.Surface).None());
  EXPECT_EQ(DescribeTopology(result.Surface).Components, 1);
  EXPECT_EQ(DescribeTopology(result.Surface).Genus, 0);
  EXPECT_GE(TriangleAngles(result.Surface).Smallest, 30.0);
  EXPECT_NEAR(SignedVolume(result.Surface), 4.0 / 3.0 * 3.14159265 * 0.343, 0.02);
  double bounds[6];
  filter->GetOutput()->GetBounds(bounds);
  EXPECT_NEAR(bounds[0], -0.7, 0.01);
  EXPECT_NEAR(bounds[5], 0.7, 0.01);
}

TEST(DelaunayIsosurface, SmallComponentsAreNotLost)
{
  const auto image = SampleImage(61,
    [](double x, double y, double z)
    {
      return std::max({ Ball(x, y, z, -0.3, 0, 0, 0.55), Ball(x, y, z, 0.7, 0.7, 0.7, 0.06),
        Ball(x, y, z, 0.6, -0.6, 0.2, 0.05), Ball(x, y, z, 0.7, 0.1, -0.8, 0.1) });
    });
  const auto set = CloseLevelSet(image, image->GetPointData()->GetScalars(), 0.0, true);
  const auto result = Isosurface(set, 0.0, 2.0 / 60);
  EXPECT_EQ(result.Warning, "");
  EXPECT_EQ(DescribeTopology(result.Surface).Components, 4);
  EXPECT_GE(TriangleAngles(result.Surface).Smallest, 30.0);
}

TEST(DelaunayIsosurface, SurfacesThatLeaveTheVolumeAreClosed)
{
  const auto image = SampleImage<vtkDoubleArray>(
    31, [](double x, double y, double z) { return Ball(x, y, z, 0.8, 0, 0, 0.6); });
  const auto set = CloseLevelSet(image, image->GetPointData()->GetScalars(), 0.0, true);
  const auto result = Isosurface(set, 0.0, 2.0 / 30);
  EXPECT_TRUE(FindDefects(result.Surface).None());
  EXPECT_EQ(DescribeTopology(result.Surface).Components, 1);
  EXPECT_GT(SignedVolume(result.Surface), 0.0);
}

TEST(DelaunayIsosurface, LowerInsideFacesAwayFromIt)
{
  const auto image =
    SampleImage(31, [](double x, double y, double z) { return -Ball(x, y, z, 0, 0, 0, 0.6); });
  vtkNew<vtkDelaunayIsosurface> filter;
  filter->SetInputData(image);
  filter->InsideIsHigherOff();
  filter->SetLevel(0.0);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 100);
  double bounds[6];
  filter->GetOutput()->GetBounds(bounds);
  EXPECT_NEAR(bounds[1], 0.6, 0.02);
}

TEST(DelaunayIsosurface, IntegersAnisotropyAndMirroredAxesWork)
{
  const auto image = SampleImage<vtkUnsignedCharArray>(31,
    [](double x, double y, double z) { return 200.0 * (0.5 + Ball(x, y, z, 0, 0, 0, 0.6) / 4.0); });
  image->SetSpacing(1.0, 1.5, 2.0);
  image->SetDirectionMatrix(1, 0, 0, 0, -1, 0, 0, 0, 1);
  vtkNew<vtkDelaunayIsosurface> filter;
  filter->SetInputData(image);
  filter->SetLevel(100.5);
  filter->Update();
  ASSERT_GT(filter->GetOutput()->GetNumberOfCells(), 100);
  double bounds[6];
  filter->GetOutput()->GetBounds(bounds);
  EXPECT_NEAR(bounds[2], -1.0 - 24.0 * 1.5, 1.0);
  EXPECT_NEAR(bounds[5], -1.0 + 24.0 * 2.0, 1.5);
}

/// Such integers were rounded to numbers of type float: nothing was found, or another level.
TEST(DelaunayIsosurface, IntegersBeyondFloatAreExact)
{
  const auto cellsOf = [](vtkImageData* image, double level)
  {
    vtkNew<vtkDelaunayIsosurface> filter;
    filter->SetInputData(image);
    filter->SetLevel(level);
    filter->Update();
    return filter->GetOutput()->GetNumberOfCells();
  };
  for (const double offset : { 0.0, 1e9, 1e15 })
  {
    const auto at = [offset](double x, double y, double z)
    { return offset + std::round(3000.0 * Ball(x, y, z, 0, 0, 0, 0.6)); };
    const auto expected = cellsOf(SampleImage<vtkDoubleArray>(31, at), offset + 0.5);
    EXPECT_GT(expected, 100);
    EXPECT_EQ(cellsOf(SampleImage<vtkTypeInt64Array>(31, at), offset + 0.5), expected) << offset;
    if (offset < 2e9)
    {
      EXPECT_EQ(cellsOf(SampleImage<vtkIntArray>(31, at), offset + 0.5), expected) << offset;
    }
  }
}

TEST(DelaunayIsosurface, EmptyInputGivesEmptyOutput)
{
  const auto image = SampleImage(11, [](double, double, double) { return 1.0; });
  vtkNew<vtkDelaunayIsosurface> filter;
  filter->SetInputData(image);
  filter->SetLevel(2.0);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetErrorCode(), 0u);
}

TEST(DelaunayIsosurface, BadParametersAndValuesAreReported)
{
  auto image =
    SampleImage(11, [](double x, double y, double z) { return Ball(x, y, z, 0, 0, 0, 0.6); });
  auto* scalars = image->GetPointData()->GetScalars();
  const auto set = CloseLevelSet(image, scalars, 0.0, true);
  DelaunayIsosurfaceParameters wrong;
  EXPECT_THROW(DelaunayIsosurface(set.Field, set.Bounds, set.Guide, wrong), std::invalid_argument)
    << "without sizes";
  SetAutomaticSizes(0.2, wrong);
  wrong.Angle = 40.0;
  EXPECT_THROW(DelaunayIsosurface(set.Field, set.Bounds, set.Guide, wrong), std::invalid_argument);
  for (const double allowed : { 0.0, 30.0 })
  {
    DelaunayIsosurfaceParameters coarse;
    coarse.Angle = allowed;
    coarse.Radius = coarse.Distance = 0.5;
    EXPECT_GT(
      DelaunayIsosurface(set.Field, set.Bounds, set.Guide, coarse).Surface.Triangles.size(), 3u);
  }
  // The least value is a millionth of the diagonal, in any unit.
  const double diagonal = set.Bounds.Diagonal();
  for (const double part : { 0.9e-6, 1.1e-6 })
  {
    DelaunayIsosurfaceParameters finest;
    finest.Radius = 0.5;
    finest.Distance = part * diagonal;
    finest.MaximumNumberOfPoints = 4;
    try
    {
      DelaunayIsosurface(set.Field, set.Bounds, set.Guide, finest);
      ADD_FAILURE() << "not refused";
    }
    catch (const std::runtime_error& refusal)
    {
      const bool tooFine = std::string(refusal.what()).find("millionth") != std::string::npos;
      EXPECT_EQ(tooFine, part < 1e-6) << refusal.what();
    }
  }
  DelaunayIsosurfaceParameters fine;
  fine.Radius = fine.Distance = 0.01;
  fine.MaximumNumberOfPoints = 300;
  EXPECT_THROW(DelaunayIsosurface(set.Field, set.Bounds, set.Guide, fine), std::runtime_error);
  EXPECT_THROW(
    DelaunayIsosurface(set.Field, set.Bounds, set.Guide, fine, [](double) { return false; }),
    Cancelled);
  scalars->SetComponent(5, 0, std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(CloseLevelSet(image, scalars, 0.0, true), std::invalid_argument);
}

/// Acceptance 2. Levels: GroEL by Otsu's rule; EMD-1832 at three standard
/// deviations above the mean; EMD-1155, all noise there, at six, half way between two integers.
TEST(DelaunayIsosurface, RealMapsKeepTheirBoundsAndTopology)
{
  struct Map
  {
    const char* File;
    double Level;
  };
  for (const Map& map :
    { Map{ "emd_5043.map", 2.4 }, Map{ "emd_1832.map", 0.46 }, Map{ "emd_1155.ccp4", 80.5 } })
  {
    ISTHMUS_NEEDS_SHARED_DATA(std::string("maps/") + map.File);
    SCOPED_TRACE(map.File);
    vtkNew<vtkMRCMapReader> reader;
    reader->SetFileName((isthmus::testing::SharedDataFolder() / "maps" / map.File).c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    const double* spacing = image->GetSpacing();
    const double h = std::min({ spacing[0], spacing[1], spacing[2] });

    const auto seconds = [start = std::chrono::steady_clock::now()]() mutable
    {
      const auto now = std::chrono::steady_clock::now();
      const double passed = std::chrono::duration<double>(now - start).count();
      start = now;
      return passed;
    };
    auto clock = seconds;
    const auto set = CloseLevelSet(image, image->GetPointData()->GetScalars(), map.Level, true);
    const double guideSeconds = clock();
    const auto result = Isosurface(set, map.Level, h);
    const double mySeconds = clock();

    const Topology mine = DescribeTopology(result.Surface);
    const Topology theirs = DescribeTopology(set.Guide);
    const Deviation near = DeviationFrom(set, map.Level, result.Surface, h);
    const Deviation guideNear = DeviationFrom(set, map.Level, set.Guide, h);
    const TriangleAngles angles(result.Surface);
    const TriangleAngles guideAngles(set.Guide);
    std::printf("%s at %g, spacing %.3g\n", map.File, map.Level, h);
    const auto row = [h](const char* name, const TriangleMesh& mesh, const Topology& topology,
                       const TriangleAngles& q, const Deviation& d, double time)
    {
      std::printf("  %-9s %7zu triangles, %d components, genus %d, angles %.2f to %.2f, deviation "
                  "95%% %.4f, max %.4f spacings, %.2f s\n",
        name, mesh.Triangles.size(), topology.Components, static_cast<int>(topology.Genus),
        q.Smallest, q.Largest, d.Percentile95 / h, d.Maximum / h, time);
    };
    row("cubes", set.Guide, theirs, guideAngles, guideNear, guideSeconds);
    row("Delaunay", result.Surface, mine, angles, near, mySeconds);
    EXPECT_EQ(result.Warning, "");
    EXPECT_TRUE(FindDefects(result.Surface).None());
    EXPECT_EQ(mine.Components, theirs.Components);
    EXPECT_EQ(mine.Genus, theirs.Genus);
    EXPECT_GE(angles.Smallest, 30.0);
    EXPECT_LE(near.Percentile95, 0.25 * h);
    EXPECT_LE(near.Maximum, 1.25 * h);
    EXPECT_LT(result.Surface.Triangles.size(), set.Guide.Triangles.size());
  }
}
