#include "vtkSolvationSurface.h"

#include "Atoms/MoleculeAtoms.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ImageExtent.h"
#include "Core/NumberText.h"
#include "Core/PipelineInputs.h"
#include "Electrostatics/PoissonBoltzmannInput.h"
#include "MolecularSurfaces/DispersionAtoms.h"
#include "MolecularSurfaces/FlowSurfaceOutput.h"
#include "MolecularSurfaces/SurfaceFlow.h"
#include "Solvation/SolvationFlow.h"
#include "Solvation/SolvationOutput.h"

#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkSolvationSurface);

using isthmus::SolvationUpdate;

/// What one execution works with.
struct vtkSolvationSurface::Internals
{
  explicit Internals(vtkSolvationSurface* self)
    : Self(self)
  {
  }

  isthmus::MoleculeAtoms Balls(vtkDataObject* input) const
  {
    isthmus::AtomOptions options = isthmus::WholeMolecule(
      isthmus::InputArrayName(this->Self, 0), this->Self->KeepWaters, this->Self->UnitedAtoms);
    options.Missing = isthmus::MissingRadius::Refuse; // it has a charge
    return isthmus::ReadAtoms(input, options);
  }

  isthmus::SolvationParameters Parameters() const;
  std::vector<isthmus::ChargedAtom> Charges(
    vtkDataObject* input, const isthmus::MoleculeAtoms& atoms) const;
  void Warn(const isthmus::SolvationFlow& flow, const isthmus::MoleculeAtoms& atoms) const;

  vtkSolvationSurface* Self;
};

isthmus::SolvationParameters vtkSolvationSurface::Internals::Parameters() const
{
  const vtkSolvationSurface* self = this->Self;
  isthmus::SolvationParameters p;
  p.Flow.Enlargement = self->Enlargement;
  p.Flow.ProbeRadius = self->ProbeRadius;
  p.Flow.Spacing = self->Spacing;
  p.Solvent.SurfaceTension = self->SurfaceTension;
  p.Solvent.Pressure = self->Pressure;
  p.Potential.SoluteDielectric = self->SoluteDielectric;
  p.Potential.SolventDielectric = self->SolventDielectric;
  p.Potential.Dielectric = static_cast<isthmus::DielectricModel>(self->DielectricModel);
  p.Potential.Temperature = self->Temperature;
  p.Potential.Padding = self->Padding;
  if (!(self->IonicStrength >= 0.0) || std::isinf(self->IonicStrength))
  {
    throw std::invalid_argument("IonicStrength is " + isthmus::FormatNumber(self->IonicStrength) +
      " mol/l, but it is 0 or more: 0.15 is physiological.");
  }
  if (self->IonicStrength > 0.0)
  {
    p.Potential.Ions = { { 1.0, self->IonicStrength }, { -1.0, self->IonicStrength } };
  }
  p.Policy.UpdatePeriod = self->UpdatePeriod;
  p.Policy.AdaptiveUpdate = self->AdaptiveUpdate;
  p.Policy.SurfaceRelaxation = self->SurfaceRelaxation;
  p.Policy.FieldRelaxation = self->FieldRelaxation;
  p.Policy.Tolerance = self->EnergyTolerance;
  p.Policy.MaximumUpdates = self->MaximumUpdates;
  return p;
}

std::vector<isthmus::ChargedAtom> vtkSolvationSurface::Internals::Charges(
  vtkDataObject* input, const isthmus::MoleculeAtoms& atoms) const
{
  std::vector<isthmus::ChargedAtom> charges =
    isthmus::ChargedAtomsOf(input, atoms, isthmus::InputArrayName(this->Self, 1));
  if (std::all_of(charges.begin(), charges.end(),
        [](const isthmus::ChargedAtom& atom) { return atom.Charge == 0.0; }))
  {
    throw std::invalid_argument(
      "All charges are 0, so there is no field: use Molecular Flow Surface and Nonpolar Solvation, "
      "or choose another array of charges.");
  }
  return charges;
}

