#include "Core/InputOverlap.h"

#include "Core/ArrayMemory.h"
#include "Core/Index.h"
#include "Core/NumberText.h"
#include "Core/ParallelFor.h"

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkDemandDrivenPipeline.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleVectorKey.h>
#include <vtkInformationStringKey.h>
#include <vtkMolecule.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace isthmus
{
namespace
{

constexpr double GrownBy = 0.1;       // of the larger box's diagonal
constexpr int NodesAlongAnAxis = 16;  // of an image that are sampled
constexpr double SameRatio = 0.05;    // off 10
constexpr std::int64_t Grain = 16384; // number of points or cells in a piece of parallel work
constexpr double NanometreInAngstrom = 10.0;

/// Nodes of an image, at most NodesAlongAnAxis along each axis.
vtkSmartPointer<vtkPoints> CollectNodes(vtkImageData* image)
{
  auto nodes = vtkSmartPointer<vtkPoints>::New();
  nodes->SetDataTypeToDouble();
  int extent[6];
  image->GetExtent(extent);
  int count[3];
  for (int a = 0; a < 3; ++a)
  {
    count[a] = std::min(extent[2 * a + 1] - extent[2 * a] + 1, NodesAlongAnAxis);
    if (count[a] < 1)
    {
      return nodes;
    }
  }
  SizePoints(nodes, static_cast<vtkIdType>(count[0]) * count[1] * count[2]);
  vtkIdType node = 0;
  for (int k = 0; k < count[2]; ++k)
  {
    for (int j = 0; j < count[1]; ++j)
    {
      for (int i = 0; i < count[0]; ++i)
      {
        const int at[3] = { i, j, k };
        double index[3];
        for (int a = 0; a < 3; ++a)
        {
          const double part = count[a] > 1 ? at[a] / (count[a] - 1.0) : 0.0;
          index[a] = extent[2 * a] + part * (extent[2 * a + 1] - extent[2 * a]);
        }
        Point3 p;
        image->TransformContinuousIndexToPhysicalPoint(index, p.data());
        nodes->SetPoint(node++, p.data());
      }
    }
  }
  return nodes;
}

/// Marks of points, which threads may set concurrently.
using Marks = std::vector<std::atomic<bool>>;

void MarkCorners(vtkCellArray* cells, Marks& marks)
{
  ParallelFor(0, cells->GetNumberOfCells(), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      vtkNew<vtkIdList> copied; // for ids of 32 bits
      for (vtkIdType cell = first; cell < last; ++cell)
      {
        vtkIdType corners = 0;
        const vtkIdType* ids = nullptr;
        cells->GetCellAtId(cell, corners, ids, copied);
        for (vtkIdType i = 0; i < corners; ++i)
        {
          if (const auto id = static_cast<std::size_t>(ids[i]); id < marks.size())
          {
            marks[id].store(true, std::memory_order_relaxed);
          }
        }
      }
    });
}

/// Number and box of some points.
struct PointCount
{
  std::int64_t Points = 0;
  Bounds3 Box{ Point3{ HUGE_VAL, HUGE_VAL, HUGE_VAL }, Point3{ -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };

  PointCount& operator+=(const PointCount& other)
  {
    if (other.Points > 0)
    {
      this->Points += other.Points;
      this->Box.Add(other.Box.Min);
      this->Box.Add(other.Box.Max);
    }
    return *this;
  }
};

/// The points of an input that count.
class Places
{
public:
  explicit Places(vtkDataObject* data)
  {
    if (auto* const image = vtkImageData::SafeDownCast(data))
    {
      this->Points = CollectNodes(image);
    }
    else if (auto* const molecule = vtkMolecule::SafeDownCast(data))
    {
      this->Points = molecule->GetNumberOfAtoms() > 0 ? molecule->GetPoints() : nullptr;
    }
    else if (auto* const set = vtkPointSet::SafeDownCast(data))
    {
      this->Points = set->GetPoints();
      if (auto* const surface = vtkPolyData::SafeDownCast(set);
          surface && this->Points && surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0)
      {
        this->Used = Marks(static_cast<std::size_t>(this->Points->GetNumberOfPoints()));
        MarkCorners(surface->GetPolys(), this->Used);
        MarkCorners(surface->GetStrips(), this->Used);
      }
    }
    this->All = this->Count([](const Point3&) { return true; });
  }

  bool IsEmpty() const { return this->All.Points == 0; }
  const Bounds3& Box() const { return this->All.Box; }

  /// Share of the points within `box`, which is enlarged first.
  double ShareWithin(Bounds3 box) const
  {
    const double more = GrownBy * box.Diagonal();
    for (std::size_t a = 0; a < 3; ++a)
    {
      box.Min[a] -= more;
      box.Max[a] += more;
    }
    if (box.Contains(this->All.Box))
    {
      return 1.0;
    }
    const PointCount within = this->Count(
      [&box](const Point3& p) {
        return box.Contains({ p, p });
      });
    return static_cast<double>(within.Points) / static_cast<double>(this->All.Points);
  }

private:
  template <typename Counts>
  PointCount Count(const Counts& counts) const
  {
    const std::int64_t points = this->Points ? this->Points->GetNumberOfPoints() : 0;
    return ParallelReduce(points, Grain, PointCount{},
      [&](PointCount& sum, std::int64_t first, std::int64_t last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          if (!this->Used.empty() && !this->Used[At(i)].load(std::memory_order_relaxed))
          {
            continue;
          }
          Point3 p;
          this->Points->GetPoint(i, p.data());
          if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) && counts(p))
          {
            ++sum.Points;
            sum.Box.Add(p);
          }
        }
      });
  }

  vtkSmartPointer<vtkPoints> Points;
  Marks Used; ///< corners of polygons and strips; empty: all points count
  PointCount All;
};

