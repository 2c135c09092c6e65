#include "vtkImageArrayWriter.h"

#include <vtkImageData.h>
#include <vtkInformation.h>

int vtkImageArrayWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

vtkImageData* vtkImageArrayWriter::GetImage()
{
  return vtkImageData::SafeDownCast(this->GetInput());
}

void vtkImageArrayWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
}
