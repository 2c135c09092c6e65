#include "CellComplex/GridCells.h"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <utility>

namespace isthmus
{
namespace
{

/// A prism with `n` sides: base 0 ... n - 1 counter-clockwise seen from the top, top n ... 2n - 1.
GridCellType PrismWithSides(int vtkType, const std::string& name, int n)
{
  std::vector<int> base, top, turned;
  FaceList faces;
  for (int i = 0; i < n; ++i)
  {
    base.push_back(n - 1 - i);
    top.push_back(n + i);
    turned.push_back((n - i) % n);
  }
  faces = { base, top };
  for (int i = 0; i < n; ++i)
  {
    faces.push_back({ i, (i + 1) % n, n + (i + 1) % n, n + i });
    turned.push_back(n + (n - i) % n);
  }
  return { vtkType, CellType(name, 2 * n, faces), turned };
}

/// The linear type whose corners come first in a cell of type `vtkType`, or -1.
int GetLinearType(int vtkType)
{
  switch (vtkType)
  {
    case VTK_QUADRATIC_TETRA:
    case VTK_LAGRANGE_TETRAHEDRON:
      return VTK_TETRA;
    case VTK_QUADRATIC_PYRAMID:
    case VTK_TRIQUADRATIC_PYRAMID:
    case VTK_LAGRANGE_PYRAMID:
      return VTK_PYRAMID;
    case VTK_QUADRATIC_WEDGE:
    case VTK_QUADRATIC_LINEAR_WEDGE:
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
    case VTK_LAGRANGE_WEDGE:
      return VTK_WEDGE;
    case VTK_QUADRATIC_HEXAHEDRON:
    case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
    case VTK_TRIQUADRATIC_HEXAHEDRON:
    case VTK_LAGRANGE_HEXAHEDRON:
      return VTK_HEXAHEDRON;
    default:
      return -1;
  }
}

}

const std::vector<GridCellType>& LinearCellTypes()
{
  static const std::vector<GridCellType> types{ { VTK_TETRA, CellType::Tetrahedron(),
                                                  { 0, 2, 1, 3 } },
    { VTK_PYRAMID, CellType::Pyramid(), { 0, 3, 2, 1, 4 } },
    // VTK's wedge has (0, 1, 2) facing outwards, the thesis' prism the other way round.
    { VTK_WEDGE,
      CellType(
        "wedge", 6, { { 0, 1, 2 }, { 3, 5, 4 }, { 0, 3, 4, 1 }, { 1, 4, 5, 2 }, { 2, 5, 3, 0 } }),
      { 0, 2, 1, 3, 5, 4 } },
    { VTK_HEXAHEDRON, CellType::Hexahedron(), { 0, 3, 2, 1, 4, 7, 6, 5 } },
    { VTK_VOXEL,
      CellType("voxel", 8,
        { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 1, 3, 7, 5 }, { 3, 2, 6, 7 },
          { 2, 0, 4, 6 } }),
      { 0, 2, 1, 3, 4, 6, 5, 7 } },
    PrismWithSides(VTK_PENTAGONAL_PRISM, "pentagonal prism", 5),
    PrismWithSides(VTK_HEXAGONAL_PRISM, "hexagonal prism", 6) };
  return types;
}

/// Appends one cell after the other.
class GridCells::Builder
{
public:
  Builder(GridCells& cells, vtkUnstructuredGrid* grid, Orientation orientation)
    : Cells(cells)
    , Grid(grid)
    , ByVolume(orientation == Orientation::ByVolume)
  {
  }

