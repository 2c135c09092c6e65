// vtkHighOrderDiffusion: types, extents, kept data, messages, refusals.

#include "DiffusionFilterTest.h"
#include "DiffusionTestTools.h"
#include "vtkHighOrderDiffusion.h"

#include <vtkCallbackCommand.h>
#include <vtkFloatArray.h>

#include <gtest/gtest.h>

#include <limits>

using namespace isthmus::testing;

namespace
{

/// With the end time that it needs.
class Filter : public Listened<vtkHighOrderDiffusion>
{
public:
  explicit Filter(vtkImageData* input)
    : Listened(input)
  {
    (*this)->SetTime(1.0);
  }
};

}

TEST(HighOrderDiffusionFilter, WorksOnEveryTypeAndReturnsFloatOrDouble)
{
  const auto whole = BumpImage(VTK_INT);
  Filter reference(whole);
  const std::vector<double> expected = Values(reference.Result());
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_LONG_LONG })
  {
    Filter filter(BumpImage(type));
    vtkDataArray* const result = filter.Result();
    const bool narrow = vtkDataArray::GetDataTypeSize(type) <= 2;
    EXPECT_EQ(result->GetDataType(), narrow ? VTK_FLOAT : VTK_DOUBLE) << type;
    EXPECT_LT(Distance(Values(result), expected), 1e-4) << type;
  }
  Filter single(BumpImage(VTK_FLOAT)), twice(BumpImage(VTK_DOUBLE));
  EXPECT_EQ(single.Result()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(twice.Result()->GetDataType(), VTK_DOUBLE);
  EXPECT_LT(Distance(Values(single.Result()), Values(twice.Result())), 1e-3);
}

TEST(HighOrderDiffusionFilter, KeepsGeometryArraysAndInput)
{
  const auto image = BumpImage();
  vtkNew<vtkFloatArray> other;
  other->SetName("Other");
  other->SetNumberOfTuples(image->GetNumberOfPoints());
  other->Fill(7.0);
  image->GetPointData()->AddArray(other);
  const std::vector<double> before = Values(image->GetPointData()->GetScalars());
  Filter filter(image);
  vtkImageData* const output = filter.Update();
  for (int n = 0; n < 6; ++n)
  {
    EXPECT_EQ(output->GetExtent()[n], image->GetExtent()[n]);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(output->GetSpacing()[axis], image->GetSpacing()[axis]);
    EXPECT_EQ(output->GetOrigin()[axis], image->GetOrigin()[axis]);
  }
  EXPECT_EQ(output->GetPointData()->GetArray("Other"), other.Get());
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "Density");
  EXPECT_EQ(Values(image->GetPointData()->GetScalars()), before);
  EXPECT_LT(Deviation(Values(filter.Result())), Deviation(before));
  for (const char* name : { "StepTime", "StepChange", "StepResidual", "NoiseLevel", "UsedSigma" })
  {
    ASSERT_TRUE(output->GetFieldData()->GetArray(name)) << name;
    EXPECT_GT(output->GetFieldData()->GetArray(name)->GetTuple1(0), 0.0) << name;
  }
}

TEST(HighOrderDiffusionFilter, SigmaComesFromTheNoiseUnlessGiven)
{
  const auto image = BumpImage(VTK_DOUBLE);
  Filter automatic(image);
  vtkFieldData* const field = automatic.Update()->GetFieldData();
  const double noise = field->GetArray("NoiseLevel")->GetTuple1(0);
  const double sigma = field->GetArray("UsedSigma")->GetTuple1(0);
  EXPECT_NEAR(sigma, 1.5 * noise, 1e-12 * sigma); // in units of the smallest spacing
  Filter given(image);
  given->SetSigma(sigma);
  EXPECT_EQ(Values(given.Result()), Values(automatic.Result()));
  EXPECT_FALSE(given.Update()->GetFieldData()->HasArray("NoiseLevel"));
  Filter linear(image);
  linear->SetEdgeStopping(vtkHighOrderDiffusion::None);
  EXPECT_FALSE(linear.Update()->GetFieldData()->HasArray("UsedSigma"));
}

TEST(HighOrderDiffusionFilter, WithoutATimeItNamesDenoiseMap)
{
  Listened<vtkHighOrderDiffusion> filter(BumpImage());
  EXPECT_NE(
    filter.Complaint().find("Denoise Map chooses the equation and its time"), std::string::npos);
}

TEST(HighOrderDiffusionFilter, UnitsOnlyChangeTheNumbers)
{
  Filter voxels(BumpImage(VTK_DOUBLE)), lengths(BumpImage(VTK_DOUBLE));
  lengths->VoxelUnitsOff();
  voxels->SetSigma(3.0);
  voxels->SetTime(2.0);
  lengths->SetSigma(3.0 / 1.5);
  lengths->SetTime(2.0 * 1.5 * 1.5);
  EXPECT_LT(Distance(Values(voxels.Result()), Values(lengths.Result())), 1e-9);
}

