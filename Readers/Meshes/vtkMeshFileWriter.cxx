#include "vtkMeshFileWriter.h"

#include "MeshData.h"
#include "PrintableText.h"
#include "Progress.h"

#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkPointSet.h>

#include <sstream>
#include <stdexcept>

vtkMeshFileWriter::~vtkMeshFileWriter()
{
  this->SetFileName(nullptr);
}

int vtkMeshFileWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

void vtkMeshFileWriter::WriteData()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    if (!this->FileName || !*this->FileName)
    {
      throw std::invalid_argument("There is no file name: set FileName.");
    }
    std::istringstream words(this->ArrayNames());
    std::vector<std::string> names;
    for (std::string name; words >> name;)
    {
      names.push_back(name);
    }
    std::string remark;
    const isthmus::CellMesh mesh =
      isthmus::FromPointSet(vtkPointSet::SafeDownCast(this->GetInput()), names, remark);
    this->WriteMesh(mesh);
    if (!remark.empty())
    {
      vtkWarningMacro(<< remark);
    }
  }
  catch (const isthmus::Cancelled&)
  {
  }
  catch (const std::exception& error)
  {
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    vtkErrorMacro(<< isthmus::Printable(error.what()));
  }
}

void vtkMeshFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
