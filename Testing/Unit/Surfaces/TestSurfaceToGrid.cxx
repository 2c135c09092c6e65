// The vtk class: surfaces and levels on grids, threads, and its messages for invalid input.

#include "GridChecks.h"
#include "SurfaceModels.h"
#include "vtkSurfaceToGrid.h"

#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

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
  filter->SetInputData(ToPolyData(Translate(Icosphere(20, 2.0), 10.0, -20.0, 30.0)));
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
  double center[3];
  double index[3] = { 13.0, 22.0, 16.0 };
  grid->TransformContinuousIndexToPhysicalPoint(index, center);
  filter->SetInputData(
    0, ToPolyData(Translate(Icosphere(20, 1.5), center[0], center[1], center[2])));
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
    const double exact = std::sqrt(vtkMath::Distance2BetweenPoints(x, center)) - 1.5;
    EXPECT_NEAR(Nodes(filter, "SignedDistance")->GetComponent(i, 0), exact, 6e-3);
  }
  vtkPolyData* crossings = filter->GetCrossings();
  ASSERT_GT(crossings->GetNumberOfPoints(), 100);
  for (vtkIdType i = 0; i < crossings->GetNumberOfPoints(); ++i)
  {
    double outward[3];
    vtkMath::Subtract(crossings->GetPoint(i), center, outward);
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
  filter->SetLevel(1.73);
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

// vtkFlyingEdges3D takes differences in the type of the scalars, where those of unsigned int wrap.
TEST(vtkSurfaceToGrid, LevelsOfAnyScalarType)
{
  std::vector<double> expected;
  for (const int type : { VTK_DOUBLE, VTK_FLOAT, VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_INT,
         VTK_UNSIGNED_INT, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(12, 11, 13);
    image->AllocateScalars(type, 1);
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      const double* x = image->GetPoint(i);
      const double distance = std::hypot(x[0] - 5.0, x[1] - 5.0, x[2] - 6.0);
      image->GetPointData()->GetScalars()->SetComponent(i, 0, std::floor(200.0 / (1.0 + distance)));
    }
    vtkNew<vtkSurfaceToGrid> filter;
    filter->SetInputData(image);
    filter->SetLevel(50.0);
    filter->Update();
    vtkDataArray* distance = Nodes(filter, "SignedDistance");
    ASSERT_EQ(distance->GetNumberOfTuples(), image->GetNumberOfPoints());
    for (vtkIdType i = 0; i < distance->GetNumberOfTuples(); ++i)
    {
      const double value = distance->GetComponent(i, 0);
      if (type == VTK_DOUBLE)
      {
        expected.push_back(value);
      }
      ASSERT_NEAR(value, expected[static_cast<std::size_t>(i)], 1e-6) << "type " << type;
    }
  }
}

// Points that no triangle uses do not count: one far away made a grid that filled the memory.
TEST(vtkSurfaceToGrid, UnusedPointsDoNotCount)
{
  const auto sphere = ToPolyData(Icosphere(6, 1.0));
  vtkNew<vtkSurfaceToGrid> filter;
  filter->SetInputData(sphere);
  filter->Update();
  double expected[6];
  filter->GetOutput()->GetBounds(expected);
  sphere->GetPoints()->InsertNextPoint(1e6, -2e6, 3e6);
  sphere->Modified();
  filter->Modified();
  filter->Update();
  double bounds[6];
  filter->GetOutput()->GetBounds(bounds);
  for (std::size_t i = 0; i < 6; ++i)
  {
    EXPECT_DOUBLE_EQ(bounds[i], expected[i]);
  }
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 69 * 69 * 69);
}

TEST(vtkSurfaceToGrid, IdenticalOnAnyNumberOfThreads)
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

TEST(vtkSurfaceToGrid, ReportsBadInput)
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
  filter->GetOutputArraySelection()->DisableAllArrays();
  EXPECT_EQ(messageFor(ToPolyData(open)), "");
  EXPECT_GT(filter->GetCrossings()->GetNumberOfPoints(), 0);
  filter->GetOutputArraySelection()->EnableArray("Inside");
  filter->SetSpacing(-1.0);
  EXPECT_NE(messageFor(sphere).find("Spacing is -1"), std::string::npos);
  filter->SetSpacing(1e-5);
  EXPECT_NE(messageFor(sphere).find("nodes needs about "), std::string::npos);
  filter->SetSpacing(1e-12);
  EXPECT_NE(messageFor(sphere).find("more than 2^31 nodes"), std::string::npos);
  filter->SetSpacing(0.0);
  filter->SetPadding(-1);
  EXPECT_NE(messageFor(sphere).find("Padding is -1, but it must be from 0"), std::string::npos);
  filter->SetPadding(2);
  filter->SetNormalMode(2);
  EXPECT_NE(messageFor(sphere).find("NormalMode is 2, but it must be"), std::string::npos);
  filter->SetNormalMode(vtkSurfaceToGrid::TriangleNormals);
  filter->SetBandWidth(0.5);
  EXPECT_NE(messageFor(sphere).find("BandWidth is 0.5, but it must be"), std::string::npos);
  filter->SetBandWidth(2.0);
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
