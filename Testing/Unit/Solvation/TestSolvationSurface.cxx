// vtkSolvationSurface: a single ion, whose surface, energies, potential and induced charge are
// known.

#include "vtkSolvationSurface.h"

#include "ChargedPoints.h"
#include "Electrostatics/ElectrostaticUnits.h"

#include <vtkCommand.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr Point3 IonPlace{ 0.11, -0.07, 0.05 }; // off the nodes
constexpr double IonRadius = 2.0;
constexpr double Within = 8.0, Water = 80.0; // dielectric constants

vtkSmartPointer<vtkSolvationSurface> SurfaceOfIon(double charge)
{
  auto filter = vtkSmartPointer<vtkSolvationSurface>::New();
  filter->SetInputData(ChargedPoints({ { IonPlace, IonRadius } }, { charge }, 0.1));
  filter->SetSoluteDielectric(Within);
  filter->SetSolventDielectric(Water);
  filter->SetSpacing(0.3);
  filter->SetPadding(3.0);
  return filter;
}

double GetLast(vtkSolvationSurface* filter, const char* column)
{
  vtkTable* table = filter->GetUpdates();
  return table->GetValueByName(table->GetNumberOfRows() - 1, column).ToDouble();
}

double DistanceToIon(const double* at)
{
  return std::hypot(at[0] - IonPlace[0], at[1] - IonPlace[1], at[2] - IonPlace[2]);
}

/// Attraction of water outside of the ion: -eps up to the minimum m, eps ((m/r)^12 - 2 (m/r)^6)
/// beyond (Weeks, Chandler, Andersen), with TIP3P's oxygen.
double AttractionOfWater(double depth)
{
  const double m = IonRadius + 1.7683;
  const double eps = std::sqrt(depth * 0.1521);
  const double within = -(std::pow(m, 3) - std::pow(IonRadius, 3)) / 3.0;
  const double beyond = std::pow(m, 3) * (1.0 / 9.0 - 2.0 / 3.0);
  return 0.033428 * 4.0 * Pi * eps * (within + beyond);
}

}

TEST(SolvationSurface, OfAnIonHasBornsEnergyAndPotential)
{
  const auto filter = SurfaceOfIon(1.0);
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  ASSERT_GT(surface->GetNumberOfPoints(), 100);
  EXPECT_EQ(surface->GetFieldData()->GetArray("Converged")->GetComponent(0, 0), 1.0);

  // Pressure and tension keep the surface on the ball, and the field pulls it there.
  const double area = 4.0 * Pi * IonRadius * IonRadius;
  const double volume = area * IonRadius / 3.0;
  const double coulomb = units::CoulombLength(298.15);
  const double born =
    -0.5 * coulomb * (1.0 / Within - 1.0 / Water) / IonRadius * units::ThermalKilocalorie(298.15);
  EXPECT_NEAR(GetLast(filter, "Area") / area, 1.0, 0.01);
  EXPECT_NEAR(GetLast(filter, "Volume") / volume, 1.0, 0.02);
  EXPECT_NEAR(GetLast(filter, "SurfaceEnergy") / (0.0700 * area), 1.0, 0.01);
  EXPECT_NEAR(GetLast(filter, "VolumeEnergy") / (0.0464 * volume), 1.0, 0.02);
  EXPECT_NEAR(GetLast(filter, "DispersionEnergy") / AttractionOfWater(0.1), 1.0, 0.01);
  EXPECT_NEAR(GetLast(filter, "PolarEnergy") / born, 1.0, 0.005);
  const double nonpolar = GetLast(filter, "SurfaceEnergy") + GetLast(filter, "VolumeEnergy") +
    GetLast(filter, "DispersionEnergy");
  EXPECT_NEAR(GetLast(filter, "NonpolarEnergy"), nonpolar, 1e-9);
  EXPECT_NEAR(GetLast(filter, "TotalEnergy"), nonpolar + GetLast(filter, "PolarEnergy"), 1e-9);

  vtkPointData* values = surface->GetPointData();
  const double potential = coulomb / (Water * IonRadius);
  const double induced = -(1.0 / Within - 1.0 / Water) / area;
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    ASSERT_NEAR(DistanceToIon(surface->GetPoint(p)), IonRadius, 0.05);
    ASSERT_NEAR(values->GetArray("Potential")->GetComponent(p, 0) / potential, 1.0, 0.03);
    ASSERT_NEAR(
      values->GetArray("NormalField")->GetComponent(p, 0) * IonRadius / potential, 1.0, 0.05);
    ASSERT_NEAR(values->GetArray("SurfaceChargeDensity")->GetComponent(p, 0) / induced, 1.0, 0.05);
  }

  // In all of the water the potential is that of the charge divided by the dielectric constant;
  // within the ion water's part of it is constant.
  vtkImageData* image = filter->GetImage();
  vtkIdType inside = 0;
  for (vtkIdType node = 0; node < image->GetNumberOfPoints(); ++node)
  {
    const double r = DistanceToIon(image->GetPoint(node));
    if (r > IonRadius + 0.1)
    {
      ASSERT_NEAR(image->GetPointData()->GetArray("Potential")->GetComponent(node, 0) * Water * r,
        coulomb, 0.02 * coulomb)
        << r;
    }
    else if (r < IonRadius - 0.1)
    {
      ++inside;
      ASSERT_NEAR(image->GetPointData()->GetArray("ReactionPotential")->GetComponent(node, 0),
        -coulomb * (1.0 / Within - 1.0 / Water) / IonRadius, 0.005 * coulomb / IonRadius)
        << r;
    }
  }
  EXPECT_GT(inside, 200);
}

