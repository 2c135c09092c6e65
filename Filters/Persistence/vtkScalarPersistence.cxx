#include "vtkScalarPersistence.h"

#include "Core/AlgorithmGuard.h"
#include "Core/ImageExtent.h"
#include "Core/ImageScalars.h"
#include "Core/NamedColumns.h"
#include "Core/RangeChecks.h"
#include "Persistence/PersistenceCache.h"
#include "Persistence/PersistenceTables.h"
#include "Persistence/ScalarSimplification.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>

vtkStandardNewMacro(vtkScalarPersistence);

namespace
{

using isthmus::VolumeView;
using Pipeline = vtkStreamingDemandDrivenPipeline;

enum Port
{
  CurvesPort,
  DiagramPort,
  SaddlesPort,
  CyclesPort,
  SimplifiedPort,
  PortCount
};

}

/// The data of one execution.
class vtkScalarPersistence::vtkInternals
{
public:
  vtkImageData* Image = nullptr;
  vtkDataArray* Scalars = nullptr;
  VolumeView Volume;
  isthmus::FeatureList Features;
  std::vector<double> Levels;
  std::vector<std::int64_t> EulerNumbers;
  double End = 0.0; ///< where infinite deaths are drawn
};

const std::vector<isthmus::OutputArray>& vtkScalarPersistence::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Rows, "Level", 1, "value", ArrayChoice::None, "NumberOfLevels levels" },
    { 0, ArrayPlace::Rows, "Beta0", 1, "", ArrayChoice::None, "number of components" },
    { 0, ArrayPlace::Rows, "Beta1", 1, "", ArrayChoice::None, "number of tunnels" },
    { 0, ArrayPlace::Rows, "Beta2", 1, "", ArrayChoice::None, "number of cavities" },
    { 0, ArrayPlace::Rows, "FilteredBeta0", 1, "", ArrayChoice::None,
      "number of components of the listed classes" },
    { 0, ArrayPlace::Rows, "FilteredBeta1", 1, "", ArrayChoice::None,
      "number of tunnels of the listed classes" },
    { 0, ArrayPlace::Rows, "FilteredBeta2", 1, "", ArrayChoice::None,
      "number of cavities of the listed classes" },
    { 0, ArrayPlace::Rows, "EulerNumber", 1, "", ArrayChoice::None, "counted from cells" },
    { 0, ArrayPlace::Rows, "IntegralBeta0", 1, "value", ArrayChoice::None,
      "of Beta0 from the first level (superlevels: the highest) to this one" },
    { 0, ArrayPlace::Rows, "IntegralBeta1", 1, "value", ArrayChoice::None,
      "of Beta1 from the first level (superlevels: the highest) to this one" },
    { 0, ArrayPlace::Rows, "IntegralBeta2", 1, "value", ArrayChoice::None,
      "of Beta2 from the first level (superlevels: the highest) to this one" },
    { 0, ArrayPlace::Rows, "IntegralFilteredBeta0", 1, "value", ArrayChoice::None,
      "of FilteredBeta0" },
    { 0, ArrayPlace::Rows, "IntegralFilteredBeta1", 1, "value", ArrayChoice::None,
      "of FilteredBeta1" },
    { 0, ArrayPlace::Rows, "IntegralFilteredBeta2", 1, "value", ArrayChoice::None,
      "of FilteredBeta2" },
    { 1, ArrayPlace::Rows, "FeatureId", 1, "", ArrayChoice::None,
      "number of the class, the longest first; does not depend on the threshold" },
    { 1, ArrayPlace::Rows, "Dimension", 1, "", ArrayChoice::None,
      "0 component, 1 tunnel, 2 cavity" },
    { 1, ArrayPlace::Rows, "Birth", 1, "value", ArrayChoice::None, "level at which it appears" },
    { 1, ArrayPlace::Rows, "Death", 1, "value", ArrayChoice::None,
      "level at which it disappears; infinite for the class that never does" },
    { 1, ArrayPlace::Rows, "Persistence", 1, "value", ArrayChoice::None, "|Death - Birth|" },
    { 1, ArrayPlace::Rows, "DeathShown", 1, "value", ArrayChoice::None,
      "Death, cut at the end of the range, for charts" },
    { 1, ArrayPlace::Rows, "Joins", 1, "", ArrayChoice::None,
      "FeatureId of what a component or cavity becomes part of when it ends; -1: none" },
    { 2, ArrayPlace::Points, "FeatureId", 1, "", ArrayChoice::None,
      "number of the class, the longest first; does not depend on the threshold" },
    { 2, ArrayPlace::Points, "Dimension", 1, "", ArrayChoice::None,
      "0 component, 1 tunnel, 2 cavity" },
    { 2, ArrayPlace::Points, "Birth", 1, "value", ArrayChoice::None, "level at which it appears" },
    { 2, ArrayPlace::Points, "Death", 1, "value", ArrayChoice::None,
      "level at which it disappears; infinite for the class that never does" },
    { 2, ArrayPlace::Points, "Persistence", 1, "value", ArrayChoice::None, "|Death - Birth|" },
    { 2, ArrayPlace::Points, "DeathShown", 1, "value", ArrayChoice::None,
      "Death, cut at the end of the range, for charts" },
    { 2, ArrayPlace::Points, "Joins", 1, "", ArrayChoice::None,
      "FeatureId of what a component or cavity becomes part of when it ends; -1: none" },
    { 2, ArrayPlace::Points, "Value", 1, "value", ArrayChoice::None, "of the node" },
    { 2, ArrayPlace::Points, "CriticalIndex", 1, "", ArrayChoice::None,
      "dimension of the critical cell: 0 components begin, 1 they meet or tunnels begin, 2 "
      "tunnels are filled or cavities close, 3 cavities are filled" },
    { 3, ArrayPlace::Cells, "FeatureId", 1, "", ArrayChoice::None,
      "number of the class, the longest first; does not depend on the threshold" },
    { 3, ArrayPlace::Cells, "Dimension", 1, "", ArrayChoice::None,
      "0 component, 1 tunnel, 2 cavity" },
    { 3, ArrayPlace::Cells, "Birth", 1, "value", ArrayChoice::None, "level at which it appears" },
    { 3, ArrayPlace::Cells, "Death", 1, "value", ArrayChoice::None,
      "level at which it disappears; infinite for the class that never does" },
    { 3, ArrayPlace::Cells, "Persistence", 1, "value", ArrayChoice::None, "|Death - Birth|" },
    { 3, ArrayPlace::Cells, "DeathShown", 1, "value", ArrayChoice::None,
      "Death, cut at the end of the range, for charts" },
    { 3, ArrayPlace::Cells, "Joins", 1, "", ArrayChoice::None,
      "FeatureId of what a component or cavity becomes part of when it ends; -1: none" },
    { 3, ArrayPlace::Cells, "Length", 1, "length", ArrayChoice::None, "of the polyline" },
  };
  return table;
}

