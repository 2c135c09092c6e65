#include "vtkHessianCurvature.h"

#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/ImageExtent.h"
#include "Core/ImageScalars.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Curvature/CurvatureOfImage.h"
#include "Curvature/CurvatureScale.h"
#include "Curvature/DifferentialForms.h"
#include "Curvature/FiniteDifference.h"
#include "Curvature/GaussBonnet.h"
#include "Curvature/GaussianSmoothing.h"

#include <vtkCommunicator.h>
#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkDataObjectTypes.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHessianCurvature);

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

constexpr double choiceShare = 0.3; // of the time, for the choice of the scale

/// Nodes needed around a node or a point: those of the differences (twice their radius at a point),
/// and those of the smoothing before. Parameters are checked later, when there is data.
std::array<int, 3> ComputeReach(
  vtkHessianCurvature* filter, bool atPoints, vtkInformation* imageInfo)
{
  std::array<double, 3> spacing{ 1.0, 1.0, 1.0 };
  if (imageInfo->Has(vtkDataObject::SPACING()))
  {
    imageInfo->Get(vtkDataObject::SPACING(), spacing.data());
  }
  const int radius = filter->GetAccuracy() == 4 ? 2 : 1;
  int stencil = atPoints ? 2 * radius : radius;
  double scale = filter->GetScale();
  if (filter->GetAutomaticScale())
  {
    const isthmus::Extent whole = isthmus::ReadExtent(imageInfo, Pipeline::WHOLE_EXTENT());
    std::array<std::int64_t, 3> nodes{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      spacing[axis] = std::abs(spacing[axis]);
      nodes[axis] = std::int64_t(whole[2 * axis + 1]) - whole[2 * axis] + 1;
    }
    scale = isthmus::LargestCandidateScale(spacing, nodes);
    // Differences of fourth order serve as reference.
    stencil = atPoints ? 4 : isthmus::DifferenceReach;
  }
  std::array<int, 3> reach = isthmus::GaussianReach(scale, spacing.data());
  for (int& nodes : reach)
  {
    nodes += stencil;
  }
  return reach;
}

/// Whether the ranks choose the scale together: blocks of composite data choose their own.
bool NeedsOtherRanks(vtkHessianCurvature* filter)
{
  if (!filter->GetAutomaticScale() || isthmus::NumberOfRanks() == 1)
  {
    return false;
  }
  try
  {
    isthmus::RequireNoBlocks(filter);
  }
  catch (const std::runtime_error&)
  {
    return false;
  }
  return true;
}

void MaximumAcrossRanks(double* values, std::int64_t count)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const std::vector<double> own(values, values + count);
  controller->AllReduce(own.data(), values, static_cast<vtkIdType>(count), vtkCommunicator::MAX_OP);
}

/// Extent and spacing of the whole image, which a rank without data may not know.
void ShareGeometry(isthmus::Extent& whole, std::array<double, 3>& spacing)
{
  constexpr double none = -std::numeric_limits<double>::infinity();
  std::array<double, 9> values;
  values.fill(none);
  for (std::size_t axis = 0; axis < 3 && isthmus::NodeCount(whole) > 0; ++axis)
  {
    values[3 * axis] = -whole[2 * axis];
    values[3 * axis + 1] = whole[2 * axis + 1];
    values[3 * axis + 2] = spacing[axis];
  }
  MaximumAcrossRanks(values.data(), static_cast<std::int64_t>(values.size()));
  for (std::size_t axis = 0; axis < 3 && values[0] != none; ++axis)
  {
    whole[2 * axis] = -static_cast<int>(values[3 * axis]);
    whole[2 * axis + 1] = static_cast<int>(values[3 * axis + 1]);
    spacing[axis] = values[3 * axis + 2];
  }
}

