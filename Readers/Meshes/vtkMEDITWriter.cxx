#include "vtkMEDITWriter.h"

#include "Core/AlgorithmGuard.h"
#include "Meshes/MEDITFile.h"

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
