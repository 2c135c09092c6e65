// Cropping an image by rows, compared with VTK value by value.

#include "Core/ImageExtent.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkShortArray.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <string>

using isthmus::CropTo;
using isthmus::Extent;

namespace
{

template <typename Array>
void AddRandom(vtkDataSetAttributes* data, const char* name, int components, vtkIdType tuples)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < components * tuples; ++i)
  {
    array->SetValue(i, static_cast<typename Array::ValueType>((7919 * i + 13) % 127));
  }
  data->AddArray(array);
}

vtkNew<vtkImageData> Image(Extent extent)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(extent.data());
  image->SetOrigin(1.0, -2.0, 3.0);
  image->SetSpacing(0.5, 1.0, 2.0);
  AddRandom<vtkDoubleArray>(image->GetPointData(), "Density", 1, image->GetNumberOfPoints());
  AddRandom<vtkShortArray>(image->GetPointData(), "Direction", 3, image->GetNumberOfPoints());
  AddRandom<vtkUnsignedCharArray>(
    image->GetPointData(), "vtkGhostType", 1, image->GetNumberOfPoints());
  AddRandom<vtkDoubleArray>(image->GetCellData(), "Mass", 1, image->GetNumberOfCells());
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    names->InsertNextValue(std::to_string(i));
  }
  image->GetPointData()->AddArray(names);
  image->GetPointData()->SetActiveScalars("Density");
  return image;
}

void ExpectEqual(vtkDataSetAttributes* ours, vtkDataSetAttributes* theirs)
{
  ASSERT_EQ(ours->GetNumberOfArrays(), theirs->GetNumberOfArrays());
  for (int a = 0; a < ours->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* one = ours->GetAbstractArray(a);
    vtkAbstractArray* other = theirs->GetAbstractArray(one->GetName());
    ASSERT_NE(other, nullptr) << one->GetName();
    ASSERT_EQ(one->GetNumberOfValues(), other->GetNumberOfValues()) << one->GetName();
    for (vtkIdType i = 0; i < one->GetNumberOfValues(); ++i)
    {
      ASSERT_EQ(one->GetVariantValue(i), other->GetVariantValue(i)) << one->GetName() << " " << i;
    }
  }
}

}

class Crops : public testing::TestWithParam<Extent>
{
};

TEST_P(Crops, MatchVTK)
{
  const Extent whole{ -2, 6, 3, 9, 0, 4 };
  const auto ours = Image(whole);
  const auto theirs = Image(whole);
  Extent to = GetParam();
  CropTo(ours, to);
  theirs->Crop(to.data());
  Extent ourExtent{};
  Extent theirExtent{};
  ours->GetExtent(ourExtent.data());
  theirs->GetExtent(theirExtent.data());
  EXPECT_EQ(ourExtent, theirExtent);
  EXPECT_EQ(ours->GetOrigin()[0], 1.0);
  ASSERT_NE(ours->GetPointData()->GetScalars(), nullptr);
  EXPECT_STREQ(ours->GetPointData()->GetScalars()->GetName(), "Density");
  ExpectEqual(ours->GetPointData(), theirs->GetPointData());
  ExpectEqual(ours->GetCellData(), theirs->GetCellData());
}

// Inner, all, more than all, one layer, one row, one node.
INSTANTIATE_TEST_SUITE_P(Boxes, Crops,
  testing::Values(Extent{ 0, 5, 4, 8, 1, 3 }, Extent{ -2, 6, 3, 9, 0, 4 },
    Extent{ -9, 3, 3, 99, 2, 4 }, Extent{ -2, 6, 3, 9, 2, 2 }, Extent{ 1, 1, 3, 9, 0, 0 },
    Extent{ 2, 2, 5, 5, 1, 1 }));

TEST(CropTo, TheLastLayerKeepsItsNodes)
{
  const auto image = Image({ 0, 4, 0, 3, 0, 2 });
  const double last = image->GetPointData()->GetScalars()->GetTuple1(59);
  CropTo(image, { 0, 4, 0, 3, 2, 2 });
  EXPECT_EQ(image->GetNumberOfPoints(), 20);
  EXPECT_EQ(image->GetPointData()->GetScalars()->GetTuple1(19), last);
  EXPECT_EQ(image->GetCellData()->GetArray("Mass")->GetNumberOfTuples(), image->GetNumberOfCells());
}

TEST(CropTo, NothingIsLeftOutsideTheImage)
{
  const auto whole = Image({ 0, 4, 0, 3, 0, 2 });
  vtkNew<vtkImageData> image;
  image->ShallowCopy(whole);
  CropTo(image, { 7, 9, 0, 3, 0, 2 });
  EXPECT_EQ(image->GetNumberOfPoints(), 0);
  ASSERT_NE(image->GetPointData()->GetScalars(), nullptr);
  EXPECT_EQ(image->GetPointData()->GetScalars()->GetNumberOfTuples(), 0);
  EXPECT_EQ(whole->GetPointData()->GetScalars()->GetNumberOfTuples(), 60); // arrays were shared
}
