#include "vtkPoissonBoltzmann.h"

#include "Atoms/MoleculeAtoms.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ImageExtent.h"
#include "Core/NumberText.h"
#include "Core/PipelineInputs.h"
#include "Core/RangeChecks.h"
#include "Electrostatics/ForceFieldAtoms.h"
#include "Electrostatics/PoissonBoltzmann.h"
#include "Electrostatics/PoissonBoltzmannInput.h"
#include "Electrostatics/PoissonBoltzmannOutput.h"
#include "Electrostatics/SoluteVolume.h"
#include "Electrostatics/SolverMemory.h"

#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <cmath>
#include <limits>
#include <stdexcept>

vtkStandardNewMacro(vtkPoissonBoltzmann);

using Pipeline = vtkStreamingDemandDrivenPipeline;

struct vtkPoissonBoltzmann::Salt
{
  std::vector<isthmus::IonSpecies> Species;
};

vtkPoissonBoltzmann::vtkPoissonBoltzmann()
  : Ions(std::make_unique<Salt>())
  , Advance(std::make_unique<isthmus::InputInAdvance>(this))
  , Charged(std::make_unique<isthmus::ForceFieldAtomsCache>())
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(3);
  const int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  this->SetInputArrayToProcess(0, 0, 0, points, "Charge");
  this->SetInputArrayToProcess(1, 0, 0, points, "Radius");
  // None for the other ports: ParaView 5.11 aborts on arrays to process there.
}

vtkPoissonBoltzmann::~vtkPoissonBoltzmann() = default;

void vtkPoissonBoltzmann::SetChargeArrayName(const char* name)
{
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
}

void vtkPoissonBoltzmann::SetRadiusArrayName(const char* name)
{
  this->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
}

void vtkPoissonBoltzmann::AddIon(double valence, double concentration)
{
  this->Ions->Species.push_back({ valence, concentration });
  this->Modified();
}

void vtkPoissonBoltzmann::AddIon(double valence, double concentration, double radius)
{
  // NaN where none is meant: below 0 the algorithm would take IonRadius.
  this->Ions->Species.push_back(
    { valence, concentration, radius >= 0.0 ? radius : std::numeric_limits<double>::quiet_NaN() });
  this->Modified();
}

void vtkPoissonBoltzmann::ClearIons()
{
  if (!this->Ions->Species.empty())
  {
    this->Ions->Species.clear();
    this->Modified();
  }
}

int vtkPoissonBoltzmann::GetNumberOfIons()
{
  return static_cast<int>(this->Ions->Species.size());
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
  // The extent of the grid is that of the surface or of the atoms as they come. No program runs
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
        grid->CopyStructure(isthmus::GridAroundSurface(surface, { this->Spacing, this->Padding }));
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
  const isthmus::ChargeArrays arrays{ isthmus::InputArrayName(this, 0),
    isthmus::InputArrayName(this, 1) };
  isthmus::GridRequest wish{ this->Spacing, this->Padding };
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
  return isthmus::Guarded(this, outputVector,
    [&]()
    {
      vtkPointSet* atoms = vtkPointSet::GetData(inputVector[0], 0);
      this->Advance->RequireOneRank(0, "atoms");
      this->Advance->RequireOneRank(1, "points of the surface");
      isthmus::RequirePlaces(vtkPointSet::GetData(inputVector[1], 0), "the surface");
      if (atoms && atoms->GetNumberOfPoints() > 0)
      {
        this->Solve(inputVector, outputVector);
      }
    });
}

isthmus::PoissonBoltzmannParameters vtkPoissonBoltzmann::Parameters() const
{
  isthmus::PoissonBoltzmannParameters p;
  p.SoluteDielectric = this->SoluteDielectric;
  p.SolventDielectric = this->SolventDielectric;
  p.IonRadius = this->IonRadius;
  p.Temperature = this->Temperature;
  p.Padding = this->Padding;
  p.Nonlinear = this->Nonlinear;
  p.Condition = static_cast<isthmus::BoundaryCondition>(this->BoundaryCondition);
  p.Dielectric = static_cast<isthmus::DielectricModel>(this->DielectricModel);
  p.Tolerance = this->Tolerance;
  p.MaximumIterations = this->MaximumIterations;
  p.Ions = this->Ions->Species;
  if (!(this->IonicStrength >= 0.0) || std::isinf(this->IonicStrength))
  {
    throw std::invalid_argument("IonicStrength is " + isthmus::FormatNumber(this->IonicStrength) +
      " mol/l, but it is 0 or more: 0.15 is physiological.");
  }
  if (p.Ions.empty() && this->IonicStrength > 0.0)
  {
    p.Ions = { { 1.0, this->IonicStrength }, { -1.0, this->IonicStrength } };
  }
  if (!std::isfinite(this->Level))
  {
    throw std::invalid_argument("Level is " + isthmus::FormatNumber(this->Level) +
      ", but it is a level of the surface's scalars: give a finite number.");
  }
  isthmus::CheckParameters(p);
  return p;
}

