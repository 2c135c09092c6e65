// Ranges with and without their ends; the messages of refused values.

#include "Core/RangeChecks.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkMolecule.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

using namespace isthmus;

namespace
{

template <typename Call>
std::string CatchRefusal(Call&& call)
{
  try
  {
    call();
  }
  catch (const std::invalid_argument& refusal)
  {
    return refusal.what();
  }
  return {};
}

}

TEST(RangeChecks, BothEndsBelongToARange)
{
  EXPECT_NO_THROW(RequireRange("Length", 1.0, 1.0, 2.0));
  EXPECT_NO_THROW(RequireRange("Length", 2.0, 1.0, 2.0));
  EXPECT_EQ(CatchRefusal([] { RequireRange("Length", 0.5, 1.0, 2.0, "It is a length."); }),
    "Length is 0.5, but it must be from 1 to 2. It is a length.");
  EXPECT_EQ(CatchRefusal([] { RequireRange("Length", 2.5, 1.0, 2.0); }),
    "Length is 2.5, but it must be from 1 to 2.");
  EXPECT_THROW(RequireRange("Length", std::nan(""), 1.0, 2.0), std::invalid_argument);
}

TEST(RangeChecks, RequireAboveIncludesOnlyTheUpperEnd)
{
  EXPECT_NO_THROW(RequireAbove("Length", 2.0, 1.0, 2.0));
  EXPECT_EQ(CatchRefusal([] { RequireAbove("Length", 1.0, 1.0, 2.0, "It is a length."); }),
    "Length is 1, but it must be above 1 and at most 2. It is a length.");
  EXPECT_THROW(RequireAbove("Length", 2.5, 1.0, 2.0), std::invalid_argument);
  EXPECT_THROW(RequireAbove("Length", std::nan(""), 1.0, 2.0), std::invalid_argument);
}

TEST(RangeChecks, ARangeWithoutEndNeedsAFiniteNumber)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_NO_THROW(RequireRange("Length", 1e300, 0.0, Unlimited));
  EXPECT_EQ(CatchRefusal([] { RequireRange("Length", -1.0, 0.0, Unlimited); }),
    "Length is -1, but it must be a finite number of at least 0.");
  EXPECT_THROW(RequireRange("Length", infinity, 0.0, Unlimited), std::invalid_argument);
  EXPECT_EQ(CatchRefusal([] { RequireAbove("Length", 0.0, 0.0, Unlimited); }),
    "Length is 0, but it must be a finite number above 0.");
  EXPECT_THROW(RequireAbove("Length", infinity, 0.0, Unlimited), std::invalid_argument);
}

TEST(RangeChecks, ATrueConditionPasses)
{
  EXPECT_NO_THROW(RequireThat(true, "Length", 3.0, "it must be even"));
  EXPECT_EQ(CatchRefusal([] { RequireThat(false, "Length", 3.0, "it must be even"); }),
    "Length is 3, but it must be even.");
}

TEST(RangeChecks, LargestMagnitudeIgnoresNonFiniteValues)
{
  vtkNew<vtkFloatArray> floats;
  vtkNew<vtkDoubleArray> doubles;
  doubles->SetNumberOfComponents(3);
  vtkNew<vtkIntArray> integers;
  EXPECT_EQ(LargestMagnitude(floats), 0.0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 300000; ++i) // several blocks
  {
    const double odd = i % 2 == 0 ? -infinity : std::nan("");
    floats->InsertNextValue(i == 200001 ? -7.0f : i % 5 == 0 ? static_cast<float>(odd) : 2.0f);
    doubles->InsertNextValue(i == 299999 ? -1e300 : i % 5 == 0 ? odd : 1e299);
    integers->InsertNextValue(i == 0 ? -9 : 4);
  }
  EXPECT_EQ(LargestMagnitude(floats), 7.0);
  EXPECT_EQ(LargestMagnitude(doubles), 1e300);
  EXPECT_EQ(LargestMagnitude(integers), 9.0);
}

