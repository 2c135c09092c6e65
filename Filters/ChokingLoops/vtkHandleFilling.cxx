#include "vtkHandleFilling.h"

#include "ChokingLoops/HandleFilling.h"
#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Core/PolyDataTriangles.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

vtkStandardNewMacro(vtkHandleFilling);

const std::vector<isthmus::OutputArray>& vtkHandleFilling::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Cells, "Filling", 1, "", ArrayChoice::None,
      "number of the filling, from 1; 0: on the input surface" },
    { 0, ArrayPlace::Field, "Genus", 1, "", ArrayChoice::None,
      "before, after; all components together" },
    { 0, ArrayPlace::Field, "LeftOpen", 1, "", ArrayChoice::None,
      "handles and tunnels below the size that could not be filled" },
    { 1, ArrayPlace::Rows, "Filling", 1, "", ArrayChoice::None, "number of the filling, from 1" },
    { 1, ArrayPlace::Rows, "Kind", 1, "", ArrayChoice::None, "0 handle, 1 tunnel" },
    { 1, ArrayPlace::Rows, "KindName", 1, "", ArrayChoice::None, "the same as text" },
    { 1, ArrayPlace::Rows, "Radius", 1, "length", ArrayChoice::None,
      "of the ball that gets stuck" },
    { 1, ArrayPlace::Rows, "Area", 1, "length^2", ArrayChoice::None, "of the membrane" },
    { 1, ArrayPlace::Rows, "Thickness", 1, "length", ArrayChoice::None, "of the filling" },
    { 1, ArrayPlace::Rows, "Volume", 1, "length^3", ArrayChoice::None,
      "Area times Thickness; negative: cut away" },
  };
  return table;
}

namespace
{

void FillTable(const std::vector<isthmus::HandleFill>& fills, vtkTable* table)
{
  using Fill = isthmus::HandleFill;
  const auto isTunnel = [](const Fill& fill) { return fill.Kind == isthmus::FeatureKind::Tunnel; };
  vtkFieldData* const data = table->GetRowData();
  isthmus::AddComputedColumn<vtkIntArray>(
    data, "Filling", fills.size(), [](std::size_t row) { return row + 1; });
  isthmus::AddComputedColumn<vtkIntArray>(
    data, "Kind", fills, [](const Fill& fill) { return static_cast<int>(fill.Kind); });
  isthmus::AddComputedColumn<vtkStringArray>(data, "KindName", fills,
    [&](const Fill& fill) { return isTunnel(fill) ? "tunnel" : "handle"; });
  const auto add = [&](const char* name, const auto& of)
  { isthmus::AddComputedColumn<vtkDoubleArray>(data, name, fills, of); };
  add("Radius", [](const Fill& fill) { return fill.Radius; });
  add("Area", [](const Fill& fill) { return fill.Area; });
  add("Thickness", [](const Fill& fill) { return fill.Thickness; });
  add("Volume",
    [&](const Fill& fill) { return (isTunnel(fill) ? 1.0 : -1.0) * fill.Area * fill.Thickness; });
}

void FillSurface(const isthmus::FilledSurface& filled, vtkPolyData* given, vtkPolyData* surface)
{
  isthmus::SetMesh(filled.Mesh, surface);
  surface->GetFieldData()->PassData(given->GetFieldData());
  isthmus::AddColumn<vtkIntArray>(surface->GetCellData(), "Filling", filled.Filling);
  surface->GetCellData()->SetActiveScalars("Filling");
  isthmus::AddColumn<vtkIdTypeArray>(surface->GetFieldData(), "Genus",
    { filled.Genus + static_cast<vtkIdType>(filled.Fills.size()), vtkIdType{ filled.Genus } });
  isthmus::AddColumn<vtkIdTypeArray>(surface->GetFieldData(), "LeftOpen", { filled.Left });
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
  return isthmus::RunGuarded(this, output,
    [&]
    {
      const auto whole = isthmus::GatherSurface(this, vtkPolyData::GetData(input[0]));
      if (whole->GetNumberOfPoints() == 0)
      {
        return;
      }
      const isthmus::FilledSurface filled = isthmus::FillHandles(
        isthmus::ToTriangleMesh(whole), this->Parameters, isthmus::MakeProgress(this));
      if (!filled.Repairs.Message.empty())
      {
        vtkWarningMacro(<< filled.Repairs.Message);
      }
      if (filled.Left > 0)
      {
        vtkWarningMacro(
          << isthmus::JoinText(filled.Left, " of ", filled.Left + filled.Fills.size(),
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
  os << indent << "FillHandlesBelow: " << this->GetFillHandlesBelow() << "\n";
  os << indent << "Side: " << this->GetSide() << "\n";
  os << indent << "Thickness: " << this->GetThickness() << "\n";
  os << indent << "SampleSpacing: " << this->GetSampleSpacing() << "\n";
}