vtkScalarPersistence::vtkScalarPersistence()
  : Cache(std::make_unique<isthmus::PersistenceCache>())
{
  this->SetNumberOfOutputPorts(PortCount);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkScalarPersistence::~vtkScalarPersistence() = default;

int vtkScalarPersistence::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkScalarPersistence::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* types[] = { "vtkTable", "vtkTable", "vtkPolyData", "vtkPolyData", "vtkImageData" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
  return 1;
}

int vtkScalarPersistence::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* image = outputVector->GetInformationObject(SimplifiedPort);
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  if (this->Simplify)
  {
    image->CopyEntry(input, Pipeline::WHOLE_EXTENT());
  }
  else
  {
    const int none[6] = { 0, -1, 0, -1, 0, -1 };
    image->Set(Pipeline::WHOLE_EXTENT(), none, 6);
  }
  image->CopyEntry(input, vtkDataObject::ORIGIN());
  image->CopyEntry(input, vtkDataObject::SPACING());
  image->CopyEntry(input, vtkDataObject::DIRECTION());
  return 1;
}

int vtkScalarPersistence::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // A loop can run anywhere, so the whole volume is needed, whatever part is requested.
  isthmus::RequestWholeExtent(inputVector[0]->GetInformationObject(0));
  return 1;
}

void vtkScalarPersistence::CheckParameters() const
{
  isthmus::RequireLevels(this->NumberOfLevels, this->AutomaticRange ? nullptr : this->Range);
  isthmus::Check(this->Parameters);
  isthmus::RequireRange(
    "MaximumNumberOfCycles", this->MaximumNumberOfCycles, 1, VTK_INT_MAX, "Or switch Cycles off.");
}

void vtkScalarPersistence::FindPairs(vtkInternals& work)
{
  const auto& statistics = this->Cache->Statistics(work.Scalars, work.Volume);
  const double low = this->AutomaticRange ? statistics.Minimum : this->Range[0];
  const double high = this->AutomaticRange ? statistics.Maximum : this->Range[1];
  isthmus::CubicalParameters parameters;
  parameters.Superlevel = this->Parameters.Superlevel;
  if (low <= high) // a volume of infinities has no range
  {
    parameters.Levels = isthmus::EvenLevels(low, high, this->NumberOfLevels);
  }
  const auto& diagram = this->Cache->Pairs(
    work.Volume, parameters, isthmus::Between(isthmus::MakeProgress(this), 0.0, 0.7));
  work.Levels = parameters.Levels;
  work.EulerNumbers = diagram.EulerNumbers;
  isthmus::FeatureParameters wanted = this->Parameters;
  if (!this->AutomaticRange)
  {
    wanted.Range = { this->Range[0], this->Range[1] };
  }
  work.Features = isthmus::ScalarFeatures(work.Volume, statistics, diagram, wanted);
  work.End = this->Parameters.Superlevel ? low : high;
}

