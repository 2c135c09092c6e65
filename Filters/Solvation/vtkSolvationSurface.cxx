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
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkSolvationSurface);

using isthmus::SolvationUpdate;

/// The data of one execution.
class vtkSolvationSurface::vtkInternals
{
public:
  explicit vtkInternals(vtkSolvationSurface* self)
    : Self(self)
  {
  }

  isthmus::MoleculeAtoms Balls(vtkDataObject* input) const
  {
    isthmus::AtomOptions options = isthmus::SelectWholeMolecule(
      isthmus::InputArrayName(this->Self, 0), this->Self->IncludeWaters, this->Self->UnitedAtoms);
    options.Missing = isthmus::MissingRadius::Refuse; // it has a charge
    return isthmus::ReadAtoms(input, options);
  }

  std::vector<isthmus::ChargedAtom> Charges(
    vtkDataObject* input, const isthmus::MoleculeAtoms& atoms) const;
  void Warn(const isthmus::SolvationFlow& flow, const isthmus::MoleculeAtoms& atoms) const;

  vtkSolvationSurface* Self;
};

std::vector<isthmus::ChargedAtom> vtkSolvationSurface::vtkInternals::Charges(
  vtkDataObject* input, const isthmus::MoleculeAtoms& atoms) const
{
  std::vector<isthmus::ChargedAtom> charges =
    isthmus::MakeChargedAtoms(input, atoms, isthmus::InputArrayName(this->Self, 1));
  if (std::all_of(charges.begin(), charges.end(),
        [](const isthmus::ChargedAtom& atom) { return atom.Charge == 0.0; }))
  {
    throw std::invalid_argument(
      "All charges are 0, so there is no field: use Molecular Flow Surface and Nonpolar Solvation, "
      "or choose another array of charges.");
  }
  return charges;
}

void vtkSolvationSurface::vtkInternals::Warn(
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
      << isthmus::JoinText("The energy has not converged after ", n, " updates: the last one is ",
           last.Total(), " kcal/mol, the one before ", flow.GetUpdates()[n > 1 ? n - 2 : 0].Total(),
           ". The last surface is shown: choose more MaximumUpdates or a larger EnergyTolerance."));
  }
  if (this->Self->Parameters.Flow.ProbeRadius == 0.0 && last.OnObstacle > nearlyAll &&
    atoms.Balls.size() > 1)
  {
    vtkWarningWithObjectMacro(this->Self,
      << isthmus::JoinText("The field has pulled the surface onto the atoms (",
           100.0 * last.OnObstacle,
           " % of it): it follows clefts that no water enters. Set a ProbeRadius, 1.4 for water."));
  }
}

const std::vector<isthmus::OutputArray>& vtkSolvationSurface::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Normals", 3, "", ArrayChoice::None, "unit, outwards" },
    { 0, ArrayPlace::Points, "Potential", 1, "kT/e", ArrayChoice::None, "electrostatic potential" },
    { 0, ArrayPlace::Points, "NormalField", 1, "kT/(e angstrom)", ArrayChoice::None,
      "of the solvent" },
    { 0, ArrayPlace::Points, "SurfaceChargeDensity", 1, "e/angstrom^2", ArrayChoice::None,
      "of the polarization" },
    { 1, ArrayPlace::Points, "SignedDistance", 1, "angstrom", ArrayChoice::None,
      "negative inside" },
    { 1, ArrayPlace::Points, "S", 1, "", ArrayChoice::None, "from 0 to 1, 1/2 on the surface" },
    { 1, ArrayPlace::Points, "Potential", 1, "kT/e", ArrayChoice::None, "electrostatic potential" },
    { 1, ArrayPlace::Points, "ReactionPotential", 1, "kT/e", ArrayChoice::None,
      "the potential minus that of the charges in a medium with SoluteDielectric everywhere" },
    { 1, ArrayPlace::Points, "Side", 1, "", ArrayChoice::None, "1 inside the solute" },
    { 0, ArrayPlace::Field, "Converged", 1, "", ArrayChoice::None,
      "1 if the energy has converged" },
    { 1, ArrayPlace::Field, "Converged", 1, "", ArrayChoice::None,
      "1 if the energy has converged" },
    { 2, ArrayPlace::Field, "Converged", 1, "", ArrayChoice::None,
      "1 if the energy has converged" },
    { 0, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,
      "the energy and its error in words; what was dropped from the input" },
    { 0, ArrayPlace::Field, "PolarEnergyError", 1, "kcal/mol", ArrayChoice::None,
      "of the last PolarEnergy, estimated from coarser grids" },
    { 0, ArrayPlace::Field, "TotalEnergyError", 1, "kcal/mol", ArrayChoice::None,
      "of the last TotalEnergy, estimated from a coarser flow" },
    { 1, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,
      "the energy and its error in words; what was dropped from the input" },
    { 1, ArrayPlace::Field, "PolarEnergyError", 1, "kcal/mol", ArrayChoice::None,
      "of the last PolarEnergy, estimated from coarser grids" },
    { 1, ArrayPlace::Field, "TotalEnergyError", 1, "kcal/mol", ArrayChoice::None,
      "of the last TotalEnergy, estimated from a coarser flow" },
    { 2, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,
      "the energy and its error in words; what was dropped from the input" },
    { 2, ArrayPlace::Field, "PolarEnergyError", 1, "kcal/mol", ArrayChoice::None,
      "of the last PolarEnergy, estimated from coarser grids" },
    { 2, ArrayPlace::Field, "TotalEnergyError", 1, "kcal/mol", ArrayChoice::None,
      "of the last TotalEnergy, estimated from a coarser flow" },
    { 2, ArrayPlace::Rows, "Update", 1, "", ArrayChoice::None, "from 1" },
    { 2, ArrayPlace::Rows, "Time", 1, "angstrom^2", ArrayChoice::None, "of the flow" },
    { 2, ArrayPlace::Rows, "Area", 1, "angstrom^2", ArrayChoice::None, "of the surface" },
    { 2, ArrayPlace::Rows, "Volume", 1, "angstrom^3", ArrayChoice::None, "enclosed" },
    { 2, ArrayPlace::Rows, "SurfaceEnergy", 1, "kcal/mol", ArrayChoice::None,
      "SurfaceTension x Area" },
    { 2, ArrayPlace::Rows, "VolumeEnergy", 1, "kcal/mol", ArrayChoice::None, "Pressure x Volume" },
    { 2, ArrayPlace::Rows, "DispersionEnergy", 1, "kcal/mol", ArrayChoice::None,
      "attraction of the atoms and the solvent" },
    { 2, ArrayPlace::Rows, "NonpolarEnergy", 1, "kcal/mol", ArrayChoice::None, "sum of the three" },
    { 2, ArrayPlace::Rows, "PolarEnergy", 1, "kcal/mol", ArrayChoice::None,
      "of the charges in the field of the solvent" },
    { 2, ArrayPlace::Rows, "TotalEnergy", 1, "kcal/mol", ArrayChoice::None, "nonpolar + polar" },
    { 2, ArrayPlace::Rows, "OnObstacle", 1, "", ArrayChoice::None,
      "fraction of the surface that its obstacle holds" },
  };
  return table;
}

