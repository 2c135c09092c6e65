#include "Core/InputOverlap.h"

#include "Core/NumberText.h"

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
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace isthmus
{
namespace
{

constexpr double GrownBy = 0.1;      // of the larger box's diagonal
constexpr int NodesAlongAnAxis = 16; // of an image that are looked at
constexpr double SameRatio = 0.05;   // off 10
constexpr double NanometreInAngstrom = 10.0;

void AddPoint(const Point3& p, std::vector<Point3>& places)
{
  if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))
  {
    places.push_back(p);
  }
}

void AddImage(vtkImageData* image, std::vector<Point3>& places)
{
  int extent[6];
  image->GetExtent(extent);
  int count[3];
  for (int a = 0; a < 3; ++a)
  {
    count[a] = std::min(extent[2 * a + 1] - extent[2 * a] + 1, NodesAlongAnAxis);
    if (count[a] < 1)
    {
      return;
    }
  }
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
        AddPoint(p, places);
      }
    }
  }
}

/// Whether a point counts: those of polygons and strips where there are any.
std::vector<bool> PointsOfPolygons(vtkPolyData* surface)
{
  const bool has = surface && surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0;
  std::vector<bool> used(static_cast<std::size_t>(has ? surface->GetNumberOfPoints() : 0));
  vtkNew<vtkIdList> ids;
  for (vtkCellArray* cells :
    { has ? surface->GetPolys() : nullptr, has ? surface->GetStrips() : nullptr })
  {
    for (vtkIdType cell = 0; cells && cell < cells->GetNumberOfCells(); ++cell)
    {
      cells->GetCellAtId(cell, ids);
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        const auto id = static_cast<std::size_t>(ids->GetId(i));
        if (id < used.size())
        {
          used[id] = true;
        }
      }
    }
  }
  return used;
}

std::vector<Point3> PlacesOf(vtkDataObject* data)
{
  std::vector<Point3> places;
  if (auto* const image = vtkImageData::SafeDownCast(data))
  {
    AddImage(image, places);
  }
  else if (auto* const molecule = vtkMolecule::SafeDownCast(data))
  {
    for (vtkIdType atom = 0; atom < molecule->GetNumberOfAtoms(); ++atom)
    {
      Point3 p;
      molecule->GetPoint(atom, p.data());
      AddPoint(p, places);
    }
  }
  else if (auto* const set = vtkPointSet::SafeDownCast(data))
  {
    const std::vector<bool> used = PointsOfPolygons(vtkPolyData::SafeDownCast(data));
    for (vtkIdType i = 0; i < set->GetNumberOfPoints(); ++i)
    {
      if (used.empty() || used[static_cast<std::size_t>(i)])
      {
        Point3 p;
        set->GetPoint(i, p.data());
        AddPoint(p, places);
      }
    }
  }
  return places;
}

Bounds3 BoxOf(const std::vector<Point3>& places)
{
  Bounds3 box{ places.front(), places.front() };
  for (const Point3& p : places)
  {
    box.Add(p);
  }
  return box;
}

double ShareWithin(const std::vector<Point3>& places, Bounds3 box)
{
  const double more = GrownBy * box.Diagonal();
  for (std::size_t a = 0; a < 3; ++a)
  {
    box.Min[a] -= more;
    box.Max[a] += more;
  }
  const auto within = std::count_if(places.begin(), places.end(),
    [&box](const Point3& p) {
      return box.Contains({ p, p });
    });
  return static_cast<double>(within) / static_cast<double>(places.size());
}

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

OverlapRule RuleOf(vtkAlgorithm* self, int port)
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

std::optional<InputOverlap> OverlapOf(vtkDataObject* first, vtkDataObject* second)
{
  const std::vector<Point3> one = PlacesOf(first);
  const std::vector<Point3> other = PlacesOf(second);
  if (one.empty() || other.empty())
  {
    return {};
  }
  InputOverlap overlap;
  overlap.First = BoxOf(one);
  overlap.Second = BoxOf(other);
  const double size = overlap.First.Diagonal();
  const double otherSize = overlap.Second.Diagonal();
  overlap.Share =
    size < otherSize ? ShareWithin(one, overlap.Second) : ShareWithin(other, overlap.First);
  overlap.Ratio = size > 0.0 ? otherSize / size : 0.0;
  return overlap;
}

void SetOverlapRule(vtkAlgorithm* self, int port, const OverlapRule& rule)
{
  vtkInformation* const info = self->GetInformation();
  std::vector<double> rules;
  for (int p = 1; p < std::max(self->GetNumberOfInputPorts(), port + 1); ++p)
  {
    const OverlapRule known = p == port ? rule : RuleOf(self, p);
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
    const OverlapRule rule = RuleOf(self, port);
    for (int i = 0; i < self->GetNumberOfInputConnections(port); ++i)
    {
      const auto overlap =
        OverlapOf(self->GetInputDataObject(0, 0), self->GetInputDataObject(port, i));
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
        throw std::invalid_argument(TextOf("Inputs 0 and ", port, " do not overlap", boxes,
          ": give data of the same molecule in the same place and unit of length.", units));
      }
      if (overlap->Share < rule.Warned)
      {
        warnings += TextOf("Only ", FormatNumber(100.0 * overlap->Share, 2),
          " % of the smaller of the inputs 0 and ", port, " lie within the other", boxes,
          ": are both of the same molecule, in the same place and unit of length?", units);
      }
      else if (unit)
      {
        warnings += TextOf("Inputs 0 and ", port, " differ in size", boxes, ".", units);
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
