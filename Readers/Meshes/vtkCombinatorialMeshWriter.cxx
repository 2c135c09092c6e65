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
#include <type_traits>

vtkStandardNewMacro(vtkCombinatorialMeshWriter);

namespace
{

/// The file's type for a type of VTK's: a number of the same size and kind.
template <typename T>
using FileNumber = std::conditional_t<std::is_floating_point_v<T>, T,
  std::conditional_t<std::is_signed_v<T>,
    std::conditional_t<sizeof(T) == 1, std::int8_t,
      std::conditional_t<sizeof(T) == 2, std::int16_t,
        std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>>>,
    std::conditional_t<sizeof(T) == 1, std::uint8_t,
      std::conditional_t<sizeof(T) == 2, std::uint16_t,
        std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>>>;

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
  isthmus::NumberList list;
  switch (plain->GetDataType())
  {
    vtkTemplateMacro({
      const auto* values = static_cast<const VTK_TT*>(plain->GetVoidPointer(0));
      list = std::vector<FileNumber<VTK_TT>>(values, values + plain->GetNumberOfValues());
    });
    default:
      throw std::invalid_argument("The array '" + std::string(array->GetName()) +
        "' holds numbers of a type that the format does not have.");
  }
  return list;
}

/// Adds the arrays of `data`; returns the names of those that hold no numbers.
template <typename TupleOf>
std::string AddAttributes(vtkDataSetAttributes* data, isthmus::MeshAttribute::Place place,
  std::int64_t count, TupleOf&& tupleOf, isthmus::CombinatorialMesh& mesh)
{
  std::string leftOut;
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
    mesh.Attributes.push_back(
      { place, name, array->GetNumberOfComponents(), Numbers(array, count, tupleOf) });
  }
  return leftOut;
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

/// The mesh of `grid`; `remark` is what the user should know.
isthmus::CombinatorialMesh MeshOf(vtkUnstructuredGrid* grid, std::string& remark)
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
  std::string leftOut = AddAttributes(grid->GetPointData(), isthmus::MeshAttribute::Place::Vertices,
    mesh.NumberOfVertices, same, mesh);
  leftOut += AddAttributes(
    grid->GetCellData(), isthmus::MeshAttribute::Place::Cells, cells.NumberOfCells(),
    [&](vtkIdType i) { return cells.GridId(static_cast<std::size_t>(i)); }, mesh);
  remark += leftOut.empty() ? "" : "Arrays that hold no numbers are left out:" + leftOut + ". ";
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
    MeshOf(vtkUnstructuredGrid::SafeDownCast(this->GetInput()), remark);
  if (!remark.empty())
  {
    vtkWarningMacro(<< remark);
  }
  isthmus::FileReplacement replacement(this->FileName);
  std::ofstream file(replacement.Written(), std::ios::binary);
  errno = 0;
  isthmus::WriteCombinatorialMesh(mesh, this->Binary, file, isthmus::ProgressOf(this));
  file.close();
  if (!file)
  {
    replacement.Fail(errno);
  }
  replacement.Replace();
}

void vtkCombinatorialMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Binary: " << this->Binary << "\n";
}
