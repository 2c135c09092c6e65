// Filters of surfaces and volume meshes.

#include "Cases.h"
#include "vtkAreaQuantiles.h"
#include "vtkCellIncidence.h"
#include "vtkChokingLoops.h"
#include "vtkCombinatorialMap.h"
#include "vtkHandleFilling.h"
#include "vtkIsosurfaceStuffing.h"
#include "vtkLoopShortening.h"
#include "vtkMeshQualityReport.h"
#include "vtkOffsetSurface.h"
#include "vtkScalarRegions.h"
#include "vtkSurfaceCurvature.h"
#include "vtkSurfaceMeasures.h"
#include "vtkSurfaceRemesh.h"
#include "vtkSurfaceToGrid.h"
#include "vtkTetCutaway.h"
#include "vtkTetrahedralMesher.h"

#include <vtkAlgorithm.h>
#include <vtkAlgorithmOutput.h>
#include <vtkCellArray.h>
#include <vtkDataObject.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkTrivialProducer.h>
#include <vtkUnstructuredGrid.h>

namespace isthmus::digests
{

namespace
{

void AddLoops(Cases& cases)
{
  AddCase<vtkChokingLoops>(cases, "",
    [](vtkChokingLoops* filter, Inputs& inputs) { filter->SetInputConnection(inputs.Surface()); });
  AddCase<vtkChokingLoops>(cases, "greedy membranes",
    [](vtkChokingLoops* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.SmallSurface());
      filter->SetMembraneMethod(vtkChokingLoops::Greedy);
      filter->SetThresholdMode(vtkChokingLoops::LargestGap);
    });
  AddCase<vtkChokingLoops>(cases, "tetrahedra",
    [](vtkChokingLoops* filter, Inputs& inputs)
    {
      RequireProgram("tetgen");
      filter->SetInputConnection(inputs.SmallSurface());
      filter->SetFiltration(vtkChokingLoops::TetrahedralMesh);
      filter->SetMorseFunction(vtkChokingLoops::FastMarching);
    });
  AddCase<vtkChokingLoops>(cases, "repaired",
    [](vtkChokingLoops* filter, Inputs& inputs)
    {
      vtkAlgorithm* const producer = inputs.SmallSurface()->GetProducer();
      producer->Update();
      vtkNew<vtkPolyData> surface;
      surface->DeepCopy(producer->GetOutputDataObject(0));
      vtkNew<vtkIdList> corners;
      surface->GetCellPoints(0, corners);
      const vtkIdType there[] = { corners->GetId(0), corners->GetId(1), corners->GetId(2) };
      const vtkIdType back[] = { there[0], there[2], there[1] };
      surface->GetPolys()->InsertNextCell(3, there); // a triangle twice, once turned around
      surface->GetPolys()->InsertNextCell(3, back);
      filter->SetInputData(surface);
    });
  AddCase<vtkHandleFilling>(cases, "",
    [](vtkHandleFilling* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.SmallSurface());
      filter->SetFillHandlesBelow(1e3);
    });
  AddCase<vtkLoopShortening>(cases, "",
    [](vtkLoopShortening* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Loops());
      filter->SetSurfaceConnection(inputs.Surface());
    });
  AddCase<vtkOffsetSurface>(cases, "",
    [](vtkOffsetSurface* filter, Inputs& inputs)
    { filter->SetInputConnection(inputs.SmallSurface()); });
}

void AddSurfaces(Cases& cases)
{
  AddCase<vtkAreaQuantiles>(cases, "",
    [](vtkAreaQuantiles* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.PotentialSurface());
      filter->SetInputArrayToProcess(
        0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "MeanCurvature");
    });
  AddCase<vtkScalarRegions>(cases, "",
    [](vtkScalarRegions* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.PotentialSurface());
      filter->SetInputArrayToProcess(
        0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "MeanCurvature");
      filter->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Potential");
      filter->UseSecondScalarOn();
      filter->SetSweepSteps(4);
    });
  AddCase<vtkSurfaceCurvature>(cases, "",
    [](vtkSurfaceCurvature* filter, Inputs& inputs)
    { filter->SetInputConnection(inputs.Surface()); });
  AddCase<vtkSurfaceCurvature>(cases, "edge tensor",
    [](vtkSurfaceCurvature* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Surface());
      filter->SetMethod(vtkSurfaceCurvature::EdgeTensor);
      filter->GetOutputArraySelection()->EnableAllArrays();
    });
  AddCase<vtkSurfaceMeasures>(cases, "",
    [](vtkSurfaceMeasures* filter, Inputs& inputs)
    { filter->SetInputConnection(inputs.Surface()); });
  AddCase<vtkSurfaceMeasures>(cases, "image",
    [](vtkSurfaceMeasures* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Distance());
      filter->SetInputArrayToProcess(
        0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "SignedDistance");
      filter->SetLevel(0.0);
      filter->InsideIsHigherOff();
      filter->SetInsideValue(-1.0);
      filter->SetOutsideValue(1.0);
    });
  AddCase<vtkSurfaceRemesh>(cases, "",
    [](vtkSurfaceRemesh* filter, Inputs& inputs)
    { filter->SetInputConnection(inputs.PotentialSurface()); });
  AddCase<vtkSurfaceRemesh>(cases, "Delaunay",
    [](vtkSurfaceRemesh* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.SmallSurface());
      filter->SetMethod(vtkSurfaceRemesh::Delaunay);
    });
  AddCase<vtkSurfaceToGrid>(cases, "",
    [](vtkSurfaceToGrid* filter, Inputs& inputs) { filter->SetInputConnection(inputs.Surface()); });
  AddCase<vtkSurfaceToGrid>(cases, "image",
    [](vtkSurfaceToGrid* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Map());
      filter->SetLevel(1.0);
    });
}

