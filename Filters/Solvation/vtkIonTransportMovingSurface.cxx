#include "vtkIonTransportMovingSurface.h"

#include "Core/NumberText.h"
#include "MolecularSurfaces/DispersionAtoms.h"
#include "Solvation/ChannelSolution.h"
#include "Solvation/IonTransportArrays.h"
#include "Solvation/IonTransportOutput.h"

#include <vtkObjectFactory.h>
#include <vtkTable.h>

#include <string>

vtkStandardNewMacro(vtkIonTransportMovingSurface);

const std::vector<isthmus::OutputArray>& vtkIonTransportMovingSurface::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    ISTHMUS_ION_TRANSPORT_ARRAY_ROWS,
    { 0, ArrayPlace::Field, "ShownUpdate", 1, "", ArrayChoice::None,
      "row of output 2 to which outputs 0 and 1 belong, from 1" },
    { 2, ArrayPlace::Rows, "Update", 1, "", ArrayChoice::None, "from 1, the initial surface" },
    { 2, ArrayPlace::Rows, "Time", 1, "angstrom^2", ArrayChoice::None, "of the flow" },
    { 2, ArrayPlace::Rows, "AreaChange", 1, "angstrom^2", ArrayChoice::None, "since the start" },
    { 2, ArrayPlace::Rows, "LumenVolume", 1, "angstrom^3", ArrayChoice::None,
      "water within the thickness of the membrane" },
    { 2, ArrayPlace::Rows, "EnergyChange", 1, "kcal/mol", ArrayChoice::None,
      "of tension, pressure and dispersion since the start" },
    { 2, ArrayPlace::Rows, "OnObstacle", 1, "", ArrayChoice::None,
      "fraction of the surface that cannot recede" },
    { 2, ArrayPlace::Rows, "BottleneckRadius", 1, "angstrom", ArrayChoice::None,
      "of the widest path through the channel" },
    { 2, ArrayPlace::Rows, "Current_NAME", 1, "pA", ArrayChoice::None, "of the species NAME" },
    { 2, ArrayPlace::Rows, "Current", 1, "pA", ArrayChoice::None, "of all species" },
  };
  return table;
}

vtkIonTransportMovingSurface::vtkIonTransportMovingSurface()
{
  this->SetNumberOfOutputPorts(3);
}

vtkIonTransportMovingSurface::~vtkIonTransportMovingSurface() = default;

vtkTable* vtkIonTransportMovingSurface::GetUpdates()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(2));
}

void vtkIonTransportMovingSurface::CompleteProblem(
  vtkDataObject* input, const isthmus::MoleculeAtoms& atoms, isthmus::ChannelProblem& problem)
{
  problem.Moves = true;
  problem.Attracting = isthmus::MakeDispersionAtoms(input, atoms);
  problem.Motion = this->Motion;
}

std::string vtkIonTransportMovingSurface::FillMotion(
  const isthmus::ChannelSolution& channel, vtkImageData* image, vtkInformationVector* outputVector)
{
  const isthmus::MovingChannel& moving = *channel.GetMoving();
  isthmus::FillMotion(moving, moving.GetSolution().GetParameters().Species, image,
    vtkTable::GetData(outputVector, 2));
  if (moving.HasConverged())
  {
    return {};
  }
  return isthmus::JoinText("The surface has not converged after ", moving.GetUpdates().size(),
    " updates: currents or lumen still changed by a fraction ", moving.LastChange(), ". Update ",
    moving.GetShown() + 1,
    ", which changed least, is returned, with Converged 0: choose more MaximumUpdates, a larger "
    "UpdateTolerance, or a smaller FieldRelaxation.");
}

void vtkIonTransportMovingSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->PrintSolventProperties(os, indent);
  os << indent << "UpdatePeriod: " << this->GetUpdatePeriod() << "\n";
  os << indent << "SurfaceRelaxation: " << this->GetSurfaceRelaxation() << "\n";
  os << indent << "FieldRelaxation: " << this->GetFieldRelaxation() << "\n";
  os << indent << "UpdateTolerance: " << this->GetUpdateTolerance() << "\n";
  os << indent << "MaximumUpdates: " << this->GetMaximumUpdates() << "\n";
}
