#include "vtkOFFSurfaceWriter.h"

#include "Core/AlgorithmGuard.h"
#include "Meshes/MeshConversion.h"
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
  isthmus::WriteOFF(mesh, this->FileName, isthmus::MakeProgress(this));
}

std::vector<isthmus::MeshArrayRule> vtkOFFSurfaceWriter::Arrays() const
{
  return { { isthmus::MeshAttribute::Place::Vertices, "Normals",
    isthmus::MeshArrayRule::Numbers::Finite, 3 } };
}
