#include "vtkMEDITReader.h"

#include "Core/AlgorithmGuard.h"
#include "Files/ReaderGuard.h"
#include "Meshes/MEDITFile.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkMEDITReader);

int vtkMEDITReader::CanReadFile(const char* fileName)
{
  return isthmus::CanRead(fileName, isthmus::LooksLikeMEDIT);
}

void vtkMEDITReader::ReadMesh(isthmus::CellMesh& mesh)
{
  mesh = isthmus::ReadMEDIT(this->FileName, isthmus::MakeProgress(this));
}
