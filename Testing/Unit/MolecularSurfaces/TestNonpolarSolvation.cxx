// vtkNonpolarSolvation: its outputs, and refused input.

#include "vtkNonpolarSolvation.h"

#include "FlowCases.h"

#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

vtkSmartPointer<vtkPolyData> WithDepths(const std::vector<Ball>& balls, double depth)
{
  auto atoms = MakeAtoms(balls);
  vtkNew<vtkDoubleArray> depths;
  depths->SetName("WellDepth");
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    depths->InsertNextValue(depth);
  }
  atoms->GetPointData()->AddArray(depths);
  return atoms;
}

}

TEST(NonpolarSolvation, ArraysSumToTheTable)
{
  const std::vector<Ball> balls = RandomBalls(40, 9.0);
  const auto atoms = WithDepths(balls, 0.1);
  vtkNew<vtkMolecularFlowSurface> flow;
  flow->SetInputData(atoms);
  vtkNew<vtkNonpolarSolvation> energy;
  energy->SetInputData(0, atoms);
  energy->SetInputConnection(1, flow->GetOutputPort(1));
  energy->Update();
  auto* table = vtkTable::SafeDownCast(energy->GetOutputDataObject(1));
  ASSERT_EQ(table->GetNumberOfRows(), 1);
  for (const char* name :
    { "Area", "Volume", "SurfaceEnergy", "VolumeEnergy", "DispersionEnergy", "NonpolarEnergy" })
  {
    vtkDataArray* parts = energy->GetOutput()->GetPointData()->GetArray(name);
    ASSERT_NE(parts, nullptr) << name;
    double sum = 0.0;
    for (vtkIdType i = 0; i < parts->GetNumberOfTuples(); ++i)
    {
      sum += parts->GetComponent(i, 0);
    }
    const double whole = table->GetValueByName(0, name).ToDouble();
    EXPECT_NEAR(sum, whole, 1e-9 * std::abs(whole)) << name;
  }
  EXPECT_NEAR(
    table->GetValueByName(0, "Area").ToDouble() / MeasureFlowSurface(flow->GetOutput()).Whole.Area,
    1.0, 5e-3);
  EXPECT_LT(table->GetValueByName(0, "DispersionEnergy").ToDouble(), 0.0);
  EXPECT_EQ(atoms->GetPointData()->GetArray("Area"), nullptr); // the input stays as it was
}

// A volume in nanometres, or a moved one, overlaps with the atoms, but does not belong to them.
TEST(NonpolarSolvation, AtomsOutsideTheVolumeAreErrorsOrWarnings)
{
  const std::vector<Ball> balls = RandomBalls(40, 9.0);
  const auto atoms = WithDepths(balls, 0.1);
  vtkNew<vtkMolecularFlowSurface> flow;
  flow->SetInputData(atoms);
  flow->Update();
  vtkNew<vtkTest::ErrorObserver> said;
  vtkNew<vtkNonpolarSolvation> energy;
  energy->AddObserver(vtkCommand::ErrorEvent, said);
  energy->AddObserver(vtkCommand::WarningEvent, said);
  energy->SetInputData(0, atoms);
  const auto moved = [&](double scale, double shift)
  {
    vtkNew<vtkImageData> image;
    image->DeepCopy(flow->GetImage());
    const double* const h = image->GetSpacing();
    image->SetSpacing(scale * h[0], scale * h[1], scale * h[2]);
    const double* const o = image->GetOrigin();
    image->SetOrigin(scale * o[0] + shift, scale * o[1] + shift, scale * o[2] + shift);
    said->Clear();
    energy->SetInputData(1, image);
    energy->Update();
  };
  moved(1.0, 0.0);
  EXPECT_FALSE(said->GetError() || said->GetWarning());
  moved(0.1, 0.0);
  EXPECT_NE(said->GetErrorMessage().find("of 40 atoms lie outside the surface"), std::string::npos);
  EXPECT_EQ(energy->GetOutput()->GetNumberOfPoints(), 0);
  moved(1.0, 1.5);
  EXPECT_FALSE(said->GetError()) << said->GetErrorMessage();
  EXPECT_NE(said->GetWarningMessage().find("lie outside the surface"), std::string::npos);
  EXPECT_EQ(energy->GetOutput()->GetNumberOfPoints(), 40);
}

