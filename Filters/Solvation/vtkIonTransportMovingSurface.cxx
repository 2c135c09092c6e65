#include "vtkIonTransportMovingSurface.h"

#include "Core/NumberText.h"
#include "MolecularSurfaces/DispersionAtoms.h"
#include "Solvation/ChannelSolution.h"
#include "Solvation/IonTransportOutput.h"

#include <vtkObjectFactory.h>
#include <vtkTable.h>

#include <string>

vtkStandardNewMacro(vtkIonTransportMovingSurface);

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
  problem.Attracting = isthmus::DispersionAtomsOf(input, atoms);
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
  return isthmus::TextOf("The surface has not converged after ", moving.GetUpdates().size(),
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
