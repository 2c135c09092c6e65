#include "Electrostatics/PoissonBoltzmannOutput.h"

#include "Atoms/MoleculeAtoms.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Electrostatics/BoundaryForces.h"
#include "Electrostatics/ChargesOnGrid.h"
#include "Electrostatics/ElectrostaticUnits.h"
#include "Electrostatics/SoluteVolume.h"
#include "Electrostatics/SurfacePotential.h"
#include "Surfaces/GridImages.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// kT/angstrom along the grid's axes as kcal/(mol angstrom) in the world.
void AddForces(vtkFieldData* data, const char* name, const std::vector<Point3>& forces,
  const SoluteVolume& volume, double kelvin)
{
  auto* array = AddArray<vtkDoubleArray>(data, name, forces.size(), 3);
  for (std::size_t i = 0; i < forces.size(); ++i)
  {
    Point3 world;
    volume.Grid->GetDirectionMatrix()->MultiplyPoint(forces[i].data(), world.data());
    for (double& force : world)
    {
      force *= units::ThermalKilocalorie(kelvin);
    }
    array->SetTuple(static_cast<vtkIdType>(i), world.data());
  }
}

/// The level as an image of -f, so that vtkFlyingEdges3D orients triangles outwards.
vtkSmartPointer<vtkPolyData> LevelTriangles(const SoluteVolume& volume)
{
  const LevelFunction& level = volume.Level;
  const auto& n = level.Dimensions();
  const auto values =
    NamedArray<vtkFloatArray>("Level", static_cast<std::size_t>(n[0] * n[1] * n[2]));
  vtkIdType id = 0;
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i)
      {
        values->SetValue(id++, static_cast<float>(-level.Node(i, j, k)));
      }
    }
  }
  return IsosurfaceInGridAxes(volume.Grid, values, 0.0);
}

}

void FillImage(const GridPotential& solution, vtkImageData* image, const ProgressCallback& progress)
{
  const SolverBox& box = solution.GetBox();
  SolverBox crop = box;
  int dimensions[3];
  image->GetDimensions(dimensions);
  for (std::size_t a = 0; a < 3; ++a)
  {
    crop.First[a] = 0;
    crop.Corner[a] = 0.0;
    crop.Dimensions[a] = dimensions[a];
  }
  const auto count = static_cast<std::size_t>(crop.Size());
  const auto potential = NamedArray<vtkDoubleArray>("Potential", count);
  const auto reaction = NamedArray<vtkDoubleArray>("ReactionPotential", count);
  const auto side = NamedArray<vtkUnsignedCharArray>("Side", count);
  double* const total = potential->GetPointer(0);
  double* const rest = reaction->GetPointer(0);
  unsigned char* const in = side->GetPointer(0);
  ChargesAtNodes(
    solution.GetCharges(), crop,
    [&](std::int64_t node, double g)
    {
      const std::int64_t i = node % crop.Dimensions[0] - box.First[0];
      const std::int64_t j = node / crop.Dimensions[0] % crop.Dimensions[1] - box.First[1];
      const std::int64_t k = node / (crop.Dimensions[0] * crop.Dimensions[1]) - box.First[2];
      const auto from =
        static_cast<std::size_t>(i + box.Dimensions[0] * (j + box.Dimensions[1] * k));
      const double u = solution.GetPotential()[from];
      const bool inside = solution.GetInside()[from] != 0;
      total[node] = inside ? u + g : u;
      rest[node] = inside ? u : u - g;
      in[node] = inside ? 1 : 0;
    },
    progress);
  // Not SetScalars, which would replace the input's active array.
  image->GetPointData()->AddArray(potential);
  image->GetPointData()->SetActiveScalars("Potential");
  image->GetPointData()->AddArray(reaction);
  image->GetPointData()->AddArray(side);
}

