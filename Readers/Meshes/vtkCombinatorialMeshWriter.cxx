#include "vtkCombinatorialMeshWriter.h"

#include "CellComplex/GridCells.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ArrayMemory.h"
#include "Files/FileReplacement.h"
#include "Meshes/CombinatorialMeshFile.h"
#include "Meshes/MeshConversion.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkCombinatorialMeshWriter);

namespace
{

/// The tuples of an array that `tupleOf(i)` names, i < count.
template <typename TupleOf>
isthmus::NumberList Numbers(vtkDataArray* array, std::int64_t count, TupleOf&& tupleOf)
{
  // A copy in VTK's plain layout, whatever the array's own.
  auto plain =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array->GetDataType()));
  plain->SetNumberOfComponents(array->GetNumberOfComponents());
  vtkNew<vtkIdList> tuples;
  tuples->SetNumberOfIds(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    tuples->SetId(i, tupleOf(i));
  }
  isthmus::SizeArray(plain, count);
  array->GetTuples(tuples, plain);
  return isthmus::ToNumberList(plain);
}

/// Adds the arrays of `data`, which are on `all` points or cells; returns messages about those that
/// are not numeric or too short.
template <typename TupleOf>
std::string AddAttributes(vtkDataSetAttributes* data, isthmus::MeshAttribute::Place place,
  vtkIdType all, std::int64_t count, TupleOf&& tupleOf, isthmus::CombinatorialMesh& mesh)
{
  std::string leftOut, tooShort;
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* any = data->GetAbstractArray(a);
    const std::string name = any->GetName() ? any->GetName() : "Array" + std::to_string(a);
    vtkDataArray* array = vtkDataArray::SafeDownCast(any);
    if (!array || array->GetDataType() == VTK_BIT)
    {
      leftOut += " '" + name + "'";
      continue;
    }
    if (array->GetNumberOfTuples() < all)
    {
      tooShort += " '" + name + "'";
      continue;
    }
    mesh.Attributes.push_back(
      { place, name, array->GetNumberOfComponents(), Numbers(array, count, tupleOf) });
  }
  const char* where =
    place == isthmus::MeshAttribute::Place::Cells ? "cells are left out:" : "points are left out:";
  return (leftOut.empty() ? "" : "Arrays that hold no numbers for " + (where + leftOut) + ". ") +
    (tooShort.empty() ? ""
                      : "Arrays that have too few tuples for the " + (where + tooShort) + ". ");
}

void CheckVertices(const isthmus::CombinatorialMesh& mesh)
{
  for (const std::int64_t vertex : mesh.CellVertices)
  {
    if (vertex < 0 || vertex >= mesh.NumberOfVertices)
    {
      throw std::invalid_argument("A cell has the point number " + std::to_string(vertex) +
        ", but points are numbered 0 ... " + std::to_string(mesh.NumberOfVertices - 1) +
        ": the grid is damaged.");
    }
  }
}

/// The mesh of `grid`; `remark` is a note for the user.
isthmus::CombinatorialMesh ToCombinatorialMesh(vtkUnstructuredGrid* grid, std::string& remark)
{
  const isthmus::GridCells cells(grid, isthmus::GridCells::Orientation::AsGiven);
  const isthmus::CellList list = cells.List();
  isthmus::CombinatorialMesh mesh;
  mesh.NumberOfVertices = list.NumberOfVertices;
  mesh.Types = list.Types;
  mesh.Runs = list.Runs;
  mesh.CellVertices.assign(list.CellVertices.begin(), list.CellVertices.end());
  CheckVertices(mesh);
  const auto same = [](vtkIdType i) { return i; };
  if (vtkPoints* points = grid->GetPoints())
  {
    if (points->GetDataType() != VTK_FLOAT && points->GetDataType() != VTK_DOUBLE)
    {
      throw std::invalid_argument("The coordinates of the points are neither float nor double.");
    }
    isthmus::RequireFinitePoints(grid);
    mesh.Coordinates = Numbers(points->GetData(), mesh.NumberOfVertices, same);
  }
  remark = cells.Remark();
  remark += AddAttributes(grid->GetPointData(), isthmus::MeshAttribute::Place::Vertices,
    grid->GetNumberOfPoints(), mesh.NumberOfVertices, same, mesh);
  remark += AddAttributes(
    grid->GetCellData(), isthmus::MeshAttribute::Place::Cells, grid->GetNumberOfCells(),
    cells.NumberOfCells(), [&](vtkIdType i) { return cells.GridId(static_cast<std::size_t>(i)); },
    mesh);
  return mesh;
}

}

int vtkCombinatorialMeshWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

void vtkCombinatorialMeshWriter::WriteFile()
{
  std::string remark;
  const isthmus::CombinatorialMesh mesh =
    ToCombinatorialMesh(vtkUnstructuredGrid::SafeDownCast(this->GetInput()), remark);
  isthmus::FileReplacement replacement(this->FileName);
  std::ofstream file(replacement.Written(), std::ios::binary);
  errno = 0;
  isthmus::WriteCombinatorialMesh(mesh, this->Binary, file, isthmus::MakeProgress(this));
  file.close();
  if (!file)
  {
    replacement.Fail(errno);
  }
  replacement.Replace();
  if (!remark.empty())
  {
    vtkWarningMacro(<< remark);
  }
}

void vtkCombinatorialMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Binary: " << this->Binary << "\n";
}