namespace
{

/// What is said about a ball of this radius with an atom in its middle, given by `change` of its
/// distance, and the row of energies.
std::string SayOfBall(double radius, double spacing, int nodes,
  const std::function<double(double)>& change, vtkSmartPointer<vtkTable>& row,
  const Point3& center = { 0.0, 0.0, 0.0 })
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(nodes, nodes, nodes);
  image->SetSpacing(spacing, spacing, spacing);
  const double corner = -0.5 * spacing * (nodes - 1);
  image->SetOrigin(corner, corner, corner);
  vtkNew<vtkFloatArray> distance;
  distance->SetName("SignedDistance");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    Point3 x;
    image->GetPoint(i, x.data());
    distance->InsertNextValue(static_cast<float>(change(Length(x - center) - radius)));
  }
  image->GetPointData()->AddArray(distance);
  vtkNew<vtkNonpolarSolvation> energy;
  vtkNew<vtkTest::ErrorObserver> said, pipeline;
  energy->AddObserver(vtkCommand::ErrorEvent, said);
  energy->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, pipeline);
  energy->SetInputData(0, WithDepths({ { center, radius } }, 0.1));
  energy->SetInputData(1, image);
  energy->Update();
  row = vtkTable::SafeDownCast(energy->GetOutputDataObject(1));
  return said->GetErrorMessage();
}

}

// Areas are measured within half a spacing of the surface, by distances.
TEST(NonpolarSolvation, SurfacesThatAreNotClosedOrNoDistancesAreRefused)
{
  const auto same = [](double d) { return d; };
  vtkSmartPointer<vtkTable> row;
  EXPECT_EQ(SayOfBall(2.0, 0.25, 41, same, row), "");
  EXPECT_EQ(SayOfBall(
              2.0, 0.25, 41, [](double d) { return 0.8 * d; }, row),
    "");
  EXPECT_EQ(SayOfBall(
              2.0, 0.25, 41, [](double d) { return std::clamp(d, -0.6, 0.6); }, row),
    "");
  for (const int nodes : { 13, 16, 5 }) // within the ball in part or as a whole
  {
    EXPECT_NE(
      SayOfBall(2.0, 0.25, nodes, same, row).find("leaves the volume along"), std::string::npos)
      << nodes;
    EXPECT_EQ(row->GetNumberOfRows(), 0);
  }
  for (const double factor : { 0.1, 0.3, 3.0, 10.0 })
  {
    EXPECT_NE(SayOfBall(
                2.0, 0.25, 41, [factor](double d) { return factor * d; }, row)
                .find("has a gradient of"),
      std::string::npos)
      << factor;
  }
  EXPECT_NE(SayOfBall(
              2.0, 0.25, 41, [](double d) { return d * (d + 4.0); }, row)
              .find("has a gradient of"),
    std::string::npos)
    << "squares";
}