void FillFieldData(const GridPotential& solution, const PoissonBoltzmannParameters& parameters,
  double netCharge, const std::string& surface, vtkImageData* image)
{
  const PoissonBoltzmannReport& report = solution.GetReport();
  const double kelvin = parameters.Temperature;
  vtkFieldData* const data = image->GetFieldData();
  AddColumn<vtkDoubleArray>(
    data, "SolvationEnergy", { report.SolvationEnergy * units::ThermalKilocalorie(kelvin) });
  AddColumn<vtkDoubleArray>(data, "SolvationEnergyError",
    { report.SolvationEnergyError * units::ThermalKilocalorie(kelvin) });
  const double kilocalorie = units::ThermalKilocalorie(kelvin);
  AddNotes({ "Solvation energy " +
             FormatWithError(report.SolvationEnergy * kilocalorie,
               report.SolvationEnergyError * kilocalorie, "kcal/mol") +
             "." },
    image);
  AddColumn<vtkDoubleArray>(data, "SolvationEnergyKT", { report.SolvationEnergy });
  AddColumn<vtkDoubleArray>(
    data, "SolvationEnergyKilojoule", { report.SolvationEnergy * units::ThermalKilojoule(kelvin) });
  AddColumn<vtkDoubleArray>(data, "Iterations", { static_cast<double>(report.Iterations) });
  AddColumn<vtkDoubleArray>(
    data, "BorderIterations", { static_cast<double>(report.BorderIterations) });
  AddColumn<vtkDoubleArray>(data, "NewtonSteps", { static_cast<double>(report.NewtonSteps) });
  AddColumn<vtkDoubleArray>(data, "ResidualHistory", report.Residuals);
  AddColumn<vtkDoubleArray>(data, "Crossings", { static_cast<double>(report.Crossings) });
  AddColumn<vtkDoubleArray>(data, "LinearFits", { static_cast<double>(report.LinearFits) });
  AddColumn<vtkDoubleArray>(data, "GhostFits", { static_cast<double>(report.GhostFits) });
  AddColumn<vtkDoubleArray>(
    data, "DebyeLength", { solution.Kappa() > 0.0 ? 1.0 / solution.Kappa() : 0.0 });
  AddColumn<vtkDoubleArray>(data, "NetCharge", { netCharge });
  AddColumn<vtkStringArray>(data, "Surface", { surface });
}

void FillSurface(const GridPotential& solution, const SoluteVolume& volume, double kelvin,
  vtkPolyData* polygons, vtkPolyData* output, const ProgressCallback& progress)
{
  std::vector<Point3> places;
  if (polygons)
  {
    output->ShallowCopy(polygons);
    for (vtkIdType i = 0; i < polygons->GetNumberOfPoints(); ++i)
    {
      Point3 x;
      polygons->GetPoint(i, x.data());
      places.push_back(ToGrid(volume.Grid, x));
    }
  }
  else
  {
    const vtkSmartPointer<vtkPolyData> triangles = LevelTriangles(volume);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < triangles->GetNumberOfPoints(); ++i)
    {
      Point3 x;
      triangles->GetPoint(i, x.data());
      places.push_back(OnLevel(volume.Level, solution.GetBox(), x));
      points->InsertNextPoint(ToWorld(volume.Grid, places.back()).data());
    }
    output->SetPoints(points);
    output->SetPolys(triangles->GetPolys());
  }
  const SurfaceValues values = EvaluateAtSurface(solution, volume.Level, places, kelvin, progress);
  const auto normals = NamedArray<vtkDoubleArray>("Normals", places.size(), 3);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    double world[3];
    volume.Grid->GetDirectionMatrix()->MultiplyPoint(values.Normal[i].data(), world);
    normals->SetTuple(static_cast<vtkIdType>(i), world);
  }
  vtkPointData* const data = output->GetPointData();
  AddColumn<vtkDoubleArray>(data, "Potential", values.Potential);
  data->SetActiveScalars("Potential");
  AddColumn<vtkDoubleArray>(data, "NormalField", values.NormalField);
  AddColumn<vtkDoubleArray>(data, "SurfaceChargeDensity", values.ChargeDensity);
  data->AddArray(normals);
  data->SetActiveNormals("Normals");
}

void FillAtoms(
  const GridPotential& solution, const SoluteVolume& volume, double kelvin, vtkPointSet* atoms)
{
  const PoissonBoltzmannReport& report = solution.GetReport();
  std::vector<double> energies = report.AtomEnergies;
  for (double& energy : energies)
  {
    energy *= units::ThermalKilocalorie(kelvin);
  }
  vtkPointData* const data = atoms->GetPointData();
  AddColumn<vtkDoubleArray>(data, "ReactionPotential", report.AtomPotentials);
  AddColumn<vtkDoubleArray>(data, "AtomEnergy", energies);
  AddForces(data, "ReactionForce", report.AtomForces, volume, kelvin);
}

