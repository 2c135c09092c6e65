#include "vtkTetGenMeshWriter.h"

#include "Core/AlgorithmGuard.h"
#include "Meshes/MeshConversion.h"
#include "Meshes/TetGenMeshFile.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkTetGenMeshWriter);

void vtkTetGenMeshWriter::WriteMesh(const isthmus::CellMesh& mesh)
{
  isthmus::WriteTetGenFiles(mesh, this->FileName, isthmus::MakeProgress(this));
}

std::vector<isthmus::MeshArrayRule> vtkTetGenMeshWriter::Arrays() const
{
  using isthmus::CellShape;
  using isthmus::MeshArrayRule;
  using Place = isthmus::MeshAttribute::Place;
  const std::vector<CellShape> tetrahedra{ CellShape::Tetrahedron,
    CellShape::QuadraticTetrahedron };
  return { { Place::Vertices, "Attribute", MeshArrayRule::Numbers::Any, 0 },
    { Place::Vertices, "BoundaryMarker", MeshArrayRule::Numbers::Whole },
    { Place::Cells, "Attribute", MeshArrayRule::Numbers::Any, 0, tetrahedra },
    { Place::Cells, "BoundaryMarker", MeshArrayRule::Numbers::Whole, 1, { CellShape::Triangle } } };
}
