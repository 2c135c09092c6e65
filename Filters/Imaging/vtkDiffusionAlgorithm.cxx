#include "vtkDiffusionAlgorithm.h"

#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/ImageExtent.h"
#include "Core/ImageScalars.h"
#include "Imaging/DiffusionImage.h"
#include "Imaging/DomainDecomposition.h"

#include <vtkCommunicator.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiProcessController.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <stdexcept>
#include <string>

vtkCxxSetObjectMacro(vtkDiffusionAlgorithm, Controller, vtkMultiProcessController);

namespace
{

/// Progress that is shown, and stops on all ranks if it stops on one.
isthmus::ProgressCallback SharedProgress(
  const isthmus::ProgressCallback& own, const isthmus::DomainDecomposition& parts)
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
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  // The whole image, since every node depends on all others in the end. Of the pieces of several
  // ranks the source splits it, and halos are exchanged instead of requested; pieces that one
  // process requests one after the other (streaming) have no others to exchange with.
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  if (!this->IsParallel())
  {
    isthmus::RequestWholeExtent(input);
  }
  else if (input->Has(Pipeline::WHOLE_EXTENT()))
  {
    input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  return 1;
}

bool vtkDiffusionAlgorithm::IsParallel() const
{
  return this->Controller && this->Controller->GetNumberOfProcesses() > 1;
}

std::array<int, 6> vtkDiffusionAlgorithm::OwnPart(
  vtkImageData* input, vtkInformation* request, const std::array<int, 6>& whole)
{
  isthmus::Extent delivered;
  input->GetExtent(delivered.data());
  if (!this->IsParallel())
  {
    return delivered;
  }
  const isthmus::Extent piece = isthmus::GetPieceExtent(request, whole);
  const int fits = isthmus::Contains(delivered, piece);
  int allFit = 0;
  this->Controller->AllReduce(&fits, &allFit, 1, vtkCommunicator::MIN_OP);
  return allFit ? piece : delivered; // a source may have its own way of splitting
}

int vtkDiffusionAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkImageData* output = vtkImageData::GetData(outputs);
  const isthmus::Extent whole =
    isthmus::ReadExtent(inputs[0]->GetInformationObject(0), Pipeline::WHOLE_EXTENT());
  if (isthmus::NodeCount(whole) == 0)
  {
    output->Initialize();
    return 1;
  }
  return isthmus::RunGuarded(this, outputs,
    [&]()
    {
      isthmus::RequireNoBlocks(this);
      isthmus::Extent own = this->OwnPart(input, outputs->GetInformationObject(0), whole);
      const isthmus::DomainDecomposition parts(this->Controller, whole, own, this->HaloWidth());
      vtkDataArray* scalars = this->ScalarsOnAllRanks(input, parts);
      output->ShallowCopy(input);
      isthmus::CropTo(output, own);
      double anyDouble = scalars && !isthmus::FitsFloat(scalars) ? 1.0 : 0.0;
      parts.Sum(&anyDouble, 1); // a rank without nodes has no array
      if (anyDouble > 0.0)
      {
        this->Compute<double>(input, output, parts);
      }
      else
      {
        this->Compute<float>(input, output, parts);
      }
      if (!this->IsParallel())
      {
        isthmus::CropTo(output, isthmus::GetPieceExtent(outputs->GetInformationObject(0), own));
      }
    });
}

vtkDataArray* vtkDiffusionAlgorithm::ChosenScalars(vtkImageData* image)
{
  return image->GetNumberOfPoints() == 0 ? nullptr : isthmus::ChosenScalars(this, image);
}

vtkDataArray* vtkDiffusionAlgorithm::ScalarsOnAllRanks(
  vtkImageData* image, const isthmus::DomainDecomposition& parts)
{
  vtkDataArray* scalars = nullptr;
  std::string complaint;
  try
  {
    scalars = this->ChosenScalars(image);
  }
  catch (const std::invalid_argument& error)
  {
    complaint = error.what();
  }
  double refusals = complaint.empty() ? 0.0 : 1.0;
  parts.Sum(&refusals, 1);
  if (refusals > 0.0)
  {
    throw std::invalid_argument(
      complaint.empty() ? "Another rank has no input array: see its message." : complaint);
  }
  return scalars;
}

template <typename T>
void vtkDiffusionAlgorithm::Compute(
  vtkImageData* input, vtkImageData* output, const isthmus::DomainDecomposition& parts)
{
  isthmus::DiffusionImage<T> image(
    input, output, parts, this->VoxelUnits, SharedProgress(isthmus::MakeProgress(this), parts));
  this->Process(image);
}

void vtkDiffusionAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaskInvalid: " << this->MaskInvalid << '\n';
  os << indent << "Controller: " << this->Controller << '\n';
}
