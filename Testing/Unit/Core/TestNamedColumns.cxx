#include "Core/NamedColumns.h"

#include <gtest/gtest.h>

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <string>
#include <vector>

namespace
{

using namespace isthmus;

TEST(NamedColumns, ValuesOfContainersAndLists)
{
  const vtkNew<vtkFieldData> data;
  AddColumn<vtkIdTypeArray>(data, "Counts", std::vector<std::size_t>{ 3, 4 });
  AddColumn<vtkDoubleArray>(data, "Level", { 0.5 });
  AddColumn<vtkIntArray>(data, "Flag", { true });
  AddColumn<vtkStringArray>(data, "Engine", { "TetGen" });
  AddColumn<vtkStringArray>(data, "Notes", std::vector<std::string>{});
  ASSERT_EQ(data->GetNumberOfArrays(), 5);
  EXPECT_STREQ(data->GetArrayName(0), "Counts");
  EXPECT_EQ(data->GetArray("Counts")->GetNumberOfTuples(), 2);
  EXPECT_EQ(data->GetArray("Counts")->GetComponent(1, 0), 4.0);
  EXPECT_EQ(data->GetArray("Level")->GetComponent(0, 0), 0.5);
  EXPECT_EQ(data->GetArray("Flag")->GetComponent(0, 0), 1.0);
  auto* engine = vtkStringArray::SafeDownCast(data->GetAbstractArray("Engine"));
  EXPECT_EQ(engine->GetValue(0), "TetGen");
  EXPECT_EQ(data->GetAbstractArray("Notes")->GetNumberOfValues(), 0);
}

TEST(NamedColumns, FunctionsOfRowsAndOfItems)
{
  const vtkNew<vtkFieldData> data;
  AddComputedColumn<vtkUnsignedCharArray>(
    data, "Odd", 3, [](std::size_t row) { return row % 2 == 1; });
  AddComputedColumn<vtkStringArray>(data, "Name", std::vector<int>{ 7, 8 },
    [](int item) { return "residue " + std::to_string(item); });
  EXPECT_EQ(data->GetArray("Odd")->GetNumberOfTuples(), 3);
  EXPECT_EQ(data->GetArray("Odd")->GetComponent(1, 0), 1.0);
  EXPECT_EQ(data->GetArray("Odd")->GetComponent(2, 0), 0.0);
  auto* names = vtkStringArray::SafeDownCast(data->GetAbstractArray("Name"));
  ASSERT_EQ(names->GetNumberOfValues(), 2);
  EXPECT_EQ(names->GetValue(1), "residue 8");
}

TEST(NamedColumns, Tuples)
{
  const vtkNew<vtkFieldData> data;
  AddTuple<vtkIntArray>(data, "Dimensions", std::array<int, 3>{ 4, 5, 6 });
  auto* vectors = AddArray<vtkFloatArray>(data, "Normals", 2, 3);
  EXPECT_EQ(vectors->GetNumberOfTuples(), 2);
  EXPECT_EQ(vectors->GetNumberOfComponents(), 3);
  EXPECT_EQ(data->GetArray("Normals"), vectors);
  EXPECT_EQ(data->GetArray("Dimensions")->GetNumberOfTuples(), 1);
  EXPECT_EQ(data->GetArray("Dimensions")->GetComponent(0, 2), 6.0);
}

TEST(NamedColumns, TypesKnownAtRunTime)
{
  const auto floats = ArrayOfType(VTK_FLOAT, "Mean", 4, 2);
  EXPECT_EQ(floats->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(floats->GetNumberOfTuples(), 4);
  EXPECT_EQ(floats->GetNumberOfComponents(), 2);
  EXPECT_EQ(ArrayOfType(VTK_DOUBLE, nullptr, 1)->GetName(), nullptr);
}

}
