#include "vtkMeshFileWriter.h"

#include "Core/NumberText.h"

#include "Meshes/MeshConversion.h"

#include <vtkInformation.h>
#include <vtkPointSet.h>

#include <string_view>

int vtkMeshFileWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

void vtkMeshFileWriter::WriteFile()
{
  const std::string all = this->ArrayNames();
  std::vector<std::string> names;
  for (std::string_view rest = all, name; !(name = isthmus::TakeWord(rest)).empty();)
  {
    names.emplace_back(name);
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
