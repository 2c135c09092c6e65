#include "vtkTetGenMeshReader.h"

#include "AlgorithmGuard.h"
#include "TetGenMeshFile.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkTetGenMeshReader);

int vtkTetGenMeshReader::CanReadFile(const char* fileName)
{
  return fileName && isthmus::LooksLikeTetGen(fileName) ? 1 : 0;
}

void vtkTetGenMeshReader::ReadMesh(isthmus::CellMesh& mesh)
{
  mesh = isthmus::ReadTetGenFiles(this->FileName, isthmus::ProgressOf(this));
}
