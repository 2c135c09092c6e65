#include "vtkSurfaceMeasures.h"

#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/ImageScalars.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Core/PolyDataTriangles.h"
#include "Core/RangeChecks.h"
#include "Surfaces/CartesianMeasures.h"
#include "Surfaces/ShellCrossings.h"
#include "Surfaces/SurfaceCleaning.h"
#include "Surfaces/SurfaceCorrection.h"
#include "Surfaces/SurfaceMeasures.h"

#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

vtkStandardNewMacro(vtkSurfaceMeasures);

namespace
{

using isthmus::SurfaceMeasure;

void AddFields(vtkFieldData* fields, const SurfaceMeasure& whole, vtkIdType components)
{
  isthmus::AddColumn<vtkDoubleArray>(fields, "Area", { whole.Area });
  isthmus::AddColumn<vtkDoubleArray>(fields, "Volume", { whole.Volume });
  isthmus::AddColumn<vtkDoubleArray>(fields, "AreaError", { whole.AreaError });
  isthmus::AddColumn<vtkDoubleArray>(fields, "VolumeError", { whole.VolumeError });
  isthmus::AddColumn<vtkIdTypeArray>(fields, "Genus", { whole.Genus });
  isthmus::AddColumn<vtkIdTypeArray>(fields, "Components", { components });
  isthmus::AddColumn<vtkIdTypeArray>(fields, "EulerNumber", { whole.EulerNumber() });
  isthmus::AddColumn<vtkIdTypeArray>(fields, "OpenEdges", { whole.OpenEdges });
  isthmus::AddColumn<vtkIdTypeArray>(fields, "BoundaryLoops", { whole.BoundaryLoops });
  isthmus::AddColumn<vtkIdTypeArray>(fields, "IrregularPoints", { whole.IrregularPoints });
}

/// Whether a node on the border of the volume is inside.
template <typename T>
bool ReachesBorder(const isthmus::LevelView<T>& level)
{
  const auto& n = level.Grid.Dimensions;
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      const bool isOuter = k == 0 || k == n[2] - 1 || j == 0 || j == n[1] - 1;
      const std::int64_t step = isOuter ? 1 : std::max<std::int64_t>(1, n[0] - 1);
      for (std::int64_t i = 0; i < n[0]; i += step)
      {
        if (level.IsInside(static_cast<double>(level.Grid(i, j, k))))
        {
          return true;
        }
      }
    }
  }
  return false;
}

void FillTable(vtkTable* table, const isthmus::SurfaceMeasures& measures)
{
  using Row = SurfaceMeasure;
  vtkFieldData* const data = table->GetRowData();
  std::vector<Row> rows{ measures.Whole };
  rows.insert(rows.end(), measures.Components.begin(), measures.Components.end());
  vtkIdType component = -1;
  isthmus::AddComputedColumn<vtkIdTypeArray>(
    data, "Component", rows, [&](const Row&) { return component++; });
  isthmus::AddComputedColumn<vtkDoubleArray>(
    data, "Area", rows, [](const Row& row) { return row.Area; });
  isthmus::AddComputedColumn<vtkDoubleArray>(
    data, "Volume", rows, [](const Row& row) { return row.Volume; });
  isthmus::AddComputedColumn<vtkDoubleArray>(
    data, "AreaError", rows, [](const Row& row) { return row.AreaError; });
  isthmus::AddComputedColumn<vtkDoubleArray>(
    data, "VolumeError", rows, [](const Row& row) { return row.VolumeError; });
  isthmus::AddComputedColumn<vtkIdTypeArray>(
    data, "Genus", rows, [](const Row& row) { return row.Genus; });
  isthmus::AddComputedColumn<vtkIdTypeArray>(
    data, "EulerNumber", rows, [](const Row& row) { return row.EulerNumber(); });
  isthmus::AddComputedColumn<vtkIdTypeArray>(
    data, "Points", rows, [](const Row& row) { return row.Points; });
  isthmus::AddComputedColumn<vtkIdTypeArray>(
    data, "Edges", rows, [](const Row& row) { return row.Edges; });
  isthmus::AddComputedColumn<vtkIdTypeArray>(
    data, "Triangles", rows, [](const Row& row) { return row.Triangles; });
  isthmus::AddComputedColumn<vtkIdTypeArray>(
    data, "OpenEdges", rows, [](const Row& row) { return row.OpenEdges; });
  isthmus::AddComputedColumn<vtkIdTypeArray>(
    data, "BoundaryLoops", rows, [](const Row& row) { return row.BoundaryLoops; });
  isthmus::AddComputedColumn<vtkIdTypeArray>(
    data, "IrregularPoints", rows, [](const Row& row) { return row.IrregularPoints; });
}

}

