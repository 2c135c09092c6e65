#include "vtkMolecularDensity.h"

#include "Atoms/MolecularDensity.h"
#include "Atoms/MoleculeAtoms.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ImageExtent.h"
#include "Core/Index.h"
#include "Core/MemoryBudget.h"
#include "Core/NamedColumns.h"
#include "Core/PipelineInputs.h"
#include "Core/RangeChecks.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

vtkStandardNewMacro(vtkMolecularDensity);

const std::vector<isthmus::OutputArray>& vtkMolecularDensity::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Density", 1, "", ArrayChoice::None,
      "1 inside and 0 outside with UnionOfBalls, else the sum of Gaussians" },
    { 0, ArrayPlace::Field, "RecommendedLevel", 1, "", ArrayChoice::None,
      "level of the surface: 0.5 with UnionOfBalls, else 1" },
  };
  return table;
}

namespace
{

using isthmus::DensityGrid;
using isthmus::MoleculeAtoms;

/// All atoms, those of radius 0 included; radii times `scale`.
MoleculeAtoms ScaledAtoms(vtkDataObject* input, const std::string& radii, double scale)
{
  isthmus::RequireAbove(
    "RadiusScale", scale, 0.0, isthmus::LargestLength, "It multiplies the radii.");
  isthmus::AtomOptions all;
  all.RadiusArray = radii;
  all.ZeroRadii = true;
  MoleculeAtoms atoms = isthmus::ReadAtoms(input, all);
  for (isthmus::Ball& ball : atoms.Balls)
  {
    ball.Radius *= scale;
  }
  return atoms;
}

/// At least as many nodes as the pipeline has announced: in another time step the molecule may be
/// smaller, but downstream filters still request the extent of the first one.
void Widen(DensityGrid& grid, vtkInformation* outInfo)
{
  const isthmus::Extent announced =
    isthmus::ReadExtent(outInfo, vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::int64_t nodes = announced[2 * axis + 1] + 1;
    grid.Dimensions[axis] = std::max(grid.Dimensions[axis], nodes);
  }
}

void SetGeometry(const DensityGrid& grid, vtkImageData* image)
{
  image->SetDimensions(static_cast<int>(grid.Dimensions[0]), static_cast<int>(grid.Dimensions[1]),
    static_cast<int>(grid.Dimensions[2]));
  image->SetOrigin(grid.Origin.data());
  image->SetSpacing(grid.Spacing, grid.Spacing, grid.Spacing);
}

/// The array `Density` of the image, not yet filled.
vtkFloatArray* AddDensity(vtkImageData* image, const DensityGrid& grid)
{
  isthmus::MemoryBudget().RequireGrid(grid.Dimensions, sizeof(float),
    isthmus::JoinText("choose a Spacing larger than ", grid.Spacing));
  const auto density = isthmus::NamedArray<vtkFloatArray>(
    "Density", isthmus::At(grid.Dimensions[0] * grid.Dimensions[1] * grid.Dimensions[2]));
  image->GetPointData()->SetScalars(density);
  return density;
}

}

vtkMolecularDensity::vtkMolecularDensity()
  : Advance(std::make_unique<isthmus::InputInAdvance>(this))
{
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Radius");
}

vtkMolecularDensity::~vtkMolecularDensity() = default;

int vtkMolecularDensity::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkMolecularDensity::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // The extent of the grid is that of the atoms, so these are needed now.
  this->Advance->Update();
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  isthmus::SetImageInformation(outInfo,
    [&](vtkImageData* image)
    {
      this->Advance->RequireOneRank(0, "atoms");
      vtkPointSet* input = vtkPointSet::GetData(inputVector[0], 0);
      if (input &&
        input->GetNumberOfPoints() > 0) // otherwise empty, or blocks that are processed one by one
      {
        const MoleculeAtoms atoms =
          ScaledAtoms(input, isthmus::InputArrayName(this, 0), this->RadiusScale);
        SetGeometry(isthmus::GridAroundBalls(atoms.Balls, this->Spacing,
                      { this->Padding[0], this->Padding[1], this->Padding[2] }),
          image);
      }
    });
  vtkDataObject::SetPointDataActiveScalarInfo(outInfo, VTK_FLOAT, 1);
  return 1;
}

int vtkMolecularDensity::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector, 0);
  vtkPointSet* input = vtkPointSet::GetData(inputVector[0], 0);
  output->Initialize();
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      isthmus::RequireRange("Form", this->Form, UnionOfBalls, GaussianSum);
      this->Advance->RequireOneRank(0, "atoms");
      if (input && input->GetNumberOfPoints() > 0)
      {
        this->FillImage(input, outputVector->GetInformationObject(0), output);
      }
    });
}

void vtkMolecularDensity::FillImage(
  vtkPointSet* input, vtkInformation* outInfo, vtkImageData* output)
{
  const MoleculeAtoms atoms =
    ScaledAtoms(input, isthmus::InputArrayName(this, 0), this->RadiusScale);
  for (const std::string& warning : atoms.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  const std::string missing = isthmus::DescribeMissingSideChains(isthmus::ReadNamedAtoms(input));
  if (!missing.empty())
  {
    vtkWarningMacro(<< missing);
  }
  if (atoms.Balls.empty())
  {
    return;
  }
  DensityGrid grid = isthmus::GridAroundBalls(
    atoms.Balls, this->Spacing, { this->Padding[0], this->Padding[1], this->Padding[2] });
  Widen(grid, outInfo);
  SetGeometry(grid, output);
  const isthmus::GridView<float> nodes{ AddDensity(output, grid)->GetPointer(0), grid.Dimensions,
    { grid.Spacing, grid.Spacing, grid.Spacing } };
  const auto progress = isthmus::MakeProgress(this);
  if (this->Form == UnionOfBalls)
  {
    isthmus::UnionOfBalls(atoms.Balls, grid.Origin, nodes, progress);
  }
  else
  {
    isthmus::GaussianSum(atoms.Balls, this->Decay, grid.Origin, nodes, progress);
  }
  // for vtkMapSurface
  isthmus::AddColumn<vtkDoubleArray>(
    output->GetFieldData(), "RecommendedLevel", { this->Form == UnionOfBalls ? 0.5 : 1.0 });
}

void vtkMolecularDensity::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Form: " << this->Form << "\n";
  os << indent << "RadiusScale: " << this->RadiusScale << "\n";
  os << indent << "Decay: " << this->Decay << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Padding: " << this->Padding[0] << " " << this->Padding[1] << " "
     << this->Padding[2] << "\n";
}
