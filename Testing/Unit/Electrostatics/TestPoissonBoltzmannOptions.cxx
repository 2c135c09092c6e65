// Optional results of vtkPoissonBoltzmann: maps, forces through the surface, ions with radii.

#include "vtkPoissonBoltzmann.h"

#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{

/// A dipole and a second molecule, `gap` apart.
vtkSmartPointer<vtkPolyData> Atoms(double gap = 0.0)
{
  auto atoms = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> charges, radii;
  charges->SetName("Charge");
  radii->SetName("Radius");
  const double rows[][5] = { { 50.1, -20.2, 3.3, 0.9, 2.0 }, { 52.0, -20.0, 3.5, -0.4, 1.7 },
    { 51.3 + gap, -18.1, 3.0, 0.5, 1.8 } };
  for (const auto& row : rows)
  {
    points->InsertNextPoint(row[0], row[1], row[2]);
    charges->InsertNextValue(row[3]);
    radii->InsertNextValue(row[4]);
  }
  atoms->SetPoints(points);
  atoms->GetPointData()->AddArray(charges);
  atoms->GetPointData()->AddArray(radii);
  return atoms;
}

vtkSmartPointer<vtkPoissonBoltzmann> Solve(
  vtkPolyData* atoms, const std::function<void(vtkPoissonBoltzmann*)>& change)
{
  auto filter = vtkSmartPointer<vtkPoissonBoltzmann>::New();
  filter->SetInputDataObject(0, atoms);
  filter->SetSpacing(0.4);
  filter->SetPadding(5.0);
  change(filter);
  filter->Update();
  return filter;
}

double Energy(vtkPoissonBoltzmann* filter)
{
  return filter->GetOutput()->GetFieldData()->GetArray("SolvationEnergy")->GetTuple1(0);
}

TEST(PoissonBoltzmannOptions, MapsAreTheInputFieldsOfTheEquation)
{
  const auto filter = Solve(Atoms(),
    [](vtkPoissonBoltzmann* f)
    {
      f->GetOutputArraySelection()->EnableAllArrays();
      f->SetIonicStrength(0.15);
    });
  vtkImageData* image = filter->GetOutput();
  vtkPointData* data = image->GetPointData();
  vtkDataArray* dielectric = data->GetArray("Dielectric");
  vtkDataArray* access = data->GetArray("IonAccessibility");
  vtkDataArray* charge = data->GetArray("ChargeDensity");
  vtkDataArray* side = data->GetArray("Side");
  ASSERT_TRUE(dielectric && access && charge);
  ASSERT_EQ(dielectric->GetNumberOfComponents(), 3);
  int n[3];
  image->GetDimensions(n);
  double total = 0.0;
  int between = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    total += charge->GetTuple1(i) * 0.064;
    EXPECT_TRUE(side->GetTuple1(i) == 0.0 || access->GetTuple1(i) == 0.0);
    if (i % n[0] + 1 == n[0])
    {
      continue;
    }
    // Along x, an edge within one side has its permittivity, one that crosses a value between.
    const double eps = dielectric->GetComponent(i, 0);
    if (side->GetTuple1(i) == side->GetTuple1(i + 1))
    {
      EXPECT_NEAR(eps, side->GetTuple1(i) == 1.0 ? 2.0 : 80.0, 1e-4);
    }
    else
    {
      EXPECT_GE(eps, 2.0 - 1e-4);
      EXPECT_LE(eps, 80.0 + 1e-4);
      ++between;
    }
  }
  EXPECT_NEAR(total, 1.0, 1e-5);
  EXPECT_GT(between, 50);
  EXPECT_EQ(access->GetTuple1(0), 1.0);
  double range[2];
  access->GetRange(range);
  EXPECT_EQ(range[0], 0.0);
}

TEST(PoissonBoltzmannOptions, NothingIsAddedByDefault)
{
  const auto filter = Solve(Atoms(), [](vtkPoissonBoltzmann*) {});
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("Dielectric"), nullptr);
  EXPECT_EQ(filter->GetAtoms()->GetPointData()->GetArray("PolarForce"), nullptr);
}

/// The sum of a force over the atoms, and the largest force.
double NetForce(vtkPointSet* atoms, const char* name, double& largest)
{
  double net[3] = { 0.0, 0.0, 0.0 };
  largest = 0.0;
  vtkDataArray* forces = atoms->GetPointData()->GetArray(name);
  for (vtkIdType i = 0; i < atoms->GetNumberOfPoints(); ++i)
  {
    const double* f = forces->GetTuple3(i);
    largest = std::max(largest, std::hypot(f[0], f[1], f[2]));
    for (int a = 0; a < 3; ++a)
    {
      net[a] += f[a];
    }
  }
  return std::hypot(net[0], net[1], net[2]);
}

TEST(PoissonBoltzmannOptions, ForcesOnTwoMoleculesSumToZero)
{
  for (const double gap : { 0.0, 7.0 })
  {
    const auto filter = Solve(Atoms(gap),
      [](vtkPoissonBoltzmann* f)
      {
        f->GetOutputArraySelection()->EnableAllArrays();
        f->SetIonicStrength(0.15);
      });
    double largest = 0.0;
    const double net = NetForce(filter->GetAtoms(), "PolarForce", largest);
    EXPECT_GT(largest, 1.0);
    EXPECT_LT(net, 0.04 * largest);
    EXPECT_GT(NetForce(filter->GetAtoms(), "ReactionForce", largest), net);
  }
}

TEST(PoissonBoltzmannOptions, ForcesOnAPolygonalSurfaceSumToZero)
{
  const auto atoms = Atoms();
  const auto first = Solve(atoms, [](vtkPoissonBoltzmann*) {});
  const auto second = Solve(atoms,
    [&](vtkPoissonBoltzmann* f)
    {
      f->SetInputDataObject(1, first->GetSurface());
      f->GetOutputArraySelection()->EnableAllArrays();
    });
  double largest = 0.0;
  const double net = NetForce(second->GetAtoms(), "PolarForce", largest);
  EXPECT_LT(net, 0.1 * largest);
}

TEST(PoissonBoltzmannOptions, IonsMayHaveIndividualRadii)
{
  const auto energy = [](double cation, double anion)
  {
    return Energy(Solve(Atoms(),
      [&](vtkPoissonBoltzmann* f)
      {
        f->AddIon(1.0, 0.5, cation);
        f->AddIon(-1.0, 0.5, anion);
      }));
  };
  const double two =
    Energy(Solve(Atoms(), [](vtkPoissonBoltzmann* f) { f->SetIonicStrength(0.5); }));
  EXPECT_NEAR(energy(2.0, 2.0), two, 1e-12 * std::abs(two));
  // The closer ions approach, the more they lower the energy; in the linear equation both kinds
  // alike.
  EXPECT_LT(energy(1.0, 2.0), two - 1e-3);
  EXPECT_GT(energy(3.0, 2.0), two + 1e-3);
  EXPECT_NEAR(energy(1.0, 2.0), energy(2.0, 1.0), 1e-6 * std::abs(two));
}

TEST(PoissonBoltzmannOptions, AnInvalidRadiusIsReported)
{
  vtkNew<vtkPoissonBoltzmann> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->SetInputDataObject(0, Atoms());
  filter->AddIon(1.0, 0.1, -0.5);
  filter->AddIon(-1.0, 0.1, 2.0);
  filter->Update();
  EXPECT_NE(observer->GetErrorMessage().find("radius"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

}