const std::vector<isthmus::OutputArray>& vtkSurfaceMeasures::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Field, "Area", 1, "length^2", ArrayChoice::None, "of the surface" },
    { 0, ArrayPlace::Field, "Volume", 1, "length^3", ArrayChoice::None,
      "enclosed, below 0 if triangles face inwards; NaN if nothing is enclosed or components "
      "cross" },
    { 0, ArrayPlace::Field, "AreaError", 1, "length^2", ArrayChoice::None,
      "estimated, of a smooth surface given by a mesh or a volume" },
    { 0, ArrayPlace::Field, "VolumeError", 1, "length^3", ArrayChoice::None,
      "estimated, of a smooth surface given by a mesh or a volume" },
    { 0, ArrayPlace::Field, "Genus", 1, "", ArrayChoice::None,
      "number of handles, with the boundary loops closed; -1 if there are irregular points" },
    { 0, ArrayPlace::Field, "Components", 1, "", ArrayChoice::None, "parts that share no point" },
    { 0, ArrayPlace::Field, "EulerNumber", 1, "", ArrayChoice::None, "points - edges + triangles" },
    { 0, ArrayPlace::Field, "OpenEdges", 1, "", ArrayChoice::None,
      "edges with more triangles on one side than on the other" },
    { 0, ArrayPlace::Field, "BoundaryLoops", 1, "", ArrayChoice::None,
      "closed curves of open edges" },
    { 0, ArrayPlace::Field, "IrregularPoints", 1, "", ArrayChoice::None,
      "points around which the triangles form neither a disc nor a half disc" },
    { 0, ArrayPlace::Field, "SmearedArea", 1, "length^2", ArrayChoice::None,
      "of images: from the scalars scaled to 0 outside and 1 inside" },
    { 0, ArrayPlace::Field, "SmearedVolume", 1, "length^3", ArrayChoice::None,
      "of images: from the scalars scaled to 0 outside and 1 inside" },
    { 1, ArrayPlace::Rows, "Component", 1, "", ArrayChoice::None, "-1 for the whole surface" },
    { 1, ArrayPlace::Rows, "Area", 1, "length^2", ArrayChoice::None, "of the surface" },
    { 1, ArrayPlace::Rows, "Volume", 1, "length^3", ArrayChoice::None,
      "enclosed, below 0 if triangles face inwards; NaN if nothing is enclosed or components "
      "cross" },
    { 1, ArrayPlace::Rows, "AreaError", 1, "length^2", ArrayChoice::None,
      "estimated, of a smooth surface given by a mesh or a volume" },
    { 1, ArrayPlace::Rows, "VolumeError", 1, "length^3", ArrayChoice::None,
      "estimated, of a smooth surface given by a mesh or a volume" },
    { 1, ArrayPlace::Rows, "Genus", 1, "", ArrayChoice::None,
      "number of handles, with the boundary loops closed; -1 if there are irregular points" },
    { 1, ArrayPlace::Rows, "EulerNumber", 1, "", ArrayChoice::None, "points - edges + triangles" },
    { 1, ArrayPlace::Rows, "OpenEdges", 1, "", ArrayChoice::None,
      "edges with more triangles on one side than on the other" },
    { 1, ArrayPlace::Rows, "BoundaryLoops", 1, "", ArrayChoice::None,
      "closed curves of open edges" },
    { 1, ArrayPlace::Rows, "IrregularPoints", 1, "", ArrayChoice::None,
      "points around which the triangles form neither a disc nor a half disc" },
    { 1, ArrayPlace::Rows, "Points", 1, "", ArrayChoice::None, "their number" },
    { 1, ArrayPlace::Rows, "Edges", 1, "", ArrayChoice::None, "their number" },
    { 1, ArrayPlace::Rows, "Triangles", 1, "", ArrayChoice::None, "their number" },
    { 1, ArrayPlace::Rows, "SmearedArea", 1, "length^2", ArrayChoice::None,
      "of images: as on output 0" },
    { 1, ArrayPlace::Rows, "SmearedVolume", 1, "length^3", ArrayChoice::None,
      "of images: as on output 0" },
  };
  return table;
}