TEST(HighOrderDiffusionFilter, TakesSlicesRowsPointsAndNothing)
{
  const int sizes[][3] = { { 14, 12, 1 }, { 1, 12, 10 }, { 14, 1, 1 }, { 1, 1, 1 } };
  for (const auto& size : sizes)
  {
    for (int edge = vtkHighOrderDiffusion::None; edge <= vtkHighOrderDiffusion::LocalVariance + 1;
         ++edge)
    {
      Filter filter(BumpImage(VTK_FLOAT, size[0], size[1], size[2]));
      filter->SetEdgeStopping(edge % 3);
      filter->SetFlow(edge / 3);
      EXPECT_EQ(filter.Update()->GetNumberOfPoints(), size[0] * size[1] * size[2]);
      const std::vector<double> values = Values(filter.Result());
      EXPECT_TRUE(std::all_of(
        values.begin(), values.end(), [](double value) { return std::isfinite(value); }));
    }
  }
  vtkNew<vtkImageData> nothing;
  Filter filter(nothing);
  EXPECT_EQ(filter.Complaint(), "");
  EXPECT_EQ(filter.Update()->GetNumberOfPoints(), 0);
}

// A slice is the plane of a volume that does not change along the third axis.
TEST(HighOrderDiffusionFilter, ASliceIsAPlaneOfALayeredVolume)
{
  const auto slice = BumpImage(VTK_DOUBLE, 14, 12, 1), volume = BumpImage(VTK_DOUBLE, 14, 12, 5);
  vtkDataArray* const plane = slice->GetPointData()->GetScalars();
  vtkDataArray* const layers = volume->GetPointData()->GetScalars();
  for (vtkIdType n = 0; n < layers->GetNumberOfTuples(); ++n)
  {
    layers->SetTuple1(n, plane->GetTuple1(n % plane->GetNumberOfTuples()));
  }
  Filter ofSlice(slice), ofVolume(volume);
  for (Filter* filter : { &ofSlice, &ofVolume })
  {
    (*filter)->SetOrder(1);
    (*filter)->SetSigma(5.0);
  }
  const std::vector<double> expected = Values(ofSlice.Result());
  const std::vector<double> result = Values(ofVolume.Result());
  for (std::size_t n = 0; n < result.size(); ++n)
  {
    EXPECT_NEAR(result[n], expected[n % expected.size()], 1e-9);
  }
}

TEST(HighOrderDiffusionFilter, NamesTheFirstInvalidValueOrMasksIt)
{
  const auto image = BumpImage();
  image->SetScalarComponentFromDouble(5, 1, 2, 0, std::nan(""));
  image->SetScalarComponentFromDouble(6, 1, 2, 0, std::numeric_limits<double>::infinity());
  Filter filter(image);
  const std::string complaint = filter.Complaint();
  for (const char* words : { "2 of the image's values", "node (5, 1, 2)", "position (3.5, 3, 10)" })
  {
    EXPECT_NE(complaint.find(words), std::string::npos) << complaint;
  }
  filter->MaskInvalidOn();
  vtkImageData* const output = filter.Update();
  int invalid = 0;
  for (const double value : Values(output->GetPointData()->GetScalars()))
  {
    invalid += !std::isfinite(value);
  }
  EXPECT_EQ(invalid, 2);
  EXPECT_TRUE(std::isnan(output->GetScalarComponentAsDouble(5, 1, 2, 0)));
}

TEST(HighOrderDiffusionFilter, MaskedValuesAreTheMeanOfTheirNeighbours)
{
  // A row: the first has one neighbour, the fourth two, the last but one none that is a number.
  const auto row = BumpImage(VTK_DOUBLE, 14, 1, 1);
  vtkDataArray* const scalars = row->GetPointData()->GetScalars();
  double sum = 0.0;
  for (const int n : { 0, 3, 10, 11, 12 })
  {
    scalars->SetTuple1(n, std::nan(""));
  }
  for (int n = 0; n < 14; ++n)
  {
    sum += std::isnan(scalars->GetTuple1(n)) ? 0.0 : scalars->GetTuple1(n);
  }
  vtkNew<vtkImageData> filled;
  filled->DeepCopy(row);
  vtkDataArray* const values = filled->GetPointData()->GetScalars();
  values->SetTuple1(0, values->GetTuple1(1));
  values->SetTuple1(3, 0.5 * (values->GetTuple1(2) + values->GetTuple1(4)));
  values->SetTuple1(10, values->GetTuple1(9));
  values->SetTuple1(11, sum / 9.0);
  values->SetTuple1(12, values->GetTuple1(13));
  const auto result = [](vtkImageData* image)
  {
    Filter filter(image);
    filter->MaskInvalidOn();
    filter->SetTime(3.0);
    filter->SetSigma(10.0);
    return Values(filter.Result());
  };
  const std::vector<double> masked = result(row), expected = result(filled);
  ASSERT_EQ(masked.size(), expected.size());
  for (std::size_t n = 0; n < masked.size(); ++n)
  {
    const bool invalid = n == 0 || n == 3 || (n >= 10 && n <= 12);
    EXPECT_EQ(std::isnan(masked[n]), invalid);
    EXPECT_TRUE(invalid || std::abs(masked[n] - expected[n]) < 1e-12) << n;
  }
}

