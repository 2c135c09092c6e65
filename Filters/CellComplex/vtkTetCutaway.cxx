#include "vtkTetCutaway.h"

#include "CellComplex/FaceTable.h"
#include "CellComplex/GridMap.h"
#include "CellComplex/TetCutaway.h"
#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Core/RangeChecks.h"
#include "Core/View.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkTetCutaway);

const std::vector<isthmus::OutputArray>& vtkTetCutaway::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Cells, "Exposed", 1, "", ArrayChoice::None,
      "0 on the boundary of the mesh, 1 on a face that was inside" },
    { 0, ArrayPlace::Cells, "OriginalCellIds", 1, "", ArrayChoice::None,
      "cell of the input that the face bounds" },
    { 1, ArrayPlace::Cells, "OriginalCellIds", 1, "", ArrayChoice::None, "cell of the input" },
  };
  return table;
}

namespace
{

/// Mean of the positions of `count` vertices.
template <typename VertexAt>
isthmus::Position Center(vtkUnstructuredGrid* grid, std::size_t count, VertexAt&& vertexAt)
{
  isthmus::Position sum{ 0, 0, 0 };
  for (std::size_t v = 0; v < count; ++v)
  {
    double position[3];
    grid->GetPoint(static_cast<vtkIdType>(vertexAt(v).Value), position);
    for (std::size_t i = 0; i < 3; ++i)
    {
      sum[i] += position[i] / static_cast<double>(count);
    }
  }
  return sum;
}

/// The cell of the boundary face whose center is nearest to `point`.
template <typename Map>
typename Map::Cell CellNearest(const Map& map, vtkUnstructuredGrid* grid, const double* point)
{
  typename Map::Cell nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < map.NumberOfBoundaryFaces(); ++b)
  {
    const auto dart = map.GetDart(typename Map::BoundaryFace(static_cast<typename Map::IdType>(b)));
    const auto darts = map.Darts(map.GetHalfFace(dart));
    const isthmus::Position center =
      Center(grid, darts.size(), [&](std::size_t v) { return map.StartVertex(darts[v]); });
    const double squared = (center[0] - point[0]) * (center[0] - point[0]) +
      (center[1] - point[1]) * (center[1] - point[1]) +
      (center[2] - point[2]) * (center[2] - point[2]);
    if (squared < least)
    {
      least = squared;
      nearest = map.GetCell(dart);
    }
  }
  return nearest;
}

/// The cell of a numbered face.
template <typename Map>
typename Map::Cell CellOfFace(const Map& map, vtkIdType face)
{
  isthmus::RequireRange("SeedFace", static_cast<double>(face), 0.0,
    static_cast<double>(map.NumberOfFaces()) - 1.0, "These are the faces of the mesh.");
  return map.GetCell(
    map.Faces().GetDart(typename Map::Face(static_cast<typename Map::IdType>(face))));
}

/// The remaining cells of `input`, and their surface.
class Remainder
{
public:
  Remainder(vtkUnstructuredGrid* input, const std::vector<unsigned char>& gone)
    : Input(input)
    , Gone(gone)
  {
  }

  template <typename Map>
  void WriteSurface(const Map& map, const isthmus::GridCells& cells, vtkPolyData* output) const
  {
    vtkNew<vtkCellArray> polygons;
    const auto exposed = isthmus::NamedArray<vtkUnsignedCharArray>("Exposed");
    vtkNew<vtkIdList> owners, points;
    for (std::size_t c = 0; c < this->Gone.size(); ++c)
    {
      const typename Map::Cell cell(static_cast<typename Map::IdType>(c));
      for (unsigned f = 0; !this->Gone[c] && f < map.Neighbours(cell).size(); ++f)
      {
        const auto across = map.Neighbours(cell)[f];
        const bool boundary = map.IsOutside(across);
        if (boundary || this->Gone[map.GetCell(across).Value])
        {
          points->Reset();
          for (const auto dart : map.Darts(map.MakeHalfFace(cell, f)))
          {
            points->InsertNextId(static_cast<vtkIdType>(map.StartVertex(dart).Value));
          }
          polygons->InsertNextCell(points);
          exposed->InsertNextValue(boundary ? 0 : 1);
          owners->InsertNextId(cells.GridId(c));
        }
      }
    }
    output->SetPolys(polygons);
    this->PassData(output, owners);
    output->GetCellData()->AddArray(exposed);
    output->GetCellData()->SetActiveScalars(
      "Exposed"); // otherwise regions, of which there may be just one
  }

