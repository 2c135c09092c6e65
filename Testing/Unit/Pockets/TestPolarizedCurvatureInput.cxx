// Potential times curvature: points off the grid, arrays of any type, threads, missing input.

#include "PolarizedTrial.h"

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace isthmus::testing;

TEST(PolarizedCurvature, PointsOffTheGridAreMarkedNotZero)
{
  const auto sphere = Ellipsoid(5.0, 5.0, 5.0, 30);
  Trial run(sphere, Image(4.0, 20, [](const double*) { return 1.0; }));
  vtkPolyData* output = run.Update();
  EXPECT_NE(run.Observer->GetWarningMessage().find("lie outside the grid"), std::string::npos);
  vtkIdType off = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double* p = output->GetPoint(i);
    const bool inside = std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) }) <= 4.0 + 1e-9;
    EXPECT_EQ(Value(output, "PotentialValid", i), inside ? 1.0 : 0.0);
    EXPECT_EQ(std::isnan(Value(output, "Potential", i)), !inside);
    EXPECT_EQ(std::isnan(Value(output, "PolarizedCurvature", i)), !inside);
    EXPECT_EQ(Value(output, "SiteClass", i), inside ? 1.0 : 0.0);
    off += inside ? 0 : 1;
  }
  EXPECT_GT(off, 0);
  EXPECT_LT(off, output->GetNumberOfPoints());
}

TEST(PolarizedCurvature, ThePotentialMayBeAnArrayOfTheSurfaceAndOfAnyType)
{
  auto sphere = Ellipsoid(5.0, 5.0, 5.0, 20);
  vtkNew<vtkFloatArray> phi;
  phi->SetName("Potential");
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    phi->InsertNextValue(i % 2 ? -2.0f : std::nanf(""));
  }
  sphere->GetPointData()->AddArray(phi);
  Trial run(sphere, nullptr);
  vtkPolyData* output = run.Update();
  EXPECT_EQ(run.Error(), "");
  EXPECT_NE(run.Observer->GetWarningMessage().find("potential that is not a finite number"),
    std::string::npos);
  EXPECT_NEAR(Value(output, "PolarizedCurvature", 41), -0.4, 1e-6);
  EXPECT_EQ(Value(output, "PotentialValid", 2), 0.0);
  // The input's own array is left as it was.
  EXPECT_EQ(sphere->GetPointData()->GetArray("Potential"), phi);
  EXPECT_EQ(sphere->GetPointData()->GetArray("PolarizedCurvature"), nullptr);
}

