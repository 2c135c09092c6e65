#include "Meshes/MeshConversion.h"
#include "Core/ArrayMemory.h"
#include "Core/InvertedCells.h"
#include "Core/NamedColumns.h"

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
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace isthmus
{
namespace
{

/// VTK's number of each shape, in the order of CellShape.
constexpr std::array<int, 15> vtkTypes{ VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON,
  VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_EDGE,
  VTK_QUADRATIC_TRIANGLE, VTK_BIQUADRATIC_QUAD, VTK_BIQUADRATIC_QUADRATIC_WEDGE,
  VTK_TRIQUADRATIC_HEXAHEDRON };

CellShape FindCellShape(int vtkType)
{
  const auto* found = std::find(vtkTypes.begin(), vtkTypes.end(), vtkType);
  if (found == vtkTypes.end())
  {
    throw std::invalid_argument("The mesh has cells of VTK's type " + std::to_string(vtkType) +
      ", which mesh files of this kind do not support: triangulate or tetrahedralize it first.");
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
    const CellShape shape = FindCellShape(data->GetCellType(cell));
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

/// The number type of a file for a VTK type: of the same size and kind.
template <typename T>
using FileNumber = std::conditional_t<std::is_floating_point_v<T>, T,
  std::conditional_t<std::is_signed_v<T>,
    std::conditional_t<sizeof(T) == 1, std::int8_t,
      std::conditional_t<sizeof(T) == 2, std::int16_t,
        std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>>>,
    std::conditional_t<sizeof(T) == 1, std::uint8_t,
      std::conditional_t<sizeof(T) == 2, std::uint16_t,
        std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>>>;

/// Whether To can hold `value` exactly; sets `result` to it.
template <typename To, typename From>
bool IsExactly(From value, To& result)
{
  if constexpr (std::is_floating_point_v<From> && std::is_integral_v<To>)
  {
    constexpr From limit = From(9223372036854775808.0); // 2^63
    if (!(value >= -limit && value < limit) || value != std::floor(value))
    {
      return false;
    }
    result = static_cast<To>(value);
    return true;
  }
  else if constexpr (std::is_integral_v<From> && std::is_floating_point_v<To>)
  {
    result = static_cast<To>(value);
    // The largest integers round up to a number outside the range of their type.
    constexpr From half = std::numeric_limits<From>::max() / 2 + 1;
    constexpr To limit = static_cast<To>(half) * 2;
    return result < limit && static_cast<From>(result) == value;
  }
  else
  {
    result = static_cast<To>(+value); // as int where it is a char, which is a number here
    return !std::is_integral_v<To> ||
      (static_cast<From>(result) == value && (result < 0) == (value < 0));
  }
}

/// Why a value does not fit a rule; empty: it fits.
template <typename To, typename From>
std::string Convert(From value, MeshArrayRule::Numbers kind, To& result)
{
  if (!IsExactly(value, result))
  {
    return std::is_integral_v<To> ? "whole numbers of 64 bits" : "numbers in double precision";
  }
  if constexpr (std::is_floating_point_v<To>)
  {
    if (kind == MeshArrayRule::Numbers::Finite && !std::isfinite(result))
    {
      return "finite numbers";
    }
  }
  return {};
}

/// Whether a tuple of a rule's array is stored.
bool IsStored(const MeshArrayRule& rule, const CellMesh& mesh, std::size_t tuple)
{
  return rule.Shapes.empty() ||
    std::find(rule.Shapes.begin(), rule.Shapes.end(), mesh.Shapes[tuple]) != rule.Shapes.end();
}

/// Appends the array's values to `to`. Returns why it is dropped; empty: it is not. `lost` becomes
/// whether values other than 0 are on cells that the format does not store them on.
template <typename To>
std::string Convert(vtkDataArray* array, const MeshArrayRule& rule, const CellMesh& mesh,
  std::vector<To>& to, bool& lost)
{
  const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
  return std::visit(
    [&](const auto& values)
    {
      to.assign(values.size(), To());
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        if (!IsStored(rule, mesh, i / components))
        {
          lost = lost || values[i] != 0;
          continue;
        }
        const std::string wanted = Convert(values[i], rule.Kind, to[i]);
        if (!wanted.empty())
        {
          std::array<char, 64> digits;
          return "the format holds " + wanted + ", and tuple " + std::to_string(i / components) +
            " has " + std::string(ToText(values[i], digits));
        }
      }
      return std::string();
    },
    ToNumberList(array));
}

/// Violation of an array's rule other than the type of its values; empty if there is none.
std::string FindFault(vtkDataArray* array, const MeshArrayRule& rule, const CellMesh& mesh)
{
  if (!array)
  {
    return "it has no numbers";
  }
  if (rule.Components > 0 && array->GetNumberOfComponents() != rule.Components)
  {
    return "the format holds " + std::to_string(rule.Components) + " components, and it has " +
      std::to_string(array->GetNumberOfComponents());
  }
  const std::int64_t tuples =
    rule.On == MeshAttribute::Place::Cells ? mesh.NumberOfCells() : mesh.NumberOfPoints();
  if (array->GetNumberOfTuples() != tuples)
  {
    return "it has " + std::to_string(array->GetNumberOfTuples()) + " tuples for " +
      std::to_string(tuples) + (rule.On == MeshAttribute::Place::Cells ? " cells" : " points");
  }
  for (std::size_t i = 0; i < mesh.Shapes.size(); ++i)
  {
    if (IsStored(rule, mesh, i))
    {
      return {};
    }
  }
  const bool isHeld = rule.Shapes.empty() || mesh.Shapes.empty();
  return isHeld ? "" : "the format does not store it on cells of these shapes";
}

/// The dropped arrays of a mesh.
struct Dropped
{
  std::string Names;     ///< of arrays that the format does not hold
  std::string Sentences; ///< about others
};

void ReadArray(vtkAbstractArray* any, const MeshArrayRule& rule, CellMesh& mesh, Dropped& dropped)
{
  auto* const array = vtkDataArray::SafeDownCast(any);
  const std::string name =
    "'" + rule.Name + "' of " + (rule.On == MeshAttribute::Place::Cells ? "cells" : "points");
  std::string fault = FindFault(array, rule, mesh);
  bool lost = false;
  NumberList list;
  if (fault.empty() && rule.Kind == MeshArrayRule::Numbers::Whole)
  {
    fault = Convert(array, rule, mesh, list.emplace<std::vector<std::int64_t>>(), lost);
  }
  else if (fault.empty())
  {
    fault = Convert(array, rule, mesh, list.emplace<std::vector<double>>(), lost);
  }
  if (!fault.empty())
  {
    dropped.Sentences += " Array " + name + " is left out: " + fault + ".";
    return;
  }
  if (lost)
  {
    dropped.Sentences +=
      " Values of " + name + " are dropped where the format does not store it on the cell.";
  }
  mesh.Attributes.push_back(
    { rule.On, rule.Name, array->GetNumberOfComponents(), std::move(list) });
}

void ReadArrays(vtkDataSetAttributes* data, MeshAttribute::Place place,
  const std::vector<MeshArrayRule>& rules, CellMesh& mesh, Dropped& dropped)
{
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    const char* given = data->GetAbstractArray(a)->GetName();
    const std::string name = given ? given : "(no name)";
    const auto rule = std::find_if(rules.begin(), rules.end(),
      [&](const MeshArrayRule& known) { return known.On == place && known.Name == name; });
    if (rule == rules.end())
    {
      dropped.Names += " '" + name + "'";
      continue;
    }
    ReadArray(data->GetAbstractArray(a), *rule, mesh, dropped);
  }
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

NumberList ToNumberList(vtkDataArray* array)
{
  NumberList list;
  const auto count = static_cast<std::size_t>(array->GetNumberOfValues());
  if (array->GetDataType() == VTK_BIT)
  {
    std::vector<std::uint8_t> bits;
    const vtkIdType components = array->GetNumberOfComponents();
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      bits.push_back(static_cast<std::uint8_t>(
        array->GetComponent(i / components, static_cast<int>(i % components))));
    }
    return bits;
  }
  // A copy in VTK's plain layout, whatever the array's own.
  vtkSmartPointer<vtkDataArray> plain = array;
  if (!array->HasStandardMemoryLayout())
  {
    plain =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array->GetDataType()));
    plain->DeepCopy(array);
  }
  switch (plain->GetDataType())
  {
    vtkTemplateMacro({
      const auto* values = static_cast<const VTK_TT*>(plain->GetVoidPointer(0));
      list = std::vector<FileNumber<VTK_TT>>(values, values + count);
    });
    default:
      throw std::invalid_argument(
        "An array holds numbers of a type that the format does not have.");
  }
  return list;
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
  if (!notes.empty())
  {
    AddColumn<vtkStringArray>(data->GetFieldData(), "Notes", notes);
  }
}

