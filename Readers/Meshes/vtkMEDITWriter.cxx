#include "vtkMEDITWriter.h"

#include "Core/AlgorithmGuard.h"
#include "Meshes/MEDITFile.h"
#include "Meshes/MeshConversion.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkMEDITWriter);

void vtkMEDITWriter::WriteMesh(const isthmus::CellMesh& mesh)
{
  isthmus::WriteMEDIT(mesh, this->FileName, isthmus::MakeProgress(this));
}

std::vector<isthmus::MeshArrayRule> vtkMEDITWriter::Arrays() const
{
  using isthmus::MeshArrayRule;
  return { { isthmus::MeshAttribute::Place::Vertices, "Reference", MeshArrayRule::Numbers::Whole },
    { isthmus::MeshAttribute::Place::Cells, "Reference", MeshArrayRule::Numbers::Whole } };
}
