#include "vtkBindingSites.h"

#include "Atoms/MoleculeAtoms.h"
#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Core/PolyDataTriangles.h"
#include "Core/RangeChecks.h"
#include "Pockets/BindingSiteTable.h"
#include "Pockets/BindingSites.h"
#include "Pockets/HullDepth.h"
#include "Pockets/MolecularPockets.h"
#include "Pockets/PocketScore.h"
#include "Surfaces/AreaQuantiles.h"

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkBindingSites);

namespace
{

double ComputeAmplitude(double value, int mode)
{
  if (std::isnan(value) || mode == vtkBindingSites::AbsoluteValue)
  {
    return std::abs(value);
  }
  return std::max(mode == vtkBindingSites::PositivePart ? value : -value, 0.0);
}

}

const std::vector<isthmus::OutputArray>& vtkBindingSites::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "BindingSite", 1, "", ArrayChoice::None,
      "0, or the rank of the site" },
    { 1, ArrayPlace::Rows, "Rank", 1, "", ArrayChoice::None, "1 is the best" },
    { 1, ArrayPlace::Rows, "Score", 1, "", ArrayChoice::None,
      "of a patch: integral of the amplitude over its area; of a pocket: its score times the "
      "square root of the mean amplitude of its surface" },
    { 1, ArrayPlace::Rows, "SiteClass", 1, "", ArrayChoice::None,
      "that of the points; of a pocket 2 if the mean potential is positive, 4 if negative, 0 "
      "without a potential" },
    { 1, ArrayPlace::Rows, "Class", 1, "", ArrayChoice::None, "SiteClass in words" },
    { 1, ArrayPlace::Rows, "Residues", 1, "", ArrayChoice::None,
      "with atoms: residues within 4 angstrom, those with the most atoms first: HIS 57 A (5) "
      "is name, number, chain and number of atoms" },
    { 1, ArrayPlace::Rows, "Volume", 1, "length^3", ArrayChoice::None, "of pockets" },
    { 1, ArrayPlace::Rows, "Area", 1, "length^2", ArrayChoice::None, "of the surface of the site" },
    { 1, ArrayPlace::Rows, "MeanDepth", 1, "length", ArrayChoice::None,
      "below the convex hull of the surface" },
    { 1, ArrayPlace::Rows, "MeanPotential", 1, "kT/e", ArrayChoice::None,
      "NaN without a potential" },
    { 1, ArrayPlace::Rows, "CenterX", 1, "length", ArrayChoice::None,
      "mean of the points of a patch; center of a pocket" },
    { 1, ArrayPlace::Rows, "CenterY", 1, "length", ArrayChoice::None,
      "mean of the points of a patch; center of a pocket" },
    { 1, ArrayPlace::Rows, "CenterZ", 1, "length", ArrayChoice::None,
      "mean of the points of a patch; center of a pocket" },
    { 1, ArrayPlace::Rows, "Points", 1, "", ArrayChoice::None, "number of points of the surface" },
    { 1, ArrayPlace::Field, "Threshold", 1, "", ArrayChoice::None,
      "the amplitude used; NaN for pockets" },
    { 1, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,
      "whether sites are pockets or patches, and which atoms were dropped" },
  };
  return table;
}

vtkBindingSites::vtkBindingSites()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  constexpr int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  this->SetInputArrayToProcess(0, 0, 0, points, "PolarizedCurvature");
  this->SetInputArrayToProcess(1, 0, 0, points, "SiteClass");
  this->SetInputArrayToProcess(2, 0, 0, points, "Potential");
  this->Threshold = this->Parameters.Threshold;
}

void vtkBindingSites::SetAtomsData(vtkPointSet* atoms)
{
  this->SetInputData(1, atoms);
}

int vtkBindingSites::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkPointSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

int vtkBindingSites::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

