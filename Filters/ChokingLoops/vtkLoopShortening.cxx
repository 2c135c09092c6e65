#include "vtkLoopShortening.h"

#include "ChokingLoops/LoopShortening.h"
#include "ChokingLoops/SurfacePreparation.h"
#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/InputOverlap.h"
#include "Core/NamedColumns.h"
#include "Core/PolyDataTriangles.h"

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

const std::vector<isthmus::OutputArray>& vtkLoopShortening::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Cells, "Length", 1, "length", ArrayChoice::None, "of the loop" },
    { 0, ArrayPlace::Cells, "Converged", 1, "", ArrayChoice::None, "1: a geodesic" },
    { 0, ArrayPlace::Cells, "Contractible", 1, "", ArrayChoice::None,
      "1: the loop can be contracted to a point, and is returned unchanged" },
  };
  return table;
}

vtkLoopShortening::vtkLoopShortening()
{
  this->SetNumberOfInputPorts(2);
  isthmus::OverlapRule rule;
  rule.Units = false; // loops may be of any size
  isthmus::SetOverlapRule(this, 1, rule);
}

namespace
{

using isthmus::SimplexId;
using isthmus::SurfaceAdjacency;

/// Points after `from` on a shortest path of edges to `to`, by breadth-first search: neighbours on
/// the input loops are a few edges apart.
std::vector<SimplexId> PathBetween(const SurfaceAdjacency& s, SimplexId from, SimplexId to)
{
  std::map<SimplexId, SimplexId> cameFrom{ { to, to } };
  std::queue<SimplexId> queue;
  queue.push(to);
  while (!queue.empty() && cameFrom.count(from) == 0)
  {
    const SimplexId p = queue.front();
    queue.pop();
    const isthmus::HalfEdgeId first = s.Leaving(p);
    isthmus::HalfEdgeId h = first;
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
std::vector<SimplexId> WalkThrough(const SurfaceAdjacency& s, const std::vector<SimplexId>& corners)
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

/// The surface, and a search for its nearest point to a given one.
struct Surface
{
  explicit Surface(vtkPolyData* data)
    : Mesh(isthmus::CheckedSurface(isthmus::ToTriangleMesh(data), true))
    , Adjacency(Mesh)
  {
    isthmus::SetMesh(this->Mesh, this->Corners);
    this->Locator->SetDataSet(this->Corners);
    this->Locator->BuildLocator();
  }

  /// A closed polyline of `loops` as a walk along edges.
  std::vector<SimplexId> Walk(vtkPolyData* loops, vtkIdType cell) const
  {
    vtkNew<vtkIdList> ids;
    loops->GetCellPoints(cell, ids);
    std::vector<SimplexId> nearest;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      nearest.push_back(
        static_cast<SimplexId>(this->Locator->FindClosestPoint(loops->GetPoint(ids->GetId(i)))));
    }
    std::vector<SimplexId> walk;
    if (!nearest.empty())
    {
      walk = WalkThrough(this->Adjacency, nearest);
    }
    if (walk.size() < 3)
    {
      throw std::invalid_argument("Loop " + std::to_string(cell - loops->GetNumberOfVerts()) +
        " is a single point or runs back along itself, so it cannot be shortened: remove it.");
    }
    return walk;
  }

  isthmus::TriangleMesh Mesh;
  SurfaceAdjacency Adjacency;
  vtkNew<vtkPolyData> Corners;
  vtkNew<vtkStaticPointLocator> Locator;
};

/// The output under construction.
struct ShortenedLoops
{
  explicit ShortenedLoops(vtkPolyData* output)
    : Output(output)
  {
    this->Points->SetDataTypeToDouble();
  }

  void Add(const SurfaceAdjacency& surface, const isthmus::SurfaceCurve& curve)
  {
    this->Lines->InsertNextCell(static_cast<int>(curve.Crossings.size() + 1));
    const vtkIdType start = this->Points->GetNumberOfPoints();
    for (const isthmus::SurfaceCurvePoint& p : curve.Crossings)
    {
      this->Lines->InsertCellPoint(
        this->Points->InsertNextPoint(isthmus::ComputePosition(surface, p).data()));
    }
    this->Lines->InsertCellPoint(start);
    this->Lengths->InsertNextValue(curve.Length);
    this->Converged->InsertNextValue(curve.Converged);
    this->Contractible->InsertNextValue(curve.Contractible);
  }

  void Finish()
  {
    this->Output->SetPoints(this->Points);
    this->Output->SetLines(this->Lines);
    this->Output->GetCellData()->AddArray(this->Lengths);
    this->Output->GetCellData()->AddArray(this->Converged);
    this->Output->GetCellData()->AddArray(this->Contractible);
  }

  vtkPolyData* Output;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkDoubleArray> Lengths = isthmus::NamedArray<vtkDoubleArray>("Length");
  vtkNew<vtkIntArray> Converged = isthmus::NamedArray<vtkIntArray>("Converged");
  vtkNew<vtkIntArray> Contractible = isthmus::NamedArray<vtkIntArray>("Contractible");
};

}

int vtkLoopShortening::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  auto* loops = vtkPolyData::GetData(input[0]);
  auto* result = vtkPolyData::GetData(output);
  return isthmus::RunGuarded(this, output,
    [&]
    {
      isthmus::RequireFinitePositions(loops, "the loops");
      isthmus::Check(this->Parameters);
      const auto whole =
        isthmus::GatherSurface(this, vtkPolyData::GetData(input[1]), isthmus::GatherOn::EachRank);
      const vtkIdType count = loops->GetNumberOfLines();
      if (count == 0)
      {
        return;
      }
      const Surface surface(whole);
      const vtkIdType first = loops->GetNumberOfVerts();
      result->GetCellData()->CopyAllocate(loops->GetCellData());
      ShortenedLoops shortened(result);
      for (vtkIdType c = 0; c < count; ++c)
      {
        const auto done = [count](vtkIdType i)
        { return static_cast<double>(i) / static_cast<double>(count); };
        const auto progress = isthmus::Between(isthmus::MakeProgress(this), done(c), done(c + 1));
        isthmus::Report(progress, 0.0);
        shortened.Add(surface.Adjacency,
          isthmus::ShortenLoop(
            surface.Adjacency, surface.Walk(loops, first + c), this->Parameters, progress));
        result->GetCellData()->CopyData(loops->GetCellData(), first + c, c);
      }
      shortened.Finish();
    });
}

void vtkLoopShortening::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumRounds: " << this->GetMaximumRounds() << "\n";
  os << indent << "Tolerance: " << this->GetTolerance() << "\n";
}
