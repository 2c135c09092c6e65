#include "Solvation/SolvationOutput.h"

#include "Atoms/MoleculeAtoms.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Electrostatics/PoissonBoltzmannOutput.h"
#include "Electrostatics/SoluteVolume.h"
#include "MolecularSurfaces/FlowSurfaceOutput.h"

#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

namespace isthmus
{
namespace
{

struct Column
{
  const char* Name;
  double (*Value)(const SolvationUpdate&);
};

constexpr Column Columns[] = {
  { "Time", [](const SolvationUpdate& u) { return u.Time; } },
  { "Area", [](const SolvationUpdate& u) { return u.Area; } },
  { "Volume", [](const SolvationUpdate& u) { return u.Volume; } },
  { "SurfaceEnergy", [](const SolvationUpdate& u) { return u.SurfaceEnergy; } },
  { "VolumeEnergy", [](const SolvationUpdate& u) { return u.VolumeEnergy; } },
  { "DispersionEnergy", [](const SolvationUpdate& u) { return u.DispersionEnergy; } },
  { "NonpolarEnergy", [](const SolvationUpdate& u) { return u.Nonpolar(); } },
  { "PolarEnergy", [](const SolvationUpdate& u) { return u.PolarEnergy; } },
  { "TotalEnergy", [](const SolvationUpdate& u) { return u.Total(); } },
  { "OnObstacle", [](const SolvationUpdate& u) { return u.OnObstacle; } },
};

void FillTable(const std::vector<SolvationUpdate>& updates, vtkTable* table)
{
  vtkFieldData* const data = table->GetRowData();
  AddComputedColumn<vtkDoubleArray>(
    data, "Update", updates.size(), [](std::size_t row) { return row + 1; });
  for (const Column& column : Columns)
  {
    AddComputedColumn<vtkDoubleArray>(data, column.Name, updates, column.Value);
  }
}

}

void FillSolvation(const SolvationFlow& flow, const SolvationErrors& errors,
  const std::vector<std::string>& notes, const SolvationOutputs& outputs,
  const ProgressCallback& progress)
{
  vtkNew<vtkImageData> image;
  FillImage(flow.GetSurface(), 0.0, image);
  vtkNew<vtkPolyData> triangles;
  ContourImage(image, false, 0.5, 0.0, triangles);
  SoluteVolume volume;
  volume.Grid = vtkSmartPointer<vtkImageData>::New();
  volume.Grid->CopyStructure(image);
  volume.Level = flow.GetLevel();
  vtkNew<vtkPolyData> surface;
  FillSurface(flow.GetSolution(), volume, flow.GetTemperature(), triangles, surface,
    Between(progress, 0.0, 0.6));
  FillImage(flow.GetSolution(), image, Between(progress, 0.6, 1.0));
  std::vector<std::string> all = notes;
  const SolvationUpdate& last = flow.GetUpdates().back();
  all.push_back("Solvation energy " + FormatWithError(last.Total(), errors.Total, "kcal/mol") +
    "; its polar part " + FormatWithError(last.PolarEnergy, errors.Polar, "kcal/mol") + ".");
  vtkNew<vtkTable> table;
  FillTable(flow.GetUpdates(), table);
  for (vtkDataObject* made : { static_cast<vtkDataObject*>(surface),
         static_cast<vtkDataObject*>(image), static_cast<vtkDataObject*>(table) })
  {
    AddNotes(all, made);
    AddColumn<vtkDoubleArray>(
      made->GetFieldData(), "Converged", { flow.HasConverged() ? 1.0 : 0.0 });
    AddColumn<vtkDoubleArray>(made->GetFieldData(), "PolarEnergyError", { errors.Polar });
    AddColumn<vtkDoubleArray>(made->GetFieldData(), "TotalEnergyError", { errors.Total });
  }
  outputs.Surface->ShallowCopy(surface);
  outputs.Image->ShallowCopy(image);
  outputs.Updates->ShallowCopy(table);
}

}
