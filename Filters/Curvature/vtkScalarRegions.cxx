#include "vtkScalarRegions.h"

#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/PolyDataTriangles.h"
#include "Curvature/RegionTables.h"
#include "Curvature/ScalarRegions.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkScalarRegions);

namespace
{

using isthmus::ThresholdedScalar;

/// Regions of points, then those of cells: the middle ones of their corners'.
struct Labels
{
  Labels(const ThresholdedScalar& scalar, vtkPolyData* surface, const char* name)
  {
    this->OnPoints->SetName(name);
    this->OnPoints->SetNumberOfValues(surface->GetNumberOfPoints());
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const double value = scalar.Values[static_cast<std::size_t>(i)];
      this->OnPoints->SetValue(i, static_cast<int>(scalar.RegionOf(value)));
    }
    this->OnCells->SetName(name);
    this->OnCells->SetNumberOfValues(surface->GetNumberOfCells());
    vtkNew<vtkIdList> corners;
    std::vector<int> regions;
    for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
    {
      surface->GetCellPoints(cell, corners);
      regions.clear();
      for (const vtkIdType corner : *corners)
      {
        regions.push_back(this->OnPoints->GetValue(corner));
      }
      const auto middle = regions.begin() + static_cast<std::ptrdiff_t>(regions.size()) / 2;
      std::nth_element(regions.begin(), middle, regions.end());
      this->OnCells->SetValue(cell, regions.empty() ? 0 : *middle);
    }
  }

  void AddTo(vtkPolyData* output) const
  {
    output->GetPointData()->AddArray(this->OnPoints);
    output->GetCellData()->AddArray(this->OnCells);
  }

  vtkNew<vtkIntArray> OnPoints;
  vtkNew<vtkIntArray> OnCells;
};

void AddJoint(
  vtkDataSetAttributes* attributes, vtkIntArray* first, vtkIntArray* second, std::size_t columns)
{
  vtkNew<vtkIntArray> joint;
  joint->SetName("JointRegion");
  joint->SetNumberOfValues(first->GetNumberOfValues());
  for (vtkIdType i = 0; i < first->GetNumberOfValues(); ++i)
  {
    joint->SetValue(i, first->GetValue(i) * static_cast<int>(columns) + second->GetValue(i));
  }
  attributes->AddArray(joint);
}

void AddToonColors(vtkPolyData* output, vtkIntArray* regions, std::size_t count)
{
  static constexpr unsigned char red[3] = { 205, 40, 40 };
  static constexpr unsigned char grey[3] = { 190, 190, 190 };
  static constexpr unsigned char blue[3] = { 40, 70, 205 };
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("ToonColor");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(regions->GetNumberOfValues());
  for (vtkIdType i = 0; i < regions->GetNumberOfValues(); ++i)
  {
    const int region = regions->GetValue(i);
    const bool highest = count > 1 && region + 1 == static_cast<int>(count);
    colors->SetTypedTuple(i, region == 0 && count > 1 ? red : highest ? blue : grey);
  }
  output->GetPointData()->AddArray(colors);
}

}

vtkScalarRegions::vtkScalarRegions()
{
  this->SetNumberOfOutputPorts(4);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  this->SetInputArrayToProcess(
    1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

int vtkScalarRegions::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

vtkTable* vtkScalarRegions::TableAt(int port)
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(port));
}

double vtkScalarRegions::At(const std::vector<double>& values, int index)
{
  const auto i = static_cast<std::size_t>(index);
  return index >= 0 && i < values.size() ? values[i] : 0.0;
}

void vtkScalarRegions::Put(std::vector<double>& values, int index, double value)
{
  if (index < 0)
  {
    vtkErrorMacro(<< "There is no threshold " << index << ": they are counted from 0.");
    return;
  }
  const auto i = static_cast<std::size_t>(index);
  if (i >= values.size())
  {
    values.resize(i + 1, 0.0);
  }
  values[i] = value;
  this->Modified();
}

void vtkScalarRegions::Resize(std::vector<double>& values, int number)
{
  values.resize(static_cast<std::size_t>(std::max(number, 0)), 0.0);
  this->Modified();
}

void vtkScalarRegions::SetNumberOfThresholds(int number)
{
  this->Resize(this->Thresholds, number);
}

void vtkScalarRegions::SetThreshold(int index, double value)
{
  this->Put(this->Thresholds, index, value);
}

void vtkScalarRegions::SetNumberOfSecondThresholds(int number)
{
  this->Resize(this->SecondThresholds, number);
}

