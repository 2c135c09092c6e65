#include "vtkPoissonBoltzmann.h"

#include "Atoms/MoleculeAtoms.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ImageExtent.h"
#include "Core/MemoryBudget.h"
#include "Core/NumberText.h"
#include "Core/PipelineInputs.h"
#include "Core/RangeChecks.h"
#include "Electrostatics/ElectrostaticUnits.h"
#include "Electrostatics/ForceFieldAtoms.h"
#include "Electrostatics/PoissonBoltzmann.h"
#include "Electrostatics/PoissonBoltzmannInput.h"
#include "Electrostatics/PoissonBoltzmannOutput.h"
#include "Electrostatics/SoluteVolume.h"

#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkPoissonBoltzmann);

using Pipeline = vtkStreamingDemandDrivenPipeline;

const std::vector<isthmus::OutputArray>& vtkPoissonBoltzmann::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Potential", 1, "kT/e", ArrayChoice::None, "electrostatic potential" },
    { 0, ArrayPlace::Points, "ReactionPotential", 1, "kT/e", ArrayChoice::None,
      "the potential minus that of the charges in a medium with SoluteDielectric everywhere" },
    { 0, ArrayPlace::Points, "Side", 1, "", ArrayChoice::None, "1 inside the solute" },
    { 0, ArrayPlace::Points, "Dielectric", 3, "", ArrayChoice::Off,
      "of the edges from the node along x, y and z, like dielx, diely and dielz of APBS; if the "
      "surface cuts an edge, its parts are in series, rounded to 1/255" },
    { 0, ArrayPlace::Points, "IonAccessibility", 1, "", ArrayChoice::Off,
      "fraction of the node's cell that ions reach, weighted by z^2 c if radii differ" },
    { 0, ArrayPlace::Points, "ChargeDensity", 1, "e/angstrom^3", ArrayChoice::Off,
      "trilinear; the solver itself uses point charges" },
    { 0, ArrayPlace::Field, "SolvationEnergy", 1, "kcal/mol", ArrayChoice::None,
      "from a medium with SoluteDielectric everywhere into the solvent" },
    { 0, ArrayPlace::Field, "SolvationEnergyError", 1, "kcal/mol", ArrayChoice::None,
      "estimated from coarser grids: the error due to the resolution, not to the choice of the "
      "surface" },
    { 0, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,
      "the energy and its error in words" },
    { 0, ArrayPlace::Field, "SolvationEnergyKT", 1, "kT", ArrayChoice::None,
      "the solvation energy" },
    { 0, ArrayPlace::Field, "SolvationEnergyKilojoule", 1, "kJ/mol", ArrayChoice::None,
      "the solvation energy" },
    { 0, ArrayPlace::Field, "Iterations", 1, "", ArrayChoice::None,
      "of BiCGSTAB on this grid, including those of all Newton steps and those for the border "
      "values on this grid" },
    { 0, ArrayPlace::Field, "BorderIterations", 1, "", ArrayChoice::None,
      "on a coarser grid, for the border values" },
    { 0, ArrayPlace::Field, "NewtonSteps", 1, "", ArrayChoice::None, "0 unless Nonlinear is on" },
    { 0, ArrayPlace::Field, "ResidualHistory", 1, "", ArrayChoice::None, "of the last solution" },
    { 0, ArrayPlace::Field, "Crossings", 1, "", ArrayChoice::None,
      "edges of the grid that the surface cuts" },
    { 0, ArrayPlace::Field, "LinearFits", 1, "", ArrayChoice::None,
      "crossings of the surface at which a linear fit replaced the quadratic one" },
    { 0, ArrayPlace::Field, "GhostFits", 1, "", ArrayChoice::None,
      "crossings at which an even simpler fit was used, most of them in cavities and clefts one or "
      "two nodes wide" },
    { 0, ArrayPlace::Field, "DebyeLength", 1, "angstrom", ArrayChoice::None, "0 without salt" },
    { 0, ArrayPlace::Field, "NetCharge", 1, "e", ArrayChoice::None, "of the atoms" },
    { 0, ArrayPlace::Field, "Surface", 1, "", ArrayChoice::None, "the source of the surface" },
    { 1, ArrayPlace::Points, "Potential", 1, "kT/e", ArrayChoice::None, "electrostatic potential" },
    { 1, ArrayPlace::Points, "NormalField", 1, "kT/(e angstrom)", ArrayChoice::None,
      "outwards, just outside" },
    { 1, ArrayPlace::Points, "SurfaceChargeDensity", 1, "e/angstrom^2", ArrayChoice::None,
      "induced" },
    { 1, ArrayPlace::Points, "Normals", 3, "", ArrayChoice::None, "of the surface" },
    { 2, ArrayPlace::Points, "ReactionPotential", 1, "kT/e", ArrayChoice::None, "at the atom" },
    { 2, ArrayPlace::Points, "AtomEnergy", 1, "kcal/mol", ArrayChoice::None,
      "contribution of the atom to the solvation energy; the contributions add up to it unless "
      "Nonlinear is on" },
    { 2, ArrayPlace::Points, "ReactionForce", 3, "kcal/(mol angstrom)", ArrayChoice::None,
      "-q grad u, the force of the reaction field on the charge" },
    { 2, ArrayPlace::Points, "DielectricBoundaryForce", 3, "kcal/(mol angstrom)", ArrayChoice::Off,
      "force of the field on the atom's part of the surface" },
    { 2, ArrayPlace::Points, "IonicBoundaryForce", 3, "kcal/(mol angstrom)", ArrayChoice::Off,
      "force of the ions on the atom's part of the surface" },
    { 2, ArrayPlace::Points, "PolarForce", 3, "kcal/(mol angstrom)", ArrayChoice::Off,
      "sum of the three forces; the Coulomb force between the charges is not included" },
  };
  return table;
}

