#include "ChokingLoopsOutput.h"

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

/// d - sqrt(d^2 - e^2) bounds how far the samples are from what the surface would give.
double UncertaintyOf(const ShapeFeature& f)
{
  const double d = f.Distance();
  return d - std::sqrt(std::max(0.0, d * d - f.Error * f.Error));
}

/// Points of a feature in an output, each inserted once.
class PointMap
{
public:
  PointMap(const LoopFeature& geometry, const TriangleMesh& samples, vtkPoints* points)
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
  const TriangleMesh& Samples;
  vtkPoints* Points;
  std::map<SimplexId, vtkIdType> Ids;
};

vtkSmartPointer<vtkPoints> DoublePoints()
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  return points;
}

}

void FillLoops(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output)
{
  const vtkSmartPointer<vtkPoints> points = DoublePoints();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkStringArray> names;
  names->SetName("KindName");
  Columns<vtkIntArray> integers;
  Columns<vtkDoubleArray> numbers;
  for (const ShownFeature& shown : features)
  {
    const ShapeFeature& f = loops.Diagram().Features[shown.Index];
    PointMap map(*shown.Geometry, loops.Samples(), points);
    for (std::size_t k = 0; k < shown.Geometry->Loops.size(); ++k)
    {
      const auto& loop = shown.Geometry->Loops[k];
      lines->InsertNextCell(static_cast<int>(loop.size() + 1));
      for (std::size_t i = 0; i <= loop.size(); ++i)
      {
        lines->InsertCellPoint(map.Of(loop[i % loop.size()]));
      }
      const SimplexId anchor = loops.MembraneOfMade(shown.Index).Loops[k].front();
      names->InsertNextValue(NameOf(f.Kind));
      integers["Kind"]->InsertNextValue(static_cast<int>(f.Kind));
      integers["Side"]->InsertNextValue(static_cast<int>(f.Side));
      integers["Trusted"]->InsertNextValue(f.Trusted);
      integers["FeatureId"]->InsertNextValue(static_cast<int>(shown.Index));
      integers["Component"]->InsertNextValue(loops.Homology().ComponentOf(anchor));
      numbers["Distance"]->InsertNextValue(f.Distance());
      numbers["Death"]->InsertNextValue(f.Fill);
      numbers["Persistence"]->InsertNextValue(f.Widening());
      numbers["Uncertainty"]->InsertNextValue(UncertaintyOf(f));
      numbers["Length"]->InsertNextValue(shown.Geometry->Lengths[k]);
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  integers.AddTo(output->GetCellData());
  numbers.AddTo(output->GetCellData());
  output->GetCellData()->AddArray(names);
  output->GetCellData()->SetActiveScalars("Distance");
}

void FillMembranes(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output)
{
  const vtkSmartPointer<vtkPoints> points = DoublePoints();
  vtkNew<vtkCellArray> triangles;
  Columns<vtkIntArray> integers;
  Columns<vtkDoubleArray> numbers;
  for (const ShownFeature& shown : features)
  {
    const ShapeFeature& f = loops.Diagram().Features[shown.Index];
    PointMap map(*shown.Geometry, loops.Samples(), points);
    for (const auto& t : shown.Geometry->Membrane)
    {
      triangles->InsertNextCell({ map.Of(t[0]), map.Of(t[1]), map.Of(t[2]) });
      integers["FeatureId"]->InsertNextValue(static_cast<int>(shown.Index));
      integers["Kind"]->InsertNextValue(static_cast<int>(f.Kind));
      numbers["Area"]->InsertNextValue(shown.Geometry->Area);
      numbers["Distance"]->InsertNextValue(f.Distance());
    }
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  integers.AddTo(output->GetCellData());
  numbers.AddTo(output->GetCellData());
}

void FillChokePoints(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output)
{
  const vtkSmartPointer<vtkPoints> points = DoublePoints();
  vtkNew<vtkCellArray> vertices;
  Columns<vtkIntArray> integers;
  Columns<vtkDoubleArray> numbers;
  for (const ShownFeature& shown : features)
  {
    const ShapeFeature& f = loops.Diagram().Features[shown.Index];
    vertices->InsertNextCell({ points->InsertNextPoint(loops.ChokePoint(shown.Index).data()) });
    integers["FeatureId"]->InsertNextValue(static_cast<int>(shown.Index));
    integers["Kind"]->InsertNextValue(static_cast<int>(f.Kind));
    integers["Side"]->InsertNextValue(static_cast<int>(f.Side));
    numbers["Radius"]->InsertNextValue(f.Distance());
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  integers.AddTo(output->GetPointData());
  numbers.AddTo(output->GetPointData());
  output->GetPointData()->SetActiveScalars("Radius");
}

void FillDiagram(const ChokingLoops& loops, vtkTable* output)
{
  Columns<vtkIntArray> integers;
  Columns<vtkDoubleArray> numbers;
  for (const ShapeFeature& f : loops.Diagram().Features)
  {
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
  const ChokingLoopTimes& t = loops.Times();
  for (const double seconds : { t.Check, t.Sampling, t.Filtration, t.Pairing, t.Features })
  {
    numbers["StageTimes"]->InsertNextValue(seconds);
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
