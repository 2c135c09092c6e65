// The vtk class with requests for pieces, and its errors for bad input.

#include "FieldImage.h"
#include "HessianCurvatureFields.h"
#include "vtkHessianCurvature.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkImageAlgorithm.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRTAnalyticSource.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace isthmus::testing;

/// Any requested part has the same values as the whole, with and without smoothing.
TEST(HessianCurvatureFilter, PiecesMatchTheWhole)
{
  for (const double scale : { 0.0, 1.5 })
  {
    vtkNew<vtkRTAnalyticSource> source;
    source->SetWholeExtent(-10, 12, -9, 11, -8, 13);
    vtkNew<vtkHessianCurvature> whole;
    whole->SetInputConnection(source->GetOutputPort());
    whole->SetScale(scale);
    whole->Update();
    vtkNew<vtkRTAnalyticSource> again;
    again->SetWholeExtent(-10, 12, -9, 11, -8, 13);
    vtkNew<vtkHessianCurvature> part;
    part->SetInputConnection(again->GetOutputPort());
    part->SetScale(scale);
    const int asked[6] = { -10, 1, 2, 9, 5, 13 };
    part->UpdateExtent(asked);
    vtkImageData* piece = part->GetImageDataOutput();
    for (int i = 0; i < 6; ++i)
    {
      EXPECT_EQ(piece->GetExtent()[i], asked[i]);
    }
    EXPECT_LT(again->GetOutput()->GetNumberOfPoints(), source->GetOutput()->GetNumberOfPoints())
      << "the rest is not asked for";
    for (vtkIdType id = 0; id < piece->GetNumberOfPoints(); ++id)
    {
      const vtkIdType other = whole->GetOutput()->FindPoint(piece->GetPoint(id));
      ASSERT_EQ(Value(part, "CurvatureValid", id), Value(whole, "CurvatureValid", other));
      const double expected = Value(whole, "MeanCurvature", other);
      ASSERT_NEAR(Value(part, "MeanCurvature", id), expected, 1e-6 * std::abs(expected));
    }
  }
}

namespace
{

/// A source that returns the same half of its image whatever is requested.
class HalfSource : public vtkImageAlgorithm
{
public:
  static HalfSource* New() { VTK_STANDARD_NEW_BODY(HalfSource); }
  vtkTypeMacro(HalfSource, vtkImageAlgorithm);

protected:
  HalfSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    int whole[6] = { 0, 16, 0, 16, 0, 16 };
    outputVector->GetInformationObject(0)->Set(
      vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole, 6);
    return 1;
  }

  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    Lattice lattice = CenteredCube(17, 1.0);
    lattice.Dimensions[2] = 9;
    vtkImageData::GetData(outputVector)->ShallowCopy(SampledImage(lattice, Ellipsoids));
    return 1;
  }
};

}

TEST(HessianCurvatureFilter, ASourceWithATooSmallExtentIsUpdatedTwice)
{
  vtkNew<HalfSource> source;
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->UpdatePiece(0, 2, 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 17 * 17 * 9);
  EXPECT_EQ(Value(filter, "CurvatureValid", 17 * 17 * 8 + 17 * 8 + 8), 0.0);
  EXPECT_EQ(Value(filter, "CurvatureValid", 17 * 17 * 7 + 17 * 8 + 4), 1.0);
}

namespace
{

/// Runs the filter on `image` and returns its error, checking that the output is empty.
std::string RecordError(vtkHessianCurvature* filter, vtkDataObject* image)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTest::ErrorObserver> executive;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executive);
  filter->SetInputDataObject(0, image);
  filter->Update();
  vtkDataSet* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(output->GetNumberOfPoints(), 0);
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 0);
  filter->RemoveAllObservers();
  return observer->GetErrorMessage();
}

}

/// A surface around the volume overlaps with it by its box, but has no point in it.
TEST(HessianCurvatureFilter, SurfacesOutsideTheVolumeAreErrorsOrWarnings)
{
  const auto image = SampledImage(CenteredCube(17, 1.0), Ellipsoids);
  const auto surface = [](int inside, int outside)
  {
    auto points = vtkSmartPointer<vtkPoints>::New();
    for (int i = 0; i < inside + outside; ++i)
    {
      const double side = i < inside ? 0.5 : 5.0;
      points->InsertNextPoint(i % 2 == 0 ? side : -side, i / 2 % 2 == 0 ? side : -side, 0.1);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    return data;
  };
  for (const int outside : { 3, 5, 8 })
  {
    vtkNew<vtkHessianCurvature> filter;
    vtkNew<vtkTest::ErrorObserver> observer;
    filter->AddObserver(vtkCommand::ErrorEvent, observer);
    filter->AddObserver(vtkCommand::WarningEvent, observer);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
    filter->SetInputData(0, image);
    filter->SetInputData(1, surface(8 - outside, outside));
    filter->Update();
    const std::string said = observer->GetErrorMessage() + observer->GetWarningMessage();
    EXPECT_EQ(observer->GetWarning(), outside == 5) << said;
    EXPECT_EQ(observer->GetError(), outside == 8) << said;
    EXPECT_EQ(said.find(std::to_string(outside) + " of 8 points") != std::string::npos, outside > 4)
      << said;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), outside == 8 ? 0 : 8);
  }
}