  void Add(vtkIdType id)
  {
    const int vtkType = this->Grid->GetCellType(id);
    if (vtkType == VTK_POLYHEDRON)
    {
      this->AddPolyhedron(id);
      return;
    }
    const int linear = GetLinearType(vtkType);
    const std::vector<GridCellType>& known = LinearCellTypes();
    const auto found = std::find_if(known.begin(), known.end(),
      [&](const GridCellType& type) { return type.VTKType == (linear < 0 ? vtkType : linear); });
    if (found == known.end())
    {
      this->SkipCell(id);
      return;
    }
    this->Cells.Simplified += linear < 0 ? 0 : 1;
    this->AddLinear(id, *found, static_cast<std::size_t>(found - known.begin()));
  }

private:
  void SkipCell(vtkIdType id)
  {
    this->Grid->GetCell(id, this->Generic);
    if (this->Generic->GetCellDimension() == 3)
    {
      throw std::invalid_argument("Cell " + std::to_string(id) + " is of the type " +
        this->Grid->GetCell(id)->GetClassName() +
        ", whose faces are not determined by its points: convert such cells to polyhedra or "
        "tetrahedra.");
    }
    ++this->Cells.DroppedCells;
  }

  void AddLinear(vtkIdType id, const GridCellType& type, std::size_t known)
  {
    this->Grid->GetCellPoints(id, this->PointBuffer);
    const vtkIdType count = this->PointBuffer->GetNumberOfIds();
    const vtkIdType* const points = this->PointBuffer->GetPointer(0);
    const auto corners = static_cast<std::size_t>(type.Type.NumberOfVertices());
    if (count < type.Type.NumberOfVertices())
    {
      throw std::invalid_argument("Cell " + std::to_string(id) + " has " + std::to_string(count) +
        " points, but a " + type.Type.Name() + " needs " + std::to_string(corners) +
        ": the grid is damaged.");
    }
    const double sixVolumes = this->SixVolumes(type.Type.Faces(), points);
    this->Cells.Inverted.Add(id, sixVolumes);
    const bool turn = this->ByVolume && sixVolumes < 0.0;
    if (this->LinearNumbers[known] == None)
    {
      this->LinearNumbers[known] = this->Cells.Types.size();
      this->Cells.Types.push_back(type.Type);
    }
    this->BeginCell(id, this->LinearNumbers[known]);
    for (std::size_t i = 0; i < corners; ++i)
    {
      this->Cells.Vertices.push_back(
        points[turn ? static_cast<std::size_t>(type.TurnedOut[i]) : i]);
    }
  }

  void AddPolyhedron(vtkIdType id)
  {
    this->Grid->GetCellPoints(id, this->PointBuffer);
    const vtkIdType count = this->PointBuffer->GetNumberOfIds();
    const vtkIdType* const points = this->PointBuffer->GetPointer(0);
    std::map<vtkIdType, int> local;
    for (vtkIdType i = 0; i < count; ++i)
    {
      local.emplace(points[i], static_cast<int>(i));
    }
    // Number of faces, then each as its size and points.
    this->Grid->GetFaceStream(id, this->StreamBuffer);
    const vtkIdType* stream = this->StreamBuffer->GetPointer(0);
    FaceList faces(static_cast<std::size_t>(*stream++));
    for (std::vector<int>& face : faces)
    {
      for (vtkIdType size = *stream++; size > 0; --size, ++stream)
      {
        const auto found = local.find(*stream);
        // CellType rejects a vertex that does not belong to the cell.
        face.push_back(found == local.end() ? -1 : found->second);
      }
    }
    faces = OrientFaces(std::move(faces));
    const auto number = this->PolyhedronNumber(id, static_cast<int>(count), faces, points);
    this->BeginCell(id, number);
    this->Cells.Vertices.insert(this->Cells.Vertices.end(), points, points + count);
  }

  std::size_t PolyhedronNumber(
    vtkIdType id, int vertexCount, FaceList& faces, const vtkIdType* points)
  {
    try
    {
      // Rejects wrong vertices before their coordinates are read.
      CellType type("polyhedron of cell " + std::to_string(id), vertexCount, faces);
      if (this->ByVolume && this->SixVolumes(faces, points) < 0.0)
      {
        type = type.MakeMirrorImage();
      }
      return this->TypeNumber(type);
    }
    catch (const std::invalid_argument& error)
    {
      throw std::invalid_argument("Cell " + std::to_string(id) + " is not valid. " + error.what());
    }
  }