vtkTable* vtkBindingSites::GetSiteTable()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkBindingSites::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* table = vtkTable::GetData(outputVector, 1);
  isthmus::ClearOutputs(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      const auto surface = isthmus::GatherSurface(this, vtkPolyData::GetData(inputVector[0]));
      vtkPointSet* atoms = vtkPointSet::GetData(inputVector[1]);
      isthmus::RequireOneRank(this, atoms, "atoms");
      output->ShallowCopy(surface);
      isthmus::Check(this->Parameters);
      isthmus::RequireRange("Classes", this->Classes, Ligands, AllPoints);
      isthmus::RequireRange("Amplitude", this->Amplitude, AbsoluteValue, NegativePart);
      if (surface->GetNumberOfCells() > 0)
      {
        std::vector<std::string> notes;
        std::optional<isthmus::MoleculeAtoms> chosen;
        if (atoms && atoms->GetNumberOfPoints() > 0)
        {
          chosen = this->PrepareAtoms(atoms);
          notes = chosen->Notes;
        }
        const isthmus::PolyDataTriangles triangles(surface);
        const bool usesPockets = chosen && this->UsePockets;
        const isthmus::BindingSiteResult result = usesPockets
          ? this->Pockets(surface, triangles.View(), *chosen)
          : this->Patches(surface, triangles.View());
        isthmus::AddColumn<vtkIntArray>(output->GetPointData(), "BindingSite", result.Labels);
        output->GetPointData()->SetActiveScalars("BindingSite");
        isthmus::FillSiteTable(result,
          chosen ? isthmus::FindSiteResidues(
                     triangles.View(), result.Labels, result.Sites.size(), *chosen)
                 : std::vector<std::string>(),
          table);
        notes.push_back(usesPockets ? "Sites are pockets." : "Sites are patches of the surface.");
        isthmus::AddNotes(notes, table);
      }
    });
}

vtkDataArray* vtkBindingSites::Scalar(int index, vtkPolyData* surface, const char* remedy)
{
  vtkDataArray* array = this->GetInputArrayToProcess(index, surface);
  if (array &&
    (array->GetNumberOfComponents() != 1 ||
      array->GetNumberOfTuples() != surface->GetNumberOfPoints()))
  {
    throw std::invalid_argument("The array " +
      std::string(array->GetName() ? array->GetName() : "without a name") +
      " does not have one number for each point: choose another.");
  }
  if (!array && remedy)
  {
    const char* name = this->GetInputArrayInformation(index)->Get(vtkDataObject::FIELD_NAME());
    throw std::invalid_argument("The surface has no point array " +
      std::string(name && *name ? name : "of that kind") + ": " + remedy);
  }
  return array;
}

isthmus::SiteFields vtkBindingSites::Fields(vtkPolyData* surface)
{
  const char* remedy =
    "run Polarized Curvature (which needs the potential) on it first, or choose another array.";
  vtkDataArray* values = this->Scalar(0, surface, remedy);
  vtkDataArray* classes = this->Classes == AllPoints ? nullptr : this->Scalar(1, surface, remedy);
  vtkDataArray* potential = this->Scalar(2, surface, nullptr);
  const auto count = static_cast<std::size_t>(surface->GetNumberOfPoints());
  isthmus::SiteFields fields;
  fields.Amplitude.resize(count);
  fields.Kind.assign(count, 1);
  fields.Potential.resize(potential ? count : 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto point = static_cast<vtkIdType>(i);
    fields.Amplitude[i] = ComputeAmplitude(values->GetComponent(point, 0), this->Amplitude);
    if (potential)
    {
      fields.Potential[i] = potential->GetComponent(point, 0);
    }
    if (classes)
    {
      const double site = classes->GetComponent(point, 0);
      const bool ligand = site == 2.0 || site == 4.0;
      const bool protein = site == 1.0 || site == 3.0;
      const bool wanted =
        (ligand && this->Classes != Proteins) || (protein && this->Classes != Ligands);
      fields.Kind[i] = static_cast<unsigned char>(wanted ? site : 0.0);
    }
  }
  return fields;
}

