#include "Meshes/MeshConversion.h"
#include "Core/ArrayMemory.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTypeTraits.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// VTK's number of each shape, in the order of CellShape.
constexpr std::array<int, 15> vtkTypes{ VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON,
  VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_EDGE,
  VTK_QUADRATIC_TRIANGLE, VTK_BIQUADRATIC_QUAD, VTK_BIQUADRATIC_QUADRATIC_WEDGE,
  VTK_TRIQUADRATIC_HEXAHEDRON };

CellShape ShapeOf(int vtkType)
{
  const auto* found = std::find(vtkTypes.begin(), vtkTypes.end(), vtkType);
  if (found == vtkTypes.end())
  {
    throw std::invalid_argument("The mesh has cells of VTK's type " + std::to_string(vtkType) +
      ", which mesh files of this kind do not hold: triangulate or tetrahedralize it first.");
  }
  return static_cast<CellShape>(found - vtkTypes.begin());
}

void SetPoints(const CellMesh& mesh, vtkPointSet* data)
{
  vtkNew<vtkPoints> points;
  points->SetData(ToDataArray(mesh.Coordinates, 3));
  data->SetPoints(points);
}

void MakeNormalsActive(vtkPointSet* data)
{
  if (data->GetPointData()->GetArray("Normals"))
  {
    data->GetPointData()->SetActiveNormals("Normals");
  }
}

/// 0 vertices, 1 lines, 2 polygons: VTK's order of a surface's cells.
int Rank(CellShape shape)
{
  return std::min(static_cast<int>(shape), 2);
}

void ReadPoints(vtkPointSet* data, CellMesh& mesh)
{
  RequireFinitePoints(data);
  mesh.Coordinates.resize(static_cast<std::size_t>(data->GetNumberOfPoints()) * 3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, mesh.Coordinates.data() + 3 * i);
  }
}

void ReadCells(vtkPointSet* data, CellMesh& mesh)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const CellShape shape = ShapeOf(data->GetCellType(cell));
    data->GetCellPoints(cell, ids);
    for (const vtkIdType id : *ids)
    {
      if (id < 0 || id >= data->GetNumberOfPoints())
      {
        throw std::invalid_argument("Cell " + std::to_string(cell) + " names point " +
          std::to_string(id) + ", but there are " + std::to_string(data->GetNumberOfPoints()) +
          ": the mesh is damaged.");
      }
      mesh.Vertices.push_back(id);
    }
    mesh.EndCell(shape);
  }
}

template <typename T>
std::vector<T> ValuesOf(vtkDataArray* array)
{
  std::vector<T> values;
  const int components = array->GetNumberOfComponents();
  values.reserve(static_cast<std::size_t>(array->GetNumberOfValues()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      values.push_back(static_cast<T>(array->GetComponent(i, c)));
    }
  }
  return values;
}

/// Adds what is wanted; returns the names of the others.
std::string ReadArrays(vtkDataSetAttributes* data, MeshAttribute::Place place,
  const std::vector<std::string>& names, CellMesh& mesh)
{
  std::string leftOut;
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = data->GetArray(a);
    const char* given = data->GetAbstractArray(a)->GetName();
    const std::string name = given ? given : "(no name)";
    if (!array || std::find(names.begin(), names.end(), name) == names.end())
    {
      leftOut += " '" + name + "'";
      continue;
    }
    const bool whole = array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
    mesh.Attributes.push_back({ place, name, array->GetNumberOfComponents(),
      whole ? NumberList(ValuesOf<std::int64_t>(array)) : NumberList(ValuesOf<double>(array)) });
  }
  return leftOut;
}

}

vtkSmartPointer<vtkDataArray> ToDataArray(const NumberList& numbers, std::int64_t components)
{
  return std::visit(
    [components](const auto& values)
    {
      using Value = typename std::decay_t<decltype(values)>::value_type;
      auto array = vtkSmartPointer<vtkDataArray>::Take(
        vtkDataArray::CreateDataArray(vtkTypeTraits<Value>::VTKTypeID()));
      array->SetNumberOfComponents(static_cast<int>(components));
      SizeArray(array, static_cast<vtkIdType>(values.size()) / components);
      if (!values.empty())
      {
        std::memcpy(array->GetVoidPointer(0), values.data(), values.size() * sizeof(Value));
      }
      return array;
    },
    numbers);
}