vtkSurfaceMeasures::vtkSurfaceMeasures()
{
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

int vtkSurfaceMeasures::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkSurfaceMeasures::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkDataObject" : "vtkTable");
  return 1;
}

int vtkSurfaceMeasures::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0], 0);
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  if (!input)
  {
    return 0;
  }
  if (!output || !output->IsA(input->GetClassName()))
  {
    auto made = vtkSmartPointer<vtkDataObject>::Take(input->NewInstance());
    outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  if (!vtkTable::GetData(outputVector, 1))
  {
    outputVector->GetInformationObject(1)->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkTable>());
  }
  return 1;
}

int vtkSurfaceMeasures::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // The measure of a part of the image is not that of the whole.
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  if (info->Has(Pipeline::WHOLE_EXTENT()))
  {
    int whole[6];
    info->Get(Pipeline::WHOLE_EXTENT(), whole);
    info->Set(Pipeline::UPDATE_EXTENT(), whole, 6);
  }
  return 1;
}

int vtkSurfaceMeasures::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  vtkTable* table = vtkTable::GetData(outputVector, 1);
  isthmus::ClearOutputs(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      output->ShallowCopy(vtkDataObject::GetData(inputVector[0], 0));
      if (auto* surface = vtkPolyData::GetData(inputVector[0], 0))
      {
        this->Measure(surface, output, table);
      }
      else
      {
        this->Measure(vtkImageData::GetData(inputVector[0], 0), output, table);
      }
    });
}

void vtkSurfaceMeasures::Measure(vtkPolyData* surface, vtkDataObject* output, vtkTable* table)
{
  // The output is this rank's piece; all pieces are measured on the first rank.
  const auto sewn = isthmus::GatherSurface(this, surface);
  if (!isthmus::OnFirstRank())
  {
    return;
  }
  const isthmus::PolyDataTriangles triangles(sewn);
  // Coincident points are merged, otherwise each triangle of some files would be a component.
  const auto& points = triangles.View().Points;
  std::vector<isthmus::Triangle> corners = isthmus::MergedCorners(triangles.View());
  const auto progress = isthmus::MakeProgress(this);
  auto measures =
    isthmus::MeasureSurface({ points, corners }, isthmus::Between(progress, 0.0, 0.8));
  isthmus::SurfaceCorrection correction;
  if (!measures.Whole.IsClosed())
  {
    corners = isthmus::JoinCracks({ points, corners }, correction);
    corners = isthmus::OrientAlike({ points, corners }, correction);
  }
  corners = isthmus::OrientShells({ points, corners }, correction);
  if (!correction.Message().empty())
  {
    measures = isthmus::MeasureSurface({ points, corners });
    vtkWarningMacro(<< isthmus::JoinText("The measures are those of the repaired surface: ",
                      correction.Message(), " The output is the surface without these repairs."));
  }
  const auto crossing =
    isthmus::FindShellCrossing({ points, corners }, isthmus::Between(progress, 0.8, 0.9));
  SurfaceMeasure& whole = measures.Whole;
  if (crossing)
  {
    whole.Volume = whole.VolumeError = std::numeric_limits<double>::quiet_NaN();
    vtkWarningMacro(<< isthmus::JoinText("Volume is not a number. ", crossing->Message()));
  }
  const auto self =
    isthmus::FindSelfCrossing({ points, corners }, isthmus::Between(progress, 0.9, 1.0));
  if (self && whole.IsClosed())
  {
    const auto& at = self->Place;
    const std::string place = isthmus::JoinText("(", at[0], ", ", at[1], ", ", at[2], ")");
    vtkWarningMacro(<< (self->Pairs == 0
                        ? "The surface touches itself, for instance at " + place +
                          ": Volume and Genus are those of its sheets as they are connected, not "
                          "as they touch."
                        : isthmus::JoinText("The surface passes through itself: ", self->Pairs,
                            " pairs of triangles cross, the first at ", place,
                            ". What it encloses twice counts twice in Volume, and what it encloses "
                            "the other way "
                            "round is subtracted. Tetrahedral Mesher with Library Automatic and "
                            "Extract Surface "
                            "make a surface without crossings.")));
  }
  isthmus::Report(progress, 1.0);
  AddFields(output->GetFieldData(), whole, static_cast<vtkIdType>(measures.Components.size()));
  FillTable(table, measures);
  if (!whole.IsClosed())
  {
    vtkWarningMacro(<< isthmus::JoinText(
                      "The surface is not closed, so Volume is not a number: ", whole.OpenEdges,
                      " edges have more triangles on one side than on the other (holes or flipped "
                      "neighbours). Fill the holes or make the winding consistent first."));
  }
  if (whole.IrregularPoints > 0)
  {
    vtkWarningMacro(<< isthmus::JoinText("The surface is not a manifold, so Genus is -1: around ",
                      whole.IrregularPoints,
                      " points its triangles form neither a disc nor a half disc."));
  }
}

