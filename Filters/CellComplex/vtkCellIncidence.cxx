#include "vtkCellIncidence.h"

#include "CellComplex/EdgeTable.h"
#include "CellComplex/FaceTable.h"
#include "CellComplex/GridMap.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ArrayMemory.h"
#include "Core/GatherRanks.h"
#include "Core/NamedColumns.h"
#include "Core/ParallelFor.h"

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

#include <algorithm>
#include <initializer_list>

vtkStandardNewMacro(vtkCellIncidence);

const std::vector<isthmus::OutputArray>& vtkCellIncidence::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Cells, "EdgeId", 1, "", ArrayChoice::None, "number of the edge" },
    { 0, ArrayPlace::Cells, "OnBoundary", 1, "", ArrayChoice::None,
      "1 on the boundary of the mesh" },
    { 0, ArrayPlace::Cells, "NumberOfIncidentCells", 1, "", ArrayChoice::None,
      "cells of the input with this edge" },
    { 0, ArrayPlace::Cells, "FirstIncidentCell", 1, "", ArrayChoice::None,
      "the smallest number of its cells" },
    { 1, ArrayPlace::Cells, "FaceId", 1, "", ArrayChoice::None, "number of the face" },
    { 1, ArrayPlace::Cells, "OnBoundary", 1, "", ArrayChoice::None,
      "1 on the boundary of the mesh" },
    { 1, ArrayPlace::Cells, "NumberOfIncidentCells", 1, "", ArrayChoice::None,
      "cells of the input with this face" },
    { 1, ArrayPlace::Cells, "FirstIncidentCell", 1, "", ArrayChoice::None,
      "the smaller number of its cells" },
    { 1, ArrayPlace::Cells, "SecondIncidentCell", 1, "", ArrayChoice::None,
      "the other one; -1: none, on the boundary" },
  };
  return table;
}

namespace
{

constexpr std::int64_t CellsPerPiece = 1 << 14;

/// The cells of one output, all edges or all faces, and their arrays.
struct Elements
{
  vtkNew<vtkIdTypeArray> Offsets, Connectivity;
  vtkNew<vtkIdTypeArray> Ids;
  vtkNew<vtkUnsignedCharArray> OnBoundary;
  vtkNew<vtkIdTypeArray> Count, First;

  Elements(const char* idName, std::size_t size)
    : Offsets(isthmus::NamedArray<vtkIdTypeArray>("", size + 1))
    , Ids(isthmus::NamedArray<vtkIdTypeArray>(idName, size))
    , OnBoundary(isthmus::NamedArray<vtkUnsignedCharArray>("OnBoundary", size))
    , Count(isthmus::NamedArray<vtkIdTypeArray>("NumberOfIncidentCells", size))
    , First(isthmus::NamedArray<vtkIdTypeArray>("FirstIncidentCell", size))
  {
  }

  vtkIdType Size() const { return this->Ids->GetNumberOfValues(); }

  /// Memory for the points of each element: `sizeOf(i)` of them.
  template <typename SizeOf>
  void LayOut(SizeOf&& sizeOf)
  {
    vtkIdType sum = 0;
    for (vtkIdType i = 0; i < this->Size(); ++i)
    {
      this->Offsets->SetValue(i, sum);
      sum += sizeOf(i);
    }
    this->Offsets->SetValue(this->Size(), sum);
    isthmus::SizeArray(this->Connectivity, sum);
  }

  vtkIdType* GetElementPoints(vtkIdType i)
  {
    return this->Connectivity->GetPointer(this->Offsets->GetValue(i));
  }

  void Set(vtkIdType i, bool onBoundary, vtkIdType count, vtkIdType first)
  {
    this->Ids->SetValue(i, i);
    this->OnBoundary->SetValue(i, onBoundary ? 1 : 0);
    this->Count->SetValue(i, count);
    this->First->SetValue(i, first);
  }