/// Removes the nodes requested beyond the piece. A volume that its source has not split (all of it
/// on one rank, or parts by another rule) stays whole: all of it is this rank's.
void CropToPiece(vtkImageData* image, vtkInformation* outInfo, bool allHere)
{
  const isthmus::Extent piece =
    isthmus::GetPieceExtent(outInfo, isthmus::ReadExtent(outInfo, Pipeline::UPDATE_EXTENT()));
  isthmus::Extent extent{};
  image->GetExtent(extent.data());
  const bool split = allHere || Pipeline::GetUpdateNumberOfPieces(outInfo) <= 1 ||
    image->GetPointGhostArray() || image->GetCellGhostArray();
  if (split && isthmus::Contains(extent, piece))
  {
    isthmus::CropTo(image, piece);
  }
}

isthmus::DifferentialFormsSelection SelectForms(vtkHessianCurvature* filter)
{
  return { filter->GetOutputArraySelection(), filter->GetNormalCurvatureDirection() };
}

isthmus::CurvatureSelection SelectArrays(vtkHessianCurvature* filter)
{
  const auto has = [arrays = filter->GetOutputArraySelection()](const char* name)
  { return arrays->ArrayIsEnabled(name) != 0; };
  isthmus::CurvatureSelection selection;
  selection.Gaussian = has("GaussianCurvature");
  selection.Mean = has("MeanCurvature");
  selection.Maximum = has("MaximumCurvature");
  selection.Minimum = has("MinimumCurvature");
  selection.ShapeIndex = has("ShapeIndex");
  selection.Curvedness = has("Curvedness");
  selection.Direction1 = has("PrincipalDirection1");
  selection.Direction2 = has("PrincipalDirection2");
  selection.SurfaceType = has("SurfaceType");
  selection.Error = filter->GetAutomaticScale();
  if (SelectForms(filter).Any())
  {
    selection.Normal = true;
    selection.Maximum = selection.Minimum = true;
    selection.Direction1 = selection.Direction2 = true;
  }
  return selection;
}

}

const std::vector<isthmus::OutputArray>& vtkHessianCurvature::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    ISTHMUS_CURVATURE_ARRAY_ROWS,
    { 0, ArrayPlace::Points, "CurvatureScale", 1, "length", ArrayChoice::None,
      "standard deviation of the Gaussian that smoothed the scalars, the same everywhere; 0 for "
      "none; with AutomaticScale" },
    { 0, ArrayPlace::Points, "CurvatureError", 1, "1/length", ArrayChoice::None,
      "standard error of the mean curvature, bias included; with AutomaticScale" },
    { 0, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,
      "at a surface, if CurvatureError exceeds the mean curvature at more than a quarter of its "
      "points" },
  };
  return table;
}

vtkHessianCurvature::vtkHessianCurvature()
  : OutputArrays(this, OutputArrayTable())
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
  // Pieces that one process requests one after another (streaming) use the scale of the whole.
  if (this->AutomaticScale && isthmus::NumberOfRanks() == 1)
  {
    isthmus::RequestWholeExtent(imageInfo);
    return 1;
  }
  const std::array<int, 3> reach = ComputeReach(this, atPoints, imageInfo);
  const isthmus::Extent whole = isthmus::ReadExtent(imageInfo, Pipeline::WHOLE_EXTENT());
  const isthmus::Extent wanted = atPoints
    ? whole
    : isthmus::GrowExtent(isthmus::ReadExtent(outInfo, Pipeline::UPDATE_EXTENT()), reach, whole);
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
  const isthmus::Extent whole = isthmus::ReadExtent(imageInfo, Pipeline::WHOLE_EXTENT());
  // Points have no extent of their own; usually they lie in their rank's part of the image.
  const isthmus::Extent piece = isthmus::GetPieceExtent(
    outInfo, pointsInfo ? whole : isthmus::ReadExtent(outInfo, Pipeline::UPDATE_EXTENT()));
  const bool together = NeedsOtherRanks(this);
  if (this->MoreLayers > 0 || Pipeline::GetUpdateNumberOfPieces(outInfo) <= 1 ||
    (isthmus::IsEmpty(piece) && !together))
  {
    request->Remove(Pipeline::CONTINUE_EXECUTING());
    this->MoreLayers = 0;
    return false;
  }
  const std::array<int, 3> reach = ComputeReach(this, pointsInfo != nullptr, imageInfo);
  isthmus::Extent needed = isthmus::GrowExtent(piece, reach, whole);
  if (pointsInfo)
  {
    vtkPolyData* surface = vtkPolyData::GetData(pointsInfo);
    needed = surface->GetNumberOfPoints() > 0
      ? isthmus::CoverBounds(image, surface->GetBounds(), reach, whole)
      : isthmus::Extent{ 0, -1, 0, -1, 0, -1 };
  }
  isthmus::Extent delivered{};
  image->GetExtent(delivered.data());
  double layers = isthmus::Contains(delivered, needed)
    ? 0.0
    : std::max(1, isthmus::LayersBetween(piece, needed)); // once is enough
  if (together)
  {
    MaximumAcrossRanks(&layers, 1); // all ranks run again if one must
  }
  if (!(layers > 0.0))
  {
    return false;
  }
  this->MoreLayers = static_cast<int>(layers);
  request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
  return true;
}

