#include "vtkHessianCurvature.h"

#include "Core/AlgorithmGuard.h"
#include "Core/ImageExtent.h"
#include "Core/ImageScalars.h"
#include "Core/NumberText.h"
#include "Core/RangeChecks.h"
#include "Curvature/CurvatureOfImage.h"
#include "Curvature/FiniteDifference.h"
#include "Curvature/GaussianSmoothing.h"

#include <vtkDataArray.h>
#include <vtkDataObjectTypes.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkHessianCurvature);

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Nodes needed around a node or a point: those of the differences (twice their radius at a point),
/// and those of the smoothing before. Parameters are checked later, when there is data.
std::array<int, 3> ReachOf(int accuracy, double scale, bool atPoints, vtkInformation* imageInfo)
{
  std::array<double, 3> spacing{ 1.0, 1.0, 1.0 };
  if (imageInfo->Has(vtkDataObject::SPACING()))
  {
    imageInfo->Get(vtkDataObject::SPACING(), spacing.data());
  }
  const int radius = accuracy == 4 ? 2 : 1;
  std::array<int, 3> reach = isthmus::GaussianReach(scale, spacing.data());
  for (int& nodes : reach)
  {
    nodes += atPoints ? 2 * radius : radius;
  }
  return reach;
}

/// Takes off what was asked for beyond the piece. A volume that its source has not split (all of it
/// on one rank, or parts by another rule) stays whole: all of it is this rank's.
void CropToPiece(vtkImageData* image, vtkInformation* outInfo)
{
  const isthmus::Extent piece =
    isthmus::PieceOf(outInfo, isthmus::ExtentOf(outInfo, Pipeline::UPDATE_EXTENT()));
  isthmus::Extent extent{};
  image->GetExtent(extent.data());
  const bool split = Pipeline::GetUpdateNumberOfPieces(outInfo) <= 1 ||
    image->GetPointGhostArray() || image->GetCellGhostArray();
  if (split && isthmus::Contains(extent, piece))
  {
    isthmus::CropTo(image, piece);
  }
}

void CheckNotNegative(double value, const char* name, const char* meaning)
{
  if (!(value >= 0.0) || std::isinf(value))
  {
    throw std::invalid_argument(
      std::string(name) + " is " + isthmus::FormatNumber(value) + ", but it is " + meaning + ".");
  }
}

isthmus::HessianCurvatureOptions OptionsOf(vtkHessianCurvature* filter)
{
  isthmus::HessianCurvatureOptions options;
  options.Accuracy = filter->GetAccuracy();
  options.InsideIsHigher = filter->GetInsideIsHigher() != 0;
  options.Convention =
    static_cast<isthmus::ShapeIndexConvention>(filter->GetShapeIndexConvention());
  options.Tolerance.Flat = filter->GetFlatTolerance();
  options.Tolerance.Gaussian = filter->GetGaussianTolerance();
  options.Tolerance.Mean = filter->GetMeanTolerance();
  return options;
}

isthmus::CurvatureSelection SelectionOf(vtkHessianCurvature* filter)
{
  isthmus::CurvatureSelection selection;
  selection.Gaussian = filter->GetGenerateGaussianCurvature() != 0;
  selection.Mean = filter->GetGenerateMeanCurvature() != 0;
  selection.Maximum = filter->GetGenerateMaximumCurvature() != 0;
  selection.Minimum = filter->GetGenerateMinimumCurvature() != 0;
  selection.ShapeIndex = filter->GetGenerateShapeIndex() != 0;
  selection.Curvedness = filter->GetGenerateCurvedness() != 0;
  selection.Direction1 = filter->GetGeneratePrincipalDirection1() != 0;
  selection.Direction2 = filter->GetGeneratePrincipalDirection2() != 0;
  selection.SurfaceType = filter->GetGenerateSurfaceType() != 0;
  return selection;
}

}

vtkHessianCurvature::vtkHessianCurvature()
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

int vtkHessianCurvature::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkImageData" : "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkHessianCurvature::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const bool atPoints = inputVector[1]->GetNumberOfInformationObjects() > 0;
  const char* type = atPoints ? "vtkPolyData" : "vtkImageData";
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkDataObject* output = vtkDataObject::GetData(outInfo);
  if (!output || !output->IsA(type))
  {
    vtkSmartPointer<vtkDataObject> made =
      vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(type));
    outInfo->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