TEST(RangeChecks, RefusesValuesOfWhichProductsOverflowOrUnderflow)
{
  const auto refusal = [](double value)
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName("Density");
    values->InsertNextValue(0.5 * value);
    values->InsertNextValue(-value);
    values->InsertNextValue(std::nan(""));
    return CatchRefusal([&] { RequireUsualValues(values); });
  };
  for (const double usual : { 0.0, 1e-36, 1.0, 1e36 })
  {
    EXPECT_EQ(refusal(usual), "") << usual;
  }
  EXPECT_EQ(refusal(3e38),
    "Array 'Density' has the largest absolute value 3e+38, but it must be from 1e-36 to 1e+36, "
    "since products of values are computed. Divide the map by a number (Calculator), or replace "
    "values that stand for missing ones.");
  for (const double unusual : { 1e-300, 1e-37, 1e37, 1e160 })
  {
    EXPECT_NE(refusal(unusual), "") << unusual;
  }
}

TEST(RangeChecks, RefusesCoordinatesOfWhichProductsOverflowOrUnderflow)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(1.0, 2.0, 3.0);
  points->InsertNextPoint(0.0, -1e300, std::nan(""));
  vtkNew<vtkPolyData> atoms;
  EXPECT_NO_THROW(RequireUsualCoordinates(atoms, "input 0"));
  atoms->SetPoints(points);
  const std::string far =
    "Point 1 of input 0 has the coordinate -1e+300: at most 1e+100 is supported. "
    "Remove the point, or choose another unit of length.";
  EXPECT_EQ(CatchRefusal([&] { RequireUsualCoordinates(atoms, "input 0"); }), far);
  // Points that no cell uses are ignored if there are cells.
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  atoms->SetVerts(vertices);
  EXPECT_NO_THROW(RequireUsualCoordinates(atoms, "input 0"));
  vertices->InsertNextCell({ 1 });
  atoms->Modified();
  vtkNew<vtkPolyData> both;
  both->SetPoints(points);
  both->SetVerts(vertices);
  EXPECT_EQ(CatchRefusal([&] { RequireUsualCoordinates(both, "input 0"); }), far);
  points->SetPoint(1, 1e100, 0.0, 0.0);
  EXPECT_NO_THROW(RequireUsualCoordinates(both, "input 0"));
  points->SetPoint(0, 1e-120, 0.0, 0.0);
  points->SetPoint(1, 0.0, 2e-120, 0.0);
  EXPECT_EQ(CatchRefusal([&] { RequireUsualCoordinates(both, "input 1"); }),
    "The largest coordinate of input 1 is 2e-120: it should be at least 1e-100. Choose another "
    "unit of length (Transform).");
  points->SetPoint(0, 0.0, 0.0, 0.0);
  points->SetPoint(1, 0.0, 0.0, 0.0);
  EXPECT_NO_THROW(RequireUsualCoordinates(both, "input 0"));
  vtkNew<vtkMolecule> molecule;
  molecule->AppendAtom(6, 0.0, 0.0, 0.0);
  EXPECT_NO_THROW(RequireUsualCoordinates(molecule, "input 0"));
}

TEST(RangeChecks, FormatsNumbers)
{
  EXPECT_EQ(FormatNumber(1e300), "1e+300");
  EXPECT_EQ(FormatNumber(std::numeric_limits<double>::quiet_NaN()), "not a number");
  EXPECT_EQ(FormatNumber(0.25), "0.25");
}

TEST(RangeChecks, RefusesNaNWithTheRange)
{
  try
  {
    RequireRange("Angle", std::numeric_limits<double>::quiet_NaN(), 0.0, 30.0, "It is in degrees.");
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_STREQ(
      error.what(), "Angle is not a number, but it must be from 0 to 30. It is in degrees.");
  }
}
