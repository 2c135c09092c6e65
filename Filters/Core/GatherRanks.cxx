#include "Core/GatherRanks.h"
#include "Core/ArrayMemory.h"

#include "Core/InnerAlgorithm.h"

#include <vtkAlgorithm.h>
#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommunicator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdList.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace isthmus
{
namespace
{

vtkSmartPointer<vtkPolyData> RemoveGhosts(vtkPolyData* piece)
{
  if (!piece->GetCellGhostArray() && !piece->GetPointGhostArray())
  {
    return piece;
  }
  auto own = vtkSmartPointer<vtkPolyData>::New();
  own->DeepCopy(piece); // its cells are changed in place
  own->RemoveGhostCells();
  own->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  own->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  return own;
}

/// For each point the lowest id of those at the same place.
std::vector<vtkIdType> FindFirstCoincident(vtkPolyData* surface)
{
  const auto count = static_cast<std::size_t>(surface->GetNumberOfPoints());
  std::vector<std::array<double, 3>> places(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    surface->GetPoint(static_cast<vtkIdType>(i), places[i].data());
    for (double& x : places[i])
    {
      x += 0.0; // -0 becomes 0
    }
  }
  // By their bytes, so that NaN is ordered as well.
  const auto compare = [&places](vtkIdType a, vtkIdType b)
  {
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bytes are meant
    return std::memcmp(places[static_cast<std::size_t>(a)].data(),
      places[static_cast<std::size_t>(b)].data(), sizeof(double[3]));
  };
  std::vector<vtkIdType> order(count);
  std::iota(order.begin(), order.end(), vtkIdType{ 0 });
  std::sort(order.begin(), order.end(),
    [&compare](vtkIdType a, vtkIdType b)
    {
      const int difference = compare(a, b);
      return difference != 0 ? difference < 0 : a < b;
    });
  std::vector<vtkIdType> first(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool same = i > 0 && compare(order[i - 1], order[i]) == 0;
    first[static_cast<std::size_t>(order[i])] =
      same ? first[static_cast<std::size_t>(order[i - 1])] : order[i];
  }
  return first;
}

vtkSmartPointer<vtkCellArray> RenumberCells(vtkCellArray* cells, const std::vector<vtkIdType>& id)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  ReserveCells(result, cells->GetNumberOfCells(), cells->GetNumberOfConnectivityIds());
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
  {
    cells->GetCellAtId(c, corners);
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    {
      corners->SetId(k, id[static_cast<std::size_t>(corners->GetId(k))]);
    }
    result->InsertNextCell(corners);
  }
  return result;
}

/// One point for each position. Ranks cut a surface along edges, whose end points each of them has.
vtkSmartPointer<vtkPolyData> MergeCoincidentPoints(vtkPolyData* surface)
{
  std::vector<vtkIdType> id = FindFirstCoincident(surface);
  vtkNew<vtkIdList> kept;
  for (std::size_t i = 0; i < id.size(); ++i)
  {
    const bool isFirst = id[i] == static_cast<vtkIdType>(i);
    id[i] = isFirst ? kept->InsertNextId(id[i]) : id[static_cast<std::size_t>(id[i])];
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints() ? surface->GetPoints()->GetDataType() : VTK_DOUBLE);
  SizePoints(points, kept->GetNumberOfIds());
  result->GetPointData()->CopyAllOn();
  result->GetPointData()->CopyAllocate(surface->GetPointData(), kept->GetNumberOfIds());
  for (vtkIdType i = 0; i < kept->GetNumberOfIds(); ++i)
  {
    points->SetPoint(i, surface->GetPoint(kept->GetId(i)));
    result->GetPointData()->CopyData(surface->GetPointData(), kept->GetId(i), i);
  }
  result->SetPoints(points);
  result->SetVerts(RenumberCells(surface->GetVerts(), id));
  result->SetLines(RenumberCells(surface->GetLines(), id));
  result->SetPolys(RenumberCells(surface->GetPolys(), id));
  result->SetStrips(RenumberCells(surface->GetStrips(), id));
  result->GetCellData()->ShallowCopy(surface->GetCellData());
  result->GetFieldData()->ShallowCopy(surface->GetFieldData());
  return result;
}

}

int NumberOfRanks()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return controller ? controller->GetNumberOfProcesses() : 1;
}

bool OnFirstRank()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return !controller || controller->GetLocalProcessId() == 0;
}

void RequireNoBlocks(vtkAlgorithm* filter)
{
  if (NumberOfRanks() == 1)
  {
    return;
  }
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < filter->GetNumberOfInputConnections(port); ++i)
    {
      // While blocks are processed one by one, the algorithm right before the filter has the block;
      // the one before ParaView's post filter, which it inserts between any two, has all of them.
      int output = 0;
      vtkAlgorithm* before = filter->GetInputAlgorithm(port, i, output);
      vtkDataObject* data = before && before->IsA("vtkPVPostFilter")
        ? before->GetInputDataObject(0, 0)
        : filter->GetInputDataObject(port, i);
      if (vtkCompositeDataSet::SafeDownCast(data))
      {
        throw std::runtime_error("Blocks on several ranks cannot be merged here, since a rank may "
                                 "lack some: run Merge Blocks first, or use one rank.");
      }
    }
  }
}

int RanksWithPoints(vtkDataObject* data)
{
  const bool any = data &&
    (data->GetNumberOfElements(vtkDataObject::POINT) > 0 ||
      data->GetNumberOfElements(vtkDataObject::VERTEX) > 0);
  const int own = any ? 1 : 0;
  if (NumberOfRanks() == 1)
  {
    return own;
  }
  int ranks = 0;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    &own, &ranks, 1, vtkCommunicator::SUM_OP);
  return ranks;
}

void RejectSeveralRanks(int ranks, const std::string& what)
{
  if (ranks > 1)
  {
    throw std::runtime_error("The " + what + " lie on " + std::to_string(ranks) +
      " ranks, and all are needed on one: read them with a reader that loads them on one rank, or "
      "run on one rank.");
  }
}

void RequireOneRank(vtkAlgorithm* filter, vtkDataObject* piece, const std::string& what)
{
  RequireNoBlocks(filter);
  RejectSeveralRanks(RanksWithPoints(piece), what);
}

vtkSmartPointer<vtkPolyData> GatherSurface(vtkAlgorithm* filter, vtkPolyData* piece, GatherOn where)
{
  if (!piece)
  {
    return piece;
  }
  vtkSmartPointer<vtkPolyData> own = RemoveGhosts(piece);
  if (NumberOfRanks() == 1)
  {
    return own;
  }
  RequireNoBlocks(filter);
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  std::vector<vtkSmartPointer<vtkDataObject>> pieces;
  controller->Gather(own, pieces, 0);
  auto whole = vtkSmartPointer<vtkPolyData>::New();
  if (controller->GetLocalProcessId() == 0)
  {
    vtkNew<vtkAppendPolyData> append;
    for (vtkDataObject* one : pieces)
    {
      auto* part = vtkPolyData::SafeDownCast(one);
      if (part && part->GetNumberOfPoints() > 0)
      {
        append->AddInputData(part);
      }
    }
    if (append->GetNumberOfInputConnections(0) > 0)
    {
      UpdateInner(append);
      whole = MergeCoincidentPoints(append->GetOutput());
    }
  }
  if (where == GatherOn::EachRank)
  {
    controller->Broadcast(whole, 0);
  }
  return whole;
}

}
