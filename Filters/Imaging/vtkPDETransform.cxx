#include "vtkPDETransform.h"

#include "Imaging/DiffusionImage.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPDETransform);

const std::vector<isthmus::OutputArray>& vtkPDETransform::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "ModeNAME", 1, "of the scalars", ArrayChoice::None,
      "Mode1, Mode2, ...: what each low-pass filter removes, the finest detail first" },
    { 0, ArrayPlace::Points, "Residue", 1, "of the scalars", ArrayChoice::None,
      "the smooth rest: the input is its sum with all modes" },
  };
  return table;
}

vtkPDETransform::vtkPDETransform() = default;

int vtkPDETransform::HaloWidth()
{
  return 1; // of the Laplacian, whatever the orders: they are powers of it
}

template <typename T>
void vtkPDETransform::Transform(isthmus::DiffusionImage<T>& image)
{
  isthmus::Check(this->Parameters); // before volumes are allocated for the modes
  auto values = image.Copy(this->ChosenScalars(image.GetInput()), this->GetMaskInvalid());
  values->SetName("Residue");
  std::vector<vtkSmartPointer<typename isthmus::DiffusionImage<T>::Array>> modes;
  std::vector<T*> pointers;
  for (int k = 1; k <= this->Parameters.NumberOfModes; ++k)
  {
    modes.push_back(image.NewVolume("Mode" + std::to_string(k)));
    pointers.push_back(modes.back()->GetPointer(0));
  }
  isthmus::TransformByPDE<T>(
    image.GetGrid(), this->Parameters, values->GetPointer(0), pointers, image.GetProgress());
  for (const auto& mode : modes)
  {
    image.AddResult(mode, false);
  }
  image.AddResult(values, true);
}

void vtkPDETransform::Process(isthmus::DiffusionImage<float>& image)
{
  this->Transform(image);
}

void vtkPDETransform::Process(isthmus::DiffusionImage<double>& image)
{
  this->Transform(image);
}

void vtkPDETransform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VoxelUnits: " << this->VoxelUnits << '\n';
  os << indent << "NumberOfModes: " << this->Parameters.NumberOfModes << '\n';
  os << indent << "FirstOrder: " << this->Parameters.FirstOrder << '\n';
  os << indent << "LastOrder: " << this->Parameters.LastOrder << '\n';
  os << indent << "FirstWavelength: " << this->Parameters.FirstWavelength << '\n';
  os << indent << "WavelengthRatio: " << this->Parameters.WavelengthRatio << '\n';
}
