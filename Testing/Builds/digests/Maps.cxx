// Filters of volumes: diffusion, levels, curvature, persistence.

#include "Cases.h"
#include "vtkDelaunayIsosurface.h"
#include "vtkDenoiseFromHalfMaps.h"
#include "vtkDenoiseMap.h"
#include "vtkDiffusionHighPass.h"
#include "vtkDualContouring.h"
#include "vtkFullereneStability.h"
#include "vtkHessianCurvature.h"
#include "vtkHighOrderDiffusion.h"
#include "vtkMapHandles.h"
#include "vtkMapSurface.h"
#include "vtkMolecularDensity.h"
#include "vtkPDETransform.h"
#include "vtkScalarPersistence.h"

#include <vtkAlgorithm.h>
#include <vtkAlgorithmOutput.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

namespace isthmus::digests
{

namespace
{

void AddImaging(Cases& cases)
{
  AddCase<vtkDenoiseFromHalfMaps>(cases, "",
    [](vtkDenoiseFromHalfMaps* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Map());
      filter->SetOtherHalfConnection(inputs.OtherMap());
    });
  AddCase<vtkDiffusionHighPass>(cases, "",
    [](vtkDiffusionHighPass* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Map());
      filter->GetOutputArraySelection()->EnableAllArrays();
    });
  AddCase<vtkDenoiseMap>(cases, "",
    [](vtkDenoiseMap* filter, Inputs& inputs) { filter->SetInputConnection(inputs.Map()); });
  AddCase<vtkDenoiseMap>(cases, "volumes",
    [](vtkDenoiseMap* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Map());
      filter->SetGoal(vtkDenoiseMap::Volumes);
      filter->SetStrength(0.8);
    });
  AddCase<vtkHighOrderDiffusion>(cases, "geometric flow",
    [](vtkHighOrderDiffusion* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Map());
      filter->SetFlow(vtkHighOrderDiffusion::GeometricFlow);
      filter->SetResidualSmoothing(2.0);
      filter->SetTime(1.0);
    });
  AddCase<vtkHighOrderDiffusion>(cases, "equation",
    [](vtkHighOrderDiffusion* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Map());
      filter->SetTime(1.0);
    });
  AddCase<vtkHighOrderDiffusion>(cases, "equation of order 4",
    [](vtkHighOrderDiffusion* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Map());
      filter->SetTime(1.0);
      filter->SetOrder(1);
      filter->SetEdgeStopping(vtkHighOrderDiffusion::LocalVariance);
      filter->SetPreSmoothing(1.0);
      filter->SetFidelity(0.1);
    });
  AddCase<vtkPDETransform>(cases, "",
    [](vtkPDETransform* filter, Inputs& inputs) { filter->SetInputConnection(inputs.Map()); });
}

void AddContouring(Cases& cases)
{
  AddCase<vtkDelaunayIsosurface>(cases, "",
    [](vtkDelaunayIsosurface* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Distance());
      filter->SetLevel(0.0);
      filter->InsideIsHigherOff();
    });
  AddCase<vtkDualContouring>(cases, "",
    [](vtkDualContouring* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Distance());
      filter->SetLevel(0.0);
      filter->InsideIsHigherOff();
    });
  AddCase<vtkDualContouring>(cases, "surface",
    [](vtkDualContouring* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Surface());
      filter->QuadrilateralsOn();
    });
  AddCase<vtkMapSurface>(cases, "",
    [](vtkMapSurface* filter, Inputs& inputs) { filter->SetInputConnection(inputs.Map()); });
  AddCase<vtkMapSurface>(cases, "level",
    [](vtkMapSurface* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Distance());
      filter->SetLevel(0.0);
      filter->InsideIsHigherOff();
      filter->GetOutputArraySelection()->DisableArray("Normals");
      filter->SetLargestComponents(1);
    });
  AddCase<vtkMapSurface>(cases, "inverted",
    [](vtkMapSurface* filter, Inputs& inputs)
    {
      vtkAlgorithm* const map = inputs.Map()->GetProducer();
      map->Update();
      vtkNew<vtkImageData> image;
      image->DeepCopy(map->GetOutputDataObject(0));
      vtkDataArray* const values = image->GetPointData()->GetScalars();
      for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
      {
        values->SetTuple1(i, -values->GetTuple1(i));
      }
      filter->SetInputData(image);
    });
}

void AddLoops(Cases& cases)
{
  AddCase<vtkMapHandles>(cases, "",
    [](vtkMapHandles* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Map());
      filter->LoopsOn();
    });
  AddCase<vtkMapHandles>(cases, "level",
    [](vtkMapHandles* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Distance());
      filter->InsideIsHigherOff();
      filter->SetLevel(0.0);
      filter->LoopsOn();
    });
  AddCase<vtkMapHandles>(cases, "recommended level",
    [](vtkMapHandles* filter, Inputs& inputs)
    {
      vtkNew<vtkMolecularDensity> density;
      density->SetInputConnection(inputs.ChargedAtoms());
      density->SetSpacing(1.0);
      filter->SetInputConnection(density->GetOutputPort());
    });
  AddCase<vtkMapHandles>(cases, "half maps",
    [](vtkMapHandles* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Map());
      filter->SetOtherHalfConnection(inputs.OtherMap());
      filter->SetNumberOfResamples(5);
    });
}

void SetAllArrays(vtkHessianCurvature* filter)
{
  filter->GetOutputArraySelection()->EnableAllArrays();
}

void AddCurvature(Cases& cases)
{
  AddCase<vtkHessianCurvature>(cases, "",
    [](vtkHessianCurvature* filter, Inputs& inputs) { filter->SetInputConnection(inputs.Map()); });
  AddCase<vtkHessianCurvature>(cases, "no scale",
    [](vtkHessianCurvature* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Map());
      filter->AutomaticScaleOff();
      SetAllArrays(filter);
    });
  AddCase<vtkHessianCurvature>(cases, "surface",
    [](vtkHessianCurvature* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Map());
      filter->SetInputConnection(1, inputs.MapSurface());
      filter->SetAccuracy(4);
      SetAllArrays(filter);
    });
}

void AddPersistence(Cases& cases)
{
  AddCase<vtkFullereneStability>(cases, "",
    [](vtkFullereneStability* filter, Inputs& inputs)
    { filter->SetInputConnection(inputs.Fullerene()); });
  AddCase<vtkFullereneStability>(cases, "grid",
    [](vtkFullereneStability* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Fullerene());
      filter->SetMethod(vtkFullereneStability::Grid);
    });
  AddCase<vtkScalarPersistence>(cases, "",
    [](vtkScalarPersistence* filter, Inputs& inputs) { filter->SetInputConnection(inputs.Map()); });
  AddCase<vtkScalarPersistence>(cases, "largest gap",
    [](vtkScalarPersistence* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Map());
      filter->SetSuperlevel(true);
      filter->SetPersistenceUnit(vtkScalarPersistence::LargestGap);
      filter->CyclesOn();
      filter->SimplifyOn();
    });
}

}

void AddMaps(Cases& cases)
{
  AddImaging(cases);
  AddContouring(cases);
  AddLoops(cases);
  AddCurvature(cases);
  AddPersistence(cases);
}

}