void vtkScalarPersistence::FillTables(const vtkInternals& work, vtkInformationVector* outputVector)
{
  const auto progress = isthmus::Between(isthmus::MakeProgress(this), 0.7, 0.9);
  isthmus::FillCurves(isthmus::CountBetti(work.Features, this->Parameters.Superlevel, work.Levels),
    work.EulerNumbers, vtkTable::GetData(outputVector, CurvesPort));
  isthmus::FillDiagram(work.Features, work.End, vtkTable::GetData(outputVector, DiagramPort));
  isthmus::FillSaddles(work.Features, work.End, work.Image, work.Volume,
    vtkPolyData::GetData(outputVector, SaddlesPort));
  if (this->Cycles)
  {
    const double* spacing = work.Image->GetSpacing();
    isthmus::FillCycles(work.Features,
      isthmus::CubicalCycles(work.Volume, { spacing[0], spacing[1], spacing[2] }, work.Features,
        this->Parameters.Superlevel, static_cast<std::size_t>(this->MaximumNumberOfCycles),
        progress),
      work.Image, vtkPolyData::GetData(outputVector, CyclesPort));
  }
}

void vtkScalarPersistence::FillSimplified(
  const vtkInternals& work, vtkInformationVector* outputVector)
{
  const auto values = isthmus::ArrayOfType(
    work.Scalars->GetDataType(), work.Scalars->GetName(), work.Scalars->GetNumberOfTuples());
  isthmus::SimplifyScalar(work.Volume, work.Features, this->Parameters.Superlevel,
    values->GetVoidPointer(0), isthmus::Between(isthmus::MakeProgress(this), 0.9, 1.0));
  vtkImageData* output = vtkImageData::GetData(outputVector, SimplifiedPort);
  output->ShallowCopy(work.Image);
  if (values->GetName())
  {
    output->GetPointData()->AddArray(values);
    output->GetPointData()->SetActiveScalars(values->GetName());
  }
  else
  {
    output->GetPointData()->SetScalars(values);
  }
  vtkInformation* info = outputVector->GetInformationObject(SimplifiedPort);
  const isthmus::Extent asked = isthmus::ReadExtent(info, Pipeline::UPDATE_EXTENT());
  if (!isthmus::IsEmpty(asked))
  {
    isthmus::CropTo(output, isthmus::GetPieceExtent(info, asked));
  }
}

int vtkScalarPersistence::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  isthmus::ClearOutputs(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      isthmus::RequireWholeExtent(inputVector[0]->GetInformationObject(0));
      vtkInternals work;
      work.Image = vtkImageData::GetData(inputVector[0], 0);
      if (!work.Image || work.Image->GetNumberOfPoints() == 0)
      {
        return;
      }
      const bool isFirst = isthmus::IsFirstPiece(outputVector->GetInformationObject(CurvesPort));
      this->CheckParameters();
      if (isFirst || this->Simplify)
      {
        work.Scalars = isthmus::ChosenScalars(this, work.Image);
        work.Volume = isthmus::MakeVolumeView(work.Scalars, work.Image);
        this->FindPairs(work);
      }
      if (isFirst)
      {
        this->FillTables(work, outputVector);
      }
      if (this->Simplify)
      {
        this->FillSimplified(work, outputVector);
      }
      this->UpdateProgress(1.0);
    });
}

vtkTable* vtkScalarPersistence::GetBettiCurves()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(CurvesPort));
}

vtkTable* vtkScalarPersistence::GetDiagram()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(DiagramPort));
}

vtkPolyData* vtkScalarPersistence::GetSaddles()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(SaddlesPort));
}

vtkPolyData* vtkScalarPersistence::GetCycleLines()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(CyclesPort));
}

vtkImageData* vtkScalarPersistence::GetSimplified()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(SimplifiedPort));
}

void vtkScalarPersistence::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Superlevel: " << this->GetSuperlevel() << "\n";
  os << indent << "MinimumPersistence: " << this->GetMinimumPersistence() << "\n";
  os << indent << "PersistenceUnit: " << this->GetPersistenceUnit() << "\n";
  os << indent << "AutomaticRange: " << this->AutomaticRange << "\n";
  os << indent << "Range: " << this->Range[0] << " " << this->Range[1] << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "Cycles: " << this->Cycles << "\n";
  os << indent << "MaximumNumberOfCycles: " << this->MaximumNumberOfCycles << "\n";
  os << indent << "Simplify: " << this->Simplify << "\n";
}
