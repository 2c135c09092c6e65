// The smooth mode (a permittivity for each edge): ions compared with Born's formula, with the order
// of convergence; Kirkwood's spheres in salt; the field's flux; the filter.

#include "SphereProblem.h"
#include "vtkPoissonBoltzmann.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

SphereErrors SmoothErrors(const KirkwoodSphere& sphere, double half, double h)
{
  SphereProblem problem(sphere, half, h);
  problem.Parameters.DielectricModel = DielectricModel::SmoothDielectric;
  const auto solution = problem.Solve();
  const SphereErrors errors = RecordErrors(problem, *solution);
  const PoissonBoltzmannReport& report = solution->GetReport();
  std::printf("R %g h %g: energy %.5f outside %.4f inside %.4f iterations %d\n", sphere.Radius, h,
    errors.Energy, errors.Outside, errors.Inside, report.Iterations);
  EXPECT_LE(report.Iterations, 10);
  EXPECT_EQ(report.LinearFits + report.GhostFits, 0);
  return errors;
}

KirkwoodSphere Ion(double radius, const Point3& center = { 0.11, -0.07, 0.05 })
{
  KirkwoodSphere ion = Kirkwood(1);
  ion.Radius = radius;
  ion.Center = center;
  ion.Charges.front().Position = center;
  return ion;
}

TEST(SmoothDielectric, IonsHaveBornsEnergy)
{
  const double most[3] = { 1.0e-2, 2.5e-3, 1.0e-3 };
  for (const Point3& center : { Point3{ 0.11, -0.07, 0.05 }, Point3{ 0.0, 0.0, 0.0 } })
  {
    for (int r = 0; r < 3; ++r)
    {
      const double radius = 1.0 + r;
      EXPECT_LE(SmoothErrors(Ion(radius, center), radius + 2.0, 0.25).Energy, most[r]);
    }
  }
}

TEST(SmoothDielectric, EnergyIsSecondOrder)
{
  const SphereErrors coarse = SmoothErrors(Ion(2.0), 4.0, 0.5);
  const SphereErrors fine = SmoothErrors(Ion(2.0), 4.0, 0.125);
  EXPECT_GT(0.5 * std::log2(coarse.Energy / fine.Energy), 1.8);
  EXPECT_GT(0.5 * std::log2(coarse.Outside / fine.Outside), 0.9);
}

TEST(SmoothDielectric, ChargesOffTheCenterInElectrolyte)
{
  const SphereErrors errors = SmoothErrors(Kirkwood(3), 10.0, 0.5);
  EXPECT_LE(errors.Energy, 4e-3);
  EXPECT_LE(errors.Outside, 0.5);
  // The sharp interface on the same nodes.
  SphereProblem sharp(Kirkwood(3), 10.0, 0.5);
  EXPECT_LT(4.0 * RecordErrors(sharp, *sharp.Solve()).Energy, errors.Energy);
}

TEST(SmoothDielectric, FluxIsTheCharge)
{
  // The field's flux through the box is the charge within, as exactly as sums over the surface's
  // edges give that of charges two spacings under it.
  SphereProblem problem(Kirkwood(4), 10.0, 0.5);
  problem.Parameters.DielectricModel = DielectricModel::SmoothDielectric;
  const auto solution = problem.Solve();
  const SolverBox& box = solution->GetBox();
  double flux = 0.0;
  for (std::int64_t node = 0; node < box.Size(); ++node)
  {
    const std::int64_t nx = box.Dimensions[0], ny = box.Dimensions[1];
    const std::int64_t at[3] = { node % nx, node / nx % ny, node / (nx * ny) };
    for (std::size_t a = 0; a < 3; ++a)
    {
      bool face = at[a] == 0 || at[a] == box.Dimensions[a] - 1;
      for (std::size_t b = 0; b < 3; ++b)
      {
        face = face && (b == a || (at[b] > 0 && at[b] < box.Dimensions[b] - 1));
      }
      if (face)
      {
        const std::int64_t in = node + (at[a] == 0 ? 1 : -1) * box.Steps()[a];
        const auto& u = solution->GetPotential();
        flux += 80.0 * 0.5 * (u[static_cast<std::size_t>(in)] - u[static_cast<std::size_t>(node)]);
      }
    }
  }
  EXPECT_NEAR(flux / (4.0 * Pi * units::CoulombLength(298.15)), 1.0, 5e-3);
}

double FilterEnergy(vtkPolyData* atoms, int model)
{
  vtkNew<vtkPoissonBoltzmann> filter;
  filter->SetInputDataObject(0, atoms);
  filter->SetSoluteDielectric(1.0);
  filter->SetSpacing(0.25);
  filter->SetPadding(4.0);
  filter->SetDielectricModel(model);
  filter->Update();
  vtkDataArray* potential = filter->GetSurface()->GetPointData()->GetArray("Potential");
  for (vtkIdType i = 0; i < potential->GetNumberOfTuples(); ++i)
  {
    // C / (80 R) on the ball; the smooth mode reproduces it to the first order.
    EXPECT_NEAR(potential->GetTuple1(i), 3.503, 0.03);
  }
  return filter->GetOutput()->GetFieldData()->GetArray("SolvationEnergy")->GetTuple1(0);
}

TEST(SmoothDielectric, FilterHasBothModels)
{
  vtkNew<vtkPolyData> atoms;
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> charge, radius;
  points->InsertNextPoint(7.03, -2.01, 1.04);
  charge->SetName("Charge");
  charge->InsertNextValue(1.0);
  radius->SetName("Radius");
  radius->InsertNextValue(2.0);
  atoms->SetPoints(points);
  atoms->GetPointData()->AddArray(charge);
  atoms->GetPointData()->AddArray(radius);
  const double born = Kirkwood(1).Energy() * units::ThermalKilocalorie(298.15);
  const double sharp = FilterEnergy(atoms, vtkPoissonBoltzmann::SharpInterface);
  const double smooth = FilterEnergy(atoms, vtkPoissonBoltzmann::SmoothDielectric);
  EXPECT_NEAR(sharp / born, 1.0, 3e-4);
  EXPECT_NEAR(smooth / born, 1.0, 2.5e-3);
  EXPECT_GT(std::abs(smooth / sharp - 1.0), 3e-4);
}

}