  void WriteCells(const isthmus::GridCells& cells, vtkUnstructuredGrid* output) const
  {
    output->Allocate(cells.NumberOfCells());
    vtkNew<vtkIdList> owners, points;
    for (std::size_t c = 0; c < this->Gone.size(); ++c)
    {
      if (this->Gone[c])
      {
        continue;
      }
      const vtkIdType id = cells.GridId(c);
      const int type = this->Input->GetCellType(id);
      if (type == VTK_POLYHEDRON)
      {
        this->Input->GetFaceStream(
          id, points); // starting with the number of faces, as for insertion
      }
      else
      {
        this->Input->GetCellPoints(id, points);
      }
      output->InsertNextCell(type, points);
      owners->InsertNextId(id);
    }
    this->PassData(output, owners);
  }

private:
  void PassData(vtkPointSet* output, vtkIdList* owners) const
  {
    output->SetPoints(this->Input->GetPoints());
    output->GetPointData()->PassData(this->Input->GetPointData());
    output->GetFieldData()->PassData(this->Input->GetFieldData());
    vtkCellData* data = output->GetCellData();
    data->CopyGlobalIdsOff();
    data->CopyAllocate(this->Input->GetCellData(), owners->GetNumberOfIds());
    data->CopyData(this->Input->GetCellData(), owners, vtkIdType(0));
    const isthmus::View<vtkIdType> ids(
      owners->GetPointer(0), static_cast<std::size_t>(owners->GetNumberOfIds()));
    isthmus::AddColumn<vtkIdTypeArray>(data, "OriginalCellIds", ids);
  }

  vtkUnstructuredGrid* Input;
  const std::vector<unsigned char>& Gone;
};

}

vtkTetCutaway::vtkTetCutaway()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkTetCutaway::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkTetCutaway::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkUnstructuredGrid");
  return 1;
}

int vtkTetCutaway::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkPolyData* surface = vtkPolyData::GetData(outputVector, 0);
  vtkUnstructuredGrid* remaining = vtkUnstructuredGrid::GetData(outputVector, 1);
  const isthmus::ProgressCallback progress = isthmus::MakeProgress(this);
  const auto cut = [&](const auto& map, const isthmus::GridCells& cells)
  {
    if (!cells.Remark().empty())
    {
      vtkWarningMacro(<< cells.Remark());
    }
    if (cells.NumberOfCells() == 0)
    {
      return;
    }
    const auto seed = this->SeedMode == AtPoint ? CellNearest(map, input, this->SeedPoint)
                                                : CellOfFace(map, this->SeedFace);
    const auto centerOf = [&](std::size_t cell)
    {
      const auto vertices = map.Vertices(std::decay_t<decltype(seed)>(
        static_cast<typename std::decay_t<decltype(map)>::IdType>(cell)));
      return Center(input, vertices.size(), [&](std::size_t v) { return vertices[v]; });
    };
    const std::vector<unsigned char> gone =
      isthmus::CutAway(map, seed, this->Parameters, centerOf, isthmus::Between(progress, 0.6, 0.8));
    if (!gone[seed.Value] && this->GetStopRule() == ByPlane)
    {
      vtkWarningMacro(
        "Nothing is removed: the seed cell lies on the side of the plane that is kept. "
        "Move the seed or reverse PlaneNormal.");
    }
    const Remainder remainder(input, gone);
    remainder.WriteSurface(map, cells, surface);
    isthmus::Report(progress, 0.9);
    remainder.WriteCells(cells, remaining);
  };
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      isthmus::RequireOneRank(this, input, "cells");
      isthmus::RequireFinitePositions(input, "the cells");
      isthmus::Check(this->Parameters);
      isthmus::RequireChoice<int>("SeedMode", this->SeedMode, AtFace);
      for (const double coordinate : this->SeedPoint)
      {
        isthmus::RequireRange("SeedPoint", coordinate, -isthmus::Unlimited, isthmus::Unlimited);
      }
      isthmus::WithMap(input, isthmus::Between(progress, 0.0, 0.6), cut);
    });
}

void vtkTetCutaway::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto text = [](const double* v)
  {
    return isthmus::FormatNumber(v[0]) + " " + isthmus::FormatNumber(v[1]) + " " +
      isthmus::FormatNumber(v[2]);
  };
  os << indent << "SeedMode: " << this->SeedMode << "\n";
  os << indent << "SeedPoint: " << text(this->SeedPoint) << "\n";
  os << indent << "SeedFace: " << this->SeedFace << "\n";
  os << indent << "StopRule: " << this->GetStopRule() << "\n";
  os << indent << "NumberOfCells: " << this->Parameters.NumberOfCells << "\n";
  os << indent << "Distance: " << this->Parameters.Distance << "\n";
  os << indent << "PlaneOrigin: " << text(this->Parameters.PlaneOrigin.data()) << "\n";
  os << indent << "PlaneNormal: " << text(this->Parameters.PlaneNormal.data()) << "\n";
}
