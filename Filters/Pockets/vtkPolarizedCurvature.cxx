#include "vtkPolarizedCurvature.h"

#include "Core/AlgorithmGuard.h"
#include "Core/ImageExtent.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Pockets/PolarizedCurvature.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkPolarizedCurvature);

namespace
{

/// `array` itself if it is a plain double array (or a vtkFloatArray), otherwise a copy of this
/// type.
template <typename Array>
vtkSmartPointer<Array> ToPlainArray(vtkDataArray* array)
{
  auto plain = vtkSmartPointer<Array>::New();
  plain->ShallowCopy(array);
  return plain;
}

template <typename Array>
void SampleAs(vtkImageData* image, vtkDataArray* scalars, const double* points, vtkIdType count,
  double* values, const isthmus::ProgressCallback& progress)
{
  using T = typename Array::ValueType;
  const auto plain = ToPlainArray<Array>(scalars);
  isthmus::GridView<const T> grid;
  grid.Data = plain->GetPointer(0);
  isthmus::GridTransform toGrid{};
  for (int a = 0; a < 3; ++a)
  {
    grid.Dimensions[static_cast<std::size_t>(a)] = image->GetDimensions()[a];
    for (int i = 0; i < 4; ++i)
    {
      toGrid[static_cast<std::size_t>(4 * a + i)] =
        image->GetPhysicalToIndexMatrix()->GetElement(a, i) -
        (i == 3 ? image->GetExtent()[2 * a] : 0);
    }
  }
  isthmus::SamplePotential(grid, toGrid, points, count, values, progress);
}

void AddSiteClassNames(vtkFieldData* fields)
{
  isthmus::AddComputedColumn<vtkStringArray>(fields, "SiteClassNames", isthmus::NumberOfSiteClasses,
    [](std::size_t site) { return isthmus::SiteClassName(static_cast<isthmus::SiteClass>(site)); });
}

void CheckScalar(vtkDataArray* array, vtkDataSet* data, const char* what)
{
  if (array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != data->GetNumberOfPoints())
  {
    throw std::invalid_argument("The array for the " + std::string(what) +
      " does not have one number for each point: choose another.");
  }
}

template <typename Array>
Array* NewPointArray(vtkPolyData* output, const char* name)
{
  return isthmus::AddArray<Array>(
    output->GetPointData(), name, static_cast<std::size_t>(output->GetNumberOfPoints()));
}

}

const std::vector<isthmus::OutputArray>& vtkPolarizedCurvature::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Potential", 1, "kT/e", ArrayChoice::None,
      "in the unit of the image; NaN at points off the grid" },
    { 0, ArrayPlace::Points, "PositivePotentialKappa1", 1, "kT/(e length)", ArrayChoice::None,
      "max(Phi, 0) kappa_1" },
    { 0, ArrayPlace::Points, "PositivePotentialKappa2", 1, "kT/(e length)", ArrayChoice::None,
      "max(Phi, 0) kappa_2" },
    { 0, ArrayPlace::Points, "NegativePotentialKappa1", 1, "kT/(e length)", ArrayChoice::None,
      "min(Phi, 0) kappa_1" },
    { 0, ArrayPlace::Points, "NegativePotentialKappa2", 1, "kT/(e length)", ArrayChoice::None,
      "min(Phi, 0) kappa_2" },
    { 0, ArrayPlace::Points, "PolarizedCurvature", 1, "kT/(e length)", ArrayChoice::None,
      "Phi kappa_2" },
    { 0, ArrayPlace::Points, "SiteClass", 1, "", ArrayChoice::None,
      "0 none; site for a negatively charged protein 1 (Phi > 0, kappa_1 > 0), a negatively "
      "charged ligand 2 (Phi > 0, kappa_2 < 0), a positively charged protein 3 (Phi < 0, "
      "kappa_1 > 0), a positively charged ligand 4 (Phi < 0, kappa_2 < 0); a saddle has the "
      "class of its larger amplitude" },
    { 0, ArrayPlace::Points, "PotentialValid", 1, "", ArrayChoice::None,
      "0 if the point lies off the grid or a value around it is not finite" },
    { 0, ArrayPlace::Field, "SiteClassNames", 1, "", ArrayChoice::None, "of SiteClass" },
  };
  return table;
}

