#include "ChokingLoops/ChokingLoopsOutput.h"

#include "ChokingLoops/ChokeFit.h"
#include "ChokingLoops/LoopLimits.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <cmath>
#include <map>

namespace isthmus
{
namespace
{

/// Named columns of one kind, appended to any attributes when complete.
template <typename Array>
class Columns
{
public:
  Array* operator[](const char* name)
  {
    vtkSmartPointer<Array>& column = this->Known[name];
    if (!column)
    {
      column = vtkSmartPointer<Array>::New();
      column->SetName(name);
    }
    return column;
  }

  template <typename Attributes>
  void AddTo(Attributes* attributes) const
  {
    for (const auto& entry : this->Known)
    {
      attributes->AddArray(entry.second);
    }
  }

private:
  std::map<std::string, vtkSmartPointer<Array>> Known;
};

const char* NameOf(FeatureKind kind)
{
  switch (kind)
  {
    case FeatureKind::Handle:
      return "handle";
    case FeatureKind::Tunnel:
      return "tunnel";
    case FeatureKind::Additional:
      return "additional";
    default:
      return "noise";
  }
}

/// What an output says of its features: a row for each of its cells or points.
struct FeatureRows
{
  Columns<vtkIntArray> Integers;
  Columns<vtkDoubleArray> Numbers;

  /// What all outputs have.
  void Add(const ShownFeature& shown, const ShapeFeature& f)
  {
    this->Integers["FeatureId"]->InsertNextValue(static_cast<int>(shown.Index));
    this->Integers["Kind"]->InsertNextValue(static_cast<int>(f.Kind));
    this->Numbers["Radius"]->InsertNextValue(f.Distance());
  }
  void AddSide(const ShapeFeature& f)
  {
    this->Integers["Side"]->InsertNextValue(static_cast<int>(f.Side));
  }
  /// The radius by the name that it had before; goes with 2.0.
  void AddDistance(const ShapeFeature& f)
  {
    this->Numbers["Distance"]->InsertNextValue(f.Distance());
  }
  /// Fill and widening, and the same by the names that they had before; these go with 2.0.
  void AddSizes(const ShapeFeature& f)
  {
    for (const char* name : { "Fill", "Death" })
    {
      this->Numbers[name]->InsertNextValue(f.Fill);
    }
    for (const char* name : { "Widening", "Persistence" })
    {
      this->Numbers[name]->InsertNextValue(f.Widening());
    }
  }

  template <typename Attributes>
  void AddTo(Attributes* attributes) const
  {
    this->Integers.AddTo(attributes);
    this->Numbers.AddTo(attributes);
  }
};

/// Points of a feature in an output, each inserted once.
class PointMap
{
public:
  PointMap(const LoopFeature& geometry, const SurfaceView& samples, vtkPoints* points)
    : Geometry(geometry)
    , Samples(samples)
    , Points(points)
  {
  }

  vtkIdType Of(SimplexId id)
  {
    const auto known = this->Ids.find(id);
    if (known != this->Ids.end())
    {
      return known->second;
    }
    return this->Ids[id] =
             this->Points->InsertNextPoint(this->Geometry.Point(id, this->Samples).data());
  }

private:
  const LoopFeature& Geometry;
  SurfaceView Samples;
  vtkPoints* Points;
  std::map<SimplexId, vtkIdType> Ids;
};

vtkSmartPointer<vtkPoints> DoublePoints()
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  return points;
}

/// The cells of one feature's loops.
using Cells = std::vector<std::vector<vtkIdType>>;

Cells InsertLoops(const ShownFeature& shown, const SurfaceView& samples, vtkPoints* points)
{
  PointMap map(*shown.Geometry, samples, points);
  Cells cells;
  for (const auto& loop : shown.Geometry->Loops)
  {
    cells.emplace_back();
    for (std::size_t i = 0; i <= loop.size(); ++i)
    {
      cells.back().push_back(map.Of(loop[i % loop.size()]));
    }
  }
  return cells;
}

}