std::string Text(const Bounds3& box)
{
  const auto place = [](const Point3& p) {
    return "(" + FormatNumber(p[0]) + ", " + FormatNumber(p[1]) + ", " + FormatNumber(p[2]) + ")";
  };
  return place(box.Min) + " to " + place(box.Max);
}

/// The rule of each port: three numbers, from port 1 on.
vtkInformationDoubleVectorKey* Rules()
{
  static auto* const key = vtkInformationDoubleVectorKey::MakeKey("OVERLAP_RULES", "isthmus");
  return key;
}

vtkInformationStringKey* LastWarning()
{
  static auto* const key = vtkInformationStringKey::MakeKey("LAST_OVERLAP", "isthmus");
  return key;
}

OverlapRule ReadRule(vtkAlgorithm* self, int port)
{
  vtkInformation* const info = self->GetInformation();
  const int first = 3 * (port - 1);
  if (Rules()->Length(info) < first + 3)
  {
    return {};
  }
  const double* const rule = Rules()->Get(info) + first;
  return { rule[0], rule[1], rule[2] != 0.0 };
}

bool IsPiece(vtkAlgorithm* self)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int port = 0; port < self->GetNumberOfOutputPorts(); ++port)
  {
    vtkInformation* const info = self->GetOutputInformation(port);
    if (info && info->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) &&
      info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1)
    {
      return true;
    }
  }
  return false;
}

}

bool InputOverlap::IsOfOtherUnit() const
{
  const auto isNear = [this](double ratio)
  { return std::abs(this->Ratio - ratio) <= SameRatio * ratio; };
  return isNear(NanometreInAngstrom) || isNear(1.0 / NanometreInAngstrom);
}

std::optional<InputOverlap> MeasureOverlap(vtkDataObject* first, vtkDataObject* second)
{
  const Places one(first);
  const Places other(second);
  if (one.IsEmpty() || other.IsEmpty())
  {
    return {};
  }
  InputOverlap overlap;
  overlap.First = one.Box();
  overlap.Second = other.Box();
  const double size = overlap.First.Diagonal();
  const double otherSize = overlap.Second.Diagonal();
  overlap.Share =
    size < otherSize ? one.ShareWithin(overlap.Second) : other.ShareWithin(overlap.First);
  overlap.Ratio = size > 0.0 ? otherSize / size : 0.0;
  return overlap;
}

void SetOverlapRule(vtkAlgorithm* self, int port, const OverlapRule& rule)
{
  vtkInformation* const info = self->GetInformation();
  std::vector<double> rules;
  for (int p = 1; p < std::max(self->GetNumberOfInputPorts(), port + 1); ++p)
  {
    const OverlapRule known = p == port ? rule : ReadRule(self, p);
    rules.insert(rules.end(), { known.Refused, known.Warned, known.Units ? 1.0 : 0.0 });
  }
  Rules()->Set(info, rules.data(), static_cast<int>(rules.size()));
}

void CheckOverlap(vtkAlgorithm* self)
{
  if (self->GetNumberOfInputPorts() < 2 || self->GetNumberOfInputConnections(0) < 1 ||
    IsPiece(self))
  {
    return;
  }
  std::string warnings;
  for (int port = 1; port < self->GetNumberOfInputPorts(); ++port)
  {
    const OverlapRule rule = ReadRule(self, port);
    for (int i = 0; i < self->GetNumberOfInputConnections(port); ++i)
    {
      const auto overlap =
        MeasureOverlap(self->GetInputDataObject(0, 0), self->GetInputDataObject(port, i));
      if (!overlap)
      {
        continue;
      }
      const std::string name = "input " + std::to_string(port);
      const std::string boxes = " (input 0 from " + Text(overlap->First) + ", " + name + " from " +
        Text(overlap->Second) + ")";
      const bool unit = rule.Units && overlap->IsOfOtherUnit();
      const std::string units = unit
        ? " One is " + FormatNumber(std::max(overlap->Ratio, 1.0 / overlap->Ratio), 3) +
          " times as large as the other: is one in angstrom, the other in nanometres? Scale it "
          "first (Transform)."
        : "";
      if (overlap->Share <= rule.Refused)
      {
        throw std::invalid_argument(JoinText("Inputs 0 and ", port, " do not overlap", boxes,
          ": give data of the same molecule in the same place and unit of length.", units));
      }
      if (overlap->Share < rule.Warned)
      {
        warnings += JoinText("Only ", FormatNumber(100.0 * overlap->Share, 2),
          " % of the smaller of the inputs 0 and ", port, " lie within the other", boxes,
          ": are both of the same molecule, in the same place and unit of length?", units);
      }
      else if (unit)
      {
        warnings += JoinText("Inputs 0 and ", port, " differ in size", boxes, ".", units);
      }
    }
  }
  if (warnings.empty())
  {
    return;
  }
  auto* const executive = vtkDemandDrivenPipeline::SafeDownCast(self->GetExecutive());
  const vtkMTimeType changed =
    std::max(self->GetMTime(), executive ? executive->GetPipelineMTime() : 0);
  const std::string words = std::to_string(changed) + ' ' + warnings;
  const char* const last = LastWarning()->Get(self->GetInformation());
  if (!last || words != last)
  {
    LastWarning()->Set(self->GetInformation(), words);
    vtkWarningWithObjectMacro(self, << warnings);
  }
}

}
