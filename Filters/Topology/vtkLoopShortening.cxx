#include "vtkLoopShortening.h"

#include "AlgorithmGuard.h"
#include "ChokingSurface.h"
#include "LoopShortening.h"
#include "PolyDataMesh.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStaticPointLocator.h>

#include <map>
#include <queue>
#include <stdexcept>

vtkStandardNewMacro(vtkLoopShortening);

namespace
{

using isthmus::SimplexId;
using isthmus::SurfaceAdjacency;

/// Points after `from` on a shortest path of edges to `to`, by breadth first search: neighbours on
/// the loops given are a few edges apart.
std::vector<SimplexId> PathBetween(const SurfaceAdjacency& s, SimplexId from, SimplexId to)
{
  std::map<SimplexId, SimplexId> cameFrom{ { to, to } };
  std::queue<SimplexId> queue;
  queue.push(to);
  while (!queue.empty() && cameFrom.count(from) == 0)
  {
    const SimplexId p = queue.front();
    queue.pop();
    const SimplexId first = s.Leaving(p);
    SimplexId h = first;
    do
    {
      if (cameFrom.emplace(s.To(h), p).second)
      {
        queue.push(s.To(h));
      }
      h = s.Turn(h);
    } while (h != first);
  }
  std::vector<SimplexId> path;
  if (cameFrom.count(from) == 0)
  {
    throw std::invalid_argument("A loop has points on two parts of the surface.");
  }
  for (SimplexId p = from; p != to; p = cameFrom[p])
  {
    path.push_back(cameFrom[p]);
  }
  return path;
}

/// A polyline as a closed walk along edges, without steps there and back.
std::vector<SimplexId> WalkOf(const SurfaceAdjacency& s, const std::vector<SimplexId>& corners)
{
  std::vector<SimplexId> walk;
  const auto push = [&walk](SimplexId p)
  {
    if (walk.size() >= 2 && walk[walk.size() - 2] == p)
    {
      walk.pop_back();
    }
    else if (walk.empty() || walk.back() != p)
    {
      walk.push_back(p);
    }
  };
  push(corners.front());
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    for (const SimplexId p : PathBetween(s, corners[i], corners[(i + 1) % corners.size()]))
    {
      push(p);
    }
  }
  while (walk.size() > 1 && walk.front() == walk.back())
  {
    walk.pop_back();
  }
  while (walk.size() > 2 && walk[1] == walk.back())
  {
    walk.erase(walk.begin());
    walk.pop_back();
  }
  return walk;
}

}

int vtkLoopShortening::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  auto* loops = vtkPolyData::GetData(input[0]);
  auto* surface = vtkPolyData::GetData(input[1]);
  auto* result = vtkPolyData::GetData(output);
  if (loops->GetNumberOfLines() == 0)
  {
    return 1;
  }
  return isthmus::Guarded(this, result,
    [&]
    {
      const isthmus::TriangleMesh mesh = isthmus::CheckedSurface(isthmus::MeshOf(surface), true);
      const SurfaceAdjacency adjacency(mesh);
      vtkNew<vtkPolyData> corners;
      isthmus::SetMesh(mesh, corners);
      vtkNew<vtkStaticPointLocator> locator;
      locator->SetDataSet(corners);
      locator->BuildLocator();
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      vtkNew<vtkCellArray> lines;
      vtkNew<vtkDoubleArray> lengths;
      lengths->SetName("Length");
      vtkNew<vtkIntArray> converged;
      converged->SetName("Converged");
      vtkNew<vtkIntArray> contractible;
      contractible->SetName("Contractible");
      isthmus::LoopShorteningParameters parameters;
      parameters.MaximumRounds = this->MaximumRounds;
      parameters.Tolerance = this->Tolerance;
      const vtkIdType first = loops->GetNumberOfVerts();
      result->GetCellData()->CopyAllocate(loops->GetCellData());
      vtkNew<vtkIdList> ids;
      const isthmus::ProgressCallback progress = isthmus::ProgressOf(this);
      for (vtkIdType c = 0; c < loops->GetNumberOfLines(); ++c)
      {
        isthmus::Report(
          progress, static_cast<double>(c) / static_cast<double>(loops->GetNumberOfLines()));
        loops->GetCellPoints(first + c, ids);
        std::vector<SimplexId> nearest;
        for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
        {
          nearest.push_back(
            static_cast<SimplexId>(locator->FindClosestPoint(loops->GetPoint(ids->GetId(i)))));
        }
        const std::vector<SimplexId> walk = WalkOf(adjacency, nearest);
        if (walk.size() < 3)
        {
          throw std::invalid_argument("Loop " + std::to_string(c) +
            " is a point or a path there and back: it encloses nothing to shorten.");
        }
        const isthmus::SurfaceCurve curve = isthmus::ShortenLoop(adjacency, walk, parameters);
        lines->InsertNextCell(static_cast<int>(curve.Crossings.size() + 1));
        const vtkIdType start = points->GetNumberOfPoints();
        for (const isthmus::SurfaceCurvePoint& p : curve.Crossings)
        {
          lines->InsertCellPoint(points->InsertNextPoint(isthmus::PositionOf(adjacency, p).data()));
        }
        lines->InsertCellPoint(start);
        result->GetCellData()->CopyData(loops->GetCellData(), first + c, c);
        lengths->InsertNextValue(curve.Length);
        converged->InsertNextValue(curve.Converged);
        contractible->InsertNextValue(curve.Contractible);
      }
      result->SetPoints(points);
      result->SetLines(lines);
      result->GetCellData()->AddArray(lengths);
      result->GetCellData()->AddArray(converged);
      result->GetCellData()->AddArray(contractible);
    });
}

void vtkLoopShortening::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumRounds: " << this->MaximumRounds << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}
