#include "vtkTetGenMeshReader.h"

#include "Core/AlgorithmGuard.h"
#include "Files/ReaderGuard.h"
#include "Meshes/TetGenMeshFile.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkTetGenMeshReader);

const std::vector<isthmus::OutputArray>& vtkTetGenMeshReader::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Attribute", 0, "", ArrayChoice::None,
      "attributes of the points, if the file has them" },
    { 0, ArrayPlace::Points, "BoundaryMarker", 1, "", ArrayChoice::None,
      "of the points, if the file has them" },
    { 0, ArrayPlace::Cells, "Attribute", 0, "", ArrayChoice::None,
      "attributes of the tetrahedra, if the file has them" },
    { 0, ArrayPlace::Cells, "BoundaryMarker", 1, "", ArrayChoice::None,
      "of the triangles, if the file has them" },
    { 0, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,
      "what is unusual about the mesh; missing if nothing is" },
  };
  return table;
}

int vtkTetGenMeshReader::CanReadFile(const char* fileName)
{
  return isthmus::CanRead(fileName, isthmus::LooksLikeTetGen);
}

void vtkTetGenMeshReader::ReadMesh(isthmus::CellMesh& mesh)
{
  mesh = isthmus::ReadTetGenFiles(this->FileName, isthmus::MakeProgress(this));
}