void FillLoops(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output)
{
  const vtkSmartPointer<vtkPoints> points = DoublePoints();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkStringArray> names;
  names->SetName("KindName");
  FeatureRows rows;
  std::map<const LoopFeature*, Cells> drawn;
  for (const ShownFeature& shown : features)
  {
    const ShapeFeature& f = loops.Diagram().Features[shown.Index];
    const auto [known, isNew] = drawn.emplace(shown.Geometry, Cells{});
    if (isNew)
    {
      known->second = InsertLoops(shown, loops.Samples(), points);
    }
    const Cells& cells = known->second;
    const double reach = ReachOf(loops, shown);
    for (std::size_t k = 0; k < cells.size(); ++k)
    {
      lines->InsertNextCell(static_cast<vtkIdType>(cells[k].size()), cells[k].data());
      const SimplexId anchor = shown.Geometry->Anchors[k];
      names->InsertNextValue(NameOf(f.Kind));
      rows.Add(shown, f);
      rows.AddSide(f);
      rows.AddDistance(f);
      rows.AddSizes(f);
      rows.Integers["Trusted"]->InsertNextValue(f.Trusted);
      rows.Integers["SharedWith"]->InsertNextValue(static_cast<int>(shown.SharedWith));
      rows.Integers["Component"]->InsertNextValue(loops.Homology().ComponentOf(anchor));
      rows.Numbers["Uncertainty"]->InsertNextValue(UncertaintyOf(f));
      rows.Numbers["Length"]->InsertNextValue(shown.Geometry->Lengths[k]);
      rows.Numbers["Reach"]->InsertNextValue(reach);
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  rows.AddTo(output->GetCellData());
  output->GetCellData()->AddArray(names);
  output->GetCellData()->SetActiveScalars("Radius");
}

void FillMembranes(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output)
{
  const vtkSmartPointer<vtkPoints> points = DoublePoints();
  vtkNew<vtkCellArray> triangles;
  FeatureRows rows;
  for (const ShownFeature& shown : features)
  {
    const ShapeFeature& f = loops.Diagram().Features[shown.Index];
    PointMap map(*shown.Geometry, loops.Samples(), points);
    for (const auto& t : shown.Geometry->Membrane)
    {
      triangles->InsertNextCell({ map.Of(t[0]), map.Of(t[1]), map.Of(t[2]) });
      rows.Add(shown, f);
      rows.AddDistance(f);
      rows.Numbers["Area"]->InsertNextValue(shown.Geometry->Area);
    }
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  rows.AddTo(output->GetCellData());
}

void FillChokePoints(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output)
{
  const vtkSmartPointer<vtkPoints> points = DoublePoints();
  vtkNew<vtkCellArray> vertices;
  FeatureRows rows;
  for (const ShownFeature& shown : features)
  {
    const ShapeFeature& f = loops.Diagram().Features[shown.Index];
    vertices->InsertNextCell({ points->InsertNextPoint(loops.ChokePoint(shown.Index).data()) });
    rows.Add(shown, f);
    rows.AddSide(f);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  rows.AddTo(output->GetPointData());
  output->GetPointData()->SetActiveScalars("Radius");
}

void FillDiagram(const ChokingLoops& loops, vtkTable* output)
{
  Columns<vtkIntArray> integers;
  Columns<vtkDoubleArray> numbers;
  const std::vector<ShapeFeature>& features = loops.Diagram().Features;
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    const ShapeFeature& f = features[i];
    integers["FeatureId"]->InsertNextValue(static_cast<int>(i));
    integers["Dimension"]->InsertNextValue(f.Dimension);
    integers["Side"]->InsertNextValue(static_cast<int>(f.Side));
    integers["Kind"]->InsertNextValue(static_cast<int>(f.Kind));
    numbers["Birth"]->InsertNextValue(f.Birth);
    numbers["Death"]->InsertNextValue(f.Death);
    numbers["Persistence"]->InsertNextValue(f.Persistence());
  }
  integers.AddTo(output->GetRowData());
  numbers.AddTo(output->GetRowData());
}

void FillFacts(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output)
{
  Columns<vtkDoubleArray> numbers;
  Columns<vtkIdTypeArray> counts;
  std::array<vtkIdType, 4> shown{ 0, 0, 0, 0 }; // handles, tunnels, additional inside and outside
  for (const ShownFeature& s : features)
  {
    const ShapeFeature& f = loops.Diagram().Features[s.Index];
    const auto kind = static_cast<std::size_t>(f.Kind);
    ++shown[kind < 2 ? kind : 2 + static_cast<std::size_t>(f.Side)];
  }
  counts["NumberOfSamples"]->InsertNextValue(static_cast<vtkIdType>(loops.Samples().Points.size()));
  counts["NumberOfHandles"]->InsertNextValue(shown[0]);
  counts["NumberOfTunnels"]->InsertNextValue(shown[1]);
  counts["NumberOfAdditionalLoops"]->InsertNextValue(shown[2]);
  counts["NumberOfAdditionalLoops"]->InsertNextValue(shown[3]);
  numbers["LargestSamplingError"]->InsertNextValue(loops.LargestError());
  for (const double reference : loops.Diagram().Reference)
  {
    numbers["ReferenceLength"]->InsertNextValue(reference);
  }
  numbers["ProposedThreshold"]->SetNumberOfComponents(2);
  numbers["ProposedThreshold"]->SetComponentName(0, "Threshold");
  numbers["ProposedThreshold"]->SetComponentName(1, "Width");
  for (const SpaceSide side : { SpaceSide::Inside, SpaceSide::Outside })
  {
    const PersistenceGap gap = LargestGap(loops.Diagram(), side);
    numbers["ProposedThreshold"]->InsertNextTuple2(gap.Threshold, gap.Width);
  }
  const SurfaceMending& mended = loops.Mended();
  if (!mended.Told.empty())
  {
    counts["Repaired"]->InsertNextValue(mended.Changed);
    vtkNew<vtkDoubleArray> places;
    places->SetName("RepairedPlaces");
    places->SetNumberOfComponents(3);
    for (const Point3& p : mended.Places)
    {
      places->InsertNextTuple(p.data());
    }
    output->GetFieldData()->AddArray(places);
  }
  counts.AddTo(output->GetFieldData());
  numbers.AddTo(output->GetFieldData());
}

}
