// The vtk class: types, arrays, parameters, progress.

#include "FieldImage.h"
#include "HessianCurvatureFields.h"
#include "vtkHessianCurvature.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

using namespace isthmus::testing;

namespace
{

const std::vector<std::string> sixNames = { "GaussianCurvature", "MeanCurvature",
  "MaximumCurvature", "MinimumCurvature", "ShapeIndex", "Curvedness" };

}

TEST(HessianCurvatureFilter, EveryScalarType)
{
  const auto counts = [](double x, double y, double z)
  { return std::round(120.0 * Spheres(x, y, z)); };
  vtkNew<vtkHessianCurvature> reference;
  reference->SetInputData(SampledImage(Block(), counts));
  reference->SetScale(0.0); // smoothed values are floats
  reference->Update();
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    vtkNew<vtkHessianCurvature> filter;
    filter->SetInputData(SampledImage(Block(), counts, type));
    filter->SetScale(0.0);
    filter->Update();
    for (const std::string& name : sixNames)
    {
      vtkDataArray* values = PointArray(filter->GetOutput(), name.c_str());
      ASSERT_NE(values, nullptr);
      const bool fitsFloat = type == VTK_FLOAT || vtkDataArray::GetDataTypeSize(type) <= 2;
      EXPECT_EQ(values->GetDataType(), fitsFloat ? VTK_FLOAT : VTK_DOUBLE);
      vtkDataArray* expected = PointArray(reference->GetOutput(), name.c_str());
      for (vtkIdType id = 0; id < values->GetNumberOfTuples(); ++id)
      {
        const double exact = expected->GetComponent(id, 0);
        ASSERT_NEAR(values->GetComponent(id, 0), exact, 1e-6 * std::max(1e-3, std::abs(exact)));
      }
    }
  }
}

TEST(HessianCurvatureFilter, KeepsTheInputsArrays)
{
  const auto image = SampledImage(Rotate(Block()), Ellipsoids, VTK_FLOAT);
  vtkNew<vtkDoubleArray> other;
  other->SetName("Other");
  other->SetNumberOfTuples(image->GetNumberOfPoints());
  other->Fill(3.0);
  image->GetPointData()->AddArray(other);
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("Cells");
  cells->SetNumberOfTuples(image->GetNumberOfCells());
  cells->Fill(2.0);
  image->GetCellData()->AddArray(cells);
  vtkNew<vtkStringArray> note;
  note->SetName("Note");
  note->InsertNextValue("kept");
  image->GetFieldData()->AddArray(note);
  vtkNew<vtkImageData> before;
  before->DeepCopy(image);

  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(image);
  filter->Update();
  vtkImageData* output = filter->GetImageDataOutput();
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(output->GetPointData()->GetArray("Other"), other);
  EXPECT_EQ(output->GetCellData()->GetArray("Cells"), cells);
  EXPECT_EQ(output->GetFieldData()->GetAbstractArray("Note"), note);
  EXPECT_EQ(output->GetPointData()->GetScalars(), image->GetPointData()->GetScalars());
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(output->GetOrigin()[axis], image->GetOrigin()[axis]);
    EXPECT_EQ(output->GetSpacing()[axis], image->GetSpacing()[axis]);
    EXPECT_EQ(output->GetDirectionMatrix()->GetElement(axis, 1),
      image->GetDirectionMatrix()->GetElement(axis, 1));
  }
  EXPECT_EQ(
    image->GetPointData()->GetNumberOfArrays(), before->GetPointData()->GetNumberOfArrays());
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    ASSERT_EQ(image->GetPointData()->GetScalars()->GetComponent(id, 0),
      before->GetPointData()->GetScalars()->GetComponent(id, 0));
  }
}