void FillBoundaryForces(const GridPotential& solution, const SoluteVolume& volume,
  const std::vector<ChargedAtom>& onGrid, vtkPointSet* atoms)
{
  const double kelvin = solution.GetParameters().Temperature;
  const SurfaceMotion motion(onGrid, volume.Decay);
  const BoundaryForces forces = ForcesOnBoundary(solution, motion);
  std::vector<Point3> all = solution.GetReport().AtomForces;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      all[i][a] += forces.Dielectric[i][a] + forces.Ionic[i][a];
    }
  }
  vtkPointData* data = atoms->GetPointData();
  AddForces(data, "DielectricBoundaryForce", forces.Dielectric, volume, kelvin);
  AddForces(data, "IonicBoundaryForce", forces.Ionic, volume, kelvin);
  AddForces(data, "PolarForce", all, volume, kelvin);
}

namespace
{

vtkSmartPointer<vtkFloatArray> Map(const char* name, vtkImageData* image, int components)
{
  auto map = NamedArray<vtkFloatArray>(
    name, static_cast<std::size_t>(image->GetNumberOfPoints()), components);
  map->FillValue(0.0F);
  return map;
}

/// Calls use(node of the image, node of the box) for all nodes of the image, in parallel.
template <class Use>
void ForEachBoxNode(vtkImageData* image, const SolverBox& box, const Use& use)
{
  int n[3];
  image->GetDimensions(n);
  ParallelFor(0, n[2], 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
      {
        for (std::int64_t j = 0; j < n[1]; ++j)
        {
          for (std::int64_t i = 0; i < n[0]; ++i)
          {
            use(static_cast<vtkIdType>(i + n[0] * (j + n[1] * k)),
              static_cast<std::size_t>(i - box.First[0] +
                box.Dimensions[0] * (j - box.First[1] + box.Dimensions[1] * (k - box.First[2]))));
          }
        }
      }
    });
}

vtkSmartPointer<vtkFloatArray> AccessMap(const GridPotential& solution, vtkImageData* image)
{
  auto map = Map("IonAccessibility", image, 1);
  const IonAtmosphere& ions = solution.GetIons();
  if (ions.Empty())
  {
    return map;
  }
  std::vector<float> share;
  for (std::size_t l = 0; l < ions.NumberOfLayers(); ++l)
  {
    share.push_back(static_cast<float>(ions.Derivative(l, 0.0) / ions.Linear()));
  }
  ForEachBoxNode(image, solution.GetBox(),
    [&](vtkIdType to, std::size_t from)
    {
      float sum = 0.0F;
      for (std::size_t l = 0; l < share.size(); ++l)
      {
        sum += share[l] * solution.GetAccess()[l][from];
      }
      map->SetValue(to, sum);
    });
  return map;
}

vtkSmartPointer<vtkFloatArray> ChargeMap(
  const std::vector<ChargedAtom>& onGrid, const SolverBox& box, vtkImageData* image)
{
  auto map = Map("ChargeDensity", image, 1);
  int n[3];
  image->GetDimensions(n);
  const double volume = box.Spacing[0] * box.Spacing[1] * box.Spacing[2];
  for (const ChargedAtom& atom : onGrid)
  {
    std::int64_t low[3];
    double t[3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double place = atom.Position[a] / box.Spacing[a];
      low[a] = static_cast<std::int64_t>(std::floor(place));
      t[a] = place - std::floor(place);
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      double weight = atom.Charge / volume;
      std::int64_t at[3];
      bool within = true;
      for (int a = 0; a < 3; ++a)
      {
        const bool upper = (corner >> a & 1) != 0;
        weight *= upper ? t[a] : 1.0 - t[a];
        at[a] = low[a] + (upper ? 1 : 0);
        within = within && at[a] >= 0 && at[a] < n[a];
      }
      if (within)
      {
        const vtkIdType node = at[0] + n[0] * (at[1] + n[1] * at[2]);
        map->SetValue(node, map->GetValue(node) + static_cast<float>(weight));
      }
    }
  }
  return map;
}

}

void FillMaps(
  const GridPotential& solution, const std::vector<ChargedAtom>& onGrid, vtkImageData* image)
{
  const SolverBox& box = solution.GetBox();
  auto dielectric = Map("Dielectric", image, 3);
  const char* const edges[] = { "x", "y", "z" };
  for (int a = 0; a < 3; ++a)
  {
    dielectric->SetComponentName(a, edges[a]);
  }
  const EdgePermittivity permittivity = solution.Permittivities();
  ForEachBoxNode(image, box,
    [&](vtkIdType to, std::size_t from)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        dielectric->SetTypedComponent(
          to, static_cast<int>(a), permittivity.Table[permittivity.Code[a][from]]);
      }
    });
  image->GetPointData()->AddArray(dielectric);
  image->GetPointData()->AddArray(AccessMap(solution, image));
  image->GetPointData()->AddArray(ChargeMap(onGrid, box, image));
}

}
