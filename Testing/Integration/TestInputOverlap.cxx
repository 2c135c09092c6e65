// Inputs of a filter that lie elsewhere or are in another unit: shares and ratios of known boxes,
// the error, the warning, and rules of filters.

#include "Core/InputOverlap.h"

#include "vtkHessianCurvature.h"

#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkMolecule.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace isthmus;

namespace
{

/// n^3 points of a cube with its lowest corner at `low`.
vtkSmartPointer<vtkPolyData> Lattice(const Point3& low, double side, int n)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < n * n * n; ++i)
  {
    const double step = side / (n - 1);
    points->InsertNextPoint(
      low[0] + step * (i % n), low[1] + step * (i / n % n), low[2] + step * (i / (n * n)));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

/// A ball of density on 21^3 nodes of [-10, 10]^3.
vtkSmartPointer<vtkImageData> Density()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(21, 21, 21);
  image->SetOrigin(-10.0, -10.0, -10.0);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Density");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    values->InsertNextValue(std::exp(-0.02 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2])));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

struct Outcome
{
  std::string Error, Warning;
  vtkIdType Points;
};

/// The message of Hessian Curvature for points beside that density.
Outcome RecordWarning(vtkPolyData* points)
{
  vtkNew<vtkHessianCurvature> filter;
  vtkNew<vtkTest::ErrorObserver> said;
  filter->AddObserver(vtkCommand::ErrorEvent, said);
  filter->AddObserver(vtkCommand::WarningEvent, said);
  filter->SetInputDataObject(0, Density());
  filter->SetInputDataObject(1, points);
  filter->Update();
  return { said->GetErrorMessage(), said->GetWarningMessage(),
    vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints() };
}

}

TEST(InputOverlap, SharesOfShiftedCubesAreKnown)
{
  // The box [0, 10]^3, grown by a tenth of its diagonal, ends at 11.732 along each axis.
  const auto cube = Lattice({ 0.0, 0.0, 0.0 }, 10.0, 3);
  struct Case
  {
    double Low, Side;
    double Share;
  };
  for (const Case& c : { Case{ 1.0, 8.0, 1.0 }, { 3.5, 9.0, 0.001 * 9 * 9 * 9 },
         { 11.0, 9.0, 0.001 }, { 12.0, 9.0, 0.0 }, { -5.5, 9.0, 0.001 * 6 * 6 * 6 } })
  {
    // Ten points along each side, one apart where it is 9 long.
    const auto other = Lattice({ c.Low, c.Low, c.Low }, c.Side, 10);
    for (const bool swapped : { false, true })
    {
      const auto overlap = swapped ? MeasureOverlap(other, cube) : MeasureOverlap(cube, other);
      ASSERT_TRUE(overlap.has_value());
      EXPECT_NEAR(overlap->Share, c.Share, 1e-12) << c.Low;
      EXPECT_NEAR(overlap->Ratio, swapped ? 10.0 / c.Side : c.Side / 10.0, 1e-12);
      EXPECT_FALSE(overlap->IsOfOtherUnit());
    }
  }
}

TEST(InputOverlap, TenTimesLargerIsAnotherUnit)
{
  const auto cube = Lattice({ 0.0, 0.0, 0.0 }, 20.0, 3);
  for (const auto& [side, other] :
    { std::pair{ 2.0, true }, { 2.09, true }, { 2.11, false }, { 1.89, false }, { 1.91, true },
      { 200.0, true }, { 209.0, true }, { 211.0, false }, { 189.0, false }, { 20.0, false } })
  {
    EXPECT_EQ(MeasureOverlap(cube, Lattice({ 0.0, 0.0, 0.0 }, side, 3))->IsOfOtherUnit(), other)
      << side;
  }
}