vtkPoissonBoltzmann::vtkPoissonBoltzmann()
  : OutputArrays(this, OutputArrayTable())
  , Advance(std::make_unique<isthmus::InputInAdvance>(this))
  , Cache(std::make_unique<isthmus::ForceFieldAtomsCache>())
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(3);
  const int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  this->SetInputArrayToProcess(0, 0, 0, points, "Radius");
  this->SetInputArrayToProcess(1, 0, 0, points, "Charge");
  // None for the other ports: ParaView 5.11 aborts on arrays to process there.
}

vtkPoissonBoltzmann::~vtkPoissonBoltzmann() = default;

void vtkPoissonBoltzmann::AddIon(double valence, double concentration)
{
  this->Parameters.Ions.push_back({ valence, concentration });
  this->Modified();
}

void vtkPoissonBoltzmann::AddIon(double valence, double concentration, double radius)
{
  // NaN where none is given: for values below 0 the algorithm would use IonRadius.
  this->Parameters.Ions.push_back(
    { valence, concentration, radius >= 0.0 ? radius : std::numeric_limits<double>::quiet_NaN() });
  this->Modified();
}

void vtkPoissonBoltzmann::ClearIons()
{
  if (!this->Parameters.Ions.empty())
  {
    this->Parameters.Ions.clear();
    this->Modified();
  }
}

int vtkPoissonBoltzmann::GetNumberOfIons()
{
  return static_cast<int>(this->Parameters.Ions.size());
}

vtkPolyData* vtkPoissonBoltzmann::GetSurface()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

vtkPointSet* vtkPoissonBoltzmann::GetAtoms()
{
  return vtkPointSet::SafeDownCast(this->GetOutputDataObject(2));
}

