#include "vtkMEDITReader.h"

#include "AlgorithmGuard.h"
#include "MEDITFile.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkMEDITReader);

int vtkMEDITReader::CanReadFile(const char* fileName)
{
  return fileName && isthmus::LooksLikeMEDIT(fileName) ? 1 : 0;
}

void vtkMEDITReader::ReadMesh(isthmus::CellMesh& mesh)
{
  mesh = isthmus::ReadMEDIT(this->FileName, isthmus::ProgressOf(this));
}