TEST(HessianCurvatureFilter, EachArrayCanBeSwitched)
{
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(SampledImage(Block(), Ellipsoids));
  filter->AutomaticScaleOff();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 1 + 6 + 1);
  filter->GetOutputArraySelection()->DisableAllArrays();
  filter->GetOutputArraySelection()->EnableArray("PrincipalDirection1");
  filter->GetOutputArraySelection()->EnableArray("PrincipalDirection2");
  filter->GetOutputArraySelection()->EnableArray("SurfaceType");
  filter->Update();
  vtkPointData* data = filter->GetOutput()->GetPointData();
  EXPECT_EQ(data->GetNumberOfArrays(), 1 + 3 + 1);
  EXPECT_EQ(data->GetArray("PrincipalDirection1")->GetNumberOfComponents(), 3);
  EXPECT_EQ(data->GetArray("PrincipalDirection2")->GetNumberOfComponents(), 3);
  EXPECT_EQ(data->GetArray("SurfaceType")->GetDataType(), VTK_UNSIGNED_CHAR);
  auto* names = vtkStringArray::SafeDownCast(
    filter->GetOutput()->GetFieldData()->GetAbstractArray("SurfaceTypeNames"));
  ASSERT_NE(names, nullptr);
  EXPECT_EQ(names->GetNumberOfValues(), 9);
  EXPECT_EQ(names->GetValue(8), "Peak");
}

TEST(HessianCurvatureFilter, UnnamedAndNamedArrays)
{
  const auto image = SampledImage(Block(), Spheres);
  image->GetPointData()->GetScalars()->SetName(nullptr);
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(image);
  filter->Update();
  const double unnamed = Value(filter, "MeanCurvature", 1500);
  EXPECT_GT(unnamed, 0.0);

  const auto second = SampledImage(Block(), Ellipsoids);
  vtkSmartPointer<vtkDataArray> spheres = image->GetPointData()->GetScalars();
  spheres->SetName("Spheres");
  second->GetPointData()->AddArray(spheres);
  filter->SetInputData(second);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Spheres");
  filter->Update();
  EXPECT_EQ(Value(filter, "MeanCurvature", 1500), unnamed);
}

TEST(HessianCurvatureFilter, ProgressIsMonotoneAndStopsOnRequest)
{
  struct Watch
  {
    double Last = 0.0;
    bool Monotone = true;
    bool Stop = false;
  } watch;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&watch);
  listener->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void* fraction)
    {
      auto& w = *static_cast<Watch*>(client);
      w.Monotone = w.Monotone && *static_cast<double*>(fraction) >= w.Last;
      w.Last = *static_cast<double*>(fraction);
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(w.Stop ? 1 : 0);
    });
  for (const double scale : { 0.0, 0.1 })
  {
    watch = Watch();
    vtkNew<vtkHessianCurvature> filter;
    filter->AddObserver(vtkCommand::ProgressEvent, listener);
    filter->SetInputData(SampledImage(CenteredCube(80, 1.0), Ellipsoids));
    filter->SetScale(scale);
    filter->Update();
    EXPECT_TRUE(watch.Monotone);
    EXPECT_EQ(watch.Last, 1.0);
    watch = Watch();
    watch.Stop = true;
    filter->Modified();
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(HessianCurvatureFilter, ArraysAreChosenByTheNamesOfItsTable)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkHessianCurvature> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->SetInputData(SampledImage(Block(), Ellipsoids));
  filter->AutomaticScaleOff();
  filter->GetOutputArraySelection()->RemoveAllArrays(); // as ParaView does
  filter->GetOutputArraySelection()->EnableArray("GaussMap");
  filter->Update();
  vtkPointData* data = filter->GetOutput()->GetPointData();
  EXPECT_EQ(data->GetNumberOfArrays(), 1 + 1 + 1) << "scalars, CurvatureValid";
  EXPECT_TRUE(data->GetArray("GaussMap"));
  EXPECT_TRUE(filter->GetOutputArraySelection()->ArrayExists("ShapeIndex"));
  filter->GetOutputArraySelection()->EnableArray("Gaussian");
  filter->Update();
  EXPECT_NE(observer->GetErrorMessage().find("OutputArraySelection has Gaussian, but it must be"),
    std::string::npos);
}

TEST(HessianCurvatureFilter, PrintsItsParameters)
{
  vtkNew<vtkHessianCurvature> filter;
  std::ostringstream text;
  filter->Print(text);
  for (const char* name : { "Accuracy: 2", "Scale: 0", "InsideIsHigher: 1", "AutomaticScale: 1",
         "ShapeIndexConvention: 0", "OutputArrays: GaussianCurvature MeanCurvature",
         "MeanTolerance: 0.001" })
  {
    EXPECT_NE(text.str().find(name), std::string::npos) << name;
  }
}
