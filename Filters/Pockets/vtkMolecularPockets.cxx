#include "vtkMolecularPockets.h"

#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/PolyDataTriangles.h"
#include "Pockets/LiningResidues.h"
#include "Pockets/LongTriangulation.h"
#include "Pockets/MolecularPockets.h"
#include "Pockets/PocketOutput.h"
#include "Pockets/PocketScore.h"
#include "Pockets/SiteDescriptors.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

vtkStandardNewMacro(vtkMolecularPockets);

namespace
{

void AddNumber(const char* name, double value, vtkDataObject* to)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  to->GetFieldData()->AddArray(array);
}

/// The heavy atoms with their properties for binding; empty without names and elements.
std::vector<isthmus::SiteAtom> SiteAtomsOf(const isthmus::MoleculeAtoms& atoms)
{
  std::vector<isthmus::SiteAtom> found;
  if (!atoms.HasNames || !atoms.HasElements)
  {
    return found;
  }
  std::map<std::string, int> chains;
  for (const std::int64_t point : atoms.Points)
  {
    chains[atoms.Named[static_cast<std::size_t>(point)].Chain] = 0;
  }
  int number = 0;
  for (auto& chain : chains)
  {
    chain.second = number++;
  }
  std::map<std::tuple<int, std::string, std::string>, std::int64_t> words;
  for (std::size_t i = 0; i < atoms.Balls.size(); ++i)
  {
    const isthmus::NamedAtom& named = atoms.Named[static_cast<std::size_t>(atoms.Points[i])];
    if (named.Element > 1)
    {
      found.push_back(
        isthmus::SiteAtomOf(atoms.Balls[i].Centre, named.Element, named.Residue, named.Name));
      found.back().Chain = chains[named.Chain];
      found.back().Word =
        words
          .emplace(std::tuple(named.ResidueId, named.InsertionCode, named.Residue),
            static_cast<std::int64_t>(words.size()))
          .first->second;
    }
  }
  return found;
}

/// The residues that line each site, those with most surface first.
std::vector<isthmus::SiteName> NamesOf(
  const std::vector<isthmus::Pocket>& sites, const isthmus::MoleculeAtoms& atoms)
{
  std::vector<isthmus::SiteName> names;
  for (const isthmus::Pocket& site : sites)
  {
    std::vector<isthmus::LiningResidue> residues = isthmus::LiningResiduesOf(site.Lining, atoms);
    std::stable_sort(residues.begin(), residues.end(),
      [](const isthmus::LiningResidue& a, const isthmus::LiningResidue& b)
      { return a.Area > b.Area; });
    names.emplace_back();
    for (const isthmus::LiningResidue& residue : residues)
    {
      const auto& atom = atoms.Named[static_cast<std::size_t>(residue.Points.front())];
      names.back().emplace_back(atom.Chain, atom.ResidueId, atom.InsertionCode, atom.Residue);
    }
  }
  return names;
}

/// The numbers of a surface's point array; empty if it is missing and not required.
std::vector<double> NumbersOf(const std::string& name, vtkPolyData* surface, bool required)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 1)
  {
    if (required)
    {
      throw std::invalid_argument("The surface has no point array " + name +
        " with one number per point: create it with vtkPolarizedCurvature, or choose another "
        "array.");
    }
    return {};
  }
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return values;
}

}

struct vtkMolecularPockets::Cache
{
  using Key = std::tuple<vtkDataObject*, vtkMTimeType, std::string, std::array<double, 4>,
    std::array<bool, 7>, std::string>;
  Key MadeOf;
  isthmus::PocketResult Result;
};

vtkMolecularPockets::~vtkMolecularPockets() = default;

vtkMolecularPockets::vtkMolecularPockets()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(7);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Radius");
}

void vtkMolecularPockets::SetSurfaceData(vtkPolyData* surface)
{
  this->SetInputData(1, surface);
}

vtkTable* vtkMolecularPockets::GetPocketTable()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

vtkPolyData* vtkMolecularPockets::GetMouths()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(2));
}

vtkPolyData* vtkMolecularPockets::GetAlphaBalls()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(3));
}

vtkTable* vtkMolecularPockets::GetLiningResidues()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(4));
}

vtkPolyData* vtkMolecularPockets::GetLiningAtoms()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(5));
}

vtkPolyData* vtkMolecularPockets::GetSiteSurface()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(6));
}

int vtkMolecularPockets::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

int vtkMolecularPockets::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* types[] = { "vtkUnstructuredGrid", "vtkTable", "vtkPolyData", "vtkPolyData",
    "vtkTable", "vtkPolyData", "vtkPolyData" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
  return 1;
}

int vtkMolecularPockets::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPointSet* atoms = vtkPointSet::GetData(inputVector[0], 0);
  vtkPolyData* surface = vtkPolyData::GetData(inputVector[1], 0);
  isthmus::ClearOutputs(outputVector);
  return isthmus::Guarded(this, outputVector,
    [&]()
    {
      isthmus::RequireOneRank(this, atoms, "atoms");
      if (atoms)
      {
        this->Compute(atoms, surface, outputVector);
      }
      isthmus::Report(isthmus::ProgressOf(this), 1.0);
    });
}