int vtkHessianCurvature::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->MoreLayers = 0;
  if (inputVector[1]->GetNumberOfInformationObjects() > 0)
  {
    outputVector->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  }
  return 1;
}

int vtkHessianCurvature::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkInformation* imageInfo = inputVector[0]->GetInformationObject(0);
  const bool atPoints = inputVector[1]->GetNumberOfInformationObjects() > 0;
  const std::array<int, 3> reach = ReachOf(this->Accuracy, this->Scale, atPoints, imageInfo);
  const isthmus::Extent whole = isthmus::ExtentOf(imageInfo, Pipeline::WHOLE_EXTENT());
  const isthmus::Extent wanted = atPoints
    ? whole
    : isthmus::Grown(isthmus::ExtentOf(outInfo, Pipeline::UPDATE_EXTENT()), reach, whole);
  imageInfo->Set(Pipeline::UPDATE_EXTENT(), wanted.data(), 6);
  // Of several pieces, the extent is that of all; the source splits it and adds the ghost layers.
  if (Pipeline::GetUpdateNumberOfPieces(outInfo) > 1)
  {
    const int layers =
      Pipeline::GetUpdateGhostLevel(outInfo) + *std::max_element(reach.begin(), reach.end());
    imageInfo->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), std::max(layers, this->MoreLayers));
  }
  return 1;
}

bool vtkHessianCurvature::NeedsLargerExtent(vtkInformation* request, vtkInformation* imageInfo,
  vtkInformation* pointsInfo, vtkInformation* outInfo)
{
  vtkImageData* image = vtkImageData::GetData(imageInfo);
  const isthmus::Extent whole = isthmus::ExtentOf(imageInfo, Pipeline::WHOLE_EXTENT());
  // Points have no extent of their own; usually they lie in their rank's part of the image.
  const isthmus::Extent piece = isthmus::PieceOf(
    outInfo, pointsInfo ? whole : isthmus::ExtentOf(outInfo, Pipeline::UPDATE_EXTENT()));
  if (this->MoreLayers > 0 || Pipeline::GetUpdateNumberOfPieces(outInfo) <= 1 ||
    isthmus::IsEmpty(piece))
  {
    request->Remove(Pipeline::CONTINUE_EXECUTING());
    this->MoreLayers = 0;
    return false;
  }
  const std::array<int, 3> reach =
    ReachOf(this->Accuracy, this->Scale, pointsInfo != nullptr, imageInfo);
  isthmus::Extent needed = isthmus::Grown(piece, reach, whole);
  if (pointsInfo)
  {
    vtkPolyData* surface = vtkPolyData::GetData(pointsInfo);
    needed = surface->GetNumberOfPoints() > 0
      ? isthmus::Covering(image, surface->GetBounds(), reach, whole)
      : isthmus::Extent{ 0, -1, 0, -1, 0, -1 };
  }
  isthmus::Extent delivered{};
  image->GetExtent(delivered.data());
  if (isthmus::Contains(delivered, needed))
  {
    return false;
  }
  this->MoreLayers = std::max(1, isthmus::LayersBetween(piece, needed)); // once is enough
  request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
  return true;
}

void vtkHessianCurvature::CheckParameters()
{
  isthmus::StencilRadius(this->Accuracy);
  CheckNotNegative(this->Scale, "Scale", "a length: 0 or more");
  CheckNotNegative(this->FlatTolerance, "FlatTolerance", "a bound: 0 or more");
  CheckNotNegative(this->GaussianTolerance, "GaussianTolerance", "a bound: 0 or more");
  CheckNotNegative(this->MeanTolerance, "MeanTolerance", "a bound: 0 or more");
  if (this->ShapeIndexConvention != Thesis && this->ShapeIndexConvention != Koenderink)
  {
    throw std::invalid_argument("ShapeIndexConvention is " +
      std::to_string(this->ShapeIndexConvention) + ": choose 0 (Thesis) or 1 (Koenderink).");
  }
}