vtkSolvationSurface::vtkSolvationSurface()
  : Advance(std::make_unique<isthmus::InputInAdvance>(this))
{
  this->SetNumberOfOutputPorts(3);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Radius");
  this->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Charge");
}

vtkSolvationSurface::~vtkSolvationSurface() = default;

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
  // The extent of the image is required now, and depends on the atoms: update the input.
  this->Advance->Update();
  isthmus::SetImageInformation(outputVector->GetInformationObject(1),
    [&](vtkImageData* image)
    {
      this->Advance->RequireOneRank(0, "atoms");
      const vtkInternals internals(this);
      const isthmus::MoleculeAtoms atoms = internals.Balls(vtkDataObject::GetData(inputVector[0]));
      if (!atoms.Balls.empty())
      {
        isthmus::SetImageGeometry(
          isthmus::FlowResultGrid(atoms.Balls, this->Parameters.Flow), image);
      }
    });
  return 1;
}

int vtkSolvationSurface::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1; // the requested extent of the image does not apply to the atoms
}

int vtkSolvationSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  isthmus::ClearOutputs(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      const vtkInternals internals(this);
      isthmus::Check(this->Parameters);
      vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
      this->Advance->RequireOneRank(0, "atoms");
      const isthmus::MoleculeAtoms atoms = internals.Balls(input);
      if (atoms.Balls.empty())
      {
        return;
      }
      const auto progress = isthmus::MakeProgress(this);
      isthmus::SolvationFlow flow({ atoms.Balls, isthmus::MakeDispersionAtoms(input, atoms),
                                    internals.Charges(input, atoms) },
        this->Parameters);
      flow.Run(isthmus::Between(progress, 0.0, 0.7));
      const isthmus::SolvationErrors errors =
        flow.EstimateErrors(isthmus::Between(progress, 0.7, 0.9));
      isthmus::FillSolvation(flow, errors, atoms.Notes,
        { vtkPolyData::GetData(outputVector, 0), vtkImageData::GetData(outputVector, 1),
          vtkTable::GetData(outputVector, 2) },
        isthmus::Between(progress, 0.9, 1.0));
      internals.Warn(flow, atoms);
    });
}

void vtkSolvationSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Enlargement: " << this->GetEnlargement() << "\n";
  os << indent << "ProbeRadius: " << this->GetProbeRadius() << "\n";
  os << indent << "Spacing: " << this->GetSpacing() << "\n";
  os << indent << "Padding: " << this->GetPadding() << "\n";
  this->PrintSolventProperties(os, indent);
  os << indent << "SoluteDielectric: " << this->GetSoluteDielectric() << "\n";
  os << indent << "SolventDielectric: " << this->GetSolventDielectric() << "\n";
  os << indent << "DielectricModel: " << this->GetDielectricModel() << "\n";
  os << indent << "IonicStrength: " << this->GetIonicStrength() << "\n";
  os << indent << "Temperature: " << this->GetTemperature() << "\n";
  os << indent << "UpdatePeriod: " << this->GetUpdatePeriod() << "\n";
  os << indent << "AdaptiveUpdate: " << this->GetAdaptiveUpdate() << "\n";
  os << indent << "SurfaceRelaxation: " << this->GetSurfaceRelaxation() << "\n";
  os << indent << "FieldRelaxation: " << this->GetFieldRelaxation() << "\n";
  os << indent << "EnergyTolerance: " << this->GetEnergyTolerance() << "\n";
  os << indent << "MaximumUpdates: " << this->GetMaximumUpdates() << "\n";
  this->PrintAtomProperties(os, indent);
}