TEST(InputOverlap, InputsWithAndWithoutPositions)
{
  const auto cube = Lattice({ 0.0, 0.0, 0.0 }, 10.0, 3);
  EXPECT_FALSE(MeasureOverlap(cube, vtkNew<vtkTable>()).has_value());
  EXPECT_FALSE(MeasureOverlap(cube, vtkNew<vtkPolyData>()).has_value());
  EXPECT_FALSE(MeasureOverlap(cube, nullptr).has_value());
  EXPECT_FALSE(MeasureOverlap(vtkNew<vtkImageData>(), cube).has_value());
  vtkNew<vtkMolecule> molecule;
  molecule->AppendAtom(6, 5.0, 5.0, 5.0);
  molecule->AppendAtom(6, 50.0, 5.0, 5.0);
  molecule->AppendAtom(6, 5.0, 5.0, 11.0);
  EXPECT_NEAR(MeasureOverlap(molecule, Lattice({ 0.0, 0.0, 0.0 }, 100.0, 3))->Share, 1.0, 1e-12);
  // For a rotated image the nodes count, not the box along the axes.
  vtkNew<vtkImageData> turned;
  turned->SetDimensions(11, 11, 11);
  turned->SetDirectionMatrix(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
  turned->SetOrigin(0.0, 0.0, 0.0); // it covers [-10, 0] x [0, 10] x [0, 10]
  EXPECT_NEAR(MeasureOverlap(turned, cube)->First.Min[0], -10.0, 1e-12);
  EXPECT_NEAR(MeasureOverlap(turned, Lattice({ -9.0, 1.0, 1.0 }, 8.0, 3))->Share, 1.0, 1e-12);
  EXPECT_NEAR(MeasureOverlap(turned, Lattice({ 12.0, 1.0, 1.0 }, 8.0, 3))->Share, 0.0, 1e-12);
  // Points with undefined positions do not count, nor do those that no polygon uses.
  const auto stray = Lattice({ 1.0, 1.0, 1.0 }, 8.0, 3);
  stray->GetPoints()->InsertNextPoint(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  EXPECT_NEAR(MeasureOverlap(cube, stray)->Share, 1.0, 1e-12);
  stray->GetPoints()->InsertNextPoint(1e6, 0.0, 0.0);
  EXPECT_LT(MeasureOverlap(cube, stray)->Share, 1.0 + 1e-12);
  EXPECT_GT(MeasureOverlap(cube, stray)->Ratio, 1e4);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 2, 26 });
  stray->SetPolys(polygons);
  EXPECT_LT(MeasureOverlap(cube, stray)->Ratio, 1.0);
}

TEST(InputOverlap, FiltersRefuseOrWarn)
{
  const auto on = RecordWarning(Lattice({ -4.0, -4.0, -4.0 }, 8.0, 5));
  EXPECT_EQ(on.Error + on.Warning, "");
  const auto off = RecordWarning(Lattice({ 996.0, -4.0, -4.0 }, 8.0, 5));
  EXPECT_NE(off.Error.find("Inputs 0 and 1 do not overlap"), std::string::npos) << off.Error;
  EXPECT_NE(off.Error.find("from (996, -4, -4)"), std::string::npos) << off.Error;
  EXPECT_EQ(off.Error.find("nanometres"), std::string::npos) << off.Error;
  EXPECT_EQ(off.Points, 0);
  // Of five layers of points, two are within the box, which ends at 13.5, one of them in the
  // volume.
  const auto partly = RecordWarning(Lattice({ 9.0, -4.0, -4.0 }, 12.0, 5));
  EXPECT_EQ(partly.Error, "");
  EXPECT_NE(partly.Warning.find("Only 40 %"), std::string::npos) << partly.Warning;
  EXPECT_EQ(partly.Points, 125);
  const auto small = RecordWarning(Lattice({ -1.0, -1.0, -1.0 }, 2.0, 5));
  EXPECT_EQ(small.Error, "");
  EXPECT_NE(small.Warning.find("10 times as large"), std::string::npos) << small.Warning;
  EXPECT_NE(small.Warning.find("nanometres"), std::string::npos) << small.Warning;
  const auto smallAndOff = RecordWarning(Lattice({ 99.0, -1.0, -1.0 }, 2.0, 5));
  EXPECT_NE(smallAndOff.Error.find("nanometres"), std::string::npos) << smallAndOff.Error;
}

TEST(InputOverlap, ARuleOfAFilterHoldsForItsPort)
{
  vtkNew<vtkHessianCurvature> filter;
  vtkNew<vtkTest::ErrorObserver> said;
  filter->AddObserver(vtkCommand::ErrorEvent, said);
  filter->AddObserver(vtkCommand::WarningEvent, said);
  filter->SetInputDataObject(0, Density());
  filter->SetInputDataObject(1, Lattice({ 996.0, -1.0, -1.0 }, 2.0, 5));
  OverlapRule none;
  none.Refused = -1.0;
  none.Warned = 0.0;
  none.Units = false;
  SetOverlapRule(filter, 1, none);
  CheckOverlap(filter); // without data yet
  filter->Update();     // has its own message about points outside
  EXPECT_EQ(
    (said->GetErrorMessage() + said->GetWarningMessage()).find("nputs 0 and 1"), std::string::npos)
    << said->GetErrorMessage() << said->GetWarningMessage();
  none.Warned = 0.5;
  SetOverlapRule(filter, 1, none);
  filter->Modified();
  filter->Update();
  EXPECT_NE(said->GetWarningMessage().find("Only 0 %"), std::string::npos)
    << said->GetWarningMessage();
  said->Clear();
  CheckOverlap(filter); // said already
  EXPECT_EQ(said->GetWarningMessage(), "");
}