void vtkScalarRegions::SetSecondThreshold(int index, double value)
{
  this->Put(this->SecondThresholds, index, value);
}

int vtkScalarRegions::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  const auto clearTables = [&]()
  {
    for (const int port : { 1, 2, 3 })
    {
      vtkTable::GetData(outputVector, port)->Initialize();
    }
  };
  clearTables();
  const int result = isthmus::Guarded(this, output,
    [&]()
    {
      const auto input = isthmus::GatherSurface(this, vtkPolyData::GetData(inputVector[0], 0));
      output->ShallowCopy(input);
      if (input->GetNumberOfCells() > 0)
      {
        this->Compute(input, output);
      }
    });
  if (output->GetNumberOfCells() == 0)
  {
    clearTables(); // an error or a stop after the first of them
  }
  return result;
}

ThresholdedScalar vtkScalarRegions::Scalar(int index, vtkPolyData* input, std::string& name)
{
  const std::string which = index == 0 ? "first" : "second";
  // A panel that has seen no data yet sends an empty name: the active scalars are meant then.
  const char* chosen = this->GetInputArrayInformation(index)->Get(vtkDataObject::FIELD_NAME());
  vtkDataArray* array = chosen && !*chosen ? input->GetPointData()->GetScalars()
                                           : this->GetInputArrayToProcess(index, input);
  if (!array)
  {
    throw std::invalid_argument("The surface has no such array for the " + which +
      " scalar: choose one of its point arrays (active scalars by default).");
  }
  name = array->GetName() ? array->GetName() : which;
  if (array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    throw std::invalid_argument("The " + which + " scalar, " + name +
      ", is not one number for each point: choose a point array of one component.");
  }
  ThresholdedScalar scalar;
  scalar.Thresholds = index == 0 ? this->Thresholds : this->SecondThresholds;
  scalar.Values.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    scalar.Values[static_cast<std::size_t>(i)] = array->GetComponent(i, 0);
  }
  return scalar;
}

void vtkScalarRegions::Compute(vtkPolyData* input, vtkPolyData* output)
{
  std::string name, secondName;
  const ThresholdedScalar first = this->Scalar(0, input, name);
  const ThresholdedScalar second = this->UseSecondScalar ? this->Scalar(1, input, secondName)
                                                         : ThresholdedScalar{ first.Values, {} };
  const auto rule = static_cast<isthmus::AreaRule>(this->AreaRule);
  const isthmus::PolyDataTriangles triangles(input);
  const isthmus::SurfaceView mesh = triangles.View();
  const std::vector<double> areas = isthmus::RegionAreas(
    mesh, first, second, rule, isthmus::Between(isthmus::ProgressOf(this), 0.1, 0.5));
  isthmus::FillRegionTable(this->TableAt(1), first, second, secondName, areas);
  if (this->SweepSteps > 0)
  {
    isthmus::FillSweepTable(
      this->TableAt(2), mesh, first, this->SweepTarget, this->SweepSteps, rule);
  }
  isthmus::FillHistogram(this->TableAt(3), mesh, first, this->HistogramBins, rule);
  isthmus::Report(isthmus::ProgressOf(this), 0.8);

  output->BuildCells();
  const Labels labels(first, output, "Region");
  labels.AddTo(output);
  output->GetPointData()->SetActiveScalars("Region");
  AddToonColors(output, labels.OnPoints, first.Regions());
  if (this->UseSecondScalar)
  {
    const Labels others(second, output, "SecondRegion");
    others.AddTo(output);
    AddJoint(output->GetPointData(), labels.OnPoints, others.OnPoints, second.Regions());
    AddJoint(output->GetCellData(), labels.OnCells, others.OnCells, second.Regions());
  }
}

void vtkScalarRegions::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto list = [&](const char* name, const std::vector<double>& values)
  {
    os << indent << name << ":";
    for (const double value : values)
    {
      os << " " << value;
    }
    os << "\n";
  };
  list("Thresholds", this->Thresholds);
  list("SecondThresholds", this->SecondThresholds);
  os << indent << "UseSecondScalar: " << this->UseSecondScalar << "\n";
  os << indent << "AreaRule: " << this->AreaRule << "\n";
  os << indent << "SweepSteps: " << this->SweepSteps << "\n";
  os << indent << "SweepTarget: " << this->SweepTarget << "\n";
  os << indent << "HistogramBins: " << this->HistogramBins << "\n";
}