void vtkSurfaceMeasures::Measure(vtkImageData* image, vtkDataObject* output, vtkTable* table)
{
  if (image->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (isthmus::NumberOfRanks() > 1)
  {
    throw std::runtime_error("The measures of a level need all of the volume on one rank, and "
                             "there are " +
      std::to_string(isthmus::NumberOfRanks()) +
      ": take the area and volume of its Contour, which are added up, or one rank.");
  }
  isthmus::RequireThat(!std::isnan(this->Level), "Level", this->Level, "it must be a number");
  isthmus::RequireThat(
    !std::isnan(this->InsideValue), "InsideValue", this->InsideValue, "it must be a number");
  isthmus::RequireThat(
    !std::isnan(this->OutsideValue), "OutsideValue", this->OutsideValue, "it must be a number");
  isthmus::CartesianMeasures measures;
  isthmus::CartesianErrors errors;
  bool reachesBorder = false;
  isthmus::UseScalars(image, isthmus::ChosenScalars(this, image),
    [&](const auto& grid)
    {
      using T = std::remove_const_t<std::remove_pointer_t<decltype(grid.Data)>>;
      const isthmus::LevelView<T> level{ grid, this->Level, this->InsideIsHigher };
      isthmus::CheckFinite(grid);
      reachesBorder = ReachesBorder(level);
      const auto progress = isthmus::MakeProgress(this);
      measures = isthmus::MeasureOnGrid(
        level, this->InsideValue, this->OutsideValue, isthmus::Between(progress, 0.0, 0.5));
      errors = isthmus::EstimateErrors(level, measures, isthmus::Between(progress, 0.5, 1.0));
    });
  if (reachesBorder)
  {
    vtkWarningMacro("The level reaches the border of the volume: Area is without the parts on the "
                    "border, and Volume ends half a spacing beyond the outermost nodes. Choose "
                    "another Level, toggle InsideIsHigher, or measure a larger volume.");
  }
  const std::pair<const char*, double> values[] = { { "Area", measures.Area },
    { "Volume", measures.Volume }, { "AreaError", errors.Area }, { "VolumeError", errors.Volume },
    { "SmearedArea", measures.SmearedArea }, { "SmearedVolume", measures.SmearedVolume } };
  for (const auto& [name, value] : values)
  {
    isthmus::AddColumn<vtkDoubleArray>(output->GetFieldData(), name, { value });
    isthmus::AddColumn<vtkDoubleArray>(table->GetRowData(), name, { value });
  }
}

vtkTable* vtkSurfaceMeasures::GetTable()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

void vtkSurfaceMeasures::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "InsideIsHigher: " << this->InsideIsHigher << "\n";
  os << indent << "InsideValue: " << this->InsideValue << "\n";
  os << indent << "OutsideValue: " << this->OutsideValue << "\n";
}
