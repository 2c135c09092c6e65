/**
 * @file DiffusionFilterTest.h
 * @brief Images for the tests of the vtk classes, and an observer of their errors.
 */
#ifndef isthmus_DiffusionFilterTest_h
#define isthmus_DiffusionFilterTest_h

#include "vtkDiffusionAlgorithm.h"

#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace isthmus::testing
{

/// A smooth bump with some texture, between 0 and 100, on an oblique box of nodes.
inline vtkSmartPointer<vtkImageData> BumpImage(
  int type = VTK_FLOAT, int nx = 14, int ny = 12, int nz = 10)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(3, 2 + nx, -2, ny - 3, 0, nz - 1);
  image->SetSpacing(1.5, 2.0, 1.5);
  image->SetOrigin(-4.0, 1.0, 7.0);
  image->AllocateScalars(type, 1);
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  scalars->SetName("Density");
  for (vtkIdType n = 0; n < scalars->GetNumberOfTuples(); ++n)
  {
    const double x = 0.4 * double(n % nx), y = 0.5 * double(n / nx % ny),
                 z = 0.6 * double(n / nx / ny);
    const double texture = double((n * 7919) % 101) / 5.0;
    scalars->SetTuple1(n, 40.0 + 30.0 * std::sin(x) * std::cos(y + z) + texture);
  }
  return image;
}

/// A filter whose errors are collected instead of printed.
template <typename Filter>
class Listened
{
public:
  explicit Listened(vtkImageData* input)
  {
    this->Object->SetInputData(input);
    this->Object->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    // The pipeline adds a message of its own when a request fails.
    this->Object->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->PipelineObserver);
  }

  Filter* operator->() { return this->Object; }

  vtkImageData* Update()
  {
    this->Object->Update();
    return this->Object->GetOutput();
  }

  vtkDataArray* Result() { return this->Update()->GetPointData()->GetScalars(); }

  /// The error message of the update; empty if there is none. Then the output must be empty.
  std::string Complaint()
  {
    this->Observer->Clear();
    return this->Update()->GetNumberOfPoints() == 0 ? this->Observer->GetErrorMessage()
                                                    : std::string();
  }

private:
  vtkNew<Filter> Object;
  vtkNew<vtkTest::ErrorObserver> Observer, PipelineObserver;
};

/// Values of an array as doubles.
inline std::vector<double> Values(vtkDataArray* array)
{
  std::vector<double> values;
  for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n)
  {
    values.push_back(array->GetTuple1(n));
  }
  return values;
}

/// `Filter`: a Listened.
template <typename Filter>
void ExpectTakesASliceAndNamesInvalidValues()
{
  const auto slice = BumpImage(VTK_FLOAT, 14, 12, 1);
  Filter filter(slice);
  const std::vector<double> values = Values(filter.Result());
  EXPECT_EQ(values.size(), 168u);
  EXPECT_TRUE(
    std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }));
  slice->SetScalarComponentFromDouble(5, 1, 0, 0, std::nan(""));
  EXPECT_NE(Filter(slice).Complaint().find("node (5, 1, 0)"), std::string::npos);
}

}

#endif
