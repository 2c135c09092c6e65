#include "vtkOFFSurfaceWriter.h"

#include "Core/AlgorithmGuard.h"
#include "Meshes/OFFFile.h"

#include <vtkInformation.h>
#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkOFFSurfaceWriter);

int vtkOFFSurfaceWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkOFFSurfaceWriter::WriteMesh(const isthmus::CellMesh& mesh)
{
  isthmus::WriteOFF(mesh, this->FileName, isthmus::ProgressOf(this));
}

const char* vtkOFFSurfaceWriter::ArrayNames() const
{
  return "Normals";
}
