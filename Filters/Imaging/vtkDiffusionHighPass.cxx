#include "vtkDiffusionHighPass.h"

#include "Imaging/DiffusionImage.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <functional>

vtkStandardNewMacro(vtkDiffusionHighPass);

const std::vector<isthmus::OutputArray>& vtkDiffusionHighPass::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "HighPass", 1, "of the scalars", ArrayChoice::None,
      "u - v, positive on the denser side of an edge" },
    { 0, ArrayPlace::Points, "SlowField", 1, "of the scalars", ArrayChoice::Off,
      "u, the slow field" },
    { 0, ArrayPlace::Points, "FastField", 1, "of the scalars", ArrayChoice::Off,
      "v, the fast field" },
  };
  return table;
}

vtkDiffusionHighPass::vtkDiffusionHighPass()
  : OutputArrays(this, OutputArrayTable())
{
}

int vtkDiffusionHighPass::HaloWidth()
{
  return isthmus::HaloWidth(isthmus::DiffusionParameters()); // of order 0
}

template <typename T>
void vtkDiffusionHighPass::FindEdges(isthmus::DiffusionImage<T>& image)
{
  this->OutputArrays.Check();
  auto u = image.Copy(this->ChosenScalars(image.GetInput()), this->GetMaskInvalid());
  u->SetName("SlowField");
  auto v = image.Duplicate(u, "FastField");
  isthmus::EvolveHighPass<T>(
    image.GetGrid(), this->Parameters, u->GetPointer(0), v->GetPointer(0), image.GetProgress());
  const bool addsSlowField = this->OutputArrays.Has("SlowField");
  auto w = addsSlowField ? image.Duplicate(u, "HighPass") : u;
  w->SetName("HighPass");
  std::transform(w->GetPointer(0), w->GetPointer(0) + w->GetNumberOfValues(), v->GetPointer(0),
    w->GetPointer(0), std::minus<T>());
  image.AddResult(w, true);
  if (addsSlowField)
  {
    image.AddResult(u, false);
  }
  if (this->OutputArrays.Has("FastField"))
  {
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
  os << indent << "VoxelUnits: " << this->VoxelUnits << '\n';
  os << indent << "DiffusivityU: " << this->Parameters.DiffusivityU << '\n';
  os << indent << "DiffusivityV: " << this->Parameters.DiffusivityV << '\n';
  os << indent << "CouplingU: " << this->Parameters.CouplingU << '\n';
  os << indent << "CouplingV: " << this->Parameters.CouplingV << '\n';
  os << indent << "Sigma: " << this->Parameters.Sigma << '\n';
  os << indent << "Time: " << this->Parameters.Time << '\n';
  os << indent << "Steps: " << this->Parameters.Steps << '\n';
  this->OutputArrays.Print(os, indent);
}
