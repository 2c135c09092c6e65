// The input of vtkSurfaceCurvature: coincident points are merged, as in all filters on surfaces,
// and bad input is reported.

#include "SurfaceModels.h"
#include "vtkSurfaceCurvature.h"

#include <gtest/gtest.h>

#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTestErrorObserver.h>

#include <cstddef>
#include <limits>
#include <vector>

using namespace isthmus::testing;

namespace
{

/// Each triangle with points of its own, as in an STL file.
Model Soup(const Model& model)
{
  Model soup;
  for (const auto& triangle : model.Triangles)
  {
    const auto first = static_cast<vtkIdType>(soup.Points.size());
    for (const auto corner : triangle)
    {
      soup.Points.push_back(model.Points[static_cast<std::size_t>(corner)]);
    }
    soup.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return soup;
}

vtkSmartPointer<vtkSurfaceCurvature> ComputeCurvature(const Model& model)
{
  auto filter = vtkSmartPointer<vtkSurfaceCurvature>::New();
  filter->SetInputData(ToPolyData(model));
  filter->Update();
  return filter;
}

double Value(vtkSurfaceCurvature* filter, const char* name, vtkIdType point)
{
  return filter->GetOutput()->GetPointData()->GetArray(name)->GetComponent(point, 0);
}

double SumOfAreas(vtkSurfaceCurvature* filter)
{
  double sum = 0.0;
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    sum += Value(filter, "PointArea", i);
  }
  return sum;
}

}

TEST(vtkSurfaceCurvature, TriangleSoupsHaveTheCurvatureOfTheClosedSurface)
{
  const Model torus = Torus(24, 12, 3.0, 1.0);
  const auto closed = ComputeCurvature(torus);
  const auto soup = ComputeCurvature(Soup(torus));
  for (std::size_t t = 0; t < torus.Triangles.size(); ++t)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const auto own = static_cast<vtkIdType>(3 * t + corner);
      const auto shared = static_cast<vtkIdType>(torus.Triangles[t][corner]);
      ASSERT_EQ(Value(soup, "CurvatureValid", own), 1.0);
      for (const char* name : { "MeanCurvature", "GaussianCurvature", "MaximumCurvature" })
      {
        ASSERT_NEAR(Value(soup, name, own), Value(closed, name, shared), 1e-12) << name;
      }
    }
  }
  EXPECT_NEAR(SumOfAreas(soup), SumOfAreas(closed), 1e-10 * SumOfAreas(closed));
}

TEST(vtkSurfaceCurvature, OpenSurfacesStayOpenAndUnusedPointsAreIgnored)
{
  Model open = Icosphere(4, 2.0);
  open.Triangles.resize(open.Triangles.size() / 2);
  const auto whole = ComputeCurvature(open);
  Model soup = Soup(open);
  soup.Points.push_back({ std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0 });
  const auto taken = ComputeCurvature(soup);
  vtkIdType border = 0;
  for (std::size_t t = 0; t < open.Triangles.size(); ++t)
  {
    const auto shared = static_cast<vtkIdType>(open.Triangles[t][0]);
    ASSERT_EQ(Value(taken, "CurvatureValid", static_cast<vtkIdType>(3 * t)),
      Value(whole, "CurvatureValid", shared));
    border += Value(whole, "CurvatureValid", shared) == 0.0;
  }
  EXPECT_GT(border, 0) << "the half sphere has a border";
  EXPECT_EQ(Value(taken, "CurvatureValid", static_cast<vtkIdType>(soup.Points.size()) - 1), 0.0);
}

TEST(vtkSurfaceCurvature, ReportsBadInput)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkSurfaceCurvature> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  const auto messageFor = [&](const Model& model)
  {
    observer->Clear();
    filter->SetInputData(ToPolyData(model));
    filter->Update();
    return observer->GetErrorMessage() + observer->GetWarningMessage();
  };
  Model bad = Icosphere(2, 1.0);
  bad.Points[3][0] = std::numeric_limits<double>::infinity();
  EXPECT_NE(messageFor(bad).find("Point 3 of the surface"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);

  bad = Icosphere(2, 1.0);
  bad.Triangles.push_back(bad.Triangles[0]);
  EXPECT_NE(messageFor(bad).find("3 points have no curvature because the surface around"),
    std::string::npos);
  bad = Icosphere(2, 1.0);
  const auto corner = [&bad](int i) -> Vector&
  { return bad.Points[static_cast<std::size_t>(bad.Triangles[0][i])]; };
  corner(0) = corner(1);
  EXPECT_EQ(messageFor(bad), "") << "points that coincide are one";
  for (int a = 0; a < 3; ++a)
  {
    corner(0)[a] = 0.5 * (corner(1)[a] + corner(2)[a]);
  }
  EXPECT_NE(messageFor(bad).find("has no area"), std::string::npos);

  filter->SetRadius(-2.0);
  EXPECT_NE(messageFor(Icosphere(2, 1.0)).find("Radius is -2"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetRadius(0.0);
  EXPECT_EQ(messageFor(Model{}), "");
  EXPECT_EQ(messageFor(Icosphere(2, 1.0)), "");
}
