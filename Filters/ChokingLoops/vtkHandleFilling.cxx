#include "vtkHandleFilling.h"

#include "ChokingLoops/HandleFilling.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ArrayMemory.h"
#include "Core/GatherRanks.h"
#include "Core/NumberText.h"
#include "Core/PolyDataTriangles.h"
#include "Core/RangeChecks.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHandleFilling);

namespace
{

template <typename Array>
Array* AddColumn(vtkTable* table, const char* name)
{
  vtkNew<Array> column;
  column->SetName(name);
  table->AddColumn(column);
  return column;
}

void FillTable(const std::vector<isthmus::HandleFill>& fills, vtkTable* table)
{
  auto* filling = AddColumn<vtkIntArray>(table, "Filling");
  auto* kind = AddColumn<vtkIntArray>(table, "Kind");
  auto* kindName = AddColumn<vtkStringArray>(table, "KindName");
  auto* radius = AddColumn<vtkDoubleArray>(table, "Radius");
  auto* area = AddColumn<vtkDoubleArray>(table, "Area");
  auto* thickness = AddColumn<vtkDoubleArray>(table, "Thickness");
  auto* volume = AddColumn<vtkDoubleArray>(table, "Volume");
  for (const isthmus::HandleFill& fill : fills)
  {
    const bool isTunnel = fill.Kind == isthmus::FeatureKind::Tunnel;
    filling->InsertNextValue(static_cast<int>(filling->GetNumberOfValues()) + 1);
    kind->InsertNextValue(static_cast<int>(fill.Kind));
    kindName->InsertNextValue(isTunnel ? "tunnel" : "handle");
    radius->InsertNextValue(fill.Radius);
    area->InsertNextValue(fill.Area);
    thickness->InsertNextValue(fill.Thickness);
    volume->InsertNextValue((isTunnel ? 1.0 : -1.0) * fill.Area * fill.Thickness);
  }
}

void FillSurface(const isthmus::FilledSurface& filled, vtkPolyData* given, vtkPolyData* surface)
{
  isthmus::SetMesh(filled.Mesh, surface);
  surface->GetFieldData()->PassData(given->GetFieldData());
  vtkNew<vtkIntArray> filling;
  filling->SetName("Filling");
  isthmus::SizeArray(filling, static_cast<vtkIdType>(filled.Filling.size()));
  std::copy(filled.Filling.begin(), filled.Filling.end(), filling->GetPointer(0));
  surface->GetCellData()->SetScalars(filling);
  vtkNew<vtkIdTypeArray> genus;
  genus->SetName("Genus");
  genus->InsertNextValue(filled.Genus + static_cast<vtkIdType>(filled.Fills.size()));
  genus->InsertNextValue(filled.Genus);
  surface->GetFieldData()->AddArray(genus);
  vtkNew<vtkIdTypeArray> left;
  left->SetName("LeftOpen");
  left->InsertNextValue(static_cast<vtkIdType>(filled.Left));
  surface->GetFieldData()->AddArray(left);
}

}

vtkHandleFilling::vtkHandleFilling()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkHandleFilling::FillOutputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkDataObject::DATA_TYPE_NAME(), port == 1 ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkHandleFilling::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  auto* surface = vtkPolyData::GetData(output, 0);
  auto* table = vtkTable::GetData(output, 1);
  return isthmus::Guarded(this, output,
    [&]
    {
      const auto whole = isthmus::GatherSurface(this, vtkPolyData::GetData(input[0]));
      if (whole->GetNumberOfPoints() == 0)
      {
        return;
      }
      isthmus::RequireThat(!std::isnan(this->SampleSpacing), "SampleSpacing", this->SampleSpacing,
        "it must be a number");
      isthmus::HandleFillingParameters parameters;
      parameters.Below = this->FillHandlesBelow;
      parameters.Inside = this->Side != Outside;
      parameters.Outside = this->Side != Inside;
      parameters.Thickness = this->Thickness;
      parameters.Analysis.SampleSpacing = this->SampleSpacing;
      const isthmus::FilledSurface filled =
        isthmus::FillHandles(isthmus::MeshOf(whole), parameters, isthmus::ProgressOf(this));
      if (!filled.Repairs.Message.empty())
      {
        vtkWarningMacro(<< filled.Repairs.Message);
      }
      if (filled.Left > 0)
      {
        vtkWarningMacro(
          << isthmus::TextOf(filled.Left, " of ", filled.Left + filled.Fills.size(),
               " handles and tunnels below the size were not removed: they have no membrane with a "
               "single loop that keeps clear of the rest of the surface."));
      }
      FillSurface(filled, whole, surface);
      FillTable(filled.Fills, table);
    });
}

void vtkHandleFilling::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FillHandlesBelow: " << this->FillHandlesBelow << "\n";
  os << indent << "Side: " << this->Side << "\n";
  os << indent << "Thickness: " << this->Thickness << "\n";
  os << indent << "SampleSpacing: " << this->SampleSpacing << "\n";
}