void vtkHessianCurvature::CheckParameters()
{
  this->OutputArrays.Check();
  isthmus::Check(this->Parameters);
  isthmus::RequireRange("Scale", this->Scale, 0.0, isthmus::Unlimited);
  SelectForms(this).Check();
}

namespace
{

/// InputOverlap.h compares boxes, and that of a surface around the image contains it. `whole` is
/// the extent of the image.
void CheckPointsInside(
  vtkHessianCurvature* self, vtkImageData* image, const int whole[6], vtkPoints* points)
{
  constexpr double rounding = 1e-3; // of a node: points on the border
  const vtkIdType count = points->GetNumberOfPoints();
  const std::int64_t outside = isthmus::ParallelReduce(count, 1 << 14, std::int64_t{ 0 },
    [&](std::int64_t& sum, std::int64_t first, std::int64_t last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        double place[3], node[3];
        points->GetPoint(i, place);
        image->TransformPhysicalPointToContinuousIndex(place, node);
        bool isInside = true;
        for (int axis = 0; axis < 3; ++axis)
        {
          isInside = isInside && node[axis] >= whole[2 * axis] - rounding &&
            node[axis] <= whole[2 * axis + 1] + rounding;
        }
        sum += isInside ? 0 : 1;
      }
    });
  if (2 * outside <= count)
  {
    return;
  }
  const std::string what = isthmus::JoinText(outside, " of ", count,
    " points of the surface lie outside the volume, where there is no curvature. Connect the "
    "volume from which the surface was made, in the same place and unit of length.");
  if (outside == count)
  {
    throw std::invalid_argument(what);
  }
  vtkWarningWithObjectMacro(self, << what);
}

/// A note if much of the curvature is not resolved.
void AddNoteOnErrors(vtkDataSet* output)
{
  vtkPointData* points = output->GetPointData();
  vtkDataArray* mean = points->GetArray("MeanCurvature");
  vtkDataArray* error = points->GetArray("CurvatureError");
  vtkDataArray* valid = points->GetArray("CurvatureValid");
  vtkIdType known = 0, unresolved = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const bool counts = valid->GetComponent(i, 0) != 0.0;
    known += counts;
    unresolved += counts && error->GetComponent(i, 0) > std::abs(mean->GetComponent(i, 0));
  }
  if (4 * unresolved > known)
  {
    isthmus::AddColumn<vtkStringArray>(output->GetFieldData(), "Notes",
      std::vector<std::string>{ isthmus::JoinText("At ", 100 * unresolved / known,
        " % of the points the estimated error of the mean curvature (CurvatureError) is larger "
        "than the curvature: the grid does not resolve these details of the surface.") });
  }
}

}