void vtkSolvationSurface::Internals::Warn(
  const isthmus::SolvationFlow& flow, const isthmus::MoleculeAtoms& atoms) const
{
  constexpr double nearlyAll = 0.9;
  for (const std::string& warning : atoms.Warnings)
  {
    vtkWarningWithObjectMacro(this->Self, << warning);
  }
  const SolvationUpdate& last = flow.GetUpdates().back();
  if (!flow.HasConverged())
  {
    const std::size_t n = flow.GetUpdates().size();
    vtkWarningWithObjectMacro(this->Self,
      << isthmus::TextOf("The energy has not converged after ", n, " updates: the last one is ",
           last.Total(), " kcal/mol, the one before ", flow.GetUpdates()[n > 1 ? n - 2 : 0].Total(),
           ". The last surface is shown: choose more MaximumUpdates or a larger EnergyTolerance."));
  }
  if (this->Self->ProbeRadius == 0.0 && last.OnObstacle > nearlyAll && atoms.Balls.size() > 1)
  {
    vtkWarningWithObjectMacro(this->Self,
      << isthmus::TextOf("The field has drawn the surface onto the atoms (",
           100.0 * last.OnObstacle,
           " % of it): it follows clefts that no water enters. Set a ProbeRadius, 1.4 for water."));
  }
}

vtkSolvationSurface::vtkSolvationSurface()
  : Advance(std::make_unique<isthmus::InputInAdvance>(this))
{
  this->SetNumberOfOutputPorts(3);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Radius");
  this->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Charge");
}

vtkSolvationSurface::~vtkSolvationSurface() = default;

void vtkSolvationSurface::SetChargeArrayName(const char* name)
{
  this->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
}

void vtkSolvationSurface::SetRadiusArrayName(const char* name)
{
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
}

vtkImageData* vtkSolvationSurface::GetImage()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

vtkTable* vtkSolvationSurface::GetUpdates()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(2));
}

int vtkSolvationSurface::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkSolvationSurface::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* types[] = { "vtkPolyData", "vtkImageData", "vtkTable" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
  return 1;
}

int vtkSolvationSurface::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // The extent of the image has to be told now, and it is that of the atoms: so make the atoms.
  this->Advance->Update();
  isthmus::SetImageInformation(outputVector->GetInformationObject(1),
    [&](vtkImageData* image)
    {
      this->Advance->RequireOneRank(0, "atoms");
      const Internals internals(this);
      const isthmus::MoleculeAtoms atoms = internals.Balls(vtkDataObject::GetData(inputVector[0]));
      if (!atoms.Balls.empty())
      {
        isthmus::SetImageGeometry(
          isthmus::FlowResultGrid(atoms.Balls, internals.Parameters().Flow), image);
      }
    });
  return 1;
}

int vtkSolvationSurface::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1; // the extent asked of the image means nothing to the atoms
}

int vtkSolvationSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  isthmus::ClearOutputs(outputVector);
  return isthmus::Guarded(this, outputVector,
    [&]()
    {
      const Internals internals(this);
      const isthmus::SolvationParameters parameters = internals.Parameters();
      vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
      this->Advance->RequireOneRank(0, "atoms");
      const isthmus::MoleculeAtoms atoms = internals.Balls(input);
      if (atoms.Balls.empty())
      {
        return;
      }
      const auto progress = isthmus::ProgressOf(this);
      isthmus::SolvationFlow flow(
        { atoms.Balls, isthmus::DispersionAtomsOf(input, atoms), internals.Charges(input, atoms) },
        parameters);
      flow.Run(isthmus::Between(progress, 0.0, 0.9));
      isthmus::FillSolvation(flow, atoms.Notes,
        { vtkPolyData::GetData(outputVector, 0), vtkImageData::GetData(outputVector, 1),
          vtkTable::GetData(outputVector, 2) },
        isthmus::Between(progress, 0.9, 1.0));
      internals.Warn(flow, atoms);
    });
}

void vtkSolvationSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Enlargement: " << this->Enlargement << "\n";
  os << indent << "ProbeRadius: " << this->ProbeRadius << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Padding: " << this->Padding << "\n";
  this->PrintSolventProperties(os, indent);
  os << indent << "SoluteDielectric: " << this->SoluteDielectric << "\n";
  os << indent << "SolventDielectric: " << this->SolventDielectric << "\n";
  os << indent << "DielectricModel: " << this->DielectricModel << "\n";
  os << indent << "IonicStrength: " << this->IonicStrength << "\n";
  os << indent << "Temperature: " << this->Temperature << "\n";
  os << indent << "UpdatePeriod: " << this->UpdatePeriod << "\n";
  os << indent << "AdaptiveUpdate: " << this->AdaptiveUpdate << "\n";
  os << indent << "SurfaceRelaxation: " << this->SurfaceRelaxation << "\n";
  os << indent << "FieldRelaxation: " << this->FieldRelaxation << "\n";
  os << indent << "EnergyTolerance: " << this->EnergyTolerance << "\n";
  os << indent << "MaximumUpdates: " << this->MaximumUpdates << "\n";
  this->PrintAtomProperties(os, indent);
}