isthmus::BindingSiteResult vtkBindingSites::Patches(
  vtkPolyData* surface, const isthmus::SurfaceView& triangles)
{
  const isthmus::SiteFields fields = this->Fields(surface);
  isthmus::BindingSiteOptions options = this->Parameters;
  options.AutomaticThreshold = this->AutomaticThreshold;
  options.Threshold = this->Threshold;
  isthmus::BindingSiteResult result =
    isthmus::FindBindingSites(triangles, fields, options, isthmus::MakeProgress(this));
  if (result.Sites.empty())
  {
    vtkWarningMacro(<< isthmus::JoinText("No patch of at least ", options.MinimumArea,
                      " (unit of length squared) has values above the threshold of ",
                      result.Threshold,
                      ". Is the array constant, or zero at the points of the chosen classes? Lower "
                      "the threshold or the quantile."));
  }
  return result;
}

isthmus::MoleculeAtoms vtkBindingSites::PrepareAtoms(vtkPointSet* input)
{
  isthmus::MoleculeAtoms atoms = isthmus::ReadAtoms(input, isthmus::SelectPolymer("Radius", {}));
  for (const std::string& warning : atoms.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  return atoms;
}

isthmus::BindingSiteResult vtkBindingSites::Pockets(
  vtkPolyData* surface, const isthmus::SurfaceView& triangles, const isthmus::MoleculeAtoms& atoms)
{
  auto pockets =
    isthmus::FindPockets(atoms.Balls, {}, isthmus::Between(isthmus::MakeProgress(this), 0.0, 0.8))
      .Pockets;
  isthmus::SiteFields fields = this->Fields(surface);
  std::vector<isthmus::PocketSurfaceMeans> means;
  isthmus::WeightScoresByCurvature(
    triangles, { std::move(fields.Amplitude), fields.Potential }, true, pockets, means);
  isthmus::BindingSiteResult result;
  result.Threshold = vtkMath::Nan();
  result.Labels = isthmus::LabelPocketSurfaces(triangles, pockets);
  const std::vector<double> areas = isthmus::PointAreas(triangles);
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    // A point that no triangle uses is not part of the surface.
    result.Labels[i] = areas[i] > 0.0 ? result.Labels[i] : 0;
  }
  const isthmus::HullDepth depth(triangles, {});
  for (std::size_t i = 0; i < pockets.size(); ++i)
  {
    const double potential = means[i].Potential;
    isthmus::BindingSite site;
    site.Kind = static_cast<unsigned char>(potential > 0.0 ? 2 : (potential < 0.0 ? 4 : 0));
    site.Score = pockets[i].Score;
    site.Area = means[i].Area;
    site.Volume = pockets[i].Volume;
    site.MeanDepth = depth(pockets[i].Center.data());
    site.MeanPotential = potential;
    site.Center = pockets[i].Center;
    site.Points = std::count(result.Labels.begin(), result.Labels.end(), static_cast<int>(i) + 1);
    result.Sites.push_back(site);
  }
  if (pockets.empty())
  {
    vtkWarningMacro(<< "The molecule has no pockets, so there are no sites: switch Use Pockets off "
                       "to find patches of the surface instead.");
  }
  return result;
}

void vtkBindingSites::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UsePockets: " << this->UsePockets << "\n";
  os << indent << "Classes: " << this->Classes << "\n";
  os << indent << "Amplitude: " << this->Amplitude << "\n";
  os << indent << "AutomaticThreshold: " << this->AutomaticThreshold << "\n";
  os << indent << "Quantile: " << this->GetQuantile() << "\n";
  os << indent << "Threshold: " << this->GetThreshold() << "\n";
  os << indent << "MergeDistance: " << this->GetMergeDistance() << "\n";
  os << indent << "MinimumArea: " << this->GetMinimumArea() << "\n";
  os << indent << "RankBy: " << this->GetRankBy() << "\n";
}
