#include "vtkTetGenMeshWriter.h"

#include "Core/AlgorithmGuard.h"
#include "Meshes/TetGenMeshFile.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkTetGenMeshWriter);

void vtkTetGenMeshWriter::WriteMesh(const isthmus::CellMesh& mesh)
{
  isthmus::WriteTetGenFiles(mesh, this->FileName, isthmus::ProgressOf(this));
}

const char* vtkTetGenMeshWriter::ArrayNames() const
{
  return "Attribute BoundaryMarker";
}