vtkPointSet* vtkPoissonBoltzmann::AtomsWithCharges(vtkInformationVector** inputVector)
{
  vtkPointSet* atoms = vtkPointSet::GetData(inputVector[0], 0);
  const isthmus::ChargeArrays arrays{ isthmus::InputArrayName(this, 0),
    isthmus::InputArrayName(this, 1) };
  if (!atoms || atoms->GetNumberOfPoints() == 0 || !isthmus::LacksCharges(atoms, arrays))
  {
    return atoms;
  }
  return this->Charged->Get(atoms, arrays, static_cast<isthmus::ChargeTable>(this->ForceField),
    isthmus::Between(isthmus::ProgressOf(this), 0.0, 0.05));
}

void vtkPoissonBoltzmann::Warn(const std::string& sentence)
{
  if (!sentence.empty())
  {
    vtkWarningMacro(<< sentence);
  }
}

void vtkPoissonBoltzmann::Solve(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto progress = isthmus::ProgressOf(this);
  vtkPointSet* points = this->AtomsWithCharges(inputVector);
  vtkImageData* image = vtkImageData::GetData(inputVector[1], 0);
  vtkPolyData* polygons = vtkPolyData::GetData(inputVector[1], 0);
  isthmus::PoissonBoltzmannParameters parameters = this->Parameters();
  isthmus::SoluteAtoms atoms = isthmus::ReadSolute(this, points, !image && !polygons);
  this->Warn(points == vtkPointSet::GetData(inputVector[0], 0) ? "" : this->Charged->Warning());
  this->Warn(atoms.Warning);
  const isthmus::GridRequest wish{ this->Spacing, this->Padding };
  isthmus::SoluteVolume volume = image
    ? isthmus::VolumeOfImage(image, isthmus::SurfaceScalars(image), this->Level,
        this->InsideIsHigher, isthmus::Between(progress, 0.0, 0.05))
    : polygons
    ? isthmus::VolumeOfSurface(polygons, wish, isthmus::Between(progress, 0.0, 0.05))
    : isthmus::VolumeOfAtoms(atoms.Atoms, this->GridAround(vtkPointSet::GetData(inputVector[0], 0)),
        isthmus::Between(progress, 0.0, 0.05));
  isthmus::PlaceOnGrid(volume, atoms.Atoms);
  isthmus::SetPotentialInput(vtkImageData::GetData(inputVector[2], 0), volume.Grid, parameters);
  const double padding =
    parameters.Condition == isthmus::BoundaryCondition::Given ? 0.0 : parameters.Padding;
  const isthmus::SolverBox box = isthmus::BoxAround(volume.Level, padding);
  isthmus::RequireMemory(box.Dimensions);
  const isthmus::IonAtmosphere ions(parameters.Ions, parameters.Temperature);
  const auto solution = isthmus::SolvePoissonBoltzmann(
    volume.Level, box, atoms.Atoms, parameters, ions, isthmus::Between(progress, 0.05, 0.75));
  const double kappa = solution->Kappa();
  if (kappa > 0.0 && this->Padding * kappa < 1.0 && this->BoundaryCondition != SelfConsistent &&
    this->BoundaryCondition != FromInput)
  {
    vtkWarningMacro(<< isthmus::TextOf("Padding is ", this->Padding,
                      " angstrom, less than the Debye length of ", 1.0 / kappa,
                      ": the border is near enough to be felt."));
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
  if (this->ComputeMaps)
  {
    isthmus::FillMaps(*solution, atoms.Atoms, output);
  }
  isthmus::FillFieldData(*solution, parameters, atoms.NetCharge, volume.Kind, output);
  isthmus::FillSurface(*solution, volume, parameters.Temperature, polygons,
    vtkPolyData::GetData(outputVector, 1), isthmus::Between(progress, 0.9, 1.0));
  auto* atomsOut = vtkPointSet::GetData(outputVector, 2);
  atomsOut->ShallowCopy(points);
  isthmus::FillAtoms(*solution, volume, parameters.Temperature, atomsOut);
  if (this->ComputeBoundaryForces)
  {
    isthmus::FillBoundaryForces(*solution, volume, atoms.Atoms, atomsOut);
  }
}

void vtkPoissonBoltzmann::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "InsideIsHigher: " << this->InsideIsHigher << "\n";
  os << indent << "SoluteDielectric: " << this->SoluteDielectric << "\n";
  os << indent << "SolventDielectric: " << this->SolventDielectric << "\n";
  os << indent << "IonicStrength: " << this->IonicStrength << "\n";
  os << indent << "Ions: " << this->Ions->Species.size() << "\n";
  os << indent << "IonRadius: " << this->IonRadius << "\n";
  os << indent << "Temperature: " << this->Temperature << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Padding: " << this->Padding << "\n";
  os << indent << "Nonlinear: " << this->Nonlinear << "\n";
  os << indent << "BoundaryCondition: " << this->BoundaryCondition << "\n";
  os << indent << "ForceField: " << this->ForceField << "\n";
  os << indent << "DielectricModel: " << this->DielectricModel << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "ComputeBoundaryForces: " << this->ComputeBoundaryForces << "\n";
  os << indent << "ComputeMaps: " << this->ComputeMaps << "\n";
}