std::string InvertedTetrahedra(const CellMesh& mesh)
{
  InvertedCells cells;
  const auto corner = [&mesh](std::int64_t at)
  {
    const auto point = 3 * static_cast<std::size_t>(mesh.Vertices[static_cast<std::size_t>(at)]);
    return Point3{ mesh.Coordinates[point], mesh.Coordinates[point + 1],
      mesh.Coordinates[point + 2] };
  };
  for (std::size_t cell = 0; cell < mesh.Shapes.size(); ++cell)
  {
    // The corners of a quadratic one come first.
    if (mesh.Shapes[cell] == CellShape::Tetrahedron ||
      mesh.Shapes[cell] == CellShape::QuadraticTetrahedron)
    {
      const std::int64_t first = mesh.Offsets[cell];
      cells.Add(static_cast<vtkIdType>(cell),
        SixSignedVolumes(corner(first), corner(first + 1), corner(first + 2), corner(first + 3)));
    }
  }
  return cells.Message();
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

CellMesh FromPointSet(
  vtkPointSet* data, const std::vector<MeshArrayRule>& rules, std::string& remark)
{
  CellMesh mesh;
  ReadPoints(data, mesh);
  ReadCells(data, mesh);
  Dropped dropped;
  ReadArrays(data->GetPointData(), MeshAttribute::Place::Vertices, rules, mesh, dropped);
  ReadArrays(data->GetCellData(), MeshAttribute::Place::Cells, rules, mesh, dropped);
  remark = dropped.Names.empty()
    ? ""
    : "Arrays that the format cannot store are dropped:" + dropped.Names + ".";
  remark += dropped.Sentences.substr(remark.empty() && !dropped.Sentences.empty() ? 1 : 0);
  return mesh;
}

}
