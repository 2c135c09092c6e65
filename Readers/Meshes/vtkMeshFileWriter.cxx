#include "vtkMeshFileWriter.h"

#include "Meshes/MeshConversion.h"

#include <vtkInformation.h>
#include <vtkPointSet.h>

#include <sstream>

int vtkMeshFileWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

void vtkMeshFileWriter::WriteFile()
{
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