void vtkHessianCurvature::WarnIfThin(const int whole[6], bool atPoints)
{
  const int radius = isthmus::StencilRadius(this->Accuracy);
  const int least = atPoints ? 4 * radius : 2 * radius + 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int nodes = whole[2 * axis + 1] - whole[2 * axis] + 1;
    if (nodes < least)
    {
      vtkWarningMacro(<< isthmus::TextOf("Along ", "xyz"[axis], " the image has ", nodes,
                        " of the ", least, " nodes that Accuracy ", this->Accuracy,
                        " needs: no value is valid. Take a thicker image."));
    }
  }
}

void vtkHessianCurvature::AddCurvature(
  vtkImageData* image, vtkDataArray* scalars, vtkPoints* points, vtkDataSet* output)
{
  isthmus::ProgressCallback progress = isthmus::ProgressOf(this);
  vtkSmartPointer<vtkDataArray> values = scalars;
  if (this->Scale > 0.0)
  {
    constexpr double smoothingShare = 0.7;
    values = isthmus::SmoothAtScale(
      image, scalars, this->Scale, isthmus::Between(progress, 0.0, smoothingShare));
    progress = isthmus::Between(progress, smoothingShare, 1.0);
  }
  if (points)
  {
    isthmus::AddCurvatureAtPoints(
      image, values, points, OptionsOf(this), SelectionOf(this), output, progress);
    // What a view colours by, and the next filter takes, unless told otherwise.
    if (this->GenerateMeanCurvature)
    {
      output->GetPointData()->SetActiveScalars("MeanCurvature");
    }
  }
  else
  {
    isthmus::Extent box{};
    vtkImageData::SafeDownCast(output)->GetExtent(box.data());
    isthmus::AddCurvatureAtNodes(
      image, values, box, OptionsOf(this), SelectionOf(this), output, progress);
  }
}

int vtkHessianCurvature::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* imageInfo = inputVector[0]->GetInformationObject(0);
  vtkInformation* pointsInfo = inputVector[1]->GetInformationObject(0);
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  if (this->NeedsLargerExtent(request, imageInfo, pointsInfo, outInfo))
  {
    return 1;
  }
  vtkDataSet* output = vtkDataSet::GetData(outputVector, 0);
  return isthmus::Guarded(this, outputVector,
    [&]()
    {
      this->CheckParameters();
      vtkImageData* image = vtkImageData::GetData(imageInfo);
      vtkPoints* points = nullptr;
      if (pointsInfo)
      {
        vtkPolyData* surface = vtkPolyData::GetData(pointsInfo);
        isthmus::RequirePlaces(surface, "the surface");
        output->ShallowCopy(surface);
        points = surface->GetPoints();
      }
      else
      {
        output->ShallowCopy(image);
        CropToPiece(vtkImageData::SafeDownCast(output), outInfo);
      }
      if (output->GetNumberOfPoints() == 0)
      {
        isthmus::AddNoCurvature(SelectionOf(this), output);
        return;
      }
      if (image->GetNumberOfPoints() == 0)
      {
        throw std::invalid_argument("The image is empty, so the surface gets no curvature: give "
                                    "the volume that the surface was taken from.");
      }
      isthmus::RequireImageGeometry(image);
      const int* whole = imageInfo->Get(Pipeline::WHOLE_EXTENT());
      isthmus::CheckScale(this->Scale, image->GetSpacing(),
        { std::int64_t(whole[1]) - whole[0] + 1, std::int64_t(whole[3]) - whole[2] + 1,
          std::int64_t(whole[5]) - whole[4] + 1 });
      vtkDataArray* scalars = isthmus::ChosenScalars(this, image);
      this->WarnIfThin(whole, points != nullptr);
      this->AddCurvature(image, scalars, points, output);
    });
}

void vtkHessianCurvature::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Accuracy: " << this->Accuracy << "\n"
     << indent << "InsideIsHigher: " << this->InsideIsHigher << "\n"
     << indent << "Scale: " << this->Scale << "\n"
     << indent << "ShapeIndexConvention: " << this->ShapeIndexConvention << "\n";
  this->PrintCurvatureArrays(os, indent);
}