void AddAttributes(const std::vector<MeshAttribute>& attributes, vtkDataSet* data)
{
  for (const MeshAttribute& attribute : attributes)
  {
    const auto array = ToDataArray(attribute.Values, attribute.Components);
    array->SetName(attribute.Name.c_str());
    vtkDataSetAttributes* to = data->GetPointData();
    if (attribute.On == MeshAttribute::Place::Cells)
    {
      to = data->GetCellData();
    }
    to->AddArray(array);
  }
}

void AddNotes(const std::vector<std::string>& notes, vtkDataSet* data)
{
  if (notes.empty())
  {
    return;
  }
  vtkNew<vtkStringArray> array;
  array->SetName("Notes");
  for (const std::string& note : notes)
  {
    array->InsertNextValue(note);
  }
  data->GetFieldData()->AddArray(array);
}

void ToGrid(const CellMesh& mesh, vtkUnstructuredGrid* grid)
{
  SetPoints(mesh, grid);
  grid->AllocateExact(mesh.NumberOfCells(), static_cast<vtkIdType>(mesh.Vertices.size()));
  for (std::size_t cell = 0; cell < mesh.Shapes.size(); ++cell)
  {
    const auto first = mesh.Offsets[cell];
    const std::vector<vtkIdType> ids(
      mesh.Vertices.begin() + first, mesh.Vertices.begin() + mesh.Offsets[cell + 1]);
    grid->InsertNextCell(vtkTypes[static_cast<std::size_t>(mesh.Shapes[cell])],
      static_cast<vtkIdType>(ids.size()), ids.data());
  }
  AddAttributes(mesh.Attributes, grid);
  MakeNormalsActive(grid);
}

void ToSurface(const CellMesh& mesh, vtkPolyData* surface)
{
  SetPoints(mesh, surface);
  std::array<vtkSmartPointer<vtkCellArray>, 3> cells;
  for (int rank = 0; rank < 3; ++rank)
  {
    cells[static_cast<std::size_t>(rank)] = vtkSmartPointer<vtkCellArray>::New();
    for (std::size_t cell = 0; cell < mesh.Shapes.size(); ++cell)
    {
      if (Rank(mesh.Shapes[cell]) == rank)
      {
        const std::vector<vtkIdType> ids(mesh.Vertices.begin() + mesh.Offsets[cell],
          mesh.Vertices.begin() + mesh.Offsets[cell + 1]);
        cells[static_cast<std::size_t>(rank)]->InsertNextCell(
          static_cast<vtkIdType>(ids.size()), ids.data());
      }
    }
  }
  surface->SetVerts(cells[0]);
  surface->SetLines(cells[1]);
  surface->SetPolys(cells[2]);
  AddAttributes(mesh.Attributes, surface);
  MakeNormalsActive(surface);
}

void RequireFinitePoints(vtkPointSet* data)
{
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    if (!std::all_of(p, p + 3, [](double x) { return std::isfinite(x); }))
    {
      throw std::invalid_argument("Point " + std::to_string(i) +
        " has a coordinate that is not a finite number: correct or remove it before writing.");
    }
  }
}

CellMesh FromPointSet(vtkPointSet* data, const std::vector<std::string>& names, std::string& remark)
{
  CellMesh mesh;
  ReadPoints(data, mesh);
  ReadCells(data, mesh);
  const std::string leftOut =
    ReadArrays(data->GetPointData(), MeshAttribute::Place::Vertices, names, mesh) +
    ReadArrays(data->GetCellData(), MeshAttribute::Place::Cells, names, mesh);
  remark =
    leftOut.empty() ? "" : "Arrays that the format does not hold are left out:" + leftOut + ".";
  return mesh;
}

}
