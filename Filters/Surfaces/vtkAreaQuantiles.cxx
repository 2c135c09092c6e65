#include "vtkAreaQuantiles.h"

#include "Core/AlgorithmGuard.h"
#include "Core/NamedColumns.h"
#include "Core/PolyDataTriangles.h"
#include "Core/RangeChecks.h"
#include "Surfaces/AreaQuantiles.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkAreaQuantiles);

const std::vector<isthmus::OutputArray>& vtkAreaQuantiles::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Rows, "Range", 1, "of the array", ArrayChoice::None,
      "the quantiles Lower and Upper by area" },
  };
  return table;
}

namespace
{

/// The weight of each value of an array on points or cells.
std::vector<double> Weights(vtkDataSet* data, int association)
{
  const bool onPoints = association == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const vtkIdType count = onPoints ? data->GetNumberOfPoints() : data->GetNumberOfCells();
  auto* surface = vtkPolyData::SafeDownCast(data);
  if (!surface || surface->GetNumberOfPolys() + surface->GetNumberOfStrips() == 0)
  {
    return std::vector<double>(static_cast<std::size_t>(count), 1.0);
  }
  const isthmus::PolyDataTriangles triangles(surface);
  const isthmus::SurfaceView view = triangles.View();
  if (onPoints)
  {
    return isthmus::PointAreas(view);
  }
  std::vector<double> weights(static_cast<std::size_t>(count), 0.0);
  for (vtkIdType t = 0; t < view.NumberOfTriangles(); ++t)
  {
    weights[isthmus::At(triangles.GetCellId(t))] += isthmus::TriangleArea(view, t);
  }
  return weights;
}

}

vtkAreaQuantiles::vtkAreaQuantiles()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

int vtkAreaQuantiles::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

int vtkAreaQuantiles::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  auto* data = vtkDataSet::GetData(input[0]);
  auto* table = vtkTable::GetData(output);
  return isthmus::RunGuarded(this, output,
    [&]
    {
      isthmus::RequireRange("Lower", this->Lower, 0.0, 1.0);
      isthmus::RequireRange("Upper", this->Upper, 0.0, 1.0);
      if (data->GetNumberOfPoints() == 0)
      {
        return;
      }
      int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
      vtkDataArray* array = this->GetInputArrayToProcess(0, data, association);
      if (!array || array->GetNumberOfComponents() != 1)
      {
        throw std::invalid_argument("There is no array of one component for the quantiles.");
      }
      const bool onPoints = association == vtkDataObject::FIELD_ASSOCIATION_POINTS;
      vtkDataArray* valid = onPoints ? data->GetPointData()->GetArray("CurvatureValid") : nullptr;
      const std::vector<double> weights = Weights(data, association);
      if (array->GetNumberOfTuples() != static_cast<vtkIdType>(weights.size()))
      {
        throw std::invalid_argument("The array does not have one number for each point or cell.");
      }
      std::vector<isthmus::WeightedValue> values;
      for (std::size_t i = 0; i < weights.size(); ++i)
      {
        const auto id = static_cast<vtkIdType>(i);
        const double value = array->GetComponent(id, 0);
        if (weights[i] > 0.0 && std::isfinite(value) &&
          (!valid || valid->GetComponent(id, 0) != 0.0))
        {
          values.emplace_back(value, weights[i]);
        }
      }
      if (values.empty())
      {
        return;
      }
      std::sort(values.begin(), values.end());
      isthmus::AddColumn<vtkDoubleArray>(table->GetRowData(), "Range",
        { isthmus::WeightedQuantile(values, this->Lower),
          isthmus::WeightedQuantile(values, this->Upper) });
    });
}

void vtkAreaQuantiles::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lower: " << this->Lower << "\n";
  os << indent << "Upper: " << this->Upper << "\n";
}