int vtkPoissonBoltzmann::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkImageData");
  if (port == 1)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  }
  if (port > 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkPoissonBoltzmann::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* const types[] = { "vtkImageData", "vtkPolyData", "vtkPointSet" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
  return 1;
}

vtkTypeBool vtkPoissonBoltzmann::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->MakeOutputs(inputVector, outputVector);
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

int vtkPoissonBoltzmann::MakeOutputs(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto ensure = [&](int port, vtkDataObject* wanted)
  {
    vtkInformation* info = outputVector->GetInformationObject(port);
    vtkDataObject* present = info->Get(vtkDataObject::DATA_OBJECT());
    if (!present || !present->IsA(wanted->GetClassName()))
    {
      vtkSmartPointer<vtkDataObject> made =
        vtkSmartPointer<vtkDataObject>::Take(wanted->NewInstance());
      info->Set(vtkDataObject::DATA_OBJECT(), made);
    }
  };
  vtkNew<vtkImageData> image;
  vtkNew<vtkPolyData> surface;
  ensure(0, image);
  ensure(1, surface);
  vtkPointSet* atoms = vtkPointSet::GetData(inputVector[0], 0);
  ensure(2, atoms ? static_cast<vtkDataObject*>(atoms) : surface);
  return 1;
}

int vtkPoissonBoltzmann::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkDataObject::SetPointDataActiveScalarInfo(outInfo, VTK_DOUBLE, 1);
  vtkInformation* info = inputVector[1]->GetInformationObject(0);
  if (vtkImageData::GetData(info))
  {
    outInfo->CopyEntry(info, Pipeline::WHOLE_EXTENT());
    outInfo->CopyEntry(info, vtkDataObject::ORIGIN());
    outInfo->CopyEntry(info, vtkDataObject::SPACING());
    outInfo->CopyEntry(info, vtkDataObject::DIRECTION());
    return 1;
  }
  // The extent of the grid follows from the surface or the atoms of the input. pdb2pqr is not run
  // here.
  this->Advance->Update(vtkPolyData::GetData(info) ? 1 : 0);
  isthmus::SetImageInformation(outInfo,
    [&](vtkImageData* grid)
    {
      this->Advance->RequireOneRank(0, "atoms");
      this->Advance->RequireOneRank(1, "points of the surface");
      vtkPolyData* surface = vtkPolyData::GetData(info);
      vtkPointSet* atoms = vtkPointSet::GetData(inputVector[0], 0);
      if (surface && surface->GetNumberOfPoints() > 0)
      {
        grid->CopyStructure(isthmus::GridAroundSurface(surface, this->Parameters));
      }
      else if (!surface && atoms && atoms->GetNumberOfPoints() > 0)
      {
        grid->CopyStructure(this->GridAround(atoms));
      }
    });
  return 1;
}

vtkSmartPointer<vtkImageData> vtkPoissonBoltzmann::GridAround(vtkPointSet* atoms)
{
  const isthmus::ChargeArrays arrays{ isthmus::InputArrayName(this, 1),
    isthmus::InputArrayName(this, 0) };
  isthmus::GridRequest wish = this->Parameters;
  if (!isthmus::LacksCharges(atoms, arrays))
  {
    return isthmus::GridAroundAtoms(isthmus::ReadSolute(this, atoms, true).Atoms, wish);
  }
  wish.Padding += isthmus::HydrogenMargin;
  return isthmus::GridAroundAtoms(isthmus::PolymerWithoutCharges(atoms), wish);
}

int vtkPoissonBoltzmann::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 1; port < 3; ++port)
  {
    vtkInformation* info = inputVector[port]->GetInformationObject(0);
    if (info && info->Has(Pipeline::WHOLE_EXTENT()))
    {
      int whole[6];
      info->Get(Pipeline::WHOLE_EXTENT(), whole);
      info->Set(Pipeline::UPDATE_EXTENT(), whole, 6);
    }
  }
  return 1;
}

int vtkPoissonBoltzmann::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  isthmus::ClearOutputs(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      this->OutputArrays.Check();
      vtkPointSet* atoms = vtkPointSet::GetData(inputVector[0], 0);
      this->Advance->RequireOneRank(0, "atoms");
      this->Advance->RequireOneRank(1, "points of the surface");
      isthmus::RequireFinitePositions(vtkPointSet::GetData(inputVector[1], 0), "the surface");
      if (atoms && atoms->GetNumberOfPoints() > 0)
      {
        this->Solve(inputVector, outputVector);
      }
    });
}

