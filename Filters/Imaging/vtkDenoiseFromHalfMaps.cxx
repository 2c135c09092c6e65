#include "vtkDenoiseFromHalfMaps.h"

#include "Core/AlgorithmGuard.h"
#include "Core/ImageExtent.h"
#include "Core/ImageScalars.h"
#include "Core/InnerAlgorithm.h"
#include "Core/NamedColumns.h"
#include "Core/RangeChecks.h"
#include "Core/SameNodes.h"
#include "Imaging/DenoisingArrays.h"
#include "Imaging/HalfMapAgreement.h"
#include "Imaging/LocalResolution.h"
#include "vtkDenoiseMap.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkDenoiseFromHalfMaps);

const std::vector<isthmus::OutputArray>& vtkDenoiseFromHalfMaps::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    ISTHMUS_DENOISING_ARRAY_ROWS,
    { 0, ArrayPlace::Points, "LocalResolution", 1, "length", ArrayChoice::None,
      "wavelength at which the correlation of the halves in a window of 24 nodes falls below "
      "0.5, between twice the spacing and the width of the window" },
    { 0, ArrayPlace::Field, "HalfMapCorrelation", 1, "", ArrayChoice::None,
      "of the halves: Pearson's, of means over blocks of 4^3 nodes without those where they "
      "are equal" },
  };
  return table;
}

namespace
{

vtkDataArray* CheckedScalars(vtkImageData* half, const char* which)
{
  vtkDataArray* scalars = half->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument(
      std::string("The ") + which + " half map has no scalars of one number at each node.");
  }
  if (scalars->GetNumberOfTuples() != half->GetNumberOfPoints())
  {
    throw std::invalid_argument(std::string("The ") + which + " half map has " +
      std::to_string(scalars->GetNumberOfTuples()) + " values for its " +
      std::to_string(half->GetNumberOfPoints()) + " nodes: it is damaged.");
  }
  isthmus::RequireUsualValues(scalars);
  return scalars;
}

/// The finite values minus their mean, scaled to at most about 1 by a power of two, so that they
/// are not lost in single precision; 0 for all others.
std::vector<float> CenteredValues(vtkDataArray* array)
{
  const auto count = static_cast<std::size_t>(array->GetNumberOfTuples());
  const auto valueAt = [array](std::size_t i)
  { return array->GetComponent(static_cast<vtkIdType>(i), 0); };
  double sum = 0.0, finite = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double value = valueAt(i);
    sum += std::isfinite(value) ? value : 0.0;
    finite += std::isfinite(value) ? 1.0 : 0.0;
  }
  const double mean = finite > 0.0 ? sum / finite : 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double value = valueAt(i);
    largest = std::isfinite(value) ? std::max(largest, std::abs(value - mean)) : largest;
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double value = valueAt(i);
    values[i] =
      std::isfinite(value) ? static_cast<float>(std::ldexp(value - mean, -exponent)) : 0.0f;
  }
  return values;
}

}

vtkDenoiseFromHalfMaps::vtkDenoiseFromHalfMaps()
{
  this->SetNumberOfInputPorts(2);
}

void vtkDenoiseFromHalfMaps::SetOtherHalfData(vtkImageData* half)
{
  this->SetInputData(1, half);
}

int vtkDenoiseFromHalfMaps::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkDenoiseFromHalfMaps::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  for (int port = 0; port < 2; ++port)
  {
    isthmus::RequestWholeExtent(input[port]->GetInformationObject(0));
  }
  return 1;
}

void vtkDenoiseFromHalfMaps::Denoise(vtkImageData* one, vtkImageData* other, vtkImageData* output)
{
  vtkDataArray* scalars = CheckedScalars(one, "first");
  vtkDataArray* others = CheckedScalars(other, "second");
  isthmus::RequireSameNodes(one, other);
  isthmus::Check(this->Parameters);
  const int* n = one->GetDimensions();
  const isthmus::HalfMapAgreement agreement =
    isthmus::CompareHalfMaps({ n[0], n[1], n[2] }, scalars, others);
  if (!agreement.Message().empty())
  {
    vtkWarningMacro(<< agreement.Message());
  }
  const vtkSmartPointer<vtkDataArray> alike = isthmus::RemoveLinearDifference(agreement, others);
  others = alike;
  constexpr char differenceName[] = "IsthmusHalfDifference";
  const isthmus::HalfMapMean halves = isthmus::AverageHalfMaps(scalars, others);
  halves.HalfDifference->SetName(differenceName);
  vtkNew<vtkImageData> volume;
  volume->CopyStructure(one);
  volume->GetFieldData()->PassData(one->GetFieldData());
  volume->GetPointData()->SetScalars(halves.Mean);
  volume->GetPointData()->AddArray(halves.HalfDifference);
  vtkNew<vtkDenoiseMap> denoising;
  denoising->SetInputData(volume);
  denoising->SetInputArrayToProcess(
    1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, differenceName);
  denoising->SetStrength(this->GetStrength());
  denoising->SetGoal(this->GetGoal());
  denoising->SetMaskInvalid(true);
  denoising->SetController(nullptr);      // every rank has all of the volume
  denoising->SetContainerAlgorithm(this); // aborted together with this filter
  isthmus::UpdateInner(denoising, isthmus::Between(isthmus::MakeProgress(this), 0.0, 0.7),
    [this](const std::string& warning) { vtkWarningMacro(<< warning); });
  isthmus::Report(isthmus::MakeProgress(this), 0.7); // throws if it was aborted
  const auto resolution =
    isthmus::ArrayOfType(VTK_FLOAT, "LocalResolution", scalars->GetNumberOfTuples());
  const double* spacing = one->GetSpacing();
  isthmus::FindLocalResolution({ n[0], n[1], n[2] }, { spacing[0], spacing[1], spacing[2] },
    CenteredValues(scalars), CenteredValues(others),
    vtkFloatArray::SafeDownCast(resolution)->GetPointer(0),
    isthmus::Between(isthmus::MakeProgress(this), 0.7, 1.0));
  isthmus::Report(isthmus::MakeProgress(this), 1.0);
  output->ShallowCopy(denoising->GetOutput());
  output->GetPointData()->RemoveArray(differenceName);
  output->GetPointData()->AddArray(resolution);
  isthmus::AddColumn<vtkDoubleArray>(
    output->GetFieldData(), "HalfMapCorrelation", { agreement.Correlation });
}

int vtkDenoiseFromHalfMaps::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  auto* image = vtkImageData::GetData(output);
  return isthmus::RunGuarded(this, output,
    [&]
    {
      auto* one = vtkImageData::GetData(input[0]);
      if (one->GetNumberOfPoints() > 0)
      {
        isthmus::RequireWholeExtent(input[0]->GetInformationObject(0));
        isthmus::RequireWholeExtent(input[1]->GetInformationObject(0));
        this->Denoise(one, vtkImageData::GetData(input[1]), image);
        isthmus::Extent piece{};
        image->GetExtent(piece.data());
        isthmus::CropTo(image, isthmus::GetPieceExtent(output->GetInformationObject(0), piece));
      }
    });
}

void vtkDenoiseFromHalfMaps::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Strength: " << this->Parameters.Strength << "\n";
  os << indent << "Goal: " << this->GetGoal() << "\n";
}