void vtkHessianCurvature::WarnIfThin(const int whole[6], bool atPoints)
{
  const int radius = isthmus::StencilRadius(this->Parameters.Accuracy);
  const int least = atPoints ? 4 * radius : 2 * radius + 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int nodes = whole[2 * axis + 1] - whole[2 * axis] + 1;
    if (nodes < least)
    {
      vtkWarningMacro(<< isthmus::JoinText("Along ", "xyz"[axis], " the image has ", nodes,
                        " of the ", least, " nodes that Accuracy ", this->Parameters.Accuracy,
                        " needs: no value is valid. Use a thicker image."));
    }
  }
}

isthmus::CurvatureScale vtkHessianCurvature::ChooseScale(
  vtkImageData* image, vtkDataArray* scalars, vtkInformation* imageInfo)
{
  isthmus::CurvatureScale scale;
  scale.Scale = this->Scale;
  if (!this->AutomaticScale)
  {
    return scale;
  }
  const bool together = NeedsOtherRanks(this);
  isthmus::Extent whole = isthmus::ReadExtent(imageInfo, Pipeline::WHOLE_EXTENT());
  std::array<double, 3> spacing{ 1.0, 1.0, 1.0 };
  image->GetSpacing(spacing.data());
  if (together)
  {
    ShareGeometry(whole, spacing);
  }
  // If one rank stopped, the others would wait forever.
  return isthmus::ChooseImageScale(image, scalars, whole, spacing.data(), this->Parameters.Accuracy,
    together ? isthmus::MaximumOverRanks(MaximumAcrossRanks) : isthmus::MaximumOverRanks{},
    together ? isthmus::ProgressCallback{}
             : isthmus::Between(isthmus::MakeProgress(this), 0.0, choiceShare));
}

void vtkHessianCurvature::AddCurvature(vtkImageData* image, vtkDataArray* scalars,
  vtkPoints* points, const isthmus::CurvatureScale& scale, vtkDataSet* output)
{
  const isthmus::ProgressCallback progress = isthmus::MakeProgress(this);
  double done = this->AutomaticScale ? choiceShare : 0.0;
  const auto step = [&](double share)
  {
    const double from = done;
    done = std::min(1.0, done + share);
    return isthmus::Between(progress, from, done);
  };
  const auto smoothed = [&](double deviation, double share)
  {
    return deviation > 0.0 ? isthmus::SmoothAtScale(image, scalars, deviation, step(share))
                           : vtkSmartPointer<vtkDataArray>(scalars);
  };
  const double remaining = 1.0 - done;
  const double smoothing = scale.Scale > 0.0 ? 0.7 : 0.0;
  const double first = this->AutomaticScale ? 0.4 * remaining : remaining;
  const isthmus::CurvatureSelection selection = SelectArrays(this);
  isthmus::Extent box{};
  if (vtkImageData* nodes = vtkImageData::SafeDownCast(output))
  {
    nodes->GetExtent(box.data());
  }
  vtkSmartPointer<vtkDataArray> values = smoothed(scale.Scale, smoothing * first);
  if (points)
  {
    isthmus::AddCurvatureAtPoints(
      image, values, points, this->Parameters, selection, output, step((1.0 - smoothing) * first));
  }
  else
  {
    isthmus::AddCurvatureAtNodes(
      image, values, box, this->Parameters, selection, output, step((1.0 - smoothing) * first));
  }
  if (this->AutomaticScale)
  {
    isthmus::AddReferenceCurvature(image, values, box, points, this->Parameters, output, step(0.1));
    values = nullptr; // its memory is reused
    values = smoothed(scale.NextScale, 0.7 * (remaining - first));
    isthmus::AddErrors(
      image, values, box, points, this->Parameters, selection, scale, output, step(1.0));
  }
  if (points && this->AutomaticScale && this->OutputArrays.Has("MeanCurvature"))
  {
    AddNoteOnErrors(output);
  }
  if (points && this->OutputArrays.Has("MeanCurvature"))
  {
    // The default array for colours and for the next filter.
    output->GetPointData()->SetActiveScalars("MeanCurvature");
  }
  if (vtkPolyData* surface = vtkPolyData::SafeDownCast(output); surface &&
      this->OutputArrays.Has("GaussianCurvature") && isthmus::NumberOfRanks() == 1 &&
      surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0)
  {
    isthmus::AddGaussBonnet(isthmus::IntegrateGaussianCurvature(surface), surface->GetFieldData());
  }
}