TEST(NonpolarSolvation, ErrorCoversTheTruth)
{
  std::mt19937 random(11);
  const auto between = [&random](double low, double high)
  { return low + (high - low) * static_cast<double>(random()) / 4294967296.0; };
  int covered = 0;
  constexpr int cases = 60;
  std::vector<double> ratios;
  for (int i = 0; i < cases; ++i)
  {
    const double radius = between(1.5, 5.0), spacing = between(0.25, 1.0);
    const Point3 center{ between(-0.5, 0.5), between(-0.5, 0.5), between(-0.5, 0.5) };
    const int nodes = static_cast<int>(2.0 * (radius + 0.5) / spacing) + 8;
    vtkSmartPointer<vtkTable> row;
    ASSERT_EQ(SayOfBall(
                radius, spacing, nodes, [](double d) { return d; }, row, center),
      "");
    const auto value = [&row](const char* name) { return row->GetValueByName(0, name).ToDouble(); };
    const double exact = 4.0 * Pi * radius * radius * (0.0700 + 0.0464 * radius / 3.0);
    const double error = std::abs(value("SurfaceEnergy") + value("VolumeEnergy") - exact);
    covered += value("NonpolarEnergyError") >= error ? 1 : 0;
    if (error > 1e-3 * exact)
    {
      ratios.push_back(value("NonpolarEnergyError") / error);
    }
  }
  ASSERT_FALSE(ratios.empty());
  std::sort(ratios.begin(), ratios.end());
  std::printf("NonpolarEnergyError: %d of %d covered, %zu errors above 0.1 %%, median ratio %.1f, "
              "at most %.1f\n",
    covered, cases, ratios.size(), ratios[ratios.size() / 2], ratios.back());
  EXPECT_GE(covered, 0.9 * cases);
  EXPECT_LE(ratios[ratios.size() / 2], 5.0);
}

TEST(NonpolarSolvation, ReportsBadInput)
{
  const std::vector<Ball> balls{ { { 0.0, 0.0, 0.0 }, 1.7 } };
  vtkNew<vtkMolecularFlowSurface> flow;
  flow->SetInputData(MakeAtoms(balls));
  flow->Update();
  vtkNew<vtkImageData> image;
  image->DeepCopy(flow->GetImage());
  vtkNew<vtkTest::ErrorObserver> said;
  vtkNew<vtkTest::ErrorObserver> pipeline;
  vtkNew<vtkNonpolarSolvation> energy;
  energy->AddObserver(vtkCommand::ErrorEvent, said);
  energy->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, pipeline);
  const auto of = [&](vtkPolyData* atoms, vtkImageData* volume)
  {
    said->Clear();
    energy->SetInputData(0, atoms);
    energy->SetInputData(1, volume);
    energy->Modified();
    energy->Update();
    return said->GetErrorMessage();
  };
  const auto empty = [&] { return energy->GetOutput()->GetNumberOfPoints() == 0; };
  EXPECT_EQ(of(WithDepths(balls, 0.1), image), "");
  EXPECT_FALSE(empty());
  EXPECT_NE(of(MakeAtoms(balls), image).find("WellDepth (kcal/mol"), std::string::npos);
  EXPECT_TRUE(empty());
  EXPECT_NE(of(WithDepths(balls, -0.1), image).find("has a WellDepth of -0.1"), std::string::npos);
  EXPECT_NE(of(WithDepths(balls, std::nan("")), image).find("WellDepth"), std::string::npos);
  vtkNew<vtkImageData> bare;
  bare->CopyStructure(image);
  EXPECT_NE(of(WithDepths(balls, 0.1), bare).find("no array SignedDistance"), std::string::npos);
  vtkNew<vtkImageData> holed;
  holed->DeepCopy(image);
  holed->GetPointData()->GetArray("SignedDistance")->SetComponent(5, 0, std::nan(""));
  EXPECT_NE(of(WithDepths(balls, 0.1), holed).find("not a number at node 5"), std::string::npos);
  vtkNew<vtkImageData> flat;
  flat->DeepCopy(image);
  flat->SetSpacing(0.5, 0.5, 0.7);
  EXPECT_NE(of(WithDepths(balls, 0.1), flat).find("not cubes"), std::string::npos);
  energy->SetSolventDensity(-1.0);
  EXPECT_NE(of(WithDepths(balls, 0.1), image).find("SolventDensity is -1"), std::string::npos);
  energy->SetSolventDensity(0.033);
  energy->SetPressure(std::nan(""));
  EXPECT_NE(of(WithDepths(balls, 0.1), image).find("Pressure is not a number"), std::string::npos);
  energy->SetPressure(0.05);
  EXPECT_EQ(of(vtkNew<vtkPolyData>(), image), "");
  EXPECT_TRUE(empty());
}