TEST(HighOrderDiffusionFilter, RefusesWithAMessage)
{
  const std::pair<const char*, std::function<void(vtkHighOrderDiffusion*)>> cases[] = {
    { "Time is -1", [](auto* f) { f->SetTime(-1.0); } },
    { "Order is 7", [](auto* f) { f->SetOrder(7); } },
    { "Sigma is -2", [](auto* f) { f->SetSigma(-2.0); } },
    { "Flow is 2", [](auto* f) { f->SetFlow(2); } },
    { "EdgeStopping is -1", [](auto* f) { f->SetEdgeStopping(-1); } },
    { "Integrator is 5", [](auto* f) { f->SetIntegrator(5); } },
    { "Window is 6",
      [](auto* f)
      {
        f->SetEdgeStopping(vtkHighOrderDiffusion::LocalVariance);
        f->SetWindow(6);
      } },
    { "stable only up to",
      [](auto* f)
      {
        f->SetIntegrator(vtkHighOrderDiffusion::ForwardEuler);
        f->SetSteps(1);
      } },
    { "lacks the chosen array", [](auto* f) { f->UseSourceOn(); } },
  };
  for (const auto& [words, spoil] : cases)
  {
    Filter spoiled(BumpImage());
    spoil(spoiled.operator->());
    const std::string complaint = spoiled.Complaint();
    EXPECT_NE(complaint.find(words), std::string::npos) << words << ": " << complaint;
  }
}

TEST(HighOrderDiffusionFilter, TakesAnArrayAsSourceIfItFits)
{
  for (const bool fits : { true, false })
  {
    const auto image = BumpImage(VTK_DOUBLE);
    vtkNew<vtkFloatArray> source;
    source->SetName("P");
    source->SetNumberOfTuples(image->GetNumberOfPoints() - (fits ? 0 : 1));
    source->Fill(0.5);
    image->GetPointData()->AddArray(source);
    Filter with(image), without(image);
    for (Filter* filter : { &with, &without })
    {
      (*filter)->SetEdgeStopping(vtkHighOrderDiffusion::None);
      (*filter)->SetTime(2.0);
    }
    with->UseSourceOn();
    with->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "P");
    if (fits)
    {
      EXPECT_NEAR(Mean(Values(with.Result())) - Mean(Values(without.Result())), 1.0, 1e-9);
    }
    else
    {
      EXPECT_NE(with.Complaint().find("'P' has 1679 values"), std::string::npos)
        << with.Complaint();
    }
  }
}

TEST(HighOrderDiffusionFilter, RefusesSeveralComponentsAndMissingScalars)
{
  const auto image = BumpImage();
  image->AllocateScalars(VTK_FLOAT, 3);
  EXPECT_NE(Filter(image).Complaint().find("has 3 components"), std::string::npos);
  const auto bare = BumpImage();
  bare->GetPointData()->Initialize();
  EXPECT_NE(Filter(bare).Complaint().find("no active scalars"), std::string::npos);
}

TEST(HighOrderDiffusionFilter, ShowsProgressAndStops)
{
  Filter filter(BumpImage());
  filter->SetTime(100.0);
  std::vector<double> shown;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&shown);
  listener->SetCallback(
    [](vtkObject* object, unsigned long, void* list, void*)
    {
      auto* algorithm = vtkAlgorithm::SafeDownCast(object);
      auto& fractions = *static_cast<std::vector<double>*>(list);
      fractions.push_back(algorithm->GetProgress());
      algorithm->SetAbortExecute(fractions.size() == 10);
    });
  filter->AddObserver(vtkCommand::ProgressEvent, listener);
  filter.Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  ASSERT_GE(shown.size(), 10u);
  EXPECT_TRUE(std::is_sorted(shown.begin(), shown.begin() + 10));
  EXPECT_LT(shown[9], 1.0);
}