vtkPointSet* vtkPoissonBoltzmann::AtomsWithCharges(vtkInformationVector** inputVector)
{
  vtkPointSet* atoms = vtkPointSet::GetData(inputVector[0], 0);
  const isthmus::ChargeArrays arrays{ isthmus::InputArrayName(this, 1),
    isthmus::InputArrayName(this, 0) };
  if (!atoms || atoms->GetNumberOfPoints() == 0 || !isthmus::LacksCharges(atoms, arrays))
  {
    return atoms;
  }
  return this->Cache->Get(atoms, nullptr, arrays,
    static_cast<isthmus::ChargeTable>(this->ForceField),
    isthmus::Between(isthmus::MakeProgress(this), 0.0, 0.05));
}

void vtkPoissonBoltzmann::Warn(const std::string& sentence)
{
  if (!sentence.empty())
  {
    vtkWarningMacro(<< sentence);
  }
}

void vtkPoissonBoltzmann::StateError(const isthmus::SoluteVolume& volume,
  isthmus::GridPotential& solution, const isthmus::ProgressCallback& progress)
{
  constexpr double large = 0.05;
  const double error = isthmus::EstimateEnergyError(volume.Level, solution, progress) +
    (volume.IsMask ? isthmus::EstimateMaskError(volume.Level, solution) : 0.0);
  solution.SetEnergyError(error);
  const double energy = std::abs(solution.GetReport().SolvationEnergy);
  if (error > large * energy)
  {
    const double kilocalorie = isthmus::units::ThermalKilocalorie(this->Parameters.Temperature);
    vtkWarningMacro(<< isthmus::JoinText("The grid is coarse for the surface or for the charges "
                                         "under it: the solvation energy is uncertain by about ",
                      isthmus::FormatNumber(error * kilocalorie, 2), " kcal/mol, ",
                      error < energy ? isthmus::FormatNumber(100.0 * error / energy, 2) + " % of it"
                                     : std::string("more than its size"),
                      ". Choose a smaller Spacing, or a finer volume on input 1."));
  }
}