vtkPolarizedCurvature::vtkPolarizedCurvature()
{
  this->SetNumberOfInputPorts(2);
  constexpr int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  this->SetInputArrayToProcess(0, 0, 0, points, "MaximumCurvature");
  this->SetInputArrayToProcess(1, 0, 0, points, "MinimumCurvature");
  this->SetInputArrayToProcess(2, 0, 0, points, "Potential");
}

int vtkPolarizedCurvature::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

void vtkPolarizedCurvature::SetPotentialData(vtkImageData* image)
{
  this->SetInputData(1, image);
}

vtkDataArray* vtkPolarizedCurvature::Scalar(
  int index, vtkPolyData* surface, const char* what, const char* remedy)
{
  vtkDataArray* array = this->GetInputArrayToProcess(index, surface);
  if (!array)
  {
    const char* name = this->GetInputArrayInformation(index)->Get(vtkDataObject::FIELD_NAME());
    throw std::invalid_argument("There is no point array for the " + std::string(what) +
      (name ? ", " + std::string(name) : std::string()) + ": " + remedy);
  }
  CheckScalar(array, surface, what);
  return array;
}

int vtkPolarizedCurvature::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // Any part of the image may be needed, since the surface's piece may lie anywhere.
  if (vtkInformation* image = inputVector[1]->GetInformationObject(0))
  {
    isthmus::RequestWholeExtent(image);
  }
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

int vtkPolarizedCurvature::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      vtkPolyData* surface = vtkPolyData::GetData(inputVector[0]);
      vtkImageData* image = vtkImageData::GetData(inputVector[1]);
      isthmus::RequireFinitePositions(surface, "the surface");
      isthmus::RequireRange("ClassThreshold", this->ClassThreshold, 0.0, isthmus::Unlimited,
        "It is in kT/(e angstrom).");
      output->ShallowCopy(surface);
      if (surface->GetNumberOfPoints() == 0)
      {
        return;
      }
      const auto potential = isthmus::NamedArray<vtkDoubleArray>(
        "Potential", static_cast<std::size_t>(surface->GetNumberOfPoints()));
      image ? this->Sample(surface, image, potential) : this->Copy(surface, potential);
      this->AddProducts(surface, potential, output);
    });
}

void vtkPolarizedCurvature::Copy(vtkPolyData* surface, vtkDoubleArray* potential)
{
  vtkDataArray* array = this->Scalar(2, surface, "potential",
    "give the potential as an image on the second input, or as a point array of the surface.");
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double value = array->GetComponent(i, 0);
    potential->SetValue(i, std::isfinite(value) ? value : std::nan(""));
  }
  this->CheckValid(potential,
    "No value of the potential is a finite number: choose another point array of the surface.",
    "have a potential that is not a finite number");
}

void vtkPolarizedCurvature::Sample(
  vtkPolyData* surface, vtkImageData* image, vtkDoubleArray* potential)
{
  vtkDataArray* scalars = image->GetPointData()->GetArray(this->PotentialArrayName.c_str());
  // A name that is not the default was chosen.
  const bool isChosen = this->PotentialArrayName != "Potential";
  scalars = scalars || isChosen ? scalars : image->GetPointData()->GetScalars();
  if (!scalars && isChosen)
  {
    throw std::invalid_argument("The image has no point array " + this->PotentialArrayName +
      ": set PotentialArrayName to one of the image's point arrays.");
  }
  if (!scalars)
  {
    throw std::invalid_argument("The image has neither a point array " + this->PotentialArrayName +
      " nor scalars: set PotentialArrayName to one of the image's point arrays.");
  }
  CheckScalar(scalars, image, "potential");
  isthmus::RequireUsualValues(scalars);
  const vtkIdType count = surface->GetNumberOfPoints();
  const auto points = ToPlainArray<vtkDoubleArray>(surface->GetPoints()->GetData());
  const auto sample =
    scalars->GetDataType() == VTK_FLOAT ? &SampleAs<vtkFloatArray> : &SampleAs<vtkDoubleArray>;
  sample(image, scalars, points->GetPointer(0), count, potential->GetPointer(0),
    isthmus::Between(isthmus::MakeProgress(this), 0.0, 0.7));
  this->CheckValid(potential,
    "The potential does not overlap the surface: none of the surface's points lies in the image. "
    "Are both of the same molecule, in the same unit of length?",
    "lie outside the grid of the potential (or at values that are not finite)");
}

