#include "vtkDiffusionHighPass.h"

#include "Imaging/DiffusionHighPass.h"
#include "Imaging/DiffusionImage.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <functional>

vtkStandardNewMacro(vtkDiffusionHighPass);

vtkDiffusionHighPass::vtkDiffusionHighPass() = default;

int vtkDiffusionHighPass::HaloWidth()
{
  isthmus::DiffusionParameters diffusion;
  diffusion.Order = 0;
  return isthmus::HaloWidth(diffusion);
}

template <typename T>
void vtkDiffusionHighPass::FindEdges(isthmus::DiffusionImage<T>& image)
{
  isthmus::HighPassParameters parameters;
  parameters.Diffusivity = { this->DiffusivityU, this->DiffusivityV };
  parameters.Coupling = { this->CouplingU, this->CouplingV };
  parameters.Sigma = this->Sigma;
  parameters.Time = this->Time;
  parameters.Steps = this->Steps;
  auto u = image.Copy(this->ChosenScalars(image.GetInput()), this->GetMaskInvalid());
  u->SetName("SlowField");
  auto v = image.Duplicate(u, "FastField");
  isthmus::EvolveHighPass<T>(
    image.GetGrid(), parameters, u->GetPointer(0), v->GetPointer(0), image.GetProgress());
  auto w = this->OutputFields ? image.Duplicate(u, "HighPass") : u;
  w->SetName("HighPass");
  std::transform(w->GetPointer(0), w->GetPointer(0) + w->GetNumberOfValues(), v->GetPointer(0),
    w->GetPointer(0), std::minus<T>());
  image.AddResult(w, true);
  if (this->OutputFields)
  {
    image.AddResult(u, false);
    image.AddResult(v, false);
  }
}

void vtkDiffusionHighPass::Process(isthmus::DiffusionImage<float>& image)
{
  this->FindEdges(image);
}

void vtkDiffusionHighPass::Process(isthmus::DiffusionImage<double>& image)
{
  this->FindEdges(image);
}

void vtkDiffusionHighPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DiffusivityU: " << this->DiffusivityU << '\n';
  os << indent << "DiffusivityV: " << this->DiffusivityV << '\n';
  os << indent << "CouplingU: " << this->CouplingU << '\n';
  os << indent << "CouplingV: " << this->CouplingV << '\n';
  os << indent << "Sigma: " << this->Sigma << '\n';
  os << indent << "Time: " << this->Time << '\n';
  os << indent << "Steps: " << this->Steps << '\n';
  os << indent << "OutputFields: " << this->OutputFields << '\n';
}