TEST(HessianCurvatureFilter, BadParametersAreNamed)
{
  const auto image = SampledImage(Block(), Spheres);
  vtkNew<vtkHessianCurvature> filter;
  filter->SetAccuracy(3);
  EXPECT_NE(RecordError(filter, image).find("Accuracy is 3"), std::string::npos);
  filter->SetAccuracy(2);
  filter->SetScale(-1.0);
  EXPECT_NE(RecordError(filter, image).find("Scale is -1"), std::string::npos);
  filter->SetScale(std::nan(""));
  EXPECT_NE(RecordError(filter, image).find("Scale is not a number"), std::string::npos);
  filter->SetScale(0.0);
  filter->SetMeanTolerance(-0.1);
  EXPECT_NE(RecordError(filter, image).find("MeanTolerance is -0.1"), std::string::npos);
  filter->SetMeanTolerance(0.001);
  filter->SetShapeIndexConvention(2);
  EXPECT_NE(RecordError(filter, image).find("ShapeIndexConvention is 2"), std::string::npos);
}

TEST(HessianCurvatureFilter, ReportsBadInput)
{
  vtkNew<vtkHessianCurvature> filter;
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(5, 5, 5);
  EXPECT_NE(RecordError(filter, bare).find("no active scalars"), std::string::npos);

  vtkNew<vtkImageData> colours;
  colours->SetDimensions(5, 5, 5);
  colours->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  colours->GetPointData()->GetScalars()->SetName("Colours");
  EXPECT_NE(
    RecordError(filter, colours).find("Array 'Colours' has 3 components"), std::string::npos);

  vtkNew<vtkDoubleArray> brief;
  brief->SetName("Brief");
  brief->SetNumberOfTuples(7);
  brief->Fill(1.0);
  bare->GetPointData()->SetScalars(brief);
  EXPECT_NE(
    RecordError(filter, bare).find("array 'Brief' has 7 values for the 125"), std::string::npos);

  const auto image = SampledImage(Block(), Spheres);
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("Cells");
  cells->SetNumberOfTuples(image->GetNumberOfCells());
  cells->Fill(1.0);
  image->GetCellData()->AddArray(cells);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Cells");
  EXPECT_NE(RecordError(filter, image).find("Array 'Cells' is not on points"), std::string::npos);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Absent");
  EXPECT_NE(
    RecordError(filter, image).find("no array 'Absent' to work on; its point arrays are: '"),
    std::string::npos);
}

TEST(HessianCurvatureFilter, SurfaceWithoutAVolume)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(1, surface);
  vtkNew<vtkImageData> empty;
  EXPECT_NE(RecordError(filter, empty).find("The image is empty"), std::string::npos);

  vtkNew<vtkHessianCurvature> unconnected;
  vtkNew<vtkTest::ErrorObserver> observer;
  unconnected->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  unconnected->SetInputData(1, surface);
  unconnected->Update();
  EXPECT_TRUE(observer->GetError()) << "VTK's own sentence about the missing input";
}

TEST(HessianCurvatureFilter, EmptyInputIsNoError)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkHessianCurvature> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  vtkNew<vtkImageData> empty;
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);

  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(0, SampledImage(Block(), Spheres));
  filter->SetInputData(1, nothing);
  filter->Update();
  ASSERT_NE(filter->GetPolyDataOutput(), nullptr);
  EXPECT_NE(PointArray(filter->GetOutput(), "MeanCurvature"), nullptr);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetInputData(0, empty);
  filter->Update();
  EXPECT_FALSE(observer->GetError()) << observer->GetErrorMessage();
  EXPECT_FALSE(observer->GetWarning()) << observer->GetWarningMessage();
}

TEST(HessianCurvatureFilter, ASliceHasNoValidNode)
{
  Lattice slice = Block();
  slice.Dimensions[2] = 1;
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkHessianCurvature> filter;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->SetInputData(SampledImage(slice, Spheres));
  filter->Update();
  EXPECT_NE(
    observer->GetWarningMessage().find("Along z the image has 1 of the 3 nodes"), std::string::npos)
    << observer->GetWarningMessage();
  EXPECT_EQ(PointArray(filter->GetOutput(), "CurvatureValid")->GetRange()[1], 0.0);
  EXPECT_EQ(PointArray(filter->GetOutput(), "GaussianCurvature")->GetRange()[1], 0.0);
}