/// Adds arrays derived from principal curvatures and directions, and removes those that were
/// computed only for this purpose.
void vtkHessianCurvature::AddForms(vtkDataSet* output)
{
  const isthmus::DifferentialFormsSelection selection = SelectForms(this);
  if (selection.Any())
  {
    isthmus::AddDifferentialForms(selection, output);
    this->OutputArrays.RemoveOthers(
      { "MaximumCurvature", "MinimumCurvature", "PrincipalDirection1", "PrincipalDirection2" },
      output->GetPointData());
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
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      this->CheckParameters();
      vtkImageData* image = vtkImageData::GetData(imageInfo);
      vtkSmartPointer<vtkDataArray> scalars;
      vtkPoints* points = nullptr;
      const auto prepare = [&]()
      {
        if (pointsInfo)
        {
          vtkPolyData* surface = vtkPolyData::GetData(pointsInfo);
          isthmus::RequireFinitePositions(surface, "the surface");
          output->ShallowCopy(surface);
          points = surface->GetPoints();
        }
        else
        {
          output->ShallowCopy(image);
          CropToPiece(vtkImageData::SafeDownCast(output), outInfo,
            this->AutomaticScale && isthmus::NumberOfRanks() == 1);
        }
        if (image->GetNumberOfPoints() == 0 && output->GetNumberOfPoints() > 0)
        {
          throw std::invalid_argument("The image is empty, so the surface gets no curvature: "
                                      "connect the volume from which the surface was made.");
        }
        if (image->GetNumberOfPoints() > 0 &&
          (output->GetNumberOfPoints() > 0 || NeedsOtherRanks(this)))
        {
          isthmus::RequireImageGeometry(image);
          const int* whole = imageInfo->Get(Pipeline::WHOLE_EXTENT());
          isthmus::CheckScale(this->Scale, image->GetSpacing(),
            { std::int64_t(whole[1]) - whole[0] + 1, std::int64_t(whole[3]) - whole[2] + 1,
              std::int64_t(whole[5]) - whole[4] + 1 });
          scalars = isthmus::WideIntegersAsDouble(isthmus::ChosenScalars(this, image));
          this->WarnIfThin(whole, points != nullptr);
          if (points && isthmus::NumberOfRanks() == 1)
          {
            CheckPointsInside(this, image, whole, points);
          }
        }
      };
      std::exception_ptr failure;
      try
      {
        prepare();
      }
      catch (const std::exception&)
      {
        failure = std::current_exception(); // the other ranks wait for this rank's contribution
        scalars = nullptr;
      }
      isthmus::CurvatureScale scale;
      if (scalars || NeedsOtherRanks(this))
      {
        scale = this->ChooseScale(image, scalars, imageInfo);
      }
      if (failure)
      {
        std::rethrow_exception(failure);
      }
      if (output->GetNumberOfPoints() == 0)
      {
        isthmus::AddNoCurvature(SelectArrays(this), output);
        this->AddForms(output);
        return;
      }
      this->AddCurvature(image, scalars, points, scale, output);
      this->AddForms(output);
    });
}

void vtkHessianCurvature::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Accuracy: " << this->Parameters.Accuracy << "\n"
     << indent << "InsideIsHigher: " << this->Parameters.InsideIsHigher << "\n"
     << indent << "AutomaticScale: " << this->AutomaticScale << "\n"
     << indent << "Scale: " << this->Scale << "\n"
     << indent << "ShapeIndexConvention: " << this->GetShapeIndexConvention() << "\n";
  this->PrintCurvatureProperties(os, indent);
  this->OutputArrays.Print(os, indent);
}