void vtkPolarizedCurvature::CheckValid(
  vtkDoubleArray* potential, const char* ifNone, const char* where)
{
  const vtkIdType count = potential->GetNumberOfValues();
  const double* values = potential->GetPointer(0);
  const auto off =
    std::count_if(values, values + count, [](double value) { return std::isnan(value); });
  if (off == count)
  {
    throw std::invalid_argument(ifNone);
  }
  if (off > 0)
  {
    vtkWarningMacro(<< isthmus::JoinText(off, " of ", count, " points of the surface ", where,
                      ": PotentialValid is 0 there and the products are NaN."));
  }
}

void vtkPolarizedCurvature::AddProducts(
  vtkPolyData* surface, vtkDoubleArray* potential, vtkPolyData* output)
{
  const char* remedy = "run Surface Curvature or Hessian Curvature on the surface first.";
  const auto kappa1 =
    ToPlainArray<vtkDoubleArray>(this->Scalar(0, surface, "maximum curvature", remedy));
  const auto kappa2 =
    ToPlainArray<vtkDoubleArray>(this->Scalar(1, surface, "minimum curvature", remedy));
  output->GetPointData()->AddArray(potential);
  auto* positive1 = NewPointArray<vtkDoubleArray>(output, "PositivePotentialKappa1");
  auto* positive2 = NewPointArray<vtkDoubleArray>(output, "PositivePotentialKappa2");
  auto* negative1 = NewPointArray<vtkDoubleArray>(output, "NegativePotentialKappa1");
  auto* negative2 = NewPointArray<vtkDoubleArray>(output, "NegativePotentialKappa2");
  auto* combined = NewPointArray<vtkDoubleArray>(output, "PolarizedCurvature");
  auto* site = NewPointArray<vtkUnsignedCharArray>(output, "SiteClass");
  auto* valid = NewPointArray<vtkUnsignedCharArray>(output, "PotentialValid");
  const auto body = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType i = first; i < last; ++i)
    {
      const double phi = potential->GetValue(i);
      const isthmus::PolarizedPoint point =
        isthmus::Polarize(phi, kappa1->GetValue(i), kappa2->GetValue(i), this->ClassThreshold);
      positive1->SetValue(i, point.PositiveKappa1);
      positive2->SetValue(i, point.PositiveKappa2);
      negative1->SetValue(i, point.NegativeKappa1);
      negative2->SetValue(i, point.NegativeKappa2);
      combined->SetValue(i, point.CombineSurfaces);
      site->SetValue(i, static_cast<unsigned char>(point.Site));
      valid->SetValue(i, std::isnan(phi) ? 0 : 1);
    }
  };
  isthmus::ParallelFor(0, surface->GetNumberOfPoints(), 4096, body,
    isthmus::Between(isthmus::MakeProgress(this), 0.7, 1.0));
  output->GetPointData()->SetActiveScalars("PolarizedCurvature");
  AddSiteClassNames(output->GetFieldData());
}

void vtkPolarizedCurvature::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PotentialArrayName: " << this->PotentialArrayName << "\n";
  os << indent << "ClassThreshold: " << this->ClassThreshold << "\n";
}