  /// Six times the volume that the faces enclose, negative if they face inwards.
  double SixVolumes(const FaceList& faces, const vtkIdType* points)
  {
    const auto at = [&](int vertex)
    {
      std::array<double, 3> position{};
      const vtkIdType point = points[vertex];
      if (point >= 0 && point < this->Cells.NumberOfPoints)
      {
        this->Grid->GetPoint(point, position.data());
      }
      return position; // an invalid number is rejected later, with all others of its kind
    };
    const std::array<double, 3> origin = at(0);
    double sum = 0.0;
    for (const std::vector<int>& face : faces)
    {
      std::array<double, 3> a = at(face[0]), b, c = at(face[1]);
      vtkMath::Subtract(a.data(), origin.data(), a.data());
      vtkMath::Subtract(c.data(), origin.data(), c.data());
      for (std::size_t i = 2; i < face.size(); ++i)
      {
        b = c;
        c = at(face[i]);
        vtkMath::Subtract(c.data(), origin.data(), c.data());
        sum += vtkMath::Determinant3x3(a.data(), b.data(), c.data());
      }
    }
    return sum;
  }

  /// Polyhedra share types among themselves, never with a linear cell of the same faces.
  std::size_t TypeNumber(const CellType& type)
  {
    const auto added = this->Polyhedra.emplace(
      std::make_pair(type.NumberOfVertices(), type.Faces()), this->Cells.Types.size());
    if (added.second)
    {
      this->Cells.Types.push_back(type);
    }
    return added.first->second;
  }

  void BeginCell(vtkIdType id, std::size_t type)
  {
    std::vector<CellRun>& runs = this->Cells.Runs;
    if (runs.empty() || runs.back().Type != type)
    {
      runs.push_back({ type, 0 });
    }
    ++runs.back().NumberOfCells;
    this->Cells.GridIds.push_back(id);
  }

  GridCells& Cells;
  vtkUnstructuredGrid* Grid;
  bool ByVolume;
  vtkNew<vtkGenericCell> Generic;
  vtkNew<vtkIdList> PointBuffer;
  vtkNew<vtkIdList> StreamBuffer;
  static constexpr std::size_t None = static_cast<std::size_t>(-1);
  std::vector<std::size_t> LinearNumbers = std::vector<std::size_t>(LinearCellTypes().size(), None);
  std::map<std::pair<int, FaceList>, std::size_t> Polyhedra;
};

GridCells::GridCells(
  vtkUnstructuredGrid* grid, Orientation orientation, const ProgressCallback& progress)
  : NumberOfPoints(grid->GetNumberOfPoints())
{
  Builder builder(*this, grid, orientation);
  const vtkIdType count = grid->GetNumberOfCells();
  this->GridIds.reserve(static_cast<std::size_t>(count));
  if (count > 0)
  {
    this->Vertices.reserve(
      static_cast<std::size_t>(grid->GetCells()->GetNumberOfConnectivityIds()));
  }
  constexpr vtkIdType CellsPerReport = 1 << 16;
  for (vtkIdType id = 0; id < count; ++id)
  {
    if (id % CellsPerReport == 0)
    {
      Report(progress, static_cast<double>(id) / static_cast<double>(count));
    }
    builder.Add(id);
  }
}

CellList GridCells::List() const
{
  return { this->NumberOfPoints, this->Types, this->Runs,
    { this->Vertices.data(), this->Vertices.size() } };
}

std::string GridCells::Remark() const
{
  std::string remark;
  if (this->Simplified > 0)
  {
    remark += std::to_string(this->Simplified) +
      " cells of higher order are represented by their corner points only. ";
  }
  if (this->DroppedCells > 0)
  {
    remark += std::to_string(this->DroppedCells) +
      " cells that are points, lines or surfaces are dropped: only volume cells are used here. ";
  }
  return remark + this->Inverted.Message();
}

}
