#include "vtkTetGenMeshReader.h"

#include "Core/AlgorithmGuard.h"
#include "Files/ReaderGuard.h"
#include "Meshes/TetGenMeshFile.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkTetGenMeshReader);

int vtkTetGenMeshReader::CanReadFile(const char* fileName)
{
  return isthmus::CanRead(fileName, isthmus::LooksLikeTetGen);
}

void vtkTetGenMeshReader::ReadMesh(isthmus::CellMesh& mesh)
{
  mesh = isthmus::ReadTetGenFiles(this->FileName, isthmus::MakeProgress(this));
}
