#include "vtkTetGenMeshReader.h"

#include "AlgorithmGuard.h"
#include "ReaderGuard.h"
#include "TetGenMeshFile.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkTetGenMeshReader);

int vtkTetGenMeshReader::CanReadFile(const char* fileName)
{
  return isthmus::CanRead(fileName, isthmus::LooksLikeTetGen);
}

void vtkTetGenMeshReader::ReadMesh(isthmus::CellMesh& mesh)
{
  mesh = isthmus::ReadTetGenFiles(this->FileName, isthmus::ProgressOf(this));
}
