#include "vtkDiffusionAlgorithm.h"

#include "AlgorithmGuard.h"
#include "DiffusionImage.h"
#include "RankParts.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiProcessController.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <stdexcept>

vtkCxxSetObjectMacro(vtkDiffusionAlgorithm, Controller, vtkMultiProcessController);

namespace
{

/// Integers of up to 16 bits are exact in float.
bool FitsFloat(vtkDataArray* array)
{
  return array->GetDataType() == VTK_FLOAT ||
    (array->GetDataType() != VTK_DOUBLE && array->GetDataTypeSize() <= 2);
}

/// Progress that is shown, and stops on all ranks if it stops on one.
isthmus::ProgressCallback SharedProgress(
  const isthmus::ProgressCallback& own, const isthmus::RankParts& parts)
{
  if (!parts.Distributed())
  {
    return own;
  }
  return [own, &parts](double fraction)
  {
    double stops = own(fraction) ? 0.0 : 1.0;
    parts.Sum(&stops, 1);
    return stops == 0.0;
  };
}

/// Throws on all ranks if `holds` is false on one.
void RequireOnAllRanks(bool holds, const isthmus::RankParts& parts, const char* sentence)
{
  double broken = holds ? 0.0 : 1.0;
  parts.Sum(&broken, 1);
  if (broken > 0.0)
  {
    throw std::invalid_argument(sentence);
  }
}

void CheckScalars(vtkImageData* input, vtkDataArray* scalars, const isthmus::RankParts& parts)
{
  isthmus::Extent available;
  input->GetExtent(available.data());
  const bool empty = isthmus::NodeCount(parts.Local()) == 0;
  RequireOnAllRanks(empty || isthmus::Contains(available, parts.Local()), parts,
    "The input did not deliver the part of the image that this rank asked for.");
  RequireOnAllRanks(empty || scalars, parts,
    "The input has no point array to work on: choose one with SetInputArrayToProcess.");
}

}

vtkDiffusionAlgorithm::vtkDiffusionAlgorithm()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkDiffusionAlgorithm::~vtkDiffusionAlgorithm()
{
  this->SetController(nullptr);
}

int vtkDiffusionAlgorithm::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* output = outputs->GetInformationObject(0);
  // Neither type nor range of the output is known before the input has been seen.
  output->CopyEntry(
    inputs[0]->GetInformationObject(0), vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  return 1;
}

int vtkDiffusionAlgorithm::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  isthmus::Extent whole, wanted;
  input->Get(Pipeline::WHOLE_EXTENT(), whole.data());
  outputs->GetInformationObject(0)->Get(Pipeline::UPDATE_EXTENT(), wanted.data());
  if (!this->Controller || this->Controller->GetNumberOfProcesses() == 1)
  {
    wanted = whole; // every node depends on all others in the end
  }
  else if (isthmus::NodeCount(wanted) > 0)
  {
    const int halo = this->HaloWidth();
    wanted = isthmus::Grown(wanted, { halo, halo, halo }, whole);
  }
  input->Set(Pipeline::UPDATE_EXTENT(), wanted.data(), 6);
  return 1;
}

int vtkDiffusionAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkImageData* output = vtkImageData::GetData(outputs);
  isthmus::Extent whole, own;
  inputs[0]->GetInformationObject(0)->Get(Pipeline::WHOLE_EXTENT(), whole.data());
  outputs->GetInformationObject(0)->Get(Pipeline::UPDATE_EXTENT(), own.data());
  if (isthmus::NodeCount(whole) == 0)
  {
    output->Initialize();
    return 1;
  }
  if (!this->Controller || this->Controller->GetNumberOfProcesses() == 1)
  {
    input->GetExtent(own.data());
  }
  return isthmus::Guarded(this, output,
    [&]()
    {
      const isthmus::RankParts parts(this->Controller, whole, own, this->HaloWidth());
      vtkDataArray* scalars = this->GetInputArrayToProcess(0, inputs);
      CheckScalars(input, scalars, parts);
      output->ShallowCopy(input);
      output->Crop(own.data());
      double anyDouble = scalars && !FitsFloat(scalars) ? 1.0 : 0.0;
      parts.Sum(&anyDouble, 1); // a rank without nodes has no array to tell it
      if (anyDouble > 0.0)
      {
        this->Compute<double>(input, output, parts);
      }
      else
      {
        this->Compute<float>(input, output, parts);
      }
    });
}

template <typename T>
void vtkDiffusionAlgorithm::Compute(
  vtkImageData* input, vtkImageData* output, const isthmus::RankParts& parts)
{
  isthmus::DiffusionImage<T> image(
    input, output, parts, this->VoxelUnits, SharedProgress(isthmus::ProgressOf(this), parts));
  this->Process(image);
}

void vtkDiffusionAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VoxelUnits: " << this->VoxelUnits << '\n';
  os << indent << "MaskInvalid: " << this->MaskInvalid << '\n';
  os << indent << "Controller: " << this->Controller << '\n';
}