void vtkPoissonBoltzmann::Solve(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  isthmus::Check(this->Parameters);
  isthmus::RequireRange("Level", this->Level, -isthmus::LargestPeak, isthmus::LargestPeak);
  const auto progress = isthmus::MakeProgress(this);
  vtkPointSet* points = this->AtomsWithCharges(inputVector);
  vtkImageData* image = vtkImageData::GetData(inputVector[1], 0);
  vtkPolyData* polygons = vtkPolyData::GetData(inputVector[1], 0);
  isthmus::PoissonBoltzmannParameters parameters = this->Parameters;
  isthmus::SoluteAtoms atoms = isthmus::ReadSolute(this, points, !image && !polygons);
  this->Warn(points == vtkPointSet::GetData(inputVector[0], 0) ? "" : this->Cache->Warning());
  this->Warn(atoms.Warning);
  isthmus::SoluteVolume volume = image
    ? isthmus::VolumeFromImage(image, isthmus::SurfaceScalars(image), this->Level,
        this->InsideIsHigher, isthmus::Between(progress, 0.0, 0.05))
    : polygons
    ? isthmus::VolumeFromSurface(polygons, parameters, isthmus::Between(progress, 0.0, 0.05))
    : isthmus::VolumeFromAtoms(atoms.Atoms,
        this->GridAround(vtkPointSet::GetData(inputVector[0], 0)),
        isthmus::Between(progress, 0.0, 0.05));
  isthmus::PlaceOnGrid(volume, atoms.Atoms);
  isthmus::SetPotentialInput(vtkImageData::GetData(inputVector[2], 0), volume.Grid, parameters);
  using isthmus::BoundaryCondition;
  const double padding =
    parameters.BoundaryCondition == BoundaryCondition::Given ? 0.0 : parameters.Padding;
  const isthmus::SolverBox box = isthmus::BoxAround(volume.Level, padding);
  isthmus::MemoryBudget().RequireGrid(
    box.Dimensions, isthmus::SolutionBytesPerNode, "choose a larger Spacing or a smaller Padding");
  const isthmus::IonAtmosphere ions(parameters.AllIons(), parameters.Temperature);
  const auto solution = isthmus::SolvePoissonBoltzmann(
    volume.Level, box, atoms.Atoms, parameters, ions, isthmus::Between(progress, 0.05, 0.65));
  this->StateError(volume, *solution, isthmus::Between(progress, 0.65, 0.75));
  const double kappa = solution->Kappa();
  if (kappa > 0.0 && parameters.Padding * kappa < 1.0 &&
    parameters.BoundaryCondition != BoundaryCondition::SelfConsistent &&
    parameters.BoundaryCondition != BoundaryCondition::Given)
  {
    vtkWarningMacro(<< isthmus::JoinText("Padding is ", parameters.Padding,
                      " angstrom, less than the Debye length of ", 1.0 / kappa,
                      ": the border is close enough to affect the result."));
  }
  auto* output = vtkImageData::GetData(outputVector, 0);
  if (image)
  {
    output->ShallowCopy(image);
  }
  else
  {
    output->CopyStructure(volume.Grid);
  }
  isthmus::FillImage(*solution, output, isthmus::Between(progress, 0.75, 0.9));
  if (this->OutputArrays.HasAny({ "Dielectric", "IonAccessibility", "ChargeDensity" }))
  {
    isthmus::FillMaps(*solution, atoms.Atoms, output);
    this->OutputArrays.RemoveOthers(
      { "Dielectric", "IonAccessibility", "ChargeDensity" }, output->GetPointData());
  }
  isthmus::FillFieldData(*solution, parameters, atoms.NetCharge, volume.Kind, output);
  isthmus::FillSurface(*solution, volume, parameters.Temperature, polygons,
    vtkPolyData::GetData(outputVector, 1), isthmus::Between(progress, 0.9, 1.0));
  auto* atomsOut = vtkPointSet::GetData(outputVector, 2);
  atomsOut->ShallowCopy(points);
  isthmus::FillAtoms(*solution, volume, parameters.Temperature, atomsOut);
  if (this->OutputArrays.HasAny({ "DielectricBoundaryForce", "IonicBoundaryForce", "PolarForce" }))
  {
    isthmus::FillBoundaryForces(*solution, volume, atoms.Atoms, atomsOut);
    this->OutputArrays.RemoveOthers(
      { "DielectricBoundaryForce", "IonicBoundaryForce", "PolarForce" }, atomsOut->GetPointData());
  }
}

void vtkPoissonBoltzmann::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "InsideIsHigher: " << this->InsideIsHigher << "\n";
  os << indent << "SoluteDielectric: " << this->GetSoluteDielectric() << "\n";
  os << indent << "SolventDielectric: " << this->GetSolventDielectric() << "\n";
  os << indent << "IonicStrength: " << this->GetIonicStrength() << "\n";
  os << indent << "Ions: " << this->Parameters.Ions.size() << "\n";
  os << indent << "IonRadius: " << this->GetIonRadius() << "\n";
  os << indent << "Temperature: " << this->GetTemperature() << "\n";
  os << indent << "Spacing: " << this->GetSpacing() << "\n";
  os << indent << "Padding: " << this->GetPadding() << "\n";
  os << indent << "Nonlinear: " << this->GetNonlinear() << "\n";
  os << indent << "BoundaryCondition: " << this->GetBoundaryCondition() << "\n";
  os << indent << "ForceField: " << this->ForceField << "\n";
  os << indent << "DielectricModel: " << this->GetDielectricModel() << "\n";
  os << indent << "Tolerance: " << this->GetTolerance() << "\n";
  os << indent << "MaximumIterations: " << this->GetMaximumIterations() << "\n";
  this->OutputArrays.Print(os, indent);
}