TEST(SolvationSurface, PolarEnergyScalesWithTheSquareOfTheCharge)
{
  const auto polar = [](double charge)
  {
    const auto filter = SurfaceOfIon(charge);
    filter->Update();
    return GetLast(filter, "PolarEnergy");
  };
  const double cation = polar(1.0);
  EXPECT_NEAR(polar(-1.0) / cation, 1.0, 1e-6);
  EXPECT_NEAR(polar(2.0) / cation, 4.0, 1e-4);
}

TEST(SolvationSurface, AChargeOutsideOfAllAtomsIsRefused)
{
  const auto filter = SurfaceOfIon(1.0);
  vtkNew<vtkTest::ErrorObserver> said;
  filter->AddObserver(vtkCommand::ErrorEvent, said);
  filter->SetInputData(
    ChargedPoints({ { IonPlace, IonRadius }, { { 9.0, 0.0, 0.0 }, 0.0 } }, { 1.0, 1.0 }, 0.1));
  filter->Update();
  EXPECT_NE(said->GetErrorMessage().find("outside"), std::string::npos) << said->GetErrorMessage();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetImage()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetUpdates()->GetNumberOfRows(), 0);
}

namespace
{

/// Two opposite ions with space between them, on a coarse grid.
vtkSmartPointer<vtkSolvationSurface> SurfaceOfIons()
{
  auto filter = vtkSmartPointer<vtkSolvationSurface>::New();
  const double half = 2.4;
  filter->SetInputData(ChargedPoints({ { { IonPlace[0] - half, IonPlace[1], IonPlace[2] }, 2.0 },
                                       { { IonPlace[0] + half, IonPlace[1], IonPlace[2] }, 1.6 } },
    { 1.0, -1.0 }, 0.1));
  filter->SetSpacing(0.5);
  filter->SetPadding(4.0);
  filter->SetProbeRadius(0.0);
  filter->SetUpdatePeriod(3);
  return filter;
}

/// All numbers of all updates.
std::vector<double> CollectHistory(vtkSolvationSurface* filter)
{
  filter->Update();
  vtkTable* table = filter->GetUpdates();
  std::vector<double> numbers;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
    {
      numbers.push_back(table->GetValue(row, column).ToDouble());
    }
  }
  return numbers;
}

}

TEST(SolvationSurface, EachPropertyHasItsEffect)
{
  using Filter = vtkSolvationSurface;
  const std::vector<double> usual = CollectHistory(SurfaceOfIons());
  ASSERT_FALSE(usual.empty());
  EXPECT_EQ(CollectHistory(SurfaceOfIons()), usual);
  const std::vector<std::pair<const char*, std::function<void(Filter*)>>> changes{
    { "Enlargement", [](Filter* f) { f->SetEnlargement(1.5); } },
    { "ProbeRadius", [](Filter* f) { f->SetProbeRadius(0.5); } },
    { "Spacing", [](Filter* f) { f->SetSpacing(0.6); } },
    { "Padding", [](Filter* f) { f->SetPadding(5.0); } },
    { "SoluteDielectric", [](Filter* f) { f->SetSoluteDielectric(4.0); } },
    { "SolventDielectric", [](Filter* f) { f->SetSolventDielectric(40.0); } },
    { "DielectricModel", [](Filter* f) { f->SetDielectricModel(Filter::SmoothDielectric); } },
    { "IonicStrength", [](Filter* f) { f->SetIonicStrength(0.5); } },
    { "Temperature", [](Filter* f) { f->SetTemperature(350.0); } },
    { "UpdatePeriod", [](Filter* f) { f->SetUpdatePeriod(10); } },
    { "SurfaceRelaxation", [](Filter* f) { f->SetSurfaceRelaxation(0.5); } },
    { "FieldRelaxation", [](Filter* f) { f->SetFieldRelaxation(0.5); } },
    { "EnergyTolerance", [](Filter* f) { f->SetEnergyTolerance(1e-9); } },
    { "MaximumUpdates", [](Filter* f) { f->SetMaximumUpdates(2); } },
    { "SurfaceTension", [](Filter* f) { f->SetSurfaceTension(0.1); } },
    { "Pressure", [](Filter* f) { f->SetPressure(0.1); } }
  };
  for (const auto& [name, change] : changes)
  {
    const auto filter = SurfaceOfIons();
    change(filter);
    EXPECT_NE(CollectHistory(filter), usual) << name;
  }
  // It shortens long periods only.
  const auto longer = [](bool adaptive)
  {
    const auto filter = SurfaceOfIons();
    filter->SetUpdatePeriod(100);
    filter->SetAdaptiveUpdate(adaptive);
    return CollectHistory(filter);
  };
  EXPECT_NE(longer(true), longer(false));
}