  /// The output's points and data; the caller places the returned cells as lines or polygons.
  vtkNew<vtkCellArray> MoveTo(vtkPolyData* output, vtkUnstructuredGrid* input, bool passCellData)
  {
    output->SetPoints(input->GetPoints());
    output->GetPointData()->PassData(input->GetPointData());
    output->GetFieldData()->PassData(input->GetFieldData());
    vtkCellData* data = output->GetCellData();
    if (passCellData)
    {
      vtkNew<vtkIdList> from;
      from->SetNumberOfIds(this->Size());
      std::copy_n(this->First->GetPointer(0), this->Size(), from->GetPointer(0));
      data->CopyGlobalIdsOff(); // the global id of a cell is not valid for its faces
      data->CopyAllocate(input->GetCellData(), this->Size());
      data->CopyData(input->GetCellData(), from, vtkIdType(0));
    }
    for (vtkDataArray* array :
      std::initializer_list<vtkDataArray*>{ this->Ids, this->OnBoundary, this->Count, this->First })
    {
      data->AddArray(array);
    }
    vtkNew<vtkCellArray> cells;
    cells->SetData(this->Offsets, this->Connectivity);
    return cells;
  }
};

template <typename Map>
void FillEdges(const Map& map, const isthmus::GridCells& cells, Elements& lines,
  const isthmus::ProgressCallback& progress)
{
  const auto& edges = map.Edges();
  lines.LayOut([](vtkIdType) { return 2; });
  isthmus::ParallelFor(
    0, lines.Size(), CellsPerPiece,
    [&](std::int64_t first, std::int64_t last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const typename Map::Edge edge(static_cast<typename Map::IdType>(i));
        const auto ends = map.EndVertices(edges.GetDart(edge));
        lines.GetElementPoints(i)[0] = static_cast<vtkIdType>(ends.first.Value);
        lines.GetElementPoints(i)[1] = static_cast<vtkIdType>(ends.second.Value);
        vtkIdType count = 0;
        typename Map::Cell smallest = map.GetCell(edges.GetDart(edge));
        for (const auto dart : edges.Fan(edge))
        {
          smallest = std::min(smallest, map.GetCell(dart));
          ++count;
        }
        lines.Set(i, edges.IsBoundary(edge), count, cells.GridId(smallest.Value));
      }
    },
    progress);
}

template <typename Map>
void FillFaces(const Map& map, const isthmus::GridCells& cells, Elements& polygons,
  vtkIdTypeArray* second, const isthmus::ProgressCallback& progress)
{
  const auto& faces = map.Faces();
  const auto halfFaceOf = [&](vtkIdType i)
  { return faces.GetHalfFace(typename Map::Face(static_cast<typename Map::IdType>(i))); };
  polygons.LayOut(
    [&](vtkIdType i) { return static_cast<vtkIdType>(map.Darts(halfFaceOf(i)).size()); });
  isthmus::ParallelFor(
    0, polygons.Size(), CellsPerPiece,
    [&](std::int64_t first, std::int64_t last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        vtkIdType* point = polygons.GetElementPoints(i);
        for (const auto dart : map.Darts(halfFaceOf(i)))
        {
          *point++ = static_cast<vtkIdType>(map.StartVertex(dart).Value);
        }
        const auto across = map.Across(halfFaceOf(i));
        const bool boundary = map.IsOutside(across);
        polygons.Set(i, boundary, boundary ? 1 : 2, cells.GridId(map.GetCell(halfFaceOf(i)).Value));
        second->SetValue(i, boundary ? -1 : cells.GridId(map.GetCell(across).Value));
      }
    },
    progress);
}

}

vtkCellIncidence::vtkCellIncidence()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkCellIncidence::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkCellIncidence::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkPolyData* edges = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* faces = vtkPolyData::GetData(outputVector, 1);
  const isthmus::ProgressCallback progress = isthmus::MakeProgress(this);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      isthmus::RequireOneRank(this, input, "cells");
      isthmus::RequireFinitePositions(input, "the cells");
      isthmus::WithMap(input, isthmus::Between(progress, 0.0, 0.5),
        [&](const auto& map, const isthmus::GridCells& cells)
        {
          if (!cells.Remark().empty())
          {
            vtkWarningMacro(<< cells.Remark());
          }
          Elements lines("EdgeId", map.Edges(isthmus::Between(progress, 0.5, 0.65)).Size());
          FillEdges(map, cells, lines, isthmus::Between(progress, 0.65, 0.75));
          Elements polygons("FaceId", map.Faces(isthmus::Between(progress, 0.75, 0.9)).Size());
          const auto second =
            isthmus::NamedArray<vtkIdTypeArray>("SecondIncidentCell", map.Faces().Size());
          FillFaces(map, cells, polygons, second, isthmus::Between(progress, 0.9, 1.0));
          edges->SetLines(lines.MoveTo(edges, input, this->PassCellData));
          faces->SetPolys(polygons.MoveTo(faces, input, this->PassCellData));
          faces->GetCellData()->AddArray(second);
        });
    });
}

void vtkCellIncidence::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PassCellData: " << this->PassCellData << "\n";
}
