#include "vtkMEDITWriter.h"

#include "AlgorithmGuard.h"
#include "MEDITFile.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkMEDITWriter);

void vtkMEDITWriter::WriteMesh(const isthmus::CellMesh& mesh)
{
  isthmus::WriteMEDIT(mesh, this->FileName, isthmus::ProgressOf(this));
}

const char* vtkMEDITWriter::ArrayNames() const
{
  return "Reference";
}