/// A table of what queries of a map return for a mesh.
vtkSmartPointer<vtkAlgorithm> QueriesOfMap(Inputs& inputs)
{
  vtkAlgorithmOutput* const mesh = inputs.MixedCells();
  mesh->GetProducer()->Update();
  vtkNew<vtkCombinatorialMap> map;
  map->SetMesh(
    vtkUnstructuredGrid::SafeDownCast(mesh->GetProducer()->GetOutputDataObject(mesh->GetIndex())));
  vtkNew<vtkTable> table;
  const auto name = [](const std::string& query, vtkIdTypeArray* ids, vtkFieldData* data)
  {
    ids->SetName(query.c_str());
    data->AddArray(ids);
  };
  for (const int from : { vtkCombinatorialMap::Vertex, vtkCombinatorialMap::Edge,
         vtkCombinatorialMap::Face, vtkCombinatorialMap::Cell, vtkCombinatorialMap::HalfFace })
  {
    vtkNew<vtkIdTypeArray> offsets, ids;
    map->GetIncidence(from, vtkCombinatorialMap::Cell, offsets, ids);
    name("Offsets" + std::to_string(from), offsets, table->GetFieldData());
    name("Cells" + std::to_string(from), ids, table->GetFieldData());
  }
  for (const int dimension : { 1, 2, 3 })
  {
    vtkNew<vtkIdTypeArray> darts;
    map->GetBeta(dimension, darts);
    name("Beta" + std::to_string(dimension), darts, table->GetRowData());
  }
  auto producer = vtkSmartPointer<vtkTrivialProducer>::New();
  producer->SetOutput(table);
  return producer;
}

void AddVolumes(Cases& cases)
{
  AddCase<vtkCellIncidence>(cases, "",
    [](vtkCellIncidence* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Cells());
      filter->PassCellDataOn();
    });
  AddCase<vtkCellIncidence>(cases, "mixed",
    [](vtkCellIncidence* filter, Inputs& inputs)
    { filter->SetInputConnection(inputs.MixedCells()); });
  AddCase<vtkCellIncidence>(cases, "polyhedra",
    [](vtkCellIncidence* filter, Inputs& inputs)
    { filter->SetInputConnection(inputs.Polyhedra()); });
  cases.push_back({ "vtkCombinatorialMap", "", QueriesOfMap });
  AddCase<vtkIsosurfaceStuffing>(cases, "",
    [](vtkIsosurfaceStuffing* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Distance());
      filter->SetLevel(0.0);
      filter->InsideIsHigherOff();
    });
  AddCase<vtkMeshQualityReport>(cases, "",
    [](vtkMeshQualityReport* filter, Inputs& inputs)
    { filter->SetInputConnection(inputs.Surface()); });
  AddCase<vtkMeshQualityReport>(cases, "tetrahedra",
    [](vtkMeshQualityReport* filter, Inputs& inputs)
    {
      vtkNew<vtkIsosurfaceStuffing> stuffing;
      stuffing->SetInputConnection(inputs.Distance());
      stuffing->SetLevel(0.0);
      stuffing->InsideIsHigherOff();
      filter->SetInputConnection(stuffing->GetOutputPort());
    });
  AddCase<vtkTetCutaway>(cases, "",
    [](vtkTetCutaway* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Cells());
      filter->SetNumberOfCells(50);
    });
  AddCase<vtkTetrahedralMesher>(cases, "CGAL",
    [](vtkTetrahedralMesher* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.SmallSurface());
      filter->SetLibrary(vtkTetrahedralMesher::CGAL);
    });
  AddCase<vtkTetrahedralMesher>(cases, "",
    [](vtkTetrahedralMesher* filter, Inputs& inputs)
    {
      RequireProgram("tetgen");
      filter->SetInputConnection(inputs.SmallSurface());
    });
  AddCase<vtkTetrahedralMesher>(cases, "repaired",
    [](vtkTetrahedralMesher* filter, Inputs& inputs)
    {
      vtkAlgorithm* const producer = inputs.SmallSurface()->GetProducer();
      producer->Update();
      vtkNew<vtkPolyData> surface;
      surface->DeepCopy(producer->GetOutputDataObject(0));
      surface->BuildCells();
      surface->DeleteCell(0);
      surface->RemoveDeletedCells();
      filter->SetInputData(surface);
      filter->SetLibrary(vtkTetrahedralMesher::CGAL);
      filter->RepairOn();
    });
  AddCase<vtkTetrahedralMesher>(cases, "TetGen, both sides",
    [](vtkTetrahedralMesher* filter, Inputs& inputs)
    {
      RequireProgram("tetgen");
      filter->SetInputConnection(inputs.SmallSurface());
      filter->SetLibrary(vtkTetrahedralMesher::TetGen);
      filter->SetSide(vtkTetrahedralMesher::Both);
    });
}

}

void AddMeshes(Cases& cases)
{
  AddLoops(cases);
  AddSurfaces(cases);
  AddVolumes(cases);
}

}
