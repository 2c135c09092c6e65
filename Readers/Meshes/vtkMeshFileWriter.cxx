#include "vtkMeshFileWriter.h"

#include "Meshes/MeshConversion.h"

#include <vtkInformation.h>
#include <vtkPointSet.h>

#include <string>

int vtkMeshFileWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

void vtkMeshFileWriter::WriteFile()
{
  std::string remark;
  const isthmus::CellMesh mesh =
    isthmus::FromPointSet(vtkPointSet::SafeDownCast(this->GetInput()), this->Arrays(), remark);
  this->WriteMesh(mesh);
  if (!remark.empty())
  {
    vtkWarningMacro(<< remark);
  }
}