TEST(PolarizedCurvature, ReportsMissingInput)
{
  const auto image = Image(8.0, 10, [](const double*) { return 1.0; });
  const auto sphere = Ellipsoid(5.0, 5.0, 5.0, 10);
  {
    Trial run(sphere, nullptr);
    EXPECT_EQ(run.Update()->GetNumberOfPoints(), 0);
    EXPECT_NE(run.Error().find("as an image on the second input"), std::string::npos)
      << run.Error();
  }
  {
    vtkNew<vtkPolyData> bare;
    bare->SetPoints(sphere->GetPoints());
    bare->SetPolys(sphere->GetPolys());
    Trial run(bare, image);
    EXPECT_EQ(run.Update()->GetNumberOfPoints(), 0);
    EXPECT_NE(run.Error().find("MaximumCurvature: run Surface Curvature"), std::string::npos)
      << run.Error();
  }
  {
    const auto far = Image(8.0, 10, [](const double*) { return 1.0; });
    far->SetOrigin(100.0, 0.0, 0.0);
    Trial run(sphere, far);
    EXPECT_EQ(run.Update()->GetNumberOfPoints(), 0);
    EXPECT_NE(run.Error().find("do not overlap"), std::string::npos) << run.Error();
    double box[6], origin[3];
    far->GetBounds(box);
    far->GetOrigin(origin); // to be moved close to the sphere
    far->SetOrigin(origin[0] + 5.1 - box[0], origin[1] - 8.0 - box[2], origin[2] - 8.0 - box[4]);
    Trial beside(sphere, far);
    EXPECT_EQ(beside.Update()->GetNumberOfPoints(), 0);
    EXPECT_NE(beside.Error().find("does not overlap the surface"), std::string::npos)
      << beside.Error();
  }
  {
    vtkNew<vtkImageData> bare;
    bare->SetDimensions(3, 3, 3);
    Trial run(sphere, bare);
    EXPECT_EQ(run.Update()->GetNumberOfPoints(), 0);
    EXPECT_NE(run.Error().find("image's point arrays"), std::string::npos) << run.Error();
  }
  {
    Trial run(sphere, image);
    run.Filter->SetPotentialArrayName("phi");
    EXPECT_EQ(run.Update()->GetNumberOfPoints(), 0);
    EXPECT_NE(run.Error().find("no point array phi"), std::string::npos) << run.Error();
  }
  {
    const auto infinite = Ellipsoid(5.0, 5.0, 5.0, 10);
    vtkNew<vtkDoubleArray> phi;
    phi->SetName("Potential");
    phi->SetNumberOfTuples(infinite->GetNumberOfPoints());
    phi->Fill(HUGE_VAL);
    infinite->GetPointData()->AddArray(phi);
    Trial run(infinite, nullptr);
    EXPECT_EQ(run.Update()->GetNumberOfPoints(), 0);
    EXPECT_NE(run.Error().find("No value of the potential"), std::string::npos) << run.Error();
  }
  vtkNew<vtkPolyData> empty;
  Trial run(empty, image);
  EXPECT_EQ(run.Update()->GetNumberOfPoints(), 0);
  EXPECT_EQ(run.Error(), "");
}

TEST(PolarizedCurvature, AnAbortLeavesAnEmptyOutput)
{
  Trial run(Ellipsoid(5.0, 5.0, 5.0, 40), DipoleImage());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  run.Filter->AddObserver(vtkCommand::ProgressEvent, stop);
  EXPECT_EQ(run.Update()->GetNumberOfPoints(), 0);
  EXPECT_EQ(run.Error(), "");
}

TEST(PolarizedCurvature, IdenticalOnAnyNumberOfThreadsAndForIntegers)
{
  // A potential of whole numbers, and the same as double: the same products.
  const auto sphere = Ellipsoid(5.0, 4.0, 3.0, 60);
  const auto image = Image(6.0, 25, [](const double* p) { return std::round(3.0 * p[0] - p[2]); });
  const auto products = [&](vtkImageData* potential, int threads)
  {
    vtkNew<vtkDoubleArray> result;
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, std::string("STDThread"), false },
      [&]()
      {
        Trial run(sphere, potential);
        result->DeepCopy(run.Update()->GetPointData()->GetArray("PolarizedCurvature"));
      });
    return std::vector<double>(
      result->GetPointer(0), result->GetPointer(0) + result->GetNumberOfValues());
  };
  vtkNew<vtkImageData> whole;
  whole->CopyStructure(image);
  vtkNew<vtkIntArray> values;
  values->DeepCopy(image->GetPointData()->GetScalars());
  values->SetName("AnyName");
  whole->GetPointData()->SetScalars(values);
  const std::vector<double> expected = products(image, 1);
  EXPECT_EQ(products(image, 4), expected);
  EXPECT_EQ(products(whole, 2), expected);
}

TEST(PolarizedCurvature, AConstantPotentialOfZeroHasNoClass)
{
  Trial run(Ellipsoid(5.0, 4.0, 3.0, 20), Image(8.0, 10, [](const double*) { return 0.0; }));
  vtkPolyData* output = run.Update();
  EXPECT_EQ(run.Error(), "");
  double range[2];
  output->GetPointData()->GetArray("SiteClass")->GetRange(range);
  EXPECT_EQ(range[1], 0.0);
}