void vtkMolecularPockets::Compute(
  vtkPointSet* input, vtkPolyData* surface, vtkInformationVector* outputs)
{
  isthmus::PolymerOptions keep;
  keep.Hydrogens = this->KeepHydrogens;
  keep.Waters = this->KeepWaters;
  keep.Ions = this->KeepIons;
  keep.Ligands = this->KeepLigands;
  keep.ProstheticGroups = this->KeepProstheticGroups;
  keep.Residues = isthmus::NamesIn(this->KeepResidues);
  isthmus::PocketOptions options;
  options.ProbeRadius = this->ProbeRadius;
  options.InnerRadius = this->InnerRadius;
  options.OuterRadius = this->OuterRadius;
  options.BurialRadius = this->BurialRadius;
  options.MinimumVolume = this->MinimumVolume;
  options.Predicted = isthmus::WarningOfLongTriangulation(this);
  const isthmus::MoleculeAtoms atoms =
    isthmus::ReadAtoms(input, isthmus::PolymerOf(isthmus::InputArrayName(this, 0), keep));
  const std::vector<isthmus::SiteAtom> siteAtoms = SiteAtomsOf(atoms);
  if (this->FindSites && !siteAtoms.empty())
  {
    options.SiteAtoms = &siteAtoms;
    options.KeepDescriptors = this->KeepDescriptors;
  }
  // Pockets of any volume are kept, so that changing the threshold of whole pockets is instant.
  const double least = options.MinimumVolume;
  options.MinimumVolume = least >= 0.0 && std::isfinite(least) ? 0.0 : least;
  const Cache::Key key{ input, input->GetMTime(), isthmus::InputArrayName(this, 0),
    { this->ProbeRadius, this->InnerRadius, this->OuterRadius, this->BurialRadius },
    { this->FindSites, this->KeepDescriptors, keep.Hydrogens, keep.Waters, keep.Ions, keep.Ligands,
      keep.ProstheticGroups },
    this->KeepResidues };
  if (!this->Kept || this->Kept->MadeOf != key || options.MinimumVolume != 0.0)
  {
    this->Kept.reset();
    auto made = std::make_unique<Cache>();
    made->MadeOf = key;
    made->Result = isthmus::FindPockets(
      atoms.Balls, options, isthmus::Between(isthmus::ProgressOf(this), 0.0, 0.9));
    this->Kept = std::move(made);
  }
  isthmus::PocketResult result = this->Kept->Result;
  if (!options.SiteAtoms)
  {
    std::vector<isthmus::Pocket>& pockets = result.Pockets;
    pockets.erase(std::remove_if(pockets.begin(), pockets.end(),
                    [least](const isthmus::Pocket& pocket) { return pocket.Volume < least; }),
      pockets.end());
  }
  if (options.SiteAtoms)
  {
    isthmus::OrderTiedSites(NamesOf(result.Pockets, atoms), result.Pockets);
  }
  std::vector<isthmus::PocketSurfaceMeans> means;
  const bool hasSurface = surface && surface->GetNumberOfPoints() > 0;
  // A surface on which sites are shown need not have polarized curvature.
  if (hasSurface && this->UsePolarizedCurvature &&
    (!options.SiteAtoms || surface->GetPointData()->HasArray(this->PolarizedArray.c_str())))
  {
    const isthmus::PolyDataTriangles triangles(surface);
    const isthmus::PocketSurfaceFields fields{ NumbersOf(this->PolarizedArray, surface, true),
      NumbersOf(this->PotentialArray, surface, false) };
    isthmus::WeightScoresByCurvature(
      triangles.View(), fields, !options.SiteAtoms, result.Pockets, means);
  }
  const isthmus::PocketReport report{ result.Pockets, means, atoms };
  auto* cells = vtkUnstructuredGrid::GetData(outputs, 0);
  auto* table = vtkTable::GetData(outputs, 1);
  isthmus::FillPocketCells(report, cells);
  isthmus::FillPocketTable(report, table);
  isthmus::FillMouths(report, vtkPolyData::GetData(outputs, 2));
  isthmus::FillAlphaBalls(report, vtkPolyData::GetData(outputs, 3));
  isthmus::FillLiningResidues(report, vtkTable::GetData(outputs, 4));
  isthmus::FillLiningAtoms(report, input, this->ShownPocket, vtkPolyData::GetData(outputs, 5));
  isthmus::FillSiteSurface(
    report, result.SitePlaces, hasSurface ? surface : nullptr, vtkPolyData::GetData(outputs, 6));
  AddNumber("AccessibleArea", result.UnionArea, table);
  AddNumber("AccessibleVolume", result.UnionVolume, table);
  isthmus::AddNotes(atoms.Notes, cells);
  isthmus::AddNotes(atoms.Notes, table);
  for (const std::string& warning : atoms.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
}

void vtkMolecularPockets::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ProbeRadius: " << this->ProbeRadius << "\n";
  os << indent << "InnerRadius: " << this->InnerRadius << "\n";
  os << indent << "OuterRadius: " << this->OuterRadius << "\n";
  os << indent << "BurialRadius: " << this->BurialRadius << "\n";
  os << indent << "MinimumVolume: " << this->MinimumVolume << "\n";
  os << indent << "FindSites: " << this->FindSites << "\n";
  os << indent << "KeepDescriptors: " << this->KeepDescriptors << "\n";
  os << indent << "UsePolarizedCurvature: " << this->UsePolarizedCurvature << "\n";
  os << indent << "PolarizedArray: " << this->PolarizedArray << "\n";
  os << indent << "PotentialArray: " << this->PotentialArray << "\n";
  os << indent << "KeepHydrogens: " << this->KeepHydrogens << "\n";
  os << indent << "KeepWaters: " << this->KeepWaters << "\n";
  os << indent << "KeepIons: " << this->KeepIons << "\n";
  os << indent << "KeepLigands: " << this->KeepLigands << "\n";
  os << indent << "KeepProstheticGroups: " << this->KeepProstheticGroups << "\n";
  os << indent << "KeepResidues: " << this->KeepResidues << "\n";
  os << indent << "ShownPocket: " << this->ShownPocket << "\n";
}
